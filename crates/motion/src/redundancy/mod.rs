//! Axes that a path leaves free: a machine with more axes than a point and a direction need can weld the same seam in
//! many ways, and the best one as a whole is looked for.
//!
//! First a graph: at stations along the path the free axes are sampled, every branch of the inverse is a node, and
//! dynamic programming finds the way of least cost through the nodes; then again with nodes closer together about that
//! way. Then the free axes become uniform cubic B-splines, and Levenberg and Marquardt's method moves their
//! coefficients to the least of the true cost at 1,000 stations. Nothing is random: the same path gives the same
//! motion.

mod banded;
mod cost;
mod explain;
mod free_axes;
mod graph;
mod refine;

use cost::Cost;
pub use free_axes::FreeAxes;
use glam::DVec3;
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine, Target};
use seamwright_program::{Finding, SpareAxes, TorchPath};
use std::f64::consts::TAU;
use thiserror::Error;

/// Stations of the graph's first level and samples of the free axes there: a quick search, then a thorough one.
const EFFORTS: [(usize, usize); 2] = [(24, 216), (48, 800)];
/// Levels of the graph after the first.
const FINER: usize = 2;
/// Stations and spline intervals of the refinement of every way, and of the best one after that.
const FIRST_STAGE: (usize, usize) = (40, 8);
const STAGES: [(usize, usize); 2] = [(120, 16), (1000, 48)];

/// Distance to obstacles, for the choice of the free axes.
#[derive(Clone, Copy)]
pub struct Clearance<'a> {
    /// Least distance (mm) at axis positions, negative inside an obstacle; continuous.
    pub distance: &'a dyn Fn(&Joints) -> f64,
    /// Distance from which on more is not better, mm, more than 0.
    pub wanted_mm: f64,
}

/// Why an axis cannot be held as asked.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum HoldError {
    /// The machine has no such axis, or the torch's pose decides it.
    #[error("axis {axis} is none to spare on this machine")]
    NotFree {
        /// Name asked for.
        axis: String,
        /// Names of the axes to spare.
        free: String,
    },
    /// The position lies outside the axis' range.
    #[error("axis {axis} does not go there")]
    Range {
        /// Name asked for.
        axis: String,
        /// The range, in the file's unit.
        range: String,
    },
}

impl HoldError {
    /// Name of the axis.
    pub fn axis(&self) -> &str {
        match self {
            Self::NotFree { axis, .. } | Self::Range { axis, .. } => axis,
        }
    }

    /// What would be allowed.
    pub fn allowed(&self) -> String {
        match self {
            Self::NotFree { free, .. } if free.is_empty() => "nothing: a torch pose decides all its axes".to_owned(),
            Self::NotFree { free, .. } => free.clone(),
            Self::Range { range, .. } => range.clone(),
        }
    }
}

/// The axes that `wishes` holds, with their positions in mm or rad.
///
/// # Errors
/// An axis that is not free on `machine`, or a position outside its range.
pub fn held(machine: &Machine, wishes: &SpareAxes) -> Result<Vec<(usize, f64)>, HoldError> {
    let free = machine.free();
    let mut held = Vec::new();
    for (name, position) in &wishes.hold {
        let axis = machine.axis(name).filter(|&i| free.has(i)).ok_or_else(|| HoldError::NotFree {
            axis: name.clone(),
            free: free.iter().map(|i| machine.axes[i].name.as_str()).collect::<Vec<_>>().join(", "),
        })?;
        let value = machine.axes[axis].from_file(position.get());
        if machine.axes[axis].outside(value).is_some() {
            let a = &machine.axes[axis];
            let (low, high) = a.range.unwrap_or_default();
            let range = format!("{:.3} to {:.3} {}", a.to_file(low), a.to_file(high), a.unit());
            return Err(HoldError::Range { axis: name.clone(), range });
        }
        held.push((axis, value));
    }
    Ok(held)
}

