//! What a surface is made of, and the same in one number format.

use core::fmt;

use crate::real::{Constant, Real, Scalar};

/// The least roughness but 0: below it a highlight of f16 has no width.
pub const LEAST_ALPHA: f64 = 5e-4;

/// A glossy surface: red, green and blue of its diffuse and of its specular reflectance, and its roughness.
///
/// ```
/// use sunglint::material::Material;
///
/// const SEA: Material = match Material::new([0.01, 0.03, 0.05], 0.02, [0.02; 3]) {
///     Ok(sea) => sea,
///     Err(_) => panic!("reflectances and alpha are from 0 to 1"),
/// };
/// assert!(Material::new([0.5; 3], 1e-4, [0.04; 3]).is_err());
/// ```
///
/// With the feature `serde` its fields are those of [`Material::new`], which reads them: in JSON `{ "albedo": [0.01,
/// 0.03, 0.05], "alpha": 0.02, "f0": [0.02, 0.02, 0.02] }`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(try_from = "stored::Fields"))]
pub struct Material {
    albedo: [Constant; 3],
    alpha: Constant,
    f0: [Constant; 3],
}

impl Material {
    /// `albedo` and `f0` (the reflectance at normal incidence; 0.02 to 0.05 for what is no metal) from 0 to 1, `alpha`
    /// (perceptual roughness squared) 0 for a mirror or from [`LEAST_ALPHA`] to 1.
    ///
    /// # Errors
    /// [`MaterialError`] for what is out of those ranges, NaN included.
    ///
    /// ```
    /// use sunglint::material::{Material, MaterialError};
    ///
    /// let polish = Material::new([0.1, 0.05, 0.02], 5e-4, [0.04; 3]);
    /// assert!(polish.is_ok());
    /// let bright = Material::new([0.1, 0.05, 1.5], 5e-4, [0.04; 3]);
    /// assert_eq!(bright, Err(MaterialError::Albedo(1.5)));
    /// assert_eq!(bright.unwrap_err().to_string(), "albedo is 1.5, allowed is 0 to 1");
    /// ```
    pub const fn new(albedo: [f64; 3], alpha: f64, f0: [f64; 3]) -> Result<Self, MaterialError<f64>> {
        let mut channel = 0;
        while channel < 3 {
            if !(albedo[channel] >= 0.0 && albedo[channel] <= 1.0) {
                return Err(MaterialError::Albedo(albedo[channel]));
            }
            if !(f0[channel] >= 0.0 && f0[channel] <= 1.0) {
                return Err(MaterialError::F0(f0[channel]));
            }
            channel += 1;
        }
        if alpha != 0.0 && !(alpha >= LEAST_ALPHA && alpha <= 1.0) {
            return Err(MaterialError::Alpha(alpha));
        }
        Ok(Self {
            albedo: [Constant::new(albedo[0]), Constant::new(albedo[1]), Constant::new(albedo[2])],
            alpha: Constant::new(alpha),
            f0: [Constant::new(f0[0]), Constant::new(f0[1]), Constant::new(f0[2])],
        })
    }
}

#[cfg(feature = "serde")]
mod stored {
    use super::{Material, MaterialError};

    /// What a file has of a material, before it is checked.
    #[derive(serde::Deserialize)]
    #[serde(rename = "Material", deny_unknown_fields)]
    pub(super) struct Fields {
        albedo: [f64; 3],
        alpha: f64,
        f0: [f64; 3],
    }

    impl TryFrom<Fields> for Material {
        type Error = MaterialError;

        fn try_from(fields: Fields) -> Result<Self, MaterialError> {
            Self::new(fields.albedo, fields.alpha, fields.f0)
        }
    }
}

/// A [`Material`] in the format `T`, each number rounded to nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Surface<T: Real> {
    pub(crate) albedo: [T::Scalar; 3],
    pub(crate) alpha: T::Scalar,
    pub(crate) f0: [T::Scalar; 3],
}

