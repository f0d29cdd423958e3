//! Transfer moves with the arc off, clear of everything: from home to a weld, between passes, and back.

mod leg;
mod rest_to_rest;
mod route;
mod too_near;

pub use leg::{Leg, TransferMove};
pub use route::route;
pub(crate) use route::{obstacle, route_within};
pub use too_near::names_nearest;
pub(crate) use too_near::{RootAt, nearest, too_near};
