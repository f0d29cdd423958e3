//! Simulated robot controls that take set-points: Universal Robots RTDE, ABB EGM, KUKA RSI.
//!
//! Each speaks the control's side of its protocol with an [`Arm`] whose servo lags. [`ControlServer`] runs one over a
//! real socket; without it a control is a function of bytes and time. The bytes are made here independently of the
//! clients in `seamwright-executive`, from the same manuals.
//!
//! # Limitations
//! They simulate what the manuals say of the messages, the handshake, the states and the watchdogs; no control was at
//! hand to compare with.

mod arm;
mod egm;
mod looped;
mod rsi;
mod rtde;
mod server;

pub use arm::{Arm, JointPositions, MAX_JOINTS, Servo};
pub use egm::EgmControl;
pub use looped::LoopedRobot;
pub use rsi::RsiControl;
pub use rtde::RtdeControl;
pub use server::{ControlServer, PacketFaults};

/// Disturbances that a test or an operator switches on a control.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Disturbances {
    /// Protective stop of the arm.
    pub protective_stop: bool,
    /// Emergency stop.
    pub emergency_stop: bool,
    /// The motors are off.
    pub motors_off: bool,
    /// The program of the control is stopped.
    pub program_stopped: bool,
    /// The joint, from 0, that has a fault of its own.
    pub joint_fault: Option<usize>,
    /// The protocol's version is refused.
    pub old_version: bool,
    /// A field that the control does not know.
    pub unknown_field: Option<String>,
    /// A field that another client uses.
    pub field_in_use: Option<String>,
    /// The control sends nothing, and takes nothing.
    pub mute: bool,
    /// Number of the arm's joints that EGM reports, if not all.
    pub joints_reported: Option<usize>,
}

/// A simulated control, as a function of bytes and time.
pub trait SimulatedControl: Send {
    /// Period of its messages, s.
    fn period_s(&self) -> f64;
    /// A client has connected, or the control was started again.
    fn connect(&mut self);
    /// Takes bytes that arrived at `t_s`; appends answers to `out`, a message each.
    fn take(&mut self, bytes: &[u8], t_s: f64, out: &mut Vec<Vec<u8>>);
    /// Runs a period that ends at `t_s`; appends the report to `out`.
    fn tick(&mut self, t_s: f64, out: &mut Vec<Vec<u8>>);
    /// Its arm; positions in rad, of RSI and EGM in degrees.
    fn arm(&self) -> &Arm;
    /// Switches disturbances.
    fn disturb(&mut self, disturbances: Disturbances);
    /// True while the arm follows set-points.
    fn follows(&self) -> bool;
}
