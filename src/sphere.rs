//! The constants of a light in one number format, computed once and outside the pixel.

use crate::light::{DistantLight, LightError};
use crate::normalization;
use crate::real::{Float, Real};

/// What the direction methods need of a light, rounded into the format `T`.
///
/// Floats hold each constant rounded to nearest. Fixed point holds them with twice its fraction bits: Q28 for I2F14,
/// Q60 for I2F30 (to f64's 53 digits, unless made from a ratio in Q30), Q32 for I16F16. `tests/sphere.rs` asserts it.
///
/// ```
/// use sunglint::fixed::types::I2F14;
/// use sunglint::{DistantSphere, SUN};
///
/// // 16 bytes of flash, and no float arithmetic at run time.
/// const SUN_Q14: DistantSphere<I2F14> = DistantSphere::<I2F14>::new(&SUN);
/// assert_eq!(core::mem::size_of_val(&SUN_Q14), 16);
/// ```
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DistantSphere<T: Real> {
    pub(crate) sin: T::Wide,
    pub(crate) sin_square: T::Wide,
    pub(crate) cos: T::Wide,
    pub(crate) versine: T::Wide,
}

impl<T: Real> DistantSphere<T> {
    /// The constants of `light` in any format; for a constant of one of the seven formats use its `new`.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let sun = DistantSphere::<f16>::of(&SUN);
    /// assert_eq!(sun, DistantSphere::<f16>::new(&SUN));
    /// // What f16 keeps of the Sun: 11 bits of the sine, nothing of the cosine.
    /// assert_eq!((sun.sin().to_f32(), sun.cos().to_f32()), (0.004_650_116, 1.0));
    /// ```
    pub fn of(light: &DistantLight) -> Self {
        Self {
            sin: T::wide(light.sin()),
            sin_square: T::square_of(light.sin()),
            cos: T::wide(least_cosine(light)),
            versine: T::wide(light.versine()),
        }
    }

    /// Sine of the angular radius, which is radius over distance.
    ///
    /// ```
    /// use sunglint::raw::SUN_Q14;
    ///
    /// // Q28: 0.004 650 467.
    /// assert_eq!(SUN_Q14.sin(), 1_248_350);
    /// ```
    pub fn sin(&self) -> T::Wide {
        self.sin
    }

    /// Its square, in the scale of [`Real::square`]: times 4096 in f16, where it would be subnormal.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::raw::SUN_Q14;
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// assert_eq!(SUN_Q14.sin_square(), 5805); // 2.16e-5 in Q28
    /// let scaled = DistantSphere::<f16>::new(&SUN).sin_square().to_f64() / 4096.0;
    /// assert!((scaled / (SUN.sin() * SUN.sin()) - 1.0).abs() < 5e-4);
    /// ```
    pub fn sin_square(&self) -> T::Wide {
        self.sin_square
    }

    /// Least cosine of a direction inside the disc: the cosine of the angular radius, or -2 for the full sphere, in
    /// which also directions lie whose dot product is a rounding below -1.
    ///
    /// ```
    /// use sunglint::{DistantLight, DistantSphere, SUN};
    ///
    /// assert_eq!(DistantSphere::<f32>::new(&SUN).cos(), 0.999_989_2);
    /// let all = DistantLight::from_angle(360.0).unwrap();
    /// assert_eq!(DistantSphere::<f32>::new(&all).cos(), -2.0);
    /// ```
    pub fn cos(&self) -> T::Wide {
        self.cos
    }

    /// `1 - cos` of the angular radius.
    ///
    /// ```
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// let sun = DistantSphere::<f32>::new(&SUN);
    /// assert_eq!(sun.versine(), 1.081_348_1e-5);
    /// // The difference has but 8 of f32's 24 digits.
    /// assert!(((1.0 - sun.cos()) / sun.versine() - 1.0).abs() > 1e-3);
    /// ```
    pub fn versine(&self) -> T::Wide {
        self.versine
    }

    /// Sine, its square, cosine and versine, as they lie in a buffer: for shaders and flash images.
    ///
    /// ```
    /// use sunglint::{DistantSphere, SUN};
    ///
    /// const UNIFORM: [f32; 4] = DistantSphere::<f32>::new(&SUN).to_array();
    /// assert_eq!(UNIFORM[0], 0.004_650_467_3);
    /// ```
    pub const fn to_array(&self) -> [T::Wide; 4] {
        [self.sin, self.sin_square, self.cos, self.versine]
    }
}

impl<T: Float> DistantSphere<T> {
    /// The constants of a sphere whose radius over distance is `ratio`, computed in the format itself, for a light that
    /// moves on a chip without f64. Within 0.51 units in the last place, 0.76 where the
    /// versine is subnormal (f16: 0.8).
    ///
    /// ```
    /// use sunglint::{DistantSphere, LightError};
    ///
    /// // A lamp of 5 cm radius that is at 2.5 m just now.
    /// let lamp = DistantSphere::<f32>::from_ratio(0.05 / 2.5).unwrap();
    /// assert!((lamp.versine() / 2.000_2e-4 - 1.0).abs() < 1e-6);
    /// assert_eq!(DistantSphere::<f32>::from_ratio(2.0), Err(LightError::Ratio(2.0)));
    /// ```
    ///
    /// # Errors
    /// [`LightError::Ratio`] for NaN, negative values and values above 1.
    pub fn from_ratio(ratio: T) -> Result<Self, LightError> {
        let versine = normalization::versine(ratio)?;
        let scaled = ratio * T::SCALE;
        let cos = normalization::cosine(ratio).rounded();
        Ok(Self { sin: ratio, sin_square: scaled * scaled, cos, versine })
    }
}

