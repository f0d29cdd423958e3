//! Users with roles and passwords, sessions, and the table of permissions.

mod accounts;
mod known_browsers;
mod login_attempts;
mod passwords;
mod permissions;
mod sessions;

pub(crate) use accounts::{Accounts, OWNER, Trouble};
pub(crate) use known_browsers::Devices;
pub(crate) use login_attempts::{Checks, Origin, Tries, house};
pub(crate) use permissions::{NEEDS, least, may};
pub(crate) use sessions::{Session, Sessions, secret};
