//! One solid angle by three ways, as the lectures on quantifying light have it, and the density that is its reciprocal.

mod exact;

use ::fixed::types::{I2F14, I2F30, I16F16};
use exact::{assert_tight, big, worse, worst};
use half::f16;
use micromath::F32;
use sunglint::oracle::cone;
use sunglint::sampling::{Cone, points};
use sunglint::{DistantLight, DistantSphere, Float, LightError, Real, SUN, Scalar};

fn ratio(ratio: f64) -> DistantLight {
    DistantLight::from_ratio(ratio).unwrap()
}

fn cone_of<T: Real>(light: &DistantLight) -> Cone<T> {
    Cone::new([0.0, 0.6, 0.8].map(T::from_f64), &DistantSphere::of(light))
}

/// The closed form, the sum of `V dw` over the hemisphere and the sum of `cos / r^2 dA` over the sphere's visible side.
///
/// The area sum falls with the square of the number of rings. The hemisphere's counts cells: those of the edge are as
/// many as fit along it, and in or out by chance, which makes `(x side)^-1.5` of the whole.
#[test]
fn three_ways_to_the_same_solid_angle() {
    for x in [0.1, 0.2, 0.4, 0.6] {
        let light = ratio(x);
        let closed = light.solid_angle();
        let disc = Cone::new([0.48, 0.36, 0.8], &DistantSphere::<f64>::new(&light));
        assert!((disc.solid_angle() / closed - 1.0).abs() < 1e-15);
        let mut scaled = [0.0_f64; 2];
        for count in [32, 64, 128, 256, 512] {
            let cells = cone::solid_angle_by_hemisphere(count, |direction| disc.contains(direction)) / closed - 1.0;
            let rings = cone::solid_angle_by_area(x, count) / closed - 1.0;
            println!("{x}, {count}: cells {cells:+.1e}, rings {rings:+.1e}");
            let side = f64::from(count);
            scaled[0] = worse(scaled[0], cells.abs() * (x * side).powf(1.5));
            scaled[1] = worse(scaled[1], rings.abs() * side * side);
        }
        assert_tight("cells", scaled[0], 1.5);
        assert_tight("rings", scaled[1], 0.55);
    }
}

/// Relative error of solid angle and density.
fn relative<T: Real>(light: &DistantLight) -> [f64; 2] {
    let cone = cone_of::<T>(light);
    let truth = light.solid_angle();
    [cone.solid_angle().exact() / truth - 1.0, cone.pdf().unwrap().exact() * truth - 1.0].map(f64::abs)
}

fn spheres() -> impl Iterator<Item = DistantLight> {
    let wide = (1..=180).map(|i| DistantLight::from_angle(180.0 + f64::from(i)).unwrap());
    exact::spread(2000, 1e-5, 1.0).map(ratio).chain(wide)
}

/// The density times the solid angle in units of the last place of 1.
fn product<T: Float + Real<Scalar = T>>(cone: &Cone<T>) -> f64 {
    ulps_of_one::<T>(big(cone.pdf().unwrap().exact()) * big(cone.solid_angle().exact()))
}

fn ulps_of_one<T: Float>(product: exact::Big) -> f64 {
    let place = exact::last_place::<T>(&big(1.0));
    exact::distance(&product, &big(1.0), place)
}

