//! A pass through axis positions, block by block as it stands.

use super::course::Course;
use super::steps::Steps;
use crate::Dialect;
use crate::part_program::{Event, Path};
use crate::points::steps as blocks;
use seamwright_motion::air::{AirMove, Leg};
use seamwright_program::{Along, Pass};

impl Steps<'_> {
    /// The pass, after the air move to it; whether it is the first, and whether the arc burns on into the next.
    pub(super) fn stands(
        &mut self,
        (pass, course): (&Pass, &Course),
        before: &AirMove,
        (first, burns_on): (bool, bool),
    ) {
        self.set.clear();
        let rapid = |points: &seamwright_program::Points| points.spans.first().is_some_and(|s| s.along == Along::Rapid);
        if !first {
            before.legs.iter().map(Leg::end).for_each(|q| self.stand_at(q));
        } else if !pass.points.as_ref().is_some_and(rapid)
            && let Some(leg) = before.legs.last()
        {
            self.stand_at(leg.end());
        }
        let (machine, control) = (self.machine, self.control);
        // Switched at its start, and the values that it begins with.
        blocks(machine, control, pass, (&mut self.program, &mut self.row), 0);
        self.begin(pass, course);
        blocks(machine, control, pass, (&mut self.program, &mut self.row), 1);
        self.finish(pass, course, burns_on);
    }

    fn stand_at(&mut self, q: &seamwright_machine::Joints) {
        let place = self.standing(q);
        self.go_to(&place, false);
        self.push(Path::Rapid, 0.0, false);
    }

    /// Rests before the travel.
    fn begin(&mut self, pass: &Pass, course: &Course) {
        let sequence = &pass.sequence;
        self.dwell(sequence.preflow_s.get(), "before");
        let delay = sequence.travel_delay_s.get();
        if pass.has_arc() && !self.arc {
            self.event(Event::Arc(true), delay > 0.0);
            self.arc = true;
        }
        let upslope = sequence.upslope.as_ref().map_or(0.0, |s| s.time_s.get());
        let mut time = 0.0;
        for step in self.rests(delay, (upslope, 0.0), pass) {
            if step.slopes {
                self.values(pass, true, (0.0, (step.middle, f64::INFINITY)));
            }
            time += step.time;
            let ends = course.at_rest(0.0, (time, f64::INFINITY));
            self.rest(step.time, ends, if step.slopes { "upslope" } else { "travel delay" });
        }
    }

    /// Rests after it.
    fn finish(&mut self, pass: &Pass, course: &Course, burns_on: bool) {
        let sequence = &pass.sequence;
        let (crater, length) = (sequence.crater_s.get(), pass.length());
        let downslope = sequence.downslope.as_ref().map_or(0.0, |s| s.time_s.get());
        let mut time = 0.0;
        for step in self.rests(crater, (0.0, downslope), pass) {
            if step.slopes {
                self.values(pass, true, (length, (f64::INFINITY, crater - step.middle)));
            }
            time += step.time;
            let ends = course.at_rest(length, (f64::INFINITY, (crater - time).max(0.0)));
            self.rest(step.time, ends, if step.slopes { "downslope" } else { "crater fill" });
        }
        if self.arc && !burns_on {
            self.event(Event::Arc(false), true);
            // LinuxCNC keeps what M62 said until a motion says otherwise.
            if self.control.dialect == Dialect::Linuxcnc {
                self.event(Event::Arc(false), false);
            }
            self.arc = false;
        }
        self.dwell(sequence.postflow_s.get(), "after");
    }
}
