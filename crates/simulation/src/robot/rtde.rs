use super::arm::{Arm, JointPositions, MAX_JOINTS, Servo};
use super::{Disturbances, SimulatedControl};

/// Time without a new order after which the program's watchdog ends it, s.
const WATCHDOG_S: f64 = 0.1;
/// Number of joints.
const JOINTS: usize = 6;

/// A simulated Universal Robots control with the program for Seamwright.
#[derive(Debug)]
pub struct RtdeControl {
    arm: Arm,
    period_s: f64,
    disturbances: Disturbances,
    waiting: Vec<u8>,
    outputs: Vec<String>,
    inputs: Vec<String>,
    sends: bool,
    now_s: f64,
    /// Registers from 24 on.
    ints: [i32; 2],
    doubles: [f64; JOINTS],
    changed_s: f64,
    watchdog_s: f64,
    program_runs: bool,
    follows: bool,
}

impl RtdeControl {
    /// Creates a control with an arm at `positions`, rad, that runs the program.
    #[must_use]
    pub fn new(rate_hz: f64, servo: Servo, positions: JointPositions) -> Self {
        Self {
            arm: Arm::new(servo, positions),
            period_s: 1.0 / rate_hz,
            disturbances: Disturbances::default(),
            waiting: Vec::new(),
            outputs: Vec::new(),
            inputs: Vec::new(),
            sends: false,
            now_s: 0.0,
            ints: [0; 2],
            doubles: [0.0; JOINTS],
            changed_s: 0.0,
            watchdog_s: WATCHDOG_S,
            program_runs: true,
            follows: false,
        }
    }

    /// Lengthens the watchdog of the program to `watchdog_s`, for a computer without real-time rights.
    #[must_use]
    pub fn patient(mut self, watchdog_s: f64) -> Self {
        self.watchdog_s = watchdog_s;
        self
    }

    /// Starts the program again, as at the pendant.
    pub fn start_program(&mut self) {
        (self.program_runs, self.changed_s) = (true, self.now_s);
    }

    fn safety_mode(&self) -> i32 {
        match &self.disturbances {
            Disturbances { emergency_stop: true, .. } => 7,
            Disturbances { protective_stop: true, .. } => 3,
            _ => 1,
        }
    }

