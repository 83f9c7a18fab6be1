//! Sampling: directions of the disc, the basis, the density, the hit test and soft shadows.

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
