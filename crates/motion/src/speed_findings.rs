//! Findings for stretches of a path on which the axes do not allow the requested speed.

use crate::limit_kind::LimitKind;
use crate::pass_channels::PassChannels;
use crate::planned::{Band, Planned};
use crate::speed_profile::{Bound, Certificate, Interval, Leg, SpeedProfile};
use crate::stretch::Stretch;
use seamwright_machine::{AxisKind, AxisLimits, Machine};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, OnLimit, Pass, PathRange};

/// Relative shortfall of speed that is reported: an axis at exactly its limit falls short by the profile's reserve
/// only.
const WORTH_SAYING: f64 = 2e-3;
/// If the requested speed or the tip's travel by path length changes, the profile stays slightly below it, and more in
/// the first and last millimetre between acceleration and deceleration phase.
const WORTH_SAYING_CHANGING: f64 = 5e-3;
const WORTH_SAYING_NEAR_END: f64 = 3e-2;
const NEAR_END_MM: f64 = 1.0;
/// Maximum fraction by which a change of the requested speed may be rounded off; a larger one is a finding.
const ROUNDED_OFF: f64 = 3e-2;
/// Fractions of the estimated maximum speed that are planned until one can be kept.
const LOWER: [f64; 4] = [1.0, 0.98, 0.93, 0.85];

/// A limit that bounds the speed, in the units of files.
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// Name of the axis, or none for the torch tip.
    pub axis: Option<String>,
    /// Kind of the limit.
    pub kind: LimitKind,
    /// The limit.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
}

impl Binding {
    /// The limit of `machine` that `bound` refers to: channels are its axes, then the tip.
    pub fn new(machine: &Machine, bound: Bound) -> Option<Self> {
        let (channel, kind) = match bound {
            Bound::Asked | Bound::Change => return None,
            Bound::Speed(i) => (i, LimitKind::Speed),
            Bound::Acceleration(i) => (i, LimitKind::Acceleration),
            Bound::Jerk(i) => (i, LimitKind::Jerk),
        };
        let of = |limits: AxisLimits| match kind {
            LimitKind::Speed => limits.speed,
            LimitKind::Acceleration => limits.acceleration,
            LimitKind::Jerk => limits.jerk,
        };
        let Some(axis) = machine.axes.get(channel) else {
            return Some(Self { axis: None, kind, value: of(machine.tip), unit: kind.unit(AxisKind::Linear) });
        };
        let value = plain(axis.to_file(of(axis.limits())));
        Some(Self { axis: Some(axis.name.clone()), kind, value, unit: kind.unit(axis.kind) })
    }

    pub(crate) fn cannot_keep(&self, asked: f64, reached: f64) -> Message {
        let message = self.message("motion-speed-axis", "motion-speed-tip").quantity("asked", asked, Unit::MmPerS, 3);
        message.quantity("reached", reached, Unit::MmPerS, 3)
    }

    /// Message `of_axis` with the axis or `of_tip` without one, and the limit.
    pub(crate) fn message(&self, of_axis: &'static str, of_tip: &'static str) -> Message {
        let message = match &self.axis {
            Some(name) => Message::new(of_axis).axis("axis", name.as_str()),
            None => Message::new(of_tip),
        };
        message.message("limit", self.kind.message()).quantity("value", self.value, self.unit, 3)
    }
}

/// A limit as written in the file, without the rounding of degrees converted through radians.
pub fn plain(limit: f64) -> f64 {
    let scale = 1e12 / 10f64.powf(limit.abs().max(f64::MIN_POSITIVE).log10().ceil());
    if scale.is_finite() { (limit * scale).round() / scale } else { limit }
}

/// Reports stretches between acceleration and deceleration phase that are slower than requested, with the limits that
/// bind there.
pub(crate) fn speed_findings(planned: Planned, pass: &Pass, number: usize) -> Vec<Finding> {
    let slow = slow_runs(planned, pass, 1.0);
    let bound = slow.iter().any(|run| run.binding.is_some());
    // The speed of a weave is reported with its frequency, see `weave_limits`.
    let wanted = pass.on_limit == OnLimit::Refuse && bound && !planned.joints.is_woven();
    let keepable = if wanted { keepable(planned, pass, &slow) } else { None };
    slow.iter().map(|run| speed_finding(planned, run, pass, number, keepable)).collect()
}

pub(crate) fn keeps_speed(planned: Planned, pass: &Pass) -> bool {
    slow_runs(planned, pass, 1.0).is_empty()
}

/// A stretch between acceleration and deceleration phase that is slower than requested.
struct SlowRun {
    from: f64,
    to: f64,
    /// Path length of the slowest point, mm, and the requested and reached speed there, mm/s.
    at: f64,
    asked: f64,
    reached: f64,
    /// The limit that is used up there; none if the profile rounds off a change of the requested speed.
    binding: Option<Binding>,
}

