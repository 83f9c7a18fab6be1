//! Draws the ball at some turns and writes the frames to `frames.rgb565` on the host, two bytes a pixel, low one first.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m::singleton;
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln, nr, syscall};
use lcd::display::{Frame, TURNS};
use lcd::{ball, planet};

#[entry]
fn main() -> ! {
    let frame = singleton!(: Frame = Frame::new()).unwrap();
    let lit = planet::lit().unwrap();
    let file = Host::create(c"frames.rgb565");
    for turn in TURNS {
        ball::draw(frame, &lit, turn).unwrap();
        file.write(frame.data());
    }
    end(true)
}

/// A file on the host.
struct Host(usize);

impl Host {
    fn create(name: &core::ffi::CStr) -> Self {
        // The name's length is without the zero that ends it.
        let handle = unsafe { syscall!(OPEN, name.as_ptr(), nr::open::W_TRUNC_BINARY, name.count_bytes()) };
        assert!(handle != usize::MAX, "the host does not open {name:?}");
        Self(handle)
    }

    fn write(&self, bytes: &[u8]) {
        let left = unsafe { syscall!(WRITE, self.0, bytes.as_ptr(), bytes.len()) };
        assert!(left == 0, "the host has not written {left} bytes");
    }
}

#[panic_handler]
fn panicked(info: &PanicInfo) -> ! {
    hprintln!("{}", info);
    end(false)
}

fn end(success: bool) -> ! {
    debug::exit(if success { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        core::hint::spin_loop();
    }
}
