//! Verification of a robot program: what was read back is compared with what was ordered step by step, and its play with
//! the planned motion.

mod stream;

use self::stream::StreamedWeld;
use super::arm::RobotArm;
use super::cutter::Course;
use super::language::RobotLanguage;
use super::play::{RobotPlay, Station};
use super::pose::RobotPose;
use super::program::{RobotFrames, RobotProgram, RobotStep, TcpMove};
use super::stream::ServoStream;
use super::weld_values::{NAMES, WeldValues};
use crate::verify::{PassVerification, Permitted, TIME_PERCENT, Verification};
use seamwright_machine::{Machine, Target};
use seamwright_message::{Message, Unit};
use seamwright_motion::{PassMotion, TipPath, WeldMotion};
use seamwright_program::{Pass, PathRange, Program};
use std::borrow::Cow;

/// Plan against which a robot program is verified.
#[derive(Debug, Clone, Copy)]
pub struct PlannedRobot<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// The language.
    pub language: RobotLanguage,
    /// The program that was posted.
    pub program: &'a Program,
    /// Its motion.
    pub motion: &'a WeldMotion,
    /// Maximum distance of the played path from the planned one of the tip, mm.
    pub tolerance_mm: f64,
    /// Maximum deviation of the tip's speed, percent.
    pub speed_percent: f64,
}

/// Differences of positions (mm, degrees) and times (s) from the order beyond which text is wrong.
pub(super) const OTHER: f64 = 2e-3;
/// Difference of orientations, rad.
const OTHER_TURN: f64 = 2e-5;
/// Stations checked in a part of the play, its end among them.
const CHECKS: u32 = 8;
/// The same in an arc.
const ARC_CHECKS: u32 = 64;
/// Permitted deviation of the torch's direction from the planned one, degrees.
const DIRECTION_DEG: f64 = 0.3;
/// Slowest planned speed that is compared, as a part of the maximum of the pass.
const SLOWEST: f64 = 0.2;

/// Verifies the program read back from the text against `asked`, from which it was written, and the plan.
///
/// # Errors
/// Descriptions of all faults.
pub fn verify_robot(
    asked: &RobotProgram,
    told: &RobotProgram,
    planned: PlannedRobot,
) -> Result<Verification, Vec<Message>> {
    let arm = RobotArm::new(planned.machine, planned.language).map_err(|e| vec![e.message()])?;
    let rounding = same(asked, told).map_err(|wrong| vec![wrong])?;
    let steps = on_work(&told.steps, &arm, planned.machine, planned.language);
    let mut wrong = Vec::new();
    let (mut passes, mut moves) = (Vec::new(), 0);
    for (i, steps) in passes_of(&steps).into_iter().enumerate() {
        let (Some(pass), Some(motion)) = (planned.program.passes.get(i), planned.motion.passes.get(i)) else { break };
        let judge = Judge::new(planned, &arm, pass, motion);
        let checked = judge.check(steps);
        wrong.extend(checked.complaints(&planned, i + 1));
        moves += steps.iter().map(moves_of).sum::<usize>();
        passes.push(checked.proof);
    }
    if passes.len() != planned.program.passes.len() {
        let message = Message::new("post-block-count").count("found", passes.len());
        wrong.push(message.count("planned", planned.program.passes.len()));
    }
    if wrong.is_empty() { Ok(Verification { moves, rounding, passes }) } else { Err(wrong) }
}

/// The steps with their poses in the frame of the work, on which lines and arcs are.
pub(super) fn on_work<'a>(
    steps: &'a [RobotStep],
    arm: &RobotArm,
    machine: &Machine,
    language: RobotLanguage,
) -> Cow<'a, [RobotStep]> {
    if !language.has_standing_frames(arm) {
        return Cow::Borrowed(steps);
    }
    let back = |pose: &RobotPose, externals: &[f64]| pose.moved(&arm.carried(machine, externals).inverse());
    let moved = |step: &RobotStep| match step {
        RobotStep::Move(line) => RobotStep::Move(line.mapped(back)),
        step => step.clone(),
    };
    Cow::Owned(steps.iter().map(moved).collect())
}

