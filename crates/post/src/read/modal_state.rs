//! Modal state of a control between blocks, and the part program read so far.

use super::addresses::Addresses;
use super::error::{Fault, Read, Span, floor_char};
use super::expression::Expressions;
use super::lexer::Cursor;
use super::lines::Flow;
use super::options::{LeftOut, ReadOptions};
use super::programs::remark;
use super::target::{Target, put_once};
use crate::control::{Code, Control};
use crate::feed::FeedRule;
use crate::part_program::{ChannelKind, Event, Level, PartProgram, Step, What};
use seamwright_message::Message;

/// Motion mode of the axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    Rapid,
    Line,
    /// Clockwise, seen against the plane's normal.
    Clockwise,
    Counterclockwise,
    /// Through a point in between.
    Through,
    /// PMAC's PVT.
    Hermite,
    /// PMAC's SPLINE1.
    Spline,
    /// Sinumerik's POLY.
    Polynomial,
}

impl Motion {
    pub(super) fn is_arc(self) -> bool {
        matches!(self, Self::Clockwise | Self::Counterclockwise | Self::Through)
    }
}

/// Meaning of F.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedMode {
    /// Blocks a minute.
    InverseTime,
    /// mm a minute (PMAC: a second).
    PerMinute,
    /// The time itself, s: PMAC's TM.
    Time,
}

/// Something that waits for the end of its line, where it is known whether the line moves.
#[derive(Debug)]
enum Pending {
    Set(usize, f64),
    Event(Event),
}

/// The state between blocks.
pub(super) struct State<'a> {
    pub(super) control: &'a Control,
    pub(super) addresses: Addresses,
    pub(super) expressions: Expressions,
    pub(super) program: PartProgram,
    pub(super) notes: Vec<Message>,
    pub(super) left_out: Vec<LeftOut>,
    noted: Vec<&'static str>,
    lenient: bool,
    pending: Vec<Pending>,
    /// Line that is read, and its first byte.
    pub(super) line: u32,
    pub(super) line_start: usize,
    /// Whether that is one of a sub-program.
    pub(super) inside: bool,
    /// Block number of the line.
    pub(super) number: Option<u32>,
    /// Commanded position of the axes, and the end of the block.
    pub(super) row: Vec<f64>,
    pub(super) next: Vec<f64>,
    pub(super) target: Target,
    pub(super) motion: Option<Motion>,
    /// X, Y or Z: the axis that the plane of arcs is square to.
    pub(super) plane: usize,
    pub(super) inch: bool,
    /// Whether F is in inches too.
    pub(super) inch_feed: bool,
    pub(super) incremental: bool,
    /// Whether I, J and K are absolute.
    pub(super) absolute_centre: bool,
    pub(super) mode: FeedMode,
    pub(super) feed: Option<f64>,
    /// Minimum time of a block, s: PMAC's TA and TS.
    pub(super) least_time: f64,
    pub(super) rule: FeedRule,
    pub(super) exact_stop: bool,
    pub(super) level: Level,
    /// X, Y and Z that are unknown since the level changed.
    pub(super) lost: [bool; 3],
}

impl<'a> State<'a> {
    pub(super) fn new(control: &'a Control, options: &ReadOptions) -> Self {
        let width = control.channels.len();
        let mut row = options.start.clone().unwrap_or_default();
        row.resize(width, 0.0);
        Self {
            control,
            addresses: Addresses::new(control),
            expressions: Expressions::new(control.dialect),
            program: PartProgram::new("", control.channels.clone()),
            notes: Vec::new(),
            left_out: Vec::new(),
            noted: Vec::new(),
            lenient: options.lenient,
            pending: Vec::new(),
            line: 1,
            line_start: 0,
            inside: false,
            number: None,
            next: row.clone(),
            row,
            target: Target::new(width),
            motion: None,
            plane: 2,
            inch: false,
            inch_feed: false,
            incremental: false,
            absolute_centre: false,
            mode: FeedMode::PerMinute,
            feed: None,
            least_time: 0.0,
            rule: control.feed_rule(None),
            exact_stop: false,
            level: options.level,
            lost: [false; 3],
        }
    }

    #[inline]
    pub(super) fn push(&mut self, what: What) {
        self.program.steps.push(Step { line: self.line, number: self.number, what });
    }

