//! Hashes of results on inputs that any language makes alike: xorshift of 32 bits for the lanes, FNV-1a of 32 bits over the
//! results, lane by lane and least byte first.

mod directions;
mod pixel;
mod quantities;
mod sampling;
mod soft;
mod status;

use sunglint::raw::{SUN_Q14, cap_q14, normalize_q14, reflect_q14};

/// Cases of each group.
pub const CASES: u32 = 4096;

/// Where every group's inputs begin.
pub const SEED: u32 = 0x5eed_5eed;

/// A group of functions by its name, and the hash of its results.
pub type Group = (&'static str, fn() -> u32);

/// Hashes of groups of functions, by the names that other languages print them under.
pub const GROUPS: [Group; 9] = [
    ("directions_q14", directions_q14),
    ("directions_q30", directions::q30),
    ("lights", directions::lights),
    ("diffuse", quantities::diffuse),
    ("sampling", sampling::hash),
    ("radiometry", quantities::radiometry),
    ("black_bodies", quantities::black_bodies),
    ("pixel", pixel::hash),
    ("soft", soft::hash),
];

/// Inputs: `x ^= x << 13; x ^= x >> 17; x ^= x << 5`.
pub struct Source(u32);

impl Source {
    /// The one that every group begins with.
    #[expect(clippy::new_without_default, reason = "the seed is part of what is compared")]
    pub fn new() -> Self {
        Self(SEED)
    }

    /// The next 32 bits.
    pub fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// Three lanes of any value: the upper halves of the next three.
    pub fn lanes_q14(&mut self) -> [i16; 3] {
        [0; 3].map(|_: i16| (self.bits() >> 16) as i16)
    }

    /// One such lane.
    pub fn lane_q14(&mut self) -> i16 {
        (self.bits() >> 16) as i16
    }

    /// Three lanes of any value.
    pub fn lanes_q30(&mut self) -> [i32; 3] {
        [0; 3].map(|_: i32| self.bits() as i32)
    }

    /// A number of any size: 32 bits, shifted down by the lowest 5 of the next.
    pub fn size(&mut self) -> u32 {
        let bits = self.bits();
        bits >> (self.bits() & 31)
    }

    /// Such a number or its complement.
    pub fn signed(&mut self) -> i32 {
        let size = self.size();
        (size ^ (self.bits() & 1).wrapping_neg()) as i32
    }

    /// A number of any size: 64 bits, the upper ones first, shifted down by the lowest 6 of the next.
    pub fn wide(&mut self) -> u64 {
        let upper = u64::from(self.bits()) << 32;
        let bits = upper | u64::from(self.bits());
        bits >> (self.bits() & 63)
    }

    /// Such a number or its complement.
    pub fn signed_wide(&mut self) -> i64 {
        let size = self.wide();
        (size ^ u64::from(self.bits() & 1).wrapping_neg()) as i64
    }

    /// Radius over distance in Q30, of any size from 0 to 1.
    pub fn ratio(&mut self) -> i32 {
        (self.size() >> 2) as i32
    }
}

/// FNV-1a of 32 bits.
pub struct Hash(pub u32);

impl Hash {
    /// Of nothing.
    #[expect(clippy::new_without_default, reason = "0 is another hash")]
    pub fn new() -> Self {
        Self(0x811c_9dc5)
    }

    /// Takes in bytes, of a number the least first.
    pub fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    }

    /// Takes in three lanes.
    pub fn add_q14(&mut self, lanes: [i16; 3]) {
        lanes.into_iter().for_each(|lane| self.add(&lane.to_le_bytes()));
    }

    /// Takes in three lanes.
    pub fn add_q30(&mut self, lanes: [i32; 3]) {
        lanes.into_iter().for_each(|lane| self.add_32(lane as u32));
    }

    /// Takes in 32 bits.
    pub fn add_32(&mut self, bits: u32) {
        self.add(&bits.to_le_bytes());
    }

    /// Takes in 64 bits.
    pub fn add_64(&mut self, bits: u64) {
        self.add(&bits.to_le_bytes());
    }
}

/// Normal, viewer and light from any lanes; then the mirror ray and what of the Sun is nearest to it.
pub fn directions_q14() -> u32 {
    let (mut source, mut hash) = (Source::new(), Hash::new());
    for _ in 0..CASES {
        let [n, v, l] = [0; 3].map(|_: u8| normalize_q14(source.lanes_q14()));
        let r = reflect_q14(n, v);
        [n, v, l, r, cap_q14(l, r, &SUN_Q14)].into_iter().for_each(|lanes| hash.add_q14(lanes));
    }
    hash.0
}
