//! Black bodies: Planck's law in SI units, relative to its peak, and as a tint.

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
