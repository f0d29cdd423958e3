//! Whole turns of rotary axes at the start of a pass.
//!
//! Each pass starts on the turn nearest to the end of the one before: an axis without end stops turns on from pass to
//! pass. An axis with a range unwinds only where a pass would leave it, and then so far that as many of the later passes
//! as possible follow without unwinding again. If all passes fit into the range, the first one starts on a turn from
//! which they do.

use crate::joint_path::JointPath;
use crate::pass_motion::Request;
use seamwright_machine::{Axis, AxisKind, Machine};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// Travel of the passes after one, in lengths of its own in its own direction: how far they go beyond its end.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct LaterTravel {
    /// At most backwards, not above 0.
    back: f64,
    /// At most onwards, not below 0.
    on: f64,
}

impl LaterTravel {
    /// Passes along the seam after that of `request`, as if an axis turned by path length alike in all of them.
    fn after(request: &Request) -> Self {
        let (own, mut at) = (request.path.length(), 0.0);
        let mut later = Self::default();
        for (path, pass) in request.weld.iter().skip(request.number).filter(|(_, pass)| pass.points.is_none()) {
            let sense = if pass.reverse == request.pass.reverse { 1.0 } else { -1.0 };
            at += sense * path.length() / own;
            later = Self { back: later.back.min(at), on: later.on.max(at) };
        }
        later
    }

    /// The positions of an axis in these passes too, if it goes from the one to the other position in its own.
    fn positions(self, own: &RangeInclusive<f64>, (from, to): (f64, f64)) -> RangeInclusive<f64> {
        let ends = [self.back, self.on].map(|lengths| to + lengths * (to - from));
        own.start().min(ends[0]).min(ends[1])..=own.end().max(ends[0]).max(ends[1])
    }
}

impl JointPath {
    /// Turns rotary axes by whole turns so that the path follows the previous pass and stays in their ranges.
    pub(crate) fn turn_to_start(&mut self, machine: &Machine, request: &Request) {
        let later = LaterTravel::after(request);
        let (start, end) = (self.at(0.0), self.at(self.length()));
        for (i, axis) in machine.axes.iter().enumerate().filter(|(_, a)| a.kind == AxisKind::Rotary) {
            let wanted = request.last.map_or(0.0, |last| ((last[i] - start[i]) / TAU).round());
            let turns = match axis.range {
                None => wanted,
                // A table of pitch errors is not periodic: its turns differ.
                Some(_) if axis.pitch_error.is_some() => 0.0,
                Some(_) => {
                    let own = self.extremes(i);
                    let all = later.positions(&own, (start[i], end[i]));
                    let is_first = request.last.is_none();
                    turns_in_range(axis, Positions { own, all, onwards: end[i] > start[i] }, wanted, is_first)
                }
            };
            self.turn(i, turns);
        }
    }
}

/// Positions of an axis before whole turns are added.
struct Positions {
    /// Those of the pass.
    own: RangeInclusive<f64>,
    /// Those of the pass and of the later ones.
    all: RangeInclusive<f64>,
    /// True if it turns in the positive direction.
    onwards: bool,
}

/// Whole turns that keep a pass in the range of `axis`: the `wanted` ones if they do; 0 if none do.
fn turns_in_range(axis: &Axis, positions: Positions, wanted: f64, is_first: bool) -> f64 {
    let Positions { own, all, onwards } = positions;
    let nearest = axis.turns_within(own.clone(), wanted);
    let for_all = || axis.turns_within(all.clone(), wanted);
    match nearest {
        None => 0.0,
        Some(nearest) if is_first => for_all().unwrap_or(nearest),
        Some(nearest) if (nearest - wanted).abs() < 0.5 || all == own => nearest,
        // It has to unwind: as far as the later passes need, or as far as it can.
        Some(nearest) => {
            let far = if onwards { f64::NEG_INFINITY } else { f64::INFINITY };
            for_all().or_else(|| axis.turns_within(own, far)).unwrap_or(nearest)
        }
    }
}
