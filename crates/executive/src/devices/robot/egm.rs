//! ABB's Externally Guided Motion (EGM), position guidance of joints.
//!
//! Source: ABB, "Application manual – Externally Guided Motion" (3HAC073318), with the messages `EgmRobot` and
//! `EgmSensor` of its `egm.proto`. The control sends a datagram every 4 ms, and takes our answer to it. Positions are
//! degrees, of linear external joints mm. When answers cease, EGM ends after `CommTimeout`, and the arm stops.

use super::protobuf::{Field, Fields, Value, put_bytes, put_double, put_varint};
use super::protocol::{Datagram, Hindrance, ProtocolError, RobotOrder, RobotProtocol, RobotReport, RobotState};
use seamwright_machine::MAX_AXES;

/// The program for the control, in RAPID.
pub const RAPID: &str = include_str!("programs/abb.mod");

/// Joints of a message: a control sends and takes six external ones, used or not.
const MAX_JOINTS: usize = 16;
/// Maximum number of datagrams by which one is overtaken: a second.
const MAX_OVERTAKEN: u64 = 250;
/// Type of a message with set-points.
const CORRECTION: u64 = 3;
/// States.
const MOTORS_ON: u64 = 1;
const MCI_ERROR: u64 = 1;
const MCI_RUNNING: u64 = 3;
const RAPID_RUNNING: u64 = 2;

/// EGM as the sensor of a control.
#[derive(Debug)]
pub struct Egm {
    /// Number of the arm's joints, and of all.
    arm: usize,
    joints: usize,
    /// Linear joints, by joint.
    linear: [bool; MAX_AXES],
    datagram: Datagram,
    /// Number and time of the last report, s.
    last: Option<(u64, f64)>,
}

impl Egm {
    /// Creates it for `joints` joints, of which the first `arm` are the arm's; `linear` marks those in mm.
    #[must_use]
    pub fn new(arm: usize, joints: usize, linear: [bool; MAX_AXES]) -> Self {
        Self { arm, joints, linear, datagram: Datagram::default(), last: None }
    }

    fn report(&mut self, bytes: &[u8]) -> Result<Option<RobotReport>, ProtocolError> {
        let robot = Robot::read(bytes)?;
        // A datagram that was overtaken or doubled is older by the control's clock. A new session counts from the start.
        if let Some((number, clock_s)) = self.last {
            let is_old = robot.number <= number && robot.clock_s <= clock_s;
            if is_old && number - robot.number < MAX_OVERTAKEN {
                return Ok(None);
            }
        }
        let begins = self.last.is_some_and(|(number, _)| robot.number <= number);
        self.last = Some((robot.number, robot.clock_s));
        let external = self.joints - self.arm;
        let reported = (robot.arm.1, robot.external.1);
        if reported.0 != self.arm || reported.1 < external {
            let reported = reported.0 + reported.1.min(external);
            return Err(ProtocolError::Joints { reported, needed: self.joints });
        }
        let mut joints = [0.0; MAX_AXES];
        joints[..self.arm].copy_from_slice(&robot.arm.0[..self.arm]);
        joints[self.arm..self.joints].copy_from_slice(&robot.external.0[..external]);
        for (joint, linear) in joints.iter_mut().zip(self.linear) {
            *joint = if linear { *joint } else { joint.to_radians() };
        }
        Ok(Some(RobotReport { clock_s: robot.clock_s, joints, state: robot.state(), fault: 0, begins }))
    }
}

/// The fields of `EgmRobot` that are used.
#[derive(Debug, Default)]
struct Robot {
    number: u64,
    clock_s: f64,
    /// Positions and their number.
    arm: ([f64; MAX_JOINTS], usize),
    external: ([f64; MAX_JOINTS], usize),
    motors: u64,
    mci: u64,
    rapid: u64,
}