impl<T: Real> Surface<T> {
    /// `material` in the format `T`; no f64 arithmetic.
    ///
    /// ```
    /// use sunglint::fixed::types::I2F14;
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::real::Scaled;
    ///
    /// const CHALK: Material = match Material::new([0.8; 3], 0.75, [0.04; 3]) {
    ///     Ok(chalk) => chalk,
    ///     Err(_) => panic!("reflectances and alpha are from 0 to 1"), // while compiling
    /// };
    /// // Beside lanes of 16 bits these numbers have 31 and an exponent.
    /// assert_eq!(Surface::<I2F14>::of(&CHALK).alpha(), Scaled::from_bits(3, -2));
    /// ```
    #[inline]
    pub fn of(material: &Material) -> Self {
        let scalars = |[red, green, blue]: [Constant; 3]| [red, green, blue].map(T::Scalar::constant);
        Self { albedo: scalars(material.albedo), alpha: T::Scalar::constant(material.alpha), f0: scalars(material.f0) }
    }

    /// A surface from numbers of the format, for one that changes at run time. Ranges as in [`Material::new`].
    ///
    /// # Errors
    /// [`MaterialError`] for what is out of range.
    ///
    /// ```
    /// use sunglint::half::f16;
    /// use sunglint::material::{MaterialError, Surface};
    ///
    /// let [black, grey, glass] = [0.0, 0.5, 0.04].map(f16::from_f32);
    /// // Drying: from a polish to chalk.
    /// let surface = |alpha: f32| Surface::<f16>::new([grey; 3], f16::from_f32(alpha), [glass; 3]);
    /// assert!([0.0, 5e-4, 0.1, 1.0].into_iter().all(|alpha| surface(alpha).is_ok()));
    /// let tiny = f16::from_f32(1e-4);
    /// assert_eq!(Surface::<f16>::new([black; 3], tiny, [glass; 3]), Err(MaterialError::Alpha(tiny)));
    /// ```
    #[inline]
    pub fn new(albedo: [T::Scalar; 3], alpha: T::Scalar, f0: [T::Scalar; 3]) -> Result<Self, MaterialError<T::Scalar>> {
        const LEAST: Constant = Constant::new(LEAST_ALPHA);
        let within = |value: T::Scalar, least: T::Scalar| value >= least && value <= T::Scalar::ONE;
        let outside = |&value: &T::Scalar| !within(value, T::Scalar::ZERO);
        if let Some(value) = albedo.into_iter().find(outside) {
            return Err(MaterialError::Albedo(value));
        }
        if let Some(value) = f0.into_iter().find(outside) {
            return Err(MaterialError::F0(value));
        }
        let allowed = alpha == T::Scalar::ZERO || within(alpha, T::Scalar::constant(LEAST));
        if allowed { Ok(Self { albedo, alpha, f0 }) } else { Err(MaterialError::Alpha(alpha)) }
    }

    /// The GGX width.
    ///
    /// ```
    /// use sunglint::material::{Material, Surface};
    /// use sunglint::micromath::F32;
    ///
    /// // Roughness of artists' tools, squared.
    /// let satin = Surface::<F32>::of(&Material::new([0.5; 3], 0.3 * 0.3, [0.04; 3])?);
    /// assert_eq!(satin.alpha(), F32(0.09));
    /// # Ok::<(), sunglint::material::MaterialError>(())
    /// ```
    pub fn alpha(&self) -> T::Scalar {
        self.alpha
    }
}

/// Why a material could not be made; holds the value, and displays the range allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum MaterialError<S = f64> {
    /// A channel of the albedo is not within 0 to 1.
    Albedo(S),
    /// A channel of the reflectance at normal incidence is not within 0 to 1.
    F0(S),
    /// `alpha` is neither 0 nor within [`LEAST_ALPHA`] to 1.
    Alpha(S),
}

impl<S: Scalar> fmt::Display for MaterialError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Albedo(value) => write!(f, "albedo is {}, allowed is 0 to 1", value.exact()),
            Self::F0(value) => write!(f, "reflectance at normal incidence is {}, allowed is 0 to 1", value.exact()),
            Self::Alpha(value) => write!(f, "alpha is {}, allowed is 0 or {LEAST_ALPHA} to 1", value.exact()),
        }
    }
}

impl<S: Scalar> core::error::Error for MaterialError<S> {}
