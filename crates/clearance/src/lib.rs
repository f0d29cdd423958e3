//! Clearance of solids: in one configuration, and along a whole motion.
//!
//! A [`Solid`] is a [`Shape`] in a pose. A [`Scene`] holds groups of solids that move rigidly (links, torch, part,
//! fixtures) and their conditions: each [`Watch`] keeps two groups apart, or a group inside permitted zones.
//! [`Scene::along`] follows a [`Motion`] and computes lower bounds that hold also *between* samples, so thin obstacles
//! are never skipped.
//!
//! Reported distances and margins are lower bounds. Every distance is proven by a plane between the solids, independent
//! of the iteration that found the plane.
//!
//! mm throughout; this crate has no machine, welding, time or file access: a closure provides STL bytes.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod along;
mod boxes;
mod clamped;
mod convex;
mod distance;
mod error;
mod file;
mod mesh;
mod scene;
mod shape;
mod stl;
mod zone;

pub use along::{Cell, Limits, Motion, Profile, Stretch, Trace};
pub use clamped::Clamped;
pub use distance::{Near, nearest};
pub use error::ClearanceError;
pub use file::{ShapeFile, SolidFile};
pub use mesh::Mesh;
pub use scene::{Evaluation, Group, Memory, Place, Scene, Watch};
pub use shape::{Shape, Solid};
pub use stl::read_stl;
