//! Selection of the rows that a profile must satisfy.

use super::cells::{Cells, PARTS};
use super::problem::{Group, Place, Problem};
use std::ops::Range;

/// Forms of the squared speed and its first and second derivative: the weights of each in a list.
#[derive(Default)]
pub(super) struct Forms([Vec<f64>; 3]);

impl Forms {
    fn push(&mut self, form: [f64; 3]) {
        self.0.iter_mut().zip(form).for_each(|(list, x)| list.push(x));
    }

    pub(super) fn count(&self) -> usize {
        self.0[0].len()
    }

    pub(super) fn at(&self, i: usize) -> [f64; 3] {
        [self.0[0][i], self.0[1][i], self.0[2][i]]
    }

    fn scale(&mut self, rows: &Range<usize>, by: f64) {
        self.0.iter_mut().for_each(|list| list[rows.clone()].iter_mut().for_each(|x| *x *= by));
    }

    /// Maximum weight of the squared speed.
    pub(super) fn greatest_value(&self) -> f64 {
        self.0[0].iter().map(|x| x.abs()).fold(0.0, f64::max)
    }

    /// 1 less the forms of these `rows`, at a squared speed and its derivatives (`profile`).
    pub(super) fn left(&self, rows: &Range<usize>, profile: [f64; 3], out: &mut [f64]) {
        let [b, d, e] = profile;
        let [x, y, z] = self.0.each_ref().map(|list| &list[rows.clone()]);
        for (i, out) in out[rows.clone()].iter_mut().enumerate() {
            *out = 1.0 - (x[i] * b + y[i] * d + z[i] * e);
        }
    }

    /// `room` less the forms of these `rows`, and less their opposites, at a squared speed and its derivatives
    /// (`profile`).
    pub(super) fn both(&self, rows: &Range<usize>, profile: [f64; 3], room: f64, up: &mut [f64], down: &mut [f64]) {
        let [b, d, e] = profile;
        let [x, y, z] = self.0.each_ref().map(|list| &list[rows.clone()]);
        for (i, (up, down)) in up[rows.clone()].iter_mut().zip(&mut down[rows.clone()]).enumerate() {
            let form = x[i] * b + y[i] * d + z[i] * e;
            (*up, *down) = (room - form, room + form);
        }
    }
}

/// Fraction of the limits that each cell may use.
#[derive(Clone)]
pub(crate) struct Room {
    /// Usable fraction of the limits.
    pub(crate) part: Vec<f64>,
    /// True if the cell needs rows at more points.
    pub(crate) dense: Vec<bool>,
}

/// Minimum use of a limit by a previous profile, in a cell or near it, for which its rows are imposed on the next one.
const WORTH_A_ROW: f64 = 0.3;
/// Rows of jerk are always imposed on channels whose motion relative to their limits exceeds this fraction of the
/// fastest channel's.
const STIFF: f64 = 0.5;
/// Number of cells before and after that count as near.
const NEAR: usize = 3;

impl Problem {
    /// Builds the rows of `cells`, within the `room` of each. With the coefficients `near` of a nearby profile, rows
    /// far from it are left out of cells that are not dense.
    pub(crate) fn new(cells: &Cells, room: &Room, near: Option<&[f64]>) -> Self {
        let count = cells.count();
        let upper = (0..count + 2).map(|k| cells.upper(k)).collect();
        let (worth, worth_cap) = match near {
            Some(c) => worth(cells, c),
            None => (vec![[true; 2]; count * cells.limits.len()], vec![true; count]),
        };
        let sparse = Room { part: room.part.clone(), dense: vec![false; count] };
        let mut built = Self::bare(upper, sparse, worth, worth_cap);
        built.measure(cells);
        for cell in 0..count {
            built.add(cells, cell, |problem, part, channel| problem.is_imposed(cells, cell, part, channel));
        }
        built.tighten(cells, room);
        built
    }

    /// Reduces the `room`, and adds rows to newly dense cells. Existing slacks keep their indices, new ones follow.
    pub(crate) fn tighten(&mut self, cells: &Cells, room: &Room) {
        for group in &self.groups {
            let by = self.room.part[group.cell] / room.part[group.cell];
            self.caps.scale(&group.caps, by * by);
            self.accelerations.scale(&group.accelerations, by);
            for place in &self.places[group.places.clone()] {
                self.jerks.scale(&place.jerks, by);
            }
        }
        self.room.part.clone_from(&room.part);
        for cell in (0..cells.count()).filter(|cell| room.dense[*cell]) {
            if !self.room.dense[cell] {
                self.room.dense[cell] = true;
                self.add(cells, cell, |problem, part, channel| {
                    problem.is_imposed(cells, cell, part, channel).map(|before| !before)
                });
            }
        }
    }

