use super::banded::Banded;
use super::cost::{Cost, Place, ROWS};
use super::free_axes::{Basis, FreeAxes};
use super::task::Task;
use crate::effort::SearchStage;
use seamwright_machine::{AxisKind, Joints, MAX_AXES};

const STEPS: usize = 40;
/// Minimum relative gain of a step; one with less is the last.
const ENOUGH: f64 = 1e-5;
/// Maximum move of a coefficient in one step: rad, or fraction of a linear axis' range.
const MAX_TURN: f64 = 0.3;
const MAX_STROKE: f64 = 0.1;
/// Difference for derivatives by free axes, rad; 100 times as many mm.
const DIFFERENCE: f64 = 1e-6;

/// Maximum number of coefficients in a row: those of three neighbouring stations.
const SPAN: usize = 5;

/// The free axes of minimum cost near any of `ways`, which are positions at equal stations, with a flag that all axes
/// stay in their ranges. None if no axis positions follow the splines, or if the effort is stopped.
pub(super) fn refine(task: &Task, ways: &[Vec<Joints>], still: Vec<(usize, f64)>) -> Option<(FreeAxes, bool)> {
    let stage = |(stations, intervals): (usize, usize), way: &[Joints]| {
        let mut stage = Stage::new(task, stations, intervals, through(task, way, intervals), way)?;
        stage.run();
        let way: Vec<Joints> = stage.rows.iter().map(|r| r.q).collect();
        Some((stage.cost, way, stage.coefficients))
    };
    task.effort.begin(SearchStage::Refining);
    let finer = if task.is_quick { &STAGES[..1] } else { &STAGES[..] };
    let stages = (ways.len() + finer.len()) as f64;
    let first = ways.iter().enumerate().filter_map(|(i, way)| {
        task.effort.spend(0, i as f64 / stages);
        stage(FIRST_STAGE, way)
    });
    let mut best = first.min_by(|a, b| a.0.total_cmp(&b.0))?;
    for (i, &size) in finer.iter().enumerate() {
        task.effort.spend(0, (ways.len() + i) as f64 / stages);
        best = stage(size, &best.1)?;
    }
    let (_, way, coefficients) = best;
    let count = task.free.len();
    let of = |a: usize| coefficients.iter().skip(a).step_by(count).copied().collect();
    let moving = task.free.iter().enumerate().map(|(a, &axis)| (axis, of(a))).collect();
    let inside = way.iter().all(|q| task.machine.outside(q).is_none());
    Some((
        FreeAxes {
            length: task.path.length(),
            still,
            moving,
            roll: task.roll,
            start: way.first().map(|q| task.of_machine(q)),
        },
        inside,
    ))
}

/// Coefficients of splines near the path: its values at the peak of each coefficient's basis function, extrapolated
/// linearly at the ends.
fn through(task: &Task, way: &[Joints], intervals: usize) -> Vec<f64> {
    let value = |x: f64, axis: usize| {
        let i = (x as usize).min(way.len() - 2);
        way[i][axis] + (x - i as f64) * (way[i + 1][axis] - way[i][axis])
    };
    let place = |j: usize| (j as f64 - 1.0) / intervals as f64 * (way.len() - 1) as f64;
    (0..intervals + 3)
        .flat_map(|j| task.free.iter().map(move |&axis| (j, axis)))
        .map(|(j, axis)| value(place(j), axis))
        .collect()
}

struct Row {
    q: Joints,
    residuals: [f64; ROWS],
}

struct Stage<'t, 'a> {
    task: &'t Task<'a>,
    places: Vec<Place>,
    basis: Vec<Basis>,
    intervals: usize,
    /// By position along the path, then by free axis.
    coefficients: Vec<f64>,
    rows: Vec<Row>,
    cost: f64,
}

