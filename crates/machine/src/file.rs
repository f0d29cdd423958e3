//! The machine file as written, before its steps are assembled.

use crate::AxisLimits;
use crate::axis::EncoderSide;
use crate::beam_deflection::BeamDeflection;
use crate::cell::{InterlockFile, PanelLost, SourceFile};
use crate::devices::DeviceFile;
use crate::sensor::SensorFile;
use glam::DVec3;
use schemars::JsonSchema;
use seamwright_clearance::SolidFile;
use seamwright_document::{
    Direction, Document, DocumentError, Finite, NonNegative, Point, Positive, SchemaVersion, Transform,
};
use serde::Deserialize;
use std::collections::BTreeMap;

pub(crate) type File = Document<MachineFile>;

/// Reads the bytes of a file named in the machine file.
pub(crate) type Load<'a> = &'a dyn Fn(&str) -> std::io::Result<Vec<u8>>;

/// A machine file.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MachineFile {
    /// Version of the file format.
    pub schema: SchemaVersion,
    /// Short name, as used in job files.
    pub name: String,
    /// Title, for people.
    pub title: String,
    /// Period of the position loops and of the set-points, ms; 1 if missing.
    pub servo_period_ms: Option<Positive>,
    /// Longest time without a cycle while the cell runs, ms, 1 to 1000, but not longer than the drives tolerate; as long as these
    /// if missing. A longer gap stops the cell.
    pub longest_gap_ms: Option<Positive>,
    /// Axes that go to their home positions, one after another, once all references are found; none if missing.
    #[serde(default)]
    pub home_order: Vec<String>,
    /// Reaction of a running program to the loss of its panel (the process has died, or is silent for a second); `hold` if
    /// missing. Jogging stops in any case.
    #[serde(default)]
    pub on_panel_lost: PanelLost,
    /// Steps from the machine's base to the torch tip, in order.
    #[serde(default)]
    pub tool: Vec<StepFile>,
    /// Steps from the machine's base to the clamped work, in order.
    #[serde(default)]
    pub work: Vec<StepFile>,
    /// The torch at the end of the tool steps, on a machine with one head.
    pub torch: Option<TorchFile>,
    /// Two heads, each at the end of steps of its own after the tool steps, instead of `torch`.
    #[serde(default)]
    pub heads: Vec<HeadFile>,
    /// Limits of the torch tip's motion against the work, beside those of the axes.
    #[serde(default)]
    pub tip: TipFile,
    /// Direction against gravity in the base frame; z if missing.
    pub up: Option<Direction>,
    /// User frames by their names, in the base frame: directions for jogging and targets.
    #[serde(default)]
    pub frames: BTreeMap<String, Transform>,
    /// Drive of each axis, by the axis' name; used by the simulation.
    #[serde(default)]
    pub drives: BTreeMap<String, DriveFile>,
    /// Measured pitch error of axes, by the axis' name.
    #[serde(default)]
    pub pitch_error: BTreeMap<String, PitchErrorFile>,
    /// Solids of each link, by the link's name: an axis (what it moves), `base`, `work`, `torch` or a head. Given in
    /// the frame that the steps up to that axis lead to.
    #[serde(default)]
    pub shapes: BTreeMap<String, Vec<SolidFile>>,
    /// Minimum clearance between the machine's own links.
    #[serde(default)]
    pub clearance: LinkClearanceFile,
    /// Volumes that links, part and fixtures must stay in or keep out of.
    #[serde(default)]
    pub zones: Vec<ZoneFile>,
    /// Sensors that see the joint, by their names.
    #[serde(default)]
    pub sensors: BTreeMap<String, SensorFile>,
    /// Which outputs of the control switch and set the process.
    #[serde(default)]
    pub io: Io,
    /// Conditions that the running cell watches.
    #[serde(default)]
    pub interlocks: Vec<InterlockFile>,
    /// Start and supervision of the process source.
    #[serde(default)]
    pub source: SourceFile,
    /// Devices of process source, inputs and outputs, by names of your own. Everything without a device is simulated.
    #[serde(default)]
    pub devices: BTreeMap<String, DeviceFile>,
    /// Names of the axes and the process on controls, for part programs.
    #[serde(default)]
    pub controls: ControlsFile,
}

