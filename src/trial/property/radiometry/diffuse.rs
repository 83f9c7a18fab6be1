//! Diffuse light under discs of every size at every elevation.

use core::f64::consts::PI;

use super::Lamp;
use super::formulas::ends;
use crate::diffuse::{illuminance, lambert, lambert_disc, relative_illuminance};
use crate::oracle::diffuse as oracle;
use crate::real::{Real, Scalar};
use crate::sphere::DistantSphere;
use crate::trial::format::{Format, Visitor};
use crate::trial::property::figures::{Figures, NONE, Row};
use crate::trial::property::{Broken, Case};

/// Ratios up to which a bin of discs goes. Beyond half the sky there is one more.
const BINS: [f64; 6] = [1e-3, 1e-2, 0.1, 0.5, 0.9, 1.0];

const ILLUMINANCE: usize = BINS.len() + 1;
const LAMBERT: usize = ILLUMINANCE + 1;

/// Budgets of [`relative_illuminance`] by the disc's ratio, relative, beyond half the sky absolute; of [`illuminance`]
/// for all discs and radiances likewise, absolute being a part of the radiance; and of [`lambert`] in units of the
/// level's last place. Answers below the least normal number, and shares of an illuminance, count as that one. Those of
/// f16's relative illuminance are 1.12 times the worst of all cosines under all discs above 0.5, and under every 17th
/// below.
pub const BUDGETS: [Row; LAMBERT + 1] = [
    ("relative illuminance, ratio to 0.001", [2.8e-7, 9.3e-7, 1.3e-5, 6.3e-3, 2.9e-7, 2.9e-7, 2.9e-7]),
    ("relative illuminance, ratio to 0.01", [2.8e-7, 9.4e-7, 1.3e-5, 6.8e-3, 2.9e-7, 2.9e-7, 2.9e-7]),
    ("relative illuminance, ratio to 0.1", [2.8e-7, 9.6e-7, 1.3e-5, 7.2e-3, 2.9e-7, 2.9e-7, 2.9e-7]),
    ("relative illuminance, ratio to 0.5", [2.8e-7, 9.7e-7, 1.7e-5, 6.5e-3, 2.9e-7, 2.9e-7, 2.9e-7]),
    ("relative illuminance, ratio to 0.9", [2.8e-7, 1.1e-6, 1.6e-5, 6.4e-3, 2.9e-7, 2.9e-7, 2.9e-7]),
    ("relative illuminance, ratio to 1", [2.8e-7, 9.1e-7, 1.7e-5, 5.5e-3, 2.9e-7, 2.9e-7, 2.9e-7]),
    ("relative illuminance, beyond half the sky", [1.4e-7, 3.9e-7, 7.6e-6, 1.7e-3, 1.4e-7, 1.4e-7, 1.4e-7]),
    ("illuminance", [4.4e-7, 1.5e-6, 2.5e-5, 7.3e-3, 4.4e-7, 4.4e-7, 4.4e-7]),
    ("lambert", [3.4, 3.3, 3.3, 3.2, 1.4, 2.9, 1.4]),
];

/// A disc over a plane, as the format holds it.
struct Scene<T: Real> {
    sphere: DistantSphere<T>,
    n_dot_l: T::Wide,
    sine: f64,
    x: f64,
    narrow: bool,
}

impl<T: Real> Scene<T> {
    fn new(lamp: &Lamp) -> Self {
        let sphere = DistantSphere::<T>::of(&lamp.light);
        let n_dot_l = T::wide(lamp.n_dot_l.clamp(-1.0, 1.0));
        let [sine, x] = [n_dot_l, sphere.sin()].map(|wide| T::scalar(wide).exact());
        Self { sphere, n_dot_l, sine, x, narrow: sphere.cos() >= T::WIDE_ZERO }
    }

    fn row(&self) -> usize {
        let bin = BINS.into_iter().position(|end| self.x <= end).unwrap_or(BINS.len() - 1);
        if self.narrow { bin } else { BINS.len() }
    }

