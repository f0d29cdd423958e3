//! Redundancy resolution: the axes that a pose decides if the chain has more than it needs.

use crate::axis::{Axis, AxisKind};
use crate::chain::{AxisSet, Chain, Joints};
use glam::DVec3;
use seamwright_geometry::Pose;
use std::f64::consts::PI;

/// Freedoms of a point with a direction.
const FREEDOMS: usize = 5;

/// Number of configurations at which a choice is judged.
const JUDGED: u32 = 12;
/// Minimum fraction of the unit volume: axes that span less everywhere cannot reach every pose.
const INDEPENDENT: f64 = 1e-6;
/// Preferred minimum range of a rotary axis decided by the pose, rad: a narrower one would often leave its range.
const NARROW: f64 = 0.5 * PI;

/// The axes to hold so that the rest exactly suffices for a point and a direction.
///
/// With three independent linear axes: those with the longest strokes, and the two rotary axes that best turn the torch
/// near home. Wide ranges and the torch side are preferred. Otherwise the five axes that span the freedoms best over
/// their ranges.
pub(crate) fn held(chain: &Chain, axes: &[Axis]) -> AxisSet {
    chain.axes().different(decided(chain, axes, AxisSet::default()))
}

/// The axes to hold, including those of `wanted`, so that the rest still suffices; none if impossible.
pub(crate) fn held_with(chain: &Chain, axes: &[Axis], wanted: AxisSet) -> Option<AxisSet> {
    let without = decided(chain, axes, AxisSet::default());
    let decided = decided(chain, axes, wanted);
    let as_many = decided.iter().count() == without.iter().count();
    let spans = decided.iter().count() < FREEDOMS || spread_volume(chain, axes, decided) > INDEPENDENT;
    (as_many && spans).then(|| chain.axes().different(decided))
}

/// The axes that the pose decides, none of them in `held`.
fn decided(chain: &Chain, axes: &[Axis], held: AxisSet) -> AxisSet {
    let of_kind = |kind| chain.screws.iter().filter(move |s| s.kind == kind && !held.has(s.axis)).map(|s| s.axis);
    let linear: Vec<usize> = of_kind(AxisKind::Linear).collect();
    let rotary: Vec<usize> = of_kind(AxisKind::Rotary).collect();
    if let Some(triple) = best_triple(chain, axes, &linear) {
        let pair = if rotary.len() > 2 { best_pair(chain, axes, &rotary) } else { rotary.iter().copied().collect() };
        return triple.union(pair);
    }
    let left: AxisSet = linear.into_iter().chain(rotary).collect();
    if left.iter().count() <= FREEDOMS { left } else { best_five(chain, axes, left) }
}

/// Maximum fraction of the unit volume spanned by the axes of `five` at positions spread over their ranges.
fn spread_volume(chain: &Chain, axes: &[Axis], five: AxisSet) -> f64 {
    let five: Vec<usize> = five.iter().collect();
    let volumes = (1..=JUDGED).map(|k| {
        let q = spread(axes, k);
        volume(&chain.forward(&q), &chain.jacobian(&q), &five)
    });
    volumes.fold(0.0, f64::max)
}

fn stroke(axis: &Axis) -> f64 {
    axis.range.map_or(4.0 * PI, |(low, high)| high - low)
}

/// Range of a rotary axis relative to the recommended one of a decided axis, at most 1; 1 for linear axes.
fn room(axis: &Axis) -> f64 {
    if axis.kind == AxisKind::Rotary { (stroke(axis) / NARROW).min(1.0) } else { 1.0 }
}

/// Three linear axes that span space, with the maximum product of strokes and volume.
fn best_triple(chain: &Chain, axes: &[Axis], linear: &[usize]) -> Option<AxisSet> {
    let direction = |axis: usize| chain.screws.iter().find(|s| s.axis == axis).map_or(DVec3::ZERO, |s| s.direction);
    let triples = subsets(linear, 3).into_iter().filter_map(|t| {
        let volume = direction(t[0]).cross(direction(t[1])).dot(direction(t[2])).abs();
        let strokes: f64 = t.iter().map(|&a| stroke(&axes[a])).product();
        (volume > 1e-3).then_some((volume * strokes, t))
    });
    triples.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, t)| t.into_iter().collect())
}

