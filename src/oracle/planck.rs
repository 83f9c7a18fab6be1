//! Planck's law in f64, from its definition: `expm1`, with the rounding of its exponent put back.
//!
//! `tests/blackbody.rs` holds it against 192 bits.

/// `hc / k` in m K, as its nearest f64 and what that lacks.
const SECOND: [f64; 2] = [1.438_776_877_503_933_9e-2, -6.735_986_446_804_958e-19];

/// `h / k` in K/Hz, as its nearest f64 and what that lacks.
const HERTZ: [f64; 2] = [4.799_243_073_366_221e-11, 2.429_594_167_459_689_6e-27];

/// `2 h c^2` in W m^2/sr.
const FIRST: f64 = 1.191_042_972_397_188_4e-16;

/// `2 h / c^2` in W s^4/(m^2 sr).
const FIRST_BY_FREQUENCY: f64 = 1.474_499_464_762_541_6e-50;

/// One of the two forms of the law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// By wavelength.
    Wavelength,
    /// By frequency.
    Frequency,
}

impl Law {
    /// Both forms.
    pub const ALL: [Self; 2] = [Self::Wavelength, Self::Frequency];

    /// Name of the form.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Wavelength => "wavelength",
            Self::Frequency => "frequency",
        }
    }

    /// The exponent at the peak, as its nearest f64 and what that lacks: the root of `a = n (1 - exp(-a))`.
    const fn peak(self) -> [f64; 2] {
        match self {
            Self::Wavelength => [4.965_114_231_744_276, 2.849_114_272_812_878e-16],
            Self::Frequency => [2.821_439_372_122_078_7, 1.564_102_018_963_651_6e-16],
        }
    }

    /// Spectral radiance over that of the peak, at `ratio` times the peak's wavelength or frequency; 0 or from 1e-60
    /// to 1e60.
    pub fn relative(self, ratio: f64) -> f64 {
        if ratio == 0.0 {
            return 0.0;
        }
        let peak = self.peak();
        let top = expm1(peak);
        match self {
            Self::Wavelength => top / expm1(quotient(peak, [ratio, 0.0])) / power(ratio, 5),
            Self::Frequency => top / expm1(product(peak, ratio)) * power(ratio, 3),
        }
    }

    /// The exponent `hc / (lambda k T)` or `h nu / (k T)`, at a wavelength in metres or frequency in hertz.
    pub fn exponent(self, at: f64, temperature: f64) -> f64 {
        self.exponent_parts(at, temperature)[0]
    }

    /// Spectral radiance in SI units, at a wavelength in metres or frequency in hertz from 1e-50 to 1e50.
    pub fn radiance(self, at: f64, temperature: f64) -> f64 {
        let below = expm1(self.exponent_parts(at, temperature));
        match self {
            Self::Wavelength => FIRST / power(at, 5) / below,
            Self::Frequency => FIRST_BY_FREQUENCY * power(at, 3) / below,
        }
    }

    fn exponent_parts(self, at: f64, temperature: f64) -> [f64; 2] {
        match self {
            Self::Wavelength => quotient(SECOND, product([at, 0.0], temperature)),
            Self::Frequency => quotient(product(HERTZ, at), [temperature, 0.0]),
        }
    }
}

/// `expm1` of a sum.
fn expm1([high, low]: [f64; 2]) -> f64 {
    if high > 700.0 { f64::INFINITY } else { libm::expm1(high) + low * libm::exp(high) }
}

fn product([high, low]: [f64; 2], factor: f64) -> [f64; 2] {
    let product = high * factor;
    [product, libm::fma(high, factor, -product) + low * factor]
}

fn quotient([high, low]: [f64; 2], [divisor, rest]: [f64; 2]) -> [f64; 2] {
    let quotient = high / divisor;
    [quotient, (libm::fma(-quotient, divisor, high) + low - quotient * rest) / divisor]
}

fn power(base: f64, exponent: u32) -> f64 {
    (0..exponent).map(|_| base).product()
}
