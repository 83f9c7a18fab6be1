//! Numbers of [`raw`](crate::raw) as they lie in memory, lane by lane: for C, uniform buffers and flash images. Needs the
//! feature `fixed`.
//!
//! With the feature `bytemuck` all are `Pod`, and so any bits are one of them: what is read from elsewhere is taken as it
//! is. With `mint` the vectors convert into that crate's. Where arrays will do, they do without either feature, and mint
//! converts them itself:
//!
//! ```
//! use mint::Vector3;
//! use sunglint::raw::{SUN_Q14, cap_q14};
//!
//! const IMAGE: [i32; 4] = SUN_Q14.to_array();
//! assert_eq!(IMAGE[0], 1_248_350);
//!
//! let up = Vector3 { x: 0, y: 0, z: 16_384 };
//! let shaded: Vector3<i16> = cap_q14(up.into(), up.into(), &SUN_Q14).into();
//! assert_eq!(shaded, up);
//! ```

mod conversions;
#[cfg(feature = "mint")]
mod vectors;

/// A vector in Q14: 16384 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VectorQ14 {
    /// First lane.
    pub x: i16,
    /// Second lane.
    pub y: i16,
    /// Third lane.
    pub z: i16,
}

/// A vector in Q30: 1073741824 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VectorQ30 {
    /// First lane.
    pub x: i32,
    /// Second lane.
    pub y: i32,
    /// Third lane.
    pub z: i32,
}

/// A vector of floats.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VectorF32 {
    /// First lane.
    pub x: f32,
    /// Second lane.
    pub y: f32,
    /// Third lane.
    pub z: f32,
}

/// Levels in unsigned Q16: 65536 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ColourQ16 {
    /// Red.
    pub red: u32,
    /// Green.
    pub green: u32,
    /// Blue.
    pub blue: u32,
}

/// Levels in Q30: 1073741824 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ColourQ30 {
    /// Red.
    pub red: i32,
    /// Green.
    pub green: i32,
    /// Blue.
    pub blue: i32,
}

/// A glossy surface, in Q30: 1073741824 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MaterialQ30 {
    /// Diffuse reflectance, each from 0 to 1.
    pub albedo: ColourQ30,
    /// The GGX width, perceptual roughness squared: 0 for a mirror, or from 5e-4 (536871) to 1.
    pub alpha: i32,
    /// Reflectance at normal incidence, each from 0 to 1; 0.02 to 0.05 for what is no metal.
    pub f0: ColourQ30,
}

/// A point of the square of 0 to 1, in Q14: 16384 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointQ14 {
    /// How far from a disc's centre to its rim, by area.
    pub z: i16,
    /// Where around it.
    pub turn: i16,
}

/// A point of the square of 0 to 1, in Q30: 1073741824 is 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointQ30 {
    /// How far from a disc's centre to its rim, by area.
    pub z: i32,
    /// Where around it.
    pub turn: i32,
}

/// Two directions across a third, in Q14.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BasisQ14 {
    /// The first.
    pub t: VectorQ14,
    /// The second.
    pub b: VectorQ14,
}

/// Two directions across a third, in Q30.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BasisQ30 {
    /// The first.
    pub t: VectorQ30,
    /// The second.
    pub b: VectorQ30,
}

/// What a surface sees of a light, in Q30, each from 0 to 1.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SoftShadow {
    /// Share of the disc that is above the surface and seen.
    pub visible: i32,
    /// Mean over the disc of the cosine to the normal, of what is hidden 0.
    pub mean_cosine: i32,
}

/// A light's constants for Q14 vectors, each in Q28, as a constructor or a constant has them; of other numbers, zeros
/// too, answers mean nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphereQ14 {
    /// Sine of the angular radius, which is radius over distance.
    pub sin: i32,
    /// Its square.
    pub sin_square: i32,
    /// Least cosine of a direction inside the disc.
    pub cos: i32,
    /// `1 - cos`.
    pub versine: i32,
}

/// A light's constants for Q30 vectors, each in Q60, as a constructor or a constant has them; of other numbers, zeros
/// too, answers mean nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphereQ30 {
    /// Sine of the angular radius, which is radius over distance.
    pub sin: i64,
    /// Its square.
    pub sin_square: i64,
    /// Least cosine of a direction inside the disc.
    pub cos: i64,
    /// `1 - cos`.
    pub versine: i64,
}