impl<'t, 'a> Stage<'t, 'a> {
    fn new(
        task: &'t Task<'a>,
        stations: usize,
        intervals: usize,
        coefficients: Vec<f64>,
        way: &[Joints],
    ) -> Option<Self> {
        let places = task.places(stations);
        let basis = places.iter().map(|p| Basis::at(p.s, task.path.length(), intervals)).collect();
        let mut stage = Self { task, places, basis, intervals, coefficients, rows: Vec::new(), cost: 0.0 };
        let near = |k: usize| -> Joints {
            let x = k as f64 / stations as f64 * (way.len() - 1) as f64;
            let i = (x as usize).min(way.len() - 2);
            std::array::from_fn(|a| way[i][a] + (x - i as f64) * (way[i + 1][a] - way[i][a]))
        };
        stage.rows = stage.follow(&stage.coefficients, near)?;
        stage.cost = stage.total(&stage.rows);
        Some(stage)
    }

    /// Runs the Levenberg-Marquardt method.
    fn run(&mut self) {
        let mut damping = 1e-3;
        for _ in 0..STEPS {
            if self.task.effort.is_stopped() {
                break;
            }
            let equations = self.equations();
            let before = self.cost;
            while self.cost >= before && damping < 1e6 {
                let moved = equations.step(damping).is_some_and(|step| self.try_step(step));
                damping *= if moved { 0.1 } else { 10.0 };
            }
            if self.cost >= before * (1.0 - ENOUGH) {
                break;
            }
            damping = damping.max(1e-9);
        }
    }

    fn try_step(&mut self, mut step: Vec<f64>) -> bool {
        let count = self.task.free.len();
        let mut part: f64 = 1.0;
        for (i, d) in step.iter().enumerate() {
            let axis = &self.task.axes[self.task.free[i % count]];
            let most = match (axis.kind, axis.range) {
                (AxisKind::Linear, Some((low, high))) => MAX_STROKE * (high - low),
                _ => MAX_TURN,
            };
            part = part.min(most / d.abs());
        }
        step.iter_mut().zip(&self.coefficients).for_each(|(d, c)| *d = c + part * *d);
        let Some(rows) = self.follow(&step, |k| self.rows[k].q) else { return false };
        let cost = self.total(&rows);
        let better = cost < self.cost;
        if better {
            (self.rows, self.cost, self.coefficients) = (rows, cost, step);
        }
        better
    }

    /// All stations with the splines' coefficients, on the branches of `near`; none if a station has no solution.
    fn follow(&self, coefficients: &[f64], near: impl Fn(usize) -> Joints) -> Option<Vec<Row>> {
        let count = self.task.free.len();
        let row = |k: usize| {
            let (mut q, basis) = (near(k), &self.basis[k]);
            for (a, &axis) in self.task.free.iter().enumerate() {
                let four = basis.factors.iter().enumerate();
                q[axis] = four.map(|(j, b)| b * coefficients[(basis.first + j) * count + a]).sum();
            }
            self.row(k, &q)
        };
        (0..self.places.len()).map(row).collect()
    }

    fn row(&self, k: usize, near: &Joints) -> Option<Row> {
        let effort = self.task.effort;
        if !effort.spend(1, effort.progress().part) {
            return None;
        }
        let q = self.task.inverse_next(self.places[k].target, near).ok()?.joints;
        Some(Row { q, residuals: self.task.cost.place(&q, &self.places[k]) })
    }

    /// Length of a cell, mm, and as a fraction of the path.
    fn cell(&self) -> (f64, f64) {
        let cells = (self.places.len() - 1) as f64;
        (self.task.path.length() / cells, 1.0 / cells)
    }

    fn total(&self, rows: &[Row]) -> f64 {
        let (h, part) = self.cell();
        let cost = &self.task.cost;
        let mut sum = 0.0;
        for (k, row) in rows.iter().enumerate() {
            let half = if k == 0 || k + 1 == rows.len() { 0.5 } else { 1.0 };
            sum += half * row.residuals.iter().map(|r| r * r).sum::<f64>();
            for i in 0..self.task.machine.axes.len() {
                if k > 0 {
                    sum += Cost::rate((row.q[i] - rows[k - 1].q[i]) / h * cost.speed[i]);
                }
                if k > 0 && k + 1 < rows.len() {
                    let bend = rows[k + 1].q[i] - 2.0 * row.q[i] + rows[k - 1].q[i];
                    sum += Cost::rate(bend / (h * h) * cost.acceleration[i]);
                }
            }
        }
        sum * part
    }

