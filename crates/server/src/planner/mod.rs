//! Plans and drafts, computed beside the cell.
//!
//! Unfinished texts may need any amount of memory and time. Separate processes with limits of both answer them: one at
//! a time for plans, one for drafts, one for jobs to be loaded, one for searches.
//! A newer draft of a page ends the older one, and so does a page that closes. A user has one question of each sort
//! answered and one more waiting.

mod child;
mod question;
mod reach;
mod schedule;
mod worker;

pub(crate) use question::{JOB, Question, wrong_view};
pub(crate) use schedule::{Planned, ScheduleWork};
pub use worker::answer_one_question;

use crate::diagnostics::WorkerCounts;
use crate::http::{Refused, Turns};
use crate::limits::{DRAFT_TIME, LONG_TIME, MAX_PLANS_OF_USER, PLAN_TIME, PLANNING};
use axum::http::StatusCode;
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::Notify;

/// First line of an answer, as JSON; lines of progress may come before it.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Header {
    /// This much of the work is done, of so much; another line follows.
    Progress { done: u64, total: u64, kept: u64 },
    /// This number of bytes follows.
    Answer { bytes: usize },
    /// No bytes follow.
    Refused { status: u16, key: String, message: Message },
}

impl Header {
    fn of(refused: &Refused) -> Self {
        let (status, key, message) = (refused.status.as_u16(), refused.key.to_owned(), refused.message.clone());
        Self::Refused { status, key, message }
    }
}

/// How far a question is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Progress {
    /// Work done.
    pub(crate) done: u64,
    /// All of it.
    pub(crate) total: u64,
    /// Part of the work done that an earlier run has done.
    pub(crate) kept: u64,
}

/// Receives the progress of a question.
pub(crate) type OnProgress<'a> = &'a (dyn Fn(Progress) + Sync);

#[derive(Debug, Default)]
struct Token {
    is_cancelled: AtomicBool,
    told: Notify,
    /// Work done, its total, and what of it was done before; zero while unknown.
    progress: [AtomicU64; 3],
}

impl Token {
    fn cancel(&self) {
        self.is_cancelled.store(true, Ordering::SeqCst);
        self.told.notify_one();
    }

    fn advance(&self, of: Progress) {
        self.progress[1].store(of.total, Ordering::Relaxed);
        self.progress[2].fetch_max(of.kept, Ordering::Relaxed);
        self.progress[0].fetch_max(of.done, Ordering::Relaxed);
    }

    /// The progress, once it is known.
    fn progress(&self) -> Option<Progress> {
        let [done, total, kept] = [0, 1, 2].map(|i| self.progress[i].load(Ordering::Relaxed));
        (total > 0).then_some(Progress { done, total, kept })
    }

    fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::SeqCst)
    }

    async fn cancelled(&self) {
        while !self.is_cancelled() {
            self.told.notified().await;
        }
    }
}

fn superseded() -> Refused {
    Refused::new(StatusCode::CONFLICT, "superseded", Message::new("server-superseded"))
}

fn too_long(patience: Duration) -> Refused {
    Refused::input(Message::new("server-planning-time").value("max", patience.as_secs_f64(), Unit::S))
}

/// Origin of a question: user, session and page.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub(crate) struct Page {
    pub(crate) user: String,
    pub(crate) session: String,
    pub(crate) page: String,
}

/// Sorts of questions, which do not wait for each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sort {
    Draft,
    Plan,
    Load,
    /// Searches take minutes: plans do not wait for them.
    Search,
}

impl Sort {
    fn of(question: &Question) -> Self {
        match question {
            Question::Draft { .. } | Question::Place { .. } => Self::Draft,
            Question::Load { .. } => Self::Load,
            Question::Reach { .. } => Self::Search,
            // Long work takes no turn.
            _ => Self::Plan,
        }
    }
}

/// A question that is being answered.
#[derive(Debug)]
struct Running {
    page: Page,
    sort: Sort,
    name: &'static str,
    since: Instant,
    token: Arc<Token>,
}

/// View for its page of a question that is being answered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Asked {
    pub(crate) name: &'static str,
    pub(crate) since: Instant,
    /// How far it is, once that is known.
    pub(crate) progress: Option<Progress>,
}

/// Work in the background that takes hours.
#[derive(Debug)]
pub(crate) struct LongWork {
    token: Arc<Token>,
    since: Instant,
}

impl LongWork {
    pub(crate) fn begin() -> Self {
        Self { token: Arc::default(), since: Instant::now() }
    }

    pub(crate) fn cancel(&self) {
        self.token.cancel();
    }

    pub(crate) fn is_cancelled(&self) -> bool {
        self.token.is_cancelled()
    }

    pub(crate) fn progress(&self) -> Progress {
        self.token.progress().unwrap_or_default()
    }

    pub(crate) fn elapsed(&self) -> Duration {
        self.since.elapsed()
    }
}

