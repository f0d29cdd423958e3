//! Common parts of the protocols of robot controls.

use seamwright_machine::Joints;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A report of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotReport {
    /// Time on the control's clock, s.
    pub clock_s: f64,
    /// Measured positions in the order of the control's joints, rad or mm.
    pub joints: Joints,
    /// Whether the control takes set-points.
    pub state: RobotState,
    /// Joints with a fault of their own, one bit each.
    pub fault: u16,
    /// The control has begun a new session: earlier set-points are forgotten.
    pub begins: bool,
}

/// Whether a control takes set-points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RobotState {
    /// It follows them.
    Follows,
    /// It will, once it is ordered to.
    Ready,
    /// It does not.
    Hindered(Hindrance),
}

/// Reason why a robot does not follow set-points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Hindrance {
    /// Its motors are off, or its brakes are on.
    MotorsOff,
    /// Protective stop.
    ProtectiveStop,
    /// Safeguard stop.
    SafeguardStop,
    /// Emergency stop.
    EmergencyStop,
    /// A fault or violation that the control's safety system found.
    SafetyFault,
    /// The program on the control does not run.
    ProgramStopped,
    /// The program on the control is another one, or of another version.
    OtherProgram,
    /// The control's motion interface reports an error.
    ControlError,
    /// Set-points were missing.
    Starved,
    /// A set-point was too far from the last one.
    Jump,
    /// The connection was lost.
    Disconnected,
}

impl Hindrance {
    /// Returns its message.
    #[must_use]
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::MotorsOff => "cell-robot-motors-off",
            Self::ProtectiveStop => "cell-robot-protective-stop",
            Self::SafeguardStop => "cell-robot-safeguard-stop",
            Self::EmergencyStop => "cell-robot-emergency-stop",
            Self::SafetyFault => "cell-robot-safety-fault",
            Self::ProgramStopped => "cell-robot-program-stopped",
            Self::OtherProgram => "cell-robot-other-program",
            Self::ControlError => "cell-robot-control-error",
            Self::Starved => "cell-robot-starved",
            Self::Jump => "cell-robot-jump",
            Self::Disconnected => "cell-robot-disconnected",
        })
    }
}

/// An order to a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotOrder {
    /// Positions in the order of the control's joints, rad or mm.
    pub joints: Joints,
    /// The robot follows; otherwise it stops and stands.
    pub follows: bool,
    /// Number of the order: the control's sign of life from us.
    pub number: u32,
}

/// Data that a protocol refuses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ProtocolError {
    /// Bytes that are no message of the protocol.
    Malformed,
    /// The control refuses the version of the protocol.
    Version,
    /// The control does not know these fields of a recipe.
    UnknownFields(String),
    /// Another program uses these fields.
    FieldsInUse(String),
    /// The control refuses to start its reports.
    NotStarted,
    /// Positions of this number of joints arrived, and another number is needed.
    Joints {
        /// Joints of the report.
        reported: usize,
        /// Joints that the machine file needs.
        needed: usize,
    },
}

impl ProtocolError {
    /// Returns its message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Malformed => Message::new("cell-robot-malformed"),
            Self::Version => Message::new("cell-robot-version"),
            Self::UnknownFields(fields) => Message::new("cell-robot-unknown-fields").text("fields", fields),
            Self::FieldsInUse(fields) => Message::new("cell-robot-fields-in-use").text("fields", fields),
            Self::NotStarted => Message::new("cell-robot-not-started"),
            Self::Joints { reported, needed } => {
                Message::new("cell-robot-joints").count("reported", *reported).count("needed", *needed)
            }
        }
    }
}

/// The newest datagram, until it is read.
#[derive(Debug, Default)]
pub(super) struct Datagram(Vec<u8>);

impl Datagram {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Takes one that arrived; an earlier one that was not read is dropped.
    pub(super) fn put(&mut self, bytes: &[u8]) {
        self.0.clear();
        self.0.extend_from_slice(bytes);
    }

    /// Returns it once.
    pub(super) fn take(&mut self) -> Option<Vec<u8>> {
        Some(std::mem::take(&mut self.0)).filter(|bytes| !bytes.is_empty())
    }
}

/// A protocol of a robot control: bytes in, reports out; orders in, bytes out. It has neither clock nor socket.
///
/// # Contract
/// No input panics, and memory is bounded. After an error the connection is made anew, with [`RobotProtocol::begin`].
pub trait RobotProtocol: fmt::Debug + Send {
    /// Starts a connection: forgets the last one, and appends the first request to `out`.
    fn begin(&mut self, out: &mut Vec<u8>);

    /// Takes bytes that arrived: a part of the stream, or one datagram.
    ///
    /// # Errors
    /// Bytes that are no message.
    fn feed(&mut self, bytes: &[u8]) -> Result<(), ProtocolError>;

    /// Returns the next report; `None` if more bytes are needed. Appends answers to requests to `out`.
    ///
    /// # Errors
    /// Invalid messages, and refusals of the control.
    fn next(&mut self, out: &mut Vec<u8>) -> Result<Option<RobotReport>, ProtocolError>;

    /// Appends the message of an order to `out`.
    fn order(&mut self, order: &RobotOrder, out: &mut Vec<u8>);

    /// Returns true if the control holds the last set-point when it does not follow; otherwise a program on the control
    /// stops the robot by itself.
    fn holds_last(&self) -> bool;
}
