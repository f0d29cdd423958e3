//! A planned weld as a robot program.

use super::arm::RobotArm;
use super::cutter::{Bounds, Course, Planned};
use super::language::CNT_S;
use super::language::RobotLanguage;
use super::play::{bend, corner_cut};
use super::pose::RobotPose;
use super::program::{ArcEnd, ArcStart, JointTarget, RobotProgram, RobotStep, TcpMove, ThroughPoint};
use super::speeds::{Timed, speeds};
use super::stream::{self, ServoStream};
use super::way::Way;
use super::weld_values::WeldValues;
use crate::error::Error;
use crate::plan::ramps::{ramp_breaks, weave_breaks};
use glam::DQuat;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::WeldMotion;
use seamwright_motion::transfer::TransferMove;
use seamwright_program::{Pass, Program, TorchPath};

/// Speed of lines to the start of a weld and back from its end, mm/s.
const APPROACH_MM_S: f64 = 50.0;
/// Part of the tolerance that lines use.
const USED: f64 = 0.95;
/// Part of the shorter line that a zone takes at most, where the language has any zone.
const ZONE_PART: f64 = 0.4;
/// Parts of the tolerance by which a corner at an arc may leave the tangents' corner and the arc.
const CORNER_PARTS: [f64; 2] = [0.25, 0.25];
/// Step of zones where the language has any, mm.
const ZONE_STEP_MM: f64 = 0.1;

/// Options that convert a weld into a robot program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotOptions {
    /// Maximum distance of the played path from the planned one of the tip, mm.
    pub tolerance_mm: f64,
    /// Maximum deviation of the tip's speed from the planned one inside lines, outside acceleration and deceleration
    /// phases, percent. Passes that weave are exempt.
    pub speed_percent: f64,
    /// Whether arcs take the place of lines where they save poses.
    pub arcs: bool,
    /// Set-points in the place of lines and arcs, in URScript.
    pub stream: Option<ServoStream>,
}

impl Default for RobotOptions {
    fn default() -> Self {
        // The repeatability of welding robots is of the same size.
        Self { tolerance_mm: 0.05, speed_percent: 2.0, arcs: true, stream: None }
    }
}

/// Machine and language for which a program is made.
#[derive(Debug, Clone, Copy)]
struct Target<'a> {
    machine: &'a Machine,
    arm: &'a RobotArm,
    language: RobotLanguage,
}

/// Converts the weld into a robot program for the language of `arm`. `paths` are those of the passes that `motion` was
/// planned of.
///
/// # Errors
/// [`Error::TooFine`], [`Error::BriefBlocks`], [`Error::TurnsAtRest`], [`Error::Slopes`], [`Error::PassEvents`],
/// [`Error::TwoTorches`], [`Error::NoStream`], [`Error::TooManySetPoints`].
pub fn robot_program(
    machine: &Machine,
    language: RobotLanguage,
    program: &Program,
    paths: &[&dyn TorchPath],
    motion: &WeldMotion,
    options: &RobotOptions,
) -> Result<RobotProgram, Error> {
    let arm = &RobotArm::new(machine, language)?;
    if paths.iter().any(|path| path.second(0.0).is_some()) {
        return Err(Error::TwoTorches);
    }
    if let Some(stream) = &options.stream {
        stream::check(language, motion, stream)?;
    }
    let target = Target { machine, arm, language };
    let mut steps = Vec::new();
    for (i, (pass, planned)) in program.passes.iter().zip(&motion.passes).enumerate() {
        check(pass)?;
        steps.push(RobotStep::Pass(pass.name.clone()));
        if i == 0 {
            steps.push(target.joints(&machine.home()));
        }
        let course = Course::new(machine, arm, planned);
        let start = course.at(0.0);
        target.transfer(&motion.transfers[i], &mut steps);
        steps.push(target.line(&start.q, APPROACH_MM_S, 0.0));
        target.weld(pass, &course, options, &mut steps)?;
        let after = &motion.transfers[i + 1];
        if let Some(back) = after.legs.first().filter(|_| after.retracts) {
            steps.push(target.line(back.end(), APPROACH_MM_S, 0.0));
        }
    }
    if let Some(home) = motion.transfers.last() {
        target.transfer(home, &mut steps);
    }
    if language.has_standing_frames(arm) {
        let standing = |pose: &RobotPose, externals: &[f64]| pose.moved(&arm.carried(machine, externals));
        for step in &mut steps {
            if let RobotStep::Move(line) | RobotStep::JointsTo(line) = step {
                *line = line.mapped(standing);
            }
        }
    }
    let frames = Some(language.frames(arm));
    Ok(RobotProgram { title: program.title.clone(), frames, steps })
}

