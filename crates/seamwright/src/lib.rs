//! Plans, posts and simulates CNC welds of seams that curve through space: the planner of Seamwright as one dependency.
//!
//! A job (TOML) describes the seam, the torch angles, the speed and the machine. [`load()`] reads it with its machine
//! and its part. [`Loaded::plan`] computes the motion of all axes within every limit, or returns the findings that
//! forbid the weld.
//!
//! ```
//! use seamwright::load;
//! use std::path::Path;
//!
//! // A file, or the name of a shipped example.
//! let job = load(Path::new("first-weld"))?;
//! let motion = job.plan()?;
//! for pass in &motion.passes {
//!     println!("{:.1} mm in {:.1} s", pass.path.length(), pass.profile.duration());
//! }
//! let mut points = motion.passes[0].set_points(job.machine.servo_period_s);
//! assert!(points.all(|point| job.machine.outside(&point.q).is_none()));
//! # Ok::<(), seamwright::Failure>(())
//! ```
//!
//! The folder `examples` of this crate has five programs: `seam`, `plan`, `post`, `own_machine` and `simulate`. Run one
//! with `cargo run --release -p seamwright --example plan`.
//!
//! Each module is a crate of the workspace. Its front page explains its terms and its units: lengths are in mm, angles
//! in rad and times in s, but angles in files and in printed results are in degrees.
//!
//! | module | content |
//! |---|---|
//! | [`project`] | from files to results: jobs, plans with a time limit, proven part programs, shipped examples |
//! | [`weld`] | jobs, seams, joints, beads, torch attitude |
//! | [`program`] | weld programs: passes, spans, process values, procedures, findings |
//! | [`machine`] | machine files, forward and inverse kinematics, limits |
//! | [`motion`] | axis paths, speed profiles, set-points, transfer moves |
//! | [`post`] | part programs for Sinumerik, LinuxCNC, grblHAL, PMAC and robots: write, read, verify |
//! | [`executive`] | the running cell: modes, process, interlocks, alarms, devices, tracking in real time |
//! | [`simulation`] | simulated devices, sensors and cameras, true positions, injected faults |
//! | [`tracking`] | seam tracking |
//! | [`teaching`] | teaching by camera: from frames to a program |
//! | [`frames`] | camera frames: files, recordings, connections |
//! | [`vision`] | joints in camera frames and in laser stripes |
//! | [`geometry`] | curves, surfaces, intersections, arc length |
//! | [`clearance`] | solids and their distances, in a pose and along a motion |
//! | [`document`] | TOML with errors that name file, line and key; bounded number types |
//! | [`message`] | messages as data, and their words in five languages |
//! | [`glam`] | vectors and transforms of all interfaces |
//!
//! Reports, records and the panel belong to the command `seamwright`; they are not in this library.

pub use glam;
#[doc(inline)]
pub use seamwright_clearance as clearance;
#[doc(inline)]
pub use seamwright_document as document;
#[doc(inline)]
pub use seamwright_executive as executive;
#[doc(inline)]
pub use seamwright_frames as frames;
#[doc(inline)]
pub use seamwright_geometry as geometry;
#[doc(inline)]
pub use seamwright_machine as machine;
#[doc(inline)]
pub use seamwright_message as message;
#[doc(inline)]
pub use seamwright_motion as motion;
#[doc(inline)]
pub use seamwright_post as post;
#[doc(inline)]
pub use seamwright_program as program;
#[doc(inline)]
pub use seamwright_project as project;
#[doc(inline)]
pub use seamwright_simulation as simulation;
#[doc(inline)]
pub use seamwright_teaching as teaching;
#[doc(inline)]
pub use seamwright_tracking as tracking;
#[doc(inline)]
pub use seamwright_vision as vision;
#[doc(inline)]
pub use seamwright_weld as weld;

pub use seamwright_project::Failure;
pub use seamwright_project::load::{Loaded, load, load_text};

/// Tests the code of the page in the book.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/how-to/library.md")]
struct HowToPage;
