//! Search for placements: figures, map and page.

mod figures;
mod map;
mod page;

pub use figures::{BestPlacement, PlacementRow, ReachFigures};
pub use map::{ReachCell, ReachMap};
pub use page::reach_page;
