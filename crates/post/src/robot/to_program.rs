//! A robot program as a weld program of points.

use super::arm::RobotArm;
use super::language::RobotLanguage;
use super::play::{RobotPlay, Station};
use super::pose::RobotPose;
use super::program::{ArcEnd, ArcStart, RobotFrames, RobotProgram, RobotStep, TcpMove};
use super::verify::{OTHER, on_work, passes_of, same_pose};
use super::weld_values::{NAMES, WeldValues};
use crate::error::Error;
use glam::DVec3;
use seamwright_document::{Finite, NonNegative, Point, Positive};
use seamwright_machine::Machine;
use seamwright_program::{
    Along, AtCorner, OnLimit, POSE_COLUMNS, Pass, PointSpan, Points, Program, SPEED_COLUMN, Sequence,
};

/// Machine and options of a conversion.
#[derive(Debug, Clone, Copy)]
pub struct RobotImport<'a> {
    /// The machine that welds the program.
    pub machine: &'a Machine,
    /// Its name in the program.
    pub machine_name: &'a str,
    /// The language that was read.
    pub language: RobotLanguage,
    /// Width of corners without a stop, mm.
    pub blend_mm: Positive,
}

/// A robot program as a weld program.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedRobot {
    /// The program.
    pub program: Program,
    /// Number of moves.
    pub moves: usize,
    /// Time of the moves by the control's rule, s.
    pub seconds: f64,
}

/// Converts a robot program into a program of points: torch tip and direction in the work frame at each move. A pass has
/// the moves of a weld from its arc start to its arc end, or all moves of a pass without a welding arc. The rotation about
/// the torch, the external axes and the transfer moves are left to the planner.
///
/// # Errors
/// [`Error::Nothing`] without moves, [`Error::StreamRead`] for a stream of set-points, [`Error::OtherFrames`] if the text has other frames than the machine, and those of
/// [`RobotArm::new`].
pub fn robot_to_program(read: &RobotProgram, import: &RobotImport) -> Result<ImportedRobot, Error> {
    let RobotImport { machine, machine_name, language, .. } = *import;
    let arm = RobotArm::new(machine, language)?;
    if read.has_stream() {
        return Err(Error::StreamRead);
    }
    if let Some(frames) = &read.frames {
        check_frames(frames, &language.frames(&arm), machine)?;
    }
    let home = machine.home();
    let local = RobotArm::pose(machine, &home).turn.inverse() * machine.forward(&home).direction;
    let steps = on_work(&read.steps, &arm, machine, language);
    let names = steps.iter().filter_map(|step| if let RobotStep::Pass(name) = step { Some(name) } else { None });
    let (mut moves, mut seconds) = (0, 0.0);
    let passes = names.zip(passes_of(&steps)).filter_map(|(name, steps)| {
        let weld = Weld::of(steps)?;
        let points = weld.points(local);
        moves += weld.moves.len();
        seconds += weld.seconds(language);
        let (name, corner) = (name.clone(), AtCorner::BlendMm(import.blend_mm));
        let sequence = weld.sequence();
        Some(Pass { name, on_limit: OnLimit::Slow, corner, sequence, points: Some(points), ..Pass::default() })
    });
    let passes: Vec<Pass> = passes.collect();
    if passes.is_empty() {
        return Err(Error::Nothing);
    }
    let (title, machine) = (read.title.clone(), machine_name.to_owned());
    Ok(ImportedRobot { program: Program { title, machine, passes, ..Program::default() }, moves, seconds })
}

/// Refuses frames of tool and work that are not the machine's.
fn check_frames(read: &RobotFrames, own: &RobotFrames, machine: &Machine) -> Result<(), Error> {
    for (frame, a, b) in [("tool", read.tool, own.tool), ("work", read.work, own.work)] {
        if same_pose(&a, &b).is_none_or(|off| off > OTHER) {
            return Err(Error::OtherFrames { machine: machine.name.clone(), frame });
        }
    }
    Ok(())
}

/// The moves of a pass from its start on, with the values of each.
struct Weld<'a> {
    start: &'a TcpMove,
    moves: Vec<(&'a TcpMove, WeldValues)>,
    arc: Option<(ArcStart, ArcEnd)>,
}