/// Number of moves of a step: a set-point is one.
fn moves_of(step: &RobotStep) -> usize {
    match step {
        RobotStep::SetPoints(points) => points.positions.len(),
        step => usize::from(matches!(step, RobotStep::Move(_) | RobotStep::Joints(_) | RobotStep::JointsTo(_))),
    }
}

/// The steps of each pass.
pub(super) fn passes_of(steps: &[RobotStep]) -> Vec<&[RobotStep]> {
    let starts: Vec<usize> = (0..steps.len()).filter(|i| matches!(steps[*i], RobotStep::Pass(_))).collect();
    let ends = starts.iter().skip(1).copied().chain([steps.len()]);
    starts.iter().zip(ends).map(|(from, to)| &steps[from + 1..to]).collect()
}

/// Compares the steps with those ordered and returns the maximum difference of a position, mm or degrees. Errors: a
/// description of the first difference.
fn same(asked: &RobotProgram, told: &RobotProgram) -> Result<f64, Message> {
    let mut rounding = 0.0f64;
    if let (Some(a), Some(t)) = (&asked.frames, &told.frames) {
        rounding = same_frames(a, t)?;
    }
    if asked.steps.len() != told.steps.len() {
        let message = Message::new("post-block-count").count("found", told.steps.len());
        return Err(message.count("planned", asked.steps.len()));
    }
    for (k, (a, t)) in asked.steps.iter().zip(&told.steps).enumerate() {
        let off = same_step(a, t).filter(|off| *off <= OTHER);
        let differs = || Message::new("post-robot-step").text("step", (k + 1).to_string());
        rounding = rounding.max(off.ok_or_else(differs)?);
    }
    Ok(rounding)
}

fn same_frames(a: &RobotFrames, t: &RobotFrames) -> Result<f64, Message> {
    let off = [(a.tool, t.tool), (a.work, t.work)].map(|(a, t)| same_pose(&a, &t));
    match off {
        [Some(tool), Some(work)] if tool.max(work) <= OTHER => Ok(tool.max(work)),
        _ => Err(Message::new("post-robot-frames")),
    }
}

/// Distance of two poses of the same orientation.
pub(super) fn same_pose(a: &RobotPose, t: &RobotPose) -> Option<f64> {
    (a.angle_to(t) <= OTHER_TURN).then(|| a.point.distance(t.point))
}

/// Maximum difference of two steps of the same kind.
fn same_step(a: &RobotStep, t: &RobotStep) -> Option<f64> {
    let most = |a: &[f64], t: &[f64]| {
        let off = a.iter().zip(t).map(|(a, t)| (a - t).abs()).fold(0.0, f64::max);
        (a.len() == t.len()).then_some(off)
    };
    match (a, t) {
        (RobotStep::Pass(_), RobotStep::Pass(_)) => Some(0.0),
        (RobotStep::Joints(a), RobotStep::Joints(t)) => {
            Some(most(&a.arm, &t.arm)?.max(most(&a.externals, &t.externals)?))
        }
        (RobotStep::Move(a), RobotStep::Move(t)) | (RobotStep::JointsTo(a), RobotStep::JointsTo(t)) => {
            let values = [(a.speed_mm_s, t.speed_mm_s), (a.zone_mm, t.zone_mm)];
            let known = t.configuration == a.configuration && values.iter().all(|(a, t)| (a - t).abs() < OTHER);
            let off = same_pose(&a.to, &t.to)?.max(most(&a.externals, &t.externals)?);
            let via = match (&a.via, &t.via) {
                (None, None) => 0.0,
                (Some(a), Some(t)) if a.configuration == t.configuration => {
                    same_pose(&a.pose, &t.pose)?.max(most(&a.externals, &t.externals)?)
                }
                _ => return None,
            };
            known.then_some(off.max(via))
        }
        (RobotStep::SetPoints(a), RobotStep::SetPoints(t)) => {
            let of = |stream: &ServoStream| [stream.period_s, stream.lookahead_s, stream.gain];
            let settings = most(&of(&a.stream), &of(&t.stream)).filter(|off| *off < 1e-9)?;
            (a.positions.len() == t.positions.len()).then_some(())?;
            let pairs = a.positions.iter().zip(&t.positions);
            Some(pairs.filter_map(|(a, t)| most(a, t)).fold(settings, f64::max))
        }
        (RobotStep::ArcOn(a), RobotStep::ArcOn(t)) => {
            let times = most(&[a.preflow_s, a.delay_s], &[t.preflow_s, t.delay_s])?;
            Some(times.max(most(&a.values.all(), &t.values.all())?))
        }
        (RobotStep::ArcOff(a), RobotStep::ArcOff(t)) => most(&[a.crater_s, a.postflow_s], &[t.crater_s, t.postflow_s]),
        (RobotStep::Values(a), RobotStep::Values(t)) => most(&a.all(), &t.all()),
        (RobotStep::Wait(a), RobotStep::Wait(t)) => Some((a - t).abs()),
        _ => None,
    }
}