/// Stretches on which the profile, planned for `times` the speeds of `pass`, falls short of these by a reportable
/// fraction.
fn slow_runs(planned: Planned, pass: &Pass, times: f64) -> Vec<SlowRun> {
    let mut runs: Vec<Vec<Interval>> = vec![Vec::new()];
    let asked = |s: f64| times * pass.speed_at(s);
    for interval in between(planned, &asked) {
        match runs.last_mut() {
            Some(run) if interval.bound != Bound::Asked => run.push(interval),
            _ => runs.push(Vec::new()),
        }
    }
    let changes = planned.joints.beside || pass.spans.iter().any(|span| span.speed_mm_s.is_ramp());
    let slowest = |run: &[Interval]| run.iter().copied().min_by(|a, b| a.reached.0.total_cmp(&b.reached.0));
    runs.retain(|run| {
        let reached = slowest(run).map_or(1.0, |interval| interval.reached.0);
        let falls_short = |last: &Interval| {
            let stretch = Stretch { from: run[0].from, to: last.to };
            reached <= 1.0 - worth_saying(planned, stretch, changes)
        };
        run.last().is_some_and(falls_short)
    });
    if planned.joints.is_woven() {
        // Every swing has such a stretch: they are reported as one.
        runs = vec![runs.concat()];
    }
    let slow = |run: &Vec<Interval>| {
        let slowest = slowest(run)?;
        let (part, at) = slowest.reached;
        let asked = asked(at);
        let binding = Binding::new(planned.machine, slowest.bound);
        Some(SlowRun { from: run[0].from, to: run.last()?.to, at, asked, reached: part * asked, binding })
    };
    runs.iter().filter_map(slow).collect()
}

/// Fraction of the requested speed by which the tip may fall short on a stretch unreported; larger if speeds change.
fn worth_saying(planned: Planned, stretch: Stretch, changes: bool) -> f64 {
    let Stretch { from, to } = stretch;
    // An acceleration phase that passes smoothly into a changing speed has no clear end.
    let near = |leg: &Leg| {
        let inside = leg.from <= from && to <= leg.to;
        inside && (to < leg.run_up_end + NEAR_END_MM || from > leg.run_down_start - NEAR_END_MM)
    };
    match changes {
        true if planned.legs.iter().any(near) => WORTH_SAYING_NEAR_END,
        true => WORTH_SAYING_CHANGING,
        false => WORTH_SAYING,
    }
}

fn speed_finding(planned: Planned, run: &SlowRun, pass: &Pass, number: usize, keepable: Option<Keepable>) -> Finding {
    let SlowRun { from, to, at, asked, reached, binding } = run;
    let message = match binding {
        Some(binding) => binding.cannot_keep(*asked, *reached),
        None => {
            let message = Message::new("motion-speed-rounded-off").quantity("reached", *reached, Unit::MmPerS, 3);
            message.quantity("asked", *asked, Unit::MmPerS, 3)
        }
    };
    if pass.on_limit == OnLimit::Slow {
        let message = Message::new("motion-speed-slowed").message("reason", message);
        return Finding::note("speed", message, number, PathRange { from_mm: *from, to_mm: *to });
    }
    if binding.is_none() && *reached > (1.0 - ROUNDED_OFF) * asked {
        return Finding::note("speed", message, number, PathRange { from_mm: *from, to_mm: *to });
    }
    let cure = match (binding, keepable) {
        (None, _) => Message::new("motion-cure-longer-change"),
        (Some(_), keepable) => slower_cure(keepable, planned.joints.in_blend(*at)),
    };
    Finding::error("speed", message, number, Stretch { from: *from, to: *to }, cure)
}

/// Operator action at a limit: a lower speed, if one helps, or to slow down at the limit; in a blend also a wider one.
fn slower_cure(keepable: Option<Keepable>, in_blend: bool) -> Message {
    let new = |outside, inside| Message::new(if in_blend { inside } else { outside });
    match keepable {
        Some(Keepable::Speed(v)) => {
            new("motion-cure-speed", "motion-cure-speed-or-blend").quantity("speed", v, Unit::MmPerS, 3)
        }
        Some(Keepable::Part(part)) => {
            let cure = new("motion-cure-speed-part", "motion-cure-speed-part-or-blend");
            cure.quantity("part", 100.0 * part, Unit::Percent, 1)
        }
        None => new("motion-cure-slow", "motion-cure-slow-or-blend"),
    }
}

#[derive(Clone, Copy)]
enum Keepable {
    Speed(f64),
    /// Fraction of the requested speeds.
    Part(f64),
}