    /// [`relative_illuminance`] by its definition, of a point the cosine.
    fn truth(&self) -> f64 {
        if self.x == 0.0 && self.narrow {
            return self.sine.max(0.0);
        }
        oracle::relative_illuminance(self.sine, self.x, if self.narrow { 1.0 } else { -1.0 })
    }

    fn answer(&self, n_dot_l: T::Wide) -> f64 {
        relative_illuminance(n_dot_l, &self.sphere).exact()
    }
}

/// Errors of the two illuminances and of Lambert's law.
pub struct Errors(pub Lamp);

impl Visitor for Errors {
    type Output = Figures;

    fn visit<T: Real>(self) -> Figures {
        let Self(lamp) = self;
        if lamp.raw {
            return NONE;
        }
        let scene = Scene::<T>::new(&lamp);
        let [least, _] = ends(lamp.format);
        let truth = scene.truth();
        let part = |error: f64, truth: f64| if scene.narrow { error.abs() / truth.max(least) } else { error.abs() };
        let error = part(scene.answer(scene.n_dot_l) - truth, truth);
        let mut figures = NONE;
        figures[0] = Some((scene.row(), error));
        figures[1] = illuminance_error(&lamp, &scene, truth).map(|error| (ILLUMINANCE, error));
        figures[2] = Some((LAMBERT, lambert_error::<T>(&lamp)));
        figures
    }
}

/// Of the illuminance, as a part of itself, beyond half the sky of the radiance; none where it is out of range.
fn illuminance_error<T: Real>(lamp: &Lamp, scene: &Scene<T>, share: f64) -> Option<f64> {
    let [least, most] = ends(lamp.format);
    let radiance = T::Scalar::nearest(lamp.levels[1]);
    let level = radiance.exact();
    let facing = level * (PI * if scene.narrow { scene.x * scene.x } else { 1.0 });
    let truth = facing * share;
    let error = (illuminance(radiance, scene.n_dot_l, &scene.sphere).exact() - truth).abs();
    let within = truth <= 0.99 * most && level <= most;
    // A share that is not a normal number has lost digits before the radiance multiplies it.
    within.then(|| error / if scene.narrow { facing * share.max(least) } else { level }.max(least))
}

/// In units of the last place: the format's, and in fixed point the level's, or that of 31 bits where it is coarser.
fn lambert_error<T: Real>(lamp: &Lamp) -> f64 {
    let albedo = T::from_f64(lamp.albedo);
    let level = T::level(T::Scalar::nearest(lamp.levels[0]));
    let n_dot_l = T::wide(lamp.n_dot_l.clamp(-1.0, 1.0));
    let [held, cosine] = [T::of_level(level), T::scalar(n_dot_l)].map(T::Scalar::exact);
    let truth = held * (albedo.to_f64() / PI * cosine.max(0.0));
    let answer = T::of_level(lambert(albedo, level, n_dot_l)).exact();
    let mantissa = if truth > 0.0 { libm::scalbn(1.0, libm::ilogb(truth) - 30) } else { 0.0 };
    let unit = match lamp.format {
        Format::I2F14 | Format::I16F16 => mantissa.max(libm::scalbn(1.0, -16)),
        Format::I2F30 => mantissa.max(libm::scalbn(1.0, -32)),
        format => format.ulp(truth.max(1e-300)),
    };
    (answer - truth).abs() / unit
}

/// What follows from the form of a disc over a plane.
pub struct Laws(pub Lamp);

impl Visitor for Laws {
    type Output = Result<(), Broken>;

    fn visit<T: Real>(self) -> Self::Output {
        let Self(lamp) = self;
        let case = lamp.case();
        let scene = Scene::<T>::new(&lamp);
        let (albedo, level) = (T::from_f64(lamp.albedo), T::level(T::Scalar::nearest(lamp.levels[0])));
        // In floats it may be NaN or infinite as well.
        let any = T::wide(lamp.n_dot_l);
        for n_dot_l in [any, scene.n_dot_l] {
            let share = scene.answer(n_dot_l);
            case.holds("shares are from 0 to 1", (0.0..=1.0 + shortfall(&lamp, &scene)).contains(&share))?;
            let [plain, disc] = [lambert(albedo, level, n_dot_l), lambert_disc(albedo, level, n_dot_l, &scene.sphere)];
            for level in [plain, disc].map(T::of_level) {
                case.holds("matt surfaces are finite", level >= T::Scalar::ZERO && level <= T::Scalar::MAX)?;
            }
        }
        bright(&lamp, &case, &scene)?;
        if lamp.raw { Ok(()) } else { horizon(&lamp, &case, &scene) }
    }
}

