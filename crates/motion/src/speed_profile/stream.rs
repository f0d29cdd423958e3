use super::cells::Cells;
use super::channels::{Channels, ends};
use super::error::SpeedProfileError;
use super::grid::stations;
use super::jerk_limited::plan;
use super::limit_use::peak;
use super::profile::ProfilePoint;
use super::profile_cell::Cell;
use super::rest_to_rest::RestToRest;
use crate::stretch::Stretch;
use std::collections::VecDeque;

/// A path that is read on demand: its channels are known over the loaded part, given by [`Channels::range`].
pub trait Feed: Channels {
    /// Loads the path until at least `seconds` beyond `beyond` at the maximum speeds, or to its end, and drops the part
    /// before `from`.
    fn load(&mut self, from: f64, beyond: f64, seconds: f64);

    /// True if the loaded part reaches the path's end.
    fn is_complete(&self) -> bool;
}

/// Speed profile of a path of any length, from a sliding window: memory and work for each set-point are independent of
/// the path's length.
///
/// Each window is planned from rest to rest like a whole path. Far from their ends two overlapping profiles agree (the
/// path beyond a stopping distance has no influence), so they are joined there: by a weighted mean of their
/// coefficients, checked against all limits. Guarantee: the output is always the start of a profile that stops within
/// its window. If the next window cannot be joined within the limits, the motion comes to that stop and continues from
/// there.
pub struct ProfileStream<F> {
    feed: F,
    horizon_s: f64,
    plan: Plan,
    /// Cells of the output that are not passed yet, with their maps.
    ready: VecDeque<(Cell, RestToRest)>,
    /// End time of the last of them, s.
    end: f64,
    stops: usize,
    done: bool,
    /// Error of planning beyond the output, which then ends at rest.
    failed: Option<SpeedProfileError>,
    last: f64,
}

/// The profile over one window, and its first cell that is not in the output.
struct Plan {
    from: f64,
    to: f64,
    cells: Cells,
    c: Vec<f64>,
    next: usize,
}

/// Joining profile between two windows: its cells and coefficients, its start station in the first and its end station
/// in the next.
type Passage = (Cells, Vec<f64>, usize, usize);

/// Overlaps with the previous window that are tried in order, as fractions of a window.
const OVERLAPS: [f64; 3] = [0.5, 0.7, 0.9];
/// Maximum use of a limit at a join of two profiles.
const ALLOWED: f64 = 0.9999;
/// Number of zones of an overlap that are tried for the join.
const ZONES: usize = 6;

impl Plan {
    fn new(path: &dyn Channels, from: f64, to: f64) -> Result<Self, SpeedProfileError> {
        let (map, tau) = stations(path, path.limits(), Stretch { from, to });
        let (cells, c) = plan(path, map, tau, path.limits())?;
        Ok(Self { from, to, cells, c, next: 0 })
    }

    /// Range of parameters between acceleration and deceleration phase.
    fn between(&self) -> (f64, f64) {
        let [up, down] = self.cells.map.borders().map(|tau| self.cells.map.at(tau, false)[0]);
        (up, down)
    }

    /// The station at or after the parameter `u`, between acceleration and deceleration phase.
    fn station(&self, u: f64) -> usize {
        let tau = self.cells.map.tau(u);
        self.cells.tau.partition_point(|t| *t < tau - 1e-9 * self.cells.map.length())
    }

    fn at(&self, i: usize) -> f64 {
        self.cells.map.at(self.cells.tau[i], false)[0]
    }
}

impl<F: Feed> ProfileStream<F> {
    /// Plans along `feed` with windows of `horizon_s` seconds at the maximum speeds: several times the longest time to
    /// stop.
    ///
    /// # Errors
    /// As [`SpeedProfile::new`](super::SpeedProfile::new).
    pub fn new(mut feed: F, horizon_s: f64) -> Result<Self, SpeedProfileError> {
        let from = feed.range().0;
        feed.load(from, from, horizon_s);
        ends(&feed)?;
        let to = window_end(&feed, from);
        let plan = Plan::new(&feed, from, to)?;
        Ok(Self {
            feed,
            horizon_s,
            plan,
            ready: VecDeque::new(),
            end: 0.0,
            stops: 0,
            done: false,
            failed: None,
            last: from,
        })
    }

    /// The path, as far as it is loaded.
    pub fn path(&self) -> &F {
        &self.feed
    }

    /// Number of stops because two windows could not be joined.
    pub fn stops(&self) -> usize {
        self.stops
    }

    /// The profile at time `t` (s), which must not decrease; none after the end.
    ///
    /// # Errors
    /// As [`SpeedProfile::new`](super::SpeedProfile::new), for a part of the path that is planned later: once the earlier
    /// motion has come to rest.
    pub fn at(&mut self, t: f64) -> Result<Option<ProfilePoint>, SpeedProfileError> {
        while t >= self.end && !self.done {
            match self.failed {
                Some(reason) => return Err(reason),
                None => self.extend(),
            }
        }
        while let Some((cell, map)) = self.ready.front() {
            let next = self.ready.get(1).map_or(self.end, |(cell, _)| cell.t);
            if t < next {
                let point = cell.point(map, (t - cell.t).max(0.0), false);
                self.last = self.last.max(point.s);
                return Ok(Some(point));
            }
            self.ready.pop_front();
        }
        Ok(None)
    }

    /// The last requested point, at rest; the end of the path once it is done.
    pub fn end(&self) -> ProfilePoint {
        ProfilePoint { s: if self.done { self.feed.range().1 } else { self.last }, ..ProfilePoint::default() }
    }

    /// Time until the end, s, known once everything is planned.
    pub fn duration(&self) -> Option<f64> {
        self.done.then_some(self.end)
    }

