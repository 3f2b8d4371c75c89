//! Many independent jobs on several threads.
//!
//! One rayon pool for both the jobs and the loops within them would let a job that waits for its own loop take up
//! another whole job: its time would be counted twice, and waiting jobs would pile up on one stack. So each worker is
//! a thread of its own with a small pool for the loops of its job.

use super::CliError;
use rayon::ThreadPoolBuilder;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// How often progress is told while no job finishes.
const PULSE: Duration = Duration::from_millis(250);

/// Results of jobs 0 to `count`, in that order, worked on by `threads` threads, at most `abreast` of them at a time;
/// `done` hears how many are finished, at least once a [`PULSE`], and sees each result once, as soon as it is there.
///
/// # Errors
/// That of the first job, by its number, that failed; later jobs are not begun then. The first of `done`.
pub(super) fn in_parallel<T: Send>(
    count: usize,
    (threads, abreast): (usize, usize),
    job: impl Fn(usize) -> Result<T, CliError> + Sync,
    mut done: impl FnMut(u64, Option<&T>) -> Result<(), CliError>,
) -> Result<Vec<T>, CliError> {
    let workers = threads.min(abreast).clamp(1, count.max(1));
    let inner = (threads / workers).max(1);
    let pools = (0..workers).map(|_| ThreadPoolBuilder::new().num_threads(inner).build());
    let pools = pools.collect::<Result<Vec<_>, _>>()?;
    let queue = Queue { next: AtomicUsize::new(0), count, failed: AtomicBool::new(false) };
    let mut refused = None;
    let mut results: Vec<Option<Result<T, CliError>>> = (0..count).map(|_| None).collect();
    thread::scope(|scope| {
        let (sender, receiver) = channel();
        for pool in &pools {
            let (queue, job, sender) = (&queue, &job, sender.clone());
            scope.spawn(move || pool.install(|| queue.work(job, &sender)));
        }
        // The loop below ends when the last worker drops its own sender.
        drop(sender);
        let mut finished = 0;
        loop {
            let seen = match receiver.recv_timeout(PULSE) {
                Ok((index, result)) => {
                    finished += 1;
                    let result = &*results[index].insert(result);
                    done(finished, result.as_ref().ok())
                }
                Err(RecvTimeoutError::Timeout) => done(finished, None),
                Err(RecvTimeoutError::Disconnected) => break,
            };
            if let Err(error) = seen {
                queue.failed.store(true, Ordering::Relaxed);
                refused.get_or_insert(error);
            }
        }
    });
    if let Some(error) = refused {
        return Err(error);
    }
    // Jobs are begun in order and finish once begun: whatever was left out comes after a failure.
    results.into_iter().flatten().collect()
}

struct Queue {
    next: AtomicUsize,
    count: usize,
    failed: AtomicBool,
}

impl Queue {
    /// Takes jobs until none is left or one has failed.
    fn work<T>(
        &self,
        job: &(impl Fn(usize) -> Result<T, CliError> + Sync),
        results: &Sender<(usize, Result<T, CliError>)>,
    ) {
        while !self.failed.load(Ordering::Relaxed) {
            let index = self.next.fetch_add(1, Ordering::Relaxed);
            if index >= self.count {
                return;
            }
            let result = job(index);
            if result.is_err() {
                self.failed.store(true, Ordering::Relaxed);
            }
            if results.send((index, result)).is_err() {
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_on_any_number_of_threads() {
        for threads in [1, 2, 5] {
            let mut heard = 0;
            let squares = in_parallel(
                20,
                (threads, 3),
                |k| Ok(k * k),
                |finished, _| {
                    heard = finished;
                    Ok(())
                },
            )
            .unwrap();
            assert_eq!(squares, (0..20).map(|k| k * k).collect::<Vec<_>>());
            assert_eq!(heard, 20);
        }
        assert_eq!(in_parallel(0, (4, 4), Ok, |_, _| Ok(())).unwrap(), Vec::<usize>::new());
    }

    #[test]
    fn no_more_jobs_are_worked_on_at_a_time_than_may_be() {
        for (threads, abreast, most) in [(4, 1, 1), (4, 2, 2), (2, 8, 2)] {
            let (now, ever) = (AtomicUsize::new(0), AtomicUsize::new(0));
            let job = |_| {
                ever.fetch_max(1 + now.fetch_add(1, Ordering::SeqCst), Ordering::SeqCst);
                let inner = rayon::current_num_threads();
                now.fetch_sub(1, Ordering::SeqCst);
                Ok(inner)
            };
            let inner = in_parallel(40, (threads, abreast), job, |_, _| Ok(())).unwrap();
            assert!(ever.into_inner() <= most, "{threads}, {abreast}");
            // Threads that no job may take help with the loops of those that run.
            assert!(inner.iter().all(|inner| *inner == threads / most), "{threads}, {abreast}");
        }
    }

    #[test]
    fn the_first_failure_counts() {
        let job = |k: usize| if k < 3 { Ok(k) } else { Err(CliError::VariedTwice { pointer: k.to_string() }) };
        for threads in [1, 3] {
            let failed = in_parallel(50, (threads, threads), job, |_, _| Ok(()));
            assert!(matches!(failed, Err(CliError::VariedTwice { pointer }) if pointer == "3"));
        }
    }
}
