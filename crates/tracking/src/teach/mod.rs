//! Teaching a path by eye (EBW-2004): frame, midline, next move along it, frame.
//!
//! The operator puts the eye on the joint's start and says roughly which way it goes. A [`Crawl`] then asks for moves and
//! frames, one after the other, until the joint ends, comes back to its start, is lost, or the machine can go no further;
//! lost, it asks the operator, and goes on from the point that he gives (SADDLE-2020 teaches by such points alone). It knows
//! no device, no machine and no clock: [`Event`]s go in, [`Command`]s come out. What it has then is a [`TaughtLine`], which
//! [`smoothed`], [`torch_axes`] and [`to_program`] make into a program of lines and arcs, or of a spline.
//!
//! - Every place on the joint is taken from the frame that saw it nearest to the picture's centre, where errors of scale,
//!   attitude and height matter least.
//! - A frame begins on the stretch that the one before it saw: where they do not agree nothing is taken.
//! - Heights between the places where frames measure them come from the frames about them ([`levelled`]).
//! - Only confident rows count: a stretch that was only coasted over has no points, and the report says so.

mod attitude;
mod crawl;
mod events;
mod height;
mod line;
mod note;
mod program;
mod settings;
mod sight;
mod smooth;

pub use attitude::{Lean, torch_axes};
pub use crawl::Crawl;
pub use events::{Answer, Command, End, Event, EyePose, Seen};
pub use height::levelled;
pub use line::{RawPoint, Source, TaughtLine};
pub use note::EyeNote;
pub use program::{Curves, Kind, Reduced, to_program};
pub use settings::Settings;
pub use sight::{Aim, FrameEnd, Patch, Row, Shape, View};
pub use smooth::{LinePoint, smoothed};
