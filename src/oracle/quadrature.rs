//! Integrals over the disc and over the viewers of a highlight, by Gauss and Legendre's rule.

use core::f64::consts::{FRAC_PI_2, PI};

use super::highlight::{Glossy, Pixel, about, frame, mirror};
use super::{Vector, angle_between, angular_radius, cross, dot, length};

/// Gauss and Legendre's rule of `N` nodes: exact for polynomials up to the degree `2 N - 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadrature<const N: usize> {
    /// Places and weights on -1 to 1.
    nodes: [[f64; 2]; N],
}

impl<const N: usize> Default for Quadrature<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> Quadrature<N> {
    /// The rule's nodes, by Newton's method on the Legendre polynomial.
    pub fn new() -> Self {
        let nodes = core::array::from_fn(|index| {
            let mut place = libm::cos(PI * (index as f64 + 0.75) / (N as f64 + 0.5));
            for _ in 0..8 {
                let [value, slope] = legendre(N, place);
                place -= value / slope;
            }
            let [_, slope] = legendre(N, place);
            [place, 2.0 / ((1.0 - place * place) * slope * slope)]
        });
        Self { nodes }
    }

    /// Places and weights from `from` to `to`.
    pub fn nodes(&self, from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> + '_ {
        let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
        self.nodes.iter().map(move |[place, weight]| [middle + half * place, half * weight])
    }

    /// The integral of `f` from `from` to `to`.
    pub fn integral(&self, from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
        self.nodes(from, to).map(|[place, weight]| weight * f(place)).sum()
    }
}

/// The Legendre polynomial of degree `n` at `x`, and its derivative.
fn legendre(n: usize, x: f64) -> [f64; 2] {
    let (mut before, mut value) = (1.0, x);
    for degree in 2..=n {
        let degree = degree as f64;
        (before, value) = (value, ((2.0 * degree - 1.0) * x * value - (degree - 1.0) * before) / degree);
    }
    [value, n as f64 * (x * value - before) / (x * x - 1.0)]
}

/// What a method makes of a whole highlight, against the truth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lobe {
    /// All light that the true highlight sends out, over the light that comes in on a facing plane.
    pub truth: f64,
    /// All light that the method sends out over that.
    pub energy: f64,
    /// The method's brightest value over the true one.
    pub peak: f64,
    /// The integral of the difference's size over that of the truth.
    pub relative_l1: f64,
}

impl<const N: usize> Quadrature<N> {
    /// The true highlight: `D V F (n.l)` averaged over the disc's projected area, `integral of brdf dw / (pi x^2)`.
    ///
    /// In polar coordinates about the mirror ray, where GGX is steepest; the radius goes as the tangent of an angle, so
    /// that the integrand is as smooth as a sine however narrow the lobe is. A disc that the horizon cuts is cut ray by
    /// ray.
    pub fn highlight(&self, glossy: &Glossy, pixel: &Pixel) -> f64 {
        let pixel = pixel.unit();
        let n_dot_v = dot(pixel.n, pixel.v);
        let (x, theta) = (glossy.ratio, angular_radius(glossy.ratio));
        let r = mirror(&pixel);
        let away = angle_between(r, pixel.l);
        if n_dot_v <= 0.0 {
            return 0.0;
        }
        if glossy.alpha == 0.0 {
            return glossy.mirrored(&pixel);
        }
        let rays = Rays::new(glossy, pixel, r, away);
        let inside = away < theta;
        let reach = if inside { PI } else { libm::asin((x / libm::sin(away)).min(1.0)) };
        // Beside the rim the segments change quickly at right angles; at a corner of disc and horizon they have a kink.
        let [first, second] = rays.corners();
        let quarter = if inside { FRAC_PI_2 } else { 0.0 };
        let mut turns = [-reach, -quarter, 0.0, first, second, quarter, reach].map(|turn| turn.clamp(-reach, reach));
        turns.sort_unstable_by(f64::total_cmp);
        let total: f64 = (1..turns.len()).map(|index| rays.sector(self, turns[index - 1], turns[index])).sum();
        total / (PI * x * x)
    }

