use super::alarm_list::Place;
use super::device_interface::VALUES;
use super::reduced_speed::hand;
use seamwright_machine::{AxisSet, Joints, Machine, Surroundings};
use seamwright_message::Message;
use seamwright_motion::feed_override::{ChannelLimits, PassTimed, channel_limits};
use seamwright_motion::jog::Jog;
use seamwright_motion::transfer::{TransferMove, route};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{ArcTime, AtHold, Pass, Sequence};
use std::cell::RefCell;

/// Starting point of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// The transfer move to the start, from the current axis positions.
    pub approach: TransferMove,
    /// The pass, counted from 0.
    pub pass: usize,
    /// Path length up to which that pass is welded, mm; it starts earlier by the overlap of its sequence.
    pub welded_mm: f64,
}

impl Start {
    /// Starts the whole program, from home.
    pub fn at_home(motion: &WeldMotion) -> Self {
        let approach = motion.transfers.first().cloned().unwrap_or(TransferMove {
            legs: Vec::new(),
            retracts: false,
            approaches: false,
        });
        Self { approach, pass: 0, welded_mm: 0.0 }
    }

    /// Continues from `place`, the end of the welded part, with the axes at `from`.
    ///
    /// # Errors
    /// If there is no collision-free transfer move.
    pub fn at_place(
        machine: &Machine,
        around: &Surroundings<'_>,
        motion: &WeldMotion,
        from: &Joints,
        place: Place,
    ) -> Result<Self, Message> {
        let pass = place.pass.saturating_sub(1).min(motion.passes.len().saturating_sub(1));
        let path = &motion.passes[pass].path;
        let welded_mm = place.s_mm.clamp(0.0, path.length());
        let points = route(machine, around, from, &path.at(welded_mm), AxisSet::default())?;
        Ok(Self { approach: TransferMove::new(machine, &points), pass, welded_mm })
    }
}

/// A pass, ready to run.
#[derive(Debug)]
pub(super) struct PassWork<'a> {
    pub(super) pass: &'a Pass,
    pub(super) timed: PassTimed<'a>,
    pub(super) planned: &'a PassMotion,
}

/// A planned program, ready to run: it makes all allocations before the first cycle. It belongs to the cycle's thread
/// and needs no lock.
#[derive(Debug)]
pub struct Work<'a> {
    /// Jogging of the axes.
    pub(super) hand: RefCell<Option<Jog<'a>>>,
    pub(super) passes: Vec<PassWork<'a>>,
    pub(super) air: &'a [TransferMove],
    pub(super) limits: ChannelLimits,
    pub(super) start: Start,
    values: Vec<String>,
}

impl<'a> Work<'a> {
    /// Creates the program. `passes` are those that `motion` was planned for; jogging avoids collisions with `around`.
    ///
    /// # Errors
    /// The number of process values, if it exceeds [`VALUES`].
    pub fn new(
        machine: &'a Machine,
        around: Option<&'a Surroundings<'a>>,
        passes: &[&'a Pass],
        motion: &'a WeldMotion,
        start: Start,
    ) -> Result<Self, usize> {
        let mut values: Vec<String> =
            passes.iter().flat_map(|p| &p.spans).flat_map(|s| s.process.keys().cloned()).collect();
        values.sort();
        values.dedup();
        if values.len() > VALUES {
            return Err(values.len());
        }
        let works = passes.iter().zip(&motion.passes);
        let passes = works.map(|(pass, planned)| PassWork { pass, timed: planned.timed(machine), planned }).collect();
        let hand = hand(machine, around);
        Ok(Self { hand, passes, air: &motion.transfers, limits: channel_limits(machine), start, values })
    }

    /// Creates an empty program; jogging avoids collisions with `around`.
    pub fn none(machine: &'a Machine, around: &'a Surroundings<'a>) -> Self {
        let start = Start {
            approach: TransferMove { legs: Vec::new(), retracts: false, approaches: false },
            pass: 0,
            welded_mm: 0.0,
        };
        let limits = channel_limits(machine);
        let hand = hand(machine, Some(around));
        Self { hand, passes: Vec::new(), air: &[], limits, start, values: Vec::new() }
    }

    /// Returns the names of the process values, in the order of their indices in orders and reports.
    pub fn values(&self) -> &[String] {
        &self.values
    }

    /// Returns the process values of pass `pass` (from 0) at path length `s`; `time` is an instant with arc or beam on.
    pub(super) fn process_at(&self, pass: usize, s: f64, time: ArcTime) -> [f64; VALUES] {
        let mut values = [f64::NAN; VALUES];
        for (value, name) in values.iter_mut().zip(&self.values) {
            *value = self.passes[pass].pass.process_at(name, s, time).unwrap_or(f64::NAN);
        }
        values
    }
}

impl PassWork<'_> {
    /// Returns the times at rest and the behaviour at a hold; all are zero without the process.
    pub(super) fn times(&self, welds: bool) -> Sequence {
        let s = &self.planned.sequence;
        if !welds {
            return Sequence { at_hold: AtHold::Crater, ..Sequence::default() };
        }
        Sequence {
            preflow_s: s.preflow_s,
            travel_delay_s: s.travel_delay_s,
            crater_s: s.crater_s,
            postflow_s: s.postflow_s,
            overlap_mm: s.overlap_mm,
            at_hold: s.at_hold,
            // The process values contain the slopes.
            upslope: None,
            downslope: None,
        }
    }
}
