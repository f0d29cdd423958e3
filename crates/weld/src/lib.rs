//! Job files, seams and torch attitude: converts a job into a program and the path of the torch.
//!
//! [`Welding`] reads a [`Job`] or a program. It holds the program, the seam ([`SeamCurve`]), the joint ([`SeamJoint`])
//! and the plan of its beads ([`BeadPlan`]). [`Welding::path`] is the [`TorchPath`](seamwright_program::TorchPath) of a
//! pass. This crate is independent of machines; [`Outside`] gives it access to files and machines.
//!
//! # Examples
//!
//! Read a job, and evaluate its path:
//!
//! ```
//! use seamwright_program::TorchPath;
//! use seamwright_weld::Welding;
//!
//! let job = r#"
//! schema = 1
//! title = "Straight fillet weld"
//! machine = "torch-5axis"
//! [seam.line]
//! start_mm = [0, 0, 0]
//! end_mm = [400, 0, 0]
//! first_normal = [0, 1, 0]
//! second_normal = [0, 0, 1]
//! [weld]
//! speed_mm_s = 5
//! "#;
//! let welding = Welding::read("job.toml", job)?;
//! let path = welding.path(0);
//! assert!((path.length() - 400.0).abs() < 1e-9);
//! assert!((path.pose(200.0).point.x - 200.0).abs() < 1e-9);
//! # Ok::<(), seamwright_document::DocumentError>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod allowed;
mod angles;
mod attitude;
mod bead_line;
mod bead_path;
mod beads;
mod body;
mod branch;
mod girth;
mod job;
mod job_program;
mod joint;
mod nozzle;
mod order;
mod outside_data;
mod part;
mod pass_findings;
mod pass_keys;
mod pass_path;
mod periodic_places;
mod plane_seam;
mod points;
mod procedure;
mod scan;
mod seam;
mod space_seam;
mod spline_seam;
mod stick_out;
mod stretch;
mod surfaces;
mod t_joint;
mod taught;
mod tube_cut;
mod vessel_head;
mod weld_path;
mod welding;

pub use attitude::Attitude;
pub use bead_line::{BeadLine, BesideSeam};
pub use bead_path::BeadPath;
pub use beads::{Adapt, BeadAt, BeadNumbers, BeadPlan, Beads, Layer, Order, Run, ToeAt, Toes};
pub use job::{Job, Station, Weld};
pub use joint::{Groove, SeamJoint, Section};
pub use nozzle::NozzleEdges;
pub use order::{Cosmetic, Parts, Rows, Rule, ShortSequence, Tacks, Turns, WeldOrder};
pub use outside_data::{NoFiles, Outside, Wrong};
pub use part::Metal;
pub use pass_keys::PassKeys;
pub use pass_path::PassPath;
pub use points::{MachineAxes, MachineAxis, PointPath};
pub use scan::{GrooveScan, GrooveScanner, Measured, NoScan, SensorView, is_symmetrical};
pub use seam::{SeamCurve, SeamPoint};
pub use stretch::Stretch;
pub use surfaces::SeamSurfaces;
pub use taught::TaughtSpan;
pub use tube_cut::{Cut, CutPoint, Unrolled};
pub use weld_path::WeldPath;
pub use welding::Welding;
