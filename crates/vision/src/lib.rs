//! Frames, and the detection of joints and laser stripes in them. Pure functions of pixels: no files, clocks or
//! cameras.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod aligned;
pub mod camera;
mod frame;
pub mod joint;
pub mod region_growing;
pub mod stripe;
#[cfg(test)]
mod testing;
mod wide;

pub use frame::{Frame, FrameError, Image, MAX_SIDE, Pixels};
