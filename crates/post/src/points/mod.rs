//! Passes through axis positions and part programs: one as the other, block by block.

mod cubics;
mod from_program;
mod rests;
mod to_program;

pub(crate) use from_program::{Part, ends, event_of, is_posted_as_it_stands, steps};
pub use to_program::to_program;
