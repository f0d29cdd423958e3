//! Survey of a path before planning: start branch and turn, and all findings against the path.

use crate::effort::Effort;
use crate::follower::Follower;
use crate::joint_path::{JointPath, PLACES};
use crate::speed_findings::Runs;
use crate::stretch::Stretch;
use seamwright_geometry::numeric::bisect;
use seamwright_machine::{Axis, AxisKind, Joints, Machine};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, PathRange, Tolerance};
use std::f64::consts::TAU;

/// Stride of the samples at which a search without closed form is made if the path cannot be followed.
const NUMERIC_STRIDE: usize = 24;
/// Maximum number of such searches at other samples: one at the start of each stretch without a solution.
const MAX_FIRST_SEARCHES: usize = PLACES / NUMERIC_STRIDE;
/// Units of effort of such a search.
const SEARCH_WORK: u64 = 600;

/// Attitude errors above this are listed as findings, rad.
const ATTITUDE_WORTH_SAYING: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// The start of the path, as a stretch without length.
const START: Stretch = Stretch { from: 0.0, to: 0.0 };

pub(crate) struct Survey {
    /// Positions at the start of the path, on the chosen branch and turn.
    pub(crate) start: Joints,
    /// Maximum angle between the requested direction and the reached one, rad, and its path length.
    pub(crate) attitude_error: (f64, f64),
    pub(crate) findings: Vec<Finding>,
    /// Maximum excess of each axis at each end of its range.
    pub(crate) lacks: Vec<Lack>,
}

/// An axis beyond one end of its range, at the path length of the maximum excess.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lack {
    pub(crate) axis: usize,
    pub(crate) s: f64,
    /// Excess, mm or rad; negative below the range.
    pub(crate) by: f64,
    pub(crate) q: Joints,
}

/// Walks the path on every branch and returns the best one. If redundant axes are resolved for the whole path, the
/// branch is chosen with them.
pub(crate) fn survey(
    follower: Follower,
    tolerance: &Tolerance,
    pass: usize,
    effort: &Effort,
) -> Result<Survey, Vec<Finding>> {
    let machine = follower.machine;
    let length = follower.path.length();
    let places: Vec<f64> = (0..=PLACES).map(|i| length * i as f64 / PLACES as f64).collect();
    let unreachable = unreachable(follower, &places, pass, effort);
    effort.check(pass, length)?;
    if !unreachable.is_empty() {
        return Err(unreachable);
    }
    let mut best: Option<(f64, Survey)> = None;
    for start in starts(follower, &places, pass)? {
        let mut walk = walk(follower, &places, start, pass);
        walk.findings.extend(attitude_finding(machine, &walk, tolerance, pass));
        walk.findings.extend(arc_finding(follower, &walk, pass));
        let cost = cost(machine, &walk);
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, walk));
        }
    }
    let no_solution = || reach_finding(machine, Message::new("motion-no-solution"), START, pass);
    best.map(|(_, survey)| survey).ok_or_else(|| vec![no_solution()])
}

/// Possible start positions of a walk.
fn starts(follower: Follower, places: &[f64], pass: usize) -> Result<Vec<Joints>, Vec<Finding>> {
    if let Some(start) = follower.free.start() {
        return Ok(vec![start]);
    }
    let home = follower.machine.home();
    // An axis that is free exactly at the start takes its position slightly later.
    let later = follower.near(places[1] * 1e-3, &home).map_or(home, |s| s.joints);
    match follower.branches(0.0, &later) {
        Ok(branches) => Ok(branches.iter().map(|b| b.joints).collect()),
        Err(reason) => Err(vec![reach_finding(follower.machine, reason.message(), START, pass)]),
    }
}

/// Reports ranges of the path that no axis positions reach.
fn unreachable(follower: Follower, places: &[f64], pass: usize, effort: &Effort) -> Vec<Finding> {
    let home = follower.machine.home();
    let numeric = follower.machine.heads[0].is_numeric();
    let mut runs = Runs::default();
    let mut last = follower.free.start().unwrap_or(home);
    let mut first_searches = 0;
    for (i, &s) in places.iter().enumerate() {
        if !effort.spend(1, i as f64 / places.len() as f64) {
            break;
        }
        // Continuation from the previous sample is quick. If it fails, a search without closed form takes thousands of
        // times as long: it is made at the first failure, and then at some of the samples only.
        let is_strided = i % NUMERIC_STRIDE == 0;
        let is_first = !runs.is_open() && first_searches < MAX_FIRST_SEARCHES;
        let reason = match follower.next(s, &last) {
            Ok(solution) => {
                last = solution.joints;
                None
            }
            Err(reason) if numeric && !is_strided && !is_first => runs.is_open().then(|| reason.message()),
            Err(_) => {
                first_searches += usize::from(numeric && !is_strided);
                effort.spend(SEARCH_WORK, i as f64 / places.len() as f64);
                let found = follower.branches(s, &home);
                if let Ok(branches) = &found {
                    last = branches[0].joints;
                }
                found.err().map(|reason| reason.message())
            }
        };
        runs.add(s, reason.map(|message| (0, 0.0, message)));
    }
    runs.findings(|run| {
        let stretch = Stretch { from: run.from, to: run.to };
        reach_finding(follower.machine, run.message.clone(), stretch, pass)
    })
}

