//! Moves with the arc off: from home to a weld, from one pass to the next, and back, clear of everything.

mod leg;
mod rest_to_rest;
mod route;

pub use leg::{AirMove, Leg};
pub use route::{Blocked, route};
pub(crate) use route::{obstacle, route_within, too_near};
