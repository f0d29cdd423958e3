//! The fewest poses between which straight lines keep to the planned motion.

use super::arm::RobotArm;
use super::play::Station;
use crate::error::Error;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::PassMotion;

/// Stations checked within a line.
const CHECKS: u32 = 16;
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
        Planned { time, s, q, station, stops: false }
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

    /// The ends of lines, the start of the pass first. Lines end at all `breaks`.
    pub(super) fn cut(&self, breaks: &[f64], bounds: &Bounds) -> Result<Vec<Planned>, Error> {
        let end = self.motion.profile.duration();
        let mut all = vec![self.at(0.0)];
        let mut next_break = breaks.iter().copied().filter(|t| *t > BRIEFEST_S && *t < end - BRIEFEST_S).peekable();
        let mut step = 0.1;
        loop {
            let here = &all[all.len() - 1];
            while next_break.next_if(|t| *t <= here.time + BRIEFEST_S).is_some() {}
            let limit = next_break.peek().copied().unwrap_or(end);
            let to = self.farthest(here, limit, &mut step, bounds)?;
            let is_last = to.time >= end;
            all.push(to);
            if is_last {
                return Ok(all);
            }
        }
    }

    /// The farthest end of a line from `here`, up to the time `limit`; `step` is the duration of the line before.
    fn farthest(&self, here: &Planned, limit: f64, step: &mut f64, bounds: &Bounds) -> Result<Planned, Error> {
        let fits = |time: f64| {
            let to = self.at(time);
            self.is_within(here, &to, bounds).then_some(to)
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

    /// True if the straight line between two stations keeps to the plan.
    fn is_within(&self, from: &Planned, to: &Planned, bounds: &Bounds) -> bool {
        let (a, b) = (&from.station, &to.station);
        let chord = b.pose.point - a.pose.point;
        let (length, time) = (chord.length(), to.time - from.time);
        if length < STILL_MM {
            return false;
        }
        let is_ramp = self.meets_ramp(from.time, to.time);
        let mut last = a.pose.point;
        (1..=CHECKS).all(|k| {
            let f = f64::from(k) / f64::from(CHECKS);
            let station = self.at(from.time + f * time).station;
            let point = station.pose.point;
            let part = ((point - a.pose.point).dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
            let there = a.towards(b, part);
            let way = std::mem::replace(&mut last, point).distance(point) * f64::from(CHECKS);
            let external = |(x, y): (&f64, &f64)| (x - y).abs() <= MAX_EXTERNAL;
            there.pose.point.distance(point) <= bounds.tolerance_mm
                && there.pose.angle_to(&station.pose) <= MAX_TURN
                && there.externals.iter().zip(&station.externals).all(external)
                && (part - f).abs() * length <= MAX_LAG_MM
                && (is_ramp || (way / length - 1.0).abs() <= USED * bounds.speed)
        })
    }
}
