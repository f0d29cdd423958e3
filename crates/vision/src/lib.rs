//! Frames, and the detection of joints and laser stripes in them.
//!
//! - [`Frame`] is a borrowed grey picture, [`Image`] one that owns its pixels.
//! - [`joint`] follows a joint, a dark line on lighter metal: [`joint::Follower`].
//! - [`stripe`] reads the joint in a laser stripe: [`stripe::StripeReader`].
//! - [`camera`] calibrates a camera by a picture of a grid.
//!
//! All are pure functions of pixels: no files, clocks or cameras.
//!
//! # Examples
//!
//! Follow a joint through a drawn frame:
//!
//! ```
//! use seamwright_vision::joint::{End, Follower, Options, Start};
//! use seamwright_vision::{Frame, Pixels};
//! use std::f64::consts::LN_2;
//!
//! // A joint along y = 200.3, 4.5 pixels wide.
//! let depth = |y: f64| 60.0 * (-4.0 * LN_2 * ((y - 200.3) / 4.5).powi(2)).exp();
//! let pixels: Vec<u8> = (0..512 * 512).map(|i| (150.0 - depth(f64::from(i / 512))).round() as u8).collect();
//! let frame = Frame::new(512, 512, Pixels::U8(&pixels))?;
//! let mut follower = Follower::new(Options::default());
//! let joint = follower.follow(&frame, &Start { x: 8.0, y: 201.3, direction: 0.05, width: None });
//! assert_eq!(joint.end, End::LeftImage);
//! assert!(joint.rows.last().is_some_and(|row| row.x > 500.0));
//! # Ok::<(), seamwright_vision::FrameError>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod aligned;
pub mod camera;
mod frame;
pub mod joint;
pub mod region_growing;
mod simd;
pub mod stripe;

pub use frame::{Frame, FrameError, Image, MAX_SIDE, Pixels};
