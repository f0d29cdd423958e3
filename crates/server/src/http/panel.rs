use crate::cell::Cell;
use crate::teaching::Teaching;
use crate::users::{Accounts, Sessions};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use tokio::sync::Semaphore;

/// Everything that handlers share.
pub(crate) struct Panel {
    pub(crate) cell: Cell,
    pub(crate) accounts: Accounts,
    pub(crate) sessions: Sessions,
    /// Opens the panel while there is no administrator.
    pub(crate) key: String,
    pub(crate) data: PathBuf,
    /// Names under which the panel may be asked for, with ports where they are not the usual one.
    pub(crate) hosts: Vec<String>,
    /// The connection is encrypted.
    pub(crate) tls: bool,
    /// One plan at a time: the cycle has to have its share of the machine.
    pub(crate) planning: Semaphore,
    pub(crate) teaching: Teaching,
    plans: AtomicU64,
}

impl Panel {
    pub(crate) fn new(cell: Cell, accounts: Accounts, key: String, data: PathBuf, hosts: Vec<String>) -> Self {
        let (sessions, planning) = (Sessions::default(), Semaphore::new(1));
        Self {
            cell,
            accounts,
            sessions,
            key,
            data,
            hosts,
            tls: false,
            planning,
            teaching: Teaching::default(),
            plans: AtomicU64::new(0),
        }
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
