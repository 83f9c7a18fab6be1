//! What the tests of C and WebAssembly share: hashes of results as Rust has them, and finding the tools.

pub mod hashes;
pub mod tools;
