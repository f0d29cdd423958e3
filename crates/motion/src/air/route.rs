use super::Leg;
use crate::effort::{Effort, SearchStage};
use seamwright_clearance::{Evaluation, Limits};
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine, Surroundings};
use thiserror::Error;

/// Why there is no air move.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Blocked {
    /// One end touches something already.
    #[error("{which} is not clear: {what}")]
    End {
        /// Its start, its end, the retract or the approach.
        which: &'static str,
        /// Who is too near to whom.
        what: String,
    },
    /// No way round was found.
    #[error("no clear way was found; straight ahead {what}")]
    NoWay {
        /// What stands in the straight way.
        what: String,
    },
}

/// Places that the two trees may have together before the search is given up.
const MOST_PLACES: usize = 4000;
/// Units of effort of a leg that is checked.
const LEG_WORK: u64 = 32;
/// Longest step of a tree, in parts of the time that an axis needs for its whole range.
const STEP: f64 = 0.12;
/// How finely legs are looked at.
const LIMITS: Limits = Limits { cutoff_mm: 50.0, precision_mm: 1.0, smallest: 1e-4 };

/// A way from `from` to `to` (mm or rad) that keeps clear of everything watched, as positions to go straight between;
/// axes in `held` do not move.
///
/// The straight way if it is clear; otherwise two trees that grow towards each other through the axes' ranges
/// (RRT-Connect, Kuffner and LaValle 2000), with the random places of that method taken from an evenly spread
/// sequence, so that the same question has the same answer; then every detour that can be cut short is. Every leg is
/// checked by the conservative walk of [`Surroundings::along`]: nothing thin is jumped over.
///
/// # Errors
/// What stands in the way.
pub fn route(
    machine: &Machine,
    around: &Surroundings,
    from: &Joints,
    to: &Joints,
    held: AxisSet,
) -> Result<Vec<Joints>, Blocked> {
    route_within(&Effort::new(None), machine, around, (from, to), held)
}

/// Returns what [`route`] does, with `effort` to stop the search.
pub(crate) fn route_within(
    effort: &Effort,
    machine: &Machine,
    around: &Surroundings,
    (from, to): (&Joints, &Joints),
    held: AxisSet,
) -> Result<Vec<Joints>, Blocked> {
    effort.begin(SearchStage::Transfer);
    for (which, q) in [("its start", from), ("its end", to)] {
        if !around.is_clear(q) {
            let found = around.nearest(q, LIMITS.cutoff_mm);
            let what = found.map_or_else(String::new, |(watch, e)| too_near(around, watch, &e));
            return Err(Blocked::End { which, what });
        }
    }
    let search = Search { effort, machine, around, held, turns: turns(machine, from, to) };
    let Some(obstacle) = search.obstacle(from, to) else { return Ok(vec![*from, *to]) };
    let way = search.grow(from, to).ok_or(Blocked::NoWay { what: obstacle })?;
    Ok(search.cut_short(&way))
}

/// Who is too near to whom.
pub(crate) fn too_near(around: &Surroundings, watch: usize, found: &Evaluation) -> String {
    let (a, b) = around.solids_described(watch, found).unwrap_or_else(|| around.names(watch));
    let least = around.scene().watches()[watch].least_mm();
    if found.distance > 0.005 {
        format!("{a} comes within {:.2} mm of {b} (at least {least} mm)", found.distance)
    } else {
        format!("{a} collides with {b} (at least {least} mm)")
    }
}

/// What stands in the way of a leg, if anything does.
pub(crate) fn obstacle(around: &Surroundings, leg: &Leg) -> Option<String> {
    match around.along(leg, 1, &LIMITS) {
        Ok(profile) => profile.stretches.first().map(|stretch| too_near(around, stretch.watch, &stretch.nearest)),
        // What cannot be looked at is not clear.
        Err(e) => Some(e.to_string()),
    }
}

struct Search<'a> {
    effort: &'a Effort<'a>,
    machine: &'a Machine,
    around: &'a Surroundings<'a>,
    held: AxisSet,
    /// Whole turns of continuous axes to which sampled positions are moved.
    turns: Joints,
}

/// A tree of places, each with the one it was reached from.
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

/// Continuous axes are sampled about the middle of the two ends.
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
    /// What stands in the straight way, if anything does.
    fn obstacle(&self, from: &Joints, to: &Joints) -> Option<String> {
        let part = self.effort.progress().part;
        // A leg takes as long as many poses; once stopped nothing is tried any more.
        if !self.effort.spend(LEG_WORK, part) {
            return Some(String::new());
        }
        obstacle(self.around, &Leg::new(self.machine, from, to))
    }

    /// Distance of two places: the largest part of its range that an axis has to move.
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
            if trees[0].places.len() + trees[1].places.len() > MOST_PLACES || k > 4 * MOST_PLACES as u32 {
                return None;
            }
            let places = trees[0].places.len() + trees[1].places.len();
            let part = (places as f64 / MOST_PLACES as f64).max(f64::from(k) / (4 * MOST_PLACES) as f64);
            if !self.effort.spend(0, part) {
                return None;
            }
            let sample = self.sample(k, from);
            let turn = (k % 2) as usize;
            let Some(new) = self.extend(&mut trees[turn], &sample) else { continue };
            let target = trees[turn].places[new].0;
            // The other tree goes as far towards the new place as it can.
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

    /// One step from the tree's nearest place towards `target`, if it is clear; the new place.
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
        if self.obstacle(&from, &to).is_some() {
            return None;
        }
        tree.places.push((to, nearest));
        Some(tree.places.len() - 1)
    }

    /// Leaves out every place that need not be passed, and pulls the others in.
    fn cut_short(&self, way: &[Joints]) -> Vec<Joints> {
        let mut short = vec![way[0]];
        let mut at = 0;
        while at + 1 < way.len() {
            let last = (at + 1..way.len()).rev().find(|&j| j == at + 1 || self.obstacle(&way[at], &way[j]).is_none());
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

    /// Moves place `i` towards the middle of its neighbours as far as its legs stay clear.
    fn pull_in(&self, way: &mut [Joints], i: usize) {
        let middle: Joints = std::array::from_fn(|k| 0.5 * (way[i - 1][k] + way[i + 1][k]));
        for part in [0.8, 0.4, 0.2] {
            let to: Joints = std::array::from_fn(|k| way[i][k] + part * (middle[k] - way[i][k]));
            if self.obstacle(&way[i - 1], &to).is_none() && self.obstacle(&to, &way[i + 1]).is_none() {
                way[i] = to;
                return;
            }
        }
    }
}
