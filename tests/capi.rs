//! The functions for C are those of `raw` and `soft` on plain structs, and what is not there or out of range has the
//! answer that their documentation says.

use std::ffi::c_void;
use std::mem::{align_of, offset_of, size_of};
use std::ptr;

use oorandom::Rand64;
use sunglint::capi::*;
use sunglint::raw::{self, SUN_Q14, SUN_Q30};
use sunglint::scene::Channel;
use sunglint::soft;

const CASES: u32 = 2000;

/// Arguments of any bits, half of the vectors at unit length.
struct Source(Rand64);

impl Source {
    fn new(seed: u128) -> Self {
        Self(Rand64::new(seed))
    }

    fn bits(&mut self) -> u64 {
        self.0.rand_u64()
    }

    fn unit(&mut self) -> bool {
        self.bits() & 1 == 0
    }

    fn lanes_q14(&mut self) -> [i16; 3] {
        let any = [0; 3].map(|_: u8| self.bits() as i16);
        if self.unit() { raw::normalize_q14(any) } else { any }
    }

    fn lanes_q30(&mut self) -> [i32; 3] {
        let any = [0; 3].map(|_: u8| self.bits() as i32);
        if self.unit() { raw::normalize_q30(any) } else { any }
    }

    fn floats(&mut self) -> [f32; 3] {
        let any = [0; 3].map(|_: u8| f32::from_bits(self.bits() as u32));
        if self.unit() { soft::normalize(any) } else { any }
    }

    /// From points to half the sky, as many of each order of size.
    fn ratio(&mut self) -> i32 {
        1 << 30 >> (self.bits() % 31)
    }
}

fn bits(v: [f32; 3]) -> [u32; 3] {
    v.map(f32::to_bits)
}

#[test]
fn directions_in_q14() {
    let mut source = Source::new(1);
    for _ in 0..CASES {
        let (a, b, ratio) = (source.lanes_q14(), source.lanes_q14(), source.ratio());
        let sphere = raw::sphere_q14(ratio).unwrap();
        let made = sunglint_sphere_q14(ratio);
        assert_eq!(made, SphereQ14Made { status: Status::Ok, sphere: sphere.into() });
        let (l, r) = (VectorQ14::from(a), VectorQ14::from(b));
        assert_eq!(<[i16; 3]>::from(sunglint_cap_q14(l, r, made.sphere)), raw::cap_q14(a, b, &sphere));
        assert_eq!(<[i16; 3]>::from(sunglint_factored_q14(l, r, made.sphere)), raw::factored_q14(a, b, &sphere));
        assert_eq!(<[i16; 3]>::from(sunglint_reflect_q14(l, r)), raw::reflect_q14(a, b));
        assert_eq!(<[i16; 3]>::from(sunglint_normalize_q14(l)), raw::normalize_q14(a));
        let x = source.bits() as u32 >> (source.bits() & 31);
        assert_eq!(sunglint_reciprocal_root_q16(x), raw::reciprocal_root_q16(x));
    }
}

#[test]
fn directions_in_q30() {
    let mut source = Source::new(2);
    for _ in 0..CASES {
        let (a, b, ratio) = (source.lanes_q30(), source.lanes_q30(), source.ratio());
        let sphere = raw::sphere_q30(ratio).unwrap();
        let made = sunglint_sphere_q30(ratio);
        assert_eq!(made, SphereQ30Made { status: Status::Ok, sphere: sphere.into() });
        let (l, r) = (VectorQ30::from(a), VectorQ30::from(b));
        assert_eq!(<[i32; 3]>::from(sunglint_cap_q30(l, r, made.sphere)), raw::cap_q30(a, b, &sphere));
        assert_eq!(<[i32; 3]>::from(sunglint_factored_q30(l, r, made.sphere)), raw::factored_q30(a, b, &sphere));
        assert_eq!(<[i32; 3]>::from(sunglint_reflect_q30(l, r)), raw::reflect_q30(a, b));
        assert_eq!(<[i32; 3]>::from(sunglint_normalize_q30(l)), raw::normalize_q30(a));
    }
}

