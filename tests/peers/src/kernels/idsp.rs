//! The crate `idsp`.

/// Sine and cosine of a part of a turn in Q32, in Q31.
pub fn sin_cos(turn: &i32) -> [i32; 2] {
    let (cosine, sine) = idsp::cossin(*turn);
    [sine, cosine]
}
