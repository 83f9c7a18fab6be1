//! Work shared out over all cores.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use indicatif::ProgressBar;

/// What `job` makes of each of `items`, each done by whichever core is free next; a step of `progress` each.
pub fn map<I: Sync, O: Send>(items: &[I], progress: &ProgressBar, job: impl Fn(&I) -> O + Sync) -> Vec<O> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(items.iter().map(|_| None).collect::<Vec<_>>());
    let work = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else { break };
            let result = job(item);
            results.lock().unwrap_or_else(PoisonError::into_inner)[index] = Some(result);
            progress.inc(1);
        }
    };
    let others = thread::available_parallelism().map_or(0, |cores| cores.get() - 1);
    thread::scope(|scope| {
        // A thread that cannot be had leaves its work to the rest.
        (0..others).for_each(|_| drop(thread::Builder::new().spawn_scoped(scope, work)));
        work();
    });
    results.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_keep_the_order_of_the_items() {
        let items: Vec<u32> = (0..1000).collect();
        let progress = ProgressBar::hidden();
        let squares = map(&items, &progress, |item| item * item);
        assert_eq!(squares, items.iter().map(|item| item * item).collect::<Vec<_>>());
        assert_eq!(progress.position(), 1000);
    }
}
