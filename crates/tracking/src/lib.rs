//! Seam tracking: measures and corrects the deviation of a seam during welding.
//!
//! - [`lead`] tracks the seam with a sensor ahead of the torch: [`lead::Tracker`] estimates its deviation.
//! - [`beam`] tracks with an electron beam that looks at the joint in short interruptions of the weld.
//! - [`actuator`] carries corrections out: with cross slides, the machine's own axes or the beam's deflection.
//!
//! All are plain state machines: measurements, positions and time are arguments.
//!
//! # Examples
//!
//! Track a part that is turned a little:
//!
//! ```
//! use glam::DVec2;
//! use seamwright_tracking::lead::{Measurement, Moment, OwnCurve, Settings, Tracker};
//!
//! // A sensor 20 mm ahead of the torch. The part is turned a little: 0.01 mm per mm of the seam.
//! let deviation = |s_mm: f64| DVec2::new(0.01 * s_mm, 0.0);
//! let torch = |cycle: u32| (1e-3 * f64::from(cycle), -25.0 + 0.01 * f64::from(cycle));
//! let mut tracker = Tracker::new(Settings::usual(20.0, 100.0), OwnCurve::straight(20.0))?;
//! for cycle in 0..6000 {
//!     let (t_s, s_mm) = torch(cycle);
//!     tracker.advance(Moment { t_s, s_mm, slide: DVec2::ZERO }, s_mm + 0.6);
//!     // A frame every 10 ms, known 15 ms after its exposure.
//!     if cycle > 15 && cycle % 10 == 5 {
//!         let (exposed_s, exposed_mm) = torch(cycle - 15);
//!         tracker.take(&Measurement { exposed_s, offset: deviation(exposed_mm + 20.0), confidence: 1.0 }, t_s);
//!     }
//! }
//! let (_, s_mm) = torch(5999);
//! assert!(tracker.at(s_mm).value.distance(deviation(s_mm)) < 0.05);
//! # Ok::<(), seamwright_tracking::lead::Error>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod actuator;
pub mod beam;
pub mod lead;
