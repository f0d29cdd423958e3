use super::cells::Cells;
use super::channels::{Channels, ends};
use super::error::SpeedProfileError;
use super::grid::stations;
use super::grid_without_jerk::spread;
use super::jerk_limited::plan;
use super::profile_cell::Cell;
use super::reachability;
use super::rest_to_rest::RestToRest;
use crate::stretch::Stretch;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Number of cells of a profile without limits of jerk.
const CELLS_WITHOUT_JERK: usize = 1000;
/// Relative distance of the squared speed to the requested one below which it counts as a cruise.
const AS_ASKED: f64 = 1e-9;
/// Decrease of the ratio of reached to requested speed at which an acceleration phase ends: from there on the tip does
/// not follow a change of the requested speed.
const FALLS_BEHIND: f64 = 3e-2;

/// The speed profile at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ProfilePoint {
    /// The path's parameter: path length, mm, where the tip moves.
    pub s: f64,
    /// Its speed, 1/s.
    pub v: f64,
    /// Its acceleration, 1/s^2.
    pub a: f64,
    /// Its jerk, 1/s^3.
    pub j: f64,
}

/// Speed profile of a path by its parameter and by time, from rest to rest: the fastest one up to the requested speed
/// and within the speed, acceleration and jerk of every channel.
///
/// The squared speed by a parameter regular at rest is a quadratic B-spline, so accelerations are continuous and jerks
/// bounded, and time follows in closed form in every cell. Its coefficients come from an interior-point method (the
/// problem is not convex under limits of jerk; see [`super`]).
///
/// To play it, call [`SpeedProfile::at`] with rising times. To see what slows it, make a
/// [`Certificate`](super::Certificate).
///
/// # Guarantees
///
/// - No channel exceeds its speed, acceleration or jerk at any time. At least half a thousandth of each limit is kept
///   in reserve (without limits of jerk 2e-5).
/// - The tip is never faster than requested, and exactly as fast unless slowed down.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SpeedProfile {
    pieces: Vec<RestToRest>,
    cells: Vec<Cell>,
    /// The piece that each cell belongs to.
    owner: Vec<u32>,
    duration: f64,
    end: f64,
}

impl SpeedProfile {
    /// Plans the fastest profile along `path`. Without a finite jerk limit the acceleration may jump, see
    /// [`SpeedProfile::without_jerk`].
    ///
    /// # Errors
    /// Limits that are zero, negative or NaN; an empty range; derivatives that are not finite; a piece between stops
    /// without motion.
    pub fn new(path: &dyn Channels) -> Result<Self, SpeedProfileError> {
        if path.limits().iter().all(|l| l.jerk.is_infinite()) {
            return Self::without_jerk(path, CELLS_WITHOUT_JERK);
        }
        let ends = ends(path)?;
        let mut profile = Self::empty(path);
        for w in ends.windows(2) {
            let (map, tau) = stations(path, path.limits(), Stretch { from: w[0], to: w[1] });
            let (cells, c) = plan(path, map, tau, path.limits())?;
            profile.add(&cells, &c);
        }
        Ok(profile)
    }

    /// Plans the fastest profile along `path` without limits of jerk. The squared speed by path length is linear in
    /// each of about `cells` cells between two stops, so the acceleration along the path is constant there. The cells
    /// are about even by time; on splines 400 of them lose less than a thousandth of the time.
    ///
    /// # Errors
    /// As [`SpeedProfile::new`].
    pub fn without_jerk(path: &dyn Channels, cells: usize) -> Result<Self, SpeedProfileError> {
        let ends = ends(path)?;
        let mut profile = Self::empty(path);
        for w in ends.windows(2) {
            let stations = spread(path, Stretch { from: w[0], to: w[1] }, cells);
            let (b, asked) = reachability::fastest(path, &stations)?;
            profile.add_linear(&stations, &b, &asked);
        }
        Ok(profile)
    }

    fn empty(path: &dyn Channels) -> Self {
        Self { pieces: Vec::new(), cells: Vec::new(), owner: Vec::new(), duration: 0.0, end: path.range().1 }
    }

    /// Appends a piece whose squared speed is a quadratic spline with coefficients `c`.
    fn add(&mut self, cells: &Cells, c: &[f64]) {
        self.pieces.push(cells.map);
        for i in 0..cells.count() {
            self.push(Cell::of_spline(cells, c, i, self.duration));
        }
    }

