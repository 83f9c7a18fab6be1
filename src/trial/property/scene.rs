//! Scenes: materials, lamps and whole pixels, three channels at a time.

use super::Broken;
use crate::trial::draw::Draw;

/// Reads a case and says what it breaks.
///
/// # Errors
/// [`Broken`].
pub fn hold(draw: &mut Draw<'_>) -> Result<(), Broken> {
    let _ = draw;
    Ok(())
}