impl<'a> Weld<'a> {
    /// None without a move.
    fn of(steps: &'a [RobotStep]) -> Option<Self> {
        let on = steps.iter().position(|step| matches!(step, RobotStep::ArcOn(_)));
        let place = |step: &'a RobotStep| if let RobotStep::Move(step) = step { Some(step) } else { None };
        let (start, from) = match on {
            Some(on) => (steps[..on].iter().rev().find_map(place)?, on),
            None => {
                let first = steps.iter().position(|step| matches!(step, RobotStep::Move(_)))?;
                (place(&steps[first])?, first + 1)
            }
        };
        let mut weld = Self { start, moves: Vec::new(), arc: None };
        let mut values = WeldValues::default();
        for step in &steps[from..] {
            match step {
                RobotStep::ArcOn(start) => {
                    values = start.values;
                    weld.arc = Some((*start, ArcEnd { crater_s: 0.0, postflow_s: 0.0 }));
                }
                RobotStep::Values(now) => values = *now,
                RobotStep::Move(step) => weld.moves.push((step, values)),
                RobotStep::ArcOff(end) => {
                    weld.arc = weld.arc.map(|(start, _)| (start, *end));
                    break;
                }
                _ => {}
            }
        }
        (!weld.moves.is_empty()).then_some(weld)
    }

    /// Time of the moves as the control plays them, s.
    fn seconds(&self, language: RobotLanguage) -> f64 {
        let start = Station { pose: self.start.to, externals: self.start.externals.clone() };
        let moves: Vec<&TcpMove> = self.moves.iter().map(|(step, _)| *step).collect();
        RobotPlay::new(&start, &moves, language).seconds
    }

    fn sequence(&self) -> Sequence {
        let Some((start, end)) = self.arc else { return Sequence::default() };
        let time = |time_s: f64| NonNegative::new(time_s).unwrap_or_default();
        Sequence {
            preflow_s: time(start.preflow_s),
            travel_delay_s: time(start.delay_s),
            crater_s: time(end.crater_s),
            postflow_s: time(end.postflow_s),
            ..Sequence::default()
        }
    }

    /// Points of tip and direction; `local` is the torch's direction in the tool frame.
    fn points(&self, local: DVec3) -> Points {
        let used: Vec<usize> =
            (0..NAMES.len()).filter(|i| self.moves.iter().any(|(_, values)| values.all()[*i] != 0.0)).collect();
        let named: Vec<String> = used.iter().map(|i| NAMES[*i].to_owned()).collect();
        let row = |pose: &RobotPose, values: &WeldValues, speed_mm_s: f64| {
            let process = used.iter().map(|i| values.all()[*i]);
            let place = pose.point.to_array().into_iter().chain((pose.turn * local).to_array());
            // Numbers of a text are finite: they were read so.
            place.chain(process).chain([speed_mm_s]).map(|v| Finite::new(v).unwrap_or_default()).collect::<Vec<_>>()
        };
        let mut spans: Vec<PointSpan> = Vec::new();
        for (step, values) in &self.moves {
            let via_mm = step.via.as_ref().and_then(|via| Point::new(via.pose.point));
            let (along, stops) = (if via_mm.is_some() { Along::Arc } else { Along::Line }, step.zone_mm <= 0.0);
            let points = vec![row(&step.to, values, step.speed_mm_s)];
            let span = PointSpan { along, stops, via_mm, normal: None, speeds: Vec::new(), points };
            match spans.last_mut().filter(|last| along == Along::Line && last.along == along && last.stops == stops) {
                Some(last) => last.points.extend(span.points),
                None => spans.push(span),
            }
        }
        let mut columns = POSE_COLUMNS.map(str::to_owned).to_vec();
        columns.extend(named.iter().cloned());
        columns.push(SPEED_COLUMN.to_owned());
        let start = row(&self.start.to, &self.moves[0].1, 0.0);
        Points { columns, arc: self.arc.is_some(), stepped: named, start, events: Vec::new(), spans }
    }
}
