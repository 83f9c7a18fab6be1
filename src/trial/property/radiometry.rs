//! Radiometry: power, intensity, irradiance, radiance, and the diffuse part down to sunset.

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
