//! 16.16 fixed point whose products drop eight bits of each factor.

use sunglint::fixed::types::{I2F14, I16F16};
use sunglint::oracle::{self, angle_between};
use sunglint::sampling::Cone;
use sunglint::trial::chip::{self, Core};
use sunglint::trial::input;
use sunglint::{DistantSphere, Real, SUN, Scalar, normalize, reflect};

use super::row::{CURE, FAILS, PresetRow, TRUTH, figure, worst};
use super::{Effort, Preset};

/// What is reported, and how it is run.
pub const PRESET: Preset = Preset {
    name: "console-16.16",
    source: "FixedMul of id-Software/wolf3d (WOLFSRC/WOLFHACK.C, 1992) and SkFixedMul_lowprec of Skia \
             (src/core/SkScan_DAAPath.cpp, 2016); asked for on the djgpp list in July 1997, since a 16.16 product \
             overflows 32 bits",
    question: "Where is the Sun, and where does its disc end, in 16.16 without wide products?",
    chart: None,
    measure,
    verdict,
};

const DOT: &str = "n.v off by at most, steps of 2^-16";
const NORMALIZE: &str = "normalised direction off by at most, per cent of the Sun's radius";
const REFLECT: &str = "mirror ray off by at most, per cent of the Sun's radius";
const EDGE: &str = "edge of the Sun's disc off by at most, per cent of its radius";

const NARROW: &str = "(a >> 8) * (b >> 8), Q16";
const BY_CHORD: &str = "|l - r|^2 by (a >> 8) * (b >> 8), Q16";
const BY_COSINE: &str = "l.r by (a >> 8) * (b >> 8), Q16";
const WIDE: &str = "wide sums, I16F16";
const SHORT: &str = "wide sums, I2F14";

type Vector = [f64; 3];

/// A product of Q16 numbers without the bits that a 32-bit register has no room for.
fn product(a: i32, b: i32) -> i32 {
    (a >> 8).wrapping_mul(b >> 8)
}

fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    (0..3).map(|i| product(a[i], b[i])).sum()
}

fn q16(vector: Vector) -> [i32; 3] {
    vector.map(|lane| (lane * 65536.0).round() as i32)
}

fn exact(vector: [i32; 3]) -> Vector {
    vector.map(|lane| f64::from(lane) / 65536.0)
}

fn exact_dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// At unit length, by a reciprocal root without an error of its own.
fn narrow_normalize(vector: [i32; 3]) -> [i32; 3] {
    let length = (f64::from(dot(vector, vector)) / 65536.0).sqrt();
    let inverse = (65536.0 / length).round() as i32;
    vector.map(|lane| product(lane, inverse))
}

fn narrow_reflect(n: [i32; 3], v: [i32; 3]) -> [i32; 3] {
    let twice = 2 * dot(n, v);
    [0, 1, 2].map(|i| product(twice, n[i]) - v[i])
}

/// The mirror ray of `v` as it should be.
fn mirrored(n: Vector, v: Vector) -> Vector {
    let share = 2.0 * exact_dot(n, v) / exact_dot(n, n);
    [0, 1, 2].map(|i| share * n[i] - v[i])
}

fn in_radii(angle: f64) -> f64 {
    100.0 * angle / SUN.angular_radius()
}

/// Normals, and viewers above the surface.
fn pairs(count: usize) -> impl Iterator<Item = [Vector; 2]> {
    let all = input::random(1, 2 * count, 1.0).zip(input::random(2, 2 * count, 1.0));
    all.map(|(n, v)| [n.l, v.l]).filter(|&[n, v]| exact_dot(n, v) > 0.1).take(count)
}

fn narrow_directions(count: usize) -> [f64; 3] {
    let vectors: Vec<_> = pairs(count).map(|pair| pair.map(q16)).collect();
    let dots = |&[n, v]: &[[i32; 3]; 2]| (f64::from(dot(n, v)) - exact_dot(exact(n), exact(v)) * 65536.0).abs();
    let normals = |&[n, _]: &[[i32; 3]; 2]| in_radii(angle_between(exact(n), exact(narrow_normalize(n))));
    let rays =
        |&[n, v]: &[[i32; 3]; 2]| in_radii(angle_between(mirrored(exact(n), exact(v)), exact(narrow_reflect(n, v))));
    [worst(vectors.iter().map(dots)), worst(vectors.iter().map(normals)), worst(vectors.iter().map(rays))]
}

/// The same by this crate.
fn directions<T: Real>(count: usize) -> [f64; 3] {
    let vectors: Vec<_> = pairs(count).map(|pair| pair.map(|vector| vector.map(T::from_f64))).collect();
    let back = |vector: [T; 3]| vector.map(T::to_f64);
    let dots = |&[n, v]: &[[T; 3]; 2]| (T::scalar(T::dot(n, v)).exact() - exact_dot(back(n), back(v))).abs() * 65536.0;
    let normals = |&[n, _]: &[[T; 3]; 2]| in_radii(angle_between(back(n), back(normalize(n))));
    let rays = |&[n, v]: &[[T; 3]; 2]| in_radii(angle_between(mirrored(back(n), back(v)), back(reflect(n, v))));
    [worst(vectors.iter().map(dots)), worst(vectors.iter().map(normals)), worst(vectors.iter().map(rays))]
}

