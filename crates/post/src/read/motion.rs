//! Blocks that move: their end, path and duration.

use super::error::{Fault, Read, Span};
use super::modal_state::{FeedMode, Motion, State};
use super::target::How;
use crate::control::Dialect;
use crate::part_program::{Arc, ChannelKind, Curve, Level, Move, MoveRows, Path, What};
use crate::polynomial::POWERS;
use glam::DVec3;
use seamwright_message::Message;

/// Words of a block beside the channels.
#[derive(Debug, Clone, Default)]
pub(super) struct Block {
    /// The block's first byte and the one behind it.
    pub(super) span: Span,
    /// Centre of an arc: I, J and K.
    pub(super) centre: [Option<(f64, How, Span)>; 3],
    /// Point in between.
    pub(super) middle: [Option<(f64, How, Span)>; 3],
    pub(super) radius: Option<(f64, Span)>,
    /// Angle of an arc, degrees.
    pub(super) angle: Option<(f64, Span)>,
    /// Full turns beside the arc.
    pub(super) turns: Option<(u32, Span)>,
    /// Whether positions count from the machine's zero, regardless of the modal state.
    pub(super) machine_zero: bool,
    /// Whether the control stops at its end.
    pub(super) exact_stop: bool,
    /// Axis that PMAC's arcs turn about, if it is normal to no main plane.
    pub(super) normal: Option<DVec3>,
    /// Coefficients from the second power on of axes that are polynomials, and where they stand.
    pub(super) higher: Vec<(usize, [f64; POWERS], Span)>,
    /// Length of the polynomials' parameter.
    pub(super) parameter: Option<f64>,
}

pub(super) const INCH: f64 = 25.4;

impl Block {
    /// Position of the first word that only arcs have.
    pub(super) fn arc_word(&self) -> Option<Span> {
        let words = self.centre.iter().chain(&self.middle).flatten().map(|w| w.2);
        let others = [self.radius.map(|r| r.1), self.angle.map(|a| a.1), self.turns.map(|t| t.1)];
        words.chain(others.into_iter().flatten()).min_by_key(|s| s.from)
    }

    #[inline]
    pub(super) fn has_arc_word(&self) -> bool {
        self.centre.iter().any(Option::is_some)
            || self.radius.is_some()
            || self.middle.iter().any(Option::is_some)
            || self.angle.is_some()
            || self.turns.is_some()
    }
}

