//! Counts the instructions of a call by SysTick, which under QEMU's `-icount shift=0` advances by one every 40
//! instructions, and how deep the stack goes.

use core::hint::black_box;
use core::mem::MaybeUninit;

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// What the boards' 25 MHz are of QEMU's 1000 million instructions a second.
const INSTRUCTIONS_A_TICK: u32 = 40;

/// The call and the return, which the empty function has too.
const CALL: u32 = 2;

/// A function of an input; what it gives may be anything where nothing was computed.
pub type Call<I, O> = fn(&I) -> MaybeUninit<O>;

/// Starts SysTick.
pub fn start(mut systick: SYST) {
    systick.set_clock_source(SystClkSource::Core);
    systick.set_reload(0xff_ffff);
    systick.clear_current();
    systick.enable_counter();
}

/// Instructions of `call` on `input`, from the call to the return.
pub fn instructions<I, O>(call: Call<I, O>, input: &I) -> u32 {
    let once = difference(call, input, 1);
    // A tick is less than half an instruction, or than half a per cent.
    let calls = (INSTRUCTIONS_A_TICK * 200 / once.max(40)).clamp(1, 100);
    let counted = difference(call, input, calls);
    (counted + calls / 2) / calls + CALL
}

/// What `calls` of them take beyond as many of the empty function.
fn difference<I, O>(call: Call<I, O>, input: &I, calls: u32) -> u32 {
    let [own, empty] = [call, nothing].map(|call| ticks(call, input, calls));
    own.saturating_sub(empty) * INSTRUCTIONS_A_TICK
}

fn nothing<I, O>(_: &I) -> MaybeUninit<O> {
    MaybeUninit::uninit()
}

#[inline(never)]
fn ticks<I, O>(call: Call<I, O>, input: &I, calls: u32) -> u32 {
    let call = black_box(call);
    // The next tick has just come.
    let before = SYST::get_current();
    while SYST::get_current() == before {}
    let start = SYST::get_current();
    for _ in 0..calls {
        black_box(call(black_box(input)));
    }
    start.wrapping_sub(SYST::get_current()) & 0xff_ffff
}
