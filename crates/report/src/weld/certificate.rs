use seamwright_machine::Machine;
use seamwright_motion::law::{Interval, Use};
use seamwright_motion::{Binding, PassMotion, plain};
use seamwright_program::Pass;
use serde::Serialize;

/// What a pass reaches and what bounds it where, for machines to read: mm, s, and mm or degrees for the axes. Whoever
/// knows the set-points and the machine's limits can check it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CertificateFigures {
    /// Least and greatest speed asked for, mm/s; they differ where spans do and in ramps.
    pub asked_speed_mm_s: (f64, f64),
    /// Least planned speed of the tip between run-up and run-down, mm/s.
    pub least_speed_mm_s: f64,
    /// Greatest planned speed of the tip there, mm/s.
    pub greatest_speed_mm_s: f64,
    /// Where the run-up ends, mm.
    pub run_up_end_mm: f64,
    /// Where the run-down begins, mm.
    pub run_down_start_mm: f64,
    /// Part of the path's length on which the tip is as fast as asked, %; run-up and run-down count as slower.
    pub at_asked_percent: f64,
    /// A speed of the tip that every axis can hold everywhere, mm/s.
    pub everywhere_mm_s: f64,
    /// Stretches of the path in order, each with what bounds its speed.
    pub intervals: Vec<IntervalFigures>,
    /// The greatest use of each axis' limits over the whole path.
    pub uses: Vec<UseFigures>,
    /// The greatest use of the torch tip's own limits, if it has any.
    pub tip: Option<TipFigures>,
}

/// What stands for an axis where a limit of the torch tip binds.
pub(super) const TIP: &str = "torch tip";

/// The greatest use that a pass makes of the torch tip's limits, seen from the directions in which they are imposed;
/// a limit that there is not is missing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TipFigures {
    /// Of its speed, %.
    pub speed_percent: Option<f64>,
    /// Its limit, mm/s.
    pub max_speed: Option<f64>,
    /// Of its acceleration, %.
    pub acceleration_percent: Option<f64>,
    /// Its limit, mm/s^2.
    pub max_acceleration: Option<f64>,
    /// Of its jerk, %.
    pub jerk_percent: Option<f64>,
    /// Its limit, mm/s^3.
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
    /// Path length at which it begins, mm.
    pub from_mm: f64,
    /// Path length at which it ends, mm.
    pub to_mm: f64,
    /// Least planned speed of the tip in it, mm/s.
    pub least_speed_mm_s: f64,
    /// Where that is, mm.
    pub least_at_mm: f64,
    /// Greatest planned speed of the tip in it, mm/s.
    pub greatest_speed_mm_s: f64,
    /// False in run-up and run-down.
    pub between: bool,
    /// `asked` (nothing else binds), `speed`, `acceleration` or `jerk`.
    pub bound: &'static str,
    /// The axis whose limit binds, or `torch tip`.
    pub axis: Option<String>,
    /// The limit that binds, in mm or degrees per s, s^2 or s^3.
    pub limit: Option<f64>,
    /// Its unit.
    pub unit: Option<String>,
}

/// The greatest use that a pass makes of one axis' limits; limits in mm or degrees per s, s^2 and s^3.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UseFigures {
    /// Name of the axis.
    pub axis: String,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// Of its speed, %.
    pub speed_percent: f64,
    /// Its limit.
    pub max_speed: f64,
    /// Of its acceleration, %.
    pub acceleration_percent: f64,
    /// Its limit.
    pub max_acceleration: f64,
    /// Of its jerk, %.
    pub jerk_percent: f64,
    /// Its limit.
    pub max_jerk: f64,
}

impl CertificateFigures {
    /// The certificate of `pass`, planned as `motion` on `machine`.
    pub fn new(machine: &Machine, pass: &Pass, motion: &PassMotion) -> Self {
        let (certificate, report) = (&motion.certificate, motion.law.report());
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
            bound: binding.as_ref().map_or("asked", |b| b.what),
            axis: binding.as_ref().map(|b| b.axis.clone().unwrap_or_else(|| TIP.to_owned())),
            limit: binding.as_ref().map(|b| b.value),
            unit: binding.map(|b| b.unit),
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
