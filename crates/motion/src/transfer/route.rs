use super::leg::Leg;
use super::too_near::too_near;
use crate::effort::{Effort, SearchStage};
use seamwright_clearance::Limits;
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine, Surroundings};
use seamwright_message::Message;

/// Maximum number of nodes of both trees together; the search then gives up.
const MAX_NODES: usize = 4000;
/// Units of effort of a leg that is checked.
const LEG_WORK: u64 = 32;
/// Maximum step of a tree, as a fraction of the axes' ranges (see `Search::apart`).
const STEP: f64 = 0.12;
/// Resolution of the clearance check of a leg.
const LIMITS: Limits = Limits { cutoff_mm: 50.0, precision_mm: 1.0, smallest: 1e-4 };

/// Finds a path from `from` to `to` (mm or rad) clear of everything watched, as via positions joined by straight moves;
/// axes in `held` do not move.
///
/// Returns the straight move if it is clear. Otherwise two trees grow towards each other through the axes' ranges
/// (RRT-Connect, Kuffner and LaValle 2000). Their samples come from an evenly spread sequence, so the result is
/// reproducible. Detours are then shortened. The conservative walk of [`Surroundings::along`] checks every leg: it
/// skips no thin obstacle.
///
/// # Errors
/// The end that is not clear or the straight move, with the obstacle.
pub fn route(
    machine: &Machine,
    around: &Surroundings,
    from: &Joints,
    to: &Joints,
    held: AxisSet,
) -> Result<Vec<Joints>, Message> {
    route_within(&Effort::new(None), machine, around, from, to, held)
}

/// Finds the same path as [`route`]; `effort` may stop the search.
pub(crate) fn route_within(
    effort: &Effort,
    machine: &Machine,
    around: &Surroundings,
    from: &Joints,
    to: &Joints,
    held: AxisSet,
) -> Result<Vec<Joints>, Message> {
    effort.begin(SearchStage::Transfer);
    for (code, q) in [("motion-transfer-start", from), ("motion-transfer-end", to)] {
        if !around.is_clear(q) {
            let found = around.nearest(q, LIMITS.cutoff_mm);
            let obstacle = found.map_or_else(Message::default, |(watch, e)| too_near(around, watch, &e, None));
            return Err(Message::new(code).message("obstacle", obstacle));
        }
    }
    let search = Search { effort, machine, around, held, turns: turns(machine, from, to) };
    if search.is_clear(from, to) {
        return Ok(vec![*from, *to]);
    }
    let none = || {
        let obstacle = obstacle(around, &Leg::new(machine, from, to)).unwrap_or_default();
        Message::new("motion-transfer-none").message("obstacle", obstacle)
    };
    let way = search.grow(from, to).ok_or_else(none)?;
    Ok(search.cut_short(&way))
}

/// Describes the first obstacle of a leg, if any.
pub(crate) fn obstacle(around: &Surroundings, leg: &Leg) -> Option<Message> {
    if is_clear(around, leg) {
        return None;
    }
    match around.along(leg, 1, &LIMITS) {
        Ok(profile) => profile.stretches.first().map(|stretch| too_near(around, stretch.watch, &stretch.nearest, None)),
        // An unchecked leg counts as not clear.
        Err(e) => Some(e.message()),
    }
}

fn is_clear(around: &Surroundings, leg: &Leg) -> bool {
    // An unchecked leg counts as not clear.
    around.is_clear_along(leg, &LIMITS).unwrap_or(false)
}

struct Search<'a> {
    effort: &'a Effort<'a>,
    machine: &'a Machine,
    around: &'a Surroundings<'a>,
    held: AxisSet,
    /// Whole turns of continuous axes to which sampled positions are moved.
    turns: Joints,
}

struct Tree {
    places: Vec<(Joints, usize)>,
}

impl Tree {
    fn way_to_root(&self, mut i: usize) -> Vec<Joints> {
        let mut way = vec![self.places[i].0];
        while i != 0 {
            i = self.places[i].1;
            way.push(self.places[i].0);
        }
        way
    }
}

/// Sampling offsets: continuous axes are sampled about the middle of the two ends.
fn turns(machine: &Machine, from: &Joints, to: &Joints) -> Joints {
    let mut middle = Joints::default();
    for (i, axis) in machine.axes.iter().enumerate() {
        if axis.range.is_none() {
            middle[i] = 0.5 * (from[i] + to[i]);
        }
    }
    middle
}

