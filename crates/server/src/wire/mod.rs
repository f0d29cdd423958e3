//! Messages in both directions: JSON. The panel's types are generated from them.
//!
//! Lengths in mm, axis angles in degrees, times in s, as in files. Every socket message has a `kind`.

mod cell;
mod certificate;
mod choices;
mod diagnostics;
mod form;
mod message;
mod record;
mod schedule;
mod setup;
mod socket;
mod status;
mod teach;
mod weld;

pub use cell::*;
pub use certificate::*;
pub use choices::*;
pub use diagnostics::*;
pub use form::*;
pub use message::*;
pub use record::*;
pub use schedule::*;
pub use setup::*;
pub use socket::*;
pub use status::*;
pub use teach::*;
pub use weld::*;
