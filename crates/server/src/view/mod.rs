//! Views of machines and planned programs for the panel.

mod arm;
mod certificate;
mod clearance;
mod devices;
mod finding_position;
mod machine;
mod moment;
mod parameters;
mod section;
mod sensor;
mod sensor_file;
mod solid;
mod tracking;
mod tuning;
mod work;

pub(crate) use arm::arm_view;
pub(crate) use clearance::near;
pub(crate) use devices::{device_views, simulated_view};
pub(crate) use machine::machine_view;
pub(crate) use moment::written;
pub(crate) use parameters::{PARAMETERS, parameters_view};
pub(crate) use section::sections;
pub(crate) use sensor_file::{SENSOR_KEYS, height_view, sensors_view, steps};
pub(crate) use solid::rows;
pub(crate) use tracking::tracking;
pub(crate) use tuning::tuning_view;
pub(crate) use work::{clamped_views, work_view};
