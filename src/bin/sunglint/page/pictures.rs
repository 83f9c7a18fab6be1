//! The contact sheets and what they show.

use crate::result::Study;

/// The section; empty where nothing was measured.
pub fn all(_study: &Study) -> String {
    String::new()
}
