//! Who may do what: users with roles and passwords, sessions, the one table of permissions.

mod accounts;
mod permissions;
mod sessions;
mod tries;

pub(crate) use accounts::{Accounts, OWNER, Trouble};
pub(crate) use permissions::{NEEDS, least, may};
pub(crate) use sessions::{Session, Sessions, secret};
pub(crate) use tries::Tries;
