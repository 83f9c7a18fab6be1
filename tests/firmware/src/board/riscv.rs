//! QEMU's `virt` machine of RISC-V: start, text and end, in a few instructions.

use core::arch::{asm, global_asm};
use core::fmt::{Arguments, Result, Write};

// QEMU starts at the beginning of the RAM, which it has cleared and where riscv.x puts this.
global_asm!(".section .init", ".global _start", "_start:", "la sp, top_of_stack", "j start", ".text");

#[unsafe(no_mangle)]
extern "C" fn start() -> ! {
    crate::run()
}

/// Prints on the host.
pub fn print(text: Arguments) {
    let _ = Host.write_fmt(text);
}

/// Ends the emulator.
pub fn end(success: bool) -> ! {
    const EXIT: usize = 0x18;
    const APPLICATION_EXIT: usize = 0x2_0026;
    const RUN_TIME_ERROR: usize = 0x2_0023;
    loop {
        ask(EXIT, if success { APPLICATION_EXIT } else { RUN_TIME_ERROR });
    }
}

struct Host;

impl Write for Host {
    fn write_str(&mut self, text: &str) -> Result {
        const WRITE_CHARACTER: usize = 3;
        for byte in text.as_bytes() {
            ask(WRITE_CHARACTER, core::ptr::from_ref(byte).expose_provenance());
        }
        Ok(())
    }
}

/// Semihosting: the three instructions that the emulator knows a question by.
fn ask(operation: usize, parameter: usize) {
    // The host reads what the parameter points at, and writes nothing.
    unsafe {
        asm!(
            ".option push",
            ".option norvc",
            ".balign 16",
            "slli x0, x0, 0x1f",
            "ebreak",
            "srai x0, x0, 7",
            ".option pop",
            inout("a0") operation => _,
            in("a1") parameter,
            options(nostack),
        );
    }
}
