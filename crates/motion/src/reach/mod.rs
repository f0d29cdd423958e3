//! Placements of the work at which a machine can weld a whole seam, and the one with the largest margin.
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | judge one placement | [`PlacementTask::judge`] |
//! | describe the placements to search | [`ReachGrid`] |
//! | search them: a grid, then a local search | [`search`] |
//!
//! # Units and frames
//!
//! A [`Placement`] is a displacement of the work from its present position, in the work frame: mm, and rad about the
//! vertical through a pivot.
//!
//! A base placement is the same of the machine's base, in the base frame. It is judged on a machine that has its base
//! there: see the search of the `project` crate.
//!
//! # Method
//!
//! A placement is judged as the planner starts a pass: redundant axes are resolved, the axes follow the whole path on one
//! branch, and whole turns are chosen. Then ranges, speeds and welding positions are checked. Speed profile, clearance and
//! transfer moves are not: plan the best placement before you rely on it. Redundant axes are searched quickly, so a
//! placement can be rejected that a thorough search would accept, but none is accepted without a motion.
//!
//! The grid's placements are judged from coarse to fine. From the best ones a compass search (Kolda, Lewis and Torczon,
//! "Optimization by direct search", 2003) moves along one coordinate at a time and halves its step where none helps.

mod judge;
mod margin;
mod placement;
mod search;

pub use judge::PlacementTask;
pub use margin::{FaultKind, Judgement, MarginAxis, PlacementFault, PlacementMargin};
pub use placement::{Moved, Pivot, Placement, ReachGrid, ReachSpan, SpanError};
pub use search::{Judged, SearchResult, search};