/// The torch.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorchFile {
    /// Direction of wire or beam, from the torch to the work, in the last frame of the tool steps.
    pub direction: Direction,
    /// Torch tip in the last frame of the tool steps, mm, as tool calibration finds it; the frame's origin if missing.
    pub tip_mm: Option<Point>,
    /// Wire between contact tip and torch tip, mm: the stick-out for which the tip's position holds. A job may weld with
    /// another one.
    pub stick_out_mm: Option<Positive>,
    /// Range and speed of a beam's deflection, if the torch is a beam.
    pub deflection: Option<DeflectionFile>,
}

/// A beam's deflection on the work, the same to all sides.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeflectionFile {
    /// Maximum deflection, mm.
    pub range_mm: Positive,
    /// Highest speed, mm/s.
    pub max_speed_mm_s: Positive,
    /// Time from the order until it acts, us; 75 if missing.
    pub latency_us: Option<NonNegative>,
    /// Distance of the point about which the beam is deflected from the work, mm.
    pub pivot_mm: Positive,
}

impl DeflectionFile {
    pub(crate) fn beam(self) -> BeamDeflection {
        BeamDeflection {
            range_mm: self.range_mm.get(),
            speed: self.max_speed_mm_s.get(),
            latency_s: 1e-6 * self.latency_us.map_or(USUAL_LATENCY_US, NonNegative::get),
            pivot_mm: self.pivot_mm.get(),
        }
    }
}

/// Of a beam's deflection (EBW-2004), us.
const USUAL_LATENCY_US: f64 = 75.0;

/// Limits of the torch tip's motion against the work, along seams and taught points.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TipFile {
    /// Highest speed, mm/s.
    pub max_speed_mm_s: Option<Positive>,
    /// Maximum acceleration in any direction, mm/s^2.
    pub max_acceleration_mm_s2: Option<Positive>,
    /// Maximum jerk in any direction, mm/s^3.
    pub max_jerk_mm_s3: Option<Positive>,
}

impl TipFile {
    pub(crate) fn limits(self) -> AxisLimits {
        let limit = |value: Option<Positive>| value.map_or(f64::INFINITY, Positive::get);
        AxisLimits {
            speed: limit(self.max_speed_mm_s),
            acceleration: limit(self.max_acceleration_mm_s2),
            jerk: limit(self.max_jerk_mm_s3),
        }
    }
}

/// One of two heads.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeadFile {
    /// Name, for people and for shapes.
    pub name: String,
    /// Direction of wire or beam, from the torch to the work, in the last frame of the head's steps.
    pub direction: Direction,
    /// Torch tip in the last frame of the head's steps, mm; the frame's origin if missing.
    pub tip_mm: Option<Point>,
    /// Steps from the end of the tool steps to the head's tip: correction slides and fixed displacements.
    #[serde(default)]
    pub steps: Vec<StepFile>,
}

impl MachineFile {
    /// Reads a machine file as it is written; [`Machine::read`](crate::Machine::read) builds the machine of it.
    ///
    /// # Errors
    /// The first error, with its address.
    pub fn read(file: &str, text: &str) -> Result<Document<Self>, DocumentError> {
        Document::read(file, text)
    }

    /// Name, own steps, direction and tip of each head.
    pub(crate) fn heads(&self) -> Vec<(&str, &[StepFile], Direction, DVec3)> {
        let tip = |tip: Option<Point>| tip.map_or(DVec3::ZERO, Point::get);
        match &self.torch {
            Some(torch) => vec![("torch", &[], torch.direction, tip(torch.tip_mm))],
            None => {
                self.heads.iter().map(|h| (h.name.as_str(), h.steps.as_slice(), h.direction, tip(h.tip_mm))).collect()
            }
        }
    }
}

/// Minimum clearance between the machine's own links. Adjacent links are not checked.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinkClearanceFile {
    /// Minimum distance of two links, mm; 5 if missing.
    pub least_mm: Option<Positive>,
    /// Pairs of links that may touch.
    #[serde(default)]
    pub ignore: Vec<[String; 2]>,
}

