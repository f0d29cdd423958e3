//! A planned weld as a part program.
//!
//! **Blocks** are cut greedily: each is as long as tolerance, timing and torch attitude allow.
//!
//! - Lines and arcs: the longer of the two is used. The arc passes through the start, the planned position at half the
//!   time, and the end.
//! - PMAC: cubics with the plan's speeds at their ends, or splines through the plan from a tridiagonal system. Times
//!   are halved until the result is within tolerance.
//! - Sinumerik's POLY: cubics with the path's directions at their ends. The parameter follows the travel of all axes
//!   (`polynomial.rs`).
//!
//! LinuxCNC raises feeds below 0.1 per minute without a message, and counts only X, Y and Z while they move. Linear
//! motion that is too small for this is left to the next block.

pub(crate) mod arcs;
mod axis_positions;
mod block;
mod block_cutter;
mod course;
mod deviation;
mod options;
pub(crate) mod ramps;
mod rows;
mod spline;
mod steps;

pub use block::{Block, Linearisation, Shape, Speeds};
pub use block_cutter::linearise;
use options::ROUNDING;
pub use options::{BRIEFEST_S, Interpolation, Options};
use steps::{PlannedPass, Steps, Transfers};

use crate::control::{Code, Control, Dialect};
use crate::error::Error;
use crate::part_program::{Event, Level, PartProgram};
use crate::points::{ends, event_of, is_posted_as_it_stands};
use arcs::Arcs;
use axis_positions::Neighbours;
use block_cutter::{Cutting, HELD_BACK, Kind, cut};
use course::Course;
use ramps::{ramp_breaks, weave_breaks};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, Program, TorchPath};

/// Part of the tolerance that controls without a tolerance for blends, and rounding to decimals, may use.
const SPARED: f64 = 0.05;
/// Longest time of PMAC's cubics, s.
const LONGEST_CUBIC_S: f64 = 4.095;

/// Converts the weld into a part program for `control`. Blocks keep to `options.tolerance_mm` and to the plan's timing,
/// and outputs are switched with the motion. Transfer moves are as planned; their straight lines in axis space are
/// those of rapid moves at joint level. `paths` are those of the passes that `motion` was planned of.
///
/// Rows are rounded to the six decimals that are written, so they equal the values that the control reads. At joint
/// level the control must move axes as they are; tip level needs kinematics in the control that match the machine.
///
/// # Errors
/// [`Error::TooFine`]; [`Error::NoTip`]; [`Error::TipPasses`] if the control cannot change to its axes between passes;
/// [`Error::TwoTorches`] at tip level.
pub fn part_program(
    machine: &Machine,
    control: &Control,
    program: &Program,
    paths: &[&dyn TorchPath],
    motion: &WeldMotion,
    options: &Options,
) -> Result<PartProgram, Error> {
    let second = paths.iter().any(|path| path.second(0.0).is_some());
    if options.level == Level::Tip {
        check_tip(control, motion, second)?;
    }
    let mut steps = Steps::new(machine, control, program, options);
    for (i, (pass, planned)) in program.passes.iter().zip(&motion.passes).enumerate() {
        if is_posted_as_it_stands(control, pass) {
            let next =
                program.passes.get(i + 1).filter(|next| motion.transfers[i + 1].legs.is_empty() && goes_on(pass, next));
            let way: Vec<Joints> = motion.transfers[i].legs.iter().map(|leg| *leg.end()).collect();
            steps.begin_pass(&pass.name);
            steps.stands(
                pass,
                &way,
                Neighbours { first: i == 0, restarts: restarts(program), burns_on: next.is_some() },
            );
            continue;
        }
        let part = PlannedPass {
            pass,
            motion: planned,
            course: Course::new(control, pass),
            events: point_events(pass, paths[i]),
        };
        let cut = blocks(machine, control, &part, options, second)?;
        steps.begin_pass(&pass.name);
        steps.remarks(&pass.name, planned, &cut, options);
        if i > 0 {
            steps.air(&motion.transfers[i]);
        }
        steps.pass(&cut, part, Transfers { before: &motion.transfers[i], after: &motion.transfers[i + 1] }, i == 0);
    }
    Ok(steps.program)
}

/// A program of axis positions as a part program, without its planned motion: the way from one pass to the next is a
/// straight one. `None` if a pass has to be planned for this control.
pub fn points_part_program(machine: &Machine, control: &Control, program: &Program) -> Option<PartProgram> {
    let mut steps = Steps::new(machine, control, program, &Options::default());
    let mut here: Option<Joints> = None;
    for (i, pass) in program.passes.iter().enumerate() {
        if !is_posted_as_it_stands(control, pass) {
            return None;
        }
        let (start, end) = ends(machine, pass)?;
        let next = program.passes.get(i + 1).and_then(|next| Some((next, ends(machine, next)?.0)));
        let way = if here.is_some_and(|here| is_same(&here, &start)) { Vec::new() } else { vec![start] };
        steps.begin_pass(&pass.name);
        let burns_on = next.is_some_and(|(next, start)| goes_on(pass, next) && is_same(&start, &end));
        steps.stands(pass, &way, Neighbours { first: i == 0, restarts: restarts(program), burns_on });
        here = Some(end);
    }
    Some(steps.program)
}

/// Whether a control can start again at a pass: there are several to weld.
fn restarts(program: &Program) -> bool {
    program.passes.iter().filter(|pass| pass.has_arc()).count() > 1
}

