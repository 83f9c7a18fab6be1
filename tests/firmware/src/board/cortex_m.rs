//! Arm's MPS2 boards: start, text and end, by the crates for them.

use core::fmt::Arguments;

use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprint};

#[entry]
fn main() -> ! {
    crate::run()
}

/// Prints on the host.
pub fn print(text: Arguments) {
    hprint!("{}", text);
}

/// Ends the emulator.
pub fn end(success: bool) -> ! {
    debug::exit(if success { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        core::hint::spin_loop();
    }
}
