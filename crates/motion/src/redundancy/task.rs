use super::cost::{Aim, Cost, Place};
use super::free_axes::FreeRoll;
use crate::effort::Effort;
use seamwright_machine::{
    Axis, AxisKind, AxisSet, Branches, Joints, Machine, RollReference, Solution, Target, Unreachable,
};
use seamwright_program::TorchPath;
use std::f64::consts::TAU;

/// Number of samples of the torch directions for the reference of the rotation about the torch.
const ROLL_SAMPLES: u32 = 200;

pub(super) struct Task<'a> {
    pub(super) effort: &'a Effort<'a>,
    pub(super) machine: &'a Machine,
    pub(super) path: &'a dyn TorchPath,
    /// The machine's axes, then the rotation about the torch as one more if it is free.
    pub(super) axes: Vec<Axis>,
    pub(super) roll: Option<FreeRoll>,
    pub(super) free: Vec<usize>,
    /// Home, with the held axes at their positions.
    pub(super) base: Joints,
    /// Axes whose positions a whole turn apart are equivalent.
    pub(super) winding: AxisSet,
    /// See [`Aim::explains`].
    pub(super) explains: bool,
    /// See [`Aim::is_quick`].
    pub(super) is_quick: bool,
    pub(super) cost: Cost<'a>,
}

impl<'a> Task<'a> {
    pub(super) fn new(
        effort: &'a Effort<'a>,
        machine: &'a Machine,
        path: &'a dyn TorchPath,
        aim: Aim<'a>,
        held: &[(usize, f64)],
    ) -> Self {
        let mut base = machine.home();
        held.iter().for_each(|&(axis, value)| base[axis] = value);
        let still: AxisSet = held.iter().map(|(axis, _)| *axis).collect();
        let Aim { explains, is_quick, .. } = aim;
        let mut looked_for = machine.free().different(still);
        let cost = Cost::new(machine, aim, still, &base);
        let mut axes = machine.axes.clone();
        let roll = machine.has_free_roll().then(|| {
            let poses: Vec<_> =
                (0..=ROLL_SAMPLES).map(|i| path.pose(path.length() * f64::from(i) / f64::from(ROLL_SAMPLES))).collect();
            FreeRoll { entry: axes.len(), reference: RollReference::new(&poses) }
        });
        if let Some(roll) = roll {
            looked_for = looked_for.with(roll.entry);
            axes.push(roll_axis());
        }
        let winding = (0..axes.len()).filter(|&axis| {
            // A free axis is sampled over one turn: the path may need another one.
            let turns = if looked_for.has(axis) { 2.0 } else { 1.0 };
            let a = &axes[axis];
            let wide = a.range.is_none_or(|(low, high)| high - low >= turns * TAU * (1.0 - 1e-9));
            // A table of pitch errors is not periodic.
            a.kind == AxisKind::Rotary && wide && (a.range.is_none() || a.pitch_error.is_none())
        });
        let winding = winding.collect();
        let free = looked_for.iter().collect();
        Self { effort, machine, path, axes, roll, free, base, winding, explains, is_quick, cost }
    }

    fn target(&self, target: Target, q: &Joints) -> Target {
        let across = self.roll.map(|roll| roll.across(target.first.direction, q));
        Target { across, ..target }
    }

    /// As [`Machine::inverse`], with the rotation about the torch of `q`.
    pub(super) fn inverse(&self, target: Target, q: &Joints) -> Result<Branches, Unreachable> {
        self.inverse_from(target, q, None)
    }

    /// As [`Machine::inverse_from`] with `start`, if there is one.
    pub(super) fn inverse_from(
        &self,
        target: Target,
        q: &Joints,
        start: Option<&Joints>,
    ) -> Result<Branches, Unreachable> {
        let target = self.target(target, q);
        let mut branches = match start {
            Some(start) => self.machine.inverse_from(target, q, &[*start])?,
            None => self.machine.inverse(target, q)?,
        };
        branches.iter_mut().for_each(|solution| self.keep_roll(solution, q));
        Ok(branches)
    }

    /// As [`Machine::inverse_next`], with the rotation about the torch of `q`.
    pub(super) fn inverse_next(&self, target: Target, q: &Joints) -> Result<Solution, Unreachable> {
        let mut solution = self.machine.inverse_next(self.target(target, q), q)?;
        self.keep_roll(&mut solution, q);
        Ok(solution)
    }

    fn keep_roll(&self, solution: &mut Solution, q: &Joints) {
        if let Some(roll) = self.roll {
            solution.joints[roll.entry] = q[roll.entry];
        }
    }

    /// `q` without the rotation about the torch.
    pub(super) fn of_machine(&self, q: &Joints) -> Joints {
        let mut q = *q;
        self.roll.iter().for_each(|roll| q[roll.entry] = 0.0);
        q
    }

    pub(super) fn endless(&self) -> AxisSet {
        let is_endless = |axis: &Axis| axis.kind == AxisKind::Rotary && axis.range.is_none();
        (0..self.axes.len()).filter(|&axis| is_endless(&self.axes[axis])).collect()
    }

    /// Approximate number of nodes per node if turns of all axes with ranges were distinguished.
    pub(super) fn telling_turns(&self) -> f64 {
        let ranges = self.winding.iter().filter_map(|axis| self.axes[axis].range);
        ranges.map(|(low, high)| ((high - low) / TAU).ceil()).product()
    }

    pub(super) fn places(&self, stations: usize) -> Vec<Place> {
        let at = |i: usize| self.path.length() * i as f64 / stations as f64;
        (0..=stations).map(|i| self.place(at(i))).collect()
    }

    pub(super) fn place(&self, s: f64) -> Place {
        let tangent = self.path.groove(s).map_or_else(|| self.path.line(s).1, |groove| groove.tangent);
        Place { s, target: self.path.pose(s).into(), face: self.path.face(s), tangent }
    }

    pub(super) fn winds(&self, axis: usize) -> bool {
        self.winding.has(axis)
    }

    /// Shortest displacement of `axis` from `a` to `b`, modulo turns if these are equivalent.
    pub(super) fn way(&self, axis: usize, a: f64, b: f64) -> f64 {
        let d = b - a;
        if self.winds(axis) { d - TAU * (d / TAU).round() } else { d }
    }

    /// Turns winding axes by whole turns, so that they stay in their ranges if possible, and as near to home as
    /// possible.
    pub(super) fn turn_home(&self, way: &mut [Joints]) {
        for (i, axis) in self.machine.axes.iter().enumerate().filter(|(i, _)| self.winds(*i)) {
            let (low, high) =
                way.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), q| (l.min(q[i]), h.max(q[i])));
            let home = ((axis.home - 0.5 * (low + high)) / TAU).round();
            let turns = axis.turns_within(low..=high, home).unwrap_or(home);
            way.iter_mut().for_each(|q| q[i] += TAU * turns);
        }
    }
}

/// The rotation about the torch as an axis without limits: only the axes that follow it have some.
fn roll_axis() -> Axis {
    Axis {
        name: String::new(),
        letter: None,
        kind: AxisKind::Rotary,
        range: None,
        home: 0.0,
        max_speed: f64::INFINITY,
        max_acceleration: f64::INFINITY,
        max_jerk: f64::INFINITY,
        pitch_error: None,
        drive: None,
        stepper: None,
    }
}
