use super::continuation;
use super::cost::{Cost, Place};
use super::task::Task;
use crate::effort::SearchStage;
use seamwright_machine::{AxisKind, Joints};
use std::collections::HashSet;
use std::f64::consts::{FRAC_PI_3, TAU};

/// Spacing of samples of a rotary axis (rad) and number over a linear one, if the number of samples allows.
const ROTARY_STEP: f64 = 15.0 * std::f64::consts::PI / 180.0;
const LINEAR_SAMPLES: usize = 9;
/// Minimum spacing of samples, rad and mm, except for three over any range.
const FINEST_TURN: f64 = 0.15 * std::f64::consts::PI / 180.0;
const FINEST_MM: f64 = 0.5;
/// Maximum move of a free axis from one station to the next, in samples, or up to the limit of the others.
const WINDOW: f64 = 3.01;
/// Maximum turn of a rotary axis, rad: a larger one is another branch.
const MAX_TURN: f64 = FRAC_PI_3;
/// Maximum number of different paths that are refined, their maximum cost relative to the best, and the additional cost
/// per station.
const WAYS: usize = 16;
const MORE: f64 = 3.0;
const MORE_A_STATION: f64 = 0.02;
/// Maximum number of rounds in which discontinuous edges are struck out.
const MAX_STRIKE_ROUNDS: usize = 60;
/// Units of effort of joining two stations.
const EDGE_WORK: u64 = 64;
/// Steps between two stations in the test of continuity.
const WALKED: usize = 8;

/// A branch of the inverse at one station and one sample of the free axes.
pub(super) struct Node {
    pub(super) q: Joints,
    /// Configuration of a six-axis arm, 0 for other machines: it changes in singularities only, which have no edges.
    branch: u8,
    place: f64,
    /// Minimum cost from here to the end, and the next station's node on that path.
    onward: (f64, usize),
    /// Minimum cost from the start to here, and the previous station's node on that path; infinite without a path.
    pub(super) total: f64,
    from: usize,
}

type Struck = HashSet<(usize, usize, usize)>;

pub(super) struct Graph<'t, 'a> {
    task: &'t Task<'a>,
    pub(super) places: Vec<Place>,
    pub(super) nodes: Vec<Vec<Node>>,
    /// Samples of each free axis if all stations have the same, and their spacing.
    grids: Vec<Vec<f64>>,
    pub(super) steps: Vec<f64>,
    /// Edges (station, from, to) that look short but are discontinuous.
    struck: Struck,
}

impl<'t, 'a> Graph<'t, 'a> {
    /// Builds the graph over the whole ranges of the free axes, with about `samples` combinations at each station.
    pub(super) fn new(task: &'t Task<'a>, stations: usize, samples: usize) -> Self {
        let grids = grids(task, samples);
        let steps = grids.iter().zip(&task.free).map(|(g, &axis)| spacing(task, axis, g)).collect();
        let places = task.places(stations);
        task.effort.begin(SearchStage::Sampling);
        let nodes: Vec<Vec<Node>> = if task.machine.heads[0].is_numeric() {
            let cells = continuation::branches(task, &places, &combinations(task, &task.base, &grids), &grids);
            let of_place = |(cells, place): (Vec<Vec<Joints>>, &Place)| {
                cells.iter().flatten().flat_map(|q| turned(task, place, q)).collect()
            };
            cells.into_iter().zip(&places).map(of_place).collect()
        } else {
            let count = places.len() as f64;
            let of_place = |(k, place): (usize, &Place)| nodes(task, place, &task.base, &grids, k as f64 / count);
            places.iter().enumerate().map(of_place).collect()
        };
        let mut graph = Self { task, places, nodes, grids, steps, struck: HashSet::new() };
        task.effort.begin(SearchStage::Joining);
        let mut from = 1;
        for round in 0..MAX_STRIKE_ROUNDS {
            if !task.effort.spend(1, round as f64 / MAX_STRIKE_ROUNDS as f64) {
                break;
            }
            graph.solve(from);
            let Some(way) = graph.way() else { break };
            let broken: Vec<_> = (1..way.len()).filter(|&k| !graph.continuous(k, way[k - 1], way[k])).collect();
            if broken.is_empty() {
                break;
            }
            // Stations before the first edge that is struck out keep their totals.
            from = broken[0];
            graph.struck.extend(broken.into_iter().map(|k| (k, way[k - 1], way[k])));
        }
        graph
    }

    /// Positions along the best path.
    pub(super) fn best(&self) -> Option<Vec<Joints>> {
        self.way().map(|way| self.positions(&way))
    }

