//! Normalisation: solid angle, sizeFactor, radiance, in floats and in integers.

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
