use crate::sample::Sample;
use crate::tracking::head_result::HeadSummary;
use seamwright_executive::tracking::AlarmAt;
use seamwright_machine::{Joints, Machine};
use seamwright_message::{Message, Unit};
use seamwright_motion::PassMotion;
use seamwright_program::{Finding, Tolerance};
use serde::Serialize;

/// Settling time of the drives after the acceleration phase, before the steady speed is evaluated, s.
pub(crate) const SETTLING_S: f64 = 0.5;

/// Minimum, maximum and root-mean-square value of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Extremes {
    /// Minimum.
    pub min: f64,
    /// Maximum.
    pub max: f64,
    /// Root mean square.
    pub rms: f64,
}

/// Accumulates [`Extremes`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gather {
    min: f64,
    max: f64,
    squares: f64,
    count: u64,
}

impl Gather {
    pub(crate) const fn new() -> Self {
        Self { min: f64::INFINITY, max: f64::NEG_INFINITY, squares: 0.0, count: 0 }
    }

    pub(crate) fn add(&mut self, value: f64) {
        self.min = self.min.min(value);
        self.max = self.max.max(value);
        self.squares += value * value;
        self.count += 1;
    }

    pub(crate) fn finish(self) -> Extremes {
        if self.count == 0 {
            return Extremes { min: 0.0, max: 0.0, rms: 0.0 };
        }
        Extremes { min: self.min, max: self.max, rms: (self.squares / self.count as f64).sqrt() }
    }
}

/// Results of one axis, in mm or degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AxisSummary {
    /// Name of the axis.
    pub axis: String,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// True position.
    pub position: Extremes,
    /// Its range, if it has one.
    pub range: Option<(f64, f64)>,
    /// Maximum speed of the set-points, per s.
    pub speed: f64,
    /// Its limit.
    pub max_speed: f64,
    /// Maximum acceleration of the set-points, per s^2.
    pub acceleration: f64,
    /// Its limit.
    pub max_acceleration: f64,
    /// Following error while the arc is on.
    pub following_error: Extremes,
    /// Maximum current, relative to the drive's peak.
    pub current: f64,
}

/// Results of a simulated weld; mm, s, degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Seed of the disturbances.
    pub seed: u64,
    /// From the first set-point to the last, s.
    pub total_s: f64,
    /// Travel time from rest to rest, s.
    pub weld_s: f64,
    /// Time with the arc (or beam) on, s.
    pub arc_on_s: f64,
    /// False if no part of the pass was welded: all of its numbers are zero then.
    pub welded: bool,
    /// Distance of the true tip from the seam, normal to it, during travel.
    pub path_error_mm: Extremes,
    /// Path length of the maximum, mm.
    pub path_error_at_mm: f64,
    /// Speed of the true tip along the seam, from half a second after each acceleration phase to the next deceleration
    /// phase; `rms` is that of the deviation from the planned speed. `None` if the weld is too short.
    pub tip_speed_mm_s: Option<Extremes>,
    /// Maximum deviation of that speed from the planned one over the same servo period, relative to it; `None` if the
    /// weld is too short.
    pub speed_ripple: Option<f64>,
    /// Path length of that deviation, mm.
    pub speed_ripple_at_mm: f64,
    /// Angle between true and planned torch direction during travel, degrees.
    pub attitude_error_deg: Extremes,
    /// Each axis, in machine-file order.
    pub axes: Vec<AxisSummary>,
    /// Distance of each head's weld from its joint, if the joint may differ from the plan.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub heads: Vec<HeadSummary>,
}

/// Returns the larger of two values, with its position.
fn greater(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if b.0 > a.0 { b } else { a }
}

impl Summary {
    /// Returns findings for deviations beyond the tolerance, and for drives at their current limit.
    pub fn findings(&self, tolerance: &Tolerance, pass: usize) -> Vec<Finding> {
        let finding = |kind: &'static str, message, at, cure, allowed| {
            let cure = Some(Message::new(cure));
            Finding { kind: kind.into(), message, pass, from_mm: at, to_mm: at, cure, allowed }
        };
        let mut findings = Vec::new();
        let (path, limit) = (self.path_error_mm.max, tolerance.path_mm.get());
        if path > limit {
            let message = Message::new("motion-simulated-path").quantity("deviation", path, Unit::Mm, 3).value(
                "tolerance",
                limit,
                Unit::Mm,
            );
            let cure = match self.heads.first() {
                None => "motion-cure-simulated-path",
                Some(head) if head.tracked => "motion-cure-simulated-path-tracked",
                Some(_) => "motion-cure-simulated-path-untracked",
            };
            findings.push(finding("path", message, self.path_error_at_mm, cure, false));
        }
        let (ripple, limit) = (100.0 * self.speed_ripple.unwrap_or(0.0), tolerance.speed_percent.get());
        if ripple > limit {
            let message = Message::new("motion-simulated-speed").quantity("deviation", ripple, Unit::Percent, 1).value(
                "tolerance",
                limit,
                Unit::Percent,
            );
            findings.push(finding("ripple", message, self.speed_ripple_at_mm, "motion-cure-simulated-speed", false));
        }
        if let Some((head, at)) = self.heads.iter().find_map(|h| Some((h, h.stopped_mm?))) {
            let why = head.alarms.last().map_or_else(|| Message::new("motion-simulated-other-head"), AlarmAt::message);
            let message = Message::new("motion-simulated-stop").quantity("at", at, Unit::Mm, 1).message("reason", why);
            findings.push(finding("stopped", message, at, "motion-cure-simulated-stop", false));
        }
        for axis in self.axes.iter().filter(|a| a.current > 0.999) {
            let message = Message::new("motion-simulated-drive").axis("axis", axis.axis.as_str());
            findings.push(finding("drive", message, 0.0, "motion-cure-simulated-drive", true));
        }
        findings
    }
}

