//! Computes the digests and compares them with the host's; ends with success only if all are the same.
#![no_std]
#![no_main]

#[cfg_attr(target_arch = "arm", path = "board/cortex_m.rs")]
#[cfg_attr(target_arch = "riscv32", path = "board/riscv.rs")]
mod board;

use core::panic::PanicInfo;

use board::{end, print};
use sunglint::trial::digest::{CASES, FIXED_POINT, FLOATS};

/// What a board calls once it has started.
fn run() -> ! {
    let mut differ = 0;
    for digester in FIXED_POINT.iter().chain(&FLOATS) {
        let digest = digester.digest(CASES);
        let same = digest.hash == digester.expected[0];
        let verdict = if same { "as on the host" } else { "NOT as on the host" };
        let (name, hash, results) = (digester.name, digest.hash, digest.results);
        print(format_args!("{name:9} {hash:#018x} of {results} results, {verdict}\n"));
        differ += u32::from(!same);
    }
    end(differ == 0)
}

#[panic_handler]
fn panicked(info: &PanicInfo) -> ! {
    print(format_args!("{info}\n"));
    end(false)
}
