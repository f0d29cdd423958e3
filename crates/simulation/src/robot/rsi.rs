use super::arm::{Arm, JointPositions, MAX_JOINTS, Servo};
use super::{Disturbances, SimulatedControl};

/// Missing or late answers in a row after which RSI ends.
const MAX_LATE: u32 = 100;
/// Joints of the arm.
const ARM: usize = 6;

/// A simulated KUKA control that corrects its axes by RSI.
#[derive(Debug)]
pub struct RsiControl {
    arm: Arm,
    external: usize,
    period_s: f64,
    start: JointPositions,
    disturbances: Disturbances,
    ipoc: u64,
    answered: bool,
    late: u32,
    runs: bool,
}

impl RsiControl {
    /// Creates a control with `external` external joints, at `positions` (degrees, mm).
    #[must_use]
    pub fn new(external: usize, period_s: f64, servo: Servo, positions: JointPositions) -> Self {
        Self {
            arm: Arm::new(servo, positions),
            external,
            period_s,
            start: positions,
            disturbances: Disturbances::default(),
            ipoc: 4_208_163,
            answered: true,
            late: 0,
            runs: true,
        }
    }

    /// Returns the corrections of an answer to the last message.
    fn corrections(&self, text: &str) -> Option<JointPositions> {
        let ipoc = text.split("<IPOC>").nth(1)?.split("</IPOC>").next()?;
        if ipoc.parse() != Ok(self.ipoc) || !text.starts_with("<Sen Type=\"ImFree\">") {
            return None;
        }
        let mut corrections = [0.0; MAX_JOINTS];
        for (joint, correction) in corrections.iter_mut().enumerate().take(ARM + self.external) {
            let (element, name) = if joint < ARM { ("<AK ", 'A') } else { ("<EK ", 'E') };
            let tag = text.split(element).nth(1)?.split("/>").next()?;
            let value = tag.split(&format!("{name}{}=\"", joint % ARM + 1)).nth(1)?.split('"').next()?;
            *correction = value.parse().ok()?;
        }
        Some(corrections)
    }
}

impl SimulatedControl for RsiControl {
    fn period_s(&self) -> f64 {
        self.period_s
    }

    fn connect(&mut self) {
        // The program starts RSI again, where the arm stands.
        (self.start, self.late, self.runs, self.answered) = (*self.arm.positions(), 0, true, true);
        self.ipoc += 60_000;
    }

    fn take(&mut self, bytes: &[u8], t_s: f64, _out: &mut Vec<Vec<u8>>) {
        let text = String::from_utf8_lossy(bytes);
        let Some(corrections) = self.corrections(&text).filter(|_| !self.disturbances.mute) else { return };
        self.answered = true;
        if self.runs && self.disturbances == Disturbances::default() {
            let goal = std::array::from_fn(|joint| self.start[joint] + corrections[joint]);
            self.arm.follow(&goal, t_s);
        }
    }

    fn tick(&mut self, t_s: f64, out: &mut Vec<Vec<u8>>) {
        self.arm.advance(t_s);
        self.late = if self.answered { 0 } else { self.late + 1 };
        self.runs &= self.late <= MAX_LATE && !self.disturbances.program_stopped;
        if !self.runs || self.disturbances != Disturbances::default() {
            self.arm.hold();
        }
        self.ipoc += (1e3 * self.period_s).round() as u64;
        self.answered = false;
        // The drives stop beneath RSI: it goes on sending.
        if !self.runs || self.disturbances.mute {
            return;
        }
        let list = |name: char, positions: &[f64]| {
            let list = positions.iter().enumerate().map(|(i, position)| format!(" {name}{}=\"{position:.4}\"", i + 1));
            list.collect::<String>()
        };
        let (arm, late, ipoc) = (&self.arm.positions(), self.late, self.ipoc);
        let mut external = [0.0; 6];
        external[..self.external].copy_from_slice(&arm[ARM..ARM + self.external]);
        out.push(
            format!(
                "<Rob Type=\"KUKA\"><RIst X=\"1.0\" Y=\"0.0\" Z=\"0.0\" A=\"0.0\" B=\"0.0\" C=\"0.0\"/>\
                 <AIPos{}/><EIPos{}/><Delay D=\"{late}\"/><IPOC>{ipoc}</IPOC></Rob>",
                list('A', &arm[..ARM]),
                list('E', &external)
            )
            .into_bytes(),
        );
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
