//! How far solids keep from each other: at one place, and all along a motion.
//!
//! A [`Solid`] is a [`Shape`] in a pose. A [`Scene`] holds groups of solids that move rigidly (links, torch, part,
//! fixtures) and what must hold between them: each [`Watch`] keeps two groups apart, or a group inside permitted
//! zones. [`Scene::along`] follows a [`Motion`] and gives lower bounds that hold *between* the places looked at, so
//! nothing thin is jumped over.
//!
//! One promise holds everywhere: no more distance or room is reported than there is. Every distance is proven by a
//! plane between the solids, whatever the iteration that found the plane did.
//!
//! mm throughout; no machine, no welding, no time and no files in here: STL bytes come in through a closure.

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
