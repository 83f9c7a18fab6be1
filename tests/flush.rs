//! f16 on hardware that flushes subnormals to zero: right as it is, and lost without the scale.

use sunglint::oracle::planck::Law;
use sunglint::trial::diffuse::RELATIVE;
use sunglint::trial::emulated::{FlushingF16, UnscaledF16};
use sunglint::trial::lights::BUDGETED;
use sunglint::trial::radiometry::Formula;
use sunglint::trial::{Format, Method, Shading, blackbody, budget, gloss, input, judge};
use sunglint::{DistantSphere, Real, SUN, Scalar, cap, oracle, relative_illuminance};

/// The catalogue's scene at 1.5 times the radius of a Sun of ratio 0.00465: where the answer lies, and where `r` does,
/// in radii.
fn turns<T: Real>() -> [f64; 2] {
    let light = sunglint::DistantLight::from_ratio(0.00465).unwrap();
    let theta = light.angular_radius();
    let pair = input::scene(1.5 * theta);
    let (l, r) = (pair.l.map(T::from_f64), pair.r.map(T::from_f64));
    let answer = cap(l, r, &DistantSphere::<T>::of(&light));
    [answer, r].map(|v| oracle::angle_between(l.map(T::to_f64), v.map(T::to_f64)) / theta)
}

#[test]
fn without_the_scale_the_sun_is_drawn_too_wide() {
    let [answer, mirror] = turns::<UnscaledF16>();
    assert_eq!(answer, mirror);
    let [answer, _] = turns::<FlushingF16>();
    assert!((answer - 0.996).abs() < 0.0002, "{answer}");
}

/// Worst error of `cap` at the Sun where `r` is farther than `steps` steps of f16 from `-l`.
fn worst_beyond(steps: f64) -> f64 {
    let theta = SUN.angular_radius();
    let pairs = input::random(1, 50_000, theta).chain(input::hard(theta));
    judge::<FlushingF16>(Method::Cap, &SUN, pairs, steps * Format::F16.step()).worst.error
}

#[test]
fn cap_keeps_the_budget_of_f16() {
    let budget = budget::maximum(Method::Cap, Format::F16, 0).unwrap();
    let worst = worst_beyond(4.0);
    assert!(worst <= budget && worst >= budget / 4.0, "{worst:e}");
}

/// Beside `-l` the tangent's own lanes are flushed, which costs up to a sixth of the Sun's radius.
#[test]
fn beside_the_opposite_flushing_costs_a_little() {
    let worst = worst_beyond(1.0);
    assert!((8.1e-4 / 4.0..=8.1e-4).contains(&worst), "{worst:e}");
}

/// Black bodies and radiometry keep the budgets of f16: their intermediates are normal numbers where the answer is.
#[test]
fn radiometry_and_black_bodies_keep_the_budgets_of_f16() {
    for formula in Formula::ALL {
        let worst = formula.error::<FlushingF16>(1, 20_000);
        let budget = formula.maximum(Format::F16);
        assert!(worst.max <= budget && worst.max >= budget / 4.0, "{} {worst:?}", formula.name());
    }
    for law in Law::ALL {
        let worst = blackbody::relative_error::<FlushingF16>(law, 1, 20_000);
        let budget = blackbody::RELATIVE[law as usize][Format::F16 as usize];
        assert!(worst.max <= budget && worst.max >= budget / 4.0, "{law:?} {worst:?}");
        // What is below the least normal number is lost.
        let lost = blackbody::absolute_error::<FlushingF16>(law, 1, 20_000);
        assert!(lost.max <= blackbody::ABSOLUTE[law as usize][Format::F16 as usize], "{law:?} {lost:?}");
    }
    let tints = blackbody::tint_error::<FlushingF16>(1, 20_000);
    assert!(tints.max <= blackbody::TINT[Format::F16 as usize], "{tints:?}");
}

#[test]
fn sampling_keeps_the_budget_of_f16() {
    let budget = sunglint::trial::sampling::DIRECTION[0][Format::F16 as usize];
    let worst = sunglint::trial::sampling::direction_error::<FlushingF16>(&SUN, 1, 20_000).max;
    assert!(worst <= budget && worst >= budget / 4.0, "{worst:e}");
    let cone = sunglint::sampling::Cone::new([0.0, 0.6, 0.8].map(FlushingF16::from_f64), &DistantSphere::of(&SUN));
    let density = cone.pdf().unwrap().exact() * SUN.solid_angle();
    assert!((density - 1.0).abs() < 2e-3, "{density}");
}

/// A setting disc keeps the budget of f16 down to the least normal number, below which its light is zero; the segment's
/// part of it is scaled by 64 and lost below that.
#[test]
fn a_setting_disc_keeps_the_budget_of_f16() {
    const LEAST: f64 = 1.0 / 16384.0;
    for (light, budgets) in BUDGETED.into_iter().zip(RELATIVE) {
        let sphere = DistantSphere::<FlushingF16>::of(&light.light);
        let x = sphere.sin().exact();
        for step in -1000..=1000 {
            let cosine = FlushingF16::from_f64(x * f64::from(step) / 1000.0);
            let truth = oracle::diffuse::relative_illuminance(cosine.exact(), x, 1.0);
            let answer = relative_illuminance(cosine, &sphere).exact();
            let kept = budgets[Format::F16 as usize] * truth + LEAST / 64.0;
            let allowed = if truth > 1.01 * LEAST { kept } else { LEAST };
            assert!((answer - truth).abs() <= allowed, "{} at {step}: {answer:e}, not {truth:e}", light.name);
        }
    }
}

/// Whole pixels too, the root mean square to within a tenth: highlights are measured in their own widths, so that only
/// their far tails are subnormal.
#[test]
fn lit_pixels_keep_the_budgets_of_f16() {
    for (index, case) in gloss::CASES.iter().enumerate() {
        for method in [Shading::Karis, Shading::DiscGgx, Shading::ConeGgx] {
            let found = gloss::arithmetic::<FlushingF16>(method, case, case.pixels(1, 10_000));
            let family = gloss::family(method);
            let [max, mean] = [gloss::MAXIMA, gloss::MEANS].map(|table| table[family][index][Format::F16 as usize]);
            let name = format!("{}, {}: {:e} {:e}", method.name(), case.name, found.max, found.rms());
            assert!(found.max <= max && found.max >= max / 4.0 && found.rms() <= 1.1 * mean, "{name}");
        }
    }
}
