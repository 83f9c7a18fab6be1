//! A planet's materials in the Sun, and which of them is where, without a table or a float.

use sunglint::raw::{PixelQ14, SUN_Q14, surface_q14};

/// Sea, wood, sand, ice: red, green and blue of the albedo, and alpha, in 256ths.
pub const GROUND: [([i32; 3], i32); 4] =
    [([1, 8, 26], 22), ([11, 30, 5], 230), ([84, 48, 15], 230), ([205, 218, 230], 150)];

/// The four in the Sun, which is to the left, a little up, and behind the viewer.
pub fn lit() -> Option<[PixelQ14; 4]> {
    let [sea, wood, sand, ice] = GROUND.map(|(albedo, alpha)| {
        let surface = surface_q14(albedo.map(|part| part << 22), alpha << 22, [5 << 22; 3]).ok()?;
        PixelQ14::new([-10_923, 5461, 10_923], &SUN_Q14, &surface, [10 << 16; 3]).ok()
    });
    Some([sea?, wood?, sand?, ice?])
}

/// Nearly a sine: 65536 is a turn, 16384 is 1.
pub fn wave(turn: i32) -> i32 {
    let turn = i32::from(turn as i16);
    (turn * (32_768 - turn.abs())) >> 14
}

/// Which of the four is in a direction from the planet's middle, in Q14: waves that bend each other.
pub fn ground([x, y, z]: [i32; 3]) -> usize {
    let [p, q, r] = [x + wave(2 * y + 9000) / 2, y + wave(2 * z + 30_000) / 2, z + wave(2 * x + 3000) / 2];
    let coast = wave(5 * p - 3 * q + r) / 2 + wave(6 * q + 5 * r - p) / 3 + wave(9 * (p + q - r)) / 4;
    let height = wave(p + q + 5000) + wave(2 * q - r + 20_000) + wave(p + 2 * r) + coast;
    match y.abs() + coast / 8 {
        14_500.. => 3,
        _ if height < 5000 => 0,
        3000..8000 => 2,
        _ => 1,
    }
}
