//! Plans and drafts, answered beside the cell.
//!
//! Texts that somebody is still typing may ask for any amount of memory and time. So they are answered by a process of their own with
//! bounds of both, one at a time for plans, one for drafts and one for jobs that are to be loaded; a newer draft of a page ends the older
//! one, and so does a page that goes. A user has one question of each of these sorts answered, and one more waiting.

mod child;
mod question;
mod worker;

pub(crate) use question::Question;
pub use worker::answer_one_question;

use crate::http::{Refused, Turns};
use axum::http::StatusCode;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::Notify;

/// Memory and processor time of a process that answers.
const MEMORY_BYTES: u64 = 2 << 30;
const TIME: Duration = Duration::from_secs(600);
/// Time for a draft, which somebody waits for while typing, and for anything else.
const DRAFT_TIME: Duration = Duration::from_secs(20);
const PLAN_TIME: Duration = Duration::from_secs(300);
/// Maximum number of bytes of an answer.
const MAX_ANSWER: usize = 128 << 20;

/// How an answer begins: a line of JSON.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Header {
    /// So many bytes follow.
    Answer { bytes: usize },
    /// Nothing follows.
    Refused { status: u16, key: String, text: String },
}

impl Header {
    fn of(refused: &Refused) -> Self {
        let (status, key, text) = (refused.status.as_u16(), refused.key.to_owned(), refused.text.clone());
        Self::Refused { status, key, text }
    }
}

/// Says that an answer is not wanted any more.
#[derive(Debug, Default)]
struct Token {
    is_cancelled: AtomicBool,
    told: Notify,
}

impl Token {
    fn cancel(&self) {
        self.is_cancelled.store(true, Ordering::SeqCst);
        self.told.notify_one();
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
    Refused::new(StatusCode::CONFLICT, "superseded", "a newer text was asked about, or it was cancelled")
}

fn too_long(patience: Duration) -> Refused {
    let text =
        format!("planning this takes longer than {} s; allowed: fewer passes, beads or points", patience.as_secs());
    Refused::input(text)
}

/// Maximum number of questions of one user and one sort at a time: whatever his pages call themselves.
const MAX_OF_USER: usize = 2;

/// Whose question it is: of which user and session, of which of its pages.
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
}

impl Sort {
    fn of(question: &Question) -> Self {
        match question {
            Question::Draft { .. } | Question::Place { .. } => Self::Draft,
            Question::Load { .. } => Self::Load,
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

/// A question that is being answered, as its page is told.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Asked {
    pub(crate) name: &'static str,
    pub(crate) since: Instant,
}

/// Answers questions.
pub(crate) struct Planner {
    /// The program that answers; none: a thread of this one does, without bounds of memory.
    program: Option<PathBuf>,
    plans: Turns,
    /// What is not planned does not wait for a plan.
    drafts: Turns,
    /// Nor does who loads for those who look.
    loads: Turns,
    running: Arc<Mutex<Table>>,
}

#[derive(Debug, Default)]
struct Table {
    running: HashMap<u64, Running>,
    next: u64,
}

/// A question's place in the table; dropped, its answer is not wanted any more.
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
            plans: Turns::new(1, 8),
            drafts: Turns::new(1, 8),
            loads: Turns::new(1, 8),
            running: Arc::default(),
        }
    }

    /// Answers with JSON or a page. A question of the same kind that the page asked before is answered no more.
    ///
    /// # Errors
    /// What is wrong with the text; that it takes too much memory or time, or was superseded; that too many ask.
    pub(crate) async fn ask(&self, page: Page, question: Question, jobs: PathBuf) -> Result<Vec<u8>, Refused> {
        let sort = Sort::of(&question);
        let (turns, patience) = match sort {
            Sort::Draft => (&self.drafts, DRAFT_TIME),
            Sort::Plan => (&self.plans, PLAN_TIME),
            Sort::Load => (&self.loads, PLAN_TIME),
        };
        let ticket = self.begin(page, sort, question.name())?;
        let (program, token) = (self.program.clone(), Arc::clone(&ticket.token));
        let answer = turns.run(move || match &program {
            _ if token.is_cancelled() => Err(superseded()),
            Some(program) => child::ask(program, &question, &jobs, &token, patience),
            None => question.answer(&jobs),
        });
        tokio::select! {
            biased;
            () = ticket.token.cancelled() => Err(superseded()),
            answer = answer => answer,
        }
    }

    /// True if questions are answered with bounds of memory and time.
    pub(crate) fn is_bounded(&self) -> bool {
        self.program.is_some()
    }

    fn begin(&self, page: Page, sort: Sort, name: &'static str) -> Result<Ticket, Refused> {
        let mut table = lock(&self.running);
        let older = table.running.values().filter(|running| running.page == page && running.name == name);
        older.for_each(|running| running.token.cancel());
        let wanted = table.running.values().filter(|running| !running.token.is_cancelled());
        if wanted.filter(|running| running.sort == sort && running.page.user == page.user).count() >= MAX_OF_USER {
            let text = "too much of this is asked for at once: try again in a moment";
            return Err(Refused::new(StatusCode::SERVICE_UNAVAILABLE, "slow_down", text));
        }
        table.next += 1;
        let (number, token) = (table.next, Arc::<Token>::default());
        let running = Running { page, sort, name, since: Instant::now(), token: Arc::clone(&token) };
        table.running.insert(number, running);
        Ok(Ticket { table: Arc::clone(&self.running), number, token })
    }

    /// What is being answered to a page.
    pub(crate) fn asked(&self, page: &Page) -> Vec<Asked> {
        let table = lock(&self.running);
        let own = table.running.values().filter(|running| running.page == *page);
        own.map(|running| Asked { name: running.name, since: running.since }).collect()
    }

    /// Cancels everything that a page has asked; how much that was.
    pub(crate) fn cancel(&self, page: &Page) -> usize {
        let table = lock(&self.running);
        let own = table.running.values().filter(|running| running.page == *page);
        own.map(|running| running.token.cancel()).count()
    }
}

#[cfg(test)]
pub(crate) mod tests;
