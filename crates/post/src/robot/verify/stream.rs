//! The check of a stream of set-points against the plan.

use super::Judge;
use crate::robot::arm::RobotArm;
use crate::robot::program::{RobotStep, TcpMove};
use crate::robot::stream::{ServoStream, SetPoints};
use crate::robot::weld_values::WeldValues;
use seamwright_machine::Joints;
use seamwright_program::PathRange;

/// Parts of a period at which positions are checked.
const PARTS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// A weld in the text: where it starts, its set-points with the process values of each, and its times at rest.
pub(super) struct StreamedWeld<'a> {
    start: &'a TcpMove,
    stream: ServoStream,
    points: Vec<(&'a [f64; 6], WeldValues)>,
    rest_s: f64,
}

impl<'a> StreamedWeld<'a> {
    /// None if the pass is not streamed, or its welding arc is not switched off.
    pub(super) fn of(steps: &'a [RobotStep], has_arc: bool) -> Option<Self> {
        let first = steps.iter().position(|step| matches!(step, RobotStep::Move(_)))?;
        let RobotStep::Move(start) = &steps[first] else { return None };
        let stream = steps.iter().find_map(|step| match step {
            RobotStep::SetPoints(SetPoints { stream, .. }) => Some(*stream),
            _ => None,
        })?;
        let mut weld = Self { start, stream, points: Vec::new(), rest_s: 0.0 };
        let mut values = WeldValues::default();
        let mut is_off = !has_arc;
        for step in &steps[first + 1..] {
            match step {
                RobotStep::ArcOn(on) => (weld.rest_s, values) = (on.delay_s, on.values),
                RobotStep::Values(now) => values = *now,
                RobotStep::SetPoints(points) => {
                    weld.points.extend(points.positions.iter().map(|positions| (positions, values)));
                }
                RobotStep::ArcOff(off) => {
                    weld.rest_s += off.crater_s;
                    is_off = true;
                    break;
                }
                _ => break,
            }
        }
        is_off.then_some(weld)
    }

    /// Number of set-points before the end is held.
    fn moving(&self) -> usize {
        self.points.len().saturating_sub(self.stream.hold())
    }
}

impl Judge<'_> {
    /// Checks a streamed weld: its time, positions, speeds and process values.
    pub(super) fn check_stream(&mut self, weld: &StreamedWeld) {
        let duration = self.motion.profile.duration();
        let expected = if self.pass.has_arc() { self.motion.arc_on_s() } else { duration };
        let moving = weld.moving();
        self.proof.arc_s = weld.rest_s + moving as f64 * weld.stream.period_s;
        self.proof.time_percent = 100.0 * (self.proof.arc_s / expected - 1.0);
        // The last set-point comes up to a period later than planned.
        self.time_percent = self.time_percent.max(100.0 * weld.stream.period_s / expected);
        let start = self.course.at(0.0);
        self.proof.tip_mm = weld.start.to.point.distance(start.station.pose.point);
        let mut from = start.q;
        for (k, (positions, values)) in weld.points.iter().enumerate() {
            let to = self.joints(positions);
            let begin_s = k as f64 * weld.stream.period_s;
            if k < moving {
                self.interval(&from, &to, begin_s, weld.stream.period_s);
                self.values_at(begin_s + 0.5 * weld.stream.period_s, values);
            } else {
                self.station(&to, duration);
            }
            from = to;
        }
    }

    /// Positions of the machine's axes from those of the arm, degrees.
    fn joints(&self, positions: &[f64; 6]) -> Joints {
        let mut q = Joints::default();
        for (axis, deg) in self.arm.joints.iter().zip(positions) {
            q[*axis] = self.planned.machine.axes[*axis].from_file(*deg);
        }
        q
    }

    /// Tip, torch and axes in a period, and the speed of the tip over it.
    fn interval(&mut self, from: &Joints, to: &Joints, begin_s: f64, period_s: f64) {
        for part in PARTS {
            let mut q = *from;
            for axis in self.arm.joints {
                q[axis] += part * (to[axis] - from[axis]);
            }
            self.station(&q, begin_s + part * period_s);
        }
        let duration = self.motion.profile.duration();
        if begin_s + period_s > duration || self.course.meets_ramp(begin_s, begin_s + period_s) {
            return;
        }
        let machine = self.planned.machine;
        let [way, planned] = [
            [from, to].map(|q| machine.forward(q).point),
            [begin_s, begin_s + period_s].map(|time| self.course.at(time).station.pose.point),
        ]
        .map(|[from, to]| from.distance(to));
        if planned > super::SLOWEST * self.fastest * period_s {
            let percent = 100.0 * (way / planned - 1.0).abs();
            self.proof.speed_inside_percent = self.proof.speed_inside_percent.max(percent);
            self.speed_counted = self.proof.speed_inside_percent;
        }
    }

    /// Tip, torch and axes at positions `q` against the planned path.
    fn station(&mut self, q: &Joints, time: f64) {
        let machine = self.planned.machine;
        let (pose, length) = (RobotArm::pose(machine, q), self.motion.path.length());
        let s = self.motion.profile.at(time.min(self.motion.profile.duration()), &mut 0).s;
        let foot = self.path.foot(pose.point, s, PathRange::up_to(length));
        let asked = self.motion.path.at(foot);
        let there = RobotArm::pose(machine, &asked);
        let proof = &mut self.proof;
        proof.tip_mm = proof.tip_mm.max(pose.point.distance(there.point));
        proof.direction_deg = proof.direction_deg.max(pose.angle_to(&there).to_degrees());
        proof.lag_mm = proof.lag_mm.max((foot - s).abs() * self.path.tip_rate(s));
        self.reaches &= machine.outside(q).is_none();
        for axis in self.arm.joints {
            let off = (q[axis] - asked[axis]).abs().to_degrees();
            if proof.rotary.as_ref().is_none_or(|(most, _)| off > *most) {
                proof.rotary = Some((off, machine.axes[axis].name.clone()));
            }
        }
    }
}