/// Whatever the radiance, no illuminance is negative or NaN; twice the radiance gives exactly twice of it.
fn bright<T: Real>(lamp: &Lamp, case: &Case, scene: &Scene<T>) -> Result<(), Broken> {
    let radiance = T::Scalar::nearest(lamp.levels[1]);
    let zero = T::Scalar::ZERO;
    let [once, twice] =
        [radiance, radiance + radiance].map(|radiance| illuminance(radiance, scene.n_dot_l, &scene.sphere));
    let usable = radiance >= zero && radiance <= T::Scalar::MAX;
    case.holds("illuminance is not negative", !usable || once >= zero)?;
    let [least, most] = ends(lamp.format);
    let doubled = twice.exact() == 2.0 * once.exact();
    // A product on the way may be less than the answer, by pi.
    let within = once.exact() >= 4.0 * least && twice.exact() <= most && radiance.exact() <= 0.5 * most;
    case.holds("twice the radiance is twice the illuminance", !(usable && within) || doubled)
}

/// What the budget leaves a share above 1.
fn shortfall<T: Real>(lamp: &Lamp, scene: &Scene<T>) -> f64 {
    BUDGETS[scene.row()].1[lamp.format as usize]
}

/// Below the horizon 0, well above it the cosine itself, and rising between, also from one side of either place to the
/// other.
fn horizon<T: Real>(lamp: &Lamp, case: &Case, scene: &Scene<T>) -> Result<(), Broken> {
    let share = scene.answer(scene.n_dot_l);
    let x = scene.sphere.sin();
    let down = T::narrow(T::Scalar::ZERO - T::scalar(x));
    if scene.narrow {
        case.holds("what is wholly above is its cosine", scene.n_dot_l < x || share == scene.sine)?;
        case.holds("what is wholly below is dark", scene.n_dot_l > down || share == 0.0)?;
    }
    // The next sine that the format has, two of them, that which is half as far again, and both places of contact.
    let step = lamp.format.ulp(scene.sine.abs().max(1e-30));
    for other in [scene.sine + step, scene.sine + 2.0 * step, scene.sine + 0.5 * scene.x] {
        rises(lamp, case, scene, [scene.n_dot_l, T::wide(other.min(1.0))])?;
    }
    for place in [x, down, T::WIDE_ZERO] {
        let (low, high) = if place < scene.n_dot_l { (place, scene.n_dot_l) } else { (scene.n_dot_l, place) };
        rises(lamp, case, scene, [low, high])?;
    }
    Ok(())
}

/// Illuminance rises with the sine, but for twice the budget; and by no more than the sine does, or the disc's own
/// cosine allows, but for the same.
fn rises<T: Real>(lamp: &Lamp, case: &Case, scene: &Scene<T>, ends: [T::Wide; 2]) -> Result<(), Broken> {
    let [from, to] = ends.map(|end| T::scalar(end).exact());
    let [low, high] = ends.map(|end| scene.answer(end));
    let [least, _] = super::formulas::ends(lamp.format);
    let budget = BUDGETS[scene.row()].1[lamp.format as usize];
    let size = if scene.narrow { low.max(high).max(least) } else { 1.0 };
    case.at_most("illuminance rises with the sine", low - high, 2.0 * budget * size)?;
    // The slope is the share of the disc that is above the plane, beyond half the sky that of the other disc times its
    // squared sine.
    case.at_most("illuminance rises no faster than the sine", high - low - (to - from), 2.0 * budget * size + 1e-15)
}
