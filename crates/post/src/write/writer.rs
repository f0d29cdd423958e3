use super::options::WriteOptions;
use super::text::Text;
use crate::control::{Control, Dialect};
use crate::error::Error;
use crate::part_program::{Arc, ChannelKind, Level, Move, MoveRows, PartProgram, Path, Step, What};
use glam::DVec3;
use seamwright_message::Message;

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
    pub(super) level: Option<Level>,
    /// Whether the control needs words for levels.
    pub(super) tells_level: bool,
    /// Step under way.
    pub(super) at: usize,
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

    fn checked(mut self) -> Result<Self, Error> {
        if self.program.channels != self.control.channels {
            return Err(self.error(Problem::plain("post-other-channels", "post-other-channels-cure")));
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
                return Err(self.error(Problem::plain("post-tip-to-axes", "post-tip-to-axes-cure")));
            }
        }
        Ok(self)
    }

    /// `problem` with the step and the pass that it is in.
    pub(super) fn error(&self, problem: Problem) -> Error {
        let pass = self.program.steps.iter().take(self.at + 1).rev().find_map(|step| match &step.what {
            What::Pass(name) => Some(name.to_string()),
            _ => None,
        });
        Error::Unwritable { step: self.at + 1, pass, what: problem.what, cure: Message::new(problem.cure) }
    }

    pub(super) fn finish(self) -> Result<String, Error> {
        let (fits, longest) = self.text.fits();
        if !fits {
            let what = Message::new("post-line-longer").count("max", longest);
            return Err(self.error(Problem::new(what, "post-line-longer-cure")));
        }
        Ok(self.text.finish())
    }

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

    /// The words of a row that have changed or are asked for.
    pub(super) fn words(&mut self, to: &[f64], asked: impl Fn(usize) -> bool) {
        for k in 0..self.order.len() {
            let i = self.order[k];
            if self.changes(i, to) || asked(i) {
                self.text.valued(&self.control.addresses[i], to[i]);
            }
        }
    }

    /// `opening` and the addresses of all axes in brackets.
    pub(super) fn all_axes(&mut self, opening: &str) {
        let axes = self.order[..self.program.axes()].iter().map(|i| self.control.addresses[*i].as_str());
        let list = axes.collect::<Vec<_>>().join(",");
        self.text.word(opening);
        self.text.glue(&list);
        self.text.glue(")");
    }

    /// Adds `word` to the next move.
    pub(super) fn with_next_move(&mut self, word: &str) {
        self.pending.push(' ');
        self.pending.push_str(word);
    }

    /// Adds the words that wait for the move, and ends the line.
    pub(super) fn end_move(&mut self) {
        self.text.glue(&self.pending);
        self.pending.clear();
        self.text.end();
    }

    /// X, Y and Z of a row as the control's arcs see them.
    pub(super) fn place(&self, row: &[f64]) -> DVec3 {
        DVec3::from_array(self.control.axes_xyz().map(|i| i.map_or(0.0, |i| row[i])))
    }

    /// The arc of a move from the end of the last one.
    pub(super) fn arc(&self, index: u32) -> Result<Arc, Problem> {
        let arc = self.program.arcs.get(index as usize).copied().ok_or("post-arc-missing");
        let arc = if self.known { arc } else { Err("post-arc-start-unknown") };
        arc.map_err(|what| Problem::plain(what, "post-begin-with-line"))
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
                self.program.evenly(self.program.curves[index as usize], MoveRows { from: &self.here, to }).length()
            }
            _ => self.control.feed_way(group, arc, &self.here, to),
        };
        let per = if self.control.dialect == Dialect::Pmac { 1.0 } else { 60.0 };
        (way > 0.0).then_some(per * way / step.seconds)
    }
}
