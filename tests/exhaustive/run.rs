//! Every input of a kernel on all cores, and where the worst error was.

use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use indicatif::{ProgressBar, ProgressStyle};

/// Inputs that a core takes at a time.
const CHUNK: u64 = 1 << 18;

/// The greatest error and the first input that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    pub error: f64,
    pub bits: u64,
}

const NONE: Worst = Worst { error: 0.0, bits: 0 };

fn worse(a: Worst, b: Worst) -> Worst {
    let greater = b.error > a.error || (b.error == a.error && b.bits < a.bits);
    if greater { b } else { a }
}

fn worst_of(bits: impl Iterator<Item = u64>, error: &(impl Fn(u64) -> f64 + ?Sized)) -> Worst {
    bits.fold(NONE, |worst, bits| {
        let error = error(bits);
        // A NaN, by which judges say that an answer is plainly wrong, is the worst of all.
        let error = if error.is_nan() { f64::INFINITY } else { error.abs() };
        if error > worst.error { Worst { error, bits } } else { worst }
    })
}

/// The worst over `first..=last`, with a bar on stderr.
pub fn worst(title: &str, [first, last]: [u64; 2], error: &(dyn Fn(u64) -> f64 + Sync)) -> Worst {
    let chunks = (last - first) / CHUNK + 1;
    let style = ProgressStyle::with_template("{msg} {bar:30} {percent:>3} %, {eta} left").unwrap();
    let bar = ProgressBar::new(chunks).with_style(style).with_message(title.to_owned());
    let next = AtomicU64::new(0);
    let work = || {
        let mut found = NONE;
        loop {
            let chunk = next.fetch_add(1, Ordering::Relaxed);
            if chunk >= chunks {
                return found;
            }
            let start = first + chunk * CHUNK;
            found = worse(found, worst_of(start..=last.min(start + CHUNK - 1), error));
            bar.inc(1);
        }
    };
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let found = thread::scope(|scope| {
        let threads: Vec<_> = (0..cores).map(|_| scope.spawn(work)).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).fold(NONE, worse)
    });
    bar.finish_and_clear();
    found
}
