//! The middle of each row, between columns.

use super::{AROUND, Midline, SLOWLY};
use crate::joint::axis::Station;
use crate::joint::lattice::column_about;
use crate::joint::parabola::Parabola;
use crate::joint::profile::Profile;
use crate::joint::readings::Window;
use crate::joint::sliding_parabola;
use crate::joint::strip::MID;
use crate::simd::{LANES, Work, wide};
use pulp::Simd;

/// Rows before and after over which step and rims are averaged where the light steps.
const STEPPED_AROUND: usize = 4;
/// Tolerances of a profile that is like the joint's: a multiple of the median difference ...
const USUAL: f32 = 1.6;
/// ... plus this part of the depth.
const LIKE: f32 = 0.06;
/// Minimum and maximum rows before and after for the parabola through the middles.
const LINE: (usize, usize) = (6, sliding_parabola::MAX_REACH);
/// Maximum length of a parabola as a part of the picture's shorter side: longer ones do not follow a winding joint.
const LONGEST: f32 = 0.14;
/// Target for the midline's standard error, pixels of the frame.
const ERROR: f32 = 0.15;
/// On coarse levels noise is small: rims whose middle differs from the profile's by more than this part of the width
/// are right. Something beside the joint distorts the profile.
const OTHER: f32 = 0.2;
/// Rows between the supports of a smooth line, for short and for long bumps.
const BUMP: [usize; 2] = [10, 20];
/// A light step exceeds this part of the depth and this many standard errors.
const STEP: f32 = 0.3;
const STEP_ERRORS: f32 = 3.5;
/// Stiffness that holds a parabola to a line: with all rows on one side, noise would bend it.
const STIFF: f32 = 100.0;

/// See [`Midline::centres`].
struct Centres<'a> {
    midline: &'a mut Midline,
    width: f32,
    scale: f32,
    side: usize,
}

impl Work for Centres<'_> {
    #[inline(always)]
    fn run(self, simd: impl Simd) {
        self.midline.find_centres(simd, self.width, self.scale, self.side);
    }
}

impl Midline {
    /// Finds the middle of each row between columns, for a joint of `width` columns of `scale` pixels of the frame.
    /// `side` is the picture's shorter side.
    pub(super) fn centres(&mut self, width: f32, scale: f32, side: usize) {
        wide(Centres { midline: self, width, scale, side });
    }

    #[inline(always)]
    fn find_centres<S: Simd>(&mut self, simd: S, width: f32, scale: f32, side: usize) {
        let count = self.path.len();
        let profile = Profile::new(width);
        self.centre.clear();
        self.centre.extend((0..count).map(|i| column_about(&self.path, i, 4)));
        for round in 0..2 {
            self.readings.read(&profile, &self.strip, &self.centre);
            self.read_middles(&profile, width, scale);
            self.place_middles();
            if round == 0 {
                self.line = self.line_length(scale, side);
                self.even.prepare(self.line);
            }
            self.fit_all(0.7 * width + 1.5);
        }
        self.compare(simd, profile.reach());
        let mut slow = (0.0, None);
        for i in 0..count {
            self.rows[i].at = self.stations[i].beside(self.centre[i] - MID as f32);
            if i % SLOWLY == 0 {
                let [line, about] = [self.line, AROUND].map(|around| self.readings.mean(i, around));
                slow = (profile.asymmetry(&line), profile.rims(&about));
            }
            self.rows[i].asymmetry = slow.0;
            self.rows[i].width = slow.1.map_or(width, |[left, right]| right - left);
        }
        self.find_bumps();
    }

    /// Measures the middle of each row from the row itself, or from the rims of the rows about it.
    #[inline(always)]
    fn read_middles(&mut self, profile: &Profile, width: f32, scale: f32) {
        let most = 0.4 * width + 0.5;
        self.single.clear();
        for (i, row) in self.rows.iter_mut().enumerate() {
            let (about, reading) = (self.readings.about(i, AROUND), self.readings.row(i));
            row.stepped = about.step.abs() > STEP * about.depth
                && about.step * about.step > STEP_ERRORS * STEP_ERRORS * about.step_variance;
            (row.depth, row.own_depth) = (about.depth, reading.depth);
            let part = 1.0 / about.depth.max(1e-3);
            let rims = if row.stepped || scale > 1.0 {
                profile.rims(&self.readings.mean(i, STEPPED_AROUND)).map(|[left, right]| 0.5 * (left + right))
            } else {
                None
            };
            let usual = || part * self.readings.about(i, STEPPED_AROUND).moment;
            let off = rims.filter(|middle| row.stepped || (middle - usual()).abs() > OTHER * width);
            let off = off.unwrap_or(part * reading.moment);
            self.single.push(self.centre[i] + off.clamp(-most, most));
        }
    }

