//! Redundancy resolution: a machine with more axes than a point and a direction need can weld the same seam with many
//! axis motions. The best one over the whole path is searched.
//!
//! **Graph.** At stations along the path the free axes are sampled, and every branch of the inverse is a node. Dynamic
//! programming finds the path of minimum cost through the nodes, then again with finer nodes about that path. It also
//! finds paths far from the best one, because samples do not show the cost of acceleration.
//!
//! **Refinement.** The free axes become uniform cubic B-splines. The Levenberg-Marquardt method (Levenberg, 1944;
//! Marquardt, 1963) moves their coefficients to the minimum of the true cost: at 40 stations for every path, then at
//! 120 and 1,000 for the best one. Ends of ranges repel strongly; the survey still checks them.
//!
//! **Inverse without closed form.** Nodes are found by continuation (`continuation.rs`): all branches in a few cells of
//! the lattice of stations and samples, then Newton's method into the neighbouring cells. A full search costs thousands
//! of times as much. In wide ranges nodes a whole turn apart are merged; they are distinguished only if the path found
//! does not fit into the ranges.
//!
//! **Determinism.** The effort is fixed, so the same path gives the same motion. A clock from outside (`effort::Watch`)
//! can only end a search. `Follower` is the only place that puts the result into the inverse.

mod banded;
mod continuation;
mod cost;
mod explain;
mod free_axes;
mod graph;
mod refine;

use crate::effort::Effort;
pub(crate) use cost::AllowedPositions;
use cost::Cost;
pub(crate) use explain::hold as hold_finding;
pub use free_axes::FreeAxes;
use glam::DVec3;
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine, Target};
use seamwright_message::{Argument, Message};
use seamwright_program::{Finding, SpareAxes, TorchPath};
use std::borrow::Cow;
use std::f64::consts::TAU;

/// Stations of the graph's first level and samples of the free axes there: a quick search, then a thorough one.
const EFFORTS: [(usize, usize); 2] = [(24, 216), (48, 800)];
/// Stations and samples for an inverse without closed form.
const NUMERIC_EFFORTS: [(usize, usize); 2] = [(24, 64), (48, 120)];
/// Maximum number of turns per node up to which nodes a whole turn apart are distinguished.
const MAX_TURNS: f64 = 8.0;
/// Number of levels of the graph after the first.
const FINER: usize = 2;
/// Stations and spline intervals of the refinement of every path, and of the best one after that.
const FIRST_STAGE: (usize, usize) = (40, 8);
const STAGES: [(usize, usize); 2] = [(120, 16), (1000, 48)];

/// Distance to obstacles, for the choice of the free axes.
#[derive(Clone, Copy)]
pub struct Clearance<'a> {
    /// Minimum distance (mm) at axis positions, negative inside an obstacle; continuous.
    pub distance: &'a dyn Fn(&Joints) -> f64,
    /// Distance above which more has no benefit, mm; greater than 0.
    pub wanted_mm: f64,
}

/// Error of an invalid hold of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct HoldError {
    /// Requested name of the axis; of several the first.
    pub axis: String,
    /// Description.
    pub message: Message,
    /// Allowed axes, number or range.
    pub allowed: Message,
}

/// The machine with the axes held by `wishes` free of the torch's pose: `machine` itself if they are already free, else
/// the one of [`Machine::freeing`].
///
/// # Errors
/// An axis whose hold is invalid, or a position outside its range.
pub fn holding<'m>(machine: &'m Machine, wishes: &SpareAxes) -> Result<Cow<'m, Machine>, HoldError> {
    let held = held(machine, wishes)?;
    let wanted: AxisSet = held.iter().map(|(axis, _)| *axis).collect();
    if wanted.both(machine.free()) == wanted {
        return Ok(Cow::Borrowed(machine));
    }
    let held: Vec<String> = held.iter().map(|(axis, _)| machine.axes[*axis].name.clone()).collect();
    let axis = held.first().cloned().unwrap_or_default();
    let redundant = machine.free().iter().count();
    if redundant == 0 {
        return Err(needed(&axis));
    }
    machine.freeing(wanted).map(Cow::Owned).ok_or_else(|| {
        // The other axes cannot reach every torch pose.
        let message = Message::new("motion-hold-too-few").list("held", held.into_iter().map(Argument::Axis));
        HoldError { axis, message, allowed: Message::new("motion-hold-allowed-count").count("axes", redundant) }
    })
}

/// Error of an axis that every torch pose needs.
fn needed(axis: &str) -> HoldError {
    let message = Message::new("motion-hold-decided").axis("axis", axis);
    HoldError { axis: axis.to_owned(), message, allowed: Message::new("motion-hold-allowed-none") }
}

