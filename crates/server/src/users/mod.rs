//! Users with roles and passwords, sessions, and the table of permissions.

mod accounts;
mod devices;
mod passwords;
mod permissions;
mod sessions;
mod tries;

pub(crate) use accounts::{Accounts, MAX_USERS, OWNER, Trouble};
pub(crate) use devices::Devices;
pub(crate) use permissions::{NEEDS, least, may};
pub(crate) use sessions::{Session, Sessions, secret};
pub(crate) use tries::{Checks, Origin, Tries, house};
