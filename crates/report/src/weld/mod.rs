//! The report of one weld: its numbers ([`WeldReport`], which is also `report.json`), its plots and its page.

mod axis_units;
mod certificate;
mod charts;
mod curves;
mod cut;
mod figures;
mod job;
mod limits;
mod order;
mod overview;
mod page;
mod passes;
mod plan;
mod posts;
mod procedure;
mod range;
mod run_windows;
mod samples;
mod sections;
mod simulated;
mod taught;
mod totals;
mod tracking;
mod woven;

pub use certificate::CertificateFigures;
pub use charts::Plots;
pub use curves::SimulationCurves;
pub use figures::{PassFigures, WeldReport};
pub use posts::PostFigures;
pub use sections::sections;
