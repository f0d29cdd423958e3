//! Machines and planned programs as the panel sees them.

mod machine;
mod moment;
mod solid;
mod work;

pub(crate) use machine::machine_view;
pub(crate) use moment::written;
pub(crate) use solid::rows;
pub(crate) use work::work_view;
