//! Counts the instructions of a call, to the instruction.
//!
//! Under QEMU's `-icount shift=0` time is instructions, but SysTick advances by one every 40 of them. A loop of 41
//! instructions that reads it once sees it advance by two exactly when the reading is at the beginning of a tick, so
//! that loop before the call and after it tells the time to the instruction, as a vernier does.

use core::arch::{asm, global_asm};
use core::hint::black_box;
use core::mem::{MaybeUninit, transmute};

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// What the boards' 25 MHz are of QEMU's 1000 million instructions a second.
const INSTRUCTIONS_A_TICK: u32 = 40;

/// Instructions of the loop that waits for a tick.
const INSTRUCTIONS_A_LOOP: u32 = INSTRUCTIONS_A_TICK + 1;

/// The call and the return, which the empty function has too.
const CALL: u32 = 2;

/// A function of an input; what it gives may be anything where nothing was computed.
pub type Call<I, O> = fn(&I) -> MaybeUninit<O>;

/// SysTick, running.
pub struct Counter(());

impl Counter {
    /// Starts it.
    pub fn start(mut systick: SYST) -> Self {
        systick.set_clock_source(SystClkSource::Core);
        systick.set_reload(0xff_ffff);
        systick.clear_current();
        systick.enable_counter();
        Self(())
    }

    /// Instructions of `call` on `input`, from the call to the return: at most 600 million.
    pub fn instructions<I, O>(&self, call: Call<I, O>, input: &I) -> u32 {
        let [own, empty] = [call, nothing()].map(|call| elapsed(call, input));
        own - empty + CALL
    }
}

// By hand, since the compiler gives every function a frame on these targets.
global_asm!(".global nothing", ".type nothing, %function", ".thumb_func", "nothing:", "bx lr");

unsafe extern "C" {
    #[link_name = "nothing"]
    safe fn only_returns();
}

/// A function that returns and does nothing else.
pub fn nothing<I, O>() -> Call<I, O> {
    // It leaves the result as it is wherever that may be, which is uninitialised.
    unsafe { transmute::<extern "C" fn(), Call<I, O>>(only_returns) }
}

/// Instructions from the beginning of a tick to that of the first loop after the call.
#[inline(never)]
fn elapsed<I, O>(call: Call<I, O>, input: &I) -> u32 {
    let call = black_box(call);
    let start = wait_for_tick();
    black_box(call(black_box(input)));
    let end = wait_for_tick();
    // It counts down, in 24 bits.
    let ticks = start.tick.wrapping_sub(end.tick) & 0xff_ffff;
    ticks * INSTRUCTIONS_A_TICK - end.loops * INSTRUCTIONS_A_LOOP
}

/// The beginning of a tick, and how many loops before it the waiting began.
struct Moment {
    tick: u32,
    loops: u32,
}

#[inline(always)]
fn wait_for_tick() -> Moment {
    let (tick, loops): (u32, u32);
    // Reading SysTick has no effect but that of taking time.
    unsafe {
        asm!(
            "ldr {now}, [{systick}]",
            // What the loop has after its reading.
            "nop",
            "nop",
            "nop",
            "nop",
            "2:",
            "mov {before}, {now}",
            ".rept 34",
            "nop",
            ".endr",
            "adds {loops}, #1",
            "ldr {now}, [{systick}]",
            "subs {before}, {before}, {now}",
            "lsls {before}, {before}, #8",
            "cmp {before}, {one}",
            "beq 2b",
            systick = in(reg) &raw const (*SYST::PTR).cvr,
            one = in(reg) 1 << 8,
            loops = inout(reg) 0 => loops,
            now = out(reg) tick,
            before = out(reg) _,
            options(nostack),
        );
    }
    Moment { tick, loops }
}