/// The play of a pass beside its plan.
struct Judge<'a> {
    planned: PlannedRobot<'a>,
    arm: &'a RobotArm,
    pass: &'a Pass,
    motion: &'a PassMotion,
    course: Course<'a>,
    path: TipPath<'a>,
    fastest: f64,
    proof: PassVerification,
    /// Maximum speed deviation that counts, percent, and whether all positions can be reached.
    speed_counted: f64,
    reaches: bool,
    /// Permitted deviation of the time, percent.
    time_percent: f64,
}

/// A weld in the text: its lines, its times at rest and the values of each line.
struct Weld<'a> {
    start: Station,
    lines: Vec<&'a TcpMove>,
    values: Vec<WeldValues>,
    rest_s: f64,
}

impl<'a> Judge<'a> {
    fn new(planned: PlannedRobot<'a>, arm: &'a RobotArm, pass: &'a Pass, motion: &'a PassMotion) -> Self {
        let machine = planned.machine;
        Self {
            planned,
            arm,
            pass,
            motion,
            course: Course::new(machine, arm, motion),
            path: motion.tip_path(machine),
            fastest: motion.tip_band(machine).1,
            proof: PassVerification { name: pass.name.clone(), ..PassVerification::default() },
            speed_counted: 0.0,
            reaches: true,
            time_percent: TIME_PERCENT,
        }
    }

    fn check(mut self, steps: &[RobotStep]) -> Self {
        if let Some(weld) = StreamedWeld::of(steps, self.pass.has_arc()) {
            self.check_stream(&weld);
            return self;
        }
        let Some(weld) = self.weld(steps) else {
            self.proof.time_percent = f64::NAN;
            return self;
        };
        let play = RobotPlay::new(&weld.start, &weld.lines, self.planned.language);
        let expected = if self.pass.has_arc() { self.motion.arc_on_s() } else { self.motion.profile.duration() };
        self.proof.arc_s = weld.rest_s + play.seconds;
        self.proof.time_percent = 100.0 * (self.proof.arc_s / expected - 1.0);
        self.positions(&play);
        self.speeds(&play, weld.lines.len());
        self.values(&play, &weld.values);
        self
    }