    /// A remark; the first one of the text, before anything else, is the title.
    pub(super) fn comment(&mut self, text: &str) {
        if text.is_empty() || text.starts_with("$PATH=") {
            return;
        }
        if self.program.title.is_empty() && self.program.steps.is_empty() {
            text.clone_into(&mut self.program.title);
        } else {
            self.push(What::Comment(text.into()));
        }
    }

    /// A remark from the text `marks` bytes behind the cursor to the end of the line.
    pub(super) fn comment_behind(&mut self, marks: usize, c: &mut Cursor) -> Read {
        c.at += marks;
        self.comment(c.rest());
        Ok(())
    }

    /// Reads the block's number.
    pub(super) fn read_number(&mut self, c: &mut Cursor, from: usize) -> Read {
        let number = c.whole()?;
        put_once(&mut self.number, number, c.since(from))
    }

    /// Starts a pass at a block number that is alone in its line, except for a remark, which names the pass.
    pub(super) fn pass_at_number(&mut self, c: &mut Cursor, from: usize) {
        let mut ahead = *c;
        let name = remark(&mut ahead);
        ahead.blanks();
        if ahead.is_done() {
            let number = c.of(c.since(from)).trim();
            *c = ahead;
            self.pass(if name.is_empty() { number } else { name });
        }
    }

    /// Ends the line with M0, M1 or another stop.
    pub(super) fn stop(&mut self, code: Option<u32>) -> Option<Flow> {
        match code? {
            0 => self.event(Event::Message("stop".into()), true),
            1 => self.event(Event::Message("optional stop".into()), true),
            17 => return Some(Flow::Return),
            _ => return Some(Flow::End),
        }
        None
    }

    /// Adds a note for the user, once for each `code`.
    pub(super) fn note(&mut self, code: &'static str) {
        if !self.noted.contains(&code) {
            self.noted.push(code);
            let note = Message::new("post-note").text("line", self.line.to_string());
            self.notes.push(note.message("note", Message::new(code)));
        }
    }

    /// Leaves out text that is not understood if the reader is lenient, else returns the fault. The cursor continues
    /// behind it.
    pub(super) fn leave_out(&mut self, fault: Box<Fault>, c: &mut Cursor) -> Read {
        if !(self.lenient && fault.unknown) {
            return Err(fault);
        }
        if c.at < fault.span.to {
            c.at = fault.span.to;
        }
        let before = fault.span.from.min(c.at);
        c.skip_word();
        if c.at == before {
            c.at = c.here().to.max(before);
        }
        let from = floor_char(c.text, fault.span.from);
        self.left_out.push(LeftOut {
            line: self.line as usize,
            column: c.of(Span { from: self.line_start, to: from }).chars().count() + 1,
            text: c.of(Span { from, to: c.at }).trim().to_owned(),
            why: fault.message,
        });
        Ok(())
    }

    pub(super) fn set(&mut self, channel: usize, value: f64, at_once: bool) {
        self.row[channel] = value;
        self.push(What::Set { channel: channel as u16, value, at_once });
    }

    pub(super) fn event(&mut self, event: Event, at_once: bool) {
        self.push(What::Event { event, at_once });
    }

    /// Whether the arc was switched on last.
    pub(super) fn is_burning(&self) -> bool {
        let arc = self.program.steps.iter().rev().find_map(|step| match step.what {
            What::Event { event: Event::Arc(on), .. } => Some(on),
            _ => None,
        });
        arc == Some(true)
    }

    pub(super) fn switch(&mut self, output: u16, on: bool, at_once: bool) {
        let io = &self.control.io;
        let is = |named: Option<u8>| named.map(u16::from) == Some(output);
        let event = match () {
            () if is(io.arc) => Event::Arc(on),
            () if is(io.gas) => Event::Gas(on),
            () if is(io.wire) => Event::Wire(on),
            () => Event::Output(output, on),
        };
        self.event(event, at_once);
    }

    /// Switches a digital output by its value, 0 or 1.
    pub(super) fn switch_by_value(&mut self, output: u16, value: f64, at_once: bool, span: Span) -> Read {
        let on = value > 0.5;
        if (value - f64::from(u8::from(on))).abs() > 1e-9 {
            return Err(Fault::new(span, "post-digital-value").allowed("post-digital-value-allowed"));
        }
        self.switch(output, on, at_once);
        Ok(())
    }

