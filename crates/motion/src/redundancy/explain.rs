use super::graph::Graph;
use super::hold_error::HoldError;
use super::task::Task;
use crate::speed_findings::Runs;
use seamwright_machine::{AxisKind, Joints};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, PathRange};
use std::f64::consts::TAU;

/// Number of samples of the free axes used to find the reason for an inverse without closed form.
const NUMERIC_SAMPLES: usize = 4;
/// Key in [`Runs`] of a station that is out of reach for another reason than the range of an axis; axis `i` has the key
/// `i + 1`.
const NO_AXIS: usize = 0;

pub(crate) fn hold(error: HoldError, length: f64, pass: usize) -> Finding {
    let cure = Message::new("document-allowed").message("allowed", error.allowed);
    Finding::error("hold", error.message, pass, PathRange::up_to(length), cure)
}

/// Reasons for a missing path: unreachable stations, or reachable ones without a connection.
pub(super) fn no_way(task: &Task, graph: &Graph, pass: usize) -> Vec<Finding> {
    let mut runs = Runs::default();
    let samples = graph.samples();
    // Without a closed form a search at every sample would take minutes.
    let stride = if task.machine.heads[0].is_numeric() { samples.len().div_ceil(NUMERIC_SAMPLES) } else { 1 };
    let samples: Vec<Joints> = samples.into_iter().step_by(stride).collect();
    for (place, nodes) in graph.places.iter().zip(&graph.nodes) {
        let why = nodes.is_empty().then(|| nearest_miss(task, &samples, place.s));
        runs.add(place.s, why);
    }
    let unreachable = runs.findings(|run| {
        let kind = if run.key == NO_AXIS { "reach" } else { "range" };
        let message = Message::new("motion-unreachable-redundant").text("machine", task.machine.name.as_str());
        let message = message.message("reason", run.message.clone());
        Finding::error(kind, message, pass, run.stretch(), Message::new("motion-cure-unreachable-redundant"))
    });
    if unreachable.is_empty() {
        return vec![jump(task, graph, pass).unwrap_or_else(|| not_smooth(task, pass))];
    }
    unreachable
}

fn not_smooth(task: &Task, pass: usize) -> Finding {
    let message = Message::new("motion-not-smooth-redundant").text("machine", task.machine.name.as_str());
    let whole = PathRange::up_to(task.path.length());
    Finding::error("singular", message, pass, whole, Message::new("motion-cure-not-tried"))
}

/// Sample of the free axes that comes nearest to reaching path length `s`: the axis out of range and its excess, as a
/// complaint for [`Runs`].
fn nearest_miss(task: &Task, samples: &[Joints], s: f64) -> (usize, f64, Message) {
    let place = task.place(s);
    let (mut least, mut reason) = (f64::INFINITY, (NO_AXIS, 0.0, Message::new("motion-no-positions")));
    for q in samples {
        if !task.effort.spend(1, task.effort.progress().part) {
            break;
        }
        match task.inverse(place.target, q) {
            Ok(branches) => {
                for branch in branches.iter() {
                    let (axis, by, part) = worst(task, &task.machine.turned_into_range(&branch.joints));
                    if part < least {
                        let a = &task.machine.axes[axis];
                        let by = a.to_file(by);
                        least = part;
                        let message = Message::new("motion-axis-beyond").axis("axis", a.name.as_str());
                        let message = message.quantity("by", by, a.position_unit(), 3);
                        reason = (axis + 1, by, message);
                    }
                }
            }
            Err(error) if least.is_infinite() => reason = (NO_AXIS, 0.0, error.message()),
            Err(_) => {}
        }
    }
    reason
}

/// The axis farthest outside its range: its index, the excess, and the excess as a fraction of the range.
fn worst(task: &Task, q: &Joints) -> (usize, f64, f64) {
    let mut worst = (0, 0.0, 0.0);
    for (i, axis) in task.machine.axes.iter().enumerate() {
        if let (Some(limit), Some((low, high))) = (axis.outside(q[i]), axis.range) {
            let by = (q[i] - limit).abs();
            if by / (high - low) > worst.2 {
                worst = (i, by, by / (high - low));
            }
        }
    }
    worst
}

/// Finding for the station at which all paths end, with the axis that would have to jump there.
fn jump(task: &Task, graph: &Graph, pass: usize) -> Option<Finding> {
    let reached = |k: usize| graph.nodes[k].iter().enumerate().filter(|(_, n)| n.total.is_finite());
    let k = (1..graph.nodes.len()).find(|&k| reached(k).next().is_none())?;
    // If rotary axes jump, the linear ones only follow them.
    let rotary = task.machine.axes.iter().any(|axis| axis.kind == AxisKind::Rotary);
    let farthest = |a: &Joints, b: &Joints| {
        let may = task.machine.axes.iter().enumerate().filter(|(_, axis)| !rotary || axis.kind == AxisKind::Rotary);
        let ways = may.map(|(i, axis)| {
            let d = task.way(i, a[i], b[i]).abs();
            // Relative to the axis' range.
            (d / axis.range.map_or(TAU, |(low, high)| high - low), i, d)
        });
        ways.fold((0.0, 0, 0.0), |most, way| if way.0 > most.0 { way } else { most })
    };
    // Edges that were struck out are excluded: they look short but are discontinuous.
    let pairs = reached(k - 1).flat_map(|(i, a)| {
        let ahead = graph.nodes[k].iter().enumerate().filter(move |(j, _)| !graph.is_struck(k, i, *j));
        ahead.map(|(_, b)| farthest(&a.q, &b.q)).collect::<Vec<_>>()
    });
    let (_, axis, by) = pairs.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let axis = &task.machine.axes[axis];
    let (from_mm, to_mm) = (graph.places[k - 1].s, graph.places[k].s);
    let message = Message::new("motion-jump")
        .quantity("from", from_mm, Unit::Mm, 1)
        .quantity("to", to_mm, Unit::Mm, 1)
        .axis("axis", axis.name.as_str())
        .quantity("by", axis.to_file(by), axis.position_unit(), 1);
    Some(Finding::error("jump", message, pass, PathRange { from_mm, to_mm }, Message::new("motion-cure-jump")))
}
