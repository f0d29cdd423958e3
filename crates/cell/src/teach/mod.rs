//! Teaching on a machine: the crawl's moves through its kinematics, limits and zones, its frames from an eye.

mod carrier;
mod follower;
mod ridge;
mod run;
mod semi_manual;
mod truth;

pub use carrier::{Carrier, Guide};
pub use follower::JointFollower;
pub use ridge::RidgeFollower;
pub use run::{Found, Midline, NoOperator, Operator, Replay, TaughtRun, crawl, replay};
pub use semi_manual::semi_manual;
pub use truth::{Truth, truth};
