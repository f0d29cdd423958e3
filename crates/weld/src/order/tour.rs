//! Which copy is welded after which.
//!
//! Under `shortest` a way starts at a copy and goes on to the nearest; windows of it are then reversed, moved on or
//! swapped at their ends as long as that makes the air way shorter (2-opt and or-opt), from several copies and from the
//! order of the list. `back_and_forth` is the same where a step within a row costs more than any way. Both are
//! local optima, and never worse than what they start from.

use super::file::Rule;
use glam::DVec3;

/// Ways started at this many copies are improved: more seldom find a better one.
const STARTS: usize = 12;
/// Longest window that is looked at: time grows with its square.
const LONGEST: usize = 48;
/// In a window of up to this many stops any number of them is moved on, in a longer one a few.
const SHORT: usize = 12;
const MOVED: usize = 3;
/// A change that wins less, mm, is rounding.
const LEAST_GAIN: f64 = 1e-9;

/// A copy: where its weld begins and ends, mm, welded one way or (if it has two) the other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stop {
    pub(crate) row: u32,
    pub(crate) ways: Vec<(DVec3, DVec3)>,
}

/// A stop and which way it is welded.
pub(crate) type Leg = (usize, usize);

/// The stops in the order of `rule`, each with the way in which it is welded; ways and what the rule leaves open are
/// chosen for a short air way from `from` (if that is known) to the end. Every stop is there once.
pub(crate) fn tour(stops: &[Stop], rule: Rule, from: Option<DVec3>) -> Vec<Leg> {
    let mut search = Search { stops, from, same_row: 0.0 };
    let order: Vec<usize> = match rule {
        Rule::InTurn => (0..stops.len()).collect(),
        Rule::Skip(every) => in_rows(stops).iter().flat_map(|row| skipping(row, every)).collect(),
        Rule::Shortest => return search.best(),
        Rule::BackAndForth => {
            search.same_row = search.penalty();
            return search.best();
        }
    };
    search.ways(&order)
}

/// The stops of each row, as listed.
pub(crate) fn in_rows(stops: &[Stop]) -> Vec<Vec<usize>> {
    let mut rows: Vec<u32> = stops.iter().map(|stop| stop.row).collect();
    rows.sort_unstable();
    rows.dedup();
    let of_row = |row: u32| (0..stops.len()).filter(|i| stops[*i].row == row).collect();
    rows.into_iter().map(of_row).collect()
}

/// A row's stops, every `every`-th and then those between, in such an order that no two neighbours follow each other
/// if there is one.
fn skipping(row: &[usize], every: usize) -> Vec<usize> {
    let series: Vec<Vec<usize>> = (0..every.min(row.len())).map(|k| (k..row.len()).step_by(every).collect()).collect();
    let mut chosen = Vec::new();
    if !choose(&series, &mut chosen) {
        chosen = (0..series.len()).collect();
    }
    chosen.into_iter().flat_map(|k| series[k].iter().map(|i| row[*i])).collect()
}

/// Adds series to `chosen`, the first one first, so that neighbours do not follow each other; false if there is no way.
fn choose(series: &[Vec<usize>], chosen: &mut Vec<usize>) -> bool {
    if chosen.len() == series.len() {
        return true;
    }
    let last = chosen.last().and_then(|k| series[*k].last().copied());
    for k in 0..series.len() {
        let near = last.is_some_and(|last| last.abs_diff(series[k][0]) == 1);
        if near || chosen.contains(&k) {
            continue;
        }
        chosen.push(k);
        if choose(series, chosen) {
            return true;
        }
        chosen.pop();
    }
    false
}

/// Stops, and what a step between two of them costs.
struct Search<'a> {
    stops: &'a [Stop],
    from: Option<DVec3>,
    /// What a step within a row costs beyond its way.
    same_row: f64,
}

