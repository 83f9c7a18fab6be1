//! What the firmware and the host draw: the ball as a reader of the README copies it, and the same in f32.
#![cfg_attr(not(test), no_std)]

pub mod ball;
pub mod display;
pub mod float;
pub mod planet;

#[cfg(test)]
mod tests {
    /// The core of embedded-graphics wants `az` below 1.3, `fixed` from 1.30 on wants 1.3: cargo takes `fixed` 1.29.
    #[test]
    fn one_fixed_serves_sunglint_and_embedded_graphics() {
        let lock = include_str!("../Cargo.lock");
        let versions = |name: &str| -> Vec<&str> {
            let packages = lock.split("[[package]]\n");
            packages.filter_map(|package| package.strip_prefix(&format!("name = \"{name}\"\nversion = \""))).collect()
        };
        let [az, fixed, graphics] = ["az", "fixed", "embedded-graphics"].map(versions);
        assert!(az.len() == 1 && az[0].starts_with("1.2."), "{az:?}");
        assert!(fixed.len() == 1 && fixed[0].starts_with("1.29."), "{fixed:?}");
        assert!(graphics.len() == 1 && graphics[0].starts_with("0.8."), "{graphics:?}");
    }
}
