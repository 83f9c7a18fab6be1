//! Every call has an answer: no input panics, and `cap`, `factored`, `disc`, `normalize` and `reflect` of finite
//! inputs are as documented.

use fixed::types::{I2F14, I2F30, I16F16};
use half::f16;
use oorandom::Rand64;
use sunglint::trial::{Constants, Format, Method, input};
use sunglint::{DistantLight, DistantSphere, Real, cap, disc, factored, normalize, reflect};

const ROUNDS: usize = 20_000;

fn lights() -> Vec<DistantLight> {
    let ratios = [0.0, 1e-6, 1e-4, 0.00465, 0.5, 0.7, 0.714, 0.9, 1.0];
    let angles = [1e-9, 180.0, 270.0, 359.99, 360.0];
    let by_ratio = ratios.into_iter().map(|ratio| DistantLight::from_ratio(ratio).unwrap());
    by_ratio.chain(angles.into_iter().map(|angle| DistantLight::from_angle(angle).unwrap())).collect()
}

/// Calls everything on vectors of `lane`, and gives `cap`'s and `normalize`'s answers to `check`.
fn call_all<T: Real>(mut lane: impl FnMut() -> T, check: impl Fn([T; 3])) {
    let lights: Vec<_> = lights().iter().map(Constants::<T>::of).collect();
    for index in 0..ROUNDS {
        let (l, r) = ([lane(), lane(), lane()], [lane(), lane(), lane()]);
        let light = &lights[index % lights.len()];
        for method in Method::ALL {
            std::hint::black_box(method.direction(l, r, light));
        }
        std::hint::black_box(reflect(l, r));
        check(cap(l, r, &light.sphere));
        check(normalize(l));
    }
}

fn finite<T: Real>(answer: [T; 3]) {
    assert!(answer.into_iter().all(|lane| lane.to_f64().is_finite()), "{answer:?}");
}

/// Random bits, and one time in four an end of the range or another special one.
fn bits(source: &mut Rand64, special: &[u64]) -> u64 {
    let random = source.rand_u64();
    if random & 3 == 0 { special[(random >> 8) as usize % special.len()] } else { random }
}

#[test]
fn any_bits_in_fixed_point() {
    let mut source = Rand64::new(1);
    let mut next =
        || bits(&mut source, &[0, 1, u64::MAX, 1 << 14, 1 << 15, 1 << 30, 1 << 31, (1 << 31) - 1, (1 << 15) - 1]);
    call_all(|| I2F14::from_bits(next() as i16), finite);
    call_all(|| I2F30::from_bits(next() as i32), finite);
    call_all(|| I16F16::from_bits(next() as i32), finite);
}

#[test]
fn any_bits_in_floats() {
    let mut source = Rand64::new(2);
    let special = [0.0_f64, -0.0, 1.0, f64::NAN, f64::INFINITY, -f64::INFINITY, f64::MAX, f64::MIN_POSITIVE, 5e-324];
    let mut next = || bits(&mut source, &special.map(f64::to_bits));
    call_all(|| f64::from_bits(next()), finite);
    let special = [0.0_f32, -0.0, 1.0, f32::NAN, -f32::NAN, f32::INFINITY, f32::MAX, f32::MIN_POSITIVE, 1e-45];
    let mut next = || bits(&mut source, &special.map(|value| value.to_bits().into()));
    call_all(|| f32::from_bits(next() as u32), finite);
    call_all(|| micromath::F32(f32::from_bits(next() as u32)), finite);
    let special = [0, 0x8000, 0x3c00, 0x7e00, 0xfe00, 0x7c00, 0xfc00, 0x7bff, 0x0400, 1];
    let mut next = || bits(&mut source, &special);
    call_all(|| f16::from_bits(next() as u16), finite);
}