/// A volume for links to stay in or to keep out of (EBW-2004).
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZoneFile {
    /// Name, for people.
    pub name: String,
    /// Whether to stay in it or keep out of it. Permitted zones with the same `watch` and `on` count together:
    /// everything watched must be wholly inside one of their solids.
    pub kind: ZoneKind,
    /// The link that it is fixed to; `base` if missing.
    pub on: Option<String>,
    /// Links that it holds for, also `part` and `fixtures`; everything that moves against it if missing.
    pub watch: Option<Vec<String>>,
    /// Minimum distance outside a forbidden zone, or inside a permitted one, mm; 1 if missing.
    pub least_mm: Option<Positive>,
    /// Its volume; boxes, cylinders, spheres and half-spaces if it is permitted.
    pub solids: Vec<SolidFile>,
}

/// Kind of a zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ZoneKind {
    /// Stay inside.
    Permitted,
    /// Keep out.
    Forbidden,
}

/// A table of an axis' measured pitch error: the true position less the indicated one.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PitchErrorFile {
    /// Indicated positions of a linear axis, mm, increasing.
    pub at_mm: Option<Vec<Finite>>,
    /// Error at each of them, mm.
    pub error_mm: Option<Vec<Finite>>,
    /// Indicated positions of a rotary axis, degrees, increasing; within one turn if it is continuous.
    pub at_deg: Option<Vec<Finite>>,
    /// Error at each of them, degrees.
    pub error_deg: Option<Vec<Finite>>,
}

/// One step of a branch: an axis (`axis`, and `turn` or `move`) or a `fixed` displacement.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepFile {
    /// A displacement that does not move.
    pub fixed: Option<Transform>,
    /// Name of the axis: lower-case letters, digits and `_`.
    pub axis: Option<String>,
    /// Letter of the axis in part programs (A B C U V W X Y Z); the upper-case name if that is one of them.
    pub letter: Option<String>,
    /// Rotary axis: the direction it turns about by the right-hand rule.
    pub turn: Option<Direction>,
    /// Rotary axis: a point on it, mm; the origin if missing.
    pub at_mm: Option<Point>,
    /// Linear axis: the direction of its positive motion.
    #[serde(rename = "move")]
    pub direction: Option<Direction>,
    /// Rotary axis without end stops.
    #[serde(default)]
    pub continuous: bool,
    /// Lowest and highest position of a linear axis, mm.
    pub range_mm: Option<[Finite; 2]>,
    /// Lowest and highest position of a rotary axis, degrees.
    pub range_deg: Option<[Finite; 2]>,
    /// Position after homing, mm; 0 if missing.
    pub home_mm: Option<Finite>,
    /// Position after homing, degrees; 0 if missing.
    pub home_deg: Option<Finite>,
    /// Highest speed, mm/s.
    pub max_speed_mm_s: Option<Positive>,
    /// Highest speed, deg/s.
    pub max_speed_deg_s: Option<Positive>,
    /// Highest acceleration, mm/s^2.
    pub max_acceleration_mm_s2: Option<Positive>,
    /// Highest acceleration, deg/s^2.
    pub max_acceleration_deg_s2: Option<Positive>,
    /// Highest jerk, mm/s^3; read, but not used yet.
    pub max_jerk_mm_s3: Option<Positive>,
    /// Highest jerk, deg/s^3; read, but not used yet.
    pub max_jerk_deg_s3: Option<Positive>,
}

