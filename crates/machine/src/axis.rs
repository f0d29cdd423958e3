use crate::AxisLimits;
use crate::pitch_error::PitchError;
use crate::stepper::Stepper;
use schemars::JsonSchema;
use seamwright_message::Unit;
use seamwright_servo::{BacklashCompensation, FrictionCompensation, Gains, NotchSettings, Transmission};
use serde::Deserialize;
use std::f64::consts::{PI, TAU};
use std::ops::RangeInclusive;

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
    /// Maximum speed.
    pub max_speed: f64,
    /// Maximum acceleration.
    pub max_acceleration: f64,
    /// Maximum jerk, infinite if not given: motion is planned with [`Axis::jerk`].
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
    /// The moved load.
    pub load: Load,
    /// Encoder counts per mm or rad.
    pub encoder_counts_per_unit: f64,
    /// Bandwidth of the velocity loop, Hz.
    pub velocity_bandwidth_hz: f64,
    /// Time constant of the current loop, s.
    pub current_time_constant_s: f64,
    /// Dead time of the current loop, s.
    pub current_delay_s: f64,
    /// Limit of force or torque; none: its peak.
    pub force_limit: Option<f64>,
    /// Transmission between motor and load; none: a rigid connection.
    pub transmission: Option<Transmission>,
    /// Gains of the position loop; none: derived from the velocity loop.
    pub gains: Option<Gains>,
    /// Notch filters of the position loop, at most two.
    pub notches: Vec<NotchSettings>,
    /// Friction feed-forward.
    pub friction_compensation: Option<FrictionCompensation>,
    /// Backlash compensation.
    pub backlash_compensation: Option<BacklashCompensation>,
}

impl Drive {
    /// Time constant of the current loop, s, if none is given.
    pub const CURRENT_TIME_CONSTANT_S: f64 = 2e-4;
}

/// Load of a drive: mass and forces in kg, N and N s/m, or inertia and torques in kg m^2, N m and N m s/rad.
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

/// An axis position outside its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeViolation {
    /// Index of the axis.
    pub axis: usize,
    /// Requested position, mm or rad.
    pub value: f64,
    /// The exceeded limit of the range.
    pub limit: f64,
}

impl RangeViolation {
    /// Excess over the limit, mm or rad.
    pub fn by(&self) -> f64 {
        (self.value - self.limit).abs()
    }
}

impl Axis {
    /// The jerk for motion planning: the maximum jerk or, if the file has none, the jerk that reaches the full
    /// acceleration in 20 ms. A drive's torque cannot jump, so set-points never require it.
    pub fn jerk(&self) -> f64 {
        const WITHOUT_LIMIT_PER_S: f64 = 50.0;
        if self.max_jerk.is_finite() { self.max_jerk } else { WITHOUT_LIMIT_PER_S * self.max_acceleration }
    }

    /// The limits for motion planning, with the jerk of [`Axis::jerk`].
    pub fn limits(&self) -> AxisLimits {
        AxisLimits { speed: self.max_speed, acceleration: self.max_acceleration, jerk: self.jerk() }
    }

    /// The limit that `value` exceeds; none inside the range.
    pub fn outside(&self, value: f64) -> Option<f64> {
        let (low, high) = self.range?;
        if value >= low && value <= high {
            return None;
        }
        // NaN counts as outside too.
        Some(if value < low { low } else { high })
    }

    /// The number of whole turns nearest to `wanted` that brings all `positions` into the range; none if they do not
    /// fit. A continuous axis fits all.
    pub fn turns_within(&self, positions: RangeInclusive<f64>, wanted: f64) -> Option<f64> {
        let (low, high) = positions.into_inner();
        let Some((least, most)) = self.range else { return Some(wanted) };
        let (first, last) = (((least - low) / TAU).ceil(), ((most - high) / TAU).floor());
        (first <= last).then(|| wanted.clamp(first, last))
    }

    /// The position nearest to `near` that differs from `value` by whole turns; linear axes return `value`.
    pub fn turn_near(&self, value: f64, near: f64) -> f64 {
        match self.kind {
            AxisKind::Linear => value,
            // Most values are within half a turn already.
            AxisKind::Rotary if (near - value).abs() <= PI => value,
            AxisKind::Rotary => value + TAU * ((near - value) / TAU).round(),
        }
    }

    /// The indicated position `turns` whole turns further: with a pitch error, whole turns of the true position.
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

    /// Unit of positions in messages: that of files.
    pub fn position_unit(&self) -> Unit {
        self.one_of(Unit::Mm, Unit::Deg)
    }

    /// Unit of speeds in messages.
    pub fn speed_unit(&self) -> Unit {
        self.one_of(Unit::MmPerS, Unit::DegPerS)
    }

    /// The first value for a linear axis, the second for a rotary one.
    pub(crate) fn one_of<T>(&self, linear: T, rotary: T) -> T {
        match self.kind {
            AxisKind::Linear => linear,
            AxisKind::Rotary => rotary,
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

/// Which side of the transmission an encoder measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum EncoderSide {
    /// The motor.
    #[default]
    Motor,
    /// The load.
    Load,
}