    /// Extends the output; to a stop if it cannot go on.
    fn extend(&mut self) {
        if let Err(reason) = self.go_on() {
            self.give_out(self.plan.cells.count());
            self.failed = Some(reason);
        }
    }

    fn go_on(&mut self) -> Result<(), SpeedProfileError> {
        // The path beyond the plan's end must be loaded to decide whether that is a stop.
        self.feed.load(self.last.min(self.plan.from), self.plan.to, 0.5 * self.horizon_s);
        let path_end = self.feed.range().1;
        let ends_path = self.feed.is_complete() && self.plan.to >= path_end;
        if ends_path || self.feed.stops().iter().any(|u| (u - self.plan.to).abs() <= f64::EPSILON * u.abs()) {
            return self.come_to_rest(ends_path);
        }
        for overlap in OVERLAPS {
            let from = self.plan.to - overlap * (self.plan.to - self.plan.from);
            let from = from.max(self.plan.from);
            if self.join(from)? {
                return Ok(());
            }
        }
        self.stops += 1;
        self.come_to_rest(false)
    }

    /// Adds the rest of the plan to the output; a new one starts at its end, unless that is the end of the path.
    fn come_to_rest(&mut self, is_end: bool) -> Result<(), SpeedProfileError> {
        self.give_out(self.plan.cells.count());
        if is_end {
            self.done = true;
            return Ok(());
        }
        let from = self.plan.to;
        self.feed.load(self.last, from, self.horizon_s);
        self.plan = Plan::new(&self.feed, from, window_end(&self.feed, from))?;
        Ok(())
    }

    /// Plans the window that starts at `from` and joins it. Returns false if the limits do not allow that.
    fn join(&mut self, from: f64) -> Result<bool, SpeedProfileError> {
        let to = window_end(&self.feed, self.plan.to);
        let mut next = Plan::new(&self.feed, from, to)?;
        let begin = next.between().0.max(self.plan.at(self.plan.next));
        let end = self.plan.between().1;
        if end <= begin {
            return Ok(false);
        }
        let width = (end - begin) / (ZONES as f64 / 2.0);
        let step = (end - begin - width) / (ZONES - 1) as f64;
        // The middle of the overlap first: farthest from both ends.
        let mut order: Vec<usize> = (0..ZONES).collect();
        order.sort_by_key(|i| (2 * i).abs_diff(ZONES - 1));
        for i in order {
            let zone = Stretch { from: begin + step * i as f64, to: begin + step * i as f64 + width };
            if let Some((cells, c, first, after)) = self.passage(&next, zone)? {
                self.give_out(first);
                for k in 0..cells.count() {
                    let cell = Cell::of_spline(&cells, &c, k, self.end);
                    self.ready.push_back((cell, cells.map));
                    self.end += cell.time;
                }
                next.next = after;
                self.plan = next;
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The profile that joins the plan to `next` in about `zone`, if the limits allow one.
    fn passage(&self, next: &Plan, zone: Stretch) -> Result<Option<Passage>, SpeedProfileError> {
        let (first, after) = (self.plan.station(zone.from), next.station(zone.to));
        let (from, to) = (self.plan.at(first), next.at(after));
        let inside = |u: f64| u > from && u < to;
        let mut u: Vec<f64> = vec![from];
        u.extend((first..self.plan.cells.tau.len()).map(|i| self.plan.at(i)).filter(|u| inside(*u)));
        u.extend((0..after).map(|i| next.at(i)).filter(|u| inside(*u)));
        u.push(to);
        u.sort_by(f64::total_cmp);
        u.dedup_by(|b, a| *b - *a < 1e-7 * (to - from));
        if let Some(last) = u.last_mut() {
            *last = to;
        }
        if u.len() < 5 || first < self.plan.next {
            return Ok(None);
        }
        let tau = u.iter().map(|u| u - from).collect();
        let cells = Cells::new(&self.feed, RestToRest::new(from, to, 0.0, 0.0), tau, self.feed.limits().to_vec())?;
        let mine = self.plan.cells.carried(&self.plan.c, &cells, self.plan.cells.map.tau(from));
        let theirs = next.cells.carried(&next.c, &cells, next.cells.map.tau(from));
        let count = mine.len();
        let c: Vec<f64> = (0..count)
            .map(|k| {
                let at = |i: usize| cells.tau[i.min(cells.count())];
                let x = 0.5 * (at(k.saturating_sub(1)) + at(k)) / (to - from);
                // Speed and acceleration at the ends are those of either profile: two coefficients each.
                let x = if k < 2 {
                    0.0
                } else if k + 2 >= count {
                    1.0
                } else {
                    x
                };
                let w = x * x * (3.0 - 2.0 * x);
                if mine[k].to_bits() == theirs[k].to_bits() { mine[k] } else { (1.0 - w) * mine[k] + w * theirs[k] }
            })
            .collect();
        Ok((0..cells.count()).all(|i| peak(&cells, &c, i) <= ALLOWED).then_some((cells, c, first, after)))
    }

    /// Adds the plan's cells up to station `until` to the output.
    fn give_out(&mut self, until: usize) {
        for i in self.plan.next..until {
            let cell = Cell::of_spline(&self.plan.cells, &self.plan.c, i, self.end);
            self.ready.push_back((cell, self.plan.cells.map));
            self.end += cell.time;
        }
        self.plan.next = until;
    }
}

/// The first stop after `u`, or the end of the loaded part.
fn window_end(feed: &impl Feed, u: f64) -> f64 {
    let end = feed.range().1;
    feed.stops().into_iter().find(|s| *s > u * (1.0 + f64::EPSILON) && *s > u).unwrap_or(end)
}
