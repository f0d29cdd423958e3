use super::cost::{Aim, Cost, Place};
use crate::effort::Effort;
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine};
use seamwright_program::TorchPath;
use std::f64::consts::TAU;

pub(super) struct Task<'a> {
    pub(super) effort: &'a Effort<'a>,
    pub(super) machine: &'a Machine,
    pub(super) path: &'a dyn TorchPath,
    pub(super) free: Vec<usize>,
    /// Home, with the held axes at their positions.
    pub(super) base: Joints,
    /// Axes whose positions a whole turn apart are equivalent.
    pub(super) winding: AxisSet,
    /// See [`Aim::explains`].
    pub(super) explains: bool,
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
        let looked_for = machine.free().different(still);
        let cost = Cost::new(machine, aim, still, &base);
        let winding = (0..machine.axes.len()).filter(|&axis| {
            // A free axis is sampled over one turn: the path may need another one.
            let turns = if looked_for.has(axis) { 2.0 } else { 1.0 };
            let a = &machine.axes[axis];
            let wide = a.range.is_none_or(|(low, high)| high - low >= turns * TAU * (1.0 - 1e-9));
            // A table of pitch errors is not periodic.
            a.kind == AxisKind::Rotary && wide && (a.range.is_none() || a.pitch_error.is_none())
        });
        let winding = winding.collect();
        Self { effort, machine, path, free: looked_for.iter().collect(), base, winding, explains: aim.explains, cost }
    }

    pub(super) fn endless(&self) -> AxisSet {
        let rotary = |axis: &usize| self.machine.axes[*axis].kind == AxisKind::Rotary;
        (0..self.machine.axes.len()).filter(rotary).filter(|&axis| self.machine.axes[axis].range.is_none()).collect()
    }

    /// Approximate number of nodes per node if turns of all axes with ranges were distinguished.
    pub(super) fn telling_turns(&self) -> f64 {
        let ranges = self.winding.iter().filter_map(|axis| self.machine.axes[axis].range);
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
