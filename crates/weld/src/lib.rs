//! Job files, seams and torch attitude: converts a job into a program and the path of the torch.
//!
//! Floor 2: independent of machines. [`Welding`] reads a job or a program and has the program, the seam and the
//! [`TorchPath`](seamwright_program::TorchPath) of its pass.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod allowed;
mod angles;
mod attitude;
mod bead_line;
mod beads;
mod body;
mod branch;
mod cut;
mod girth;
mod head;
mod job;
mod joint;
mod nozzle;
mod order;
mod outside;
mod part;
mod pass_findings;
mod pass_keys;
mod pass_path;
mod plane;
mod points;
mod procedure;
mod seam;
mod space;
mod spline;
mod stations;
mod stretch;
mod surfaces;
mod t_joint;
mod taught;
mod weld_path;
mod welding;

pub use attitude::Attitude;
pub use bead_line::BeadLine;
pub use beads::{Adapt, BeadAt, BeadPlan, Beads, Layer, Order, Run};
pub use cut::{Cut, CutPoint, Unrolled};
pub use job::{Job, Weld};
pub use joint::{SeamJoint, Section};
pub use nozzle::NozzleEdges;
pub use order::{Cosmetic, Parts, Rows, Rule, ShortSequence, Tacks, Turns, WeldOrder};
pub use outside::{NoFiles, Outside, Wrong};
pub use pass_keys::PassKeys;
pub use pass_path::PassPath;
pub use points::{MachineAxes, MachineAxis, PointPath};
pub use seam::{SeamCurve, SeamPoint};
pub use stations::Station;
pub use stretch::Stretch;
pub use surfaces::SeamSurfaces;
pub use taught::TaughtSpan;
pub use weld_path::WeldPath;
pub use welding::Welding;
