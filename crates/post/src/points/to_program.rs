mod blocks;

use super::rests::{Gap, Rests};
use crate::control::Control;
use crate::error::Error;
use crate::part_program::{ChannelKind, Event, Level, Move, PartProgram, Path, Step, What};
use crate::play::{Segment, play};
use blocks::push;
use seamwright_document::{Finite, Positive};
use seamwright_machine::Machine;
use seamwright_program::{
    Along, AtCorner, NUMBER_COLUMN, OnLimit, POSE_COLUMNS, Pass, PointEvent, PointSpan, Points, Program, TIME_COLUMN,
};

/// Converts a part program into a program of points: every block a point, equal in effect. `start` is the row before
/// its first block, `name` the machine's. Corners that the control passes without a stop are blended within `blend_mm`.
///
/// A new pass starts at each pass of the part program, at each change of the arc, and at each change of the control's
/// kinematics. If the machine file has no output for the arc, it is on in feed moves and off in rapid ones.
///
/// # Errors
/// [`Error::Nothing`] without any motion.
pub fn to_program(
    machine: &Machine,
    control: &Control,
    read: &PartProgram,
    start: &[f64],
    name: &str,
    blend_mm: Positive,
) -> Result<Program, Error> {
    let segments = play(read, start);
    let used = used(read, &segments);
    let mut builder = Builder {
        machine,
        read,
        used,
        switches_arc: control.switches_arc(),
        numbered: read.steps.iter().any(|step| step.number.is_some() && matches!(step.what, What::Move(_))),
        corner: AtCorner::BlendMm(blend_mm),
        here: start.to_vec(),
        before: start.to_vec(),
        done: Vec::new(),
        open: None,
        name: None,
        rests: Rests::default(),
        switched: false,
    };
    let mut segments = segments.into_iter().peekable();
    for (i, step) in read.steps.iter().enumerate() {
        let mut of_step = Vec::new();
        while let Some(segment) = segments.next_if(|segment| segment.step <= i) {
            of_step.push(segment);
        }
        builder.step(step, &of_step);
    }
    builder.close(true);
    if builder.done.is_empty() {
        return Err(Error::Nothing);
    }
    let (title, machine) = (read.title.clone(), name.to_owned());
    Ok(Program { title, machine, passes: builder.done, ..Program::default() })
}

/// Process channels that are ever other than 0.
fn used(read: &PartProgram, segments: &[Segment]) -> Vec<usize> {
    let mut used = vec![false; read.channels.len()];
    for segment in segments {
        for row in [segment.start(), segment.end()] {
            used.iter_mut().zip(row).for_each(|(used, value)| *used |= *value != 0.0);
        }
    }
    (read.axes()..used.len()).filter(|i| used[*i]).collect()
}

/// A pass that is being made.
struct Open {
    name: String,
    arc: bool,
    level: Level,
    points: Points,
    rests: Rests,
}

struct Builder<'a> {
    machine: &'a Machine,
    read: &'a PartProgram,
    /// Process channels that the part program sets.
    used: Vec<usize>,
    switches_arc: bool,
    numbered: bool,
    corner: AtCorner,
    /// All channels where the last step ended.
    here: Vec<f64>,
    /// The same before the rests since the last move.
    before: Vec<f64>,
    done: Vec<Pass>,
    open: Option<Open>,
    /// Name that the next pass has.
    name: Option<String>,
    /// Gaps since the last move.
    rests: Rests,
    /// Whether the arc was switched since then.
    switched: bool,
}