    /// Appends a piece whose squared speed is linear between its values `b` at stations.
    fn add_linear(&mut self, stations: &[f64], b: &[f64], asked: &[[f64; 2]]) {
        let from = stations[0];
        self.pieces.push(RestToRest::new(from, stations[stations.len() - 1], 0.0, 0.0));
        self.cells.reserve(asked.len());
        self.owner.reserve(asked.len());
        for (i, asked) in asked.iter().enumerate() {
            let width = stations[i + 1] - stations[i];
            let cruises = (0..2).all(|end| b[i + end] >= (1.0 - AS_ASKED) * asked[end]);
            let over = Stretch { from: stations[i] - from, to: stations[i + 1] - from };
            self.push(Cell::new(over, self.duration, [b[i], (b[i + 1] - b[i]) / width, 0.0], cruises, *asked));
        }
    }

    fn push(&mut self, cell: Cell) {
        self.duration += cell.time;
        self.owner.push(self.pieces.len() as u32 - 1);
        self.cells.push(cell);
    }

    /// Returns the time from rest to rest, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Evaluates the profile at time `t`, s: at rest at the start before 0, and at the end after
    /// [`SpeedProfile::duration`].
    ///
    /// `cursor` keeps the cell between calls, so that a rising `t` needs no search. Start with any value, such as 0.
    /// Does not allocate.
    pub fn at(&self, t: f64, cursor: &mut usize) -> ProfilePoint {
        if t >= self.duration {
            return ProfilePoint { s: self.end, ..ProfilePoint::default() };
        }
        let t = t.max(0.0);
        if self.cells.get(*cursor).is_none_or(|c| c.t > t) {
            *cursor = self.cells.partition_point(|c| c.t <= t).saturating_sub(1);
        }
        while self.cells.get(*cursor + 1).is_some_and(|c| c.t <= t) {
            *cursor += 1;
        }
        self.point(*cursor, t - self.cells[*cursor].t, false)
    }

    /// Returns true if evaluation is possible at all times, along a path of this length: cells follow one another from 0
    /// to the duration, each with its piece.
    pub(crate) fn is_whole(&self, length: f64) -> bool {
        let times = self.cells.iter().map(|cell| cell.t).chain(std::iter::once(self.duration));
        let later = times.clone().skip(1);
        self.cells.first().is_some_and(|first| first.t.total_cmp(&0.0).is_eq())
            && self.duration.is_finite()
            && self.end.total_cmp(&length).is_eq()
            && times.zip(later).all(|(t, next)| t <= next)
            && self.owner.len() == self.cells.len()
            && self.owner.is_sorted()
            && self.owner.iter().all(|owner| (*owner as usize) < self.pieces.len())
    }

    fn point(&self, i: usize, t: f64, before: bool) -> ProfilePoint {
        self.cells[i].point(&self.pieces[self.owner[i] as usize], t, before)
    }

    /// Number of cells, in which the profile is smooth; its jerk may jump between them.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Returns the first and the last instant of cell `i`, s.
    ///
    /// # Panics
    /// If `i` is not less than [`SpeedProfile::cells`].
    pub fn cell_times(&self, i: usize) -> (f64, f64) {
        (self.cells[i].t, self.cells.get(i + 1).map_or(self.duration, |c| c.t))
    }

    /// Evaluates the profile in cell `i` at the `part` of its time, from 0 to 1; at its ends the limit from inside.
    ///
    /// # Panics
    /// If `i` is not less than [`SpeedProfile::cells`].
    pub fn in_cell(&self, i: usize, part: f64) -> ProfilePoint {
        self.point(i, part * self.cells[i].time, part > 0.5)
    }

    /// Evaluates the speed at the parameter `s`, 1/s.
    pub fn speed(&self, s: f64) -> f64 {
        let (i, v, tau) = self.passing(s);
        v * self.pieces[self.owner[i] as usize].at(tau, false)[1]
    }

    /// Returns the time at which the parameter `s` is reached, s: the inverse of [`SpeedProfile::at`].
    pub fn time(&self, s: f64) -> f64 {
        if s >= self.end {
            return self.duration;
        }
        let (i, v, tau) = self.passing(s);
        self.cells[i].passed(tau, v)
    }

