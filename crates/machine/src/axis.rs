use crate::{EncoderSide, PitchError, Stepper};
use std::f64::consts::{PI, TAU};

/// Linear or rotary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisKind {
    /// Positions in mm.
    Linear,
    /// Positions in rad.
    Rotary,
}

/// One axis with its limits; mm or rad, s.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Name in files and columns.
    pub name: String,
    /// Letter in part programs, if it has one.
    pub letter: Option<char>,
    /// Linear or rotary.
    pub kind: AxisKind,
    /// Lowest and highest position; none for a continuous rotary axis.
    pub range: Option<(f64, f64)>,
    /// Position after homing.
    pub home: f64,
    /// Highest speed.
    pub max_speed: f64,
    /// Highest acceleration.
    pub max_acceleration: f64,
    /// Highest jerk, infinite if not given: motion is planned with [`Axis::jerk`].
    pub max_jerk: f64,
    /// Measured pitch error, if the file has one.
    pub pitch_error: Option<PitchError>,
    /// Drive for the simulation, if the file describes one.
    pub drive: Option<Drive>,
    /// The stepper that moves it, if the file describes one.
    pub stepper: Option<Stepper>,
}

/// A drive with its load and position loop, in the units of the file (N, kg, N m, kg m^2, counts per mm or rad).
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// What it moves.
    pub load: Load,
    /// Encoder counts per mm or rad.
    pub encoder_counts_per_unit: f64,
    /// Bandwidth of the velocity loop, Hz.
    pub velocity_bandwidth_hz: f64,
    /// Time constant of the current loop, s.
    pub current_time_constant_s: f64,
    /// Dead time of the current loop, s.
    pub current_delay_s: f64,
    /// Force or torque that it is limited to; none: its peak.
    pub force_limit: Option<f64>,
    /// What is between motor and load; none: they are one.
    pub transmission: Option<Transmission>,
    /// Gains of the position loop; none: to follow from the velocity loop.
    pub gains: Option<Gains>,
    /// Notch filters of the position loop, two at most.
    pub notches: Vec<Notch>,
    /// Friction fed forward.
    pub friction_compensation: Option<FrictionCompensation>,
    /// Lost motion made up for.
    pub backlash_compensation: Option<BacklashCompensation>,
}

impl Drive {
    /// Time constant of the current loop, s, if none is given.
    pub const CURRENT_TIME_CONSTANT_S: f64 = 2e-4;
}

impl FrictionCompensation {
    /// [`FrictionCompensation::smoothing`] as a part of the axis' highest speed, if none is given.
    pub const SMOOTHING: f64 = 0.002;
}

impl BacklashCompensation {
    /// [`BacklashCompensation::time_s`], if none is given.
    pub const TIME_S: f64 = 0.02;
}

/// An elastic transmission with a gap; mm or rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transmission {
    /// Frequency at which motor and load swing against each other, Hz.
    pub resonance_hz: f64,
    /// Damping of that swing, a part of the critical one.
    pub damping: f64,
    /// Inertia of the load over that of the motor.
    pub load_ratio: f64,
    /// Whole width of the gap.
    pub backlash: f64,
    /// Part of the friction that is at the motor.
    pub motor_friction: f64,
    /// Which side the encoder measures.
    pub encoder_on: EncoderSide,
}

/// A notch filter on the speed command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Notch {
    /// Centre, Hz.
    pub frequency_hz: f64,
    /// Gain at the centre.
    pub depth: f64,
    /// Width, Hz.
    pub width_hz: f64,
}

/// Coulomb friction fed forward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionCompensation {
    /// Force or torque, N or N m.
    pub force: f64,
    /// Set speed at which it has risen to 76 %; mm/s or rad/s.
    pub smoothing: f64,
}

/// Lost motion made up for on reversal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BacklashCompensation {
    /// Whole lost motion, mm or rad.
    pub width: f64,
    /// Time that a reversal is spread over, s.
    pub time_s: f64,
}

