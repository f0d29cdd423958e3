//! From texts to machines, welds and motions.

use crate::positive;
use seamwright_document::NonNegative;
use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
use seamwright_motion::{PassMotion, Terms, WeldMotion};
use seamwright_program::{AxisPositions, Finding, OnLimit, Pass, TorchPath};
use seamwright_weld::{MachineAxes, MachineAxis, NoFiles, Outside, Welding, Wrong};
use std::sync::Arc;

/// The shipped machines, and no files.
struct Shipped;

impl Outside for Shipped {
    fn bytes(&self, file: &str) -> std::io::Result<Vec<u8>> {
        NoFiles.bytes(file)
    }

    fn table(&self, file: &str) -> Result<Vec<Vec<f64>>, Wrong> {
        NoFiles.table(file)
    }

    fn tip(&self, machine: &str, axes: &[f64]) -> Result<glam::DVec3, Wrong> {
        NoFiles.tip(machine, axes)
    }

    fn axes(&self, machine: &str) -> Result<Arc<dyn MachineAxes>, Wrong> {
        Ok(Arc::new(ShippedAxes(shipped_machine(machine))))
    }
}

#[derive(Debug)]
struct ShippedAxes(Machine);

impl MachineAxes for ShippedAxes {
    fn axes(&self) -> Vec<MachineAxis> {
        Vec::new()
    }

    fn torch(&self, positions: &AxisPositions) -> seamwright_geometry::Pose {
        self.0.forward(positions)
    }

    fn stick_out(&self) -> Option<f64> {
        self.0.stick_out_mm
    }
}

pub(crate) fn read(text: &str) -> Welding {
    Welding::read_with("job.toml", text, &Shipped).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

pub(crate) fn read_machine(text: &str) -> Machine {
    Machine::read("machine.toml", text).unwrap_or_else(|e| panic!("{e}"))
}

pub(crate) fn shipped_machine(name: &str) -> Machine {
    read_machine(shipped(name).unwrap().text)
}

pub(crate) fn machine_of(welding: &Welding) -> Machine {
    shipped_machine(&welding.program.value.machine)
}

pub(crate) fn first_pass(welding: &Welding) -> &Pass {
    &welding.program.value.passes[0]
}

/// The ellipse's pass as one span at `speed`, slowed down where an axis needs it.
pub(crate) fn one_span(length: f64, speed: f64) -> Pass {
    let mut pass = read(include_str!("../../../../examples/ellipse.toml")).program.value.passes.remove(0);
    pass.on_limit = OnLimit::Slow;
    pass.spans.truncate(1);
    let span = &mut pass.spans[0];
    (span.from_mm, span.to_mm) = (NonNegative::new(0.0).unwrap(), positive(length));
    span.speed_mm_s = positive(speed).into();
    pass
}

pub(crate) fn plan(machine: &Machine, welding: &Welding) -> Result<PassMotion, Vec<Finding>> {
    PassMotion::plan(machine, &welding.path(0), first_pass(welding), 1)
}

pub(crate) fn several_passes(job: &str, passes: usize) -> Welding {
    let mut program = read(job).program.value;
    let pass = program.passes[0].clone();
    program.passes = (0..passes).map(|i| Pass { name: format!("pass {}", i + 1), ..pass.clone() }).collect();
    read(&program.to_toml().unwrap())
}

pub(crate) fn plan_weld(machine: &Machine, welding: &Welding, clamped: &Clamped) -> Result<WeldMotion, Vec<Finding>> {
    plan_weld_under(machine, welding, clamped, Terms::default())
}

pub(crate) fn plan_weld_under(
    machine: &Machine,
    welding: &Welding,
    clamped: &Clamped,
    terms: Terms<'_>,
) -> Result<WeldMotion, Vec<Finding>> {
    let around = Surroundings::new(machine, clamped).unwrap();
    let paths: Vec<_> = (0..welding.program.value.passes.len()).map(|i| welding.path(i)).collect();
    let passes: Vec<(&dyn TorchPath, &Pass)> =
        paths.iter().zip(&welding.program.value.passes).map(|(path, pass)| (path as &dyn TorchPath, pass)).collect();
    WeldMotion::plan_under(machine, &around, &passes, 30.0, terms)
}