    fn derivatives(&self, k: usize) -> Vec<(Joints, [f64; ROWS])> {
        let row = &self.rows[k];
        let derivative = |&axis: &usize| {
            let d = match self.task.axes[axis].kind {
                AxisKind::Linear => 100.0 * DIFFERENCE,
                AxisKind::Rotary => DIFFERENCE,
            };
            let mut near = row.q;
            near[axis] += d;
            let Some(other) = self.row(k, &near) else { return ([0.0; MAX_AXES], [0.0; ROWS]) };
            let by = |i: usize| (other.q[i] - row.q[i]) / d;
            (std::array::from_fn(by), std::array::from_fn(|i| (other.residuals[i] - row.residuals[i]) / d))
        };
        self.task.free.iter().map(derivative).collect()
    }

    fn equations(&self) -> Banded {
        let count = self.task.free.len();
        let (h, part) = self.cell();
        let weight = part.sqrt();
        let mut equations = Banded::new((self.intervals + 3) * count, SPAN * count);
        let slopes: Vec<_> = (0..self.rows.len()).map(|k| self.derivatives(k)).collect();
        // The row of a combination of positions at neighbouring stations.
        let mut add = |of: &[(usize, f64)], by: &dyn Fn(usize, usize) -> f64, r: f64| {
            let first = of.iter().map(|(k, _)| self.basis[*k].first).min().unwrap_or(0);
            let mut row = [0.0; SPAN * MAX_AXES];
            for &(k, factor) in of {
                let basis = &self.basis[k];
                for (j, b) in basis.factors.iter().enumerate() {
                    let at = (basis.first - first + j) * count;
                    (0..count).for_each(|a| row[at + a] += factor * b * by(k, a));
                }
            }
            let used = SPAN.min(self.intervals + 3 - first) * count;
            equations.add(first * count, &row[..used], r);
        };
        for k in 0..self.rows.len() {
            let half = if k == 0 || k + 1 == self.rows.len() { 0.5_f64.sqrt() } else { 1.0 };
            for (i, r) in self.rows[k].residuals.iter().enumerate() {
                if *r != 0.0 || slopes[k].iter().any(|d| d.1[i] != 0.0) {
                    add(&[(k, half * weight)], &|k, a| slopes[k][a].1[i], half * weight * r);
                }
            }
            for i in 0..self.task.machine.axes.len() {
                let mut rate = |of: &[(usize, f64)], scale: f64| {
                    let r: f64 = scale * of.iter().map(|(k, f)| f * self.rows[*k].q[i]).sum::<f64>();
                    let scaled = |f: f64| of.iter().map(move |(k, x)| (*k, f * weight * scale * x));
                    let by = |k: usize, a: usize| slopes[k][a].0[i];
                    let row: arrayvec::ArrayVec<_, 3> = scaled(1.0).collect();
                    add(&row, &by, weight * r);
                    if let Some((over, slope)) = Cost::excess(r) {
                        let row: arrayvec::ArrayVec<_, 3> = scaled(slope).collect();
                        add(&row, &by, weight * over);
                    }
                };
                if k > 0 {
                    rate(&[(k - 1, -1.0), (k, 1.0)], self.task.cost.speed[i] / h);
                }
                if k > 0 && k + 1 < self.rows.len() {
                    let scale = self.task.cost.acceleration[i] / (h * h);
                    rate(&[(k - 1, 1.0), (k, -2.0), (k + 1, 1.0)], scale);
                }
            }
        }
        equations
    }
}

/// Stations and spline intervals of the refinement of every path, and of the best one after that.
pub(super) const FIRST_STAGE: (usize, usize) = (40, 8);

pub(super) const STAGES: [(usize, usize); 2] = [(120, 16), (1000, 48)];
