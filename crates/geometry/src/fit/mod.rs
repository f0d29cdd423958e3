//! Rigid motions from measured points: the pose of a part found by touching it.
//!
//! All fits map the nominal part's frame to the frame in which the points were measured.
//!
//! - [`fit_pairs`]: points with nominal positions.
//! - [`plane_line_point`]: touches of three faces that define the frame.
//! - [`three_points`]: a plane with two marks on it; [`chuck`]: a face and a round.
//! - [`best_fit`]: touches of surfaces with a [`SignedDistance`](crate::SignedDistance).
//! - [`run_out`]: touches around a tube that turns about its nominal axis.
//! - [`pivot`]: the tip of a tool, brought to one fixed point from several attitudes.

mod best_fit;
mod datums;
mod free_motion;
mod pivot;
mod placing;
mod point_pairs;
mod run_out;
mod statistics;
mod twist;

pub use best_fit::{BestFit, Touch, best_fit};
pub use datums::{DatumFit, plane_line_point};
pub use free_motion::Motion;
pub use pivot::{PivotFit, pivot};
pub use placing::{Placing, chuck, three_points};
pub use point_pairs::{PairFit, fit_pairs};
pub use run_out::{RunOut, run_out};
pub use statistics::{outliers, rms};
pub use twist::Deviation;
