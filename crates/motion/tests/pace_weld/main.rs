//! Commands at any time on the examples' own motion: on the path, in limits, to the same end.

#[path = "../pace_law/mod.rs"]
mod pace_law;
mod rates;
mod welds;