/// A drive for the simulation: load, motor and position loop.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveFile {
    /// Moved mass of a linear axis with motor, kg.
    pub mass_kg: Option<Positive>,
    /// Peak force of a linear axis' drive, N.
    pub peak_force_n: Option<Positive>,
    /// Force that a linear axis' drive is limited to, N; the peak if missing.
    pub force_limit_n: Option<Positive>,
    /// Coulomb friction of a linear axis, N.
    pub friction_n: Option<NonNegative>,
    /// Viscous friction of a linear axis, N s/m.
    pub viscous_n_s_m: Option<NonNegative>,
    /// Moved inertia of a rotary axis with motor, kg m^2.
    pub inertia_kg_m2: Option<Positive>,
    /// Peak torque of a rotary axis' drive, N m.
    pub peak_torque_n_m: Option<Positive>,
    /// Torque that a rotary axis' drive is limited to, N m; the peak if missing.
    pub torque_limit_n_m: Option<Positive>,
    /// Coulomb friction of a rotary axis, N m.
    pub friction_n_m: Option<NonNegative>,
    /// Viscous friction of a rotary axis, N m s/rad.
    pub viscous_n_m_s_rad: Option<NonNegative>,
    /// Encoder counts per mm.
    pub encoder_counts_per_mm: Option<Positive>,
    /// Encoder counts per degree.
    pub encoder_counts_per_deg: Option<Positive>,
    /// Frequency at which motor and load swing against each other, both free, Hz; one rigid mass if missing.
    pub resonance_hz: Option<Positive>,
    /// Damping of that swing as a part of the critical one; 0.02 if missing.
    pub resonance_damping: Option<NonNegative>,
    /// Inertia of the load over that of the motor; needed with `resonance_hz`.
    pub load_ratio: Option<Positive>,
    /// Gap between motor and load of a linear axis, mm.
    pub backlash_mm: Option<NonNegative>,
    /// Gap between motor and load of a rotary axis, degrees.
    pub backlash_deg: Option<NonNegative>,
    /// Part of the friction that is at the motor, 0 to 1; the rest is at the load. 0 if missing.
    pub motor_friction: Option<NonNegative>,
    /// Position of the encoder: at the motor or at the load; `motor` if missing.
    pub encoder_on: Option<EncoderSide>,
    /// Bandwidth of the velocity loop, Hz.
    pub velocity_bandwidth_hz: Positive,
    /// Time constant of the current loop, ms; 0.2 if missing.
    pub current_time_constant_ms: Option<Positive>,
    /// Dead time from the velocity loop's measurement to the current, ms; 0 if missing.
    pub current_delay_ms: Option<NonNegative>,
    /// Position loop: proportional gain, 1/s. With all gains missing they follow from the velocity loop.
    pub kp_per_s: Option<NonNegative>,
    /// Position loop: integral gain, 1/s^2.
    pub ki_per_s2: Option<NonNegative>,
    /// Position loop: derivative gain.
    pub kd: Option<NonNegative>,
    /// Velocity feed-forward; 1 cancels the following error at constant speed.
    pub kvff: Option<NonNegative>,
    /// Acceleration feed-forward, s.
    pub kaff_s: Option<NonNegative>,
    /// Position loop: notch filters of the speed command, two at most.
    #[serde(default)]
    pub notches: Vec<NotchFile>,
    /// Coulomb friction fed forward on a linear axis, N.
    pub friction_compensation_n: Option<NonNegative>,
    /// Coulomb friction fed forward on a rotary axis, N m.
    pub friction_compensation_n_m: Option<NonNegative>,
    /// Set speed at which it has risen to 76 %, mm/s; 0.2 % of the highest speed if missing.
    pub friction_smoothing_mm_s: Option<Positive>,
    /// Set speed at which it has risen to 76 %, degrees/s; 0.2 % of the highest speed if missing.
    pub friction_smoothing_deg_s: Option<Positive>,
    /// Lost motion made up for on a linear axis, mm: half of it is added in the direction of motion.
    pub backlash_compensation_mm: Option<NonNegative>,
    /// Lost motion made up for on a rotary axis, degrees.
    pub backlash_compensation_deg: Option<NonNegative>,
    /// Time that a reversal is spread over, ms; 20 if missing.
    pub backlash_compensation_ms: Option<Positive>,
    /// The stepper that moves the axis, if one does; for pulses.
    pub stepper: Option<StepperFile>,
}

/// A notch filter.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NotchFile {
    /// Centre, Hz; below half the rate of the position loop.
    pub frequency_hz: Positive,
    /// Gain at the centre, 0 to 1.
    pub depth: NonNegative,
    /// Width between the edges, Hz.
    pub width_hz: Positive,
}

