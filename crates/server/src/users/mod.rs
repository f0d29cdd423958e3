//! Who may do what: users with roles and passwords, sessions, the one table of permissions.

mod accounts;
mod permissions;
mod sessions;

pub(crate) use accounts::{Accounts, Trouble};
pub(crate) use permissions::{NEEDS, least, may};
pub(crate) use sessions::{Session, Sessions, secret};