/// The free axes of `machine` along `path`, welded at up to `speed` mm/s: continuous, twice continuously
/// differentiable, within their ranges, of least cost by the weights of `wishes`. Nothing to choose gives the default.
///
/// # Errors
/// Findings of pass `pass` that say where there is no way, and because of what.
pub fn resolve(
    machine: &Machine,
    path: &dyn TorchPath,
    speed: f64,
    wishes: &SpareAxes,
    clearance: Option<Clearance>,
    pass: usize,
) -> Result<FreeAxes, Vec<Finding>> {
    if path.axes(0.0).is_some() {
        return Ok(FreeAxes::default());
    }
    let still = held(machine, wishes).map_err(|e| vec![explain::hold(&e, path.length(), pass)])?;
    let two = path.second(0.0).is_some();
    if let (true, Some(&(axis, _))) = (two, still.first()) {
        // Two torches decide every axis.
        let error = HoldError::NotFree { axis: machine.axes[axis].name.clone(), free: String::new() };
        return Err(vec![explain::hold(&error, path.length(), pass)]);
    }
    if machine.free().is_empty() || two {
        return Ok(FreeAxes::default());
    }
    let task = Task::new(machine, path, speed, wishes, clearance, &still);
    if task.free.is_empty() {
        return Ok(FreeAxes { length: path.length(), still, moving: Vec::new(), start: None });
    }
    let mut best: Option<FreeAxes> = None;
    let mut last = None;
    for (stations, samples) in EFFORTS {
        let mut graph = graph::Graph::new(&task, stations, samples);
        let mut ways = graph.ways();
        if let Some(best) = ways.first() {
            ways.push(task.closer(best.clone(), graph.steps.clone()));
        }
        ways.iter_mut().for_each(|way| task.turn_home(way));
        if let Some((free, inside)) = refine::refine(&task, &ways, still.clone()) {
            if inside {
                return Ok(free);
            }
            // What it lacks, the survey says.
            best = best.or(Some(free));
        }
        last = Some(graph);
    }
    match (best, last) {
        (Some(free), _) => Ok(free),
        (None, Some(graph)) => Err(explain::no_way(&task, &graph, pass)),
        (None, None) => Ok(FreeAxes::default()),
    }
}

/// What is looked for.
struct Task<'a> {
    machine: &'a Machine,
    path: &'a dyn TorchPath,
    /// The axes that are looked for.
    free: Vec<usize>,
    /// Home, with the axes that are held where they are held.
    base: Joints,
    cost: Cost<'a>,
}

/// A place along the path.
struct Place {
    s: f64,
    target: Target,
    face: DVec3,
}

impl<'a> Task<'a> {
    fn new(
        machine: &'a Machine,
        path: &'a dyn TorchPath,
        speed: f64,
        wishes: &'a SpareAxes,
        clearance: Option<Clearance<'a>>,
        held: &[(usize, f64)],
    ) -> Self {
        let mut base = machine.home();
        held.iter().for_each(|&(axis, value)| base[axis] = value);
        let still: AxisSet = held.iter().map(|(axis, _)| *axis).collect();
        let looked_for = machine.free().different(still);
        let cost = Cost::new(machine, wishes, clearance, speed, (looked_for, still), &base);
        Self { machine, path, free: looked_for.iter().collect(), base, cost }
    }

    fn places(&self, stations: usize) -> Vec<Place> {
        let at = |i: usize| self.path.length() * i as f64 / stations as f64;
        (0..=stations).map(|i| self.place(at(i))).collect()
    }

    fn place(&self, s: f64) -> Place {
        Place { s, target: self.path.pose(s).into(), face: self.path.face(s) }
    }

    /// The way through nodes ever closer about `way`, whose own are `steps` apart.
    fn closer(&self, mut way: Vec<Joints>, mut steps: Vec<f64>) -> Vec<Joints> {
        for _ in 0..FINER {
            way = graph::finer(self, &way, &steps).unwrap_or(way);
            steps.iter_mut().for_each(|s| *s *= 0.5);
        }
        way
    }

    /// True if `axis` turns without end.
    fn endless(&self, axis: usize) -> bool {
        self.machine.axes[axis].range.is_none()
    }

    /// The least way of `axis` from `a` to `b`, over the gap where it turns without end.
    fn way(&self, axis: usize, a: f64, b: f64) -> f64 {
        let d = b - a;
        if self.endless(axis) { d - TAU * (d / TAU).round() } else { d }
    }

    /// Turns the axes that turn without end by whole turns, so that they stay as near to home as can be.
    fn turn_home(&self, way: &mut [Joints]) {
        for (i, axis) in self.machine.axes.iter().enumerate() {
            if axis.kind == AxisKind::Rotary && axis.range.is_none() {
                let (low, high) =
                    way.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), q| (l.min(q[i]), h.max(q[i])));
                let turns = ((0.5 * (low + high) - axis.home) / TAU).round();
                way.iter_mut().for_each(|q| q[i] -= TAU * turns);
            }
        }
    }
}
