//! Universal Robots' Real-Time Data Exchange (RTDE), version 2, as a client.
//!
//! Source: Universal Robots, "Real-Time Data Exchange (RTDE) Guide" (support page), for messages, fields and the ranges
//! of registers for external clients; "The URScript Programming Language", for `servoj` and `rtde_set_watchdog`.
//!
//! Set-points go to registers of the control, where a program ([`URSCRIPT`]) gives them to `servoj`. It confirms its
//! version, and that it follows, in output registers. Its watchdog ends it when registers are no longer written.

use super::protocol::{Hindrance, ProtocolError, RobotOrder, RobotProtocol, RobotReport, RobotState};
use seamwright_machine::MAX_AXES;

/// The program for the control, in URScript.
pub const URSCRIPT: &str = include_str!("programs/universal_robots.script");
/// Version of the registers' meaning, which the program confirms.
const PROGRAM_VERSION: i32 = 1;

/// Version of the protocol.
const VERSION: u16 = 2;
/// Size of a message's head: its length and its type.
const HEAD: usize = 3;
/// Number of joints.
const JOINTS: usize = 6;
/// Maximum number of bytes that wait for the rest of their message.
const MAX_WAITING: usize = 1 << 17;

/// Types of the messages that are used; texts are for the log of the control.
const REQUEST_VERSION: u8 = b'V';
const DATA: u8 = b'U';
const SETUP_OUTPUTS: u8 = b'O';
const SETUP_INPUTS: u8 = b'I';
const START: u8 = b'S';

/// A field of a recipe, and its type.
type Field = (&'static str, &'static str);

/// Fields that the control reports.
const OUTPUTS: [Field; 9] = [
    ("timestamp", "DOUBLE"),
    ("actual_q", "VECTOR6D"),
    ("joint_mode", "VECTOR6INT32"),
    ("robot_mode", "INT32"),
    ("safety_mode", "INT32"),
    ("runtime_state", "UINT32"),
    ("output_int_register_24", "INT32"),
    ("output_int_register_25", "INT32"),
    ("output_int_register_26", "INT32"),
];
/// Bytes of a report, with the number of its recipe.
const REPORT: usize = 1 + 8 + 48 + 24 + 3 * 4 + 3 * 4;

/// Fields that the control takes: number of the order, 1 to follow, positions. Registers from 24 on are those of external
/// clients.
const INPUTS: [Field; 8] = [
    ("input_int_register_24", "INT32"),
    ("input_int_register_25", "INT32"),
    ("input_double_register_24", "DOUBLE"),
    ("input_double_register_25", "DOUBLE"),
    ("input_double_register_26", "DOUBLE"),
    ("input_double_register_27", "DOUBLE"),
    ("input_double_register_28", "DOUBLE"),
    ("input_double_register_29", "DOUBLE"),
];

/// Modes and states of the guide's tables.
const JOINT_MODE_FAULT: i32 = 252;
const ROBOT_MODE_RUNNING: i32 = 7;
const RUNTIME_PLAYING: u32 = 2;
const RUNTIME_RESUMING: u32 = 5;

/// A client of RTDE.
#[derive(Debug)]
pub struct Rtde {
    rate_hz: f64,
    waiting: Vec<u8>,
    /// Numbers of the recipes, once they are accepted.
    outputs: Option<u8>,
    inputs: Option<u8>,
}

impl Rtde {
    /// Creates a client that asks for `rate_hz` reports in a second.
    #[must_use]
    pub fn new(rate_hz: f64) -> Self {
        Self { rate_hz, waiting: Vec::new(), outputs: None, inputs: None }
    }

    /// Answers a message of the control.
    fn answer(&mut self, kind: u8, body: &[u8], out: &mut Vec<u8>) -> Result<Option<RobotReport>, ProtocolError> {
        match kind {
            REQUEST_VERSION => {
                if body != [1] {
                    return Err(ProtocolError::Version);
                }
                let mut request = self.rate_hz.to_be_bytes().to_vec();
                request.extend_from_slice(names(&OUTPUTS).as_bytes());
                message(SETUP_OUTPUTS, &request, out);
                message(SETUP_INPUTS, names(&INPUTS).as_bytes(), out);
            }
            SETUP_OUTPUTS => {
                self.outputs = Some(recipe(body, &OUTPUTS)?);
                self.start(out);
            }
            SETUP_INPUTS => {
                self.inputs = Some(recipe(body, &INPUTS)?);
                self.start(out);
            }
            START if body != [1] => return Err(ProtocolError::NotStarted),
            DATA if body.first().copied() == self.outputs => return report(body).map(Some),
            // Texts are for the control's own log; other messages are not asked for.
            _ => {}
        }
        Ok(None)
    }

    /// Asks for reports once both recipes are accepted.
    fn start(&self, out: &mut Vec<u8>) {
        if self.outputs.is_some() && self.inputs.is_some() {
            message(START, &[], out);
        }
    }
}

impl RobotProtocol for Rtde {
    fn begin(&mut self, out: &mut Vec<u8>) {
        self.waiting.clear();
        (self.outputs, self.inputs) = (None, None);
        message(REQUEST_VERSION, &VERSION.to_be_bytes(), out);
    }

    fn feed(&mut self, bytes: &[u8]) -> Result<(), ProtocolError> {
        if self.waiting.len() + bytes.len() > MAX_WAITING {
            return Err(ProtocolError::Malformed);
        }
        self.waiting.extend_from_slice(bytes);
        Ok(())
    }