    fn type_of(&self, name: &str) -> &'static str {
        if self.disturbances.unknown_field.as_deref() == Some(name) {
            return "NOT_FOUND";
        }
        if self.disturbances.field_in_use.as_deref() == Some(name) {
            return "IN_USE";
        }
        match name {
            "timestamp" => "DOUBLE",
            "actual_q" | "target_q" | "actual_qd" | "target_qd" | "actual_current" | "actual_TCP_pose" => "VECTOR6D",
            "joint_mode" => "VECTOR6INT32",
            "robot_mode" | "safety_mode" => "INT32",
            "runtime_state" | "robot_status_bits" | "safety_status_bits" => "UINT32",
            _ if name.starts_with("output_int_register_") || name.starts_with("input_int_register_") => "INT32",
            _ if name.starts_with("output_double_register_") || name.starts_with("input_double_register_") => "DOUBLE",
            _ => "NOT_FOUND",
        }
    }

    /// Returns the value of an output as bytes.
    fn output(&self, name: &str) -> Vec<u8> {
        let int = |value: i32| value.to_be_bytes().to_vec();
        let doubles = |values: &[f64]| values.iter().flat_map(|value| value.to_be_bytes()).collect();
        match name {
            "timestamp" => self.now_s.to_be_bytes().to_vec(),
            "actual_q" | "target_q" => doubles(&self.arm.positions()[..JOINTS]),
            "actual_qd" | "target_qd" | "actual_current" | "actual_TCP_pose" => doubles(&[0.0; JOINTS]),
            "joint_mode" => {
                let mode = |joint| if self.disturbances.joint_fault == Some(joint) { 252i32 } else { 253 };
                (0..JOINTS).flat_map(|joint| mode(joint).to_be_bytes()).collect()
            }
            "robot_mode" => int(if self.disturbances.motors_off { 3 } else { 7 }),
            "safety_mode" => int(self.safety_mode()),
            "runtime_state" => int(if self.program_runs { 2 } else { 1 }),
            "robot_status_bits" => int(3),
            "safety_status_bits" => int(1),
            "output_int_register_24" => int(self.ints[0]),
            "output_int_register_25" => int(i32::from(self.follows)),
            "output_int_register_26" => int(1),
            _ if self.type_of(name) == "DOUBLE" => doubles(&[0.0]),
            _ => int(0),
        }
    }

    fn answer(&mut self, kind: u8, body: &[u8], t_s: f64, out: &mut Vec<Vec<u8>>) {
        let text = |from: usize| String::from_utf8_lossy(body.get(from..).unwrap_or_default()).into_owned();
        // A comma may follow the last name.
        let split =
            |names: &str| names.split(',').filter(|name| !name.is_empty()).map(str::to_owned).collect::<Vec<_>>();
        match kind {
            b'V' => out.push(message(b'V', &[u8::from(body == [0, 2] && !self.disturbances.old_version)])),
            b'v' => out.push(message(b'v', &[0, 0, 0, 5, 0, 0, 0, 12, 0, 0, 0, 0, 0, 0, 0, 0])),
            b'O' | b'I' => {
                let names = split(&text(if kind == b'O' { 8 } else { 0 }));
                let types: Vec<&str> = names.iter().map(|name| self.type_of(name)).collect();
                let is_known = types.iter().all(|kind| !["NOT_FOUND", "IN_USE"].contains(kind));
                let recipe = if !is_known {
                    0
                } else if kind == b'O' {
                    1
                } else {
                    2
                };
                let mut answer = vec![recipe];
                answer.extend_from_slice(types.join(",").as_bytes());
                out.push(message(kind, &answer));
                if kind == b'O' {
                    self.outputs = names;
                } else {
                    self.inputs = names;
                }
            }
            b'S' => {
                self.sends = !self.outputs.is_empty();
                out.push(message(b'S', &[u8::from(self.sends)]));
                // Texts come at any time.
                out.push(message(b'M', b"\x07started\x04RTDE\x03"));
            }
            b'P' => {
                self.sends = false;
                out.push(message(b'P', &[1]));
            }
            b'U' if body.first() == Some(&2) => self.write(&body[1..], t_s),
            _ => {}
        }
    }

    /// Takes the values of the inputs.
    fn write(&mut self, mut body: &[u8], t_s: f64) {
        for name in self.inputs.clone() {
            let number = name.rsplit('_').next().and_then(|number| number.parse::<usize>().ok()).unwrap_or(0);
            if name.contains("int") {
                let Some((bytes, rest)) = body.split_first_chunk::<4>() else { return };
                let value = i32::from_be_bytes(*bytes);
                if let Some(register) = number.checked_sub(24).and_then(|i| self.ints.get_mut(i)) {
                    if number == 24 && *register != value {
                        self.changed_s = t_s;
                    }
                    *register = value;
                }
                body = rest;
            } else {
                let Some((bytes, rest)) = body.split_first_chunk::<8>() else { return };
                if let Some(register) = number.checked_sub(24).and_then(|i| self.doubles.get_mut(i)) {
                    *register = f64::from_be_bytes(*bytes);
                }
                body = rest;
            }
        }
    }

    /// Runs a period of the program.
    fn run_program(&mut self, t_s: f64) {
        let hindered = self.safety_mode() != 1 || self.disturbances.motors_off || self.disturbances.program_stopped;
        if hindered || t_s - self.changed_s > self.watchdog_s {
            self.program_runs &= !hindered && !self.follows;
        }
        if !self.program_runs {
            self.arm.hold();
            self.follows = false;
            return;
        }
        if self.ints[1] == 1 {
            let mut goal = [0.0; MAX_JOINTS];
            goal[..JOINTS].copy_from_slice(&self.doubles);
            self.arm.follow(&goal, t_s);
            self.follows = true;
        } else if self.follows {
            self.arm.hold();
            self.follows = false;
        }
    }
}

fn message(kind: u8, body: &[u8]) -> Vec<u8> {
    let mut message = ((body.len() + 3) as u16).to_be_bytes().to_vec();
    message.push(kind);
    message.extend_from_slice(body);
    message
}

impl SimulatedControl for RtdeControl {
    fn period_s(&self) -> f64 {
        self.period_s
    }

    fn connect(&mut self) {
        self.waiting.clear();
        self.outputs.clear();
        self.inputs.clear();
        self.sends = false;
    }

    fn take(&mut self, bytes: &[u8], t_s: f64, out: &mut Vec<Vec<u8>>) {
        if self.disturbances.mute {
            return;
        }
        self.waiting.extend_from_slice(bytes);
        while let Some(&[high, low, kind]) = self.waiting.first_chunk::<3>() {
            let length = usize::from(u16::from_be_bytes([high, low])).max(3);
            if self.waiting.len() < length {
                break;
            }
            let whole: Vec<u8> = self.waiting.drain(..length).collect();
            self.answer(kind, &whole[3..], t_s, out);
        }
    }

    fn tick(&mut self, t_s: f64, out: &mut Vec<Vec<u8>>) {
        self.now_s = t_s;
        self.run_program(t_s);
        self.arm.advance(t_s);
        if self.sends && !self.disturbances.mute {
            let mut body = vec![1];
            self.outputs.iter().for_each(|name| body.extend_from_slice(&self.output(name)));
            out.push(message(b'U', &body));
        }
    }

    fn arm(&self) -> &Arm {
        &self.arm
    }

    fn disturb(&mut self, disturbances: Disturbances) {
        // After a stop the program is started again at the pendant.
        if disturbances == Disturbances::default() {
            self.start_program();
        }
        self.disturbances = disturbances;
    }

    fn follows(&self) -> bool {
        self.follows
    }
}