    pub(super) fn set_output(&mut self, output: u32, value: f64, at_once: bool, span: Span) -> Read {
        let channel = self.control.outputs.iter().position(|o| o.map(u32::from) == Some(output));
        let Some(channel) = channel else {
            let known: Vec<String> = self.control.outputs.iter().flatten().map(ToString::to_string).collect();
            return Err(Fault::unknown(span, Message::new("post-no-process-value").text("output", output.to_string()))
                .allowed(match known.is_empty() {
                    true => Message::new("post-none-on-machine"),
                    false => Message::verbatim(known.join(" ")),
                })
                .cure("post-process-value-cure"));
        };
        self.set(channel, value, at_once);
        Ok(())
    }

    /// Sets a channel at the line's end, when it is known whether the line moves.
    pub(super) fn set_later(&mut self, channel: usize, value: f64) {
        self.pending.push(Pending::Set(channel, value));
    }

    pub(super) fn event_later(&mut self, event: Event) {
        self.pending.push(Pending::Event(event));
    }

    /// Executes the settings that waited for the line's end: with its move if it `moves`, else at once.
    #[inline]
    pub(super) fn flush(&mut self, moves: bool) {
        if self.pending.is_empty() {
            return;
        }
        for pending in std::mem::take(&mut self.pending) {
            match pending {
                Pending::Set(channel, value) => self.set(channel, value, !moves),
                Pending::Event(event) => self.event(event, !moves),
            }
        }
    }

    /// The machine's own code, if this is one: `number` in tenths.
    pub(super) fn own_code(&mut self, letter: u8, number: u32) -> bool {
        match self.addresses.code(letter, number) {
            Some(Code::Event(event)) => {
                self.event_later(event.clone());
            }
            Some(Code::ExactStop) => self.exact_stop = true,
            Some(Code::ContinuousPath) => self.exact_stop = false,
            None => return false,
        }
        true
    }

    /// Switches the control to this level: X, Y and Z are unknown until a block gives them.
    pub(super) fn switch_level(&mut self, level: Level, span: Span) -> Read {
        if level != self.level {
            if self.addresses.xyz.contains(&None) {
                return Err(Fault::new(span, "post-no-tip-axes"));
            }
            self.lost = [true; 3];
        }
        self.level = level;
        Ok(())
    }

    /// A dwell; one of no time right behind a move is that move's exact stop if `marks`.
    pub(super) fn dwell(&mut self, seconds: f64, marks: bool, span: Span) -> Read {
        if !(0.0..=1e6).contains(&seconds) {
            return Err(Fault::new(span, "post-dwell-time").allowed("post-dwell-allowed"));
        }
        let mut steps = self.program.steps.iter_mut().rev();
        if marks
            && seconds <= 0.0
            && let Some(Step { what: What::Move(last), .. }) = steps.find(|s| !matches!(s.what, What::Comment(_)))
        {
            last.exact_stop = true;
            return Ok(());
        }
        self.push(What::Dwell(seconds));
        Ok(())
    }

    /// Checks the value of F or TM.
    pub(super) fn check_feed(value: f64, span: Span) -> Read {
        if value <= 0.0 {
            return Err(Fault::new(span, "post-feed-not-positive"));
        }
        if !(1e-6..=1e9).contains(&value) {
            return Err(Fault::new(span, "post-feed-out-of-range").allowed("post-feed-allowed"));
        }
        Ok(())
    }

    /// Changes the meaning of F; F must then be given anew, as all the controls need it.
    pub(super) fn set_mode(&mut self, mode: FeedMode) {
        if self.mode != mode {
            self.feed = None;
        }
        self.mode = mode;
    }

    /// Whether lengths of this channel are in inches when the program is.
    pub(super) fn is_length(&self, channel: usize) -> bool {
        self.program.channels[channel].kind == ChannelKind::Linear
    }

    /// Whether this channel is an axis or a value that goes with the axes.
    pub(super) fn is_interpolated(&self, channel: usize) -> bool {
        self.program.channels[channel].kind != ChannelKind::Stepped
    }
}
