//! Plans by workers of a cluster, which have neither the table nor the files of its jobs.
//!
//! - `task`: what all workers get once, and what they make of a piece of work.
//! - `spark`: the program that hands pieces to a Spark cluster, and its results.

mod spark;
mod task;

pub(crate) use spark::Run;
pub use spark::Spark;
pub use task::Worker;
pub(crate) use task::{DrawPiece, DrawPlanned, RowPiece, RowPlanned, Task, Work, parsed, text};