/// Events and messages of a pass through points, each with its path length.
fn point_events(pass: &Pass, path: &dyn TorchPath) -> Vec<(f64, Event)> {
    let events = pass.points.iter().flat_map(|points| &points.events);
    let mut events: Vec<(f64, Event)> =
        events.filter_map(|event| Some((path.points()?.reached(event.after)?, event_of(event)?))).collect();
    events.sort_by(|a, b| a.0.total_cmp(&b.0));
    events
}

/// Positions nearer than this are the same, mm or rad.
const SAME: f64 = 1e-9;

fn is_same(a: &Joints, b: &Joints) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME)
}

/// Whether the arc burns on from one pass into the next at the same position.
fn goes_on(pass: &Pass, next: &Pass) -> bool {
    next.has_arc() && pass.sequence.postflow_s.get() + next.sequence.preflow_s.get() <= 0.0
}

fn check_tip(control: &Control, motion: &WeldMotion, second: bool) -> Result<(), Error> {
    if !["x", "y", "z"].iter().all(|n| control.channel(n).is_some()) {
        return Err(Error::NoTip);
    }
    if motion.passes.len() > 1 && !control.switches_level() {
        return Err(Error::TipPasses);
    }
    if second { Err(Error::TwoTorches) } else { Ok(()) }
}

/// The blocks of a pass in the shapes that the control has; `second` if there is a second torch.
fn blocks(
    machine: &Machine,
    control: &Control,
    planned: &PlannedPass,
    options: &Options,
    second: bool,
) -> Result<Linearisation, Error> {
    let PlannedPass { pass, motion, course, events } = planned;
    let mut breaks: Vec<f64> = pass.spans.iter().skip(1).map(|s| s.from_mm.get()).collect();
    if pass.spans[0].process.keys().any(|name| control.is_stepped(name)) {
        breaks.extend(pass.spans.iter().flat_map(ramp_breaks));
        breaks.extend(weave_breaks(pass));
    }
    breaks.extend(course.breaks());
    breaks.extend(events.iter().map(|(s, _)| *s));
    breaks.sort_by(f64::total_cmp);
    let pmac = control.dialect == Dialect::Pmac;
    let spline = pmac && options.interpolation == Interpolation::Spline1;
    let base = match (control.dialect, options.interpolation) {
        (Dialect::Pmac, Interpolation::Pvt) => Kind::Cubic,
        (Dialect::Sinumerik, Interpolation::Poly) => Kind::Curve,
        _ => Kind::Line,
    };
    // Rounding of corners by the control, and linear motion left to the next block, count against the tolerance too.
    let linuxcnc = control.dialect == Dialect::Linuxcnc;
    let spared = if linuxcnc { ROUNDING + HELD_BACK } else { SPARED };
    let cutting = Cutting {
        level: options.level,
        tolerance_mm: (1.0 - spared) * options.tolerance_mm,
        speed: if motion.path.is_woven() { f64::INFINITY } else { 0.01 * options.speed_percent },
        least_feed: linuxcnc,
        base,
        arcs: if base == Kind::Line { arcs_of(control, options.level) } else { Arcs::None },
        xyz: control.axes_xyz(),
        longest_s: if base == Kind::Cubic || spline { LONGEST_CUBIC_S } else { f64::INFINITY },
        course: Some(course),
        second,
    };
    if spline { spline::splines(machine, motion, &breaks, &cutting) } else { cut(machine, motion, &breaks, &cutting) }
}

/// The arcs of the control: [`Arcs::None`] unless at least two (at tip level three) of its X, Y and Z are axes of these
/// names.
fn arcs_of(control: &Control, level: Level) -> Arcs {
    let there = control.axes_xyz().iter().flatten().count();
    if there < 2 || (level == Level::Tip && there < 3) {
        return Arcs::None;
    }
    match control.dialect {
        Dialect::Linuxcnc | Dialect::Grblhal => Arcs::Planes,
        // Circles anywhere in space need all three.
        Dialect::Sinumerik | Dialect::Pmac if there == 3 => Arcs::Any,
        Dialect::Sinumerik | Dialect::Pmac => Arcs::Planes,
    }
}

impl Control {
    /// Whether `name` is a process value that changes in steps.
    fn is_stepped(&self, name: &str) -> bool {
        self.channel(name).is_some_and(|i| self.channels[i].kind == crate::part_program::ChannelKind::Stepped)
    }

    /// Whether the machine file has an output or code for `event`.
    fn can(&self, event: &Event) -> bool {
        let output = match event {
            // Always present, and left out by the writer if the control has no word for it.
            Event::Arc(_) => Some(0),
            Event::Gas(_) => self.io.gas,
            Event::Wire(_) => self.io.wire,
            Event::Output(..) | Event::Message(_) => Some(0),
            Event::Call(_) => None,
        };
        output.is_some() || self.code(&Code::Event(event.clone())).is_some()
    }

    /// Whether a program can change from axes to the tip and back.
    pub(crate) fn switches_level(&self) -> bool {
        match self.dialect {
            Dialect::Sinumerik => true,
            Dialect::Linuxcnc => self.kinematics_output.is_some(),
            Dialect::Grblhal | Dialect::Pmac => false,
        }
    }

    /// Channels of X, Y and Z whose addresses are these letters too: those that arcs can be in.
    pub(crate) fn axes_xyz(&self) -> [Option<usize>; 3] {
        ["x", "y", "z"].map(|name| {
            self.channel(name).filter(|i| {
                self.addresses[*i].eq_ignore_ascii_case(name)
                    && self.channels[*i].kind == crate::part_program::ChannelKind::Linear
            })
        })
    }
}
