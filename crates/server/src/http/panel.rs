use super::assets::Compressed;
use super::turns::{Turn, Turns};
use crate::cell::Cell;
use crate::planner::Planner;
use crate::teaching::{Cameras, Teaching};
use crate::users::{Accounts, Checks, Devices, MAX_USERS, OWNER, Session, Sessions, Tries};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;
use tokio::sync::watch;

/// Most bytes of an archive that is restored from a page.
const MOST_ARCHIVE: u64 = 16 << 30;

/// Who restores all data, and the turn that keeps others from it.
pub(crate) type Restores = Option<Arc<(String, Turn)>>;

/// Jobs that are being planned in this process to be loaded. That may take as much memory as the system has: no machine may move then.
#[derive(Default)]
pub(crate) struct Loads(Arc<()>);

/// A load that is announced, until it is dropped.
pub(crate) struct Announced(#[allow(dead_code, reason = "held")] Arc<()>);

impl Loads {
    pub(crate) fn announce(&self) -> Announced {
        Announced(Arc::clone(&self.0))
    }

    /// True while at least one is announced.
    pub(crate) fn any(&self) -> bool {
        Arc::strong_count(&self.0) > 1
    }
}

/// Everything that handlers share.
pub(crate) struct Panel {
    pub(crate) cell: Cell,
    pub(crate) accounts: Accounts,
    pub(crate) sessions: Sessions,
    pub(crate) tries: Tries,
    pub(crate) devices: Devices,
    /// Passwords that are being checked, by name.
    pub(crate) checks: Checks,
    /// Opens the panel while there is no administrator.
    pub(crate) key: String,
    pub(crate) data: PathBuf,
    /// Names under which the panel may be asked for, with ports where they are not the usual one.
    pub(crate) hosts: Vec<String>,
    /// The connection is encrypted.
    pub(crate) tls: bool,
    pub(crate) planning: Turns,
    pub(crate) loads: Loads,
    /// Answers what is asked about texts, beside the cell.
    pub(crate) planner: Planner,
    /// What is read without being planned does not wait for a plan.
    pub(crate) drawing: Turns,
    /// Of records, jobs and texts.
    pub(crate) reading: Turns,
    /// Of passwords of users that there are: one at a time, so that guesses at once do not count as one. Names share the places evenly:
    /// see [`Checks`].
    pub(crate) checking: Turns,
    pub(crate) backing_up: Turns,
    /// When somebody who is not logged in stopped last.
    pub(crate) stopped: Mutex<Option<Instant>>,
    /// Of what is kept in files: one at a time, since what is there is looked at before. A disk that hangs holds up nothing else.
    pub(crate) saving: Turns,
    /// Says that the cell is to begin anew with restored data.
    pub(crate) restores: watch::Sender<Restores>,
    /// Most bytes of an archive that is restored.
    pub(crate) most_archive: u64,
    /// Files of the panel as they are sent.
    pub(crate) compressed: Compressed,
    pub(crate) teaching: Teaching,
    /// Where frames may come from.
    pub(crate) cameras: Cameras,
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
            planning: Turns::new(1, 8),
            loads: Loads::default(),
            planner: Planner::new(None),
            drawing: Turns::new(1, 8),
            reading: Turns::new(2, 32),
            checking: Turns::new(1, 8 * MAX_USERS),
            backing_up: Turns::new(1, 0),
            stopped: Mutex::new(None),
            saving: Turns::new(1, 16),
            restores: watch::Sender::new(None),
            most_archive: MOST_ARCHIVE,
            compressed: Compressed::default(),
            teaching: Teaching::default(),
            cameras: Cameras::default(),
            plans: AtomicU64::new(0),
        }
    }

    /// True if the session is there still, and its user may log in and has the role that he had; `used`: it counts as used.
    pub(crate) fn stands(&self, session: &Session, used: bool) -> bool {
        let known = match session.user.as_str() {
            OWNER => !self.accounts.has_admin(),
            user => self.accounts.role(user) == Some(session.role),
        };
        known && self.sessions.lives(session, used)
    }

    /// Where jobs are kept.
    pub(crate) fn jobs(&self) -> PathBuf {
        self.data.join("jobs")
    }

    /// A number for a new plan.
    pub(crate) fn plan_number(&self) -> u64 {
        self.plans.fetch_add(1, Ordering::Relaxed) + 1
    }
}
