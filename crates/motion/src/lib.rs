//! Turns a torch path and a machine into set-points over time.
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | plan a whole program with the transfer moves between its passes | [`WeldMotion::plan`] |
//! | plan one pass | [`PassMotion::plan`] |
//! | play a pass period by period, in constant memory, without allocation | [`PassMotion::set_points`] |
//! | see which limit binds where | [`PassMotion::certificate`], a [`Certificate`](speed_profile::Certificate) |
//! | play a motion under an operator's commands: override, hold, resume, reverse | [`feed_override`] |
//! | find a placement of the work at which the whole seam is weldable | [`reach`] |
//! | move axes without a path | [`jog`], [`transfer`] |
//! | follow any number of taught points | [`taught`] |
//! | compare a plan with a welding procedure specification | [`procedure`] |
//! | find the fastest speed profile of any path | [`speed_profile`] |
//! | interpolate coarse set-points; make step and direction pulses | [`fine`], [`pulses`] |
//!
//! A pass consists of the path of the axes ([`JointPath`]), the speed profile ([`SpeedProfile`]) and the process
//! sequence. The profile is the fastest one up to the requested speed within every axis' speed, acceleration and jerk.
//!
//! # Units and frames
//!
//! Lengths are in mm, angles in rad, times in s. Axis positions are in the order of
//! [`Machine::axes`](seamwright_machine::Machine::axes). A path length `s` counts from the start of the pass. Torch
//! poses are in the work frame.
//!
//! # Errors
//!
//! Planning returns all [`Finding`](seamwright_program::Finding)s against a weld, not only the first. Each has the
//! pass, the stretch of the seam and usually a cure. A planned motion has remarks only: [`PassMotion::findings`].
//!
//! # Examples
//!
//! Plan a supplied example, and play it:
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
//!
//! The same weld at 200 mm/s is too fast: the acceleration of axis x allows 80 mm/s in the bends.
//!
//! ```
//! # use seamwright_machine::{Machine, shipped};
//! # use seamwright_motion::PassMotion;
//! # use seamwright_weld::Welding;
//! # let job = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml"));
//! # let machine = Machine::read("ellipse-xy", shipped("ellipse-xy").unwrap().text).unwrap();
//! let job = job.replace("speed_mm_s = 5", "speed_mm_s = 200");
//! let welding = Welding::read("ellipse.toml", &job).unwrap();
//! let findings = PassMotion::plan(&machine, &welding.path(0), &welding.program.value.passes[0], 1).unwrap_err();
//! assert!(findings.iter().any(|finding| finding.kind == "speed" && finding.cure.is_some()));
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
mod pass_channels;
mod pass_clearance;
mod pass_heat;
mod pass_motion;
mod pass_order;
mod pass_time;
mod path_source;
mod placed_path;
mod planned;
pub mod procedure;
pub mod pulses;
pub mod reach;
pub mod redundancy;
mod set_points;
mod singular;
mod speed_findings;
pub mod speed_profile;
mod start_turn;
mod stretch;
mod survey;
pub mod taught;
mod tip_channels;
mod tip_path;
mod torch_search;
pub mod transfer;
mod verification;
mod waits;
mod weave_limits;
mod weld_motion;

pub use effort::{SearchProgress, SearchStage, Stop, Watch};
pub use joint_path::{JointPath, JointPoint};
pub use limit_kind::LimitKind;
pub use pass_clearance::PassClearance;
pub use pass_heat::{PassHeat, ROOM_C};
pub use pass_motion::PassMotion;
pub use set_points::{Phase, SetPoint, SetPoints};
pub use speed_findings::{Binding, plain};
pub use speed_profile::{Leg, ProfilePoint, SpeedProfile, SpeedReport};
pub use tip_path::TipPath;
pub use torch_search::{AngleChange, AngleLimits, AngleSearch, AngleTask, search_angles};
pub use weld_motion::{MetalByPass, Stage, Terms, WeldMotion};