/// The two rotary axes that best turn the torch about home.
fn best_pair(chain: &Chain, axes: &[Axis], rotary: &[usize]) -> AxisSet {
    let home = crate::inverse::choice::home(axes);
    let columns = chain.jacobian(&home);
    let later = |axis: usize| chain.screws.iter().position(|s| s.axis == axis).unwrap_or(0) as f64;
    let score = |pair: &[usize]| {
        let [a, b] = [columns[pair[0]].1, columns[pair[1]].1];
        // Priority: rotation near home; if every pair is singular there, axes that are not parallel; then the torch
        // side.
        let [u, v] =
            [pair[0], pair[1]].map(|p| chain.screws.iter().find(|s| s.axis == p).map_or(DVec3::ZERO, |s| s.direction));
        let home = (a.cross(b).length() * 10.0).round() / 10.0;
        let turns = home + 0.1 * u.cross(v).length() + 1e-3 * (later(pair[0]) + later(pair[1]));
        turns * room(&axes[pair[0]]) * room(&axes[pair[1]])
    };
    let best = subsets(rotary, 2).into_iter().max_by(|a, b| score(a).total_cmp(&score(b)));
    best.into_iter().flatten().collect()
}

/// The five axes whose Jacobian is best conditioned over their ranges.
fn best_five(chain: &Chain, axes: &[Axis], of: AxisSet) -> AxisSet {
    let indices: Vec<usize> = of.iter().collect();
    let judged: Vec<_> =
        (1..=JUDGED).map(|k| (spread(axes, k), k)).map(|(q, _)| (chain.forward(&q), chain.jacobian(&q))).collect();
    let score = |five: &[usize]| -> f64 {
        let room: f64 = five.iter().map(|&axis| room(&axes[axis]).ln()).sum();
        let volumes = judged.iter().map(|(tip, columns)| volume(tip, columns, five).max(1e-12).ln());
        f64::from(JUDGED) * room + volumes.sum::<f64>()
    };
    let best = subsets(&indices, FREEDOMS).into_iter().max_by(|a, b| score(a).total_cmp(&score(b)));
    best.into_iter().flatten().collect()
}

/// Fraction of the unit volume spanned by five columns of the Jacobian, each scaled to length 1.
fn volume(tip: &Pose, columns: &[(DVec3, DVec3)], five: &[usize]) -> f64 {
    let (u, v) = tip.direction.any_orthonormal_pair();
    let mut rows: Vec<[f64; FREEDOMS]> = five
        .iter()
        .map(|&i| {
            let (p, d) = columns[i];
            // A rad of direction counts like 100 mm.
            [p.x, p.y, p.z, 100.0 * d.dot(u), 100.0 * d.dot(v)]
        })
        .collect();
    let mut volume = 1.0;
    for i in 0..rows.len() {
        let before = dot(&rows[i], &rows[i]).sqrt();
        for k in 0..i {
            let along = dot(&rows[i], &rows[k]);
            let base = rows[k];
            rows[i].iter_mut().zip(base).for_each(|(a, b)| *a -= along * b);
        }
        let length = dot(&rows[i], &rows[i]).sqrt();
        if length <= 1e-12 * before.max(1e-300) {
            return 0.0;
        }
        volume *= length / before;
        rows[i].iter_mut().for_each(|a| *a /= length);
    }
    volume
}

fn dot(a: &[f64; FREEDOMS], b: &[f64; FREEDOMS]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The `k`-th of positions spread evenly over the axes' ranges: the additive recurrence with the generalised golden
/// ratio, which fills the box uniformly.
pub(crate) fn spread(axes: &[Axis], k: u32) -> Joints {
    let mut q = Joints::default();
    // The root of x^(n+1) = x + 1 for n = 12 axes.
    const ROOT: f64 = 1.057_050_575_221_228_5;
    let mut step = 1.0;
    for (value, axis) in q.iter_mut().zip(axes) {
        step /= ROOT;
        let (low, high) = axis.range.unwrap_or((-PI, PI));
        let (low, high) = match axis.kind {
            // One turn of a rotary axis suffices.
            AxisKind::Rotary if high - low > 2.0 * PI => (0.5 * (low + high) - PI, 0.5 * (low + high) + PI),
            _ => (low, high),
        };
        *value = low + (high - low) * (0.5 + step * f64::from(k)).fract();
    }
    q
}

/// All subsets of `size` elements.
fn subsets(of: &[usize], size: usize) -> Vec<Vec<usize>> {
    if size == 0 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for i in 0..of.len() {
        for mut rest in subsets(&of[i + 1..], size - 1) {
            rest.insert(0, of[i]);
            all.push(rest);
        }
    }
    all
}

pub(super) fn home(axes: &[Axis]) -> Joints {
    std::array::from_fn(|i| axes.get(i).map_or(0.0, |a| a.home))
}
