//! The functions that are counted and whose bytes are: plain ones, of an input that lies in memory.

pub mod by_hand;
pub mod directions;
pub mod highlights;
pub mod sampling;
pub mod vectors;
