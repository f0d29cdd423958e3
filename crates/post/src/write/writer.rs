use super::options::WriteOptions;
use super::text::Text;
use super::tongue::Tongue;
use crate::control::{Code, Control, Dialect};
use crate::error::Error;
use crate::part_program::{Arc, ChannelKind, Event, Level, Move, MoveRows, PartProgram, Path, Step, What};
use glam::DVec3;
use seamwright_message::{Message, Unit};
use std::ops::Range;

/// Feature that the control lacks, and the operator action.
pub(super) struct Problem {
    pub(super) what: Message,
    pub(super) cure: &'static str,
}

impl Problem {
    /// A problem and the code of its operator action.
    pub(super) fn new(what: Message, cure: &'static str) -> Self {
        Self { what, cure }
    }

    /// A problem without arguments, by its code.
    pub(super) fn plain(what: &'static str, cure: &'static str) -> Self {
        Self::new(Message::new(what), cure)
    }
}

/// Slower blocks lose digits of their feed, s.
const LONGEST_S: f64 = 3600.0;
/// Maximum length of remarks behind a dwell.
const SHORT: usize = 40;

/// The text so far and the state of the control.
pub(super) struct Writer<'a> {
    pub(super) control: &'a Control,
    pub(super) program: &'a PartProgram,
    pub(super) options: &'a WriteOptions,
    pub(super) text: Text,
    /// Axis channels in the order in which they are written, then interpolated process values.
    pub(super) order: Vec<usize>,
    /// Row the control is at; empty before the first move.
    pub(super) here: Vec<f64>,
    /// Whether its values have been written since the pass started.
    pub(super) known: bool,
    /// Codes and words that go with the next move.
    pub(super) pending: String,
    /// Level last sent to the control, if any.
    level: Option<Level>,
    /// Whether the control needs words for levels.
    tells_level: bool,
    at: usize,
    /// Block number that the step under way has of its own.
    pub(super) number: Option<u32>,
    /// Whether the program has its own block numbers: then no others are written.
    pub(super) numbered: bool,
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        control: &'a Control,
        program: &'a PartProgram,
        options: &'a WriteOptions,
    ) -> Result<Self, Error> {
        let text = Text::new(control.dialect, control.decimal_comma, 64 * program.steps.len() + 4096);
        let kinds = |i: &usize| control.channels[*i].kind;
        let axes =
            (0..control.channels.len()).filter(|i| matches!(kinds(i), ChannelKind::Linear | ChannelKind::Rotary));
        let mut order: Vec<usize> = axes.collect();
        if control.dialect != Dialect::Sinumerik {
            order.sort_by_key(|i| "XYZUVWABC".find(control.addresses[*i].as_str()));
        }
        order.extend((0..control.channels.len()).filter(|i| kinds(i) == ChannelKind::Interpolated));
        let writer = Self {
            control,
            program,
            options,
            text,
            order,
            here: Vec::new(),
            known: false,
            pending: String::new(),
            level: None,
            tells_level: false,
            at: 0,
            number: None,
            numbered: program.steps.iter().any(|step| step.number.is_some()),
        };
        writer.checked()
    }

    /// Checks channels and levels.
    fn checked(mut self) -> Result<Self, Error> {
        if self.program.channels != self.control.channels {
            let problem = Problem::plain("post-other-channels", "post-other-channels-cure");
            return Err(self.error(problem));
        }
        let axes = self.program.axes();
        if self.control.dialect == Dialect::Grblhal && axes > 8 {
            let problem = Problem::new(Message::new("post-grblhal-axes").count("axes", axes), "post-another-control");
            return Err(self.error(problem));
        }
        let level = |step: &Step| match &step.what {
            What::Move(m) => Some(m.level),
            _ => None,
        };
        let steps = &self.program.steps;
        let tip = steps.iter().any(|s| level(s) == Some(Level::Tip));
        self.tells_level = tip && self.control.switches_level();
        if tip && !self.tells_level {
            self.at = steps.iter().position(|s| level(s) == Some(Level::Joint)).unwrap_or(0);
            if steps.iter().any(|s| level(s) == Some(Level::Joint)) {
                let cure = "post-tip-to-axes-cure";
                return Err(self.error(Problem::plain("post-tip-to-axes", cure)));
            }
        }
        Ok(self)
    }

    /// `problem` with the step and the pass that it is in.
    fn error(&self, problem: Problem) -> Error {
        let before = self.program.steps.iter().take(self.at + 1).rev();
        let pass = before.into_iter().find_map(|step| match &step.what {
            What::Pass(name) => Some(name.to_string()),
            _ => None,
        });
        Error::Unwritable { step: self.at + 1, pass, what: problem.what, cure: Message::new(problem.cure) }
    }

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

    pub(super) fn finish(self) -> Result<String, Error> {
        let (fits, longest) = self.text.fits();
        if !fits {
            let what = Message::new("post-line-longer").count("max", longest);
            return Err(self.error(Problem::new(what, "post-line-longer-cure")));
        }
        Ok(self.text.finish())
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
                    let set = tongue.set(self, usize::from(*channel), *value, *at_once);
                    set.map_err(|problem| self.error(problem))?;
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
                    self.pending.push(' ');
                    self.pending.push_str(code);
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
        let what = Message::new("post-event-without-code").message("event", event.message());
        Err(Problem::new(what, cure))
    }

    /// Ends the line with a comment on its effect.
    fn remark(&mut self, event: &Event, at_once: bool) {
        let (name, on) = match event {
            Event::Arc(on) => ("arc", *on),
            Event::Gas(on) => ("gas", *on),
            Event::Wire(on) => ("wire", *on),
            _ => return self.text.end(),
        };
        self.text.remark(match (name, on, at_once) {
            ("arc", true, true) => "arc on",
            ("arc", true, false) => "arc on with the motion",
            ("arc", false, true) => "arc off",
            ("arc", false, false) => "arc stays off",
            ("gas", true, _) => "gas on",
            ("gas", false, _) => "gas off",
            (_, true, _) => "wire on",
            (_, false, _) => "wire off",
        });
        self.text.end();
    }

    fn go<T: Tongue>(&mut self, tongue: &mut T, step: &Move) -> Result<(), Problem> {
        let program = self.program;
        let to = program.row(step.row);
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

    /// Number of passes.
    pub(super) fn passes(&self) -> usize {
        self.program.steps.iter().filter(|step| matches!(step.what, What::Pass(_))).count()
    }

    /// Whether passes are sub-programs: if several of them do more than a move.
    pub(super) fn has_subs(&self) -> bool {
        let (mut welds, mut told) = (0, true);
        for step in &self.program.steps {
            match &step.what {
                What::Pass(_) => told = false,
                What::Move(m) if m.path != Path::Rapid && !told => {
                    told = true;
                    welds += 1;
                }
                _ => {}
            }
        }
        welds > 1
    }

    /// Whether channel `i` needs a word to get its value in `to`.
    pub(super) fn changes(&self, i: usize, to: &[f64]) -> bool {
        !self.known || to[i].to_bits() != self.here[i].to_bits()
    }

    /// X, Y and Z of a row as the control's arcs see them.
    pub(super) fn place(&self, row: &[f64]) -> DVec3 {
        DVec3::from_array(self.control.axes_xyz().map(|i| i.map_or(0.0, |i| row[i])))
    }

    /// The arc of a move from the end of the last one.
    pub(super) fn arc(&self, index: u32) -> Result<Arc, Problem> {
        let cure = "post-begin-with-line";
        let start = Problem::plain("post-arc-start-unknown", cure);
        let arc = self.program.arcs.get(index as usize).copied();
        if self.known { arc.ok_or_else(|| Problem::plain("post-arc-missing", cure)) } else { Err(start) }
    }

    /// Feed of a move to `to` along all axes, per minute (PMAC: per s); `None` if the feed counts no moving axis.
    pub(super) fn feed(&self, step: &Move, arc: Option<&Arc>, to: &[f64]) -> Option<f64> {
        if !self.known {
            return None;
        }
        let axes = &self.order[..self.program.axes()];
        let group = matches!(self.control.dialect, Dialect::Sinumerik | Dialect::Pmac).then_some(axes);
        let way = match step.path {
            Path::Curve(index) => {
                let rows = MoveRows { from: &self.here, to };
                self.program.evenly(self.program.curves[index as usize], rows).length()
            }
            _ => self.control.feed_way(group, arc, &self.here, to),
        };
        let per = if self.control.dialect == Dialect::Pmac { 1.0 } else { 60.0 };
        (way > 0.0).then_some(per * way / step.seconds)
    }
}