/// The axes held by `wishes`, with their positions in mm or rad.
fn held(machine: &Machine, wishes: &SpareAxes) -> Result<Vec<(usize, f64)>, HoldError> {
    let chain = machine.heads[0].chain.axes();
    let mut held = Vec::new();
    for (name, position) in &wishes.hold {
        let about = |code| Message::new(code).axis("axis", name.as_str());
        let wrong = |message, allowed| HoldError { axis: name.clone(), message, allowed };
        let axis = machine.axis(name).filter(|&i| chain.has(i)).ok_or_else(|| {
            let axes: Vec<&str> = chain.iter().map(|i| machine.axes[i].name.as_str()).collect();
            wrong(about("motion-hold-unknown"), Message::verbatim(axes.join(", ")))
        })?;
        let value = machine.axes[axis].from_file(position.get());
        if machine.axes[axis].outside(value).is_some() {
            let a = &machine.axes[axis];
            let ((low, high), unit) = (a.range.unwrap_or_default(), a.position_unit());
            let message = about("motion-hold-range").value("value", position.get(), unit);
            let allowed = Message::new("document-between").quantity("min", a.to_file(low), unit, 3);
            return Err(wrong(message, allowed.quantity("max", a.to_file(high), unit, 3)));
        }
        held.push((axis, value));
    }
    Ok(held)
}

/// Criteria for the choice of the free axes.
#[derive(Clone, Copy)]
pub(crate) struct Aim<'a> {
    /// Maximum speed along the path, mm/s.
    pub(crate) speed: f64,
    pub(crate) wishes: &'a SpareAxes,
    /// Obstacles to keep clear of.
    pub(crate) clearance: Option<Clearance<'a>>,
    /// Welding positions that take precedence over the preferred ones.
    pub(crate) positions: Option<AllowedPositions<'a>>,
    /// False if the reason for a missing path is not needed: without a closed form it is slow to find.
    pub(crate) explains: bool,
}

/// Resolves the free axes of `machine` along `path`, welded at up to `speed` mm/s: continuous, twice continuously
/// differentiable, within their ranges, of minimum cost by the weights of `wishes`. Without free axes returns the
/// default. They are those of the machine of [`holding`].
///
/// # Errors
/// Findings of pass `pass` with the stretches without a path and the reasons.
pub fn resolve(
    machine: &Machine,
    path: &dyn TorchPath,
    speed: f64,
    wishes: &SpareAxes,
    clearance: Option<Clearance>,
    pass: usize,
) -> Result<FreeAxes, Vec<Finding>> {
    let machine = holding(machine, wishes).map_err(|e| vec![explain::hold(e, path.length(), pass)])?;
    let aim = Aim { speed, wishes, clearance, positions: None, explains: true };
    resolve_within(&Effort::new(None), &machine, path, aim, pass)
}

/// Resolves as [`resolve`], for a `machine` whose held axes are free; `effort` may stop the search.
pub(crate) fn resolve_within(
    effort: &Effort,
    machine: &Machine,
    path: &dyn TorchPath,
    aim: Aim,
    pass: usize,
) -> Result<FreeAxes, Vec<Finding>> {
    if path.axes(0.0).is_some() {
        return Ok(FreeAxes::default());
    }
    let still = held(machine, aim.wishes).map_err(|e| vec![explain::hold(e, path.length(), pass)])?;
    let two = path.second(0.0).is_some();
    if let (true, Some(&(axis, _))) = (two, still.first()) {
        // Two torches determine every axis.
        return Err(vec![explain::hold(needed(&machine.axes[axis].name), path.length(), pass)]);
    }
    if machine.free().is_empty() || two {
        return Ok(FreeAxes::default());
    }
    let task = Task::new(effort, machine, path, aim, &still);
    if task.free.is_empty() {
        return Ok(FreeAxes { length: path.length(), still, moving: Vec::new(), start: None });
    }
    let alike = task.search(&still, pass)?;
    if alike.inside || task.winding == task.endless() || task.telling_turns() > MAX_TURNS {
        return Ok(alike.free);
    }
    let apart = Task { winding: task.endless(), ..task };
    let other = apart.search(&still, pass);
    effort.check(pass, path.length())?;
    Ok(other.map_or(alike.free, |found| found.free))
}

/// The free axes found, with a flag that all axes stay in their ranges.
struct Found {
    free: FreeAxes,
    inside: bool,
}

