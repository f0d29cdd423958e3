//! Branches of an inverse without closed form, at stations and samples of the free axes, by continuation.
//!
//! A full search runs Newton's method from hundreds of starts. Here it is made at a few cells of the lattice of
//! stations and samples only; every solution is then continued into the neighbouring cells, from there into theirs, and
//! so on. A branch found in one cell is thus followed over the whole lattice.

use super::cost::Place;
use super::task::Task;
use seamwright_machine::{AxisKind, Joints, MAX_BRANCHES};
use std::collections::VecDeque;
use std::f64::consts::TAU;

/// Number of cells of the lattice with a full search.
const SEEDS: usize = 16;
/// Units of effort of such a search.
const SEED_WORK: u64 = 600;
/// Two solutions are the same within this, mm or rad.
const SAME: f64 = 1e-5;

/// Solutions by station and by combination of samples; `combinations` are those of `grids`, and solutions have the free
/// axes at these samples. Ranges of dependent axes are not checked.
pub(super) fn branches(
    task: &Task,
    places: &[Place],
    combinations: &[Joints],
    grids: &[Vec<f64>],
) -> Vec<Vec<Vec<Joints>>> {
    let mut lattice =
        Lattice { task, cells: vec![vec![Vec::new(); combinations.len()]; places.len()], todo: VecDeque::new() };
    lattice.seed(places, combinations);
    let count = (places.len() * combinations.len() * MAX_BRANCHES) as f64;
    let mut done = 0u32;
    while let Some((station, sample, q)) = lattice.todo.pop_front() {
        done += 1;
        for (station, sample) in neighbours(station, sample, places.len(), grids) {
            if !task.effort.spend(1, 0.2 + 0.8 * f64::from(done) / count) {
                return lattice.cells;
            }
            let mut start = q;
            task.free.iter().for_each(|&axis| start[axis] = combinations[sample][axis]);
            if lattice.is_known(station, sample, &start) {
                continue;
            }
            if let Ok(found) = task.machine.inverse_from(places[station].target, &start, &[start]) {
                found.iter().for_each(|solution| lattice.add(station, sample, solution.joints));
            }
        }
    }
    lattice.cells
}

struct Lattice<'t, 'a> {
    task: &'t Task<'a>,
    cells: Vec<Vec<Vec<Joints>>>,
    todo: VecDeque<(usize, usize, Joints)>,
}

impl Lattice<'_, '_> {
    fn seed(&mut self, places: &[Place], combinations: &[Joints]) {
        for i in 0..SEEDS {
            if !self.task.effort.spend(SEED_WORK, 0.2 * i as f64 / SEEDS as f64) {
                return;
            }
            let station = i * (places.len() - 1) / (SEEDS - 1);
            // The golden section spreads any number evenly.
            let sample = ((i as f64 * 0.618_033_988_75).fract() * combinations.len() as f64) as usize;
            let near = &combinations[sample];
            if let Ok(found) = self.task.machine.inverse(places[station].target, near) {
                found.iter().for_each(|solution| self.add(station, sample, solution.joints));
            }
        }
    }

    fn add(&mut self, station: usize, sample: usize, q: Joints) {
        let cell = &self.cells[station][sample];
        if cell.len() < MAX_BRANCHES && !cell.iter().any(|other| self.apart(other, &q) < SAME) {
            self.cells[station][sample].push(q);
            self.todo.push_back((station, sample, q));
        }
    }

    /// True if a solution of the cell is so near to the start of a neighbour's continuation that it would only find
    /// this one.
    fn is_known(&self, station: usize, sample: usize, start: &Joints) -> bool {
        self.cells[station][sample].iter().any(|other| self.apart(other, start) < 1e-3)
    }

    /// Maximum distance over all axes, rotary ones modulo turns, mm or rad.
    fn apart(&self, a: &Joints, b: &Joints) -> f64 {
        let axes = self.task.machine.axes.iter().zip(a.iter().zip(b));
        let parts = axes.map(|(axis, (a, b))| match axis.kind {
            AxisKind::Linear => (a - b).abs(),
            AxisKind::Rotary => (a - b - TAU * ((a - b) / TAU).round()).abs(),
        });
        parts.fold(0.0, f64::max)
    }
}

fn neighbours(station: usize, sample: usize, stations: usize, grids: &[Vec<f64>]) -> Vec<(usize, usize)> {
    let mut all = Vec::new();
    all.extend(station.checked_sub(1).map(|before| (before, sample)));
    all.extend((station + 1 < stations).then_some((station + 1, sample)));
    let mut stride = 1;
    for grid in grids {
        let at = sample / stride % grid.len();
        all.extend((at > 0).then(|| (station, sample - stride)));
        all.extend((at + 1 < grid.len()).then_some((station, sample + stride)));
        stride *= grid.len();
    }
    all
}
