//! A planned pass against the welding procedure: process values, speed, heat input, torch angles and welding position
//! along the path, where they leave their windows, and the findings that say so.
//!
//! Everything is that of the plan: the speed is the one that the axes can keep, the torch angles are those that they
//! reach, and gravity is seen from the part as the machine's axes turn it. Run-up and run-down are not held against
//! the windows of speed and heat input; a stop on the way is.

mod findings;
mod lie;
mod windows;

use crate::PassMotion;
use seamwright_machine::Machine;
use seamwright_program::{
    FilletOrButt, Finding, Inclination, Outside, Pass, PositionStretch, Procedure, TorchPath, Window,
};

/// What a planned pass does, and what its procedure allows.
#[derive(Debug, Clone, PartialEq)]
pub struct PassProcedure {
    /// The procedure's run that the pass belongs to, in words; none if there is none.
    pub run: Option<String>,
    /// Kind of weld, which decides where positions begin and end.
    pub joint: FilletOrButt,
    /// Values along the pass against their windows.
    pub quantities: Vec<Quantity>,
    /// Heat input over path length (mm, kJ/mm) between run-up and run-down, a pair of places wherever it jumps; empty if
    /// the pass does not say its power.
    pub heat_input: Vec<(f64, f64)>,
    /// Slope and rotation over path length (mm).
    pub inclinations: Vec<(f64, Inclination)>,
    /// Welding positions, one after the other.
    pub positions: Vec<PositionStretch>,
    /// Where the plan leaves the procedure.
    pub findings: Vec<Finding>,
}

/// A value along a pass.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Its key in the procedure, which ends in its unit.
    pub key: String,
    /// Least and greatest value found; none if the plan does not know it.
    pub found: Option<(f64, f64)>,
    /// The window, if the procedure has one.
    pub allowed: Option<Window>,
    /// Where it is outside, in the order of path length.
    pub outside: Vec<Outside>,
}

impl PassProcedure {
    /// Holds `motion`, planned for `pass` (the `number`-th, from 1) along `path` on `machine`, against `procedure`.
    pub fn new(
        procedure: &Procedure,
        machine: &Machine,
        path: &dyn TorchPath,
        (pass, number, motion): (&Pass, usize, &PassMotion),
    ) -> Self {
        let run = procedure.run_of(number, pass);
        let lies = lie::along(machine, path, motion);
        let joint = procedure.joint(lie::dihedrals(path, &lies));
        let limits = &procedure.position_limits;
        let places: Vec<f64> = lies.iter().map(|lie| lie.s).collect();
        let at = |s: f64| lie::at(machine, path, motion, s).inclination;
        let heat_input = windows::heat_input(procedure, machine, (pass, motion));
        let mut held = Self {
            run: run.map(seamwright_program::Run::label),
            joint,
            quantities: windows::quantities(procedure, run, machine, (path, pass, motion), &lies),
            heat_input,
            inclinations: lies.iter().map(|lie| (lie.s, lie.inclination)).collect(),
            positions: limits.along(joint, &places, at),
            findings: Vec::new(),
        };
        held.findings = findings::findings(&held, procedure, run, (pass, number));
        held
    }

    /// Least and greatest slope, and least and greatest rotation (rad), at the places looked at in a stretch; none if
    /// it lies between two of them.
    pub fn inclination_in(&self, stretch: &PositionStretch) -> Option<((f64, f64), (f64, f64))> {
        let inside = self.inclinations.iter().filter(|(s, _)| *s >= stretch.from_mm && *s <= stretch.to_mm);
        let grow = |(least, greatest): (f64, f64), v: f64| (v.min(least), v.max(greatest));
        inside.map(|(_, at)| at).fold(None, |ends: Option<((f64, f64), (f64, f64))>, at| {
            let (slope, rotation) = ends.unwrap_or(((at.slope, at.slope), (at.rotation, at.rotation)));
            Some((grow(slope, at.slope), grow(rotation, at.rotation)))
        })
    }
}
