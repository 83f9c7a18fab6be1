//! What the images have in common: reset, where directions come from and answers go, and the end.
#![no_std]

use core::arch::{asm, global_asm};
use core::panic::PanicInfo;
use core::ptr::with_exposed_provenance_mut;

use sunglint::highlight::DiscGgx;
use sunglint::material::{Material, Surface};
use sunglint::scene::{Lamp, Scene};
use sunglint::{DistantSphere, Real};

/// How many inputs there are.
const INPUTS: usize = 512;

/// Beyond what the linker knows of.
const RAM: usize = if cfg!(target_arch = "arm") { 0x2100_0000 } else { 0x8000_0000 };

/// Where a driver would read its sensors. The stack is what lies 4 MB lower.
const DIRECTIONS: usize = RAM + (8 << 20);

/// Where it would put what it has computed.
const ANSWERS: usize = RAM + (12 << 20);

// An FPU is off after reset.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
global_asm!(
    ".section .text.reset",
    ".global reset",
    ".type reset, %function",
    ".thumb_func",
    "reset:",
    "ldr r0, =0xe000ed88",
    "ldr r1, [r0]",
    "orr r1, #0xf00000",
    "str r1, [r0]",
    "dsb",
    "isb",
    "bl main",
    ".text",
);
#[cfg(all(target_arch = "arm", not(target_abi = "eabihf")))]
global_asm!(
    ".section .text.reset",
    ".global reset",
    ".type reset, %function",
    ".thumb_func",
    "reset:",
    "bl main",
    ".text"
);
#[cfg(target_arch = "riscv32")]
global_asm!(".section .text.reset", ".global reset", "reset:", "lui sp, 0x80400", "j main", ".text");

/// Answers all inputs, a normal and two directions each, by three numbers, and ends.
#[inline(always)]
pub fn run<T: Copy, A: Copy>(answer: impl Fn([T; 3], [T; 3], [T; 3]) -> [A; 3]) -> ! {
    let directions = with_exposed_provenance_mut::<T>(DIRECTIONS);
    let answers = with_exposed_provenance_mut::<A>(ANSWERS);
    for input in 0..INPUTS {
        // Nobody else's memory: see link.x.
        let lane = |index| unsafe { directions.add(9 * input + index).read_volatile() };
        let n = [lane(0), lane(1), lane(2)];
        let v = [lane(3), lane(4), lane(5)];
        let l = [lane(6), lane(7), lane(8)];
        let [x, y, z] = answer(n, v, l);
        // As above.
        let give = |index, value| unsafe { answers.add(3 * input + index).write_volatile(value) };
        give(0, x);
        give(1, y);
        give(2, z);
    }
    end()
}

/// What pixels are of: the README's sea.
pub const SEA: Material = match Material::new([0.01, 0.03, 0.05], 0.02, [0.02; 3]) {
    Ok(sea) => sea,
    Err(_) => panic!("reflectances are from 0 to 1, alpha is 0 or from 5e-4 to 1"),
};

/// Answers all inputs, of which it takes the normal and the direction to the viewer, by the sea's colour under a light.
#[inline(always)]
pub fn shade<T: Real>(direction: [T; 3], sphere: &DistantSphere<T>, illuminance: [T::Level; 3]) -> ! {
    let mut scene = Scene::<T, 1, DiscGgx<T>>::with_highlight(&Surface::of(&SEA), DiscGgx::new);
    match Lamp::new(direction, *sphere, illuminance).and_then(|lamp| scene.push(&lamp)) {
        Ok(()) => run(|n, v, _| scene.shade(n, v)),
        Err(_) => end(),
    }
}

/// Ends the emulator: two or three instructions.
#[cfg(target_arch = "arm")]
pub fn end() -> ! {
    // The host is told that the application has exited, and does not return.
    unsafe { asm!("bkpt 0xab", in("r0") 0x18, in("r1") 0x2_0026, options(noreturn)) }
}

/// Ends the emulator: the three instructions that it knows a question by.
#[cfg(target_arch = "riscv32")]
pub fn end() -> ! {
    // As above.
    unsafe {
        asm!(
            ".option push",
            ".option norvc",
            ".balign 16",
            "slli x0, x0, 0x1f",
            "ebreak",
            "srai x0, x0, 7",
            ".option pop",
            in("a0") 0x18,
            in("a1") 0x2_0026,
            options(noreturn),
        )
    }
}

/// A panic that survives fails to link.
#[panic_handler]
fn panicked(_: &PanicInfo) -> ! {
    unsafe extern "C" {
        safe fn there_is_a_panic() -> !;
    }
    there_is_a_panic()
}