    /// The lines between arc start and arc end; without an arc, all lines behind the first up to the retract.
    fn weld<'b>(&self, steps: &'b [RobotStep]) -> Option<Weld<'b>> {
        let has_arc = self.pass.has_arc();
        let first = steps.iter().position(|step| matches!(step, RobotStep::Move(_)))?;
        let RobotStep::Move(start) = &steps[first] else { return None };
        let start = Station { pose: start.to, externals: start.externals.clone() };
        let mut weld = Weld { start, lines: Vec::new(), values: Vec::new(), rest_s: 0.0 };
        let mut values = WeldValues::default();
        let mut ended = !has_arc;
        for step in &steps[first + 1..] {
            match step {
                RobotStep::ArcOn(on) => (weld.rest_s, values) = (on.delay_s, on.values),
                RobotStep::ArcOff(off) => {
                    weld.rest_s += off.crater_s;
                    ended = true;
                    break;
                }
                RobotStep::Values(now) => values = *now,
                RobotStep::Move(line) => {
                    weld.lines.push(line);
                    weld.values.push(values);
                }
                _ => break,
            }
        }
        if !has_arc && weld.lines.len() > 1 {
            // The last line goes back from the end.
            let end = self.course.at(self.motion.profile.duration()).station.pose.point;
            let last = weld.lines[weld.lines.len() - 1].to.point;
            if last.distance(end) > self.planned.tolerance_mm + 1.0 {
                weld.lines.pop();
            }
        }
        (ended && !weld.lines.is_empty()).then_some(weld)
    }

    /// Tip, torch and axes against the planned path.
    fn positions(&mut self, play: &RobotPlay) {
        let machine = self.planned.machine;
        let length = self.motion.path.length();
        let (mut cursor, mut near) = (0, self.course.at(0.0).q);
        for piece in &play.pieces {
            let checks = if piece.is_arc() { ARC_CHECKS } else { CHECKS };
            for k in 0..=checks {
                let f = f64::from(k) / f64::from(checks);
                let station = piece.at(f);
                let time = (piece.begin_s + f * piece.seconds).clamp(0.0, self.motion.profile.duration());
                let s = self.motion.profile.at(time, &mut cursor).s;
                let foot = self.path.foot(station.pose.point, s, PathRange::up_to(length));
                let asked = self.motion.path.at(foot);
                let there = RobotArm::pose(machine, &asked);
                let proof = &mut self.proof;
                proof.tip_mm = proof.tip_mm.max(station.pose.point.distance(there.point));
                proof.direction_deg = proof.direction_deg.max(station.pose.angle_to(&there).to_degrees());
                proof.lag_mm = proof.lag_mm.max((foot - s).abs() * self.path.tip_rate(s));
                self.axes(&station, &asked, &mut near);
            }
        }
    }

    /// The arm's axes that reach a station, against the planned ones.
    fn axes(&mut self, station: &Station, asked: &seamwright_machine::Joints, near: &mut seamwright_machine::Joints) {
        let machine = self.planned.machine;
        let mut pose = machine.forward(asked);
        // The torch's direction is fixed in the tool frame.
        let turned = station.pose.turn * RobotArm::pose(machine, asked).turn.inverse();
        (pose.point, pose.direction) = (station.pose.point, (turned * pose.direction).normalize());
        *near = *asked;
        for (external, position) in self.arm.externals.iter().zip(&station.externals) {
            near[external.axis] = machine.axes[external.axis].from_file(*position);
        }
        let across = Some(RobotArm::across(&station.pose, pose.direction));
        let Ok(solution) = machine.inverse_near(Target { across, ..Target::new(pose, None) }, near) else {
            self.reaches = false;
            return;
        };
        self.reaches &= machine.outside(&solution.joints).is_none();
        for (i, axis) in machine.axes.iter().enumerate() {
            let worst = match axis.kind {
                seamwright_machine::AxisKind::Linear => &mut self.proof.linear,
                seamwright_machine::AxisKind::Rotary => &mut self.proof.rotary,
            };
            let off = (axis.to_file(solution.joints[i]) - axis.to_file(asked[i])).abs();
            if worst.as_ref().is_none_or(|(most, _)| off > *most) {
                *worst = Some((off, axis.name.clone()));
            }
        }
    }

    /// Mean and local speed of the tip against the plan, outside acceleration and deceleration phases.
    fn speeds(&mut self, play: &RobotPlay, lines: usize) {
        // A line that meets an acceleration phase has its mean speed throughout.
        let mut spans = vec![[f64::INFINITY, 0.0f64]; lines];
        for piece in &play.pieces {
            let span = &mut spans[piece.line];
            *span = [span[0].min(piece.begin_s), span[1].max(piece.begin_s + piece.seconds)];
        }
        // Times of the text are off by its permitted deviation.
        let margin = 1e-3 * play.seconds;
        let meets = |[from, to]: &[f64; 2]| self.course.meets_ramp(from - margin, to + margin);
        let is_ramp: Vec<bool> = spans.iter().map(meets).collect();
        for piece in &play.pieces {
            let next = is_ramp.get(piece.line + 1).copied().unwrap_or(true);
            if is_ramp[piece.line] || next || piece.seconds < 1e-3 {
                continue;
            }
            let mut last = piece.at(0.0).pose.point;
            for k in 1..=4u32 {
                let f = f64::from(k) / 4.0;
                let point = piece.at(f).pose.point;
                let way = std::mem::replace(&mut last, point).distance(point);
                let [from, to] =
                    [f - 0.25, f].map(|f| self.course.at(piece.begin_s + f * piece.seconds).station.pose.point);
                let planned = from.distance(to);
                if planned > SLOWEST * self.fastest * 0.25 * piece.seconds {
                    let percent = 100.0 * (way / planned - 1.0).abs();
                    self.proof.speed_inside_percent = self.proof.speed_inside_percent.max(percent);
                }
            }
        }
        if !self.motion.path.is_woven() {
            self.speed_counted = self.proof.speed_inside_percent;
        }
    }

    /// Process values of the lines against those of the pass.
    fn values(&mut self, play: &RobotPlay, values: &[WeldValues]) {
        for piece in &play.pieces {
            self.values_at(piece.begin_s + 0.5 * piece.seconds, &values[piece.line]);
        }
    }

    /// Process values of the text at a time against those of the pass.
    fn values_at(&mut self, time: f64, told: &WeldValues) {
        if !self.pass.has_arc() {
            return;
        }
        let s = self.motion.profile.at(time.min(self.motion.profile.duration()), &mut 0).s;
        let asked = WeldValues::of(self.pass, s).all();
        let count = if self.planned.language.has_gas_and_wire() { 3 } else { 2 };
        for ((name, told), asked) in NAMES.iter().zip(told.all()).zip(asked).take(count) {
            let greatest = self.pass.process_range(name).map_or(0.0, |range| range.1);
            let percent = if greatest > 0.0 { 100.0 * (told - asked).abs() / greatest } else { 0.0 };
            if greatest > 0.0 && self.proof.process.as_ref().is_none_or(|(most, _)| percent > *most) {
                self.proof.process = Some((percent, (*name).to_owned()));
            }
        }
    }

    /// Deviation of a current that the decimals of the language make, percent of the maximum.
    fn rounding_percent(&self) -> f64 {
        let greatest = self.pass.process_range(NAMES[0]).map_or(0.0, |range| range.1);
        if greatest > 0.0 { 50.0 * self.planned.language.current_step_a() / greatest } else { 0.0 }
    }

    fn complaints(&self, planned: &PlannedRobot, number: usize) -> Vec<Message> {
        let permitted = Permitted {
            tip_mm: planned.tolerance_mm,
            time_percent: self.time_percent,
            rounding_percent: self.rounding_percent(),
        };
        let mut wrong = self.proof.complaints_within(&permitted, number);
        // Speeds are programmed in steps.
        let step = 50.0 * planned.language.speed_step_mm_s() / self.fastest;
        let max = planned.speed_percent + step;
        let mut complain = |fault: Message| wrong.push(crate::verify::in_pass(number, &self.pass.name, fault));
        if self.speed_counted > max {
            let message = Message::new("post-speed-off").quantity("deviation", self.speed_counted, Unit::Percent, 2);
            complain(message.value("max", max, Unit::Percent));
        }
        if self.proof.direction_deg > DIRECTION_DEG {
            let message =
                Message::new("post-robot-direction").quantity("deviation", self.proof.direction_deg, Unit::Deg, 3);
            complain(message.value("max", DIRECTION_DEG, Unit::Deg));
        }
        if !self.reaches {
            complain(Message::new("post-robot-reach"));
        }
        wrong
    }
}
