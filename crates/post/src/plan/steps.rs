//! The steps of a pass around its blocks: gas, arc, slopes, values, and the ways there and back.

use super::block::{Block, Linearisation, Shape};
use super::course::Course;
use super::options::Options;
use super::ramps::{RestStep, rest_steps};
use super::rows::{SCALE, rounded};
use super::spline::TICK;
use crate::control::{Control, Dialect};
use crate::part_program::{ChannelKind, Event, Level, PartProgram, Path, What};
use crate::write::fixed;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::PassMotion;
use seamwright_motion::transfer::{Leg, TransferMove};
use seamwright_program::{ArcTime, Pass, ProcessValue, Program};
use std::collections::BTreeMap;

/// Feed of the approach from where the torch stands back to the start of the weld, mm/min.
const APPROACH_MM_MIN: f64 = 600.0;
/// An event up to this far behind the start of a block is switched with it, mm.
const NEAR: f64 = 1e-6;
/// Steps of process values at outputs.
const VALUE_SCALE: f64 = 1e4;

/// Transfer moves before and after a pass.
#[derive(Clone, Copy)]
pub(super) struct Transfers<'a> {
    pub(super) before: &'a TransferMove,
    pub(super) after: &'a TransferMove,
}

/// A part program in the making.
pub(super) struct Steps<'a> {
    pub(super) machine: &'a Machine,
    pub(super) control: &'a Control,
    pub(super) level: Level,
    pub(super) program: PartProgram,
    /// Last value of each channel that was sent to the control.
    pub(super) row: Vec<f64>,
    /// The row before the block under way.
    pub(super) before: Vec<f64>,
    /// The last value of each channel that was set at once or not, since the pass began.
    pub(super) set: BTreeMap<(u16, bool), f64>,
    pub(super) arc: bool,
}

impl<'a> Steps<'a> {
    pub(super) fn new(machine: &'a Machine, control: &'a Control, program: &Program, options: &Options) -> Self {
        let part = PartProgram::new(&program.title, control.channels.clone());
        let row = vec![0.0; control.channels.len()];
        let before = row.clone();
        Self { machine, control, level: options.level, program: part, row, before, set: BTreeMap::new(), arc: false }
    }

    /// Starts a pass: the arc is off, regardless of the program before, unless it burns on.
    pub(super) fn begin_pass(&mut self, name: &str) {
        self.program.push(What::Pass(name.into()));
        if !self.arc {
            self.event(Event::Arc(false), true);
        }
    }

    fn comment(&mut self, text: &str) {
        self.program.push(What::Comment(text.into()));
    }

    pub(super) fn remarks(&mut self, name: &str, motion: &PassMotion, cut: &Linearisation, options: &Options) {
        self.comment(&format!(
            "{name}: travel {} mm in {} s; arc on {} s",
            fixed(motion.path.length(), 3),
            fixed(motion.profile.duration(), 3),
            fixed(motion.arc_on_s(), 3)
        ));
        let arcs = cut.blocks.iter().filter(|b| matches!(b.shape, Shape::Arc(_))).count();
        let arcs = if arcs > 0 { format!(", {arcs} of them arcs") } else { String::new() };
        self.comment(&format!(
            "{} blocks{arcs}, chord error {} mm of {} mm allowed",
            cut.blocks.len(),
            fixed(cut.chord_error_mm, 6),
            fixed(options.tolerance_mm, 6)
        ));
    }

    /// The planned way from where the torch stands back after one pass to where it does before the next, for the axes.
    pub(super) fn air(&mut self, air: &TransferMove) {
        self.comment("the planned way to the next pass");
        // The retract and the approach are written with their welds; the last position is the start of the approach.
        let skip = usize::from(air.retracts);
        let inner = air.legs.len().saturating_sub(usize::from(air.approaches));
        let level = std::mem::replace(&mut self.level, Level::Joint);
        for leg in air.legs.iter().take(inner).skip(skip) {
            if leg.is_rest() {
                self.dwell(leg.duration(), "wait until the weld has cooled");
                continue;
            }
            self.go_to(&self.standing(leg.end()), false);
            self.push(Path::Rapid, 0.0, false);
        }
        self.level = level;
    }

    /// A pass with the ends of the transfer moves before and after it.
    pub(super) fn pass(&mut self, cut: &Linearisation, planned: PlannedPass, transfers: Transfers, first: bool) {
        let PlannedPass { pass, course, events, .. } = planned;
        let Transfers { before, after } = transfers;
        let from = before.legs.last().filter(|_| before.approaches).map(Leg::start);
        let to = after.legs.first().filter(|_| after.retracts).map(Leg::end);
        self.set.clear();
        self.approach(&cut.start, from, first);
        self.start(cut, pass, &course);
        let left = self.weld(cut, pass, &course, events);
        self.end(pass, &course);
        left.into_iter().for_each(|(_, event)| self.event(event, true));
        let end = cut.blocks.last().unwrap_or(&cut.start);
        if let Some(to) = to {
            // LinuxCNC keeps the outputs of M62 until a motion changes them.
            if self.control.dialect == Dialect::Linuxcnc && pass.has_arc() {
                self.event(Event::Arc(false), false);
            }
            let back = self.standing(to);
            self.go_to(&back, false);
            self.push(Path::Line, approach_s(end, &back), false);
        }
    }

