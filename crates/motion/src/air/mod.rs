//! Transfer moves with the arc off, clear of everything: from home to a weld, between passes, and back.

mod leg;
mod rest_to_rest;
mod route;

pub use leg::{AirMove, Leg};
pub use route::{Blocked, route};
pub(crate) use route::{obstacle, route_within, too_near};