impl Search<'_> {
    /// True if the straight move is clear.
    fn is_clear(&self, from: &Joints, to: &Joints) -> bool {
        let part = self.effort.progress().part;
        // A leg costs as much as many poses; a stopped search tries no more legs.
        self.effort.spend(LEG_WORK, part) && is_clear(self.around, &Leg::new(self.machine, from, to))
    }

    /// Distance of two positions: Euclidean norm of the axes' moves, each as a fraction of its range.
    fn apart(&self, a: &Joints, b: &Joints) -> f64 {
        let part = |(i, axis): (usize, &seamwright_machine::Axis)| {
            let range = axis.range.map_or(std::f64::consts::TAU, |(low, high)| high - low);
            ((a[i] - b[i]) / range).powi(2)
        };
        self.machine.axes.iter().enumerate().map(part).sum::<f64>().sqrt()
    }

    fn grow(&self, from: &Joints, to: &Joints) -> Option<Vec<Joints>> {
        let mut trees = [Tree { places: vec![(*from, 0)] }, Tree { places: vec![(*to, 0)] }];
        for k in 1.. {
            if trees[0].places.len() + trees[1].places.len() > MAX_NODES || k > 4 * MAX_NODES as u32 {
                return None;
            }
            let places = trees[0].places.len() + trees[1].places.len();
            let part = (places as f64 / MAX_NODES as f64).max(f64::from(k) / (4 * MAX_NODES) as f64);
            if !self.effort.spend(0, part) {
                return None;
            }
            let sample = self.sample(k, from);
            let turn = (k % 2) as usize;
            let Some(new) = self.extend(&mut trees[turn], &sample) else { continue };
            let target = trees[turn].places[new].0;
            // The other tree grows towards the new node as far as it can.
            while let Some(reached) = self.extend(&mut trees[1 - turn], &target) {
                if self.apart(&trees[1 - turn].places[reached].0, &target) < 1e-9 {
                    let (mut way, other) = (trees[turn].way_to_root(new), trees[1 - turn].way_to_root(reached));
                    way.reverse();
                    way.extend(other.into_iter().skip(1));
                    if turn == 1 {
                        way.reverse();
                    }
                    return Some(way);
                }
            }
        }
        None
    }

    fn sample(&self, k: u32, from: &Joints) -> Joints {
        let mut q = self.machine.spread(k);
        for (i, axis) in self.machine.axes.iter().enumerate() {
            if self.held.has(i) {
                q[i] = from[i];
            } else if axis.kind == AxisKind::Rotary && axis.range.is_none() {
                q[i] += self.turns[i];
            }
        }
        q
    }

    /// Takes one step from the tree's nearest node towards `target`, if it is clear. Returns the index of the new node.
    fn extend(&self, tree: &mut Tree, target: &Joints) -> Option<usize> {
        let apart = |place: &(Joints, usize)| self.apart(&place.0, target);
        let nearest =
            (0..tree.places.len()).min_by(|&a, &b| apart(&tree.places[a]).total_cmp(&apart(&tree.places[b])))?;
        let from = tree.places[nearest].0;
        let distance = self.apart(&from, target);
        if distance < 1e-9 {
            return Some(nearest);
        }
        let part = (STEP / distance).min(1.0);
        let to = if part < 1.0 { std::array::from_fn(|i| from[i] + part * (target[i] - from[i])) } else { *target };
        if !self.is_clear(&from, &to) {
            return None;
        }
        tree.places.push((to, nearest));
        Some(tree.places.len() - 1)
    }

    /// Removes unnecessary via positions and pulls the others in.
    fn cut_short(&self, way: &[Joints]) -> Vec<Joints> {
        let mut short = vec![way[0]];
        let mut at = 0;
        while at + 1 < way.len() {
            let last = (at + 1..way.len()).rev().find(|&j| j == at + 1 || self.is_clear(&way[at], &way[j]));
            at = last.unwrap_or(at + 1);
            short.push(way[at]);
        }
        for _ in 0..3 {
            for i in 1..short.len().saturating_sub(1) {
                self.pull_in(&mut short, i);
            }
        }
        short
    }

    /// Moves via position `i` towards the middle of its neighbours as far as its legs stay clear.
    fn pull_in(&self, way: &mut [Joints], i: usize) {
        let middle: Joints = std::array::from_fn(|k| 0.5 * (way[i - 1][k] + way[i + 1][k]));
        for part in [0.8, 0.4, 0.2] {
            let to: Joints = std::array::from_fn(|k| way[i][k] + part * (middle[k] - way[i][k]));
            if self.is_clear(&way[i - 1], &to) && self.is_clear(&to, &way[i + 1]) {
                way[i] = to;
                return;
            }
        }
    }
}