    pub(super) fn standing(&self, q: &Joints) -> Block {
        let tip = self.machine.forward(q).point;
        Block { s: 0.0, q: *q, tip, duration: 0.0, turns_only: false, stops: false, shape: Shape::Line }
    }

    fn approach(&mut self, start: &Block, back: Option<&Joints>, first: bool) {
        match back.map(|q| self.standing(q)) {
            Some(back) => {
                if first {
                    self.comment(
                        "rapid to a place back from the start along the torch: make sure that the way there is clear",
                    );
                }
                self.go_to(&back, false);
                self.push(Path::Rapid, 0.0, false);
                self.go_to(start, false);
                // A PMAC does not blend into its cubics.
                self.push(Path::Line, approach_s(&back, start), self.control.dialect == Dialect::Pmac);
            }
            None => {
                if first {
                    self.comment(
                        "rapid to the start of the weld [the axes cannot take the torch back along itself]: make sure that the way there is clear",
                    );
                }
                self.go_to(start, false);
                self.push(Path::Rapid, 0.0, false);
            }
        }
    }

    fn start(&mut self, cut: &Linearisation, pass: &Pass, course: &Course) {
        let sequence = &pass.sequence;
        self.missing(pass);
        // A pass through points has its own events beside the arc.
        if pass.points.is_none() {
            self.event(Event::Gas(true), true);
        }
        self.dwell(sequence.preflow_s.get(), if pass.has_arc() { "preflow" } else { "before" });
        let delay = sequence.travel_delay_s.get();
        let since_on = |since_on_s: f64| ArcTime { since_on_s, ..ArcTime::TRAVEL };
        let at_first = if delay > 0.0 { since_on(0.0) } else { ArcTime::TRAVEL };
        for (channel, value) in course.at_rest(0.0, at_first) {
            self.set_interpolated(channel, value);
        }
        if delay > 0.0 {
            // At rest before the motion: immediate outputs, for LinuxCNC repeated below in step with the motion.
            let upslope = sequence.upslope.as_ref().map_or(0.0, |s| s.time_s.get());
            let mut time = 0.0;
            for (i, step) in self.rests(delay, (upslope, 0.0), pass).into_iter().enumerate() {
                self.values(pass, true, 0.0, since_on(step.middle));
                if i == 0 && pass.has_arc() {
                    self.event(Event::Arc(true), true);
                }
                time += step.time;
                let ends = course.at_rest(0.0, since_on(time));
                self.rest(step.time, ends, if step.slopes { "upslope" } else { "travel delay" });
            }
        }
        self.values(pass, false, cut.blocks.first().map_or(0.0, |block| 0.5 * block.s), ArcTime::TRAVEL);
        if pass.has_arc() && (delay <= 0.0 || self.control.dialect == Dialect::Linuxcnc) {
            self.event(Event::Arc(true), false);
        }
    }

    /// The blocks, with the events on the way; remaining events come at the end.
    fn weld(
        &mut self,
        cut: &Linearisation,
        pass: &Pass,
        course: &Course,
        events: Vec<(f64, Event)>,
    ) -> Vec<(f64, Event)> {
        let mut before = cut.start;
        let mut events = events.into_iter().peekable();
        let (mut last, mut time, mut ticks) = (0, 0.0, 0.0);
        for (i, block) in cut.blocks.iter().enumerate() {
            // A block has the values of its middle: of the one span that it lies in, and half a step off a ramp's at
            // most.
            let middle = 0.5 * (before.s + block.s);
            let span = pass.spans.partition_point(|span| span.to_mm.get() <= middle).min(pass.spans.len() - 1);
            let ramps = pass.spans[span].process.values().any(ProcessValue::is_ramp)
                || pass.weave.as_ref().is_some_and(|weave| !weave.at_sides.is_empty());
            if i > 0 && (span != last || ramps) {
                self.values(pass, false, middle, ArcTime::TRAVEL);
                last = span;
            }
            while let Some((_, event)) = events.next_if(|(s, _)| *s <= before.s + NEAR) {
                self.event(event, false);
            }
            for (channel, value) in course.row(block.s) {
                self.row[channel] = rounded(value, SCALE);
            }
            self.before.clone_from(&self.row);
            self.go_to(block, block.turns_only);
            // PMAC's times are multiples of a tick; the rounding of one block is corrected in the next.
            time += block.duration;
            let seconds = match self.control.dialect {
                Dialect::Pmac => (time / TICK).round() * TICK - ticks,
                _ => block.duration,
            };
            ticks += seconds;
            let path = self.path(&block.shape);
            self.push(path, seconds, block.stops);
            before = *block;
        }
        events.collect()
    }

