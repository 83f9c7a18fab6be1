//! What the tests of C and WebAssembly share: hashes of results as Rust has them, the library for C, programs in C, and finding
//! the tools.

pub mod hashes;
pub mod library;
pub mod program;
pub mod tools;