    /// Positions along the best path, and along others of similar cost through nodes as far apart as possible: the
    /// samples do not include the cost of acceleration, by which one of these may be best. Empty without a path.
    pub(super) fn ways(&mut self) -> Vec<Vec<Joints>> {
        let Some(best) = self.way() else { return Vec::new() };
        self.solve_onward();
        let middle = self.nodes.len() / 2;
        let nodes = &self.nodes[middle];
        let through = |i: usize| nodes[i].total + nodes[i].onward.0;
        let most = MORE * through(best[middle]) + MORE_A_STATION * self.nodes.len() as f64;
        let close: Vec<usize> = (0..nodes.len()).filter(|&i| through(i) <= most).collect();
        let apart = |a: usize, b: usize| -> f64 {
            let parts = self.task.free.iter().map(|&axis| {
                let span = self.task.axes[axis].range.map_or(0.5 * TAU, |(low, high)| high - low);
                (self.task.way(axis, nodes[a].q[axis], nodes[b].q[axis]) / span).powi(2)
            });
            parts.sum()
        };
        let mut chosen = vec![best[middle]];
        // Takes the node farthest from all chosen ones next.
        let mut nearest: Vec<f64> = close.iter().map(|&i| apart(chosen[0], i)).collect();
        while chosen.len() < WAYS {
            let Some(next) = (0..close.len()).max_by(|&a, &b| nearest[a].total_cmp(&nearest[b])) else { break };
            if nearest[next] <= 0.0 {
                break;
            }
            chosen.push(close[next]);
            close.iter().zip(&mut nearest).for_each(|(&i, d)| *d = d.min(apart(close[next], i)));
        }
        let mut ways = vec![self.positions(&best)];
        for &start in &chosen[1..] {
            let mut way = vec![start];
            (1..=middle).rev().for_each(|k| way.push(self.nodes[k][way[way.len() - 1]].from));
            way.reverse();
            (middle..self.nodes.len() - 1).for_each(|k| way.push(self.nodes[k][way[way.len() - 1]].onward.1));
            if (1..way.len()).all(|k| self.continuous(k, way[k - 1], way[k])) {
                ways.push(self.positions(&way));
            }
        }
        ways
    }

    /// Positions along a path, with continuous axes unwrapped.
    fn positions(&self, way: &[usize]) -> Vec<Joints> {
        let mut rows: Vec<Joints> = Vec::with_capacity(way.len());
        for (k, &i) in way.iter().enumerate() {
            let mut q = self.nodes[k][i].q;
            if let Some(before) = rows.last() {
                for (axis, value) in q.iter_mut().enumerate().take(self.task.axes.len()) {
                    *value = before[axis] + self.task.way(axis, before[axis], *value);
                }
            }
            rows.push(q);
        }
        rows
    }

    pub(super) fn samples(&self) -> Vec<Joints> {
        combinations(self.task, &self.task.base, &self.grids)
    }

    /// Dynamic programming: computes the minimum total at every node of station `first` (at least 1) and later ones.
    fn solve(&mut self, first: usize) {
        if first == 1 {
            self.nodes[0].iter_mut().for_each(|n| n.total = n.place);
        }
        for k in first..self.nodes.len() {
            let part = self.task.effort.progress().part;
            if !self.task.effort.spend(EDGE_WORK, part) {
                return;
            }
            let (before, here) = self.nodes.split_at_mut(k);
            let before = &before[k - 1];
            for (j, node) in here[0].iter_mut().enumerate() {
                (node.total, node.from) = (f64::INFINITY, 0);
                for (i, from) in before.iter().enumerate().filter(|(_, n)| n.branch == node.branch) {
                    if from.total + node.place >= node.total {
                        continue;
                    }
                    let edge = edge(self.task, &self.places[k - 1..=k], &self.steps, &from.q, &node.q);
                    let total = from.total + edge.unwrap_or(f64::INFINITY) + node.place;
                    if total < node.total && !struck(&self.struck, k, i, j) {
                        (node.total, node.from) = (total, i);
                    }
                }
            }
        }
    }

    /// True if the edge to node `j` of station `k` from node `i` of the previous one proved discontinuous.
    pub(super) fn is_struck(&self, k: usize, i: usize, j: usize) -> bool {
        struck(&self.struck, k, i, j)
    }