#[test]
fn floats_in_integers() {
    let mut source = Source::new(3);
    for _ in 0..CASES {
        let (a, b) = (source.floats(), source.floats());
        let (l, r) = (VectorF32::from(a), VectorF32::from(b));
        let sun = SUN_Q30.into();
        assert_eq!(bits(sunglint_soft_cap(l, r, sun).into()), bits(soft::cap(a, b, &SUN_Q30)));
        assert_eq!(bits(sunglint_soft_reflect(l, r).into()), bits(soft::reflect(a, b)));
        assert_eq!(bits(sunglint_soft_normalize(l).into()), bits(soft::normalize(a)));
        let x = f32::from_bits(source.bits() as u32);
        assert_eq!(sunglint_soft_root(x).to_bits(), soft::root(x).to_bits());
        assert_eq!(sunglint_soft_reciprocal_root(x).to_bits(), soft::reciprocal_root(x).to_bits());
    }
}

#[test]
fn diffuse_light() {
    let mut source = Source::new(4);
    for _ in 0..CASES {
        let ratio = source.ratio();
        let (narrow, wide) = (raw::sphere_q14(ratio).unwrap(), raw::sphere_q30(ratio).unwrap());
        let (albedo, level, cosine) = (source.bits() as i64, source.bits(), source.bits() as i64 >> 2);
        let (rho, e, n_dot_l) = ((albedo >> 48) as i16, (level >> 32) as u32, (cosine >> 32) as i32);
        assert_eq!(sunglint_lambert_q14(rho, e, n_dot_l), raw::lambert_q14(rho, e, n_dot_l));
        let disc = sunglint_lambert_disc_q14(rho, e, n_dot_l, narrow.into());
        assert_eq!(disc, raw::lambert_disc_q14(rho, e, n_dot_l, &narrow));
        let relative = sunglint_relative_illuminance_q14(n_dot_l, narrow.into());
        assert_eq!(relative, raw::relative_illuminance_q14(n_dot_l, &narrow));
        let rho = (albedo >> 32) as i32;
        assert_eq!(sunglint_lambert_q30(rho, level, cosine), raw::lambert_q30(rho, level, cosine));
        let disc = sunglint_lambert_disc_q30(rho, level, cosine, wide.into());
        assert_eq!(disc, raw::lambert_disc_q30(rho, level, cosine, &wide));
        let relative = sunglint_relative_illuminance_q30(cosine, wide.into());
        assert_eq!(relative, raw::relative_illuminance_q30(cosine, &wide));
    }
}

/// Half of the directions, if the caller's pointer has arrived.
extern "C" fn sees_q14(direction: VectorQ14, user: *mut c_void) -> bool {
    user.addr() == USER && direction.x & 1 == 0
}

extern "C" fn sees_q30(direction: VectorQ30, user: *mut c_void) -> bool {
    user.addr() == USER && direction.x & 1 == 0
}

/// An address that is passed on and not looked at.
const USER: usize = 42;

#[test]
fn sampling_in_q14() {
    let (mut source, user) = (Source::new(5), ptr::without_provenance_mut(USER));
    for index in 0..CASES {
        let (l, n, light) = (source.lanes_q14(), source.lanes_q14(), raw::sphere_q14(source.ratio()).unwrap());
        let cone = raw::cone_q14(l, &light);
        assert_eq!(sunglint_cone_q14(l.into(), light.into()), cone);
        let point = [source.bits() as i16, source.bits() as i16];
        let direction = sunglint_cone_direction_q14(Some(&cone), PointQ14 { z: point[0], turn: point[1] });
        assert_eq!(<[i16; 3]>::from(direction), raw::cone_direction_q14(&cone, point));
        for any in [direction, n.into()] {
            assert_eq!(sunglint_cone_contains_q14(Some(&cone), any), raw::cone_contains_q14(&cone, any.into()));
        }
        let BasisQ14 { t, b } = sunglint_basis_q14(l.into());
        assert_eq!([t, b].map(<[i16; 3]>::from), raw::basis_q14(l));
        let PointQ14 { z, turn } = sunglint_point_q14(index.wrapping_mul(0x0100_0001));
        assert!(raw::points_q14(index.wrapping_mul(0x0100_0001), 1).eq([[z, turn]]));
        let seen = sunglint_soft_shadow_q14(Some(&cone), n.into(), index, 9, Some(sees_q14), user);
        let means = raw::soft_shadow_q14(&cone, n, index, 9, |direction| direction[0] & 1 == 0);
        assert_eq!([seen.visible, seen.mean_cosine], means);
    }
}

