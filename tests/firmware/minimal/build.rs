//! Puts link.x and riscv.x where the linker looks for them.

fn main() {
    println!("cargo::rustc-link-search={}", std::env::var("CARGO_MANIFEST_DIR").unwrap());
    println!("cargo::rerun-if-changed=link.x");
    println!("cargo::rerun-if-changed=riscv.x");
}
