//! The steps of a program in the words of a dialect.

use super::dialect::Tongue;
use super::writer::{Problem, Writer};
use crate::control::{Code, Dialect};
use crate::error::Error;
use crate::part_program::{Event, Level, Move, Path, Step, What};
use seamwright_message::{Message, Unit};
use std::ops::Range;

/// Slower blocks lose digits of their feed, s.
const LONGEST_S: f64 = 3600.0;
/// Maximum length of remarks behind a dwell.
const SHORT: usize = 40;

impl Writer<'_> {
    pub(super) fn run<T: Tongue>(&mut self, tongue: &mut T) -> Result<(), Error> {
        let steps = &self.program.steps;
        let mut begins: Vec<usize> = (0..steps.len()).filter(|i| matches!(steps[*i].what, What::Pass(_))).collect();
        let passes = begins.len() as u32;
        begins.push(steps.len());
        let sub_first = T::SUBS.filter(|_| self.has_subs());
        tongue.first(self);
        self.comments(tongue, passes);
        let each = begins.windows(2).zip(1..).map(|(w, number)| (w[0]..w[1], number));
        if sub_first == Some(true) {
            each.clone().try_for_each(|(range, number)| self.pass(tongue, range, number, true))?;
        }
        self.template(&self.control.header, |w| tongue.head(w));
        self.known = false;
        self.steps(tongue, 0..begins[0])?;
        for (range, number) in each.clone() {
            match (sub_first, &steps[range.start].what) {
                (Some(_), What::Pass(name)) => tongue.call(self, number, name),
                _ => self.pass(tongue, range, number, false)?,
            }
        }
        if passes == 0 {
            tongue.end(self, 0, false);
        }
        self.template(&self.control.footer, |w| tongue.tail(w));
        if sub_first == Some(false) {
            each.clone().try_for_each(|(range, number)| self.pass(tongue, range, number, true))?;
        }
        Ok(())
    }

    /// The lines of a template, or the usual ones.
    fn template(&mut self, lines: &Option<String>, usual: impl FnOnce(&mut Self)) {
        let Some(lines) = lines else { return usual(self) };
        let filled = lines.replace("{title}", &self.program.title).replace("{machine}", &self.options.machine);
        filled.lines().for_each(|line| self.text.plain(line));
    }

    fn pass<T: Tongue>(&mut self, tongue: &mut T, range: Range<usize>, number: u32, sub: bool) -> Result<(), Error> {
        let program = self.program;
        if let What::Pass(name) = &program.steps[range.start].what {
            self.known = false;
            self.level = None;
            tongue.begin(self, number, name, sub);
        }
        self.steps(tongue, range)?;
        if self.level == Some(Level::Tip) {
            tongue.level(self, Level::Joint);
        }
        tongue.end(self, number, sub);
        Ok(())
    }

    fn steps<T: Tongue>(&mut self, tongue: &mut T, range: Range<usize>) -> Result<(), Error> {
        let program = self.program;
        let mut why: Option<&str> = None;
        for at in range.clone() {
            self.at = at;
            self.number = program.steps[at].number;
            let next = program.steps.get(at + 1).filter(|_| at + 1 < range.end);
            match &program.steps[at].what {
                What::Pass(_) => {}
                What::Comment(text)
                    if text.len() <= SHORT && matches!(next, Some(Step { what: What::Dwell(_), .. })) =>
                {
                    why = Some(text);
                }
                What::Comment(text) => self.text.comment(text),
                What::Dwell(seconds) => tongue.dwell(self, *seconds, why.take()),
                What::Set { channel, value, at_once } => {
                    tongue.set(self, usize::from(*channel), *value, *at_once).map_err(|problem| self.error(problem))?;
                }
                What::Event { event, at_once } => {
                    self.event(tongue, event, *at_once).map_err(|problem| self.error(problem))?;
                }
                What::Move(step) => self.go(tongue, step).map_err(|problem| self.error(problem))?,
            }
        }
        Ok(())
    }

    fn event<T: Tongue>(&mut self, tongue: &mut T, event: &Event, at_once: bool) -> Result<(), Problem> {
        if let Event::Message(text) = event {
            tongue.message(self, text);
            return Ok(());
        }
        if matches!(event, Event::Arc(_)) && !self.control.switches_arc() {
            return Ok(());
        }
        if tongue.own(self, event, at_once) {
            return Ok(());
        }
        let control = self.control;
        if let Some(code) = control.code(&Code::Event(event.clone())) {
            match at_once || control.dialect == Dialect::Pmac {
                true => {
                    tongue.wait(self);
                    self.text.word(code);
                    self.remark(event, true);
                }
                false => {
                    self.with_next_move(code);
                }
            }
            return Ok(());
        }
        if let Some((output, on)) = control.output(event) {
            tongue.output(self, output, on, at_once);
            self.remark(event, at_once);
            return Ok(());
        }
        let cure = "post-event-without-code-cure";
        Err(Problem::new(Message::new("post-event-without-code").message("event", event.message()), cure))
    }

    /// Ends the line with a comment on its effect.
    fn remark(&mut self, event: &Event, at_once: bool) {
        let (name, on) = match event {
            Event::Arc(on) => ("arc", *on),
            Event::Gas(on) => ("gas", *on),
            Event::Wire(on) => ("wire", *on),
            _ => return self.text.end(),
        };
        self.text.comment(match (name, on, at_once) {
            ("arc", true, true) => "arc on",
            ("arc", true, false) => "arc on with the motion",
            ("arc", false, true) => "arc off",
            ("arc", false, false) => "arc stays off",
            ("gas", true, _) => "gas on",
            ("gas", false, _) => "gas off",
            (_, true, _) => "wire on",
            (_, false, _) => "wire off",
        });
    }

    fn go<T: Tongue>(&mut self, tongue: &mut T, step: &Move) -> Result<(), Problem> {
        let to = self.program.row(step.row);
        if self.tells_level && self.level != Some(step.level) {
            tongue.level(self, step.level);
            self.level = Some(step.level);
            self.known = false;
        }
        if step.path != Path::Rapid && !(step.seconds > 0.0 && step.seconds <= LONGEST_S) {
            let what = Message::new("post-block-time").value("time", step.seconds, Unit::S);
            return Err(Problem::new(what, "post-block-time-cure"));
        }
        if step.path == Path::Line && self.known && !self.order.iter().any(|i| self.changes(*i, to)) {
            tongue.dwell(self, step.seconds, None);
        } else {
            tongue.go(self, step, to)?;
        }
        self.here.clear();
        self.here.extend_from_slice(to);
        self.known = true;
        Ok(())
    }
}