    /// Flags for rows of acceleration and jerk of a channel, and of speed, at a part of a cell that is not dense.
    /// Acceleration is continuous between cells, jerk is not; speed is also bounded in the middle, where the profile
    /// would bulge otherwise.
    fn is_imposed(&self, cells: &Cells, cell: usize, part: usize, channel: usize) -> [bool; 3] {
        let (begin, end) = (part == 0, part + 1 == PARTS.len());
        let [acceleration, jerk] = self.worth[cell * cells.limits.len() + channel];
        [
            acceleration && (begin || (end && cell + 1 == cells.count())),
            jerk && (begin || end),
            self.worth_cap[cell] && part.is_multiple_of(2),
        ]
    }

    /// Adds the rows of a cell that are `wanted`: by part and channel, acceleration, jerk and, of the first channel,
    /// the cap of the speed.
    fn add(&mut self, cells: &Cells, cell: usize, wanted: impl Fn(&Self, usize, usize) -> [bool; 3]) {
        let room = self.room.part[cell];
        let begin = (self.caps.count(), self.accelerations.count(), self.places.len());
        for (part, x) in PARTS.iter().map(|part| part * cells.width(cell)).enumerate() {
            let along = [1.0, x, 0.5 * x * x];
            let cap = 1.0 / (cells.speed_cap(cell, part) * room * room);
            if wanted(self, part, 0)[2] && cap > 0.0 {
                self.caps.push(along.map(|w| cap * w));
            }
            let first = self.jerks.count();
            for (channel, ([q1, q2, q3], limits)) in cells.derivatives(cell, part).iter().zip(&cells.limits).enumerate()
            {
                let [acceleration, jerk, _] = wanted(self, part, channel);
                // Converts weights of the values here to weights of those at the cell's start.
                let push = |forms: &mut Forms, scale: f64, [b, d, e]: [f64; 3]| {
                    let form = [b, x * b + d, 0.5 * x * x * b + x * d + e];
                    if form.iter().any(|x| *x != 0.0) && scale > 0.0 {
                        forms.push(form.map(|x| scale * x));
                    }
                };
                if acceleration {
                    push(&mut self.accelerations, 1.0 / (room * limits.acceleration), [*q2, 0.5 * q1, 0.0]);
                }
                if jerk {
                    push(&mut self.jerks, 1.0 / (room * limits.jerk), [*q3, 1.5 * q2, 0.5 * q1]);
                }
            }
            if self.jerks.count() > first {
                self.places.push(Place { along, jerks: first..self.jerks.count() });
            }
        }
        self.groups.push(Group {
            cell,
            weights: cells.weights(cell),
            caps: begin.0..self.caps.count(),
            accelerations: begin.1..self.accelerations.count(),
            places: begin.2..self.places.len(),
        });
    }
}

/// Flags for accelerations and jerks of each channel that need a row in each cell, and for speeds, of a profile near
/// the one with coefficients `c`.
fn worth(cells: &Cells, c: &[f64]) -> (Vec<[bool; 2]>, Vec<bool>) {
    let (count, channels) = (cells.count(), cells.limits.len());
    let (used, speeds) = uses(cells, c);
    let mut worth = vec![[false; 2]; used.len()];
    let around = |cell: usize| cell.saturating_sub(NEAR)..(cell + NEAR + 1).min(count);
    for cell in 0..count {
        let stiffness = |channel: usize| cells.derivatives(cell, 2)[channel][0].abs() / cells.limits[channel].jerk;
        let stiffest = (0..channels).map(stiffness).fold(0.0, f64::max);
        for channel in 0..channels {
            let most = |k: usize| around(cell).map(|i| used[i * channels + channel][k]).fold(0.0, f64::max);
            // Channels that bound the change of acceleration always need rows.
            let stiff = stiffness(channel) > STIFF * stiffest;
            worth[cell * channels + channel] = [most(0) > WORTH_A_ROW, most(1) > WORTH_A_ROW || stiff];
        }
    }
    let fast = |cell: usize| around(cell).any(|i| speeds[i] > WORTH_A_ROW);
    (worth, (0..count).map(fast).collect())
}

/// Use of its acceleration and jerk by each channel in each cell, at the cell's ends and middle; and the maximum use of
/// squared speeds.
fn uses(cells: &Cells, c: &[f64]) -> (Vec<[f64; 2]>, Vec<f64>) {
    let mut used = Vec::with_capacity(cells.count() * cells.limits.len());
    let mut speeds = Vec::with_capacity(cells.count());
    for cell in 0..cells.count() {
        let profiles = [0, 2, 4].map(|part| (part, cells.profile(c, cell, PARTS[part])));
        for (channel, limits) in cells.limits.iter().enumerate() {
            let mut most: [f64; 2] = [0.0; 2];
            for (part, [b, d, e]) in profiles {
                let [q1, q2, q3] = cells.derivatives(cell, part)[channel];
                let jerk = b.max(0.0).sqrt() * (q3 * b + 1.5 * q2 * d + 0.5 * q1 * e);
                most = [
                    most[0].max((q2 * b + 0.5 * q1 * d).abs() / limits.acceleration),
                    most[1].max(jerk.abs() / limits.jerk),
                ];
            }
            used.push(most);
        }
        speeds.push(profiles.iter().map(|(part, [b, ..])| b / cells.speed_cap(cell, *part)).fold(0.0, f64::max));
    }
    (used, speeds)
}