/// Returns a lower speed than that of `pass` that removes all `slow` stretches, as verified by planning. None if no
/// lower speed helps.
fn keepable(planned: Planned, pass: &Pass, slow: &[SlowRun]) -> Option<Keepable> {
    let (least, fastest) = pass.speeds();
    let steady = (fastest - least).abs() <= f64::EPSILON * fastest;
    let reached = slow.iter().map(|run| run.reached / run.asked).fold(1.0, f64::min);
    let everywhere = planned.certificate.everywhere / fastest;
    // The speed that can be held everywhere; if it is not lower, the limits are used up at changes of speed.
    let most = if steady && everywhere < 1.0 { everywhere } else { reached };
    // Rounded down, so that the printed speed is feasible.
    let rounded = |part: f64| match steady {
        true => (1e3 * part * fastest).floor() * 1e-3 / fastest,
        false => (1e3 * part).floor() * 1e-3,
    };
    let keeps = |part: &f64| {
        let channels = PassChannels::new(planned.machine, planned.joints, pass, *part);
        let Ok(profile) = SpeedProfile::new(&channels) else { return false };
        let certificate = Certificate::new(&channels, &profile);
        let lower = Planned { profile: &profile, certificate: &certificate, legs: &profile.legs(), ..planned };
        slow_runs(lower, pass, *part).is_empty()
    };
    let part = LOWER.iter().map(|lower| rounded(lower * most)).find(keeps)?;
    Some(if steady { Keepable::Speed(part * fastest) } else { Keepable::Part(part) })
}

/// The certificate's stretches without the acceleration and deceleration phase of each leg.
fn between(planned: Planned, asked: &dyn Fn(f64) -> f64) -> Vec<Interval> {
    let mut all = Vec::new();
    let rounding = 1e-9 * planned.joints.length();
    for i in planned.certificate.intervals.iter().filter(|i| i.between) {
        for leg in planned.legs {
            let (from, to) = (i.from.max(leg.run_up_end), i.to.min(leg.run_down_start));
            if from - i.from <= rounding && i.to - to <= rounding {
                all.push(*i);
            } else if to - from > rounding
                && let Some(band) = planned.tip_band(Stretch { from, to }, asked)
            {
                let Band { least, greatest, reached } = band;
                all.push(Interval { from, to, speed: (least.0, greatest), least_at: least.1, reached, ..*i });
            }
        }
    }
    all
}

pub(crate) fn never_reached(planned: Planned, asked: f64, on_limit: OnLimit, pass: usize) -> Vec<Finding> {
    let finding = |leg: &Leg| {
        let reached = planned.tip_speed_at(leg.run_up_end);
        let several = planned.legs.len() > 1;
        if reached >= asked * (1.0 - WORTH_SAYING) || leg.run_up_end < leg.run_down_start {
            return None;
        }
        let message = Message::new(if several { "motion-too-short-between-stops" } else { "motion-too-short" })
            .quantity("reached", reached, Unit::MmPerS, 3)
            .quantity("asked", asked, Unit::MmPerS, 3);
        let range = PathRange { from_mm: leg.from, to_mm: if several { leg.to } else { leg.run_up_end } };
        if on_limit == OnLimit::Slow {
            return Some(Finding::note("speed", message, pass, range));
        }
        let speed = (reached * 1e3).floor() * 1e-3;
        let cure = Message::new("motion-cure-speed-at-most").quantity("speed", speed, Unit::MmPerS, 3);
        Some(Finding::error("speed", message, pass, range, cure))
    };
    planned.legs.iter().filter_map(finding).collect()
}

/// Joins neighbouring stations with the same complaint into runs and keeps the worst message of each.
#[derive(Default)]
pub(crate) struct Runs {
    runs: Vec<Run>,
    open: bool,
}

pub(crate) struct Run {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) message: Message,
    pub(crate) key: usize,
    worst: f64,
}

impl Run {
    pub(crate) fn stretch(&self) -> Stretch {
        Stretch { from: self.from, to: self.to }
    }
}

impl Runs {
    /// Adds the next station: none, or a complaint as (key, severity, message).
    pub(crate) fn add(&mut self, s: f64, complaint: Option<(usize, f64, Message)>) {
        let Some((key, worst, message)) = complaint else {
            self.open = false;
            return;
        };
        match self.runs.last_mut().filter(|r| self.open && r.key == key) {
            Some(run) => {
                run.to = s;
                if worst > run.worst {
                    (run.worst, run.message) = (worst, message);
                }
            }
            None => self.runs.push(Run { from: s, to: s, message, key, worst }),
        }
        self.open = true;
    }

    pub(crate) fn is_open(&self) -> bool {
        self.open
    }

    pub(crate) fn findings(&self, make: impl Fn(&Run) -> Finding) -> Vec<Finding> {
        self.runs.iter().map(make).collect()
    }
}