impl Search<'_> {
    /// More than any way through all stops.
    fn penalty(&self) -> f64 {
        let points = || self.stops.iter().flat_map(|s| s.ways.iter().flat_map(|w| [w.0, w.1])).chain(self.from);
        let low = points().fold(DVec3::INFINITY, DVec3::min);
        let high = points().fold(DVec3::NEG_INFINITY, DVec3::max);
        (high - low).length() * (self.stops.len() + 1) as f64 + 1.0
    }

    fn step(&self, a: Leg, b: Leg) -> f64 {
        let (from, to) = (&self.stops[a.0], &self.stops[b.0]);
        let same = if from.row == to.row { self.same_row } else { 0.0 };
        from.ways[a.1].1.distance(to.ways[b.1].0) + same
    }

    /// The way to the first of `legs`, from the leg before it or from where the torch is.
    fn enter(&self, before: Option<Leg>, first: Leg) -> f64 {
        match (before, self.from) {
            (Some(before), _) => self.step(before, first),
            (None, Some(from)) => from.distance(self.stops[first.0].ways[first.1].0),
            (None, None) => 0.0,
        }
    }

    /// What `legs` cost between the legs before and after them.
    fn cost(&self, before: Option<Leg>, legs: &[Leg], after: Option<Leg>) -> f64 {
        let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return 0.0 };
        let inside: f64 = legs.windows(2).map(|w| self.step(w[0], w[1])).sum();
        self.enter(before, *first) + inside + after.map_or(0.0, |after| self.step(*last, after))
    }

    /// The best way found.
    fn best(&self) -> Vec<Leg> {
        let n = self.stops.len();
        let starts = (0..n.min(STARTS)).map(|i| i * n / n.min(STARTS));
        let starts = starts.flat_map(|i| (0..self.stops[i].ways.len()).map(move |way| self.nearest((i, way))));
        let listed: Vec<usize> = (0..n).collect();
        let mut best: (f64, Vec<Leg>) = (f64::INFINITY, Vec::new());
        for mut legs in starts.chain([self.ways(&listed)]) {
            self.improve(&mut legs);
            let cost = self.cost(None, &legs, None);
            if cost < best.0 - LEAST_GAIN {
                best = (cost, legs);
            }
        }
        best.1
    }

    /// From leg `first` always to the nearest; where rows must change to one of the row of which most are left, so
    /// that none is left over that need not be.
    fn nearest(&self, first: Leg) -> Vec<Leg> {
        let mut left: Vec<usize> = (0..self.stops.len()).filter(|i| *i != first.0).collect();
        let mut legs = vec![first];
        while let Some(&last) = legs.last().filter(|_| !left.is_empty()) {
            let row = self.stops[last.0].row;
            let in_row = |i: usize| left.iter().filter(|k| self.stops[**k].row == self.stops[i].row).count();
            let rank = |i: usize| match self.same_row > 0.0 {
                true => (self.stops[i].row == row, usize::MAX - in_row(i)),
                false => (false, 0),
            };
            let next = left
                .iter()
                .flat_map(|i| (0..self.stops[*i].ways.len()).map(move |way| (*i, way)))
                .min_by(|a, b| rank(a.0).cmp(&rank(b.0)).then(self.step(last, *a).total_cmp(&self.step(last, *b))));
            let Some(next) = next else { break };
            left.retain(|i| *i != next.0);
            legs.push(next);
        }
        legs
    }

    /// Changes windows of `legs` as long as one makes it shorter.
    fn improve(&self, legs: &mut [Leg]) {
        let n = legs.len();
        let mut improved = true;
        while improved {
            improved = false;
            for low in 0..n {
                for high in low..n.min(low + LONGEST) {
                    improved |= self.improve_window(legs, low, high);
                }
            }
        }
    }

    fn improve_window(&self, legs: &mut [Leg], low: usize, high: usize) -> bool {
        let (before, after) = (low.checked_sub(1).map(|i| legs[i]), legs.get(high + 1).copied());
        let window = &mut legs[low..=high];
        let old = window.to_vec();
        let cost = self.cost(before, window, after);
        for number in 0..changes(window.len()) {
            change(window, number);
            for leg in window.iter_mut() {
                leg.1 = leg.1.min(self.stops[leg.0].ways.len() - 1);
            }
            if self.cost(before, window, after) < cost - LEAST_GAIN {
                return true;
            }
            window.copy_from_slice(&old);
        }
        false
    }

    /// The best way in which each stop of a given order is welded: dynamic programming.
    fn ways(&self, order: &[usize]) -> Vec<Leg> {
        let Some((&first, rest)) = order.split_first() else { return Vec::new() };
        let ways = |stop: usize| 0..self.stops[stop].ways.len();
        let mut costs: Vec<f64> = ways(first).map(|way| self.enter(None, (first, way))).collect();
        let mut back: Vec<Vec<usize>> = Vec::new();
        let mut last = first;
        for &stop in rest {
            let reach = |way: usize| {
                let all = ways(last).map(|w| (costs[w] + self.step((last, w), (stop, way)), w));
                all.reduce(|a, b| if b.0 < a.0 { b } else { a }).unwrap_or((f64::INFINITY, 0))
            };
            let reached: Vec<(f64, usize)> = ways(stop).map(reach).collect();
            back.push(reached.iter().map(|r| r.1).collect());
            costs = reached.iter().map(|r| r.0).collect();
            last = stop;
        }
        let mut way = (0..costs.len()).min_by(|a, b| costs[*a].total_cmp(&costs[*b])).unwrap_or(0);
        let mut legs = vec![(last, way)];
        for (from, &stop) in back.iter().rev().zip(order[..order.len() - 1].iter().rev()) {
            way = from[way];
            legs.push((stop, way));
        }
        legs.reverse();
        legs
    }
}

/// The number of things that [`change`] does with a window of `length` stops.
fn changes(length: usize) -> usize {
    5 + if length <= SHORT { length - 1 } else { 2 * MOVED }
}

/// The `number`-th thing that is tried with a window: reversed as it is, reversed with every stop welded the other way, its
/// ends swapped, its first or last stop moved to its other end and welded the other way, its first stops moved to its
/// end (in a long window a few, or the last few to its start).
fn change(window: &mut [Leg], number: usize) {
    let last = window.len() - 1;
    let other_way = |leg: &mut Leg| leg.1 = 1 - leg.1;
    match number {
        0 => window.reverse(),
        1 => {
            window.reverse();
            window.iter_mut().for_each(other_way);
        }
        2 => window.swap(0, last),
        3 => {
            window.rotate_left(1);
            other_way(&mut window[last]);
        }
        4 => {
            window.rotate_right(1);
            other_way(&mut window[0]);
        }
        _ if last < SHORT => window.rotate_left(number - 4),
        _ if number < 5 + MOVED => window.rotate_left(number - 4),
        _ => window.rotate_right(number - 4 - MOVED),
    }
}