/// Gains of a position loop (DUALBEAM-2013).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// Proportional, 1/s.
    pub kp: f64,
    /// Integral, 1/s^2.
    pub ki: f64,
    /// Derivative.
    pub kd: f64,
    /// Velocity feed-forward.
    pub kvff: f64,
    /// Acceleration feed-forward, s.
    pub kaff: f64,
}

/// What a drive moves: mass and forces in kg, N and N s/m, or inertia and torques in kg m^2, N m and N m s/rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Mass or inertia.
    pub inertia: f64,
    /// Peak force or torque.
    pub peak: f64,
    /// Coulomb friction.
    pub coulomb: f64,
    /// Viscous friction.
    pub viscous: f64,
}

/// An axis would have to leave its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeViolation {
    /// Index of the axis.
    pub axis: usize,
    /// Position asked for, mm or rad.
    pub value: f64,
    /// The end of the range that it passes.
    pub limit: f64,
}

impl RangeViolation {
    /// By how much the limit is passed, mm or rad.
    pub fn by(&self) -> f64 {
        (self.value - self.limit).abs()
    }
}

impl Axis {
    /// The jerk that motion is planned with: the highest one, or, where the file gives none, the one that builds up the
    /// full acceleration in 20 ms. No drive's torque jumps, so no set-points ask for that.
    pub fn jerk(&self) -> f64 {
        const WITHOUT_LIMIT_PER_S: f64 = 50.0;
        if self.max_jerk.is_finite() { self.max_jerk } else { WITHOUT_LIMIT_PER_S * self.max_acceleration }
    }

    /// How far `value` is outside the range (0 inside), and the limit it passes.
    pub fn outside(&self, value: f64) -> Option<f64> {
        let (low, high) = self.range?;
        if value >= low && value <= high {
            return None;
        }
        // A value that is no number is outside too.
        Some(if value < low { low } else { high })
    }

    /// Whole turns, as near as can be to `wanted`, that bring positions from `low` to `high` into the range; none if it
    /// has no room for them. An axis without ends has room for all.
    pub fn turns_within(&self, (low, high): (f64, f64), wanted: f64) -> Option<f64> {
        let Some((least, most)) = self.range else { return Some(wanted) };
        let (first, last) = (((least - low) / TAU).ceil(), ((most - high) / TAU).floor());
        (first <= last).then(|| wanted.clamp(first, last))
    }

    /// The position equal to `value` up to whole turns that is nearest to `near`; linear axes have no turns.
    pub fn turn_near(&self, value: f64, near: f64) -> f64 {
        match self.kind {
            AxisKind::Linear => value,
            // Most values are within half a turn already.
            AxisKind::Rotary if (near - value).abs() <= PI => value,
            AxisKind::Rotary => value + TAU * ((near - value) / TAU).round(),
        }
    }

    /// The indicated position `turns` whole turns on: an axis with a pitch error truly turns whole turns there.
    pub fn turned(&self, value: f64, turns: f64) -> f64 {
        match &self.pitch_error {
            Some(error) if turns != 0.0 => error.indicated_at(error.true_at(value).0 + TAU * turns),
            _ => value + TAU * turns,
        }
    }

    /// Unit of positions in files and columns.
    pub fn unit(&self) -> &'static str {
        match self.kind {
            AxisKind::Linear => "mm",
            AxisKind::Rotary => "deg",
        }
    }

    /// From mm or rad to the unit of files and columns.
    pub fn to_file(&self, value: f64) -> f64 {
        match self.kind {
            AxisKind::Linear => value,
            AxisKind::Rotary => value.to_degrees(),
        }
    }

    /// From the unit of files and columns to mm or rad.
    pub fn from_file(&self, value: f64) -> f64 {
        match self.kind {
            AxisKind::Linear => value,
            AxisKind::Rotary => value.to_radians(),
        }
    }
}