    /// Compares `methods` with the truth over all viewers of a surface lit from `incidence` radians off its normal.
    pub fn lobes<const M: usize>(
        &self,
        glossy: &Glossy,
        incidence: f64,
        methods: impl Fn(&Pixel) -> [f64; M],
    ) -> [Lobe; M] {
        let (n, l) = ([0.0, 0.0, 1.0], [libm::sin(incidence), 0.0, libm::cos(incidence)]);
        let up = [libm::cos(incidence), 0.0, -libm::sin(incidence)];
        let (mut lobes, mut truth, mut brightest) = ([Lobe::default(); M], 0.0, 0.0_f64);
        let quarters = self.nodes(0.0, FRAC_PI_2).chain(self.nodes(FRAC_PI_2, PI));
        for [stretched, arc] in quarters {
            // The highlight is longer in the plane of incidence.
            let [azimuth, share] = narrowed(stretched, libm::cos(incidence));
            let arc = arc * share;
            // Where the viewer, mirrored, sets.
            let horizon = libm::atan2(libm::cos(incidence), libm::cos(azimuth) * libm::sin(incidence));
            for [polar, ring] in self.rings(glossy, horizon) {
                let r = about(l, [up, [0.0, 1.0, 0.0]], polar, azimuth);
                let v = [-r[0], -r[1], r[2]];
                let pixel = Pixel { n, v, l };
                // Both halves of the sky to either side of the plane of incidence.
                let weight = 2.0 * arc * ring * libm::sin(polar) * r[2];
                let exact = self.highlight(glossy, &pixel);
                truth += weight * exact;
                brightest = brightest.max(exact);
                for (lobe, value) in lobes.iter_mut().zip(methods(&pixel)) {
                    lobe.energy += weight * value;
                    lobe.peak = lobe.peak.max(value);
                    lobe.relative_l1 += weight * (value - exact).abs();
                }
            }
        }
        lobes.map(|lobe| Lobe {
            truth,
            energy: lobe.energy / truth,
            peak: lobe.peak / brightest,
            relative_l1: lobe.relative_l1 / truth,
        })
    }

    /// Nodes in the angle from the disc's centre, crowded about its rim as the highlight's width asks, up to `horizon`.
    fn rings(&self, glossy: &Glossy, horizon: f64) -> impl Iterator<Item = [f64; 2]> + '_ {
        let theta = angular_radius(glossy.ratio);
        let mut edges = [PI; EDGES];
        (edges[0], edges[1], edges[2]) = (0.0, theta / 2.0, theta);
        for step in 0..(EDGES - 3) / 2 {
            let aside = glossy.alpha / 2.0 * libm::pow(3.0, step as f64);
            edges[3 + 2 * step] = (theta - aside).max(0.0);
            edges[4 + 2 * step] = if glossy.alpha > 0.0 { theta + aside } else { PI };
        }
        edges.sort_unstable_by(f64::total_cmp);
        (1..EDGES).flat_map(move |index| {
            let [from, to] = [edges[index - 1], edges[index]].map(|edge| edge.min(horizon));
            // Nothing at all lies between most edges that were cut.
            (to - from > 1e-12).then(|| self.nodes(from, to)).into_iter().flatten()
        })
    }
}

/// Edges between which the angle from the disc's centre is integrated.
const EDGES: usize = 27;

/// Rays from the mirror direction over the disc.
struct Rays<'a> {
    glossy: &'a Glossy,
    pixel: Pixel,
    /// The mirror ray, and its angle from the disc's centre.
    r: Vector,
    away: f64,
    /// Towards the centre, and across.
    frame: [Vector; 2],
    /// The direction in the plane of incidence.
    incidence: Vector,
}

impl<'a> Rays<'a> {
    fn new(glossy: &'a Glossy, pixel: Pixel, r: Vector, away: f64) -> Self {
        Self { glossy, pixel, r, away, frame: frame(r, pixel.l), incidence: frame(r, pixel.n)[0] }
    }

