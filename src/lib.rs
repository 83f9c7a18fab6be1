//! Light a surface by the Sun, or by any distant sphere, in the arithmetic that the machine has: fixed point on a
//! chip without an FPU, half floats on a phone GPU, f32, f64.
//!
//! A distant sphere needs no position, only radius over distance. This crate turns that ratio into constants once
//! ([`DistantSphere`]), and with them every pixel into the direction to shade with ([`cap`]), or into its brightness
//! ([`scene`]), so that the highlight has the light's size and no more than its energy. It models no more than that
//! needs: no camera, no geometry.
//!
//! | room | what it has |
//! |---|---|
//! | [`scene`], [`material`] | distant lights, one material, [`shade`](scene::Scene::shade) |
//! | [`specular`], [`highlight`], [`diffuse`] | which point of the disc; how bright the gloss; how bright the rest, down to sunset |
//! | [`light`], [`sphere`], [`normalization`] | a light as described, its constants in a format, sizeFactor and solid angle |
//! | [`sampling`], [`shadow`] | directions of the disc and their density; soft shadows by the caller's visibility |
//! | [`radiometry`], [`blackbody`] | power, intensity, irradiance, radiance; Planck's law and tints |
//! | [`raw`], [`plain`] | the same on raw bits; their numbers as they lie in memory |
//! | [`soft`] | f32 in integers, for chips without an FPU: roots, directions |
//! | `capi` | `extern "C"` functions on raw bits and plain structs, and `src/capi/sunglint.h`; with the feature `capi` |
//!
//! ```
//! use sunglint::{DistantSphere, SUN, cap, reflect};
//!
//! const SUN_F32: DistantSphere<f32> = DistantSphere::<f32>::new(&SUN);
//!
//! let (n, v, l) = ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.5985, 0.0, 0.80112]);
//! let specular_l = cap(l, reflect(n, v), &SUN_F32);
//! // The mirror ray is within the Sun's 0.27 degrees, so it is what the surface reflects.
//! assert_eq!(specular_l, [-0.6, 0.0, 0.8]);
//! ```
//!
//! # Formats
//!
//! | type | lanes | scalars and constants | worst error of [`cap`] at the Sun | light quantities | light levels |
//! |---|---|---|---|---|---|
//! | f64 | as they are | the same | 2.5e-16 rad | 0.51 ULP | the same |
//! | f32 | as they are | the same | 5.7e-8 rad | 0.51 ULP | the same |
//! | micromath | f32 | the same | 8.0e-8 rad | 0.51 ULP | the same |
//! | f16 | f16, subnormals not needed | the same | 4.8e-4 rad | 0.8 ULP | the same |
//! | I2F14 | Q14 in 16 bits | Q28 in 32 | 6.2e-5 rad | 0.51 LSB of U16F48, U52F12 | U16F16 |
//! | I2F30 | Q30 in 32 bits | Q60 in 64 | 1.5e-9 rad | the same | U32F32 |
//! | I16F16 | Q16 in 32 bits | Q32 in 64 | 1.5e-5 rad | the same | U16F16 |
//!
//! Brightness is computed in [`Scaled`](real::Scaled) numbers beside fixed-point lanes: 31 bits and an exponent of
//! their own, in integers. Levels saturate.
//!
//! All live in one build; a format is a type, and a formula is written once over [`Real`]. [`raw`] takes and gives
//! bits. The types come from the crates [`fixed`], [`half`] and [`micromath`], which are re-exported. f64 takes its square
//! root from libm, whose version for no_std is software, on chips with a root instruction too; so does f32 but on arm and
//! riscv32, where a root in integers gives the same bits in a third of the instructions.
//!
//! # Overflow
//!
//! Nothing panics. A light that cannot be is a [`LightError`] with the value and the range. Per pixel, vectors are
//! expected at unit length, give or take what rounding does; lengths up to 1.16 never overflow any format. Beyond
//! that fixed point wraps or saturates to a meaningless direction. NaN and infinities have the answers that each
//! function documents.
//!
//! # Features
//!
//! `fixed`, `half` and `micromath` (all on) bring the formats of the crates of those names, `heapless` (on) the scene,
//! whose lights are in a list of that crate's; no type of it is public. None changes a result. `capi` (with `fixed` and
//! `heapless`) adds functions for C, the one place where attributes, and nothing else, are unsafe; the README has the
//! command that makes a library of them. `oracle` adds the f64 truth and the lists that tests and study share, without
//! the standard library; `study` the host tool.
//!
//! Four more bring other crates' traits, without the standard library as well:
//!
//! | feature | what it does |
//! |---|---|
//! | `serde` | [`DistantLight`], [`Description`](light::Description), [`Material`](material::Material), [`SphereLight`](radiometry::SphereLight) and [`Channel`](scene::Channel) are stored as described, and checked when read |
//! | `defmt` | every public type but [`Scene`](scene::Scene) is a `Format` where its numbers are: f16 and micromath are not, lanes of `fixed` by that crate's feature of the name, from 1.30 on |
//! | `bytemuck` | the structs of [`plain`] are `Pod`; [`DistantSphere::to_array`] needs no feature |
//! | `mint` | the vectors of [`plain`] convert into mint's and back; the arrays that functions take mint converts by itself |
//!
//! Constants such as [`DistantSphere`] and [`Surface`](material::Surface) are not stored: four numbers that have to agree
//! to the last bit, and a format that a file should not know. Store what they are made of.
#![cfg_attr(not(test), no_std)]
// Says at each item which feature it needs; docs.rs has the nightly that can.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![cfg_attr(not(feature = "capi"), forbid(unsafe_code))]
#![deny(unsafe_code)]
#![warn(missing_docs, missing_debug_implementations, missing_copy_implementations)]

pub mod blackbody;
// Symbols by name are unsafe attributes.
#[cfg(feature = "capi")]
#[allow(unsafe_code)]
pub mod capi;
mod constant;
pub mod diffuse;
mod exponential;
pub mod highlight;
pub mod light;
pub mod material;
#[cfg(any(feature = "fixed", target_arch = "arm", target_arch = "riscv32"))]
mod multiply;
pub mod normalization;
#[cfg(feature = "oracle")]
pub mod oracle;
mod pair;
#[cfg(feature = "fixed")]
pub mod plain;
mod product;
pub mod radiometry;
#[cfg(feature = "fixed")]
pub mod raw;
pub mod real;
#[cfg(feature = "fixed")]
mod reciprocal;
#[cfg(any(feature = "fixed", target_arch = "arm", target_arch = "riscv32"))]
mod root;
pub mod sampling;
#[cfg(feature = "heapless")]
pub mod scene;
pub mod shadow;
#[cfg(feature = "fixed")]
pub mod soft;
pub mod specular;
pub mod sphere;
#[cfg(feature = "oracle")]
pub mod trial;
mod vec3;
#[cfg(feature = "fixed")]
mod zeros;

#[cfg(feature = "fixed")]
pub use fixed;
#[cfg(feature = "half")]
pub use half;
#[cfg(feature = "micromath")]
pub use micromath;

pub use diffuse::{illuminance, lambert, lambert_disc, relative_illuminance};
pub use light::{DistantLight, LightError, SUN};
pub use real::{Float, Real, Scalar};
pub use specular::{cap, disc, epic, factored, normalize, reflect};
pub use sphere::{DistantSphere, UnfactoredSphere};

/// The README's examples are tests too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