    fn end(&mut self, pass: &Pass, course: &Course) {
        let sequence = &pass.sequence;
        self.crater(pass, course);
        if pass.has_arc() {
            self.event(Event::Arc(false), true);
        }
        for name in pass.spans[0].process.keys() {
            if let Some(i) = self.control.channel(name) {
                self.row[i] = 0.0;
                self.program.push(What::Set { channel: i as u16, value: 0.0, at_once: true });
            }
        }
        self.dwell(sequence.postflow_s.get(), if pass.has_arc() { "postflow" } else { "after" });
        if pass.points.is_none() {
            self.event(Event::Gas(false), true);
        }
    }

    /// Rests at the end of a pass with the arc on.
    pub(super) fn crater(&mut self, pass: &Pass, course: &Course) {
        let sequence = &pass.sequence;
        let (crater, length) = (sequence.crater_s.get(), pass.length());
        let downslope = sequence.downslope.as_ref().map_or(0.0, |s| s.time_s.get());
        let until_off = |until_off_s: f64| ArcTime { until_off_s, ..ArcTime::TRAVEL };
        let mut time = 0.0;
        for step in self.rests(crater, (0.0, downslope), pass) {
            if step.slopes {
                self.values(pass, true, length, until_off(crater - step.middle));
            }
            time += step.time;
            let ends = course.at_rest(length, until_off((crater - time).max(0.0)));
            self.rest(step.time, ends, if step.slopes { "downslope" } else { "crater fill" });
        }
    }

    /// The steps of a rest; slopes are one step if the control interpolates all that changes.
    pub(super) fn rests(&self, time: f64, slopes: (f64, f64), pass: &Pass) -> Vec<RestStep> {
        if pass.spans[0].process.keys().any(|name| self.control.is_stepped(name)) {
            return rest_steps(time, slopes);
        }
        let parts = [(slopes.0, true), (time - slopes.0 - slopes.1, false), (slopes.1, true)];
        let parts = parts.into_iter().filter(|(length, _)| *length > 0.0);
        parts.map(|(time, slopes)| RestStep { time, middle: 0.0, slopes }).collect()
    }

    /// A part of a rest: a dwell, or a block in which only process values change.
    pub(super) fn rest(&mut self, seconds: f64, ends: impl Iterator<Item = (usize, f64)>, why: &str) {
        let mut changes = false;
        for (channel, value) in ends {
            let value = rounded(value, SCALE);
            changes |= self.row[channel].to_bits() != value.to_bits();
            self.row[channel] = value;
        }
        if changes {
            self.comment(why);
            self.push(Path::Line, seconds, false);
        } else {
            self.dwell(seconds, why);
        }
    }

    pub(super) fn dwell(&mut self, seconds: f64, why: &str) {
        if seconds > 0.0 {
            self.comment(why);
            self.program.push(What::Dwell(rounded(seconds, SCALE)));
        }
    }

    /// Switches `event`, if the machine file has an output or code for it.
    pub(super) fn event(&mut self, event: Event, at_once: bool) {
        if self.control.can(&event) {
            self.program.push(What::Event { event, at_once });
        }
    }

    /// Sets the process values that change in steps and have changed, at path length `s` and an instant with the arc on.
    pub(super) fn values(&mut self, pass: &Pass, at_once: bool, s: f64, time: ArcTime) {
        for name in pass.spans[0].process.keys() {
            let value = rounded(pass.process_at(name, s, time).unwrap_or(0.0), VALUE_SCALE);
            match self.control.channel(name) {
                Some(i) if self.control.channels[i].kind == ChannelKind::Stepped => {
                    let channel = i as u16;
                    self.row[i] = value;
                    if self.set.insert((channel, at_once), value) != Some(value) {
                        self.program.push(What::Set { channel, value, at_once });
                    }
                }
                _ => {}
            }
        }
    }

    /// Reports process values for which the control has no output.
    fn missing(&mut self, pass: &Pass) {
        for name in pass.spans[0].process.keys().filter(|name| self.control.channel(name).is_none()) {
            let value = pass.process_at(name, 0.0, ArcTime::TRAVEL).unwrap_or(0.0);
            self.comment(&format!("{name}, {value} at first: the machine file has no output for it"));
        }
    }

    fn set_interpolated(&mut self, channel: usize, value: f64) {
        let value = rounded(value, SCALE);
        self.row[channel] = value;
        self.program.push(What::Set { channel: channel as u16, value, at_once: true });
    }
}

/// Time of an approach or retract, s.
fn approach_s(a: &Block, b: &Block) -> f64 {
    60.0 * (a.tip - b.tip).length().max(1.0) / APPROACH_MM_MIN
}

/// A pass with its motion, process values and events.
pub(super) struct PlannedPass<'a> {
    pub(super) pass: &'a Pass,
    pub(super) motion: &'a PassMotion,
    pub(super) course: Course<'a>,
    /// Events and messages with their path lengths, mm.
    pub(super) events: Vec<(f64, Event)>,
}
