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
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | follow a joint with any camera on any machine | [`teach`], a [`Rig`] and an [`Operator`] |
//! | the decisions from frame to frame | [`Crawl`] |
//! | from a job to its nominal seam, and from the line found to a program | [`nominal`], [`reduced`] |
//! | report the result | [`Outcome`], [`Figures`], [`Picture`] |
//! | teach by the operator's points only | [`semi_manual()`] |
//!
//! This crate has no I/O, clock or thread of its own: frames, moves and answers come through [`Rig`] and [`Operator`].
//! The command line, the panel and the simulation have their own.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod attitude;
mod carrier;
mod crawl;
mod error;
mod events;
mod figures;
mod follower;
mod frame_note;
mod height;
mod job;
mod outcome;
mod picture;
mod planned_weld;
mod program;
mod rig;
mod run;
mod seam_line;
mod semi_manual;
mod settings;
mod smoothing;
mod taught_line;
mod work_shape;

pub use attitude::{Lean, torch_axes};
pub use carrier::{Carrier, Guide};
pub use crawl::Crawl;
pub use error::Error;
pub use events::{Answer, CameraPose, Command, End, Event, Seen};
pub use figures::{Figures, TaughtPoint, bridged, from_nominal};
pub use follower::JointFollower;
pub use frame_note::CameraNote;
pub use height::levelled;
pub use job::{EVERY_MM, follower, nominal, reduced, settings, start};
pub use outcome::{Outcome, finding};
pub use picture::Picture;
pub use planned_weld::PlannedWeld;
pub use program::{Curves, Kind, Reduced, ReductionTolerances, to_program};
pub use rig::Rig;
pub use run::{Found, Look, Midline, NoOperator, Operator, Setup, TaughtRun, teach};
pub use seam_line::{Foot, STATION_MM, SeamLine, Station};
pub use semi_manual::semi_manual;
pub use settings::Settings;
pub use smoothing::{LinePoint, smoothed};
pub use taught_line::{RawPoint, Source, TaughtLine};
pub use work_shape::{Aim, FrameEnd, Patch, Row, Shape, View};
