//! Illuminance of a tilted plane under a disc, by quadrature of its definition: `max(n.w, 0)` over the disc.
//!
//! Nothing of the disc's shape on the plane is derived: the disc is cut into rings about its centre, each ring into its
//! azimuths, and every ring is left where the plane cuts it.

use core::f64::consts::PI;

/// Nodes and weights of Gauss and Legendre's rule of 16 points, one half of them.
const RULE: [[f64; 2]; 8] = [
    [0.9894009349916499, 0.027152459411754058],
    [0.9445750230732326, 0.062253523938647776],
    [0.8656312023878318, 0.0951585116824929],
    [0.755404408355003, 0.12462897125553395],
    [0.6178762444026438, 0.14959598881657682],
    [0.45801677765722737, 0.16915651939500256],
    [0.2816035507792589, 0.1826034150449236],
    [0.09501250983763744, 0.18945061045506847],
];

/// Illuminance of a plane by a disc of radiance 1 whose angular radius has the sine `sin` and a cosine of the sign of
/// `cos`, and whose centre's direction has the cosine `n_dot_l` to the plane's normal.
///
/// Within 4e-11 of the value (against 192 bits), also where hardly anything of the disc is above the plane; twice the
/// nodes move it by 5e-11 at most, beyond half the sky by 5e-10 (`tests/diffuse.rs`).
pub fn illuminance(n_dot_l: f64, sin: f64, cos: f64) -> f64 {
    illuminance_by(n_dot_l, sin, cos, 1)
}

/// [`illuminance`] with `panels` times as many nodes in each direction.
pub fn illuminance_by(n_dot_l: f64, sin: f64, cos: f64, panels: u32) -> f64 {
    let disc = Disc::new(n_dot_l, sin, cos);
    disc.above(panels) + disc.astride(panels) + disc.beyond(panels)
}

/// [`illuminance`] over that of a plane which faces the disc: `pi sin^2`, or pi for discs beyond half the sky.
pub fn relative_illuminance(n_dot_l: f64, sin: f64, cos: f64) -> f64 {
    let facing = if cos >= 0.0 { sin * sin } else { 1.0 };
    illuminance(n_dot_l, sin, cos) / (PI * facing)
}

/// A disc over a plane. Rings are told by their angle from the disc's centre.
struct Disc {
    /// Sine of the centre's elevation.
    sine: f64,
    /// Its cosine.
    across: f64,
    /// The disc's angular radius.
    theta: f64,
    /// The first ring that the plane cuts: the size of the centre's elevation.
    first: f64,
    /// From there to the rim.
    rest: f64,
}

impl Disc {
    fn new(sine: f64, sin: f64, cos: f64) -> Self {
        let across = libm::sqrt((1.0 - sine) * (1.0 + sine));
        let size = libm::fabs(sine);
        let cos = libm::copysign(libm::sqrt((1.0 - sin) * (1.0 + sin)), cos);
        // Sine and cosine of the difference of two angles, of which the sine would cancel.
        let ahead = if cos > 0.0 {
            (sin - size) * (sin + size) / (sin * across + size * cos)
        } else {
            sin * across - size * cos
        };
        let rest = libm::atan2(ahead, cos * across + sin * size);
        Self { sine, across, theta: libm::atan2(sin, cos), first: libm::atan2(size, across), rest }
    }

    /// Rings that are wholly above the plane, about a centre that is above it.
    fn above(&self, panels: u32) -> f64 {
        if self.sine < 0.0 { 0.0 } else { self.rings(0.0, self.first.min(self.theta), panels) }
    }

    /// Rings that are wholly above the plane, about the point opposite to a centre that is below it.
    fn beyond(&self, panels: u32) -> f64 {
        let last = PI - self.first;
        if self.sine < 0.0 && self.theta > last { self.rings(last, self.theta, panels) } else { 0.0 }
    }

    fn rings(&self, from: f64, to: f64, panels: u32) -> f64 {
        integral(|ring| 2.0 * PI * libm::sin(ring) * self.sine * libm::cos(ring), from, to, panels)
    }

    /// Rings that the plane cuts.
    fn astride(&self, panels: u32) -> f64 {
        let width = self.rest.min(PI - 2.0 * self.first);
        if width <= 0.0 {
            return 0.0;
        }
        let ring = |turn: f64| {
            // What is above the plane begins with the root of the ring's distance from the first: as a function of
            // this variable it is smooth.
            let half = libm::sin(turn / 2.0);
            let past = width * half * half;
            self.cut(past) * width / 2.0 * libm::sin(turn)
        };
        integral(ring, 0.0, PI, panels)
    }

    /// The integral over the ring that is `past` the first.
    fn cut(&self, past: f64) -> f64 {
        let ring = self.first + past;
        let (sin, amplitude) = (libm::sin(ring), self.across * libm::sin(ring));
        // The plane cuts the ring at this azimuth, reckoned from the horizon's nearer side.
        let square = libm::sin(past) / (2.0 * amplitude);
        let azimuth = 2.0 * libm::asin(libm::sqrt(square.clamp(0.0, 1.0)));
        // max(a + b cos(t)) from 0 to where it is zero, by parts.
        let side = amplitude * integral(|t| t * libm::sin(t), 0.0, azimuth, 1);
        let whole = if self.sine < 0.0 { 0.0 } else { PI * self.sine * libm::cos(ring) };
        2.0 * sin * (whole + side)
    }
}

/// Gauss and Legendre's rule on each of so many equal panels.
fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64, panels: u32) -> f64 {
    let half = (to - from) / (2.0 * f64::from(panels));
    let panel = |index: u32| {
        let middle = from + half * (2.0 * f64::from(index) + 1.0);
        RULE.into_iter().map(|[node, weight]| weight * (f(middle - half * node) + f(middle + half * node))).sum::<f64>()
    };
    (0..panels).map(panel).sum::<f64>() * half
}
