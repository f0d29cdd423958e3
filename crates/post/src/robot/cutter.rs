//! The fewest poses between which lines and arcs keep to the planned motion.

use super::arm::RobotArm;
use super::language::RobotLanguage;
use super::play::Station;
use super::way::Way;
use crate::error::Error;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::PassMotion;

/// Stations checked within a line, and within an arc.
const CHECKS: u32 = 16;
const ARC_CHECKS: u32 = 64;
/// Part of the tolerance that arcs use: corners at their ends leave them by the sagitta of the zone.
const ARC_PART: f64 = 0.7;
/// An arc must be so many times longer than the line in its place: it takes two poses.
const ARC_GAIN: f64 = 2.2;
/// Angles of arcs, rad. ABB wants a degree between their points (RAPID reference, MoveC); by more than a third of a turn
/// rounding moves the middle.
const ARC_SWEEP: [f64; 2] = [0.07, 2.1];
/// Maximum time by which the step of the speed may make an arc early or late, as a way in mm and as a part of the pass.
const ARC_LAG_MM: f64 = 0.15;
const ARC_TIME_PART: f64 = 3e-4;
/// Permitted deviation of the orientation from the planned one within a line, rad.
const MAX_TURN: f64 = 0.002;
/// Permitted lead or lag of the tip within a line, mm.
const MAX_LAG_MM: f64 = 0.3;
/// Permitted deviation of external axes within a line, mm or degrees.
const MAX_EXTERNAL: f64 = 0.2;
/// Part of the permitted deviation of the speed that lines use.
const USED: f64 = 0.7;
/// Way below which the tip stands still, mm.
const STILL_MM: f64 = 1e-6;
/// Minimum duration of a line, s. No maker states one; controls interpolate in 4 to 24 ms and take five cycles of the
/// fastest of them for a line without slowing down.
pub(super) const BRIEFEST_S: f64 = 0.02;

/// Bounds within which lines are chosen.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    /// Maximum distance from the planned path, mm.
    pub(super) tolerance_mm: f64,
    /// Maximum relative deviation of the speed; infinite for passes that weave.
    pub(super) speed: f64,
    /// The language.
    pub(super) language: RobotLanguage,
    /// Whether arcs are tried.
    pub(super) arcs: bool,
}

/// A station of the planned motion.
#[derive(Debug, Clone)]
pub(super) struct Planned {
    pub(super) time: f64,
    pub(super) s: f64,
    pub(super) q: Joints,
    pub(super) station: Station,
    /// True if the tip stops there inside the pass.
    pub(super) stops: bool,
    /// Station through which an arc leads there; `None`: a line does.
    pub(super) via: Option<Box<Planned>>,
}

impl Planned {
    /// The way there from `from`.
    pub(super) fn way(&self, from: &Self, language: RobotLanguage) -> Way {
        let arc = |via: &Self| Way::arc(&from.station, &via.station, &self.station, language.circular_rule());
        let arc = self.via.as_deref().and_then(arc);
        arc.unwrap_or_else(|| Way::line(&from.station, &self.station))
    }
}

/// The motion of a pass by time.
pub(super) struct Course<'a> {
    pub(super) machine: &'a Machine,
    pub(super) arm: &'a RobotArm,
    pub(super) motion: &'a PassMotion,
    /// Times of the acceleration and deceleration phases, s.
    ramps: Vec<[f64; 2]>,
}

impl<'a> Course<'a> {
    pub(super) fn new(machine: &'a Machine, arm: &'a RobotArm, motion: &'a PassMotion) -> Self {
        let profile = &motion.profile;
        let time = |s: f64| profile.time(s);
        let legs = profile.legs();
        let ramps = legs
            .iter()
            .flat_map(|leg| [[time(leg.from), time(leg.run_up_end)], [time(leg.run_down_start), time(leg.to)]]);
        Self { machine, arm, motion, ramps: ramps.collect() }
    }

    pub(super) fn at(&self, time: f64) -> Planned {
        let s = self.motion.profile.at(time, &mut 0).s;
        let q = self.motion.path.at(s);
        let externals = self.arm.external_positions(self.machine, &q);
        let station = Station { pose: RobotArm::pose(self.machine, &q), externals };
        Planned { time, s, q, station, stops: false, via: None }
    }

