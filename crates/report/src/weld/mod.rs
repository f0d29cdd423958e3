//! The report of one weld: its numbers ([`WeldReport`], which is also `report.json`), its plots and its page.

mod axis_units;
mod certificate;
mod charts;
mod curves;
mod cut_template;
mod figures;
mod job;
mod joint_facts;
mod limits;
mod map;
mod materials;
mod overview;
mod page;
mod passes;
mod plan;
mod post_verification;
mod procedure;
mod range;
mod run_windows;
mod samples;
mod sections;
mod simulated;
mod taught;
mod totals;
mod tracking;
mod weave_charts;
mod welding_order;

pub use certificate::CertificateFigures;
pub use charts::Plots;
pub use curves::SimulationCurves;
pub use figures::{PassFigures, WeldReport};
pub use page::Extent;
pub use post_verification::PostFigures;
pub use sections::sections;