/// A two-phase stepper with its driver, fed with step and direction pulses.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepperFile {
    /// Full steps of a turn of the motor: 200 for a step angle of 1.8 degrees.
    pub full_steps_per_turn: u32,
    /// Travel of a linear axis per turn of the motor (the lead, through all gears), mm.
    pub mm_per_turn: Option<Positive>,
    /// Rotation of a rotary axis per turn of the motor, degrees.
    pub deg_per_turn: Option<Positive>,
    /// Pulses of a full step that the driver can be set to, increasing.
    pub microsteps: Vec<u32>,
    /// Length of a pulse that is wanted of a linear axis, mm.
    pub resolution_mm: Option<Positive>,
    /// Angle of a pulse that is wanted of a rotary axis, degrees.
    pub resolution_deg: Option<Positive>,
    /// Highest pulse frequency of the driver, Hz.
    pub max_pulse_hz: Positive,
    /// Shortest time that the driver needs the step line to be high, and to be low, us.
    pub min_pulse_us: Positive,
    /// Time from a change of the direction line to the next pulse's rising edge, us.
    pub direction_setup_us: NonNegative,
    /// Time from a pulse's falling edge to a change of the direction line, us.
    pub direction_hold_us: NonNegative,
    /// Inertia of the rotor, kg m^2; for the model that shows lost steps.
    pub rotor_inertia_kg_m2: Option<Positive>,
    /// Coulomb friction of the rotor, bearings and hysteresis of the iron, N m; 0 if missing.
    pub rotor_friction_n_m: Option<NonNegative>,
    /// Speeds of the torque curve, rpm: increasing, the first 0.
    pub torque_rpm: Option<Vec<NonNegative>>,
    /// Pull-out torque at each of them, N m; at 0 rpm the holding torque.
    pub torque_n_m: Option<Vec<NonNegative>>,
}

/// Outputs of the control, by number.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Io {
    /// Digital output that switches arc or beam.
    pub arc: Option<u8>,
    /// Digital output of the gas valve.
    pub gas: Option<u8>,
    /// Digital output of the wire feeder.
    pub wire: Option<u8>,
    /// Analogue output of each process value, by the value's name (like `current_a`).
    #[serde(default)]
    pub analog: BTreeMap<String, u8>,
}

/// Names of the axes and the process on each control.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControlsFile {
    /// Siemens Sinumerik 840D.
    #[serde(default)]
    pub sinumerik: ControlFile,
    /// LinuxCNC.
    #[serde(default)]
    pub linuxcnc: ControlFile,
    /// grblHAL.
    #[serde(default)]
    pub grblhal: ControlFile,
    /// Delta Tau PMAC.
    #[serde(default)]
    pub pmac: ControlFile,
}

/// Names of the axes and the process on one control.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControlFile {
    /// Addresses of axes by their names, where they are not the axis' letter (Sinumerik: its name in capitals).
    #[serde(default)]
    pub axes: BTreeMap<String, String>,
    /// Addresses of process values by their names: Sinumerik interpolates them like axes, on grblHAL it can be `S`, on
    /// PMAC it is an M-variable. The others are analogue outputs.
    #[serde(default)]
    pub process: BTreeMap<String, String>,
    /// G- and M-codes of the machine's own, and what they do: `arc_on`, `arc_off`, `gas_on`, `gas_off`, `wire_on`,
    /// `wire_off`, `exact_stop`, `continuous_path`, or a name of its own.
    #[serde(default)]
    pub codes: BTreeMap<String, String>,
    /// True if numbers have a decimal comma.
    #[serde(default)]
    pub decimal_comma: bool,
    /// Analogue output that switches the control's kinematics: 0 for the axes, 1 for the torch tip. LinuxCNC only.
    pub kinematics_output: Option<u8>,
    /// Lines at the beginning of every part program, instead of the usual ones.
    pub header: Option<String>,
    /// Lines at its end, instead of the usual ones.
    pub footer: Option<String>,
}
