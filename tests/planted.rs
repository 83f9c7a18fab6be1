//! The judges are judged: an error planted into a format, of the size that its last place has, is one that the budgets
//! of every family catch; and what they cannot catch is said.

mod exact;
#[path = "exact/planted.rs"]
mod plant;

use exact::{big, lsbs, ratios_q30, spread, ulps, worst};
use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use micromath::F32;
use plant::{Off, Rough, format};
use sunglint::oracle::planck::Law;
use sunglint::trial::quantity::Quantity;
use sunglint::trial::radiometry::Formula;
use sunglint::trial::{self, Method, Shading, blackbody, budget, gloss, input, judge};
use sunglint::{Float, Real, SUN, Scalar};

/// What a family's judge finds in a format, in units of its budget.
trait Family {
    fn part<T: Real>(&self) -> f64;
}

/// Nothing planted is within the budget, one step in one lane of vectors (one place of levels) is not.
fn catches_steps_in<T: Real, const STEPS: u8, const SUMS: bool>(name: &str, family: &impl Family) {
    let [sound, planted] = [family.part::<Off<T, 0, SUMS>>(), family.part::<Off<T, STEPS, SUMS>>()];
    println!("{name} in {}: {sound:.2} of the budget, with {STEPS} steps {planted:.2}", T::NAME);
    assert!(sound <= 1.0, "{name} in {}: {sound}", T::NAME);
    assert!(planted > 1.0, "{name} in {}: {STEPS} steps pass for {planted}", T::NAME);
}

fn catches_rough_roots_in<T: Float + Real, const PLACES: u8>(name: &str, family: &impl Family) {
    let [sound, planted] = [family.part::<Rough<T, 0>>(), family.part::<Rough<T, PLACES>>()];
    println!(
        "{name} in {}: {sound:.2} of the budget, with roots and quotients {PLACES} places off {planted:.2}",
        T::FORMAT
    );
    assert!(sound <= 1.0, "{name} in {}: {sound}", T::FORMAT);
    assert!(planted > 1.0, "{name} in {}: {PLACES} places pass for {planted}", T::FORMAT);
}

fn catches_steps<const STEPS: u8, const SUMS: bool>(name: &str, family: &impl Family) {
    catches_steps_in::<f64, STEPS, SUMS>(name, family);
    catches_steps_in::<f32, STEPS, SUMS>(name, family);
    catches_steps_in::<F32, STEPS, SUMS>(name, family);
    catches_steps_in::<f16, STEPS, SUMS>(name, family);
    catches_steps_in::<I2F14, STEPS, SUMS>(name, family);
    catches_steps_in::<I2F30, STEPS, SUMS>(name, family);
    catches_steps_in::<I16F16, STEPS, SUMS>(name, family);
}

struct Directions(Method);

impl Family for Directions {
    fn part<T: Real>(&self) -> f64 {
        let theta = SUN.angular_radius();
        let recorded = trial::worst::under(self.0, format::<T>(), 0);
        let pairs = input::random(1, 20_000, theta).chain(input::hard(theta)).chain(recorded);
        let worst = judge::<T>(self.0, &SUN, pairs, format::<T>().step()).worst.error;
        worst / budget::maximum(self.0, format::<T>(), 0).unwrap()
    }
}

#[test]
fn directions() {
    catches_steps::<1, false>("cap", &Directions(Method::Cap));
    catches_steps::<2, false>("factored", &Directions(Method::Factored));
    // With its lengths of 150 million km two are within what the oracle itself rounds.
    catches_steps_in::<f64, 3, false>("epic", &Directions(Method::Epic));
    catches_steps_in::<f32, 2, false>("epic", &Directions(Method::Epic));
}

/// What is wrong with `disc` itself is many steps; its budgets say so, and cannot tell a step more.
#[test]
fn a_step_drowns_in_the_errors_of_disc() {
    let parts = [Directions(Method::Disc).part::<Off<f32, 2>>(), Directions(Method::Disc).part::<Off<I2F14, 2>>()];
    println!("{parts:?}");
    assert!(parts.into_iter().all(|part| part <= 1.0), "{parts:?}");
}

struct Sampling;

impl Family for Sampling {
    fn part<T: Real>(&self) -> f64 {
        let budget = trial::sampling::DIRECTION[0][format::<T>() as usize];
        trial::sampling::direction_error::<T>(&SUN, 1, 20_000).max / budget
    }
}

struct Basis;

impl Family for Basis {
    fn part<T: Real>(&self) -> f64 {
        trial::sampling::basis_error::<T>(1, 20_000).max / trial::sampling::BASIS[format::<T>() as usize]
    }
}

#[test]
fn samples() {
    catches_steps::<2, true>("samples", &Sampling);
    catches_steps::<2, true>("basis", &Basis);
}

struct Lambert;

impl Family for Lambert {
    fn part<T: Real>(&self) -> f64 {
        trial::diffuse::lambert_error::<T>(1, 20_000).max / trial::diffuse::LAMBERT[format::<T>() as usize]
    }
}

struct Setting(usize);

impl Family for Setting {
    fn part<T: Real>(&self) -> f64 {
        let light = trial::lights::BUDGETED[self.0].light;
        let budget = trial::diffuse::RELATIVE[self.0][format::<T>() as usize];
        trial::diffuse::relative_illuminance_error::<T>(&light, 1, 20_000).max / budget
    }
}