#[test]
fn sampling_in_q30() {
    let (mut source, user) = (Source::new(6), ptr::without_provenance_mut(USER));
    for index in 0..CASES {
        let (l, n, light) = (source.lanes_q30(), source.lanes_q30(), raw::sphere_q30(source.ratio()).unwrap());
        let cone = raw::cone_q30(l, &light);
        assert_eq!(sunglint_cone_q30(l.into(), light.into()), cone);
        let point = [source.bits() as i32, source.bits() as i32];
        let direction = sunglint_cone_direction_q30(Some(&cone), PointQ30 { z: point[0], turn: point[1] });
        assert_eq!(<[i32; 3]>::from(direction), raw::cone_direction_q30(&cone, point));
        for any in [direction, n.into()] {
            assert_eq!(sunglint_cone_contains_q30(Some(&cone), any), raw::cone_contains_q30(&cone, any.into()));
        }
        let BasisQ30 { t, b } = sunglint_basis_q30(l.into());
        assert_eq!([t, b].map(<[i32; 3]>::from), raw::basis_q30(l));
        let PointQ30 { z, turn } = sunglint_point_q30(index.wrapping_mul(0x0100_0001));
        assert!(raw::points_q30(index.wrapping_mul(0x0100_0001), 1).eq([[z, turn]]));
        let seen = sunglint_soft_shadow_q30(Some(&cone), n.into(), index, 9, Some(sees_q30), user);
        let means = raw::soft_shadow_q30(&cone, n, index, 9, |direction| direction[0] & 1 == 0);
        assert_eq!([seen.visible, seen.mean_cosine], means);
    }
}

#[test]
fn quantities_of_light() {
    let mut source = Source::new(7);
    for _ in 0..CASES {
        let [a, b, c] = [0; 3].map(|_: u8| source.bits() as u32 >> (source.bits() & 31));
        let cos = source.bits() as i16;
        assert_eq!(sunglint_irradiance_q16(a, cos, b), raw::irradiance_q16(a, cos, b));
        assert_eq!(sunglint_diffuse_radiance_q16(cos, a), raw::diffuse_radiance_q16(cos, a));
        let made = sunglint_area_radiance_q16(a, b, c);
        match raw::area_radiance_q16(a, b, c) {
            Ok(radiance) => assert_eq!(made, RadianceQ16Made { status: Status::Ok, radiance }),
            Err(_) => assert_ne!(made.status, Status::Ok),
        }
        assert_eq!(sunglint_relative_to_peak_q16(a), raw::relative_to_peak_q16(a));
        assert_eq!(sunglint_relative_to_peak_frequency_q16(a), raw::relative_to_peak_frequency_q16(a));
        assert_eq!(<[i32; 3]>::from(sunglint_tint_q16(a, [a, b, c].into())), raw::tint_q16(a, [a, b, c]));
    }
}

#[test]
fn whole_pixels() {
    let mut source = Source::new(8);
    for _ in 0..CASES {
        let [direction, n, v] = [0; 3].map(|_: u8| source.lanes_q14());
        let light = raw::sphere_q14(source.ratio()).unwrap();
        let [albedo, f0] = [0; 2].map(|_: u8| [0; 3].map(|_: u8| (source.bits() >> 34) as i32));
        let alpha = (1 << 30) >> (source.bits() % 11);
        let illuminance = [0; 3].map(|_: u8| source.bits() as u32);
        let material = MaterialQ30 { albedo: albedo.into(), alpha, f0: f0.into() };
        let made = sunglint_pixel_q14(direction.into(), light.into(), material, illuminance.into());
        let surface = raw::surface_q14(albedo, alpha, f0).unwrap();
        let Ok(pixel) = raw::PixelQ14::new(direction, &light, &surface, illuminance) else {
            assert_eq!(made, PixelQ14Made { status: Status::Direction, pixel: raw::PixelQ14::BLACK });
            continue;
        };
        assert_eq!(made, PixelQ14Made { status: Status::Ok, pixel });
        let colour = sunglint_pixel_q14_shade(Some(&pixel), n.into(), v.into());
        assert_eq!(<[u32; 3]>::from(colour), pixel.shade(n, v));
        for (index, channel) in [Channel::Red, Channel::Green, Channel::Blue].into_iter().enumerate() {
            let level = sunglint_pixel_q14_shade_channel(Some(&pixel), n.into(), v.into(), index as u32);
            assert_eq!(level, pixel.shade_channel(n, v, channel));
        }
        assert_eq!(sunglint_pixel_q14_shade_channel(Some(&pixel), n.into(), v.into(), 3), 0);
    }
}

