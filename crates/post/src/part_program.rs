//! A part program as data: commands to a control, in order, in no dialect. Posts write it, readers make it, the proof
//! plays it.

use crate::polynomial::{Evenly, POWERS, Polynomial};
use glam::{DQuat, DVec3};
use seamwright_message::Message;
use std::f64::consts::TAU;

/// Meaning of one number of a row.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Name of the axis (in the machine file) or of the process value.
    pub name: String,
    /// Change of its value from one row to the next.
    pub kind: ChannelKind,
}

/// Change of a channel's value from one row to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChannelKind {
    /// A linear axis, mm, interpolated.
    Linear,
    /// A rotary axis, degrees, interpolated.
    Rotary,
    /// A process value that is interpolated like an axis and reaches its value at the block's end.
    Interpolated,
    /// A process value that has its value from the start of the block on.
    Stepped,
}

/// A part program. Rows are positions of all axes in the machine file's order (mm, degrees), then process values. Every
/// row is complete: channels that a block does not name keep their value.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PartProgram {
    /// Title, for people.
    pub title: String,
    /// Channels of a row.
    pub channels: Vec<Channel>,
    /// Steps in the order of execution.
    pub steps: Vec<Step>,
    /// Arcs that moves go along.
    pub arcs: Vec<Arc>,
    /// Curves that moves go along.
    pub curves: Vec<Curve>,
    rows: Vec<f64>,
}

/// A line of a part program.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Line of the text it was read from, counted from 1; 0 if it was not read.
    pub line: u32,
    /// Block number, if it has one.
    pub number: Option<u32>,
    /// Effect of the step.
    pub what: What,
}

/// Effect of a step.
#[derive(Debug, Clone, PartialEq)]
pub enum What {
    /// Start of a pass, with its name: the program can be started again from here.
    Pass(Box<str>),
    /// The axes move.
    Move(Move),
    /// Sets a process value: `at_once`, or with the start of the next move.
    Set {
        /// Index of the channel.
        channel: u16,
        /// Its value.
        value: f64,
        /// Whether it is set without waiting for a move.
        at_once: bool,
    },
    /// Switches an output or shows a message: `at_once`, or with the start of the next move.
    Event {
        /// The output or message.
        event: Event,
        /// Whether it does not wait for a move.
        at_once: bool,
    },
    /// Dwell without motion, s.
    Dwell(f64),
    /// A remark.
    Comment(Box<str>),
}

/// Output that is switched, or message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Event {
    /// Arc or beam on or off.
    Arc(bool),
    /// Shielding gas on or off.
    Gas(bool),
    /// Wire feeder on or off.
    Wire(bool),
    /// A digital output on or off.
    Output(u16, bool),
    /// Words for the operator.
    Message(Box<str>),
    /// A code of the machine's own, by the name that the machine file gives it.
    Call(Box<str>),
}

impl Event {
    pub(crate) fn message(&self) -> Message {
        let switched = |on: bool, codes: [&'static str; 2]| Message::new(codes[usize::from(on)]);
        match self {
            Self::Arc(on) => switched(*on, ["post-arc-off", "post-arc-on"]),
            Self::Gas(on) => switched(*on, ["post-gas-off", "post-gas-on"]),
            Self::Wire(on) => switched(*on, ["post-wire-off", "post-wire-on"]),
            Self::Output(number, on) => {
                switched(*on, ["post-output-off", "post-output-on"]).text("number", number.to_string())
            }
            Self::Message(text) | Self::Call(text) => Message::new("post-quoted").text("text", text.as_ref()),
        }
    }
}

/// One block of motion, from where the one before ended to its row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// The way there.
    pub path: Path,
    /// Index of the row it ends at.
    pub row: u32,
    /// Duration by the control's own rule for feeds, s; 0 for a rapid move.
    pub seconds: f64,
    /// Level of interpolation.
    pub level: Level,
    /// Whether the control stops at the end of the move.
    pub exact_stop: bool,
}

/// Rows of all channels at the start and the end of a move.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MoveRows<'a> {
    pub(crate) from: &'a [f64],
    pub(crate) to: &'a [f64],
}

/// Level at which the control interpolates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// The axes themselves.
    Joint,
    /// The torch tip in the work frame, and the rotary axes: X, Y and Z of a row are the tip's position.
    Tip,
}

/// The way from row to row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// All channels go at the axes' own speeds.
    Rapid,
    /// All channels go evenly.
    Line,
    /// X, Y and Z go along this arc of [`PartProgram::arcs`], evenly by its angle; all else goes evenly.
    Arc(u32),
    /// Each axis is a cubic in time with given speeds at both ends. This row has those at the end, per s. The speeds at
    /// the start are those at the end of the move before if that is one of these, else 0. PMAC's PVT.
    Hermite(u32),
    /// Uniform cubic B-spline: a run of these with equal times has their rows as its control points, the first and last
    /// ones three times. PMAC's SPLINE1.
    Spline,
    /// The axes go along this curve of [`PartProgram::curves`]: polynomials of a parameter. Sinumerik's POLY.
    Curve(u32),
}

