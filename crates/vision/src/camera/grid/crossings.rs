//! Assignment of the dots to crossings of the grid.

use super::identified::{FEWEST_DOTS, GridError};
use crate::frame::Size;
use glam::{DVec2, IVec2};
use std::collections::{BTreeMap, VecDeque};

/// Maximum distance of a dot from the position predicted by its neighbour, as a part of their distance.
const OFF: f64 = 0.25;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    pub(super) place: IVec2,
    pub(super) px: DVec2,
}

/// Orders dots by their crossings, from the one nearest to the frame's middle outwards; x grows to the right, y down.
pub(super) fn ordered(dots: &[DVec2], size: Size) -> Result<Vec<Crossing>, GridError> {
    let few = |found| GridError::Few { found };
    let size = DVec2::new(size.width as f64, size.height as f64);
    let near = |p: DVec2| {
        let by = |i: &usize, j: &usize| dots[*i].distance_squared(p).total_cmp(&dots[*j].distance_squared(p));
        (0..dots.len()).filter(|i| dots[*i] != p).min_by(by)
    };
    let middle = near(0.5 * size).ok_or(few(dots.len()))?;
    let first = dots[near(dots[middle]).ok_or(few(dots.len()))?] - dots[middle];
    // The nearest neighbour may lie in any of four directions: quarter turns bring it to the right.
    let across = [first, first.perp(), -first, -first.perp()].into_iter().max_by(|a, b| a.x.total_cmp(&b.x));
    let across = across.unwrap_or(first);
    let cells = Cells::new(dots, across.length());
    let mut found: BTreeMap<[i32; 2], usize> = BTreeMap::from([([0, 0], middle)]);
    let mut places: BTreeMap<usize, IVec2> = BTreeMap::from([(middle, IVec2::ZERO)]);
    let mut queue = VecDeque::from([(middle, across, across.perp())]);
    while let Some((dot, right, down)) = queue.pop_front() {
        let place = places[&dot];
        for (step, way) in [(IVec2::X, right), (IVec2::NEG_X, -right), (IVec2::Y, down), (IVec2::NEG_Y, -down)] {
            let Some(next) = cells.nearest(dots[dot] + way, OFF * way.length()) else { continue };
            let there = place + step;
            if let Some(before) = places.get(&next) {
                if *before != there {
                    return Err(GridError::Tangled { x: dots[next].x, y: dots[next].y });
                }
                continue;
            }
            if found.contains_key(&there.to_array()) {
                return Err(GridError::Tangled { x: dots[next].x, y: dots[next].y });
            }
            found.insert(there.to_array(), next);
            places.insert(next, there);
            // The last step predicts the next one best.
            let met = dots[next] - dots[dot];
            let (right, down) = match (step.x, step.y) {
                (0, y) => (right, f64::from(y) * met),
                (x, _) => (f64::from(x) * met, down),
            };
            queue.push_back((next, right, down));
        }
    }
    if places.len() < FEWEST_DOTS {
        return Err(few(places.len()));
    }
    let crossings: Vec<Crossing> =
        places.iter().map(|(dot, place)| Crossing { place: *place, px: dots[*dot] }).collect();
    let extent = |axis: fn(&DVec2) -> f64, size: f64| {
        let (low, high) = crossings
            .iter()
            .map(|c| axis(&c.px))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        (high - low) / size
    };
    let covered = extent(|p| p.x, size.x).min(extent(|p| p.y, size.y));
    if covered < 0.5 { Err(GridError::Corner(100.0 * covered)) } else { Ok(crossings) }
}

/// Dots indexed by squares of the picture.
struct Cells<'a> {
    dots: &'a [DVec2],
    side: f64,
    cells: BTreeMap<[i64; 2], Vec<usize>>,
}

impl<'a> Cells<'a> {
    fn new(dots: &'a [DVec2], side: f64) -> Self {
        let mut cells: BTreeMap<[i64; 2], Vec<usize>> = BTreeMap::new();
        for (i, dot) in dots.iter().enumerate() {
            cells.entry((*dot / side).floor().as_i64vec2().to_array()).or_default().push(i);
        }
        Self { dots, side, cells }
    }

    /// Returns the dot nearest to `p` within `reach`, which is at most a square's side.
    fn nearest(&self, p: DVec2, reach: f64) -> Option<usize> {
        let [x, y] = (p / self.side).floor().as_i64vec2().to_array();
        let near = (-1..=1).flat_map(|i| (-1..=1).filter_map(move |j| self.cells.get(&[x + i, y + j]))).flatten();
        let by = |i: &&usize| self.dots[**i].distance(p);
        near.filter(|i| by(i) <= reach).min_by(|i, j| by(i).total_cmp(&by(j))).copied()
    }
}