#[test]
fn null_gives_zeros() {
    let (up, wide_up) = (VectorQ14 { x: 0, y: 0, z: 16384 }, VectorQ30 { x: 0, y: 0, z: 1 << 30 });
    let zero = SoftShadow::default();
    assert_eq!(sunglint_cone_direction_q14(None, PointQ14::default()), VectorQ14::default());
    assert_eq!(sunglint_cone_direction_q30(None, PointQ30::default()), VectorQ30::default());
    assert!(!sunglint_cone_contains_q14(None, up) && !sunglint_cone_contains_q30(None, wide_up));
    let user = ptr::without_provenance_mut(USER);
    assert_eq!(sunglint_soft_shadow_q14(None, up, 0, 9, Some(sees_q14), user), zero);
    assert_eq!(sunglint_soft_shadow_q30(None, wide_up, 0, 9, Some(sees_q30), user), zero);
    let (cone, wide_cone) = (sunglint_cone_q14(up, SUN_Q14.into()), sunglint_cone_q30(wide_up, SUN_Q30.into()));
    assert_eq!(sunglint_soft_shadow_q14(Some(&cone), up, 0, 9, None, user), zero);
    assert_eq!(sunglint_soft_shadow_q30(Some(&wide_cone), wide_up, 0, 9, None, user), zero);
    assert_eq!(sunglint_soft_shadow_q14(Some(&cone), up, 0, 0, Some(sees_q14), user), zero);
    assert_ne!(sunglint_soft_shadow_q14(Some(&cone), up, 0, 9, Some(sees_q14), user), zero);
    assert_eq!(sunglint_pixel_q14_shade(None, up, up), ColourQ16::default());
    assert_eq!(sunglint_pixel_q14_shade_channel(None, up, up, 0), 0);
}

#[test]
fn zero_vectors_and_opposites() {
    let half = sunglint_sphere_q14(1 << 29).sphere;
    let (zero, r, back) = ([0; 3].into(), [0, 9830, 13107].into(), [0, -9830, -13107].into());
    assert_eq!(sunglint_cap_q14(zero, r, half), [0, 4915, 6554].into());
    assert_eq!([sunglint_cap_q14(r, zero, half), sunglint_normalize_q14(zero)], [zero; 2]);
    assert_eq!(sunglint_cap_q14(r, back, half), r);
    let (x, y) = ([1 << 14, 0, 0].into(), [0, 1 << 14, 0].into());
    assert_eq!(sunglint_factored_q14(x, y, sunglint_sphere_q14(1 << 30).sphere), zero);
    let half = sunglint_sphere_q30(1 << 29).sphere;
    let (zero, r, back) = ([0; 3].into(), [0, 644245094, 858993460].into(), [0, -644245094, -858993460].into());
    assert_eq!(sunglint_cap_q30(zero, r, half), [0, 322122547, 429496730].into());
    assert_eq!([sunglint_cap_q30(r, zero, half), sunglint_normalize_q30(zero)], [zero; 2]);
    assert_eq!(sunglint_cap_q30(r, back, half), r);
    let (x, y) = ([1 << 30, 0, 0].into(), [0, 1 << 30, 0].into());
    assert_eq!(sunglint_factored_q30(x, y, sunglint_sphere_q30(1 << 30).sphere), zero);
    let z_axis = BasisQ14 { t: [1 << 14, 0, 0].into(), b: [0, 1 << 14, 0].into() };
    assert_eq!([[0; 3], [0, 0, 1 << 14], [i16::MAX; 3]].map(|l| sunglint_basis_q14(l.into())), [z_axis; 3]);
    let z_axis = BasisQ30 { t: [1 << 30, 0, 0].into(), b: [0, 1 << 30, 0].into() };
    assert_eq!([[0; 3], [0, 0, 1 << 30], [i32::MAX; 3]].map(|l| sunglint_basis_q30(l.into())), [z_axis; 3]);
    assert_eq!(sunglint_reciprocal_root_q16(0), u32::MAX);
}