    /// Turns at which the horizon cuts the disc's rim; 0 where it does not.
    fn corners(&self) -> [f64; 2] {
        let Pixel { n, l, .. } = self.pixel;
        let across = cross(n, l);
        let level = length(across);
        // A corner is level and `cos` of the disc from its centre.
        let along = libm::sqrt((1.0 - self.glossy.ratio) * (1.0 + self.glossy.ratio)) / level;
        let aside = libm::sqrt((1.0 - along) * (1.0 + along));
        let forward = cross(across, n);
        [aside, -aside].map(|aside| {
            let corner = [0, 1, 2].map(|i| (along * forward[i] + aside * across[i]) / level);
            let turn = libm::atan2(dot(corner, self.frame[1]), dot(corner, self.frame[0]));
            if turn.is_finite() { turn } else { 0.0 }
        })
    }

    /// The integral between two turns; as the ends may be tangents to the rim, where segments grow like a root, the
    /// turn goes as a sine.
    fn sector<const N: usize>(&self, rule: &Quadrature<N>, from: f64, to: f64) -> f64 {
        if to - from < 1e-12 {
            return 0.0;
        }
        let n_dot_v = dot(self.pixel.n, self.pixel.v);
        let offset = libm::atan2(dot(self.incidence, self.frame[1]), dot(self.incidence, self.frame[0]));
        let [from, to] = [from, to].map(|turn| widened(turn - offset, n_dot_v));
        let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
        rule.integral(-FRAC_PI_2, FRAC_PI_2, |t| {
            let [turn, share] = narrowed(middle + half * libm::sin(t), n_dot_v);
            self.segment(rule, turn + offset) * share * half * libm::cos(t)
        })
    }

    /// The integral along the ray that leaves the mirror direction at the angle `turn` from that towards the centre.
    fn segment<const N: usize>(&self, rule: &Quadrature<N>, turn: f64) -> f64 {
        let x = self.glossy.ratio;
        let aside = libm::sin(turn) * libm::sin(self.away);
        let half_square = (x - aside) * (x + aside) / ((1.0 - aside) * (1.0 + aside));
        if half_square <= 0.0 {
            return 0.0;
        }
        let half = libm::asin(libm::sqrt(half_square));
        let foot = libm::atan2(libm::cos(turn) * libm::sin(self.away), libm::cos(self.away));
        let outward = about(self.r, self.frame, FRAC_PI_2, turn);
        let horizon = libm::atan2(dot(self.pixel.n, self.r), -dot(self.pixel.n, outward));
        let to = (foot + half).min(PI).min(horizon);
        let from = (foot - half).max(0.0);
        if to <= from {
            return 0.0;
        }
        let width = self.width(outward);
        rule.integral(libm::atan(from / width), libm::atan(to / width), |t| {
            let tan = libm::tan(t);
            let polar = width * tan;
            let (sin, cos) = (libm::sin(polar), libm::cos(polar));
            let l = [0, 1, 2].map(|i| cos * self.r[i] + sin * outward[i]);
            self.glossy.brdf_of_unit(&Pixel { l, ..self.pixel }) * sin * width * (1.0 + tan * tan)
        })
    }

    /// About how far the lobe reaches in the direction `outward`: half vectors turn half as far as the light in the
    /// plane of incidence, and farther across.
    fn width(&self, outward: Vector) -> f64 {
        let along = dot(outward, self.incidence);
        let across = (1.0 - along * along).max(0.0);
        let n_dot_v = dot(self.pixel.n, self.pixel.v);
        2.0 * self.glossy.alpha / libm::sqrt(along * along + across / (n_dot_v * n_dot_v))
    }
}

/// The angle whose tangent is `cosine` times that of `angle`, in the same quarter of the same turn, and its derivative.
fn narrowed(angle: f64, cosine: f64) -> [f64; 2] {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let near = libm::atan2(cosine * sin, cos);
    let turns = libm::round((angle - near) / (2.0 * PI));
    [near + 2.0 * PI * turns, cosine / (cos * cos + cosine * cosine * sin * sin)]
}

/// The angle that [`narrowed`] makes `angle` of.
fn widened(angle: f64, cosine: f64) -> f64 {
    let near = libm::atan2(libm::sin(angle), cosine * libm::cos(angle));
    near + 2.0 * PI * libm::round((angle - near) / (2.0 * PI))
}
