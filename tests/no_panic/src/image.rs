//! What makes a panic fail to link.

use core::hint::black_box;
use core::panic::PanicInfo;

unsafe extern "C" {
    safe fn there_is_a_panic() -> !;
}

#[panic_handler]
fn panicked(_: &PanicInfo) -> ! {
    there_is_a_panic()
}

/// Makes the compiler compute `answer`.
pub fn keep<T>(answer: T) {
    let _ = black_box(answer);
}

/// What shows that a panic is found.
pub fn plant() {
    #[cfg(feature = "planted_panic")]
    keep(black_box([0; 3])[black_box(0_usize)]);
    #[cfg(feature = "planted_float")]
    keep(black_box(1.0_f64) + black_box(2.0_f64));
}