#[test]
fn quantities_at_the_ends() {
    assert_eq!(sunglint_lambert_q14(-1, u32::MAX, 1 << 28), 0);
    assert_eq!(sunglint_lambert_q14(1 << 14, u32::MAX, -1), 0);
    assert_eq!(sunglint_lambert_q14(1 << 14, 1 << 16, i32::MAX), sunglint_lambert_q14(1 << 14, 1 << 16, 1 << 28));
    assert_eq!(sunglint_lambert_q30(-1, u64::MAX, 1 << 60), 0);
    assert_eq!(sunglint_lambert_q30(1 << 30, u64::MAX, -1), 0);
    assert_eq!(sunglint_lambert_q30(1 << 30, 1 << 32, i64::MAX), sunglint_lambert_q30(1 << 30, 1 << 32, 1 << 60));
    let (sun, wide_sun) = (SUN_Q14.into(), SUN_Q30.into());
    assert_eq!([-1 << 28, 1 << 28].map(|cos| sunglint_relative_illuminance_q14(cos, sun)), [0, 1 << 28]);
    assert_eq!([-1 << 60, 1 << 60].map(|cos| sunglint_relative_illuminance_q30(cos, wide_sun)), [0, 1 << 60]);
    assert_eq!([sunglint_irradiance_q16(1, -1, 1), sunglint_irradiance_q16(1, 1, 0)], [0; 2]);
    assert_eq!(sunglint_irradiance_q16(u32::MAX, 1 << 14, 1), u32::MAX);
    assert_eq!(sunglint_diffuse_radiance_q16(-1, u32::MAX), 0);
    assert_eq!([sunglint_relative_to_peak_q16(0), sunglint_relative_to_peak_frequency_q16(0)], [0; 2]);
    assert_eq!(sunglint_relative_to_peak_q16(1 << 16), 1 << 30);
    let (green, dark) = (36_000, ColourQ30::default());
    assert_eq!(sunglint_tint_q16(0, [green; 3].into()), dark);
    assert_eq!(sunglint_tint_q16(1, [green, 0, green].into()), dark);
    assert_eq!(sunglint_tint_q16(378_274, [green; 3].into()), [1 << 30; 3].into());
}

/// As IEEE 754 has it, and no more than that.
#[test]
fn floats_at_the_ends() {
    let infinity = f32::INFINITY;
    assert_eq!([0.0, -0.0, infinity].map(|x| sunglint_soft_reciprocal_root(x)), [infinity, -infinity, 0.0]);
    assert!(sunglint_soft_reciprocal_root(-1.0).is_nan() && sunglint_soft_root(-1.0).is_nan());
    assert_eq!([0.0, -0.0].map(|zero| sunglint_soft_root(zero).to_bits()), [0.0_f32, -0.0].map(f32::to_bits));
    let (l, sun, zero) = (VectorF32::from([0.6, 0.0, 0.8]), SUN_Q30.into(), VectorF32::default());
    for bad in [f32::NAN, 2.0, -infinity].map(|lane| VectorF32 { x: lane, ..l }) {
        assert_eq!(sunglint_soft_cap(bad, l, sun), zero);
        assert_eq!(sunglint_soft_cap(l, bad, sun), l);
        assert_eq!([sunglint_soft_reflect(bad, l), sunglint_soft_reflect(l, bad)], [zero; 2]);
    }
    assert_eq!(sunglint_soft_cap(l, zero, sun), zero);
    assert_eq!(sunglint_soft_normalize(zero), zero);
    assert_eq!(sunglint_soft_normalize(VectorF32 { x: f32::NAN, ..l }), zero);
}

#[test]
fn ratios_out_of_range_give_points() {
    for ratio in [-1, i32::MIN, (1 << 30) + 1, i32::MAX] {
        let (made, wide) = (sunglint_sphere_q14(ratio), sunglint_sphere_q30(ratio));
        assert_eq!([made.status, wide.status], [Status::Ratio; 2]);
        assert_eq!([made.sphere, sunglint_sphere_q14(0).sphere], [raw::sphere_q14(0).unwrap().into(); 2]);
        assert_eq!([wide.sphere, sunglint_sphere_q30(0).sphere], [raw::sphere_q30(0).unwrap().into(); 2]);
    }
}

#[test]
fn radiances_have_a_status_for_each_argument() {
    let made = |status, radiance| RadianceQ16Made { status, radiance };
    assert_eq!(sunglint_area_radiance_q16(1, 0, 1), made(Status::Area, 0));
    assert_eq!(sunglint_area_radiance_q16(1, 1, 0), made(Status::SolidAngle, 0));
    assert_eq!(sunglint_area_radiance_q16(u32::MAX, 1, 1), made(Status::Overflow, u32::MAX));
}