#[test]
fn diffuse_light() {
    catches_steps::<2, false>("lambert", &Lambert);
    catches_rough_roots_in::<f32, 2>("setting", &Setting(0));
    catches_rough_roots_in::<f16, 2>("setting", &Setting(0));
}

struct Gloss {
    method: Shading,
    case: usize,
}

impl Family for Gloss {
    fn part<T: Real>(&self) -> f64 {
        let case = &gloss::CASES[self.case];
        let found = gloss::arithmetic::<T>(self.method, case, case.pixels(1, 10_000));
        let of = |table: [[[f64; 7]; 5]; 6]| table[gloss::family(self.method)][self.case][format::<T>() as usize];
        (found.max / of(gloss::MAXIMA)).max(found.rms() / of(gloss::MEANS))
    }
}

#[test]
fn pixels() {
    for method in [Shading::Karis, Shading::DiscGgx, Shading::ConeGgx] {
        let name = method.name();
        let family = Gloss { method, case: 2 };
        catches_steps_in::<f64, 2, false>(name, &family);
        catches_steps_in::<f32, 2, false>(name, &family);
        // Whose roots are fifty of its last places off by themselves.
        catches_steps_in::<F32, 50, false>(name, &family);
        catches_steps_in::<f16, 2, false>(name, &family);
        catches_steps_in::<I2F14, 2, false>(name, &family);
        catches_steps_in::<I2F30, 2, false>(name, &family);
        catches_steps_in::<I16F16, 2, false>(name, &family);
    }
}

struct Radiometry(Formula);

impl Family for Radiometry {
    fn part<T: Real>(&self) -> f64 {
        self.0.error::<T>(1, 20_000).max / self.0.maximum(format::<T>())
    }
}

/// A quantity's answer, planted: worst distance from the truth in units of the last place.
fn worst_quantity<T: Float + Real>(quantity: Quantity, places: f64) -> f64 {
    let ratios = spread(1000, 1e-6, 1.0).map(T::nearest);
    worst(ratios.filter_map(|ratio| quantity.in_float(ratio).ok().map(|computed| (ratio, computed))).map(
        |(ratio, computed)| {
            let exact = Scalar::exact(computed);
            let planted = T::nearest(exact + places * format::<T>().ulp(exact));
            ulps(planted, &truth(quantity, Scalar::exact(ratio)))
        },
    ))
}

/// In 192 bits.
fn truth(quantity: Quantity, ratio: f64) -> exact::Big {
    let x = big(ratio);
    let square = exact::square(&x);
    match quantity {
        Quantity::Versine => exact::versine(&x),
        Quantity::SolidAngle => big(2.0) * exact::pi() * exact::versine(&x),
        Quantity::SizeFactor => exact::pi() * square,
        Quantity::InverseSizeFactor => big(1.0) / (exact::pi() * square),
        Quantity::WhiteRadiance => big(1.0) / square,
    }
}

/// The bounds of `tests/normalization.rs`.
#[test]
fn quantities_in_floats() {
    for quantity in Quantity::ALL {
        let check = |of: fn(Quantity, f64) -> f64, bound: f64| {
            let [sound, below, above] = [0.0, -1.0, 1.0].map(|places| of(quantity, places));
            println!("{}: {sound:.2}, a place below {below:.2}, above {above:.2}", quantity.name());
            assert!(sound <= bound && below > bound && above > bound, "{}", quantity.name());
        };
        check(worst_quantity::<f64>, 0.51);
        check(worst_quantity::<f32>, 0.51);
        check(worst_quantity::<F32>, 0.51);
        check(worst_quantity::<f16>, 0.8);
    }
}

#[test]
fn quantities_in_fixed_point() {
    for quantity in Quantity::ALL {
        let errors = |steps: f64| {
            worst(ratios_q30(1000).filter(|bits| *bits >= 1074).filter_map(|bits| {
                let ratio = I2F30::from_bits(bits);
                let found = quantity.in_fixed(ratio).ok()?;
                let fraction = if found.format == "U16F48" { 48 } else { 12 };
                let planted = (found.value / found.lsb + steps) as i128;
                Some(lsbs(planted, fraction, &truth(quantity, ratio.to_num())))
            }))
        };
        let [sound, below, above] = [0.0, -1.0, 1.0].map(errors);
        println!("{}: {sound:.2}, a step below {below:.2}, above {above:.2}", quantity.name());
        // Documented is 1; half of that is what rounding, in place of cutting off, gives.
        assert!(sound <= 0.51 && below > 1.0 && above > 1.0, "{}", quantity.name());
    }
}

#[test]
fn radiometry() {
    // All but the product with 1/pi divide.
    for formula in Formula::ALL.into_iter().filter(|formula| *formula != Formula::DiffuseRadiance) {
        let family = Radiometry(formula);
        catches_rough_roots_in::<f64, 2>(formula.name(), &family);
        catches_rough_roots_in::<f32, 2>(formula.name(), &family);
        catches_rough_roots_in::<f16, 2>(formula.name(), &family);
    }
}

struct Planck(Law);

impl Family for Planck {
    fn part<T: Real>(&self) -> f64 {
        blackbody::relative_error::<T>(self.0, 1, 20_000).max
            / blackbody::RELATIVE[self.0 as usize][format::<T>() as usize]
    }
}

#[test]
fn black_bodies() {
    for law in Law::ALL {
        catches_rough_roots_in::<f64, 2>("Planck", &Planck(law));
        catches_rough_roots_in::<f32, 2>("Planck", &Planck(law));
        catches_rough_roots_in::<f16, 2>("Planck", &Planck(law));
    }
}