    /// The cell in which the parameter `s` is passed, the speed by `tau` there, and `tau`.
    fn passing(&self, s: f64) -> (usize, f64, f64) {
        let piece = self.pieces.partition_point(|p| p.from <= s).saturating_sub(1);
        let tau = self.pieces[piece].tau(s);
        let cells = self.cells_of(piece);
        let i = cells.start + self.cells[cells].partition_point(|c| c.tau <= tau).saturating_sub(1);
        (i, self.cells[i].speed(tau), tau)
    }

    fn cells_of(&self, piece: usize) -> Range<usize> {
        let first = self.owner.partition_point(|owner| (*owner as usize) < piece);
        first..self.owner.partition_point(|owner| (*owner as usize) <= piece)
    }

    /// The subrange of `cells` between their acceleration and deceleration phase.
    fn between(&self, cells: Range<usize>) -> Range<usize> {
        let up = self.run_up(cells.clone(), false);
        let down = self.run_up(cells.clone().rev(), true);
        cells.start + up..(cells.end - down).max(cells.start + up)
    }

    /// Number of `cells` in the acceleration phase at their start, or in the deceleration phase if iterated
    /// `backwards`. In these the speed rises or approaches the requested one, until it falls behind that by more than
    /// [`FALLS_BEHIND`]. So a rising requested speed hides neither the tip's acceleration nor a rise that the tip
    /// cannot follow.
    fn run_up(&self, cells: impl Iterator<Item = usize>, backwards: bool) -> usize {
        let (mut count, mut nearest) = (0, (0.0, 0));
        for i in cells {
            let ordered = |[a, b]: [f64; 2]| if backwards { (b, a) } else { (a, b) };
            let (from, to) = ordered([0.0, 1.0].map(|part| self.in_cell(i, part).v));
            // 0 without a requested speed.
            let (before, after) = ordered(self.cells[i].parts.map(|part| part.max(0.0).sqrt()));
            if self.cells[i].cruises || (to <= from && after <= before) {
                break;
            }
            if after < (1.0 - FALLS_BEHIND) * nearest.0 {
                return nearest.1;
            }
            count += 1;
            if after >= nearest.0 {
                nearest = (after, count);
            }
        }
        count
    }

    /// Legs from rest to rest: the whole path, or from one stop to the next.
    pub fn legs(&self) -> Vec<Leg> {
        let leg = |(piece, map): (usize, &RestToRest)| {
            let cells = self.cells_of(piece);
            let border = |cell: usize| if cell < cells.end { self.in_cell(cell, 0.0).s } else { map.to };
            let between = self.between(cells.clone());
            Leg { from: map.from, to: map.to, run_up_end: border(between.start), run_down_start: border(between.end) }
        };
        self.pieces.iter().enumerate().map(leg).collect()
    }

    /// Range of the planned speed between the first acceleration and the last deceleration phase.
    pub fn report(&self) -> SpeedReport {
        let last = self.cells.len() - 1;
        let cells = self.between(0..last + 1);
        let at = |i: usize| if i > last { self.end } else { self.in_cell(i, 0.0).s };
        let (run_up_end, run_down_start) = (at(cells.start), at(cells.end));
        let speeds = |i: usize| [0.0, 0.5, 1.0].map(|part| self.in_cell(i, part).v);
        // If the two phases meet, the maximum speed is at their border.
        let between: Vec<f64> = match cells.is_empty() {
            true => vec![self.in_cell(cells.start.min(last), 0.0).v],
            false => cells.flat_map(speeds).collect(),
        };
        SpeedReport {
            run_up_end,
            run_down_start,
            least: between.iter().copied().fold(f64::INFINITY, f64::min),
            greatest: between.iter().copied().fold(0.0, f64::max),
        }
    }
}

/// A stretch of a speed profile from rest to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Path length of its start, mm.
    pub from: f64,
    /// Path length of its end, mm.
    pub to: f64,
    /// Path length at the end of its acceleration phase, mm.
    pub run_up_end: f64,
    /// Path length at the start of its deceleration phase, mm; equal to the end of the acceleration phase if the two
    /// meet.
    pub run_down_start: f64,
}

/// Planned speed between acceleration and deceleration phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedReport {
    /// Path length at the end of the acceleration phase, mm.
    pub run_up_end: f64,
    /// Path length at the start of the deceleration phase, mm.
    pub run_down_start: f64,
    /// Minimum planned speed between them, mm/s.
    pub least: f64,
    /// Maximum planned speed between them, mm/s.
    pub greatest: f64,
}
