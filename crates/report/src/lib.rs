//! Reports: plots as SVG and one self-contained HTML page.
//!
//! Pure data in, `String` out: numbers and curves that an engineer can judge at a glance. They suit screens (light or
//! dark), telephones and A4 paper. The output loads no script, font or image from elsewhere. Only the folders `weld`,
//! `record` and `machine` depend on welding and machines: they fill the page with a planned weld, a recorded one, a
//! machine.
//!
//! - [`Chart`] plots series over one axis, against limits; [`ChartGrid`] sets several on one x axis.
//! - [`Bode`] plots a frequency response with its margins.
//! - [`ThreeViews`] draws a curve in space in first-angle projection.
//! - [`Tornado`] shows the effect of several quantities on one figure.
//! - [`WeldMap`] unrolls a weld: its passes with starts, stops and tacks along the seam.
//! - [`Page`] combines figures, tables, findings and listings in one HTML file.
//!
//! Each [`Drawing`] comes in two forms: `to_svg` for a [`Page`], which carries the styles, and `to_svg_standalone` for a
//! file of its own.
//!
//! # Examples
//!
//! Draw a speed over the path length, with its limit:
//!
//! ```
//! use seamwright_report::{Axis, Chart, Drawing, LimitLine, Series};
//!
//! let chart = Chart {
//!     title: "Speed".into(),
//!     x: Axis::new("s", "mm"),
//!     y: Axis::new("v", "mm/s"),
//!     series: vec![Series::line("reached", vec![(0.0, 0.0), (5.0, 10.0), (95.0, 10.0), (100.0, 0.0)])],
//!     limits: vec![LimitLine::new("limit", 12.0)],
//!     ..Chart::default()
//! };
//! assert!(chart.to_svg_standalone().contains("<svg"));
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod block;
mod bode;
mod chart;
mod domain;
mod gallery;
mod gantt;
mod glyph;
mod grid;
mod icon;
mod label_placement;
mod layout;
mod legend;
mod limit;
mod machine;
mod number;
mod order_drawing;
mod page;
mod plot;
mod projection;
mod reach;
mod record;
mod series;
mod sheet;
mod style;
mod svg;
mod text;
mod thinning;
mod three_views;
mod ticks;
mod tornado;
mod value_names;
mod weld;
mod weld_map;
mod words;

pub use block::{Block, Finding, Severity, Table, Tile};
pub use bode::Bode;
pub use chart::{Axis, Band, Chart, Stretch};
pub use gallery::{DrawnBead, Gallery, SectionDrawing};
pub use gantt::{Gantt, GanttBar, GanttRow};
pub use grid::ChartGrid;
pub use limit::LimitLine;
pub use machine::{MachineDrawing, check_page, check_text};
pub use number::format_number;
pub use order_drawing::{OrderDrawing, OrderedLine};
pub use page::{Page, Verdict};
pub use reach::{BestPlacement, PlacementRow, ReachCell, ReachFigures, ReachMap, reach_page};
pub use record::recorded_weld_page;
pub use seamwright_message::Language;
pub use series::{Series, Style};
pub use sheet::sheet;
pub use svg::Drawing;
pub use three_views::{Mark, ThreeViews};
pub use tornado::{Tornado, TornadoRow};
pub use weld::{CertificateFigures, Extent, PassFigures, Plots, PostFigures, SimulationCurves, WeldReport, sections};
pub use weld_map::{MapPiece, MapRow, WeldMap};
pub(crate) use words::Words;
