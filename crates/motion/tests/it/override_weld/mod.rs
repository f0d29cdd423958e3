//! Commands at any time on the examples' own motion: on the path, in limits, to the same end.

#![allow(clippy::float_cmp, reason = "what rests does not move at all")]

mod fuzz;
mod orders;
mod rates;
mod welds;