fn reach_finding(machine: &Machine, reason: Message, stretch: Stretch, pass: usize) -> Finding {
    let message = Message::new("motion-unreachable").text("machine", machine.name.as_str()).message("reason", reason);
    Finding::error("reach", message, pass, stretch, Message::new("motion-cure-unreachable"))
}

fn walk(follower: Follower, places: &[f64], start: Joints, pass: usize) -> Survey {
    let machine = follower.machine;
    let mut rows: Vec<Joints> = Vec::with_capacity(places.len());
    let mut attitude_error = (0.0, 0.0);
    for &s in places {
        let near = rows.last().copied().unwrap_or(start);
        // Reachability was checked before; a sample that fails between checked ones keeps its neighbour's positions.
        let solution = follower.next(s, &near);
        if let Ok(solution) = &solution
            && solution.attitude_error > attitude_error.0
        {
            attitude_error = (solution.attitude_error, s);
        }
        rows.push(solution.map_or(near, |s| s.joints));
    }
    let shift = turns_into_range(follower, &rows);
    for row in &mut rows {
        row.iter_mut().zip(&shift).for_each(|(q, d)| *q += d);
    }
    let findings = range_findings(machine, places, &rows, pass);
    Survey { start: rows[0], attitude_error, findings, lacks: lacks(machine, places, &rows) }
}

fn attitude_finding(machine: &Machine, walk: &Survey, tolerance: &Tolerance, pass: usize) -> Option<Finding> {
    let (error, at) = walk.attitude_error;
    let allowed = error.to_degrees() <= tolerance.attitude_deg.get();
    (error > ATTITUDE_WORTH_SAYING).then(|| {
        let message = Message::new("motion-attitude")
            .text("machine", machine.name.as_str())
            .quantity("error", error.to_degrees(), Unit::Deg, 2)
            .value("tolerance", tolerance.attitude_deg.get(), Unit::Deg);
        let cure = Message::new("motion-cure-attitude");
        Finding { allowed, ..Finding::error("attitude", message, pass, PathRange::at(at), cure) }
    })
}

/// Maximum distance of the arc from its line where the torch's attitude is not reached, mm.
const MAX_ARC_OFF_MM: f64 = 0.1;

/// Reports an arc that the wire of a torch drawn back leads beside the line.
fn arc_finding(follower: Follower, walk: &Survey, pass: usize) -> Option<Finding> {
    let (error, at) = walk.attitude_error;
    let back = follower.path.drawn_back();
    let off = 2.0 * back.abs() * (0.5 * error).sin();
    (off > MAX_ARC_OFF_MM).then(|| {
        let message = Message::new("motion-arc-off-line")
            .text("machine", follower.machine.name.as_str())
            .quantity("back", back, Unit::Mm, 1)
            .quantity("off", off, Unit::Mm, 2);
        Finding::error("attitude", message, pass, PathRange::at(at), Message::new("motion-cure-arc-off-line"))
    })
}

/// Whole turns to add to each rotary axis so that its positions lie in its range, as near to home as possible.
fn turns_into_range(follower: Follower, rows: &[Joints]) -> Joints {
    let mut shift = Joints::default();
    if follower.is_given() {
        return shift;
    }
    for (i, axis) in follower.machine.axes.iter().enumerate() {
        // Redundant axes are already on their turn.
        // A limited axis with a table of pitch errors is not periodic: it stays on the turn nearest to home.
        let alike = axis.pitch_error.is_none() || axis.range.is_none();
        if axis.kind == AxisKind::Linear || follower.free.has(i) || !alike {
            continue;
        }
        let (low, high) = extremes(rows, i);
        let near_home = -((0.5 * (low + high) - axis.home) / TAU).round();
        shift[i] = TAU * axis.turns_within(low..=high, near_home).unwrap_or(near_home);
    }
    shift
}

fn extremes(rows: &[Joints], axis: usize) -> (f64, f64) {
    rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), q| (l.min(q[axis]), h.max(q[axis])))
}

