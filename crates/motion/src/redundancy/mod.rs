//! Redundancy resolution: a machine with more axes than a point and a direction need can weld the same seam with many
//! axis motions. The best one over the whole path is searched.
//!
//! **Graph.** At stations along the path the free axes are sampled, and every branch of the inverse is a node. Dynamic
//! programming finds the path of minimum cost through the nodes, then again with finer nodes about that path. It also
//! finds paths far from the best one, because samples do not show the cost of acceleration.
//!
//! **Six-axis arms** in closed form. The rotation about the torch is one more free axis, sampled over a turn. Every
//! configuration of the arm (shoulder, elbow, wrist) is a branch; edges keep it, since it changes in singularities only.
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
pub(crate) mod free_axes;
mod graph;
mod hold_error;
mod refine;
mod task;

use crate::effort::Effort;
pub use cost::Clearance;
pub(crate) use cost::{Aim, AllowedPositions};
pub(crate) use explain::hold as hold_finding;
pub use free_axes::FreeAxes;
pub use hold_error::HoldError;
use seamwright_machine::{AxisSet, Joints, Machine};
use seamwright_message::{Argument, Message};
use seamwright_program::{Finding, SpareAxes, TorchPath};
use std::borrow::Cow;
use task::Task;

/// Stations of the graph's first level and samples of the free axes there: a quick search, then a thorough one.
const EFFORTS: [(usize, usize); 2] = [(24, 216), (48, 800)];
/// Stations and samples for an inverse without closed form.
const NUMERIC_EFFORTS: [(usize, usize); 2] = [(24, 64), (48, 120)];
/// Stations and samples with the rotation about an arm's torch as the only free axis, and with external ones. Its branches
/// are continuous, so that few samples suffice: 7.5 degrees. Tried on nozzles welded by a UR10e, on the floor and with
/// a positioner.
const ROLL_EFFORTS: [(usize, usize); 2] = [(24, 48), (48, 96)];
const ARM_EFFORTS: [(usize, usize); 2] = [(24, 216), (48, 600)];
/// Maximum number of turns per node up to which nodes a whole turn apart are distinguished.
const MAX_TURNS: f64 = 8.0;
/// Number of levels of the graph after the first.
const FINER: usize = 2;

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
    let redundant = machine.free().iter().count() + usize::from(machine.has_free_roll());
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
    let aim = Aim { speed, wishes, clearance, positions: None, explains: true, is_quick: false };
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
    if !machine.is_redundant() || two {
        return Ok(FreeAxes::default());
    }
    let task = Task::new(effort, machine, path, aim, &still);
    if task.free.is_empty() {
        return Ok(FreeAxes { length: path.length(), still, ..FreeAxes::default() });
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

impl<'a> Task<'a> {
    /// Runs a quick search, then a thorough one if that found no path inside the ranges.
    fn search(&self, still: &[(usize, f64)], pass: usize) -> Result<Found, Vec<Finding>> {
        let mut best: Option<Found> = None;
        let mut last = None;
        let efforts = match self.roll {
            Some(_) if self.free.len() == 1 => ROLL_EFFORTS,
            Some(_) => ARM_EFFORTS,
            None if self.machine.heads[0].is_numeric() => NUMERIC_EFFORTS,
            None => EFFORTS,
        };
        let efforts = if self.is_quick { &efforts[..1] } else { &efforts[..] };
        for &(stations, samples) in efforts {
            let mut graph = graph::Graph::new(self, stations, samples);
            let mut ways = if self.is_quick { graph.best().into_iter().collect() } else { graph.ways() };
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

    /// The path through successively finer nodes about `way`, whose nodes are `steps` apart.
    fn closer(&self, mut way: Vec<Joints>, mut steps: Vec<f64>) -> Vec<Joints> {
        for _ in 0..FINER {
            way = graph::finer(self, &way, &steps).unwrap_or(way);
            steps.iter_mut().for_each(|s| *s *= 0.5);
        }
        way
    }
}
