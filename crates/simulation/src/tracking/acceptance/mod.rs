//! Acceptance tests of tracking: rows of measured values against limits.

mod cross_talk;
mod disturbances;
mod sensor_faults;
mod single_welds;
mod stripe_images;

pub use cross_talk::cross_talk;
pub use disturbances::{GateRow, SPEEDS, scenarios, tracking_gates, weld_count};
pub use sensor_faults::fault_rows;
pub use single_welds::{heat_rows, misplaced_rows, t_joint_rows};
pub use stripe_images::stripe_rows;
