//! Computes the digests and compares them with the host's; ends with success only if all are the same.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use sunglint::trial::digest::{CASES, FIXED_POINT, FLOATS};

#[entry]
fn main() -> ! {
    let mut differ = 0;
    for digester in FIXED_POINT.iter().chain(&FLOATS) {
        let digest = digester.digest(CASES);
        let same = digest.hash == digester.expected[0];
        let verdict = if same { "as on the host" } else { "NOT as on the host" };
        hprintln!("{:9} {:#018x} of {} results, {}", digester.name, digest.hash, digest.results, verdict);
        differ += u32::from(!same);
    }
    end(differ == 0)
}

#[panic_handler]
fn panicked(info: &PanicInfo) -> ! {
    hprintln!("{}", info);
    end(false)
}

fn end(success: bool) -> ! {
    debug::exit(if success { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {}
}
