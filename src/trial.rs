//! What is compared, once for tests, fuzzers, firmware and study: methods, formats, lights, inputs and error budgets.
//!
//! No standard library, no allocation.

pub mod aim;
pub mod blackbody;
pub mod budget;
pub mod chip;
pub mod diffuse;
pub mod digest;
pub mod draw;
pub mod emulated;
pub mod format;
pub mod formula;
pub mod found;
pub mod gloss;
pub mod input;
pub mod judge;
pub mod lights;
pub mod mantissa;
pub mod method;
pub mod property;
pub mod quantity;
pub mod radiometry;
pub mod sampling;
pub mod search;
pub mod shading;
pub mod shadow;
pub mod spread;
pub mod worst;

pub use draw::Draw;
pub use format::{Format, Visitor};
pub use found::Found;
pub use judge::{Judgement, Worst, judge, judge_code};
pub use lights::Light;
pub use method::{Constants, Method};
pub use shading::{Make, Shading, ShadingVisitor};
pub use spread::Spread;
