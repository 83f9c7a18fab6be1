//! In the place of the library: a function that may panic, which a check has to find.
#![no_std]

#[repr(C)]
pub struct Vector {
    lanes: [i16; 3],
}

#[repr(C)]
pub struct Sphere {
    constants: [i32; 4],
}

/// # Panics
/// Unless the first lane of `l` is that of one of `r`'s lanes.
#[unsafe(no_mangle)]
pub extern "C" fn sunglint_cap_q14(l: Vector, r: Vector, _: Sphere) -> Vector {
    Vector { lanes: [r.lanes[l.lanes[0] as usize]; 3] }
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