const fn least_cosine(light: &DistantLight) -> f64 {
    // The sine tells what the cosine has lost: a gap of 1e-9 about the opposite, which is no part of the disc.
    let full = light.versine() >= 2.0 && light.sin() <= f64::EPSILON;
    if full { -2.0 } else { light.cos() }
}

/// What [`epic`](crate::epic) needs of a light: radius and distance, not divided by each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UnfactoredSphere<T: Real> {
    pub(crate) radius: T::Wide,
    pub(crate) radius_square: T::Wide,
    pub(crate) distance: T::Wide,
}

impl<T: Real> UnfactoredSphere<T> {
    /// Radius and distance of `light` in its own unit. A format that cannot hold them has infinities (floats) or its
    /// greatest number (fixed point) here, and `epic` fails.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::{SUN, UnfactoredSphere, epic};
    ///
    /// let l = [f16::ZERO, f16::ZERO, f16::ONE];
    /// // f32 holds the Sun's distance in kilometres, f16 does not.
    /// assert_eq!(epic([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], &UnfactoredSphere::<f32>::of(&SUN)), [0.0, 0.0, 1.0]);
    /// assert!(epic(l, l, &UnfactoredSphere::<f16>::of(&SUN))[2].is_nan());
    /// ```
    pub fn of(light: &DistantLight) -> Self {
        Self {
            radius: T::wide(light.radius()),
            radius_square: T::square_of(light.radius()),
            distance: T::wide(light.distance()),
        }
    }
}

const fn to_f64(value: f64) -> f64 {
    value
}

const fn to_f32(value: f64) -> f32 {
    value as f32
}

#[cfg(feature = "micromath")]
const fn to_micromath(value: f64) -> micromath::F32 {
    micromath::F32(value as f32)
}

// A macro, since no function of a trait can be called in a constant.
macro_rules! constants_of {
    ($format:ty, $wide:path, $scale:expr) => {
        impl DistantSphere<$format> {
            /// The constants of `light`, each rounded to nearest; in constants too.
            ///
            /// ```
            /// use sunglint::{DistantSphere, SUN};
            /// # use sunglint::{fixed::types::{I2F14, I2F30, I16F16}, half, micromath};
            ///
            #[doc = concat!("type Sphere = DistantSphere<", stringify!($format), ">;")]
            /// const SUN_SPHERE: Sphere = Sphere::new(&SUN);
            /// assert_eq!(SUN_SPHERE, Sphere::of(&SUN));
            /// ```
            pub const fn new(light: &DistantLight) -> Self {
                let scaled = light.sin() * $scale;
                Self {
                    sin: $wide(light.sin()),
                    sin_square: $wide(scaled * scaled),
                    cos: $wide(least_cosine(light)),
                    versine: $wide(light.versine()),
                }
            }
        }
    };
}

constants_of!(f64, to_f64, 1.0);
constants_of!(f32, to_f32, 1.0);
#[cfg(feature = "micromath")]
constants_of!(micromath::F32, to_micromath, 1.0);
#[cfg(feature = "half")]
constants_of!(half::f16, crate::real::half::nearest, crate::real::half::SQUARE_SCALE);

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::{I2F14, I2F30, I16F16};

    use super::{DistantLight, DistantSphere, LightError, least_cosine};
    use crate::normalization::Q60;
    use crate::real::fixed::{wide_i32, wide_i64};

    constants_of!(I2F14, wide_i32::<28>, 1.0);
    constants_of!(I2F30, wide_i64::<60>, 1.0);
    constants_of!(I16F16, wide_i64::<32>, 1.0);

    // A macro for the sake of the wide type's cast.
    macro_rules! integers_of {
        ($format:ty, $wide:ty, $fraction:literal) => {
            impl DistantSphere<$format> {
                /// The constants of a sphere whose radius over distance is `ratio`, in integers to the end, for a light
                /// that moves on a chip without an FPU. Within 0.51 units of the wide format's last place (I2F30:
                /// 0.75 asserted, 0.5 found over all ratios).
                ///
                /// ```
                /// use sunglint::fixed::types::*;
                /// use sunglint::{DistantLight, DistantSphere, LightError};
                ///
                #[doc = concat!("type Sphere = DistantSphere<", stringify!($format), ">;")]
                /// // A lamp that touches the eye fills half the sky.
                /// let near = Sphere::from_ratio_q30(I2F30::ONE).unwrap();
                /// assert_eq!(near, Sphere::new(&DistantLight::from_ratio(1.0).unwrap()));
                /// assert_eq!(Sphere::from_ratio_q30(-I2F30::DELTA), Err(LightError::RatioQ30(-1)));
                /// ```
                ///
                /// # Errors
                /// [`LightError::RatioQ30`] for negative values and values above 1.
                pub fn from_ratio_q30(ratio: I2F30) -> Result<Self, LightError> {
                    let Q60 { sin, sin_square, cos, versine } = Q60::of(ratio)?;
                    let [sin, sin_square, cos, versine] = [sin, sin_square, cos, versine]
                        .map(|bits| ((bits >> (60 - $fraction)) + ((bits << 1 >> (60 - $fraction)) & 1)) as $wide);
                    Ok(Self { sin, sin_square, cos, versine })
                }
            }
        };
    }

    integers_of!(I2F14, i32, 28);
    integers_of!(I2F30, i64, 60);
    integers_of!(I16F16, i64, 32);
}
