//! Work by several threads.

use seamwright_project::failure::Failure;
use std::sync::mpsc::{Receiver, sync_channel};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Pieces of work that wait for a thread, for each thread.
const WAITING: usize = 4;

/// Calls `work` for every piece that `feed` sends, in `threads` threads. Sending returns false after a fault: then `feed`
/// should end.
///
/// # Errors
/// Those of `feed`, and the first one of `work`.
pub(crate) fn in_threads<W: Send>(
    threads: usize,
    work: &(dyn Fn(W) -> Result<(), Failure> + Sync),
    feed: impl FnOnce(&dyn Fn(W) -> bool) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let threads = threads.max(1);
    let (send, receive) = sync_channel::<W>(WAITING * threads);
    let receive = Mutex::new(receive);
    let fault: Mutex<Option<Failure>> = Mutex::new(None);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                // After a fault the pieces that wait are thrown away, so that the feeder does not block.
                while let Some(piece) = next(&receive) {
                    if locked(&fault).is_some() {
                        continue;
                    }
                    if let Err(failure) = work(piece) {
                        let _ = locked(&fault).get_or_insert(failure);
                    }
                }
            });
        }
        let fed = feed(&|piece| locked(&fault).is_none() && send.send(piece).is_ok());
        drop(send);
        fed
    })?;
    let fault = locked(&fault).take();
    fault.map_or(Ok(()), Err)
}

/// The next piece, or none when there are no more.
fn next<W>(receive: &Mutex<Receiver<W>>) -> Option<W> {
    locked(receive).recv().ok()
}

/// The value of a lock. A thread that panicked with it has left a whole value.
pub(crate) fn locked<T>(lock: &Mutex<T>) -> MutexGuard<'_, T> {
    lock.lock().unwrap_or_else(PoisonError::into_inner)
}