/// Problem of the search.
struct Task<'a> {
    effort: &'a Effort<'a>,
    machine: &'a Machine,
    path: &'a dyn TorchPath,
    /// The axes to resolve.
    free: Vec<usize>,
    /// Home, with the held axes at their positions.
    base: Joints,
    /// Axes whose positions a whole turn apart are equivalent.
    winding: AxisSet,
    /// See [`Aim::explains`].
    explains: bool,
    cost: Cost<'a>,
}

/// A station of the path.
struct Place {
    s: f64,
    target: Target,
    face: DVec3,
    tangent: DVec3,
}

impl<'a> Task<'a> {
    fn new(
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

    /// Runs a quick search, then a thorough one if that found no path inside the ranges.
    fn search(&self, still: &[(usize, f64)], pass: usize) -> Result<Found, Vec<Finding>> {
        let mut best: Option<Found> = None;
        let mut last = None;
        let efforts = if self.machine.heads[0].is_numeric() { NUMERIC_EFFORTS } else { EFFORTS };
        for (stations, samples) in efforts {
            let mut graph = graph::Graph::new(self, stations, samples);
            let mut ways = graph.ways();
            if let Some(best) = ways.first() {
                ways.push(self.closer(best.clone(), graph.steps.clone()));
            }
            ways.iter_mut().for_each(|way| self.turn_home(way));
            let refined = refine::refine(self, &ways, still.to_vec());
            self.effort.check(pass, self.path.length())?;
            if let Some((free, inside)) = refined {
                let found = Found { free, inside };
                if inside {
                    return Ok(found);
                }
                // The survey reports the axes out of range.
                best = best.or(Some(found));
            }
            last = Some(graph);
        }
        match (best, last) {
            (Some(found), _) => Ok(found),
            (None, Some(_)) if !self.explains => Err(Vec::new()),
            (None, Some(graph)) => {
                let findings = explain::no_way(self, &graph, pass);
                self.effort.check(pass, self.path.length())?;
                Err(findings)
            }
            (None, None) => Ok(Found { free: FreeAxes::default(), inside: true }),
        }
    }

    /// Rotary axes without a limited range.
    fn endless(&self) -> AxisSet {
        let rotary = |axis: &usize| self.machine.axes[*axis].kind == AxisKind::Rotary;
        (0..self.machine.axes.len()).filter(rotary).filter(|&axis| self.machine.axes[axis].range.is_none()).collect()
    }

    /// Approximate number of nodes per node if turns of all axes with ranges were distinguished.
    fn telling_turns(&self) -> f64 {
        let ranges = self.winding.iter().filter_map(|axis| self.machine.axes[axis].range);
        ranges.map(|(low, high)| ((high - low) / TAU).ceil()).product()
    }

    fn places(&self, stations: usize) -> Vec<Place> {
        let at = |i: usize| self.path.length() * i as f64 / stations as f64;
        (0..=stations).map(|i| self.place(at(i))).collect()
    }

    fn place(&self, s: f64) -> Place {
        let tangent = self.path.groove(s).map_or_else(|| self.path.line(s).1, |groove| groove.tangent);
        Place { s, target: self.path.pose(s).into(), face: self.path.face(s), tangent }
    }

    /// The path through successively finer nodes about `way`, whose nodes are `steps` apart.
    fn closer(&self, mut way: Vec<Joints>, mut steps: Vec<f64>) -> Vec<Joints> {
        for _ in 0..FINER {
            way = graph::finer(self, &way, &steps).unwrap_or(way);
            steps.iter_mut().for_each(|s| *s *= 0.5);
        }
        way
    }

    /// True if positions of `axis` a whole turn apart are equivalent.
    fn winds(&self, axis: usize) -> bool {
        self.winding.has(axis)
    }

    /// Shortest displacement of `axis` from `a` to `b`, modulo turns if these are equivalent.
    fn way(&self, axis: usize, a: f64, b: f64) -> f64 {
        let d = b - a;
        if self.winds(axis) { d - TAU * (d / TAU).round() } else { d }
    }

    /// Turns winding axes by whole turns, so that they stay in their ranges if possible, and as near to home as
    /// possible.
    fn turn_home(&self, way: &mut [Joints]) {
        for (i, axis) in self.machine.axes.iter().enumerate().filter(|(i, _)| self.winds(*i)) {
            let (low, high) =
                way.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), q| (l.min(q[i]), h.max(q[i])));
            let home = ((axis.home - 0.5 * (low + high)) / TAU).round();
            let turns = axis.turns_within(low..=high, home).unwrap_or(home);
            way.iter_mut().for_each(|q| q[i] += TAU * turns);
        }
    }
}
