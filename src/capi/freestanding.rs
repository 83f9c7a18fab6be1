//! What a library has that is linked into a program of another language: an answer to panics, of which there are none.

use core::panic::PanicInfo;

#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    loop {}
}