    /// Dynamic programming from the end: computes the minimum onward cost at every node.
    fn solve_onward(&mut self) {
        let end = self.nodes.len() - 1;
        self.nodes[end].iter_mut().for_each(|n| n.onward.0 = 0.0);
        for k in (1..=end).rev() {
            let part = self.task.effort.progress().part;
            if !self.task.effort.spend(EDGE_WORK, part) {
                return;
            }
            let (before, here) = self.nodes.split_at_mut(k);
            for (i, node) in before[k - 1].iter_mut().enumerate().filter(|(_, n)| n.total.is_finite()) {
                for (j, to) in here[0].iter().enumerate().filter(|(_, to)| to.branch == node.branch) {
                    if to.onward.0 + to.place >= node.onward.0 {
                        continue;
                    }
                    let edge = edge(self.task, &self.places[k - 1..=k], &self.steps, &node.q, &to.q);
                    let cost = to.onward.0 + to.place + edge.unwrap_or(f64::INFINITY);
                    if cost < node.onward.0 && !struck(&self.struck, k, i, j) {
                        node.onward = (cost, j);
                    }
                }
            }
        }
    }

    fn way(&self) -> Option<Vec<usize>> {
        let last = self.nodes.last()?;
        let end = (0..last.len()).min_by(|&a, &b| last[a].total.total_cmp(&last[b].total))?;
        last[end].total.is_finite().then_some(())?;
        let mut way = vec![end];
        for k in (1..self.nodes.len()).rev() {
            way.push(self.nodes[k][way[way.len() - 1]].from);
        }
        way.reverse();
        Some(way)
    }

    /// True if small steps from node `a` of the station before `k` lead to node `b` of station `k`.
    fn continuous(&self, k: usize, a: usize, b: usize) -> bool {
        let task = self.task;
        let (start, end) = (&self.nodes[k - 1][a].q, &self.nodes[k][b].q);
        let (from, to) = (self.places[k - 1].s, self.places[k].s);
        let mut q = *start;
        for i in 1..=WALKED {
            let x = i as f64 / WALKED as f64;
            for &axis in &task.free {
                q[axis] = start[axis] + x * task.way(axis, start[axis], end[axis]);
            }
            match task.inverse_next(task.path.pose(from + x * (to - from)).into(), &q) {
                Ok(solution) => q = solution.joints,
                Err(_) => return false,
            }
        }
        (0..task.axes.len()).all(|axis| task.way(axis, q[axis], end[axis]).abs() < 1e-5)
    }
}

fn struck(all: &Struck, k: usize, i: usize, j: usize) -> bool {
    !all.is_empty() && all.contains(&(k, i, j))
}

/// The best path through finer nodes about the path `rough`: half the spacing `steps`, twice the stations. None if no
/// path exists.
pub(super) fn finer(task: &Task, rough: &[Joints], steps: &[f64]) -> Option<Vec<Joints>> {
    let stations = 2 * (rough.len() - 1);
    let places = task.places(stations);
    let offsets: &[f64] = if task.free.len() <= 2 { &[0.0, -0.5, 0.5, -1.0, 1.0] } else { &[0.0, -0.5, 0.5] };
    let nodes = places.iter().enumerate().map(|(k, place)| {
        let (a, b) = (&rough[k / 2], &rough[k.div_ceil(2)]);
        let middle: Joints = std::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        let grid = |(&axis, step): (&usize, &f64)| -> Vec<f64> {
            let within = |v: &f64| task.axes[axis].outside(*v).is_none();
            offsets.iter().map(|o| middle[axis] + o * step).filter(within).collect()
        };
        let grids: Vec<Vec<f64>> = task.free.iter().zip(steps).map(grid).collect();
        self::nodes(task, place, &middle, &grids, task.effort.progress().part)
    });
    let nodes = nodes.collect();
    let steps = steps.iter().map(|s| 0.5 * s).collect();
    let mut graph = Graph { task, places, nodes, grids: Vec::new(), steps, struck: HashSet::new() };
    graph.solve(1);
    let way = graph.way()?;
    if (1..way.len()).any(|k| !graph.continuous(k, way[k - 1], way[k])) {
        return None;
    }
    Some(graph.positions(&way))
}

fn grids(task: &Task, samples: usize) -> Vec<Vec<f64>> {
    let range = |axis: usize| task.axes[axis].range.filter(|_| !task.winds(axis));
    let wanted = |&axis: &usize| match (task.axes[axis].kind, range(axis)) {
        (AxisKind::Linear, _) => LINEAR_SAMPLES as f64,
        (AxisKind::Rotary, Some((low, high))) => ((high - low) / ROTARY_STEP).ceil() + 1.0,
        (AxisKind::Rotary, None) => (TAU / ROTARY_STEP).ceil(),
    };
    let mut counts: Vec<f64> = task.free.iter().map(wanted).collect();
    // Scales the number of samples of all axes by the same factor.
    let factor = (samples as f64 / counts.iter().product::<f64>()).powf(1.0 / counts.len() as f64);
    let most = |axis: usize| {
        let span = range(axis).map_or(TAU, |(low, high)| high - low);
        let finest = if task.axes[axis].kind == AxisKind::Linear { FINEST_MM } else { FINEST_TURN };
        (span / finest).ceil() + 1.0
    };
    for (count, &axis) in counts.iter_mut().zip(&task.free) {
        *count = (*count * factor).round().min(most(axis)).max(3.0);
    }
    let grid = |(&axis, &count): (&usize, &f64)| {
        let sample = |i: usize| match range(axis) {
            Some((low, high)) => low + (high - low) * (0.004 + 0.992 * i as f64 / (count - 1.0)),
            None => task.base[axis] + TAU * i as f64 / count,
        };
        (0..count as usize).map(sample).collect()
    };
    task.free.iter().zip(&counts).map(grid).collect()
}