/// Vectors of length 1.16: the lanes of fixed point against f64's, in steps of the format.
fn long_vectors<T: Real>(step: f64) -> f64 {
    let mut worst = 0.0_f64;
    for ratio in [0.00465, 0.5] {
        let light = DistantLight::from_ratio(ratio).unwrap();
        let (sphere, exact) = (DistantSphere::<T>::of(&light), DistantSphere::<f64>::of(&light));
        for pair in input::random(8, ROUNDS, light.angular_radius()) {
            let [l, r] = [pair.l, pair.r].map(|v| v.map(|lane| T::from_f64(1.16 * lane)));
            let [a, b] = [l, r].map(|v| v.map(T::to_f64));
            for (answer, truth) in [(reflect(l, r), reflect(a, b)), (factored(l, r, &sphere), factored(a, b, &exact))] {
                let errors = [0, 1, 2].map(|i| (answer[i].to_f64() - truth[i]).abs() / step);
                worst = errors.into_iter().fold(worst, f64::max);
            }
        }
    }
    worst
}

#[test]
fn vectors_a_sixth_too_long_do_not_overflow() {
    for (name, worst) in [
        ("I2F14", long_vectors::<I2F14>(Format::I2F14.step())),
        ("I2F30", long_vectors::<I2F30>(Format::I2F30.step())),
        ("I16F16", long_vectors::<I16F16>(Format::I16F16.step())),
    ] {
        println!("{name}: {worst} steps");
        assert!((1.7 / 4.0..=1.7).contains(&worst), "{name}: {worst}");
    }
}

/// Moderate lengths in floats are finite in every method but `epic`.
#[test]
fn moderate_lengths_are_finite_in_floats() {
    fn check<T: Real>(seed: u128) {
        let mut source = Rand64::new(seed);
        let lights: Vec<_> = lights().iter().map(DistantSphere::<T>::of).collect();
        for index in 0..ROUNDS {
            let mut lane = || T::from_f64(2.3 * source.rand_float() - 1.15);
            let (l, r) = ([lane(), lane(), lane()], [lane(), lane(), lane()]);
            let light = &lights[index % lights.len()];
            for answer in [cap(l, r, light), factored(l, r, light), disc(l, r, light), reflect(l, r), normalize(l)] {
                finite(answer);
            }
        }
    }
    check::<f64>(3);
    check::<f32>(4);
    check::<micromath::F32>(5);
    check::<f16>(6);
}

#[test]
fn what_is_not_finite_has_the_documented_answer() {
    let sun = DistantSphere::<f32>::new(&sunglint::SUN);
    let good = [0.0, 0.6, 0.8];
    for bad in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for lane in 0..3 {
            let mut broken = good;
            broken[lane] = bad;
            assert_eq!(cap(good, broken, &sun), good);
            assert_eq!(cap(broken, good, &sun), [0.0; 3]);
            // As long as a light may be, and longer.
            let [long, longer] = [2.0, 2.0_f32.next_up()].map(|z| [0.0, 0.0, z]);
            assert_eq!([cap(long, broken, &sun), cap(longer, broken, &sun)], [long, [0.0; 3]]);
            assert_eq!(normalize(broken), [0.0; 3]);
        }
    }
}

#[test]
fn zero_vectors_have_the_documented_answer() {
    fn check<T: Real>() {
        let zero = [T::ZERO; 3];
        let good = [0.0, 0.6, 0.8].map(T::from_f64);
        let sun = DistantSphere::<T>::of(&sunglint::SUN);
        assert_eq!(normalize(zero), zero);
        assert_eq!(cap(good, zero, &sun), zero);
        assert_eq!(cap(zero, zero, &sun), zero);
        // Along r, as long as the ratio; half a step of I2F14 is 3e-5.
        let along = cap(zero, good, &sun).map(T::to_f64);
        assert!(along[0] == 0.0 && (along[2] - 0.8 * sunglint::SUN.sin()).abs() < 3.1e-5, "{along:?}");
    }
    check::<f64>();
    check::<f32>();
    check::<micromath::F32>();
    check::<f16>();
    check::<I2F14>();
    check::<I2F30>();
    check::<I16F16>();
}