    /// Measures each row's distance from the cubic through four rows, two before and two after at equal distances. The
    /// rest is not explained by the joint's bend: a second joint or a scratch pulls the middle aside.
    #[inline(always)]
    fn find_bumps(&mut self) {
        for apart in BUMP {
            for i in 2 * apart..self.rows.len().saturating_sub(2 * apart) {
                let five = [i - 2 * apart, i - apart, i, i + apart, i + 2 * apart].map(|k| &self.rows[k]);
                if five.iter().any(|row| !row.seen) {
                    continue;
                }
                let [a, b, c, d, e] = five.map(|row| row.at);
                let off = |k: usize| c[k] - (4.0 * (b[k] + d[k]) - a[k] - e[k]) * (1.0 / 6.0);
                let [cos, sin] = self.stations[i].tangent;
                let bump = (off(1) * cos - off(0) * sin).abs();
                self.rows[i].bump = self.rows[i].bump.max(bump);
            }
        }
    }

    #[inline(always)]
    pub(super) fn place_middles(&mut self) {
        let middles = self.stations.iter().zip(&self.single).zip(&self.seen);
        self.places.put(middles.map(|((station, middle), seen)| (station.beside(middle - MID as f32), *seen)));
    }

    /// Measures the dissimilarity of the rows about each row to the joint.
    #[inline(always)]
    fn compare(&mut self, simd: impl Simd, reach: usize) {
        const ROWS: usize = 3;
        self.readings.rests(simd, Window { reach, around: ROWS }, |i| self.rows[i].seen, &mut self.rests);
        self.sorted.clear();
        self.sorted.extend(self.rests.iter().zip(&self.rows).filter(|(_, row)| row.seen).map(|(rest, _)| *rest));
        if self.sorted.is_empty() {
            return;
        }
        let middle = self.sorted.len() / 2;
        let usual = *self.sorted.select_nth_unstable_by(middle, f32::total_cmp).1;
        for (row, rest) in self.rows.iter_mut().zip(&self.rests) {
            row.unlike = rest / (USUAL * usual + LIKE * row.depth.max(1e-3));
        }
    }

    /// Returns the rows that a parabola needs for the target error, by the scatter of the centres. `side` is the
    /// picture's shorter side.
    #[inline(always)]
    fn line_length(&self, scale: f32, side: usize) -> usize {
        let (mut sum, mut count) = (0.0, 0);
        for i in (2..self.single.len().saturating_sub(2)).filter(|i| self.rows[*i].seen) {
            // Second difference over two rows each: its variance is 6 times that of a row.
            let bend = self.single[i - 2] - 2.0 * self.single[i] + self.single[i + 2];
            sum += bend * bend;
            count += 1;
        }
        let variance = sum / (6 * count.max(1)) as f32 * scale * scale;
        let most = ((LONGEST * side as f32) as usize).clamp(LINE.0, LINE.1);
        ((variance / (ERROR * ERROR)) as usize).clamp(LINE.0, most)
    }

    /// Fits the centres by parabolas through the middles about them, within `most` columns of the path.
    #[inline(always)]
    fn fit_all(&mut self, most: f32) {
        let (count, reach) = (self.path.len(), self.line);
        let all_seen = |seen_before: &[usize], i: usize| {
            i >= reach && i + reach < count && seen_before[i + reach + 1] - seen_before[i - reach] == 2 * reach + 1
        };
        for i in (0..count).step_by(LANES) {
            let last = (i + LANES).min(count);
            let stations = &self.stations[i..last];
            let found = if all_seen(&self.seen_before, i) && all_seen(&self.seen_before, last - 1) {
                self.even.across(&self.places, i, stations)
            } else {
                let found = self.even.across_seen(&self.places, i, stations, STIFF);
                std::array::from_fn(|k| {
                    let unknown = || (self.centre[(i + k).min(last - 1)] - MID as f32, f32::INFINITY);
                    found[k].map_or_else(unknown, |parabola| (parabola.terms[0], parabola.error()))
                })
            };
            for (k, (across, error)) in (i..last).zip(found) {
                let path = self.path[k] as f32;
                self.centre[k] = (across + MID as f32).clamp(path - most, path + most);
                self.rows[k].error = error;
            }
        }
    }

    /// Returns the crossing of row `i`'s line with the parabola through the seen rows about it and before row `end`.
    #[inline(always)]
    pub(super) fn fit(&self, i: usize, reach: usize, end: usize) -> f32 {
        let near = i.saturating_sub(reach)..(i + reach + 1).min(end);
        let Station { at: [x0, y0], tangent: [cos, sin] } = self.stations[i];
        // Computes all rows, several at a time, then selects the seen ones.
        let (scale, first) = (1.0 / (reach + 1) as f32, near.start as i32 - i as i32);
        let mut local = [[0.0f32; 2 * sliding_parabola::MAX_REACH + 1]; 3];
        let [us, vs, weights] = &mut local;
        let places = self.places.places(near.clone());
        for (k, (((u, v), weight), [x, y])) in us.iter_mut().zip(vs).zip(weights).zip(places).enumerate() {
            (*u, *v) = ((x - x0) * cos + (y - y0) * sin, (y - y0) * cos - (x - x0) * sin);
            *weight = 1.0 - ((first + k as i32) as f32 * scale).powi(2);
        }
        let seen = self.seen[near].iter().enumerate().filter(|(_, seen)| **seen);
        let places = seen.map(|(k, _)| (local[0][k], local[1][k], local[2][k]));
        Parabola::through(places, STIFF).map_or(self.centre[i], |parabola| parabola.terms[0] + MID as f32)
    }
}
