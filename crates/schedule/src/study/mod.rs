//! Studies: one job planned with many drawn values.
//!
//! - `open`: the study file with its job and machine, and what varies.
//! - `draw`: the values of a draw, and the job and machine that they make.
//! - `figures`: figures of a plan.
//! - `run`: all draws by several threads.
//! - `columns`: result files, and columns read back.
//! - `summary`: statistics; `report` shows them.

mod columns;
mod draw;
mod figures;
mod open;
mod report;
mod run;
mod summary;

pub use draw::DrawResult;
pub(crate) use draw::DrawTerms;
pub use open::{Overrides, Study};
pub use run::{StudyProgress, StudyRun};
pub use summary::{
    FigureSummary, FindingSummary, IndexSummary, Outcome, Quantiles, QuantitySummary, StudySummary, SweepFigure,
    SweepPoint, SweepSummary, Swing,
};