/// Polynomials of all axes in a block, by a parameter from 0 at the start to 1 at the end. Of the rows from `row` on
/// the first has the coefficients of the second power, the next those of the third, up to the fifth. Lower powers
/// follow from start and end. The control goes evenly by the way of the axes that the feed counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Curve {
    /// Index of the first of its [`POWERS`] rows.
    pub row: u32,
    /// A bit for each channel that the feed counts.
    pub counted: u64,
}

/// An arc or helix of X, Y and Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// A point on its axis, mm.
    pub centre: DVec3,
    /// Unit vector along its axis.
    pub normal: DVec3,
    /// Angle it turns by about the axis by the right-hand rule, rad; a full circle 2 pi, a helix may have more.
    pub sweep: f64,
}

impl Arc {
    /// Angle from `start` to `end` about the axis along `normal` through `centre` by the right-hand rule, rad, less than
    /// a turn.
    pub(crate) fn angle(start: DVec3, end: DVec3, centre: DVec3, normal: DVec3) -> f64 {
        let [from, to] = [start, end].map(|p| (p - centre).reject_from_normalized(normal));
        from.cross(to).dot(normal).atan2(from.dot(to)).rem_euclid(TAU)
    }

    /// Position at the part `f` of the way from `start` to `end`, which are both on it: by that part of the angle round
    /// the axis, and by that part of the ends' differences along the axis and outwards.
    pub fn at(&self, start: DVec3, end: DVec3, f: f64) -> DVec3 {
        let across = |p: DVec3| {
            let away = p - self.centre;
            (away.dot(self.normal), away.reject_from_normalized(self.normal))
        };
        let ((h0, r0), (h1, r1)) = (across(start), across(end));
        let (radius, last) = (r0.length(), r1.length());
        let growth = if radius > 0.0 { 1.0 + f * (last / radius - 1.0) } else { 1.0 };
        let turned = DQuat::from_axis_angle(self.normal, f * self.sweep) * r0;
        self.centre + (h0 + f * (h1 - h0)) * self.normal + growth * turned
    }
}

impl PartProgram {
    /// An empty one with these channels.
    pub fn new(title: &str, channels: Vec<Channel>) -> Self {
        Self { title: title.to_owned(), channels, ..Self::default() }
    }

    /// Reserves memory for so many moves, so that a long program is not copied while it grows.
    pub(crate) fn reserve(&mut self, moves: usize) {
        self.steps.reserve(moves);
        self.rows.reserve(moves * self.channels.len());
    }

    /// Adds a row of all channels and gives its index.
    pub fn add_row(&mut self, row: &[f64]) -> u32 {
        debug_assert_eq!(row.len(), self.channels.len());
        let index = self.rows.len() / self.channels.len().max(1);
        self.rows.extend_from_slice(row);
        u32::try_from(index).unwrap_or(u32::MAX)
    }

    /// Row number `index`.
    pub fn row(&self, index: u32) -> &[f64] {
        let width = self.channels.len();
        &self.rows[index as usize * width..][..width]
    }

    /// Axis `channel` along a curve.
    pub(crate) fn polynomial(&self, curve: Curve, channel: usize, rows: MoveRows) -> Polynomial {
        let higher = std::array::from_fn(|k| self.row(curve.row + k as u32)[channel]);
        Polynomial { from: rows.from[channel], to: rows.to[channel], higher }
    }

    /// The parameter of a curve, by its even feed.
    pub(crate) fn evenly(&self, curve: Curve, rows: MoveRows) -> Evenly {
        let counted = (0..self.axes()).filter(|channel| curve.counted >> channel & 1 == 1);
        Evenly::new(counted.map(|channel| self.polynomial(curve, channel, rows)))
    }

    /// Adds a curve: of each power from 2 on a row of all channels.
    pub(crate) fn add_curve(&mut self, higher: &[Vec<f64>; POWERS], counted: u64) -> u32 {
        let rows = higher.each_ref().map(|row| self.add_row(row));
        self.curves.push(Curve { row: rows[0], counted });
        self.curves.len() as u32 - 1
    }

    /// Adds a step that was not read from a text.
    pub fn push(&mut self, what: What) {
        self.steps.push(Step { line: 0, number: None, what });
    }

    /// Number of axes: the channels before the process values.
    pub fn axes(&self) -> usize {
        self.channels.iter().take_while(|c| matches!(c.kind, ChannelKind::Linear | ChannelKind::Rotary)).count()
    }

    /// Channels of X, Y and Z, which arcs are in; a machine without one of them has 0 there.
    pub fn xyz(&self) -> Xyz {
        Xyz(["x", "y", "z"].map(|name| self.channels.iter().position(|c| c.name == name)))
    }
}

/// Channels of X, Y and Z.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Xyz([Option<usize>; 3]);

impl Xyz {
    /// The position of a row, mm.
    pub fn of(self, row: &[f64]) -> DVec3 {
        DVec3::from_array(self.0.map(|channel| channel.map_or(0.0, |i| row[i])))
    }

    /// Writes a position into a row.
    pub fn put(self, row: &mut [f64], place: DVec3) {
        for (channel, value) in self.0.into_iter().zip(place.to_array()) {
            if let Some(i) = channel {
                row[i] = value;
            }
        }
    }
}
