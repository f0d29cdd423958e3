//! Teaching a path by camera (EBW-2004): frame, midline, next move along it, frame.
//!
//! The operator puts the camera on the joint's start and gives its rough direction. A [`Crawl`] then requests moves and
//! frames in turn, until the joint ends, returns to its start, or the machine can go no further. If it loses the joint,
//! it asks the operator and continues from the given point (SADDLE-2020 teaches by such points alone). It is
//! independent of devices, machines and clocks: [`Event`]s go in, [`Command`]s come out. [`smoothed`], [`torch_axes`]
//! and [`to_program`] turn the resulting [`TaughtLine`] into a program of lines and arcs, or of a spline.
//!
//! - Every point comes from the frame that saw it nearest to the picture's centre, where errors of scale, attitude and
//!   height matter least.
//! - A frame starts on the stretch that the previous one saw; if both disagree, its points are discarded.
//! - Heights between measured positions come from the surrounding frames ([`levelled`]).
//! - Only confident rows count: an extrapolated stretch has no points, and the report names it.
//!
//! **Heights.** Pixels are intersected with the nominal surface, raised to the height that was measured with the frame.
//! At the end they are intersected once more, with the surface raised to the heights of the surrounding frames
//! together.
//!
//! **Line.** Local parabolas smooth the line. It is then reduced to lines and arcs, or to a spline.

mod attitude;
mod crawl;
mod events;
mod height;
mod line;
mod note;
mod program;
mod seam_line;
mod settings;
mod sight;
mod smooth;

pub use attitude::{Lean, torch_axes};
pub use crawl::Crawl;
pub use events::{Answer, CameraPose, Command, End, Event, Seen};
pub use height::levelled;
pub use line::{RawPoint, Source, TaughtLine};
pub use note::CameraNote;
pub use program::{Curves, Kind, Reduced, ReductionTolerances, to_program};
pub use seam_line::{Foot, STATION_MM, SeamLine, Station};
pub use settings::Settings;
pub use sight::{Aim, FrameEnd, Patch, Row, Shape, View};
pub use smooth::{LinePoint, smoothed};
