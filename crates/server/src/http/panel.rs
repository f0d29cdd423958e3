use super::answer::Refused;
use super::schedules::Schedules;
use super::work_limit::{Turn, Turns};
use crate::cell::{Cell, Change};
use crate::diagnostics::Diagnostics;
use crate::limits::{BACKING_UP, CHECKING, DRAWING, LOADING, MAX_ARCHIVE_BYTES, READING, SAVING};
use crate::planner::Planner;
use crate::teaching::{Cameras, Teaching};
use crate::users::{Accounts, Checks, Devices, OWNER, Session, Sessions, Tries};
use axum::extract::State;
use seamwright_machine::Machine;
use seamwright_message::Message;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;
use tokio::sync::watch;

/// The user who restores all data, and the turn that excludes others.
pub(crate) type Restores = Option<Arc<(String, Turn)>>;

/// Jobs on their way to the cell: no machine may start meanwhile.
#[derive(Default)]
pub(crate) struct Loads(Arc<()>);

/// An announced load, until dropped.
pub(crate) struct Announced {
    _held: Arc<()>,
}

impl Loads {
    pub(crate) fn announce(&self) -> Announced {
        Announced { _held: Arc::clone(&self.0) }
    }

    pub(crate) fn any(&self) -> bool {
        Arc::strong_count(&self.0) > 1
    }
}

/// The panel as an argument of handlers.
pub(super) type Shared = State<Arc<Panel>>;

/// State shared by all handlers.
pub(crate) struct Panel {
    pub(crate) cell: Cell,
    pub(crate) accounts: Accounts,
    pub(crate) sessions: Sessions,
    pub(crate) tries: Tries,
    pub(crate) devices: Devices,
    /// Passwords that are being checked, by name.
    pub(crate) checks: Checks,
    /// Key that opens the panel while there is no administrator.
    pub(crate) key: String,
    pub(crate) data: PathBuf,
    /// Valid values of header `host`; a default port may be missing.
    pub(crate) hosts: Vec<String>,
    /// The connection is encrypted.
    pub(crate) tls: bool,
    pub(crate) planning: Turns,
    pub(crate) loads: Loads,
    /// Answers questions about texts, beside the cell.
    pub(crate) planner: Planner,
    /// Turns for views that need no plan: they do not wait for plans.
    pub(crate) drawing: Turns,
    /// Turns for reading records, jobs and texts.
    pub(crate) reading: Turns,
    /// Turns for checking passwords of existing users: one at a time, so that simultaneous guesses are all counted.
    /// Names share the turns evenly: see [`Checks`].
    pub(crate) checking: Turns,
    pub(crate) backing_up: Turns,
    /// Time of the last stop without a session.
    pub(crate) stopped: Mutex<Option<Instant>>,
    /// Turns for writing files: one at a time, since existing files are read first. A hanging disk blocks nothing else.
    pub(crate) saving: Turns,
    /// Announces that the cell restarts with restored data.
    pub(crate) restores: watch::Sender<Restores>,
    /// Maximum size of an archive that is restored, bytes.
    pub(crate) most_archive: u64,
    pub(crate) teaching: Teaching,
    /// Tables of seams that are being planned.
    pub(super) schedules: Schedules,
    /// Addresses allowed as source of camera frames.
    pub(crate) cameras: Cameras,
    pub(crate) diagnostics: Diagnostics,
    plans: AtomicU64,
}

impl Panel {
    pub(crate) fn new(cell: Cell, accounts: Accounts, key: String, data: PathBuf, hosts: Vec<String>) -> Self {
        Self {
            cell,
            accounts,
            sessions: Sessions::default(),
            tries: Tries::default(),
            devices: Devices::open(&data),
            checks: Checks::default(),
            key,
            data,
            hosts,
            tls: false,
            planning: Turns::new(LOADING),
            loads: Loads::default(),
            planner: Planner::new(None),
            drawing: Turns::new(DRAWING),
            reading: Turns::new(READING),
            checking: Turns::new(CHECKING),
            backing_up: Turns::new(BACKING_UP),
            stopped: Mutex::new(None),
            saving: Turns::new(SAVING),
            restores: watch::Sender::new(None),
            most_archive: MAX_ARCHIVE_BYTES,
            teaching: Teaching::default(),
            schedules: Schedules::default(),
            cameras: Cameras::default(),
            diagnostics: Diagnostics::default(),
            plans: AtomicU64::new(0),
        }
    }

    /// Returns true if the session exists and its user is enabled with an unchanged role; `used` counts it as used.
    pub(crate) fn stands(&self, session: &Session, used: bool) -> bool {
        let known = match session.user.as_str() {
            OWNER => !self.accounts.has_admin(),
            user => self.accounts.role(user) == Some(session.role),
        };
        known && self.sessions.lives(session, used)
    }

    /// Adds a request of `user` to the audit log.
    pub(super) fn audit(&self, user: &str, command: Message, change: Change<'_>, result: Message) {
        self.cell.archive.audit(user, Message::new("server-audit-panel"), command, change, result);
    }

    pub(super) fn machine(&self) -> Result<Arc<Machine>, Refused> {
        self.cell.hub.machine().ok_or_else(|| Refused::server(Message::new("server-no-machine")))
    }

    /// Does `work` on this panel in the turns that `of` chooses.
    pub(super) async fn run<T: Send + 'static>(
        self: &Arc<Self>,
        of: fn(&Self) -> &Turns,
        work: impl FnOnce(&Arc<Self>) -> Result<T, Refused> + Send + 'static,
    ) -> Result<T, Refused> {
        let panel = Arc::clone(self);
        of(self).run(move || work(&panel)).await
    }

    pub(crate) fn jobs(&self) -> PathBuf {
        self.data.join("jobs")
    }

    pub(crate) fn plan_number(&self) -> u64 {
        self.plans.fetch_add(1, Ordering::Relaxed) + 1
    }
}
