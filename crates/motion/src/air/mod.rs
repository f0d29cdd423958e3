//! Transfer moves with the arc off, clear of everything: from home to a weld, between passes, and back.

mod leg;
mod rest_to_rest;
mod route;
mod solids;

pub use leg::{AirMove, Leg};
pub use route::{Blocked, MoveEnd, route};
pub(crate) use route::{obstacle, route_within};
pub(crate) use solids::too_near;
pub use solids::{names_nearest, solids};
