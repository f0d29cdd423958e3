//! Teaching on a machine: the crawl's moves through its kinematics, limits and zones, its frames from a camera.

mod carrier;
mod follower;
mod rig;
mod run;
mod semi_manual;

pub use carrier::{Carrier, Guide};
pub use follower::JointFollower;
pub use rig::{DistantRig, Played, Rig, joints};
pub use run::{Found, Look, Midline, NoOperator, Operator, Setup, TaughtRun, teach};
pub use semi_manual::semi_manual;
