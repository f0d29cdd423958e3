//! The report of one weld: its numbers ([`WeldReport`], which is also `report.json`), its plots and its page.

mod charts;
mod curves;
mod figures;
mod page;
mod plan;
mod samples;

pub use charts::Plots;
pub use curves::SimulationCurves;
pub use figures::WeldReport;