impl Robot {
    fn read(bytes: &[u8]) -> Result<Self, ProtocolError> {
        let mut robot = Self::default();
        for field in Fields(bytes) {
            let Field { number, value } = field?;
            let Value::Bytes(inner) = value else { continue };
            match number {
                1 => {
                    for field in Fields(inner) {
                        match field? {
                            Field { number: 1, value: Value::Varint(number) } => robot.number = number,
                            Field { number: 2, value: Value::Varint(ms) } => robot.clock_s = 1e-3 * ms as f64,
                            _ => {}
                        }
                    }
                }
                2 => {
                    for field in Fields(inner) {
                        match field? {
                            Field { number: 1, value: Value::Bytes(joints) } => robot.arm = positions(joints)?,
                            Field { number: 3, value: Value::Bytes(joints) } => robot.external = positions(joints)?,
                            _ => {}
                        }
                    }
                }
                4 => robot.motors = state(inner)?,
                5 => robot.mci = state(inner)?,
                8 => robot.rapid = state(inner)?,
                _ => {}
            }
        }
        Ok(robot)
    }

    fn state(&self) -> RobotState {
        let hindrance = if self.motors != MOTORS_ON {
            Hindrance::MotorsOff
        } else if self.mci == MCI_ERROR {
            Hindrance::ControlError
        } else if self.mci != MCI_RUNNING || self.rapid != RAPID_RUNNING {
            Hindrance::ProgramStopped
        } else {
            return RobotState::Follows;
        };
        RobotState::Hindered(hindrance)
    }
}

/// Reads the state of a message whose only field is one.
fn state(bytes: &[u8]) -> Result<u64, ProtocolError> {
    let mut state = 0;
    for field in Fields(bytes) {
        if let Field { number: 1, value: Value::Varint(value) } = field? {
            state = value;
        }
    }
    Ok(state)
}

/// Reads repeated numbers, packed or not, and returns how many there are.
fn positions(bytes: &[u8]) -> Result<([f64; MAX_JOINTS], usize), ProtocolError> {
    let (mut positions, mut count) = ([0.0; MAX_JOINTS], 0);
    let mut add = |position: f64| {
        *positions.get_mut(count).ok_or(ProtocolError::Malformed)? = position;
        count += 1;
        if position.is_finite() { Ok(()) } else { Err(ProtocolError::Malformed) }
    };
    for field in Fields(bytes) {
        match field? {
            Field { number: 1, value: Value::Double(position) } => add(position)?,
            Field { number: 1, value: Value::Bytes(packed) } => {
                let (chunks, rest) = packed.as_chunks::<8>();
                if !rest.is_empty() {
                    return Err(ProtocolError::Malformed);
                }
                for chunk in chunks {
                    add(f64::from_le_bytes(*chunk))?;
                }
            }
            _ => {}
        }
    }
    Ok((positions, count))
}

impl RobotProtocol for Egm {
    fn begin(&mut self, _out: &mut Vec<u8>) {
        self.datagram.clear();
        self.last = None;
    }

    fn feed(&mut self, bytes: &[u8]) -> Result<(), ProtocolError> {
        self.datagram.put(bytes);
        Ok(())
    }

    fn next(&mut self, _out: &mut Vec<u8>) -> Result<Option<RobotReport>, ProtocolError> {
        self.datagram.take().map_or(Ok(None), |datagram| self.report(&datagram))
    }

    fn order(&mut self, order: &RobotOrder, out: &mut Vec<u8>) {
        let joints = |range: std::ops::Range<usize>| {
            let mut message = Vec::new();
            for joint in range {
                let position = order.joints[joint];
                put_double(1, if self.linear[joint] { position } else { position.to_degrees() }, &mut message);
            }
            message
        };
        let mut header = Vec::new();
        put_varint(1, u64::from(order.number), &mut header);
        put_varint(3, CORRECTION, &mut header);
        let mut planned = Vec::new();
        put_bytes(1, &joints(0..self.arm), &mut planned);
        if self.joints > self.arm {
            put_bytes(3, &joints(self.arm..self.joints), &mut planned);
        }
        put_bytes(1, &header, out);
        put_bytes(2, &planned, out);
    }

    fn holds_last(&self) -> bool {
        true
    }
}
