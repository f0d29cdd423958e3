//! Turns a torch path and a machine into set-points over time.
//!
//! - [`WeldMotion`] plans a whole program: its passes and the transfer moves ([`transfer`]) between them.
//! - [`PassMotion`] is one pass: the path of the axes ([`JointPath`]), the speed profile ([`SpeedProfile`]) and the process
//!   sequence. The profile is the fastest up to the requested speed within every axis' speed, acceleration and jerk.
//! - [`SetPoints`] plays a pass period by period in constant memory, without allocation.
//! - [`feed_override`] plays a speed profile under an operator's commands, [`jog`] moves axes without a path, and [`taught`]
//!   follows any number of points.
//! - [`procedure`] compares the plan with the welding procedure specification.
//! - [`fine`] interpolates coarse set-points, [`pulses`] generates step and direction pulses.
//! - [`textbook`] has the interpolators of the papers, for comparison.
//!
//! ```
//! use seamwright_machine::{Machine, shipped};
//! use seamwright_motion::PassMotion;
//! use seamwright_weld::Welding;
//!
//! let job = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml"));
//! let welding = Welding::read("ellipse.toml", job).unwrap();
//! let machine = Machine::read("ellipse-xy", shipped("ellipse-xy").unwrap().text).unwrap();
//! let motion = PassMotion::plan(&machine, &welding.path(0), &welding.program.value.passes[0], 1).unwrap();
//! for point in motion.set_points(1e-3) {
//!     assert!(machine.outside(&point.q).is_none());
//! }
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod arc_limits;
pub mod corners;
mod cures;
mod effort;
pub mod feed_override;
pub mod fine;
mod follower;
pub mod jog;
mod joint_path;
mod limit_kind;
mod limits;
mod pass_channels;
mod pass_clearance;
mod pass_motion;
mod pass_time;
mod planned;
pub mod procedure;
pub mod pulses;
pub mod redundancy;
mod set_points;
mod singular;
pub mod speed_profile;
mod stretch;
mod survey;
pub mod taught;
pub mod textbook;
mod tip_channels;
mod tip_path;
pub mod transfer;
mod weave_limits;
mod weld_motion;

pub use effort::{Effort, SearchProgress, SearchStage, Stop, Watch};
pub use joint_path::{JointPath, JointPoint};
pub use limit_kind::LimitKind;
pub use limits::{Binding, plain};
pub use pass_clearance::PassClearance;
pub use pass_motion::PassMotion;
pub use set_points::{Phase, SetPoint, SetPoints};
pub use speed_profile::{Leg, ProfilePoint, SpeedProfile, SpeedReport};
pub use tip_path::TipPath;
pub use weld_motion::{Stage, Terms, WeldMotion};
