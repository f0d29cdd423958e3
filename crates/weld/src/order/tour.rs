//! Order of the copies.
//!
//! Under `shortest` a way starts at a copy and goes on to the nearest. Windows of it are then reversed, moved on or
//! swapped at their ends as long as that shortens the transfer moves (2-opt and or-opt). This is repeated from several
//! copies and from the order of the list. `back_and_forth` is the same, but steps within a row count first. Both are
//! local optima, and never worse than their starts.

use super::file::Rule;
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Ways started at this many copies are improved: more seldom find a better one.
const STARTS: usize = 12;
/// Of more stops in all fewer ways are started.
const STOPS: usize = 2400;
/// Times that all windows are gone through at most.
const SWEEPS: usize = 100;
/// Maximum length of a window: time grows with its square.
const LONGEST: usize = 48;
/// In a window of up to this many stops any number of them is moved on, in a longer one a few.
const SHORT: usize = 12;
const MOVED: usize = 3;
/// Minimum gain of a change, mm and as a part of the way; smaller ones are rounding.
const MIN_GAIN: (f64, f64) = (1e-9, 1e-11);

/// A copy: start and end of its weld, mm, welded one way or (if it has two) the other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stop {
    pub(crate) row: u32,
    pub(crate) ways: Vec<(DVec3, DVec3)>,
}

/// A stop and which way it is welded.
pub(crate) type Leg = (usize, usize);

/// The stops in the order of `rule`, each with its way of welding. Ways and the freedom of the rule serve short
/// transfer moves from `from` (if that is known) to the end. Every stop is there once.
pub(crate) fn tour(stops: &[Stop], rule: Rule, from: Option<DVec3>) -> Vec<Leg> {
    let search = Search { stops, from, rows_count: rule == Rule::BackAndForth };
    let order: Vec<usize> = match rule {
        Rule::InTurn => (0..stops.len()).collect(),
        Rule::Skip(every) => in_rows(stops).iter().flat_map(|row| skipping(row, every)).collect(),
        Rule::Shortest | Rule::BackAndForth => return search.best(),
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

/// A row's stops, every `every`-th and then those between. If possible the order avoids successive neighbours.
fn skipping(row: &[usize], every: usize) -> Vec<usize> {
    let series: Vec<Vec<usize>> = (0..every.min(row.len())).map(|k| (k..row.len()).step_by(every).collect()).collect();
    let mut chosen = Vec::new();
    if !choose(&series, &mut chosen) {
        chosen = (0..series.len()).collect();
    }
    chosen.into_iter().flat_map(|k| series[k].iter().map(|i| row[*i])).collect()
}

/// Adds series to `chosen`, the first one first, so that neighbours do not follow each other; false if that is
/// impossible.
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

/// Cost of a way: first by its steps within a row, where these count, then by its length.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
struct Cost {
    within: usize,
    /// mm.
    way: f64,
}

impl std::ops::Add for Cost {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { within: self.within + other.within, way: self.way + other.way }
    }
}

impl Cost {
    /// True if it is less by more than rounding.
    fn wins(self, other: Self) -> bool {
        let least = MIN_GAIN.0 + MIN_GAIN.1 * other.way;
        self.within < other.within || (self.within == other.within && self.way < other.way - least)
    }
}

/// Stops, with the cost of a step between two of them.
struct Search<'a> {
    stops: &'a [Stop],
    from: Option<DVec3>,
    /// Whether steps within a row count.
    rows_count: bool,
}

