//! Bytes of a linked file by its section headers.

use std::path::Path;

const ALLOCATED: u32 = 2;

const EXECUTABLE: u32 = 4;

const WRITABLE: u32 = 1;

/// Names of sections that tell how to unwind, which no one does.
const UNWINDING: &str = ".ARM.ex";

/// Code, and what code reads: tables and constants.
pub fn bytes(path: &Path) -> [u32; 2] {
    let file = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert_eq!(file[..6], *b"\x7fELF\x01\x01", "{}: neither 32 bits nor little endian", path.display());
    let sections = half(&file, 48);
    let header = |index: u32| word(&file, 32) + index * half(&file, 46);
    let names = word(&file, header(half(&file, 50)) + 16);
    let mut bytes = [0; 2];
    for section in (0..sections).map(header) {
        let (flags, size) = (word(&file, section + 8), word(&file, section + 20));
        let name = &file[(names + word(&file, section)) as usize..];
        if flags & ALLOCATED == 0 || name.starts_with(UNWINDING.as_bytes()) {
            continue;
        }
        assert!(flags & WRITABLE == 0 || size == 0, "{}: a function has variables", path.display());
        bytes[usize::from(flags & EXECUTABLE == 0)] += size;
    }
    assert!(bytes[0] > 0, "{}: bytes.rs exports no such function", path.display());
    bytes
}

fn half(file: &[u8], offset: u32) -> u32 {
    let offset = offset as usize;
    u16::from_le_bytes([file[offset], file[offset + 1]]).into()
}

fn word(file: &[u8], offset: u32) -> u32 {
    half(file, offset) | half(file, offset + 2) << 16
}