#[test]
fn pixels_have_a_status_for_each_argument() {
    let (half, up) = (ColourQ30 { red: 1 << 29, green: 1 << 29, blue: 1 << 29 }, VectorQ14 { x: 0, y: 0, z: 16384 });
    let good = MaterialQ30 { albedo: half, alpha: 1 << 28, f0: half };
    let status = |direction, material| {
        let made = sunglint_pixel_q14(direction, SUN_Q14.into(), material, [1 << 16; 3].into());
        let colour = sunglint_pixel_q14_shade(Some(&made.pixel), up, up);
        assert_eq!(colour == ColourQ16::default(), made.status != Status::Ok);
        made.status
    };
    assert_eq!(status(up, good), Status::Ok);
    assert_eq!(status(VectorQ14::default(), good), Status::Direction);
    for bad in [-1, (1 << 30) + 1, i32::MIN] {
        let colours =
            [ColourQ30 { red: bad, ..half }, ColourQ30 { green: bad, ..half }, ColourQ30 { blue: bad, ..half }];
        for colour in colours {
            assert_eq!(status(up, MaterialQ30 { albedo: colour, ..good }), Status::Albedo);
            assert_eq!(status(up, MaterialQ30 { f0: colour, ..good }), Status::F0);
        }
    }
    for (alpha, expected) in [(0, Status::Ok), (1, Status::Alpha), (536_870, Status::Alpha), (536_871, Status::Ok)] {
        assert_eq!(status(up, MaterialQ30 { alpha, ..good }), expected, "{alpha}");
    }
}

/// What a C program may hold before a light is there.
#[test]
fn a_pixel_of_zeros_is_black() {
    let mut source = Source::new(9);
    for _ in 0..CASES {
        let (n, v) = (source.lanes_q14(), source.lanes_q14());
        assert_eq!(raw::PixelQ14::BLACK.shade(n, v), [0; 3]);
    }
}

/// As C makes one by `= {0}`.
#[test]
fn a_cone_of_zeros_has_directions_of_zero() {
    // SAFETY: a cone is numbers of whole bits and one bool, for all of which zero is a value.
    let (cone, wide): (ConeQ14, ConeQ30) = unsafe { std::mem::zeroed() };
    let mut source = Source::new(10);
    for _ in 0..CASES {
        let point = PointQ14 { z: source.bits() as i16, turn: source.bits() as i16 };
        assert_eq!(sunglint_cone_direction_q14(Some(&cone), point), VectorQ14::default());
        assert!(sunglint_cone_contains_q14(Some(&cone), raw::normalize_q14(source.lanes_q14()).into()));
        let point = PointQ30 { z: source.bits() as i32, turn: source.bits() as i32 };
        assert_eq!(sunglint_cone_direction_q30(Some(&wide), point), VectorQ30::default());
    }
}

/// C compilers hold the header to the same in `tests/embedding`.
#[test]
fn layouts_are_those_of_c() {
    assert_eq!([size_of::<VectorQ14>(), size_of::<VectorQ30>(), size_of::<VectorF32>()], [6, 12, 12]);
    assert_eq!([size_of::<SphereQ14>(), size_of::<SphereQ30>()], [16, 32]);
    assert_eq!([align_of::<SphereQ14>(), align_of::<SphereQ30>()], [align_of::<i32>(), align_of::<i64>()]);
    assert_eq!([size_of::<SphereQ14Made>(), offset_of!(SphereQ14Made, sphere)], [20, 4]);
    assert_eq!([size_of::<SphereQ30Made>(), offset_of!(SphereQ30Made, sphere)], [40, 8]);
    assert_eq!([size_of::<PixelQ14Made>(), offset_of!(PixelQ14Made, pixel)], [168, 4]);
    assert_eq!([size_of::<MaterialQ30>(), offset_of!(MaterialQ30, alpha), offset_of!(MaterialQ30, f0)], [28, 12, 16]);
    assert_eq!([size_of::<ConeQ14>(), size_of::<ConeQ30>(), size_of::<PixelQ14>()], [76, 96, 164]);
    assert_eq!([size_of::<Status>(), size_of::<RadianceQ16Made>(), size_of::<SoftShadow>()], [4, 8, 8]);
}