impl State<'_> {
    #[inline]
    pub(super) fn go(&mut self, block: &Block) -> Read {
        let arc_word = block.has_arc_word();
        if self.target.count == 0 && !arc_word {
            return Ok(());
        }
        let place = self.target.span().unwrap_or(block.span);
        let Some(motion) = self.motion else {
            return Err(Fault::new(place, "post-no-motion-mode").cure("post-no-motion-mode-cure"));
        };
        if arc_word && !motion.is_arc() {
            let span = block.arc_word().unwrap_or(block.span);
            return Err(Fault::new(span, "post-arc-word").allowed("post-arc-word-allowed"));
        }
        if let Some((_, _, span)) = block.higher.first().filter(|_| motion != Motion::Polynomial) {
            return Err(Fault::new(*span, "post-polynomial-without-poly").cure("post-polynomial-without-poly-cure"));
        }
        self.resolve(block)?;
        let lost = self.lost != [false; 3];
        if lost {
            self.find_again(motion, place)?;
        }
        let (path, seconds) = match motion {
            Motion::Rapid => (Path::Rapid, 0.0),
            Motion::Line => (Path::Line, self.seconds(None, place)?),
            Motion::Hermite => (self.speeds(block)?, self.seconds(None, place)?),
            Motion::Spline => (Path::Spline, self.seconds(None, place)?),
            Motion::Polynomial if block.higher.is_empty() => (Path::Line, self.seconds(None, place)?),
            Motion::Polynomial => {
                let curve = self.curve(block);
                let rows = MoveRows { from: &self.row, to: &self.next };
                let length = self.program.evenly(self.program.curves[curve as usize], rows).length();
                (Path::Curve(curve), self.timed(place, true, |_| length)?)
            }
            Motion::Clockwise | Motion::Counterclockwise | Motion::Through => {
                let arc = self.arc(motion, block)?;
                let seconds = self.seconds(Some(&arc), place)?;
                self.program.arcs.push(arc);
                (Path::Arc(self.program.arcs.len() as u32 - 1), seconds)
            }
        };
        let row = self.program.add_row(&self.next);
        let exact_stop = self.exact_stop || block.exact_stop;
        self.push(What::Move(Move { path, row, seconds, level: self.level, exact_stop }));
        std::mem::swap(&mut self.row, &mut self.next);
        Ok(())
    }

    /// Resolves the end of the block from its words and the modal state.
    #[inline]
    fn resolve(&mut self, block: &Block) -> Read {
        for channel in 0..self.row.len() {
            let here = self.row[channel];
            let Some(word) = self.target.get(channel) else {
                self.next[channel] = here;
                continue;
            };
            let value = if self.inch && self.is_length(channel) { INCH * word.value } else { word.value };
            let modal = if self.incremental && !block.machine_zero { How::Increment } else { How::Absolute };
            let turn = |to: f64| (to - here).rem_euclid(360.0);
            self.next[channel] = match if word.how == How::Modal { modal } else { word.how } {
                How::Increment => here + value,
                How::Nearest => here + (turn(value + 180.0) - 180.0),
                How::Upwards => here + turn(value),
                How::Downwards => here - (here - value).rem_euclid(360.0),
                How::Absolute | How::Modal => value,
            };
            let turned = matches!(word.how, How::Nearest | How::Upwards | How::Downwards);
            if turned && self.program.channels[channel].kind != ChannelKind::Rotary {
                return Err(Fault::new(word.span, "post-rotary-words").allowed("post-rotary-words-allowed"));
            }
        }
        Ok(())
    }

    /// After a change of the level X, Y and Z follow from the kinematics: a block must give all three.
    fn find_again(&mut self, motion: Motion, place: Span) -> Read {
        let said = |k: usize| {
            self.addresses.xyz[k].and_then(|channel| self.target.get(channel)).is_some_and(|w| match w.how {
                How::Modal => !self.incremental,
                how => how != How::Increment,
            })
        };
        let all = (0..3).all(said);
        let counted = self.mode == FeedMode::PerMinute && motion != Motion::Rapid;
        if !all || counted || !matches!(motion, Motion::Rapid | Motion::Line) {
            let tip = self.level == Level::Tip;
            let message = if tip { "post-start-unknown-tip" } else { "post-start-unknown-axes" };
            let cure = "post-start-unknown-cure";
            return Err(Fault::new(place, message).cure(cure));
        }
        self.lost = [false; 3];
        Ok(())
    }

    /// Duration of a line or an arc by the control's rule, s.
    #[inline]
    fn seconds(&mut self, arc: Option<&Arc>, place: Span) -> Read<f64> {
        let moves = arc.is_some() || self.row != self.next;
        self.timed(place, moves, |state| state.way(arc))
    }

    /// Duration of a block with the length `way`, s.
    #[inline]
    fn timed(&mut self, place: Span, moves: bool, way: impl FnOnce(&mut Self) -> f64) -> Read<f64> {
        let Some(feed) = self.feed else { return Err(self.no_feed(place)) };
        let seconds = match self.mode {
            FeedMode::Time => return Ok(feed.max(self.least_time)),
            _ if !moves => 0.0,
            FeedMode::InverseTime if self.control.dialect == Dialect::Linuxcnc => {
                self.control.inverse_time(feed, way(self))
            }
            FeedMode::InverseTime => self.control.inverse_time(feed, 0.0),
            FeedMode::PerMinute => {
                // LinuxCNC counts degrees alone without linear motion: those are not in inches.
                let linear = (0..self.row.len()).any(|i| self.is_length(i) && (self.row[i] - self.next[i]).abs() > 0.0);
                let in_inches = self.inch_feed && (linear || self.control.dialect != Dialect::Linuxcnc);
                let feed = if in_inches { INCH * feed } else { feed };
                self.control.per_minute(feed, way(self))
            }
        };
        Ok(seconds.max(self.least_time))
    }

    /// The way that the feed counts. If none of the counted axes moves, that of all that do.
    fn way(&mut self, arc: Option<&Arc>) -> f64 {
        let way = self.rule.way(arc, &self.row, &self.next);
        if way > 0.0 || self.control.dialect == Dialect::Linuxcnc {
            return way;
        }
        self.note("post-feed-counts-none");
        let square = |i: usize| if self.is_interpolated(i) { (self.next[i] - self.row[i]).powi(2) } else { 0.0 };
        (0..self.row.len()).map(square).sum::<f64>().sqrt()
    }

    /// The polynomials of the block's axes. If none of the counted axes moves, all that do are counted.
    fn curve(&mut self, block: &Block) -> u32 {
        let length = block.parameter.unwrap_or(1.0);
        let mut rows: [Vec<f64>; POWERS] = std::array::from_fn(|_| vec![0.0; self.row.len()]);
        for (channel, higher, _) in &block.higher {
            let unit = if self.inch && self.is_length(*channel) { INCH } else { 1.0 };
            for (k, row) in rows.iter_mut().enumerate() {
                row[*channel] = unit * higher[k] * length.powi(k as i32 + 2);
            }
        }
        let index = self.program.add_curve(&rows, self.rule.counted());
        let curve = self.program.curves[index as usize];
        if self.program.evenly(curve, MoveRows { from: &self.row, to: &self.next }).length() <= 0.0 {
            self.note("post-feed-counts-none");
            let all = (1u64 << self.program.axes()) - 1;
            self.program.curves[index as usize] = Curve { counted: all, ..curve };
        }
        index
    }

    #[cold]
    fn no_feed(&self, place: Span) -> Box<Fault> {
        match (self.control.dialect, self.mode) {
            (Dialect::Pmac, _) => Fault::new(place, "post-speed-missing").cure("post-speed-missing-cure"),
            (Dialect::Linuxcnc | Dialect::Grblhal, FeedMode::InverseTime) => {
                Fault::new(place, "post-feed-missing").cure("post-feed-missing-inverse-time")
            }
            _ => Fault::new(place, "post-feed-missing").cure("post-feed-missing-cure"),
        }
    }

    /// PVT's row of speeds at the block's end.
    fn speeds(&mut self, block: &Block) -> Read<Path> {
        let mut speeds = vec![0.0; self.row.len()];
        for (channel, speed) in speeds.iter_mut().enumerate().take(self.program.axes()) {
            let Some(word) = self.target.get(channel) else {
                let address = &self.control.addresses[channel];
                let message = Message::new("post-pvt-axis-missing").text("address", address);
                return Err(Fault::new(block.span, message).allowed("post-pvt-axis-missing-allowed"));
            };
            let missing = || Fault::new(word.span, "post-pvt-speed-missing").allowed("post-pvt-speed-allowed");
            *speed = word.speed.ok_or_else(missing)?;
        }
        Ok(Path::Hermite(self.program.add_row(&speeds)))
    }
}