pub(crate) struct Planner {
    /// The program that answers; `None`: a thread of this process, without a memory limit.
    program: Option<PathBuf>,
    plans: Turns,
    /// Drafts do not wait for plans.
    drafts: Turns,
    /// Loading does not wait for plans that are only viewed.
    loads: Turns,
    searches: Turns,
    running: Arc<Mutex<Table>>,
    workers: Arc<WorkerCounts>,
}

#[derive(Debug, Default)]
struct Table {
    running: HashMap<u64, Running>,
    next: u64,
}

/// Entry of a question in the table; dropping it cancels the question.
struct Ticket {
    table: Arc<Mutex<Table>>,
    number: u64,
    token: Arc<Token>,
}

impl Drop for Ticket {
    fn drop(&mut self) {
        self.token.cancel();
        lock(&self.table).running.remove(&self.number);
    }
}

fn lock(table: &Mutex<Table>) -> MutexGuard<'_, Table> {
    table.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Planner {
    pub(crate) fn new(program: Option<PathBuf>) -> Self {
        Self {
            program,
            plans: Turns::new(PLANNING),
            drafts: Turns::new(PLANNING),
            loads: Turns::new(PLANNING),
            searches: Turns::new(PLANNING),
            running: Arc::default(),
            workers: Arc::default(),
        }
    }

    /// Answers with JSON or an HTML page. Cancels an earlier question of the same kind from this page.
    /// Fails if the text is invalid, needs too much memory or time, or was superseded, or if there are too many questions.
    pub(crate) async fn ask(&self, page: Page, question: Question, jobs: PathBuf) -> Result<Vec<u8>, Refused> {
        let sort = Sort::of(&question);
        let (turns, patience) = match sort {
            Sort::Draft => (&self.drafts, DRAFT_TIME),
            Sort::Plan => (&self.plans, PLAN_TIME),
            Sort::Load => (&self.loads, PLAN_TIME),
            Sort::Search => (&self.searches, PLAN_TIME),
        };
        let ticket = self.begin(page, sort, question.name())?;
        let (program, token, workers) = (self.program.clone(), Arc::clone(&ticket.token), Arc::clone(&self.workers));
        let answer = turns.run(move || match &program {
            _ if token.is_cancelled() => Err(superseded()),
            Some(program) => child::ask(program, &question, &jobs, &token, patience, &workers),
            None => question.answer(&jobs, &|progress| token.advance(progress)),
        });
        tokio::select! {
            biased;
            () = ticket.token.cancelled() => Err(superseded()),
            answer = answer => answer,
        }
    }

    /// Answers a question in the background, in a process of its own; takes no turn.
    ///
    /// # Errors
    /// As [`Planner::ask`].
    pub(crate) fn work_long(&self, work: &LongWork, question: &Question, jobs: &Path) -> Result<Vec<u8>, Refused> {
        match &self.program {
            Some(program) => child::ask(program, question, jobs, &work.token, LONG_TIME, &self.workers),
            None => question.answer(jobs, &|progress| work.token.advance(progress)),
        }
    }

    /// Queues of plans, drafts and loads.
    #[cfg(test)]
    pub(crate) fn turns(&self) -> [&Turns; 3] {
        [&self.plans, &self.drafts, &self.loads]
    }

    /// Counts of the processes.
    pub(crate) fn workers(&self) -> &WorkerCounts {
        &self.workers
    }

    fn begin(&self, page: Page, sort: Sort, name: &'static str) -> Result<Ticket, Refused> {
        let mut table = lock(&self.running);
        let older = table.running.values().filter(|running| running.page == page && running.name == name);
        older.for_each(|running| running.token.cancel());
        let wanted = table.running.values().filter(|running| !running.token.is_cancelled());
        if wanted.filter(|running| running.sort == sort && running.page.user == page.user).count() >= MAX_PLANS_OF_USER
        {
            return Err(Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", Message::new("server-slow-down")));
        }
        table.next += 1;
        let (number, token) = (table.next, Arc::<Token>::default());
        let running = Running { page, sort, name, since: Instant::now(), token: Arc::clone(&token) };
        table.running.insert(number, running);
        Ok(Ticket { table: Arc::clone(&self.running), number, token })
    }

    pub(crate) fn asked(&self, page: &Page) -> Vec<Asked> {
        let table = lock(&self.running);
        let own = table.running.values().filter(|running| running.page == *page);
        own.map(|running| Asked { name: running.name, since: running.since, progress: running.token.progress() })
            .collect()
    }

    /// Cancels the questions of a page, or those of one name.
    pub(crate) fn cancel(&self, page: &Page, name: Option<&str>) -> usize {
        let table = lock(&self.running);
        let named = |running: &&Running| name.is_none_or(|name| name == running.name);
        let own = table.running.values().filter(|running| running.page == *page).filter(named);
        own.map(|running| running.token.cancel()).count()
    }
}

#[cfg(test)]
pub(crate) mod tests;