fn spacing(task: &Task, axis: usize, grid: &[f64]) -> f64 {
    task.way(axis, grid[0], grid[1]).abs()
}

/// Every branch at every combination of the samples, on every distinct turn within the ranges; `part` of the stage is
/// done. For an inverse without closed form, the branch that continues from `near`.
fn nodes(task: &Task, place: &Place, near: &Joints, grids: &[Vec<f64>], part: f64) -> Vec<Node> {
    let mut nodes = Vec::new();
    for q in combinations(task, near, grids) {
        if !task.effort.spend(1, part) {
            break;
        }
        let Ok(branches) = task.inverse_from(place.target, &q, Some(&q)) else { continue };
        nodes.extend(branches.iter().flat_map(|branch| turned(task, place, &branch.joints)));
    }
    nodes
}

/// Nodes at `q`, on every distinct turn.
fn turned(task: &Task, place: &Place, q: &Joints) -> Vec<Node> {
    let node = |q: Joints| {
        let cost = task.cost.place(&q, place).iter().map(|r| r * r).sum();
        let branch = task.machine.arm_configuration(&q).map_or(0, |arm| arm.branch());
        Node { q, branch, place: cost, onward: (f64::INFINITY, 0), total: f64::INFINITY, from: 0 }
    };
    turns(task, q).into_iter().map(node).collect()
}

/// `near` with each combination of samples of the free axes; the first axis' sample changes first.
fn combinations(task: &Task, near: &Joints, grids: &[Vec<f64>]) -> Vec<Joints> {
    let count: usize = grids.iter().map(Vec::len).product();
    let combination = |mut index: usize| {
        let mut q = *near;
        for (&axis, grid) in task.free.iter().zip(grids) {
            q[axis] = grid[index % grid.len()];
            index /= grid.len();
        }
        q
    };
    (0..count).map(combination).collect()
}

/// `q` with its dependent rotary axes on every distinct turn within their ranges; empty if an axis has no turn in its
/// range.
fn turns(task: &Task, q: &Joints) -> Vec<Joints> {
    let mut all = vec![*q];
    for (i, axis) in task.machine.axes.iter().enumerate() {
        let Some((low, high)) = axis.range else { continue };
        if task.winds(i) {
            // Turns are equivalent here: takes the one nearest to home, at which ranges cost least.
            let home = ((axis.home - q[i]) / TAU).round();
            let turns = axis.turns_within(q[i]..=q[i], home).unwrap_or(home);
            all.iter_mut().for_each(|q| q[i] += TAU * turns);
            continue;
        }
        if axis.kind == AxisKind::Linear || task.free.contains(&i) {
            all.retain(|q| axis.outside(q[i]).is_none());
            continue;
        }
        let (first, last) = (((low - q[i]) / TAU).ceil() as i32, ((high - q[i]) / TAU).floor() as i32);
        all = (first..=last)
            .flat_map(|k| {
                all.iter().map(move |q| {
                    let mut turned = *q;
                    turned[i] = axis.turned(q[i], f64::from(k));
                    turned
                })
            })
            .collect();
    }
    all
}

/// Cost of the motion from `a` to `b`, on the same scale as that of the nodes; none if too far.
fn edge(task: &Task, places: &[Place], steps: &[f64], a: &Joints, b: &Joints) -> Option<f64> {
    for (&axis, step) in task.free.iter().zip(steps) {
        let most = match task.axes[axis].kind {
            AxisKind::Linear => WINDOW * step,
            AxisKind::Rotary => MAX_TURN.max(WINDOW * step),
        };
        if task.way(axis, a[axis], b[axis]).abs() > most {
            return None;
        }
    }
    let h = places[1].s - places[0].s;
    let mut cost = 0.0;
    for (i, axis) in task.machine.axes.iter().enumerate() {
        let d = task.way(i, a[i], b[i]);
        if axis.kind == AxisKind::Rotary && d.abs() > MAX_TURN && !task.free.contains(&i) {
            return None;
        }
        cost += Cost::rate(d / h * task.cost.speed[i]);
    }
    Some(cost)
}
