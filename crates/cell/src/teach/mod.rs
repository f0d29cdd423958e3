//! Teaching on a machine: the crawl's moves through its kinematics, limits and zones, its frames from an eye.

mod carrier;
mod run;

pub use carrier::{Carrier, Guide};
pub use run::{Found, Midline, NoOperator, Operator, Replay, TaughtRun, crawl, replay};
