//! Other crates' traits: what is stored is read back to the bit or refused, what is logged arrives, what lies in memory
//! is bytes.

use std::sync::Mutex;

use sunglint::real::{Constant, Scaled};
use sunglint::{SUN, DistantLight};

mod logged {
    use super::*;
    static FRAME: Mutex<Vec<u8>> = Mutex::new(Vec::new());

    #[defmt::global_logger]
    struct Captured;

    // SAFETY: one test logs, in one thread; a frame is one write after the other into a vector that is locked for each.
    unsafe impl defmt::Logger for Captured {
        fn acquire() {}
        unsafe fn flush() {}
        unsafe fn release() {}
        unsafe fn write(bytes: &[u8]) {
            FRAME.lock().unwrap().extend(bytes);
        }
    }
    defmt::timestamp!("");

    #[test]
    fn numbers() {
        defmt::info!("{}", sunglint::raw::SUN_Q14);
        println!("{:?} {:x?}", FRAME.lock().unwrap(), sunglint::raw::SUN_Q14.to_array());
        FRAME.lock().unwrap().clear();
        defmt::info!("{}", Constant::new(0.5));
        println!("{:?} ", FRAME.lock().unwrap());
        FRAME.lock().unwrap().clear();
        defmt::info!("{}", Scaled::new(0.5));
        println!("{:?} ", FRAME.lock().unwrap());
        FRAME.lock().unwrap().clear();
        defmt::info!("{}", SUN);
        println!("{:?} ", FRAME.lock().unwrap());
    }
}
