//! Clearance of solids: in one configuration, and along a whole motion.
//!
//! - A [`Solid`] is a [`Shape`] in a pose. [`nearest`] computes the distance of two solids.
//! - A [`Scene`] holds groups of solids that move rigidly: links, torch, part, fixtures. Each [`Watch`] of it keeps two
//!   groups apart, or a group inside permitted zones.
//! - [`Scene::along`] follows a [`Motion`].
//!
//! This crate has no machine, welding, time or file access: a closure provides the bytes of STL files.
//!
//! # Guarantees
//!
//! - Reported distances and margins are lower bounds, along a motion also *between* samples. So thin obstacles are never
//!   skipped.
//! - Every distance is proven by a plane between the solids, independent of the iteration that found the plane.
//!
//! # Units and frames
//!
//! Lengths are in mm. A shape is in its own frame, a solid in that of its group; the frames of groups are arguments.
//!
//! # Examples
//!
//! A clamp beside a gas cup:
//!
//! ```
//! use glam::{DAffine3, DVec3};
//! use seamwright_clearance::{Shape, Solid, nearest};
//!
//! let nozzle = Solid::new("gas cup", Shape::Cylinder { radius: 10.0, length: 80.0 }, DAffine3::IDENTITY)?;
//! let beside = DAffine3::from_translation(DVec3::new(20.0, 0.0, 40.0));
//! let clamp = Solid::new("clamp", Shape::Sphere { radius: 5.0 }, beside)?;
//! let frame = DAffine3::IDENTITY;
//! // Pairs that are further apart than the limit are not computed.
//! let near = nearest(&nozzle, &frame, &clamp, &frame, 10.0);
//! assert!(near.is_some_and(|near| (near.distance - 5.0).abs() < 1e-3));
//! assert!(nearest(&nozzle, &frame, &clamp, &frame, 2.0).is_none());
//! # Ok::<(), seamwright_clearance::ClearanceError>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod along;
mod boxes;
mod cells;
mod clamped;
mod convex;
mod distance;
mod error;
mod file;
mod mesh;
mod permitted_zone;
mod placed;
mod scene;
mod shape;
mod stl;
mod swept;

pub use along::{Cell, Limits, Motion, Profile, Stretch, Trace};
pub use cells::Cells;
pub use clamped::Clamped;
pub use distance::{Near, nearest};
pub use error::ClearanceError;
pub use file::{ShapeFile, SolidFile};
pub use mesh::Mesh;
pub use scene::{Evaluation, Group, Memory, Place, Scene, Watch};
pub use shape::{Shape, Solid};
pub use stl::read_stl;
