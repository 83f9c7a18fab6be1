//! The RAM of an emulated machine, which is a file: painted and filled before, read after.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Of the file.
const SIZE: u64 = 16 << 20;

/// Where the stack begins, downwards.
const STACK: u64 = 4 << 20;

/// As the crate `minimal` has it.
const DIRECTIONS: u64 = 8 << 20;

/// As the crate `minimal` has it.
const ANSWERS: u64 = 12 << 20;

/// More than any image takes.
const PAINTED: u64 = 16 << 10;

/// No address, small number or float of a direction.
const PAINT: [u8; 4] = 0xa5c3_5ac3_u32.to_le_bytes();

/// What an image leaves.
pub struct Outcome {
    /// Bytes of stack at the deepest.
    pub stack: u32,
    /// From the first answer on.
    pub answers: Vec<u8>,
}

/// Paints the stack and puts the directions where the image reads them.
pub fn prepare(path: &Path, directions: &[u8]) {
    let fill = || {
        let mut file = File::create(path)?;
        file.set_len(SIZE)?;
        file.seek(SeekFrom::Start(STACK - PAINTED))?;
        file.write_all(&PAINT.repeat(PAINTED as usize / PAINT.len()))?;
        file.seek(SeekFrom::Start(DIRECTIONS))?;
        file.write_all(directions)
    };
    fill().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

/// What the image has left.
pub fn read(path: &Path) -> Outcome {
    let read = |start, length| {
        let mut bytes = vec![0; length];
        let mut file = File::open(path)?;
        file.seek(SeekFrom::Start(start))?;
        file.read_exact(&mut bytes).map(|()| bytes)
    };
    let expect = |read: std::io::Result<Vec<u8>>| read.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let stack = expect(read(STACK - PAINTED, PAINTED as usize));
    let free = stack.chunks(PAINT.len()).take_while(|word| **word == PAINT).count() * PAINT.len();
    assert!(free > 0, "more stack than is painted");
    Outcome { stack: (stack.len() - free) as u32, answers: expect(read(ANSWERS, 16 << 10)) }
}