#[test]
fn density_times_solid_angle_is_one() {
    fn check<T: Float + Real<Scalar = T>>() {
        let products = spheres().map(|light| product(&cone_of::<T>(&light)));
        assert_tight(&format!("{}, ULP", T::FORMAT), worst(products), 1.0);
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    // Normal solid angles.
    let normal = spheres().filter(|light| light.solid_angle() >= 6.2e-5);
    assert_tight("f16, ULP", worst(normal.map(|light| product(&cone_of::<f16>(&light)))), 1.0);
    let fixed = |product: fn(&DistantLight) -> f64| worst(spheres().map(|light| product(&light)));
    fn scaled<T: Real>(light: &DistantLight) -> f64 {
        let cone = cone_of::<T>(light);
        (cone.pdf().unwrap().exact() * cone.solid_angle().exact() - 1.0).abs() * f64::from(1_u32 << 30)
    }
    assert_tight("I2F14, 2^-30", fixed(scaled::<I2F14>), 2.0);
    assert_tight("I2F30, 2^-30", fixed(scaled::<I2F30>), 2.0);
    assert_tight("I16F16, 2^-30", fixed(scaled::<I16F16>), 2.0);
}

/// Against the light itself, whose ratio the format has rounded.
#[test]
fn density_and_solid_angle_are_those_of_the_light() {
    fn check<T: Real>(least: f64, budget: f64) {
        let errors =
            spheres().filter(|light| light.sin() >= least || light.cos() < 0.0).flat_map(|light| relative::<T>(&light));
        assert_tight(T::NAME, worst(errors), budget);
    }
    check::<f64>(0.0, RELATIVE[0]);
    check::<f32>(0.0, RELATIVE[1]);
    check::<F32>(0.0, RELATIVE[2]);
    check::<f16>(4.5e-3, RELATIVE[3]);
    check::<I2F14>(1e-3, RELATIVE[4]);
    check::<I2F30>(0.0, RELATIVE[5]);
    check::<I16F16>(1e-3, RELATIVE[6]);
}

/// 1.12 times what these lights give.
const RELATIVE: [f64; 7] = [5.0e-16, 3.7e-7, 3.7e-7, 2.8e-3, 3.9e-6, 3.4e-9, 2.3e-7];

/// Every ratio that f16 has.
#[test]
fn density_in_f16_overflows_where_the_docs_say() {
    let mut last = 0.0;
    for bits in 1..=f16::ONE.to_bits() {
        let ratio = f16::from_bits(bits);
        let cone = Cone::new([f16::ZERO, f16::ZERO, f16::ONE], &DistantSphere::<f16>::from_ratio(ratio).unwrap());
        match cone.pdf() {
            Ok(pdf) => {
                let truth = 1.0 / sunglint::oracle::closed::solid_angle(ratio.to_f64());
                assert!((pdf.to_f64() / truth - 1.0).abs() < 2.5e-3, "{ratio}: {pdf} in place of {truth}");
            }
            Err(error) => {
                assert_eq!(error, LightError::Overflow("f16"));
                last = ratio.to_f64();
            }
        }
    }
    println!("overflows up to {last}");
    assert!((last - 0.0022).abs() < 1e-5);
    let sun = cone_of::<f16>(&SUN);
    println!("Sun in f16: density {}, solid angle {}", sun.pdf().unwrap(), sun.solid_angle());
    assert!((sun.pdf().unwrap().to_f64() * SUN.solid_angle() - 1.0).abs() < 2.5e-3);
}

#[test]
fn a_point_has_density_one_and_no_solid_angle() {
    fn check<T: Real>() {
        let cone = cone_of::<T>(&ratio(0.0));
        assert_eq!((cone.pdf(), cone.solid_angle()), (Ok(Scalar::ONE), Scalar::ZERO));
        assert!(points(0, 16).all(|point| cone.direction(point) == [0.0, 0.6, 0.8].map(T::from_f64)));
    }
    check::<f64>();
    check::<f32>();
    check::<F32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
    check::<I16F16>();
}

/// A density from another expression than the sampler, as a renderer in wide use has it.
#[test]
fn the_subtraction_is_a_third_of_a_percent_off() {
    let x = SUN.sin() as f32;
    let by_subtraction = 1.0 / (2.0 * std::f32::consts::PI * (1.0 - (1.0 - x * x).sqrt()));
    let off = |pdf: f32| (f64::from(pdf) * SUN.solid_angle() - 1.0).abs();
    println!("by subtraction {:.2e}, here {:.2e}", off(by_subtraction), off(cone_of::<f32>(&SUN).pdf().unwrap()));
    assert!((3.1e-3..3.3e-3).contains(&off(by_subtraction)) && off(cone_of::<f32>(&SUN).pdf().unwrap()) < 1e-7);
    let tiny = 1e-4_f32;
    assert!((1.0 / (2.0 * std::f32::consts::PI * (1.0 - (1.0 - tiny * tiny).sqrt()))).is_infinite());
}