/// Accumulates a [`Summary`] sample by sample.
#[derive(Debug, Clone)]
pub(crate) struct Tally {
    path_error: Gather,
    tip_speed: Gather,
    deviation: Gather,
    /// Maximum deviation of the speed and its path length.
    ripple: (f64, f64),
    /// Maximum path error and its path length.
    worst: (f64, f64),
    attitude: Gather,
    position: Vec<Gather>,
    speed: Vec<f64>,
    acceleration: Vec<f64>,
    following: Vec<Gather>,
    current: Vec<f64>,
    /// Ranges of path length (mm) in which the steady speed is evaluated.
    steady: Vec<(f64, f64)>,
    period_s: f64,
    /// Number of periods: in the pass, of travel, with the arc on.
    periods: [u64; 3],
}

impl Tally {
    pub(crate) fn new(machine: &Machine, motion: &PassMotion) -> Self {
        let axes = machine.axes.len();
        let settled = |s: f64| motion.profile.at(motion.profile.time(s) + SETTLING_S, &mut 0).s;
        let steady = motion.profile.legs();
        let steady = steady.iter().map(|leg| (settled(leg.run_up_end), leg.run_down_start));
        Self {
            path_error: Gather::new(),
            tip_speed: Gather::new(),
            deviation: Gather::new(),
            ripple: (0.0, 0.0),
            worst: (0.0, 0.0),
            attitude: Gather::new(),
            position: vec![Gather::new(); axes],
            speed: vec![0.0; axes],
            acceleration: vec![0.0; axes],
            following: vec![Gather::new(); axes],
            current: vec![0.0; axes],
            steady: steady.collect(),
            period_s: machine.servo_period_s,
            periods: [0; 3],
        }
    }

    pub(crate) fn add(&mut self, sample: &Sample, rates: &(Joints, Joints)) {
        for (periods, is) in self.periods.iter_mut().zip([true, sample.travels(), sample.arc()]) {
            *periods += u64::from(is);
        }
        let s = sample.set.profile.s;
        if sample.travels() {
            self.path_error.add(sample.path_error);
            self.worst = greater(self.worst, (sample.path_error, sample.set.profile.s));
            self.attitude.add(sample.attitude_error.to_degrees());
        }
        if sample.travels() && self.steady.iter().any(|(from, to)| s > *from && s < *to) {
            let asked = sample.planned_speed;
            self.tip_speed.add(sample.tip_speed);
            self.deviation.add(sample.tip_speed - asked);
            let deviation = (sample.tip_speed - asked).abs() / asked;
            self.ripple = greater(self.ripple, (deviation, sample.set.profile.s));
        }
        for i in 0..self.position.len() {
            self.position[i].add(sample.q[i]);
            self.speed[i] = self.speed[i].max(rates.0[i].abs());
            self.acceleration[i] = self.acceleration[i].max(rates.1[i].abs());
            self.current[i] = self.current[i].max(sample.current[i].abs());
            if sample.arc() {
                self.following[i].add(sample.following_error[i]);
            }
        }
    }

    pub(crate) fn finish(self, machine: &Machine, seed: u64) -> Summary {
        let judged = self.tip_speed.count > 0;
        let [total_s, weld_s, arc_on_s] = self.periods.map(|periods| periods as f64 * self.period_s);
        let speed = self.tip_speed.finish();
        let axes = machine.axes.iter().enumerate().map(|(i, axis)| {
            let shown =
                |e: Extremes| Extremes { min: axis.to_file(e.min), max: axis.to_file(e.max), rms: axis.to_file(e.rms) };
            AxisSummary {
                axis: axis.name.clone(),
                unit: axis.unit(),
                position: shown(self.position[i].finish()),
                range: axis.range.map(|(l, h)| (axis.to_file(l), axis.to_file(h))),
                speed: axis.to_file(self.speed[i]),
                max_speed: axis.to_file(axis.max_speed),
                acceleration: axis.to_file(self.acceleration[i]),
                max_acceleration: axis.to_file(axis.max_acceleration),
                following_error: shown(self.following[i].finish()),
                current: self.current[i],
            }
        });
        Summary {
            seed,
            total_s,
            weld_s,
            arc_on_s,
            welded: self.path_error.count > 0,
            path_error_mm: self.path_error.finish(),
            path_error_at_mm: self.worst.1,
            tip_speed_mm_s: judged.then(|| Extremes { rms: self.deviation.finish().rms, ..speed }),
            speed_ripple: judged.then_some(self.ripple.0),
            speed_ripple_at_mm: self.ripple.1,
            attitude_error_deg: self.attitude.finish(),
            axes: axes.collect(),
            heads: Vec::new(),
        }
    }
}
