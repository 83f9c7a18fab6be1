//! A million pixels in a plain loop over slices: what a caller has who shades a picture.

use std::hint::black_box;
use std::time::Instant;

use fixed::types::{I2F14, I2F30};
use sunglint::trial::input;
use sunglint::{DistantSphere, Real, SUN, cap, normalize};

/// Pixels across a ball that covers a million of them.
const SIDE: u32 = 1130;

/// A loop, and the same with a call for each pixel.
pub struct Row {
    /// What is computed.
    pub function: &'static str,
    /// The format, and whether the loop is by hand for vectors.
    pub format: &'static str,
    /// Nanoseconds a pixel of the loop over those of f32 in the same round: half of the rounds took no more.
    pub over_f32: f64,
    /// Time of the loop over the time of the calls.
    pub over_calls: f64,
}

/// `out` of `v`, in a loop that the compiler may make vectors of.
#[inline(never)]
pub fn normalize_loop<T: Real>(v: &[[T; 3]], out: &mut [[T; 3]]) {
    for (v, out) in v.iter().zip(out) {
        *out = normalize(*v);
    }
}

/// The nearest directions of the disc, likewise.
#[inline(never)]
pub fn cap_loop<T: Real>(l: [T; 3], sun: &DistantSphere<T>, r: &[[T; 3]], out: &mut [[T; 3]]) {
    for (r, out) in r.iter().zip(out) {
        *out = cap(l, *r, sun);
    }
}

#[inline(never)]
fn normalize_call<T: Real>(v: &[T; 3]) -> [T; 3] {
    normalize(*v)
}

#[inline(never)]
fn cap_call<T: Real>(l: [T; 3], sun: &DistantSphere<T>, r: &[T; 3]) -> [T; 3] {
    cap(l, *r, sun)
}

/// I2F14 at unit length for vectors of the machine: no branch, no table, no product of more than 32 bits; f32 finds the
/// root, whose 24 digits are more than the 15 of the answer. By lanes, since three in a row are no vector.
#[inline(never)]
pub fn normalize_lanes([x, y, z]: [&[i16]; 3], [a, b, c]: [&mut [i16]; 3]) {
    for ((((&x, &y), &z), a), (b, c)) in x.iter().zip(y).zip(z).zip(a).zip(b.iter_mut().zip(c)) {
        let [x, y, z] = [x, y, z].map(i32::from);
        // A sum that may be 3 * 2^30, of which only the size of the root counts.
        let square = (x * x) as f32 + (y * y) as f32 + (z * z) as f32;
        let scale = 16384.0 / square.max(1.0).sqrt();
        // 1.5 * 2^23 leaves no room for digits below 1. Older machines have no instruction that rounds.
        let unit = |lane: i32| (((lane as f32 * scale + 12_582_912.0) - 12_582_912.0) as i32) as i16;
        (*a, *b, *c) = (unit(x), unit(y), unit(z));
    }
}

fn rays<T: Real>() -> Vec<[T; 3]> {
    input::ball(SIDE).map(|pair| pair.r.map(T::from_f64)).collect()
}

/// Nanoseconds a pixel of: the loop that normalises, its calls, the loop of `cap`, its calls.
struct Turn<T: Real> {
    r: Vec<[T; 3]>,
    l: [T; 3],
    sun: DistantSphere<T>,
    out: Vec<[T; 3]>,
}

impl<T: Real> Turn<T> {
    fn new() -> Self {
        let r = rays::<T>();
        let l = [1.0, 2.0, 3.0].map(|lane: f64| T::from_f64(lane / 14_f64.sqrt()));
        Self { out: r.clone(), r, l, sun: DistantSphere::of(&SUN) }
    }

    fn nanoseconds(&mut self) -> [f64; 4] {
        let Self { r, l, sun, out } = self;
        [
            time(r.len(), || normalize_loop(r, black_box(&mut *out))),
            time(r.len(), || r.iter().zip(black_box(&mut *out)).for_each(|(r, out)| *out = normalize_call(r))),
            time(r.len(), || cap_loop(*l, sun, r, black_box(&mut *out))),
            time(r.len(), || r.iter().zip(black_box(&mut *out)).for_each(|(r, out)| *out = cap_call(*l, sun, r))),
        ]
    }
}

fn time(pixels: usize, mut run: impl FnMut()) -> f64 {
    // So that none pays for bringing the slices into the cache.
    run();
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() * 1e9 / pixels as f64
}

/// How many nanoseconds a pixel takes by `normalize_lanes`.
struct Lanes {
    lanes: [Vec<i16>; 3],
    out: [Vec<i16>; 3],
}

impl Lanes {
    fn new() -> Self {
        let r = rays::<I2F14>();
        let lanes = [0, 1, 2].map(|i| r.iter().map(|r| r[i].to_bits()).collect::<Vec<_>>());
        Self { out: lanes.clone(), lanes }
    }

    fn nanoseconds(&mut self) -> f64 {
        let [x, y, z] = &self.lanes;
        let [a, b, c] = &mut self.out;
        time(x.len(), || normalize_lanes([x, y, z], black_box([&mut *a, &mut *b, &mut *c])))
    }
}

/// All loops, timed in turn for some rounds.
pub fn rows(rounds: usize) -> Vec<Row> {
    let (mut f, mut narrow, mut long, mut lanes) =
        (Turn::<f32>::new(), Turn::<I2F14>::new(), Turn::<I2F30>::new(), Lanes::new());
    let mut ratios = vec![[Vec::new(), Vec::new()]; 7];
    for _ in 0..rounds {
        let base = f.nanoseconds();
        for (turn, all) in [base, narrow.nanoseconds(), long.nanoseconds()].into_iter().enumerate() {
            for function in 0..2 {
                let [looped, called] = [all[2 * function], all[2 * function + 1]];
                ratios[2 * turn + function][0].push(looped / base[2 * function]);
                ratios[2 * turn + function][1].push(looped / called);
            }
        }
        let by_lanes = lanes.nanoseconds();
        ratios[6][0].push(by_lanes / base[0]);
        ratios[6][1].push(by_lanes / narrow.nanoseconds()[1]);
    }
    const NAMES: [[&str; 2]; 7] = [
        ["normalize", "f32"],
        ["cap", "f32"],
        ["normalize", "I2F14"],
        ["cap", "I2F14"],
        ["normalize", "I2F30"],
        ["cap", "I2F30"],
        ["normalize", "I2F14 by lanes"],
    ];
    let median = |mut ratios: Vec<f64>| {
        ratios.sort_by(f64::total_cmp);
        ratios[ratios.len() / 2]
    };
    let row = |([function, format], [f32s, calls]): ([&'static str; 2], [Vec<f64>; 2])| Row {
        function,
        format,
        over_f32: median(f32s),
        over_calls: median(calls),
    };
    NAMES.into_iter().zip(ratios).map(row).collect()
}
