//! A page for each method: formula, errors along angle and ratio, worst inputs, pictures, failures.

use crate::result::Study;

/// The section; empty where nothing was measured.
pub fn all(_study: &Study) -> String {
    String::new()
}
