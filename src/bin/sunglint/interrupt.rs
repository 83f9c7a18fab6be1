//! Ctrl-C: nothing is half written.
//!
//! While nothing is being written, the process ends at once: there is nothing to be undone. While something is, the
//! writer stops at its next file and takes its temporary files away first. Once it has all that it needs and is putting
//! it into place, it is too late, and the run ends as it would have. A second Ctrl-C waits for nothing.

use std::io::{self, Write};
use std::process;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use indicatif::ProgressBar;

use crate::failure::Failure;

/// What is going on.
struct State {
    /// Whether Ctrl-C has come.
    asked: bool,
    /// How many [`Writing`] there are.
    writing: usize,
    /// Whether it is too late to undo anything.
    late: bool,
}

static STATE: Mutex<State> = Mutex::new(State { asked: false, writing: 0, late: false });

/// The bar that has to go before anything is said.
static BAR: OnceLock<ProgressBar> = OnceLock::new();

/// Heeds Ctrl-C from here on. Where the system lets no one do so, its own way of ending the process stays.
pub fn heed() {
    let _ = ctrlc::set_handler(|| {
        let mut state = state();
        if std::mem::replace(&mut state.asked, true) {
            process::exit(Failure::Interrupted.code().into());
        }
        if state.writing == 0 && !state.late {
            // The state stays locked, so that nobody begins to write.
            end();
        }
    });
}

/// Clears `bar` before the message.
pub fn clear(bar: &ProgressBar) {
    let _ = BAR.set(bar.clone());
}

/// Something is being written for as long as this lives. Where Ctrl-C has come in between, the process ends with it.
#[derive(Debug)]
pub struct Writing(());

impl Writing {
    /// Begins to write.
    ///
    /// # Errors
    /// [`io::ErrorKind::Interrupted`] once Ctrl-C has come.
    pub fn begin() -> io::Result<Self> {
        let mut state = state();
        if state.asked {
            return Err(io::ErrorKind::Interrupted.into());
        }
        state.writing += 1;
        Ok(Self(()))
    }

    /// All is ready: from here on nothing is undone.
    ///
    /// # Errors
    /// [`io::ErrorKind::Interrupted`] once Ctrl-C has come.
    pub fn commit(&self) -> io::Result<()> {
        let mut state = state();
        if state.asked {
            return Err(io::ErrorKind::Interrupted.into());
        }
        state.late = true;
        Ok(())
    }
}

impl Drop for Writing {
    fn drop(&mut self) {
        let mut state = state();
        state.writing -= 1;
        if state.asked && state.writing == 0 && !state.late {
            end();
        }
    }
}

fn state() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn end() -> ! {
    if let Some(bar) = BAR.get() {
        bar.finish_and_clear();
    }
    let _ = writeln!(io::stderr(), "sunglint: {}", Failure::Interrupted);
    process::exit(Failure::Interrupted.code().into())
}
