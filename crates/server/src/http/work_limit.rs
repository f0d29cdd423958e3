use super::answer::Refused;
use axum::http::StatusCode;
use seamwright_executive::realtime::contained;
use seamwright_message::Message;
use std::sync::Arc;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot};

/// Limits long work in separate threads: a number running, a number waiting; further work is refused. The cycle needs
/// its share of the processor.
pub(crate) struct Turns {
    places: Arc<Semaphore>,
    running: Arc<Semaphore>,
}

/// A turn, which ends when dropped.
pub(crate) struct Turn(#[allow(dead_code, reason = "held")] [OwnedSemaphorePermit; 2]);

impl Turns {
    pub(crate) fn new(at_once: usize, waiting: usize) -> Self {
        Self { places: Arc::new(Semaphore::new(at_once + waiting)), running: Arc::new(Semaphore::new(at_once)) }
    }

    /// Takes a turn if one is free.
    pub(crate) fn now(&self) -> Option<Turn> {
        let place = Arc::clone(&self.places).try_acquire_owned().ok()?;
        Some(Turn([place, Arc::clone(&self.running).try_acquire_owned().ok()?]))
    }

    async fn take(&self) -> Result<Turn, Refused> {
        let busy = |_| Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", Message::new("server-slow-down"));
        let place = Arc::clone(&self.places).try_acquire_owned().map_err(busy)?;
        let turn = Arc::clone(&self.running).acquire_owned().await;
        Ok(Turn([place, turn.map_err(|_| Refused::server(Message::new("server-panel-ends")))?]))
    }

    /// Runs `work` in its turn, in a separate thread with lower priority than the cycle's. The turn lasts until the
    /// work is done, even if its caller has gone.
    /// Fails if too many wait, or the work fails.
    pub(crate) async fn run<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> Result<T, Refused> + Send + 'static,
    ) -> Result<T, Refused> {
        let turn = self.take().await?;
        let (answer, answered) = oneshot::channel();
        let run = move || {
            lower_priority();
            // A panic in a plan costs its answer, not the cell.
            let fault = |_| Err(Refused::server(Message::new("server-program-fault")));
            let result = contained(work).unwrap_or_else(fault);
            // Freed first: the receiver of the answer may take the next turn.
            drop(turn);
            // The caller may have gone.
            drop(answer.send(result));
        };
        let spawned = std::thread::Builder::new().name("panel-work".to_owned()).spawn(run);
        spawned.map_err(|e| Refused::server(Message::new("server-no-thread").text("why", e.to_string())))?;
        answered.await.map_err(|_| Refused::server(Message::new("server-failed")))?
    }
}

/// Priority reduction of these threads (`nice`).
#[cfg(target_os = "linux")]
const NICE: i32 = 10;

/// Lowers the priority of the calling thread, on systems with thread priorities.
fn lower_priority() {
    // A refused priority does not change results.
    #[cfg(target_os = "linux")]
    let _ = rustix::process::setpriority_process(None, NICE);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Duration;

    /// Cancelled requests do not free their turn early: the work still completes.
    #[tokio::test(flavor = "multi_thread", worker_threads = 2)]
    async fn work_that_nobody_waits_for_still_has_its_turn() {
        let turns = Arc::new(Turns::new(2, 3));
        let (now, most) = (Arc::new(AtomicUsize::new(0)), Arc::new(AtomicUsize::new(0)));
        let mut refused = 0;
        for _ in 0..40 {
            let (now, most) = (Arc::clone(&now), Arc::clone(&most));
            let work = turns.run(move || {
                most.fetch_max(now.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
                std::thread::sleep(Duration::from_millis(20));
                now.fetch_sub(1, Ordering::SeqCst);
                Ok(())
            });
            // Cancelled after a moment.
            drop(tokio::time::timeout(Duration::from_millis(1), work).await);
        }
        let all: Vec<_> = (0..12).map(|_| Arc::clone(&turns)).collect();
        let asked = all.iter().map(|turns| {
            turns.run(|| {
                std::thread::sleep(Duration::from_millis(20));
                Ok(())
            })
        });
        for answer in futures_util::future::join_all(asked).await {
            refused += usize::from(answer.is_err_and(|e| e.status == StatusCode::SERVICE_UNAVAILABLE));
        }
        assert!(most.load(Ordering::SeqCst) <= 2 && refused >= 7, "{most:?} {refused}");
    }
}
