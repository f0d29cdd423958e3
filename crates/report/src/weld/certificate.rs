use seamwright_machine::Machine;
use seamwright_motion::speed_profile::{Interval, Use};
use seamwright_motion::{Binding, PassMotion, plain};
use seamwright_program::Pass;
use serde::Serialize;

/// Speeds of a pass and their bounds, machine-readable: mm, s, and mm or degrees for the axes. They can be verified
/// from the set-points and the machine's limits.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CertificateFigures {
    /// Minimum and maximum requested speed, mm/s; they differ between spans and in ramps.
    pub asked_speed_mm_s: (f64, f64),
    /// Minimum planned speed of the torch tip between acceleration and deceleration phase, mm/s.
    pub least_speed_mm_s: f64,
    /// Maximum planned speed of the torch tip there, mm/s.
    pub greatest_speed_mm_s: f64,
    /// End of the acceleration phase, mm.
    pub run_up_end_mm: f64,
    /// Start of the deceleration phase, mm.
    pub run_down_start_mm: f64,
    /// Percentage of the path's length at the requested torch-tip speed; acceleration and deceleration phase count as
    /// slower.
    pub at_asked_percent: f64,
    /// Torch-tip speed that every axis can hold everywhere, mm/s.
    pub everywhere_mm_s: f64,
    /// Stretches of the path in order, each with the bound of its speed.
    pub intervals: Vec<IntervalFigures>,
    /// Maximum use of each axis' limits over the whole path.
    pub uses: Vec<UseFigures>,
    /// Maximum use of the torch tip's own limits, if it has any.
    pub tip: Option<TipFigures>,
}

/// Name in place of an axis where a limit of the torch tip binds.
pub(super) const TIP: &str = "torch tip";

/// Maximum use of the torch tip's limits in a pass, in the directions in which they apply; `None` without that limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TipFigures {
    /// Use of its speed limit, %.
    pub speed_percent: Option<f64>,
    /// Speed limit, mm/s.
    pub max_speed: Option<f64>,
    /// Use of its acceleration limit, %.
    pub acceleration_percent: Option<f64>,
    /// Acceleration limit, mm/s^2.
    pub max_acceleration: Option<f64>,
    /// Use of its jerk limit, %.
    pub jerk_percent: Option<f64>,
    /// Jerk limit, mm/s^3.
    pub max_jerk: Option<f64>,
}

impl TipFigures {
    fn new(machine: &Machine, uses: &[Use]) -> Option<Self> {
        let given = |limit: f64| limit.is_finite().then_some(limit);
        let used = |limit: f64, part: fn(&Use) -> f64| {
            given(limit).map(|_| uses.iter().map(|used| 100.0 * part(used)).fold(0.0, f64::max))
        };
        let limits = machine.tip;
        (!uses.is_empty()).then(|| Self {
            speed_percent: used(limits.speed, |u| u.speed),
            max_speed: given(limits.speed),
            acceleration_percent: used(limits.acceleration, |u| u.acceleration),
            max_acceleration: given(limits.acceleration),
            jerk_percent: used(limits.jerk, |u| u.jerk),
            max_jerk: given(limits.jerk),
        })
    }
}

/// A stretch of the path with one bound.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct IntervalFigures {
    /// Path length of its start, mm.
    pub from_mm: f64,
    /// Path length of its end, mm.
    pub to_mm: f64,
    /// Minimum planned speed of the torch tip in it, mm/s.
    pub least_speed_mm_s: f64,
    /// Path length of that minimum, mm.
    pub least_at_mm: f64,
    /// Maximum planned speed of the torch tip in it, mm/s.
    pub greatest_speed_mm_s: f64,
    /// False in the acceleration and deceleration phases.
    pub between: bool,
    /// `asked` (the requested speed itself), `speed`, `acceleration` or `jerk`.
    pub bound: &'static str,
    /// Axis of the binding limit, or `torch tip`.
    pub axis: Option<String>,
    /// Binding limit, in mm or degrees per s, s^2 or s^3.
    pub limit: Option<f64>,
    /// Its unit.
    pub unit: Option<String>,
}

/// Maximum use of one axis' limits in a pass; limits in mm or degrees per s, s^2 and s^3.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UseFigures {
    /// Name of the axis.
    pub axis: String,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// Use of its speed limit, %.
    pub speed_percent: f64,
    /// Speed limit.
    pub max_speed: f64,
    /// Use of its acceleration limit, %.
    pub acceleration_percent: f64,
    /// Acceleration limit.
    pub max_acceleration: f64,
    /// Use of its jerk limit, %.
    pub jerk_percent: f64,
    /// Jerk limit.
    pub max_jerk: f64,
}

impl CertificateFigures {
    /// Computes the certificate of `pass`, planned as `motion` on `machine`.
    pub fn new(machine: &Machine, pass: &Pass, motion: &PassMotion) -> Self {
        let (certificate, report) = (&motion.certificate, motion.profile.report());
        let (least, greatest) = motion.tip_band(machine);
        Self {
            asked_speed_mm_s: pass.speeds(),
            least_speed_mm_s: least,
            greatest_speed_mm_s: greatest,
            run_up_end_mm: report.run_up_end,
            run_down_start_mm: report.run_down_start,
            // `+ 0.0` turns the negative zero of an empty sum into zero.
            at_asked_percent: 100.0 * certificate.at_asked + 0.0,
            everywhere_mm_s: certificate.everywhere,
            intervals: certificate.intervals.iter().map(|i| IntervalFigures::new(machine, i)).collect(),
            uses: machine.axes.iter().zip(&certificate.uses).map(|(axis, used)| UseFigures::new(axis, used)).collect(),
            tip: TipFigures::new(machine, certificate.uses.get(machine.axes.len()..).unwrap_or_default()),
        }
    }
}

impl IntervalFigures {
    fn new(machine: &Machine, i: &Interval) -> Self {
        let binding = Binding::new(machine, i.bound);
        Self {
            from_mm: i.from,
            to_mm: i.to,
            least_speed_mm_s: i.speed.0,
            least_at_mm: i.least_at,
            greatest_speed_mm_s: i.speed.1,
            between: i.between,
            bound: binding.as_ref().map_or("asked", |b| b.kind.name()),
            axis: binding.as_ref().map(|b| b.axis.clone().unwrap_or_else(|| TIP.to_owned())),
            limit: binding.as_ref().map(|b| b.value),
            unit: binding.map(|b| b.unit.to_string()),
        }
    }
}

impl UseFigures {
    fn new(axis: &seamwright_machine::Axis, used: &Use) -> Self {
        Self {
            axis: axis.name.clone(),
            unit: axis.unit(),
            speed_percent: 100.0 * used.speed,
            max_speed: plain(axis.to_file(axis.max_speed)),
            acceleration_percent: 100.0 * used.acceleration,
            max_acceleration: plain(axis.to_file(axis.max_acceleration)),
            jerk_percent: 100.0 * used.jerk,
            max_jerk: plain(axis.to_file(axis.jerk())),
        }
    }
}