impl Search<'_> {
    fn step(&self, a: Leg, b: Leg) -> Cost {
        let (from, to) = (&self.stops[a.0], &self.stops[b.0]);
        let within = usize::from(self.rows_count && from.row == to.row);
        Cost { within, way: from.ways[a.1].1.distance(to.ways[b.1].0) }
    }

    /// The way to the first of `legs`, from the leg before it or from where the torch is.
    fn enter(&self, before: Option<Leg>, first: Leg) -> Cost {
        match (before, self.from) {
            (Some(before), _) => self.step(before, first),
            (None, Some(from)) => Cost { within: 0, way: from.distance(self.stops[first.0].ways[first.1].0) },
            (None, None) => Cost::default(),
        }
    }

    /// Cost of `legs` between the legs before and after them.
    fn cost(&self, before: Option<Leg>, legs: &[Leg], after: Option<Leg>) -> Cost {
        let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return Cost::default() };
        let steps = legs.windows(2).map(|w| self.step(w[0], w[1])).chain(after.map(|after| self.step(*last, after)));
        steps.fold(self.enter(before, *first), |sum, step| sum + step)
    }

    fn best(&self) -> Vec<Leg> {
        let n = self.stops.len();
        let count = STARTS.min(STOPS / n.max(1)).max(1).min(n);
        let starts = (0..count).map(|i| i * n / count);
        let starts = starts.flat_map(|i| (0..self.stops[i].ways.len()).map(move |way| self.nearest((i, way))));
        let listed: Vec<usize> = (0..n).collect();
        let mut best: Option<(Cost, Vec<Leg>)> = None;
        for mut legs in starts.chain([self.ways(&listed)]) {
            self.improve(&mut legs);
            let cost = self.cost(None, &legs, None);
            if best.as_ref().is_none_or(|best| cost.wins(best.0)) {
                best = Some((cost, legs));
            }
        }
        best.map_or_else(Vec::new, |best| best.1)
    }

    /// From leg `first` always to the nearest. At a change of rows, to one of the row with the most stops left, so that
    /// few are left over.
    fn nearest(&self, first: Leg) -> Vec<Leg> {
        let mut left: Vec<usize> = (0..self.stops.len()).filter(|i| *i != first.0).collect();
        let mut legs = vec![first];
        let mut in_row: BTreeMap<u32, usize> = BTreeMap::new();
        left.iter().for_each(|i| *in_row.entry(self.stops[*i].row).or_default() += 1);
        while let Some(&last) = legs.last().filter(|_| !left.is_empty()) {
            let row = self.stops[last.0].row;
            let rank = |i: usize| match self.rows_count {
                true => (self.stops[i].row == row, Reverse(in_row.get(&self.stops[i].row))),
                false => (false, Reverse(None)),
            };
            let next =
                left.iter().flat_map(|i| (0..self.stops[*i].ways.len()).map(move |way| (*i, way))).min_by(|a, b| {
                    rank(a.0).cmp(&rank(b.0)).then(self.step(last, *a).way.total_cmp(&self.step(last, *b).way))
                });
            let Some(next) = next else { break };
            in_row.entry(self.stops[next.0].row).and_modify(|count| *count -= 1);
            left.retain(|i| *i != next.0);
            legs.push(next);
        }
        legs
    }

    /// Changes windows of `legs` as long as one makes it shorter.
    fn improve(&self, legs: &mut [Leg]) {
        let n = legs.len();
        for _ in 0..SWEEPS {
            let mut improved = false;
            for low in 0..n {
                for high in low..n.min(low + LONGEST) {
                    improved |= self.improve_window(legs, low, high);
                }
            }
            if !improved {
                break;
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
            if self.cost(before, window, after).wins(cost) {
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
        let mut costs: Vec<Cost> = ways(first).map(|way| self.enter(None, (first, way))).collect();
        let mut back: Vec<Vec<usize>> = Vec::new();
        let mut last = first;
        for &stop in rest {
            let reach = |way: usize| {
                let all = ways(last).map(|w| (costs[w] + self.step((last, w), (stop, way)), w));
                all.reduce(|a, b| if b.0 < a.0 { b } else { a }).unwrap_or_default()
            };
            let reached: Vec<(Cost, usize)> = ways(stop).map(reach).collect();
            back.push(reached.iter().map(|r| r.1).collect());
            costs = reached.iter().map(|r| r.0).collect();
            last = stop;
        }
        let mut way = (0..costs.len()).reduce(|a, b| if costs[b] < costs[a] { b } else { a }).unwrap_or(0);
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

/// Applies change `number` to a window. It is reversed, reversed with every stop welded the other way, or its ends are
/// swapped. Or its first or last stop moves to its other end, welded the other way. Or its first stops move to its end
/// (in a long window a few, or the last few to its start).
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
