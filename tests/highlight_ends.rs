//! The ends of every highlight: a mirror's image ends at the disc's rim, and a point is a disc of no size.

use std::f64::consts::PI;

use half::f16;
use sunglint::oracle::highlight::{Glossy, Pixel};
use sunglint::trial::{Format, Shading, Visitor};
use sunglint::{DistantLight, DistantSphere, Real, SUN};

fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

/// A surface of normal `(0, 0, 1)`, and a viewer who sees the light's centre mirrored in it, `degrees` off the normal.
fn mirrored(degrees: f64) -> Pixel {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Pixel { n: [0.0, 0.0, 1.0], v: [-sin, 0.0, cos], l: [sin, 0.0, cos] }
}
/// Where the mirrored disc ends: half of a hundredth of its radius within the rim there is all of its radiance, as much
/// outside nothing, in the plane of incidence and across it.
struct MirroredRim {
    ratio: f64,
    degrees: f64,
}

impl Visitor for MirroredRim {
    type Output = ();

    fn visit<T: Real>(self) {
        let light = DistantLight::from_ratio(self.ratio).unwrap();
        let sphere = DistantSphere::<T>::of(&light);
        let pixel = mirrored(self.degrees);
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        let [plane, across] = [[cos, 0.0, -sin], [0.0, 1.0, 0.0]];
        for (turn, part) in (0..16).flat_map(|step| [(step, 0.995), (step, 1.005)]) {
            let (up, aside) = (f64::from(turn) * PI / 8.0).sin_cos();
            let toward = [0, 1, 2].map(|i| aside * plane[i] + up * across[i]);
            let angle = part * light.angular_radius();
            // The centre is beside the mirror ray.
            let l = [0, 1, 2].map(|i| angle.cos() * pixel.l[i] + angle.sin() * toward[i]);
            let glossy = Glossy { alpha: 0.0, f0: 1.0, ratio: self.ratio };
            let [n, v, l] = [pixel.n, pixel.v, l].map(|vector| vector.map(T::from_f64));
            let [cone, karis] = [Shading::ConeGgx, Shading::Karis].map(|m| m.radiance(&glossy, &sphere, [n, v, l]));
            let name =
                format!("{} at {}, {} degrees, {part} of the radius at {turn}", T::NAME, self.ratio, self.degrees);
            assert_eq!([cone > 0.0, karis > 0.0], [part < 1.0; 2], "{name}: {cone} {karis}");
        }
    }
}

#[test]
fn a_mirror_shows_the_disc_to_its_rim() {
    // Formats whose steps are below half of a hundredth of the radius.
    for (ratio, formats) in [
        (SUN.sin(), &[Format::F64, Format::F32, Format::Micromath, Format::I2F30][..]),
        (0.3, &[Format::F64, Format::F32, Format::I2F14, Format::I2F30, Format::I16F16][..]),
    ] {
        for format in formats {
            for degrees in [0.0, 45.0, 60.0] {
                format.visit(MirroredRim { ratio, degrees });
            }
        }
    }
}

/// The ends of every method: a mirror under the Sun shows its whole radiance, a point light is that of no size, and
/// what was left to guards at zero is not dark.
struct Ends;

impl Visitor for Ends {
    type Output = ();

    fn visit<T: Real>(self) {
        let allowed = if T::NAME == f16::NAME { 1e-2 } else { 3e-4 };
        let level = |method: Shading, alpha: f64, ratio: f64, degrees: f64| {
            let sphere = DistantSphere::<T>::of(&DistantLight::from_ratio(ratio).unwrap());
            let pixel = mirrored(degrees);
            let vectors = [pixel.n, pixel.v, pixel.l].map(|vector| vector.map(T::from_f64));
            method.radiance(&Glossy { alpha, f0: 1.0, ratio }, &sphere, vectors)
        };
        for method in Shading::ALL.into_iter().filter(|method| *method != Shading::None) {
            // Straight on, where all methods have the right radiance; that of `x/3` is greater by the square of 3/2.
            let peak = 1.0 / (PI * SUN.sin().powi(2));
            let expected = if method == Shading::KarisThird { 9.0 / 4.0 * peak } else { peak };
            let name = format!("{} in {}", method.name(), T::NAME);
            assert_near(level(method, 0.0, SUN.sin(), 0.0) / expected, 1.0, allowed);
            for alpha in [0.01, 0.5] {
                let [point, none] = [method, Shading::None].map(|method| level(method, alpha, 0.0, 30.0));
                assert!((point / none - 1.0).abs() < allowed && point > 0.0, "{name}: {point}, {none}");
            }
            // A mirror under a point shows no area.
            assert_eq!(level(method, 0.0, 0.0, 30.0), 0.0, "{name}");
        }
        assert_eq!(level(Shading::None, 0.0, 0.0, 30.0), 0.0, "{}", T::NAME);
    }
}

#[test]
fn mirrors_and_points_are_the_ends_of_every_method() {
    Format::ALL.into_iter().for_each(|format| format.visit(Ends));
}