fn range_findings(machine: &Machine, places: &[f64], rows: &[Joints], pass: usize) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (i, axis) in machine.axes.iter().enumerate() {
        // Neighbouring samples outside form one finding, with its worst value.
        let mut run: Option<(f64, f64, f64, f64)> = None;
        for (&s, q) in places.iter().zip(rows) {
            run = match (axis.outside(q[i]), run) {
                (Some(limit), None) => Some((s, s, q[i], limit)),
                (Some(limit), Some((from, _, worst, _))) => {
                    let worse = (q[i] - limit).abs() > (worst - limit).abs();
                    Some((from, s, if worse { q[i] } else { worst }, limit))
                }
                (None, Some((from, to, worst, limit))) => {
                    findings.push(range_finding(axis, worst, limit, Stretch { from, to }, pass));
                    None
                }
                (None, None) => None,
            };
        }
        let last = |(from, to, worst, limit)| range_finding(axis, worst, limit, Stretch { from, to }, pass);
        findings.extend(run.map(last));
    }
    findings
}

/// Reports ranges exceeded at the samples of the axes' path, after it has been turned.
pub(crate) fn range_on_path(machine: &Machine, path: &JointPath, pass: usize) -> Vec<Finding> {
    let places: Vec<f64> = (0..=PLACES).map(|i| path.length() * i as f64 / PLACES as f64).collect();
    let rows: Vec<Joints> = places.iter().map(|&s| path.at(s)).collect();
    range_findings(machine, &places, &rows, pass)
}

/// Reports ranges exceeded only between the survey's samples: at extremes of an axis at its reversals.
pub(crate) fn range_between(machine: &Machine, path: &JointPath, pass: usize) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut places: Vec<f64> = (0..=PLACES).map(|i| path.length() * i as f64 / PLACES as f64).collect();
    // A weave reverses more often than that, but hardly twice in half a panel.
    if path.is_woven() {
        places.extend(path.edges().windows(2).flat_map(|w| [w[0], 0.5 * (w[0] + w[1])]));
    }
    places.sort_by(f64::total_cmp);
    for ends in places.windows(2) {
        let (a, b) = (ends[0], ends[1]);
        let (start, end) = (path.point(a, false), path.point(b, true));
        for (k, axis) in machine.axes.iter().enumerate() {
            if start.d1[k] * end.d1[k] >= 0.0 {
                continue;
            }
            let (s, _) = bisect(a, b, 50, |s| path.point(s, false).d1[k] * start.d1[k] > 0.0);
            let value = path.at(s)[k];
            // The survey has already reported samples outside the range.
            if let Some(limit) = axis.outside(value)
                && axis.outside(start.q[k]).is_none()
                && axis.outside(end.q[k]).is_none()
            {
                findings.push(range_finding(axis, value, limit, Stretch { from: s, to: s }, pass));
            }
        }
    }
    findings
}

fn range_finding(axis: &Axis, value: f64, limit: f64, stretch: Stretch, pass: usize) -> Finding {
    let (value, limit, unit) = (axis.to_file(value), axis.to_file(limit), axis.position_unit());
    let message = Message::new("motion-beyond-range")
        .axis("axis", axis.name.as_str())
        .quantity("value", value, unit, 3)
        .quantity("by", (value - limit).abs(), unit, 3)
        .quantity("limit", limit, unit, 3);
    // Changes are tried when the pass is planned.
    Finding::error("range", message, pass, stretch, Message::new("motion-cure-range"))
}

/// Orders walks: feasible before infeasible ones, then by range excess, then by attitude error, then by distance from
/// home.
fn cost(machine: &Machine, survey: &Survey) -> f64 {
    let forbidden = survey.findings.iter().any(|f| !f.allowed);
    let from_home: f64 = machine
        .axes
        .iter()
        .zip(survey.start.iter().zip(machine.home()))
        .map(|(axis, (q, home))| ((q - home) / axis.max_speed).abs())
        .sum();
    // Fraction of a linear axis' range, or rad.
    let beyond = survey.lacks.iter().map(|lack| match (machine.axes[lack.axis].kind, machine.axes[lack.axis].range) {
        (AxisKind::Linear, Some((low, high))) => lack.by.abs() / (high - low),
        _ => lack.by.abs(),
    });
    let beyond = beyond.fold(0.0, f64::max);
    1e9 * f64::from(u8::from(forbidden)) + 1e6 * beyond + 1e3 * survey.attitude_error.0 + from_home * 1e-3
}

/// Maximum excess of each axis at each end of its range.
fn lacks(machine: &Machine, places: &[f64], rows: &[Joints]) -> Vec<Lack> {
    let at = |axis: usize, sense: f64| {
        let beyond = |q: &Joints| machine.axes[axis].outside(q[axis]).map_or(0.0, |limit| sense * (q[axis] - limit));
        let worst = places.iter().zip(rows).max_by(|a, b| beyond(a.1).total_cmp(&beyond(b.1)))?;
        let by = beyond(worst.1);
        (by > 0.0).then_some(Lack { axis, s: *worst.0, by: sense * by, q: *worst.1 })
    };
    (0..machine.axes.len()).flat_map(|axis| [-1.0, 1.0].map(|sense| at(axis, sense))).flatten().collect()
}