    fn next(&mut self, out: &mut Vec<u8>) -> Result<Option<RobotReport>, ProtocolError> {
        while let Some(head) = self.waiting.get(..HEAD) {
            let (length, kind) = (usize::from(u16::from_be_bytes([head[0], head[1]])), head[2]);
            if length < HEAD {
                return Err(ProtocolError::Malformed);
            }
            if self.waiting.len() < length {
                break;
            }
            let whole: Vec<u8> = self.waiting.drain(..length).collect();
            if let Some(report) = self.answer(kind, &whole[HEAD..], out)? {
                return Ok(Some(report));
            }
        }
        Ok(None)
    }

    fn order(&mut self, order: &RobotOrder, out: &mut Vec<u8>) {
        let Some(recipe) = self.inputs else { return };
        let mut body = vec![recipe];
        body.extend_from_slice(&(order.number as i32).to_be_bytes());
        body.extend_from_slice(&i32::from(order.follows).to_be_bytes());
        for joint in &order.joints[..JOINTS] {
            body.extend_from_slice(&joint.to_be_bytes());
        }
        message(DATA, &body, out);
    }

    fn holds_last(&self) -> bool {
        false
    }
}

/// Returns the names of fields, separated by commas.
fn names(fields: &[Field]) -> String {
    fields.iter().map(|field| field.0).collect::<Vec<_>>().join(",")
}

fn message(kind: u8, body: &[u8], out: &mut Vec<u8>) {
    // Requests are far shorter than the maximum.
    out.extend_from_slice(&((HEAD + body.len()) as u16).to_be_bytes());
    out.push(kind);
    out.extend_from_slice(body);
}

/// Returns the number of an accepted recipe.
fn recipe(body: &[u8], fields: &[Field]) -> Result<u8, ProtocolError> {
    let (id, types) = body.split_first().ok_or(ProtocolError::Malformed)?;
    let types = std::str::from_utf8(types).map_err(|_| ProtocolError::Malformed)?;
    let types: Vec<&str> = types.split(',').collect();
    let with = |answer: &str| {
        let found = fields.iter().zip(&types).filter(|(_, kind)| **kind == answer).map(|(field, _)| field.0);
        Some(found.collect::<Vec<_>>().join(", ")).filter(|names| !names.is_empty())
    };
    if let Some(unknown) = with("NOT_FOUND") {
        return Err(ProtocolError::UnknownFields(unknown));
    }
    if let Some(used) = with("IN_USE") {
        return Err(ProtocolError::FieldsInUse(used));
    }
    if types.len() != fields.len() || types.iter().zip(fields).any(|(kind, field)| *kind != field.1) {
        return Err(ProtocolError::Malformed);
    }
    Ok(*id)
}

/// Reads numbers of a message, big end first.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ProtocolError> {
        let (bytes, rest) = self.0.split_first_chunk::<N>().ok_or(ProtocolError::Malformed)?;
        self.0 = rest;
        Ok(*bytes)
    }

    fn double(&mut self) -> Result<f64, ProtocolError> {
        self.bytes().map(f64::from_be_bytes)
    }

    fn int(&mut self) -> Result<i32, ProtocolError> {
        self.bytes().map(i32::from_be_bytes)
    }
}

fn report(body: &[u8]) -> Result<RobotReport, ProtocolError> {
    if body.len() != REPORT {
        return Err(ProtocolError::Malformed);
    }
    let mut from = Reader(&body[1..]);
    let clock_s = from.double()?;
    let mut joints = [0.0; MAX_AXES];
    for joint in &mut joints[..JOINTS] {
        *joint = from.double()?;
    }
    let mut fault = 0;
    for joint in 0..JOINTS {
        fault |= u16::from(from.int()? == JOINT_MODE_FAULT) << joint;
    }
    let (robot_mode, safety_mode, runtime) = (from.int()?, from.int()?, from.int()? as u32);
    // The program's copy of the order's number is for people: it shows in the control's log.
    let (_taken, follows, version) = (from.int()?, from.int()?, from.int()?);
    if !clock_s.is_finite() {
        return Err(ProtocolError::Malformed);
    }
    let state = state(robot_mode, safety_mode, runtime, follows == 1, version);
    Ok(RobotReport { clock_s, joints, state, fault, begins: false })
}

fn state(robot_mode: i32, safety_mode: i32, runtime: u32, follows: bool, version: i32) -> RobotState {
    let hindrance = match safety_mode {
        // Normal and reduced.
        1 | 2 => None,
        3 => Some(Hindrance::ProtectiveStop),
        5 => Some(Hindrance::SafeguardStop),
        6 | 7 => Some(Hindrance::EmergencyStop),
        // Recovery, violation, fault, and those of later versions.
        _ => Some(Hindrance::SafetyFault),
    };
    let runs = [RUNTIME_PLAYING, RUNTIME_RESUMING].contains(&runtime);
    match hindrance {
        Some(why) => RobotState::Hindered(why),
        None if robot_mode != ROBOT_MODE_RUNNING => RobotState::Hindered(Hindrance::MotorsOff),
        None if !runs => RobotState::Hindered(Hindrance::ProgramStopped),
        None if version != PROGRAM_VERSION => RobotState::Hindered(Hindrance::OtherProgram),
        None if follows => RobotState::Follows,
        None => RobotState::Ready,
    }
}
