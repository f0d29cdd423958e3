//! Counts of clients, answers, logins and processes since the start.

use crate::wire::{ClientsView, CountView, WorkerView, WorkersView};
use seamwright_message::named_enum;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

named_enum! {
    /// End of a connection.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Ended {
        /// By client or server, in order or not.
        InOrder => "ended",
        /// For a newcomer, since too many had no session.
        Displaced => "displaced",
        /// The encryption was not agreed.
        Handshake => "handshake",
    }
}

named_enum! {
    /// End of a process that answers.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum WorkerEnd {
        /// It answered.
        Answered => "answered",
        /// It answered that the text is invalid.
        Refused => "refused",
        /// Killed: its page asked anew, cancelled, or closed.
        Superseded => "superseded",
        /// Killed: it took too long.
        Late => "late",
        /// It asked for more than its memory.
        Memory => "memory",
        /// It failed otherwise.
        Failed => "failed",
    }
}

/// Clients, answers and logins.
#[derive(Debug, Default)]
pub(crate) struct Counts {
    open: AtomicUsize,
    ended: [AtomicU64; Ended::ALL.len()],
    accepted: AtomicU64,
    refused: AtomicU64,
    answers: Mutex<BTreeMap<u16, u64>>,
}

/// An open connection, until dropped.
pub(crate) struct Open(Arc<Counts>);

impl Drop for Open {
    fn drop(&mut self) {
        self.0.open.fetch_sub(1, Ordering::Relaxed);
    }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

fn row(name: &(impl ToString + ?Sized), count: u64) -> CountView {
    CountView { name: name.to_string(), count }
}

impl Counts {
    pub(crate) fn open(self: &Arc<Self>) -> Open {
        self.open.fetch_add(1, Ordering::Relaxed);
        Open(Arc::clone(self))
    }

    pub(crate) fn ended(&self, how: Ended) {
        self.ended[how as usize].fetch_add(1, Ordering::Relaxed);
    }

    pub(crate) fn login(&self, accepted: bool) {
        let count = if accepted { &self.accepted } else { &self.refused };
        count.fetch_add(1, Ordering::Relaxed);
    }

    /// Counts an answer with this HTTP status.
    pub(crate) fn answered(&self, status: u16) {
        *lock(&self.answers).entry(status).or_default() += 1;
    }

    pub(crate) fn view(&self) -> ClientsView {
        let get = |count: &AtomicU64| count.load(Ordering::Relaxed);
        ClientsView {
            connections: self.open.load(Ordering::Relaxed),
            ended: Ended::ALL.map(|how| row(how.name(), get(&self.ended[how as usize]))).to_vec(),
            logins: vec![row("accepted", get(&self.accepted)), row("refused", get(&self.refused))],
            answers: lock(&self.answers).iter().map(|(status, count)| row(status, *count)).collect(),
            ..ClientsView::default()
        }
    }

    /// Everything refused so far, by kind: HTTP status, `displaced`, `handshake`, `login`.
    pub(crate) fn refused(&self) -> BTreeMap<String, u64> {
        let get = |count: &AtomicU64| count.load(Ordering::Relaxed);
        let answers = lock(&self.answers);
        let answers = answers.iter().filter(|(status, _)| **status >= 400);
        let ended = [Ended::Displaced, Ended::Handshake].map(|how| (how.name(), get(&self.ended[how as usize])));
        let others = ended.into_iter().chain([("login", get(&self.refused))]);
        let others = others.map(|(kind, count)| (kind.to_owned(), count));
        answers.map(|(status, count)| (status.to_string(), *count)).chain(others).collect()
    }
}

/// Processes that answer questions.
#[derive(Debug, Default)]
pub(crate) struct WorkerCounts {
    running: Mutex<BTreeMap<u32, (&'static str, Instant)>>,
    ended: [AtomicU64; WorkerEnd::ALL.len()],
}

/// A running process, until it is counted as ended.
pub(crate) struct RunningWorker<'a> {
    of: &'a WorkerCounts,
    pid: u32,
    pub(crate) since: Instant,
}

impl WorkerCounts {
    pub(crate) fn begin(&self, pid: u32, question: &'static str) -> RunningWorker<'_> {
        let since = Instant::now();
        lock(&self.running).insert(pid, (question, since));
        RunningWorker { of: self, pid, since }
    }

    pub(crate) fn view(&self) -> WorkersView {
        let running = lock(&self.running);
        let running = running.iter().map(|(pid, (question, since))| WorkerView {
            pid: *pid,
            question: (*question).to_owned(),
            elapsed_s: since.elapsed().as_secs_f64(),
        });
        let ended = WorkerEnd::ALL.map(|how| row(how.name(), self.ended[how as usize].load(Ordering::Relaxed)));
        WorkersView { running: running.collect(), ended: ended.to_vec() }
    }
}

impl RunningWorker<'_> {
    pub(crate) fn ends(self, how: WorkerEnd) {
        self.of.ended[how as usize].fetch_add(1, Ordering::Relaxed);
    }
}

impl Drop for RunningWorker<'_> {
    fn drop(&mut self) {
        lock(&self.of.running).remove(&self.pid);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn connections_and_processes_are_counted_while_they_last() {
        let counts = Arc::new(Counts::default());
        let (first, second) = (counts.open(), counts.open());
        assert_eq!(counts.view().connections, 2);
        drop((first, second));
        counts.ended(Ended::Displaced);
        counts.login(false);
        (0..3).for_each(|_| counts.answered(429));
        counts.answered(200);
        assert_eq!(counts.view().connections, 0);
        let refused: Vec<(String, u64)> = counts.refused().into_iter().filter(|(_, n)| *n > 0).collect();
        assert_eq!(refused, [("429".to_owned(), 3), ("displaced".to_owned(), 1), ("login".to_owned(), 1)]);
        let workers = WorkerCounts::default();
        let (draft, plan) = (workers.begin(7, "draft"), workers.begin(8, "plan"));
        assert_eq!(workers.view().running.len(), 2);
        draft.ends(WorkerEnd::Superseded);
        drop(plan);
        let view = workers.view();
        assert!(view.running.is_empty() && view.ended[WorkerEnd::Superseded as usize].count == 1, "{view:?}");
    }
}
