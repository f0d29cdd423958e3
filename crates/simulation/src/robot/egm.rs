use super::arm::{Arm, JointPositions, MAX_JOINTS, Servo};
use super::{Disturbances, SimulatedControl};

/// Time without a message after which EGM ends, s: the default of `CommTimeout`.
const COMM_TIMEOUT_S: f64 = 1.0;
/// External joints of a message.
const EXTERNAL: usize = 6;

/// A simulated ABB control in position guidance of joints.
#[derive(Debug)]
pub struct EgmControl {
    arm: Arm,
    joints: usize,
    external: usize,
    disturbances: Disturbances,
    number: u64,
    heard_s: Option<f64>,
    runs: bool,
}

impl EgmControl {
    /// Creates a control with `joints` joints of the arm and `external` ones, at `positions` (degrees, mm).
    #[must_use]
    pub fn new(joints: usize, external: usize, servo: Servo, positions: JointPositions) -> Self {
        let arm = Arm::new(servo, positions);
        Self { arm, joints, external, disturbances: Disturbances::default(), number: 0, heard_s: None, runs: true }
    }

    /// Returns positions of `EgmPlanned`: those of the arm and the external ones.
    fn planned(bytes: &[u8]) -> Option<(Vec<f64>, Vec<f64>)> {
        let planned = fields(bytes)?.into_iter().find(|(number, _)| *number == 2)?.1;
        let parts = fields(planned)?;
        let joints = |wanted: u64| {
            let part = parts.iter().find(|(number, _)| *number == wanted).map(|(_, bytes)| *bytes).unwrap_or_default();
            // Each position is a key and eight bytes.
            part.chunks_exact(9).map(|chunk| f64::from_le_bytes(chunk[1..].try_into().unwrap_or_default())).collect()
        };
        Some((joints(1), joints(3)))
    }
}

/// Returns the nested messages of `bytes` with their numbers; `None` if they are no message.
fn fields(mut bytes: &[u8]) -> Option<Vec<(u64, &[u8])>> {
    let mut found = Vec::new();
    while let Some((key, rest)) = bytes.split_first() {
        bytes = rest;
        match key & 7 {
            0 => {
                let end = bytes.iter().position(|byte| byte & 0x80 == 0)?;
                bytes = &bytes[end + 1..];
            }
            2 => {
                let (length, rest) = bytes.split_first()?;
                let (inner, rest) = rest.split_at_checked(usize::from(*length))?;
                found.push((u64::from(key >> 3), inner));
                bytes = rest;
            }
            _ => return None,
        }
    }
    Some(found)
}

/// Returns a nested message; its length is below 128.
fn nested(number: u8, inner: &[u8]) -> Vec<u8> {
    [&[number << 3 | 2, inner.len() as u8][..], inner].concat()
}

fn varint(number: u8, mut value: u64) -> Vec<u8> {
    let mut bytes = vec![number << 3];
    while value > 127 {
        bytes.push((value & 127) as u8 | 128);
        value >>= 7;
    }
    bytes.push(value as u8);
    bytes
}

fn joints(positions: &[f64]) -> Vec<u8> {
    positions.iter().flat_map(|position| [&[9][..], &position.to_le_bytes()].concat()).collect()
}

impl SimulatedControl for EgmControl {
    fn period_s(&self) -> f64 {
        0.004
    }

    fn connect(&mut self) {
        // The instruction EGMRunJoint starts again.
        (self.number, self.heard_s, self.runs) = (0, None, true);
    }

    fn take(&mut self, bytes: &[u8], t_s: f64, _out: &mut Vec<Vec<u8>>) {
        let Some((arm, external)) = Self::planned(bytes).filter(|_| !self.disturbances.mute) else { return };
        self.heard_s = Some(t_s);
        let stands = self.disturbances != Disturbances::default();
        if !self.runs || stands || arm.len() != self.joints || external.len() < self.external {
            return;
        }
        let mut goal = [0.0; MAX_JOINTS];
        goal[..self.joints].copy_from_slice(&arm);
        goal[self.joints..self.joints + self.external].copy_from_slice(&external[..self.external]);
        self.arm.follow(&goal, t_s);
    }

    fn tick(&mut self, t_s: f64, out: &mut Vec<Vec<u8>>) {
        self.arm.advance(t_s);
        self.runs &= self.heard_s.is_none_or(|heard_s| t_s - heard_s < COMM_TIMEOUT_S);
        let stops = self.disturbances.emergency_stop || self.disturbances.motors_off;
        if !self.runs || stops || self.disturbances.program_stopped || self.disturbances.protective_stop {
            self.arm.hold();
        }
        self.number += 1;
        if self.disturbances.mute {
            return;
        }
        let header = [varint(1, self.number), varint(2, (1e3 * t_s).round() as u64), varint(3, 2)].concat();
        let reported = self.disturbances.joints_reported.unwrap_or(self.joints);
        let mut others = [0.0; EXTERNAL];
        others[..self.external].copy_from_slice(&self.arm.positions()[self.joints..self.joints + self.external]);
        let arm = joints(&self.arm.positions()[..reported]);
        let feedback = [nested(1, &arm), nested(3, &joints(&others))].concat();
        let mci = match () {
            () if self.disturbances.protective_stop => 1,
            () if self.runs => 3,
            () => 2,
        };
        let rapid = if self.disturbances.program_stopped { 1 } else { 2 };
        let message = [
            nested(1, &header),
            nested(2, &feedback),
            nested(4, &varint(1, if stops { 2 } else { 1 })),
            nested(5, &varint(1, mci)),
            varint(6, 1),
            nested(8, &varint(1, rapid)),
        ];
        out.push(message.concat());
    }

    fn arm(&self) -> &Arm {
        &self.arm
    }

    fn disturb(&mut self, disturbances: Disturbances) {
        self.disturbances = disturbances;
    }

    fn follows(&self) -> bool {
        self.runs && self.disturbances == Disturbances::default()
    }
}
