//! A pass through axis positions, block by block as it stands.

use super::course::Course;
use super::steps::Steps;
use crate::part_program::{ChannelKind, Event, Path, What};
use crate::points::{Part, ends, steps as blocks};
use seamwright_document::{Finite, NonNegative, Positive};
use seamwright_machine::Joints;
use seamwright_program::{Along, ArcTime, Pass, Span, SpanValue};

/// The pass with only the process values of its first and its last block, in spans of 1 mm: the data for slopes before
/// and after it.
fn at_its_ends(pass: &Pass) -> Pass {
    let Some(points) = &pass.points else { return pass.clone() };
    let columns = points.known_columns();
    let rows: Vec<&[Finite]> = points.rows().collect();
    let span = |from: f64, before: &[Finite], after: &[Finite]| {
        Some(Span {
            from_mm: NonNegative::new(from)?,
            to_mm: Positive::new(from + 1.0)?,
            speed_mm_s: SpanValue::Steady(Positive::TEN),
            process: points.process_between(&columns, before, after),
        })
    };
    let last = rows.len() - 1;
    let spans = [span(0.0, rows[0], rows[1]), span(1.0, rows[last - 1], rows[last])];
    Pass { spans: spans.into_iter().flatten().collect(), ..pass.clone() }
}

/// Whether no axis moves to the first point of a pass.
fn rests_first(pass: &Pass) -> bool {
    let Some(points) = &pass.points else { return false };
    let axes = points.known_columns().axes;
    points.rows().nth(1).is_some_and(|first| axes.iter().all(|(_, i)| first[*i] == points.start[*i]))
}

/// Position of a pass among its neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours {
    pub(super) first: bool,
    /// The control may start again at it.
    pub(super) restarts: bool,
    /// The arc burns on into the next.
    pub(super) burns_on: bool,
}

impl Steps<'_> {
    /// The pass, after the `way` to it, straight from position to position.
    pub(super) fn stands(&mut self, pass: &Pass, way: &[Joints], neighbours: Neighbours) {
        let Neighbours { first, restarts, burns_on } = neighbours;
        let again = restarts && !self.arc;
        let short = at_its_ends(pass);
        let course = Course::new(self.control, &short);
        self.set.clear();
        let along = pass.points.as_ref().and_then(|points| points.spans.first()).map(|span| span.along);
        if !first {
            way.iter().for_each(|q| self.stand_at(q));
        } else if along != Some(Along::Rapid)
            && let Some(start) = way.last()
        {
            self.stand_at(start);
        }
        if along == Some(Along::Arc) || rests_first(pass) || (again && !first && way.is_empty()) {
            // Controls need the start of an arc or a rest, and move there if they start again here.
            ends(self.machine, pass).into_iter().for_each(|(start, _)| self.stand_at(&start));
        }
        let (machine, control) = (self.machine, self.control);
        // Events at its start, and its first values.
        blocks(machine, control, pass, &mut self.program, &mut self.row, Part::Begin { all: again });
        self.begin(&short, &course);
        blocks(machine, control, pass, &mut self.program, &mut self.row, Part::Blocks);
        self.finish(&short, &course, burns_on);
        blocks(machine, control, pass, &mut self.program, &mut self.row, Part::End);
    }

    fn stand_at(&mut self, q: &Joints) {
        self.go_to(&self.standing(q), false);
        self.push(Path::Rapid, 0.0, false);
    }

    /// Rests before the travel.
    fn begin(&mut self, pass: &Pass, course: &Course) {
        let sequence = &pass.sequence;
        self.dwell(sequence.preflow_s.get(), "before");
        let delay = sequence.travel_delay_s.get();
        if pass.has_arc() && !self.arc {
            // At once: LinuxCNC keeps outputs switched with a motion until another motion changes them.
            self.event(Event::Arc(true), true);
            self.arc = true;
        }
        let upslope = sequence.upslope.as_ref().map_or(0.0, |s| s.time_s.get());
        let since_on = |since_on_s: f64| ArcTime { since_on_s, ..ArcTime::TRAVEL };
        let mut time = 0.0;
        for step in self.rests(delay, (upslope, 0.0), pass) {
            if step.slopes {
                self.values(pass, true, 0.0, since_on(step.middle));
            }
            time += step.time;
            let ends = course.at_rest(0.0, since_on(time));
            self.rest(step.time, ends, if step.slopes { "upslope" } else { "travel delay" });
        }
    }

    /// Rests after it.
    fn finish(&mut self, pass: &Pass, course: &Course, burns_on: bool) {
        let sequence = &pass.sequence;
        self.crater(pass, course);
        if self.arc && !burns_on {
            self.event(Event::Arc(false), true);
            self.arc = false;
            // A stepped value keeps its setting until the next one, so it is set to zero without the arc.
            for name in pass.spans.first().iter().flat_map(|span| span.process.keys()) {
                let Some(i) = self.control.channel(name) else { continue };
                if self.control.channels[i].kind == ChannelKind::Stepped && self.row[i].abs() > 0.0 {
                    self.row[i] = 0.0;
                    self.program.push(What::Set { channel: i as u16, value: 0.0, at_once: true });
                }
            }
        }
        self.dwell(sequence.postflow_s.get(), "after");
    }
}