    /// True if a range of times meets an acceleration or deceleration phase.
    pub(super) fn meets_ramp(&self, from: f64, to: f64) -> bool {
        self.ramps.iter().any(|ramp| from < ramp[1] && to > ramp[0])
    }

    /// Times at which the tip stops inside the pass.
    pub(super) fn stops(&self) -> Vec<f64> {
        let legs = self.motion.profile.legs();
        legs.iter().skip(1).map(|leg| self.motion.profile.time(leg.from)).collect()
    }

    /// Marks the stations at which the tip stops inside the pass.
    pub(super) fn mark_stops(&self, ends: &mut [Planned]) {
        let stops = self.stops();
        for end in ends {
            end.stops = stops.iter().any(|time| (time - end.time).abs() < 1e-9);
        }
    }

    /// The ends of moves, the start of the pass first. Moves end at all `breaks`.
    pub(super) fn cut(&self, breaks: &[f64], bounds: &Bounds) -> Result<Vec<Planned>, Error> {
        let end = self.motion.profile.duration();
        let mut all = vec![self.at(0.0)];
        let mut next_break = breaks.iter().copied().filter(|t| *t > BRIEFEST_S && *t < end - BRIEFEST_S).peekable();
        let mut step = 0.1;
        loop {
            let here = &all[all.len() - 1];
            while next_break.next_if(|t| *t <= here.time + BRIEFEST_S).is_some() {}
            let limit = next_break.peek().copied().unwrap_or(end);
            let line = self.farthest(here, limit, &mut step, bounds);
            let line_s = line.as_ref().map_or(BRIEFEST_S, |line| line.time - here.time);
            let moves = match self.with_arc(here, limit, line_s, bounds) {
                Some(moves) => moves,
                None => vec![line?],
            };
            all.extend(moves);
            if all[all.len() - 1].time >= end {
                return Ok(all);
            }
        }
    }

    /// The longest arc from `here`, with the short lines that it needs at its ends; `None` if lines of `line_s` (s) do as
    /// well.
    fn with_arc(&self, here: &Planned, limit: f64, line_s: f64, bounds: &Bounds) -> Option<Vec<Planned>> {
        if !bounds.arcs {
            return None;
        }
        let Some(short_mm) = bounds.language.arc_ends_mm() else {
            return self.farthest_arc(here, limit, ARC_GAIN * line_s, bounds).map(|arc| vec![arc]);
        };
        let short = |from: &Planned| {
            let ahead = self.at(from.time + 0.5 * BRIEFEST_S).station.pose.point;
            let speed = ahead.distance(from.station.pose.point) / (0.5 * BRIEFEST_S);
            let to = self.at(from.time + (short_mm / speed).max(BRIEFEST_S));
            (to.time < limit && self.is_within(&Way::line(&from.station, &to.station), from, &to, bounds)).then_some(to)
        };
        let first = short(here)?;
        let spare = 1.1 * (first.time - here.time);
        // Two lines and two poses of the arc take the place of lines.
        let arc = self.farthest_arc(&first, limit - spare, (ARC_GAIN + 2.0) * line_s, bounds)?;
        let last = short(&arc)?;
        Some(vec![first, arc, last])
    }

    /// The farthest end of an arc from `here` that takes at least `min_s`, up to the time `limit`.
    fn farthest_arc(&self, here: &Planned, limit: f64, min_s: f64, bounds: &Bounds) -> Option<Planned> {
        let fits = |time: f64| {
            let via = self.at(0.5 * (here.time + time));
            let to = Planned { via: Some(Box::new(via)), ..self.at(time) };
            let way = to.way(here, bounds.language);
            (self.is_arc_timed(&way, time - here.time, bounds) && self.is_within(&way, here, &to, bounds)).then_some(to)
        };
        let mut length = min_s;
        if here.time + length > limit {
            return None;
        }
        let mut good = fits(here.time + length)?;
        let mut bad = limit;
        while good.time < limit {
            length *= 2.0;
            match fits((here.time + length).min(limit)) {
                Some(to) => good = to,
                None => {
                    bad = (here.time + length).min(limit);
                    break;
                }
            }
        }
        while good.time < limit && bad - good.time > 0.02 * (good.time - here.time) {
            let middle = 0.5 * (good.time + bad);
            match fits(middle) {
                Some(to) => good = to,
                None => bad = middle,
            }
        }
        // No brief move is left over.
        let rest = limit - good.time;
        if rest > 0.0 && rest < 3.0 * BRIEFEST_S { fits(limit - 3.0 * BRIEFEST_S) } else { Some(good) }
    }

