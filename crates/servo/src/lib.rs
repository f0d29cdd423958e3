//! Position loop and the drive model used in simulation.
//!
//! One axis at a time. A length in mm or an angle in rad is just a "unit" (u) here; time is in
//! seconds. Everything is a plain state machine: it takes its inputs as arguments, reads no clock,
//! does not allocate once built, and does not panic.
//!
//! ```text
//!             ┌────────────── ServoAxis::step, once a servo period ───────────────┐
//! SetPoint ──►│ PositionLoop ──► Notch ──► Drive (velocity loop, current) ──► Load │──► AxisState
//!   (t_k)     │      ▲                                                          │ │
//!             │      └────────────────── Encoder (whole counts) ◄───────────────┘ │◄── disturbance
//!             └───────────────────────────────────────────────────────────────────┘
//! ```
//!
//! On a real machine only [`PositionLoop`] (with its [`Notch`]) runs; [`Drive`], [`Load`] and
//! [`Encoder`] stand in for the hardware in simulation. [`tune()`] finds the gains of a loop, [`Margins`] are its
//! stability margins, and [`StepperMotor`] is the model of a stepper.
//!
//! **Mechanics.** Two masses on a spring with a gap, integrated by Verlet's method between loads in closed form
//! (`mechanism`). **Responses** are sines over a constant speed, fitted by least squares (`response`, `sweep`).
//! **Tuning** derives gains and notch filters from the measured Nyquist curve (`design`, `margins`).
//!
//! # Examples
//!
//! Move a simulated axis by 0.1 mm:
//!
//! ```
//! use seamwright_servo::{DriveParameters, DriveTuning, Gains, LinearLoad, ServoAxis, SetPoint};
//!
//! let load = LinearLoad { mass_kg: 60.0, peak_force_n: 500.0, coulomb_n: 25.0, viscous_n_s_per_m: 60.0 };
//! let tuning = DriveTuning {
//!     velocity_bandwidth_hz: 80.0,
//!     current_time_constant_s: 3e-4,
//!     current_delay_s: 0.0,
//!     encoder_counts_per_unit: 1000.0,
//! };
//! let mut axis = ServoAxis::new(Gains::suggested(80.0, 1e-3), 200.0, DriveParameters::linear(load, tuning)?, 1e-3)?;
//! axis.settle_at(5.0, 0.0);
//! for _ in 0..500 {
//!     axis.step(SetPoint { position: 5.1, ..SetPoint::default() }, 0.0);
//! }
//! assert!((axis.drive().position() - 5.1).abs() < 0.002);
//! # Ok::<(), seamwright_servo::Error>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod axis;
mod compensation;
mod design;
mod drive;
mod encoder;
mod error;
mod load;
mod margins;
mod mechanism;
mod notch;
mod parameters;
mod position_loop;
mod response;
mod stepper;
mod sweep;
mod trial;
mod tune;

pub use axis::{AxisState, ServoAxis};
pub use compensation::{BacklashCompensation, FrictionCompensation};
pub use design::NotchSettings;
pub use drive::{Disturbance, Drive};
pub use encoder::Encoder;
pub use error::Error;
pub use load::Load;
pub use margins::{Margins, decibels, unwrapped};
pub use notch::Notch;
pub use parameters::{DriveParameters, DriveTuning, EncoderSide, LinearLoad, RotaryLoad, Transmission};
pub use position_loop::{Gains, PositionLoop, SetPoint};
pub use response::loop_response;
pub use stepper::{StepperMotor, StepperParameters};
pub use sweep::Line;
pub use tune::{REQUIRED, Tuned, tune};