/// Centres of the Sun, and directions up to three radii off them, half of these within a hundredth of the rim.
fn beside_the_sun(count: usize) -> impl Iterator<Item = [Vector; 2]> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    input::random(3, count, 1.0).enumerate().map(move |(index, pair)| {
        let share = (index as f64 + 0.5) / count as f64;
        let radii = if index % 2 == 0 { 3.0 * share } else { 0.99 + 0.02 * share };
        [pair.l, oracle::cone::at(pair.l, radii * SUN.angular_radius(), (index as f64 * GOLDEN).fract())]
    })
}

/// How far from the rim a direction lies that `inside` has on the wrong side of it.
fn edge<T: Copy>(
    count: usize,
    round: impl Fn(Vector) -> [T; 3],
    back: impl Fn([T; 3]) -> Vector,
    inside: impl Fn([T; 3], [T; 3]) -> bool,
) -> f64 {
    let off = |[l, r]: [Vector; 2]| {
        let [l, r] = [round(l), round(r)];
        let beyond = angle_between(back(l), back(r)) - SUN.angular_radius();
        if inside(l, r) == (beyond <= 0.0) { 0.0 } else { in_radii(beyond.abs()) }
    };
    worst(beside_the_sun(count).map(off))
}

fn edge_of<T: Real>(count: usize) -> f64 {
    let sun = DistantSphere::<T>::of(&SUN);
    let inside = |l: [T; 3], r: [T; 3]| Cone::new(l, &sun).contains(r);
    edge(count, |vector| vector.map(T::from_f64), |vector| vector.map(T::to_f64), inside)
}

fn narrow_edges(count: usize) -> [f64; 2] {
    let [chord, cosine] = [2.0 * SUN.versine(), SUN.cos()].map(|limit| (limit * 65536.0).round() as i32);
    let apart = |l: [i32; 3], r: [i32; 3]| [0, 1, 2].map(|i| l[i] - r[i]);
    let by_chord = edge(count, q16, exact, |l, r| dot(apart(l, r), apart(l, r)) <= chord);
    [by_chord, edge(count, q16, exact, |l, r| dot(l, r) >= cosine)]
}

/// Instructions on a core without wide products, as counted.
fn instructions(format: &'static str, form: &str) -> Vec<PresetRow> {
    let counted = |function: &&str| {
        let row = chip::rows().find(|row| {
            row.function == *function && row.format == format && row.by == "sunglint" && row.case != "inside"
        });
        let median = row?.on(Core::M0)?.median;
        let measure = format!("instructions of {function} on a Cortex-M0+");
        Some(PresetRow::new(CURE, form, &measure, f64::from(median)))
    };
    ["dot", "normalize", "reflect"].iter().filter_map(counted).collect()
}

fn measure(effort: Effort) -> Vec<PresetRow> {
    let count = effort.count(4000, 100_000);
    let [dots, normals, rays] = narrow_directions(count);
    let [chord, cosine] = narrow_edges(count);
    let mut rows = vec![
        PresetRow::new(TRUTH, "f64", "the Sun's radius, steps of 2^-16", SUN.sin() * 65536.0),
        PresetRow::new(FAILS, NARROW, DOT, dots).at_most(1.0),
        PresetRow::new(FAILS, NARROW, NORMALIZE, normals).at_most(5.0),
        PresetRow::new(FAILS, NARROW, REFLECT, rays).at_most(5.0),
        PresetRow::new(FAILS, BY_CHORD, EDGE, chord).at_most(5.0),
        PresetRow::new(FAILS, BY_COSINE, EDGE, cosine).at_most(5.0),
    ];
    let short = (SHORT, directions::<I2F14>(count), edge_of::<I2F14>(count), "I2F14");
    let wide = (WIDE, directions::<I16F16>(count), edge_of::<I16F16>(count), "I16F16");
    for (form, [dots, normals, rays], edge, format) in [wide, short] {
        rows.extend([
            PresetRow::new(CURE, form, DOT, dots).at_most(1.0),
            PresetRow::new(CURE, form, NORMALIZE, normals).at_most(5.0),
            PresetRow::new(CURE, form, REFLECT, rays).at_most(5.0),
            PresetRow::new(CURE, form, EDGE, edge).at_most(5.0),
        ]);
        rows.extend(instructions(format, form));
    }
    rows
}

fn verdict(rows: &[PresetRow]) -> String {
    let of = |form, measure| figure(rows, form, measure);
    format!(
        "Narrow products turn a mirror ray by up to {} % of the Sun's radius and move the disc's edge by {} %; sums \
         that stay wide, in I2F14, {} % and {} %, for {} instructions a mirror ray on a Cortex-M0+, which has no \
         wide products either.",
        of(NARROW, REFLECT),
        of(BY_CHORD, EDGE),
        of(SHORT, REFLECT),
        of(SHORT, EDGE),
        of(SHORT, "instructions of reflect on a Cortex-M0+")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_has_eight_bits_of_each_factor_less() {
        assert_eq!([product(65536, 65536), product(-32768, 98304), product(255, 65536)], [65536, -49152, 0]);
        // Rounded down: a step below zero counts for 256.
        assert_eq!([product(-1, 65536), product(-1, -1)], [-256, 1]);
    }

    #[test]
    fn instructions_are_those_of_the_table() {
        let rows = instructions("I2F14", SHORT);
        let median = chip::rows().find(|row| (row.function, row.format) == ("reflect", "I2F14"));
        let median = median.and_then(|row| row.on(Core::M0)).map_or(0, |cost| cost.median);
        assert_eq!((rows.len(), rows[2].value), (3, f64::from(median)));
    }
}