    /// True if an arc of `time` s is one that controls take, and the steps of its speed keep to the time.
    fn is_arc_timed(&self, way: &Way, time: f64, bounds: &Bounds) -> bool {
        let steps = way.length() / time / bounds.language.speed_step_mm_s();
        let off = if (steps - steps.round()).abs() < 0.02 { 0.02 / steps } else { 0.5 / steps };
        let total = self.motion.profile.duration();
        // On a smaller arc no zone fits, and the control would stop at its ends.
        let min_radius_mm = bounds.language.min_zone_mm().powi(2) / bounds.tolerance_mm;
        way.radius_mm() >= min_radius_mm
            && (ARC_SWEEP[0]..ARC_SWEEP[1]).contains(&way.sweep())
            && off * way.length() <= ARC_LAG_MM
            && off * time <= ARC_TIME_PART * total
    }

    /// The farthest end of a line from `here`, up to the time `limit`; `step` is the duration of the line before.
    fn farthest(&self, here: &Planned, limit: f64, step: &mut f64, bounds: &Bounds) -> Result<Planned, Error> {
        let fits = |time: f64| {
            let to = self.at(time);
            self.is_within(&Way::line(&here.station, &to.station), here, &to, bounds).then_some(to)
        };
        let (mut good, mut bad) = (None, None);
        let mut length = *step;
        while bad.is_none() {
            let time = (here.time + length).min(limit);
            match fits(time) {
                Some(to) if time >= limit => return Ok(to),
                Some(to) => (good, length) = (Some(to), 2.0 * length),
                None if good.is_some() || length < 0.5 * BRIEFEST_S => bad = Some(time),
                None => length *= 0.5,
            }
        }
        let (Some(mut good), Some(mut bad)) = (good, bad) else { return Err(self.too_fine(here, limit)) };
        while bad - good.time > 0.02 * (good.time - here.time) {
            let middle = 0.5 * (good.time + bad);
            match fits(middle) {
                Some(to) => good = to,
                None => bad = middle,
            }
        }
        *step = good.time - here.time;
        if *step < BRIEFEST_S {
            return Err(Error::BriefBlocks { s: here.s, time_s: *step, min_s: BRIEFEST_S });
        }
        // A short rest is shared with this line.
        if limit - good.time < 0.7 * *step {
            return Ok(self.at(0.5 * (here.time + limit)));
        }
        Ok(good)
    }

    fn too_fine(&self, here: &Planned, limit: f64) -> Error {
        let next = self.at((here.time + BRIEFEST_S).min(limit));
        let still = here.station.pose.point.distance(next.station.pose.point) < STILL_MM;
        if still { Error::TurnsAtRest { s: here.s } } else { Error::TooFine { s: here.s } }
    }

    /// True if the way between two stations keeps to the plan.
    fn is_within(&self, way: &Way, from: &Planned, to: &Planned, bounds: &Bounds) -> bool {
        let (length, time) = (way.length(), to.time - from.time);
        if length < STILL_MM {
            return false;
        }
        let is_ramp = self.meets_ramp(from.time, to.time);
        let (checks, used) = if way.is_arc() { (ARC_CHECKS, ARC_PART) } else { (CHECKS, 1.0) };
        let chord = way.chord(1.0 / f64::from(checks));
        let mut last = from.station.pose.point;
        (1..=checks).all(|k| {
            let f = f64::from(k) / f64::from(checks);
            let station = self.at(from.time + f * time).station;
            let point = station.pose.point;
            let part = way.part_of(point);
            let there = way.at(part);
            let gone = std::mem::replace(&mut last, point).distance(point);
            let external = |(x, y): (&f64, &f64)| (x - y).abs() <= MAX_EXTERNAL;
            there.pose.point.distance(point) <= used * bounds.tolerance_mm
                && there.pose.angle_to(&station.pose) <= MAX_TURN
                && there.externals.iter().zip(&station.externals).all(external)
                && (part - f).abs() * length <= MAX_LAG_MM
                && (is_ramp || (gone / chord - 1.0).abs() <= USED * bounds.speed)
        })
    }
}
