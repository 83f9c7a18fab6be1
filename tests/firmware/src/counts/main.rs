//! Prints what calls cost, a line of CSV each: function, format, by, case, inputs, median, worst, stack.
#![no_std]
#![no_main]

#[path = "../calls/mod.rs"]
mod calls;
mod counter;
mod inputs;
mod row;
mod rows;
mod self_test;
mod stack;

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};

use counter::Counter;

#[entry]
fn main() -> ! {
    let counter = Counter::start(cortex_m::Peripherals::take().unwrap().SYST);
    self_test::run(&counter);
    rows::count(&counter);
    end(true)
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