/// Refuses what robot languages do not have.
fn check(pass: &Pass) -> Result<(), Error> {
    if pass.sequence.upslope.is_some() || pass.sequence.downslope.is_some() {
        return Err(Error::Slopes { pass: pass.name.clone() });
    }
    if pass.points.as_ref().is_some_and(|points| !points.events.is_empty()) {
        return Err(Error::PassEvents { pass: pass.name.clone() });
    }
    Ok(())
}

impl Target<'_> {
    fn joints(&self, q: &Joints) -> RobotStep {
        if !self.language.has_joint_targets() {
            return RobotStep::JointsTo(self.line_to(q));
        }
        RobotStep::Joints(JointTarget {
            arm: self.arm.arm_deg(q),
            externals: self.arm.external_positions(self.machine, q),
        })
    }

    fn line(&self, q: &Joints, speed_mm_s: f64, zone_mm: f64) -> RobotStep {
        RobotStep::Move(TcpMove { speed_mm_s, zone_mm, ..self.line_to(q) })
    }

    /// A move to the pose at `q`, without speed and zone.
    fn line_to(&self, q: &Joints) -> TcpMove {
        TcpMove {
            via: None,
            to: RobotArm::pose(self.machine, q),
            externals: self.arm.external_positions(self.machine, q),
            configuration: self.language.configuration(self.machine, self.arm, q),
            speed_mm_s: 0.0,
            zone_mm: 0.0,
        }
    }

    /// The move to a station of a weld.
    fn move_to(&self, end: &Planned, speed_mm_s: f64, zone_mm: f64) -> RobotStep {
        let via = end.via.as_deref().map(|via| match self.language.has_whole_through_points() {
            true => {
                let TcpMove { to, externals, configuration, .. } = self.line_to(&via.q);
                ThroughPoint { pose: to, externals, configuration }
            }
            false => {
                let pose = RobotPose { turn: DQuat::IDENTITY, ..via.station.pose };
                ThroughPoint { pose, externals: Vec::new(), configuration: Vec::new() }
            }
        });
        RobotStep::Move(TcpMove { via, speed_mm_s, zone_mm, ..self.line_to(&end.q) })
    }

    /// The legs between the retract and the approach, as planned.
    fn transfer(&self, transfer: &TransferMove, steps: &mut Vec<RobotStep>) {
        let count = transfer.legs.len().saturating_sub(usize::from(transfer.approaches));
        for leg in transfer.legs.iter().take(count).skip(usize::from(transfer.retracts)) {
            steps.push(match leg.is_rest() {
                true => RobotStep::Wait(self.language.time_s(leg.duration())),
                false => self.joints(leg.end()),
            });
        }
    }

    /// The moves of a weld, with the welding arc.
    fn weld(
        &self,
        pass: &Pass,
        course: &Course,
        options: &RobotOptions,
        steps: &mut Vec<RobotStep>,
    ) -> Result<(), Error> {
        let breaks = breaks(pass, course);
        let (values, moves) = match options.stream {
            Some(stream) => {
                let end = breaks.first().copied().unwrap_or(course.motion.profile.duration());
                (stream::values_between(pass, course, 0.0, end), stream::set_points(pass, course, &breaks, stream))
            }
            None => self.lines(pass, course, &breaks, options)?,
        };
        let sequence = &pass.sequence;
        let gas = |time_s: f64| if self.language.has_gas_and_wire() { self.language.time_s(time_s) } else { 0.0 };
        if pass.has_arc() {
            let preflow_s = gas(sequence.preflow_s.get());
            let delay_s = self.language.time_s(sequence.travel_delay_s.get());
            steps.push(RobotStep::ArcOn(ArcStart { preflow_s, delay_s, values }));
        }
        steps.extend(moves);
        if pass.has_arc() {
            let crater_s = self.language.time_s(sequence.crater_s.get());
            let postflow_s = gas(sequence.postflow_s.get());
            steps.push(RobotStep::ArcOff(ArcEnd { crater_s, postflow_s }));
        }
        Ok(())
    }

    /// The lines and arcs of a weld, with the process values of the first.
    fn lines(
        &self,
        pass: &Pass,
        course: &Course,
        breaks: &[f64],
        options: &RobotOptions,
    ) -> Result<(WeldValues, Vec<RobotStep>), Error> {
        let tolerance_mm = USED * (options.tolerance_mm - 2.0 * self.language.rounding_mm());
        let is_woven = course.motion.path.is_woven();
        let speed = if is_woven { f64::INFINITY } else { 0.01 * options.speed_percent };
        let mut ends =
            course.cut(breaks, &Bounds { tolerance_mm, speed, language: self.language, arcs: options.arcs })?;
        course.mark_stops(&mut ends);
        let ways: Vec<Way> = ends.windows(2).map(|w| w[1].way(&w[0], self.language)).collect();
        let times = ends.windows(2).map(|w| w[1].time - w[0].time);
        let means: Vec<f64> = times.zip(&ways).map(|(time, way)| way.length() / time).collect();
        let lengths = self.lengths(&ways, &self.zones(&ends, &ways, &means, tolerance_mm));
        let timed: Vec<Timed> =
            lengths.iter().zip(&ends[1..]).map(|(mm, end)| Timed { length_mm: *mm, end_s: end.time }).collect();
        let speeds = speeds(&timed, self.language.speed_step_mm_s(), 0.3 * speed.min(0.05));
        let zones = self.zones(&ends, &ways, &speeds, tolerance_mm);
        let values_at = |s: f64| self.language.values(WeldValues::of(pass, s));
        let first = values_at(0.5 * ends[1].s);
        let (mut values, mut steps) = (first, Vec::new());
        for (k, end) in ends.iter().enumerate().skip(1) {
            let now = values_at(0.5 * (ends[k - 1].s + end.s));
            if pass.has_arc() && now != std::mem::replace(&mut values, now) {
                steps.push(RobotStep::Values(now));
            }
            steps.push(self.move_to(end, speeds[k - 1], zones[k - 1]));
        }
        Ok((first, steps))
    }

    /// The zone at the end of each move.
    fn zones(&self, ends: &[Planned], ways: &[Way], speeds: &[f64], tolerance_mm: f64) -> Vec<f64> {
        let mut zones: Vec<f64> = ways
            .windows(2)
            .zip(&ends[1..])
            .zip(speeds)
            .map(|((pair, end), speed)| {
                if end.stops {
                    return 0.0;
                }
                let radius = max_corner_mm(&pair[0], &pair[1], tolerance_mm);
                match self.language {
                    // A whole part of a hundred.
                    RobotLanguage::FanucLs => {
                        let full = CNT_S * speed;
                        0.01 * (100.0 * radius / full).floor().min(100.0) * full
                    }
                    _ => self.language.zone_mm(pair[0].length().min(pair[1].length()), radius),
                }
            })
            .collect();
        zones.push(0.0);
        zones
    }

    /// The way of the tip on each move and its halves of the corners.
    fn lengths(&self, ways: &[Way], zones: &[f64]) -> Vec<f64> {
        let mut lengths: Vec<f64> = ways.iter().map(Way::length).collect();
        for (k, pair) in ways.windows(2).enumerate() {
            let shorter = corner_cut(&pair[0], &pair[1], self.language.blend_shape(), zones[k]);
            lengths[k] -= shorter;
            lengths[k + 1] -= shorter;
        }
        lengths
    }
}