impl Builder<'_> {
    fn step(&mut self, step: &Step, segments: &[Segment]) {
        match &step.what {
            What::Pass(name) => {
                self.close(false);
                self.name = Some(name.to_string());
            }
            What::Move(m) => segments.iter().for_each(|segment| self.segment(step, m, segment)),
            What::Dwell(seconds) if *seconds <= 0.0 => {}
            What::Dwell(seconds) => {
                if !self.rests.is_rest() {
                    self.before.clone_from(&self.here);
                }
                for segment in segments {
                    let values = self.used.iter().map(|i| segment.end()[*i]).collect();
                    self.rests.add(Gap::Rest(segment.arc, *seconds, values));
                    self.here = segment.end().to_vec();
                }
            }
            What::Event { event, .. } => self.event(event),
            What::Set { .. } | What::Comment(_) => {}
        }
    }

    fn event(&mut self, event: &Event) {
        let none = PointEvent { after: 0, gas: None, wire: None, output: None, on: None, message: None, call: None };
        self.rests.add(Gap::Event(match event {
            Event::Arc(on) => {
                self.switched |= self.switches_arc && self.open.as_ref().is_some_and(|open| open.arc != *on);
                return;
            }
            Event::Gas(on) => PointEvent { gas: Some(*on), ..none },
            Event::Wire(on) => PointEvent { wire: Some(*on), ..none },
            Event::Output(number, on) => PointEvent { output: Some(*number), on: Some(*on), ..none },
            Event::Message(text) => PointEvent { message: Some(text.to_string()), ..none },
            Event::Call(name) => PointEvent { call: Some(name.to_string()), ..none },
        }));
    }

    fn segment(&mut self, step: &Step, m: &Move, segment: &Segment) {
        let arc = if self.switches_arc { segment.arc } else { m.path != Path::Rapid };
        let stands = segment.seconds == 0.0 && segment.start() == segment.end();
        if stands {
            return;
        }
        let same = |open: &Open| open.arc == arc && open.level == m.level;
        let goes_on = !std::mem::take(&mut self.switched) && self.open.as_ref().is_some_and(same);
        if goes_on && self.rests.is_rest() {
            let rests = self.rests.take_all();
            self.rest_within(rests);
        }
        if !goes_on {
            let mut start = segment.start().to_vec();
            let before = if self.rests.is_rest() { &self.before } else { &self.here };
            for (i, channel) in self.read.channels.iter().enumerate() {
                if channel.kind == ChannelKind::Stepped {
                    start[i] = before[i];
                }
            }
            self.close(false);
            let told = |row: &[f64]| -> Vec<f64> { self.used.iter().map(|i| row[*i]).collect() };
            let (stays, weld) = (told(&start), told(segment.end()));
            let odd = if arc { self.rests.take_odd(true, &stays, &weld, false) } else { Vec::new() };
            self.begin(arc, m.level, &start);
            self.rest_within(odd);
        }
        let Some(open) = &mut self.open else { return };
        let reached = open.points.count();
        let events = self.rests.take_events().into_iter();
        open.points.events.extend(events.map(|event| PointEvent { after: reached, ..event }));
        self.add(m, segment, step.number.filter(|_| self.numbered));
        self.here = segment.end().to_vec();
    }

    /// Adds rests within a pass to it: points where the torch is.
    fn rest_within(&mut self, rests: Vec<Gap>) {
        for gap in rests {
            let Some(open) = &mut self.open else { return };
            match gap {
                Gap::Event(event) => open.points.events.push(PointEvent { after: open.points.count(), ..event }),
                Gap::Rest(_, seconds, values) => {
                    let level = open.level;
                    let mut row = self.here.clone();
                    self.used.iter().zip(values).for_each(|(i, value)| row[*i] = value);
                    let point = self.point(&row, level, None, seconds);
                    let (along, stops, via_mm, normal) = (Along::Line, false, None, None);
                    let span = PointSpan { along, stops, via_mm, normal, speeds: Vec::new(), points: vec![point] };
                    if let Some(open) = &mut self.open {
                        push(&mut open.points.spans, span);
                    }
                }
            }
        }
    }

    fn begin(&mut self, arc: bool, level: Level, start: &[f64]) {
        let mut columns: Vec<String> = match level {
            Level::Joint => self.read.channels[..self.read.axes()].iter().map(|c| c.name.clone()).collect(),
            Level::Tip => POSE_COLUMNS.map(str::to_owned).to_vec(),
        };
        columns.extend(self.used.iter().map(|i| self.read.channels[*i].name.clone()));
        columns.extend(self.numbered.then(|| NUMBER_COLUMN.to_owned()));
        columns.push(TIME_COLUMN.to_owned());
        let stepped = self.used.iter().map(|i| &self.read.channels[*i]);
        let stepped = stepped.filter(|c| c.kind == ChannelKind::Stepped).map(|c| c.name.clone()).collect();
        let name = self.name.take().unwrap_or_else(|| match arc {
            true => format!("weld {}", self.done.iter().filter(|pass| pass.has_arc()).count() + 1),
            false => format!("way {}", self.done.iter().filter(|pass| !pass.has_arc()).count() + 1),
        });
        let start = self.point(start, level, None, 0.0);
        let events = self.rests.take_events();
        let points = Points { columns, arc, stepped, start, events, spans: Vec::new() };
        self.open = Some(Open { name, arc, level, points, rests: std::mem::take(&mut self.rests) });
    }

    /// Ends the open pass, the last one or not.
    fn close(&mut self, last: bool) {
        let Some(open) = &self.open else { return };
        let ended = open.points.rows().last().map_or(Vec::new(), |row| self.values(&open.points, row));
        let odd = self.rests.take_odd(open.arc, &ended, &ended, true);
        self.rest_within(odd);
        let Some(mut open) = self.open.take() else { return };
        let names: Vec<String> = self.used.iter().map(|i| self.read.channels[*i].name.clone()).collect();
        let values = |row: Option<&[Finite]>| row.map_or(Vec::new(), |row| self.values(&open.points, row));
        let (first, ended) = (values(open.points.rows().nth(1)), values(open.points.rows().last()));
        let end = self.rests.take_end(open.arc, last);
        let sequence = open.rests.sequence(&names, &first, &ended, &end);
        let reached = open.points.count();
        open.points.events.extend(end.events.into_iter().map(|event| PointEvent { after: reached, ..event }));
        self.done.push(Pass {
            name: open.name,
            on_limit: OnLimit::Slow,
            corner: self.corner,
            sequence,
            points: Some(open.points),
            ..Pass::default()
        });
    }

    /// Process values of a point.
    fn values(&self, points: &Points, row: &[Finite]) -> Vec<f64> {
        let first = points.columns.len() - 1 - usize::from(self.numbered) - self.used.len();
        row[first..first + self.used.len()].iter().map(|v| v.get()).collect()
    }
}

/// Values of a part program are finite: they were read so.
fn finite(value: f64) -> Finite {
    Finite::new(value).unwrap_or_default()
}
