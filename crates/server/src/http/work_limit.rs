use super::answer::Refused;
use crate::limits::Queue;
use crate::users::Session;
use crate::wire::Role;
use axum::http::StatusCode;
use seamwright_executive::realtime::contained;
use seamwright_message::Message;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot};

tokio::task_local! {
    /// User of the request that the current task answers.
    static ASKER: Asker;
}

#[derive(Debug, Clone)]
struct Asker {
    user: String,
    /// Its role may only watch and stop.
    watches: bool,
}

/// Answers a request of a session: turns that `answer` takes count as those of its user.
pub(super) async fn asked_by<F: Future>(session: &Session, answer: F) -> F::Output {
    let asker = Asker { user: session.user.clone(), watches: session.role < Role::Operator };
    ASKER.scope(asker, answer).await
}

/// Limits long work in separate threads: a number running, a number waiting; further work is refused. The cycle needs
/// its share of the processor.
///
/// Each user has at most half of the places, and so have all viewers together; where several run at once, viewers
/// leave one to others. Work continues when its client has gone, so a client that asks and goes takes no more than that.
pub(crate) struct Turns {
    places: Arc<Semaphore>,
    running: Arc<Semaphore>,
    places_of_viewers: Arc<Semaphore>,
    running_of_viewers: Arc<Semaphore>,
    share: usize,
    shares: Shares,
}

/// Number of turns that each user has taken.
#[derive(Clone, Default)]
struct Shares(Arc<Mutex<HashMap<String, usize>>>);

impl Shares {
    fn table(&self) -> MutexGuard<'_, HashMap<String, usize>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes a part of the share of `user`. `None`: all of it is taken.
    fn take(&self, user: &str, share: usize) -> Option<Part> {
        let mut table = self.table();
        let own = table.entry(user.to_owned()).or_default();
        if *own >= share {
            return None;
        }
        *own += 1;
        Some(Part { of: self.clone(), user: user.to_owned() })
    }
}

/// Part of a user's share; given back when dropped.
struct Part {
    of: Shares,
    user: String,
}

impl Drop for Part {
    fn drop(&mut self) {
        let mut table = self.of.table();
        match table.get_mut(&self.user) {
            Some(own) if *own > 1 => *own -= 1,
            _ => drop(table.remove(&self.user)),
        }
    }
}

/// A turn, which ends when dropped.
#[derive(Default)]
pub(crate) struct Turn {
    permits: Vec<OwnedSemaphorePermit>,
    _part: Option<Part>,
}

fn busy() -> Refused {
    Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", Message::new("server-slow-down"))
}

impl Turns {
    pub(crate) fn new(queue: Queue) -> Self {
        let (all, at_once) = (queue.at_once + queue.waiting, queue.at_once);
        let semaphore = |permits| Arc::new(Semaphore::new(permits));
        Self {
            places: semaphore(all),
            running: semaphore(at_once),
            places_of_viewers: semaphore((all / 2).max(1)),
            running_of_viewers: semaphore((at_once - 1).max(1)),
            share: (all / 2).max(1),
            shares: Shares::default(),
        }
    }

    /// Returns true if every place is taken.
    #[cfg(test)]
    pub(crate) fn is_full(&self) -> bool {
        self.places.available_permits() == 0
    }

    /// Takes a turn if one is free.
    pub(crate) fn now(&self) -> Option<Turn> {
        let free = |of: &Arc<Semaphore>| Arc::clone(of).try_acquire_owned().ok();
        Some(Turn { permits: vec![free(&self.places)?, free(&self.running)?], _part: None })
    }

    async fn take(&self) -> Result<Turn, Refused> {
        let asker = ASKER.try_with(Asker::clone).ok();
        let watches = asker.as_ref().is_some_and(|asker| asker.watches);
        let mut turn = Turn::default();
        if let Some(asker) = &asker {
            turn._part = Some(self.shares.take(&asker.user, self.share).ok_or_else(busy)?);
        }
        let (for_viewers, for_all) = (
            [&self.places_of_viewers, &self.running_of_viewers].map(|of| watches.then_some(of)),
            [&self.places, &self.running].map(Some),
        );
        for of in [for_viewers[0], for_all[0]].into_iter().flatten() {
            turn.permits.push(Arc::clone(of).try_acquire_owned().map_err(|_| busy())?);
        }
        for of in [for_viewers[1], for_all[1]].into_iter().flatten() {
            let permit = Arc::clone(of).acquire_owned().await;
            turn.permits.push(permit.map_err(|_| Refused::server(Message::new("server-panel-ends")))?);
        }
        Ok(turn)
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
        let turns = Arc::new(Turns::new(Queue { at_once: 2, waiting: 3 }));
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

    /// Neither a user nor all viewers together take every place.
    #[tokio::test(flavor = "multi_thread", worker_threads = 2)]
    #[allow(clippy::await_holding_lock, reason = "that the work waits for it is what is tried")]
    async fn places_are_kept_for_other_users_and_for_operators() {
        let turns = Arc::new(Turns::new(Queue { at_once: 2, waiting: 32 }));
        let (sessions, blocks) = (crate::users::Sessions::default(), Arc::new(Mutex::new(())));
        let held = blocks.lock().unwrap();
        let ask = |user: &str, role: Role| {
            let (turns, session) = (Arc::clone(&turns), sessions.begin(user, role).unwrap().1);
            let blocks = Arc::clone(&blocks);
            let work = move || -> Result<(), Refused> {
                drop(blocks.lock());
                Ok(())
            };
            tokio::spawn(async move { asked_by(&session, turns.run(work)).await })
        };
        let viewing: Vec<_> = (0..40).map(|i| ask(&format!("viewer {i}"), Role::Viewer)).collect();
        let operating: Vec<_> = (0..20).map(|_| ask("olga", Role::Operator)).collect();
        // All but those with a place are refused at once.
        let refused = || viewing.iter().chain(&operating).filter(|asked| asked.is_finished()).count();
        while refused() < 60 - 34 {
            tokio::time::sleep(Duration::from_millis(5)).await;
        }
        // One of the two threads works for operators.
        assert_eq!(turns.running_of_viewers.available_permits(), 0);
        drop(held);
        let mut answered = [0, 0];
        for (count, asked) in answered.iter_mut().zip([viewing, operating]) {
            for asked in asked {
                *count += usize::from(asked.await.unwrap().is_ok());
            }
        }
        assert_eq!(answered, [17, 17]);
        assert!(turns.shares.table().is_empty());
        assert_eq!(turns.places.available_permits(), 34);
    }
}