/// The largest zone between two moves. Between lines a corner may leave the programmed point by the tolerance; beside an
/// arc less, and the arc by the sagitta of the zone.
fn max_corner_mm(before: &Way, after: &Way, tolerance_mm: f64) -> f64 {
    let sine = (0.5 * bend(before, after)).sin().max(1e-9);
    let radius_mm = before.radius_mm().min(after.radius_mm());
    if radius_mm.is_infinite() {
        return 2.0 * tolerance_mm / sine;
    }
    let [corner, sagitta] = CORNER_PARTS.map(|part| part * tolerance_mm);
    (2.0 * corner / sine).min((8.0 * radius_mm * sagitta).sqrt())
}

impl RobotLanguage {
    /// The largest zone between lines of which the shorter has `length_mm`, with a radius of at most `max_mm`.
    fn zone_mm(self, length_mm: f64, max_mm: f64) -> f64 {
        let Some(zones) = self.zones_mm() else {
            let step = if length_mm < 1.0 { 0.1 * ZONE_STEP_MM } else { ZONE_STEP_MM };
            return ((ZONE_PART * length_mm).min(max_mm).min(10.0) / step + 1e-9).floor() * step;
        };
        // Where a zone is larger than half of the line the control takes that half.
        let half = 0.5 * length_mm;
        let largest = zones.iter().rev().find(|zone| **zone <= half).or(zones.first()).copied().unwrap_or(0.0);
        let fitting = zones.iter().rev().find(|zone| **zone <= largest && zone.min(half) <= max_mm);
        fitting.copied().unwrap_or(0.0)
    }
}

/// Times at which lines must end: where process values change, and where the tip stops.
fn breaks(pass: &Pass, course: &Course) -> Vec<f64> {
    let mut lengths: Vec<f64> = pass.spans.iter().skip(1).map(|span| span.from_mm.get()).collect();
    lengths.extend(pass.spans.iter().flat_map(ramp_breaks));
    lengths.extend(weave_breaks(pass));
    let mut times: Vec<f64> = lengths.into_iter().map(|s| course.motion.profile.time(s)).collect();
    times.extend(course.stops());
    times.sort_by(f64::total_cmp);
    times
}
