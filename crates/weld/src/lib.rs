//! Job files, seams and torch attitude: from what is to be welded to a program and the path of the torch.
//!
//! Floor 2: knows no machine. A [`Job`] becomes a [`Program`](seamwright_program::Program) with [`Job::program`]; a
//! pass of a program becomes a [`TorchPath`](seamwright_program::TorchPath) with [`PassPath`].

mod attitude;
mod job;
mod pass_path;
mod seam;

pub use attitude::Attitude;
pub use job::{Job, Weld};
pub use pass_path::PassPath;
pub use seam::{SeamCurve, SeamPoint};
