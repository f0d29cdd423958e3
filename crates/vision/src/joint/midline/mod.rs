mod centres;

use super::axis::{Station, length};
use super::even::{Even, Rows};
use super::lattice::Lattice;
use super::levels::Picture;
use super::make_room;
use super::profile::{Profile, about};
use super::readings::Readings;
use super::strip::{COLS, MID, Strip, lesser};
use super::trail::{Look, Place, Trail};
use crate::wide::Scalar;

/// Places before and after that a station is the mean of.
const SMOOTH: usize = 8;
/// Rows before and after that depth, step and width are means over.
const AROUND: usize = 12;
/// Depth, asymmetry and width change slowly: they are found once for so many rows.
const SLOWLY: usize = 4;
/// Metal is even if boxes beside each other differ by less than this part of the joint's depth.
const PLAIN: f32 = 0.4;

/// A row of the midline, in pixels of the level.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Found {
    pub(super) at: [f32; 2],
    pub(super) seen: bool,
    pub(super) width: f32,
    /// Depth, grey values.
    pub(super) depth: f32,
    /// Standard error across, pixels.
    pub(super) error: f32,
    /// How much likelier the path here is than the best one elsewhere, nats.
    pub(super) margin: f32,
    /// How much likelier a joint in the rows about is than none, nats.
    pub(super) strength: f32,
    /// Light steps across the joint.
    pub(super) stepped: bool,
    /// Depth of the row alone, by its own two sides.
    pub(super) own_depth: f32,
    /// How far apart middles between the rims are that are found in other ways, pixels.
    pub(super) asymmetry: f32,
    /// How much less the rows about look like the joint than most do: 1 at the limit.
    pub(super) unlike: f32,
    /// How far the middle stands off the smooth line through others before and after, pixels.
    pub(super) bump: f32,
}

/// The whole way once more along the trail: the best path, by all that is seen of it, and the middle between pixels.
#[derive(Debug, Clone, Default)]
pub(super) struct Midline {
    pub(super) rows: Vec<Found>,
    stations: Vec<Station>,
    before: Vec<[f64; 2]>,
    strip: Strip,
    lattice: Lattice,
    path: Vec<usize>,
    seen: Vec<bool>,
    margins: Vec<f32>,
    contrast: Vec<f32>,
    centre: Vec<f32>,
    single: Vec<f32>,
    readings: Readings,
    /// Middles of the rows in the picture.
    places: Rows,
    even: Even,
    /// Rows before and after that a parabola is fitted to.
    line: usize,
    /// How many of the rows before each are seen.
    seen_before: Vec<usize>,
    rests: Vec<f32>,
    sorted: Vec<f32>,
}

impl Midline {
    /// Room for so many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        make_room(&mut self.rows, rows);
        make_room(&mut self.stations, rows);
        make_room(&mut self.before, rows + 1);
        make_room(&mut self.path, rows);
        make_room(&mut self.seen, rows);
        make_room(&mut self.seen_before, rows + 1);
        let numbers = [
            &mut self.margins,
            &mut self.contrast,
            &mut self.centre,
            &mut self.single,
            &mut self.rests,
            &mut self.sorted,
        ];
        numbers.into_iter().for_each(|list| make_room(list, rows));
        self.strip.make_room(rows);
        self.lattice.make_room(rows);
        self.readings.make_room(rows);
        self.places.make_room(rows);
    }

    /// Finds it along `trail`.
    pub(super) fn find(&mut self, picture: &Picture, trail: &Trail, look: &Look) {
        self.stand(&trail.places);
        self.strip.unroll(picture, self.stations.iter().copied());
        let deepest = trail.places.iter().map(|p| p.contrast).fold(0.0, f32::max);
        self.strip.measure(look.width, look.most(deepest));
        self.contrast.clear();
        self.contrast.extend(trail.places.iter().map(|p| p.contrast));
        // The joint lies about along the stations.
        self.path.clear();
        self.path.resize(self.stations.len(), MID);
        // A few rows tell none.
        self.strip.noise = look.noise;
        self.strip.noise = self.strip.noise_beside(&self.path, (look.width, look.contrast));
        self.lattice.best(&self.strip, |i| self.contrast[i], |_| 0.0, &mut self.path);
        self.follow_contrast(&trail.places);
        let scale = (1 << look.level) as f32;
        let away = (2.0 / scale).max(0.5 * look.width).round().max(1.0) as usize;
        self.lattice.margins(&self.path, away, &mut self.margins);
        self.rows.clear();
        self.rows.resize(self.stations.len(), Found::default());
        self.judge_rows();
        self.centres(look.width, scale, picture.width.min(picture.height));
    }

    /// Smooth stations along the places.
    fn stand(&mut self, places: &[Place]) {
        let count = places.len();
        self.stations.clear();
        // The sums over those before each.
        self.before.clear();
        self.before.push([0.0; 2]);
        let mut sum = [0.0; 2];
        self.before.extend(places.iter().map(|p| {
            sum = [0, 1].map(|k| sum[k] + f64::from(p.at[k]));
            sum
        }));
        let smooth = |i: usize| {
            let reach = SMOOTH.min(i).min(count - 1 - i);
            let (before, after) = (&self.before[i - reach], &self.before[i + reach + 1]);
            let part = 1.0 / (2 * reach + 1) as f64;
            [0, 1].map(|k| ((after[k] - before[k]) * part) as f32)
        };
        self.stations.extend((0..count).map(|i| Station { at: smooth(i), tangent: [1.0, 0.0] }));
        for i in 0..count {
            let (a, b) = (self.stations[i.saturating_sub(6)].at, self.stations[(i + 6).min(count - 1)].at);
            let (x, y) = (b[0] - a[0], b[1] - a[1]);
            let length = length([x, y]);
            if length > 1e-3 {
                self.stations[i].tangent = [x / length, y / length];
            }
        }
    }

    /// The joint's depth near each row, from rows where there is much of it.
    fn follow_contrast(&mut self, places: &[Place]) {
        const REACH: usize = 40;
        let count = self.path.len();
        // Depths along the path, one after the other, where middles are put later.
        self.single.clear();
        self.single.extend(self.path.iter().zip(&self.strip.depth).map(|(j, row)| row[*j]));
        for (i, place) in places.iter().enumerate() {
            let known = place.contrast;
            if i % SLOWLY > 0 {
                self.contrast[i] = self.contrast[i - 1];
                continue;
            }
            let near = i.saturating_sub(REACH)..(i + REACH + 1).min(count);
            let (mut sum, mut weight) = (4.0 * known, 4.0);
            for d in self.single[near].iter().step_by(3) {
                let counts = f32::from(u8::from(*d > 0.4 * known));
                sum += counts * lesser(*d, 2.0 * known);
                weight += counts;
            }
            self.contrast[i] = sum / weight;
        }
    }

    fn judge_rows(&mut self) {
        let count = self.path.len();
        self.strip.shows(&self.path, |i| self.contrast[i], &mut self.seen);
        let evidence = |k: usize| f64::from(self.lattice.evidence(k, self.path[k]));
        let mut strength: f64 = (0..AROUND.min(count)).map(evidence).sum();
        for (i, row) in self.rows.iter_mut().enumerate() {
            if i + AROUND < count {
                strength += evidence(i + AROUND);
            }
            if i > AROUND {
                strength -= evidence(i - AROUND - 1);
            }
            (row.seen, row.strength, row.margin) = (self.seen[i], strength as f32, self.margins[i]);
        }
        self.seen_before.clear();
        self.seen_before.push(0);
        let mut seen = 0;
        self.seen_before.extend(self.rows.iter().map(|row| {
            seen += usize::from(row.seen);
            seen
        }));
    }

    /// Finds the last rows of a joint of `width` that ends before row `end` once more, without what is behind it. The last row is
    /// in part behind it.
    pub(super) fn end_before(&mut self, end: usize, width: f32) {
        let (from, whole) = (end.saturating_sub(self.line), end.saturating_sub(1));
        let profile = Profile::new(width);
        let depth = self.rows[from..whole].iter().map(|r| r.own_depth).sum::<f32>() / (whole - from).max(1) as f32;
        for _ in 0..3 {
            for i in from..whole {
                let moment = profile.read(Scalar::new(), &about(&self.strip.grey[i], self.centre[i])).moment;
                self.single[i] = self.centre[i] + (moment / depth.max(1e-3)).clamp(-0.5 * width, 0.5 * width);
            }
            self.place_middles();
            for i in from..end {
                // Next to the end all rows are on one side: more of them hold it.
                self.centre[i] = self.fit(i, self.line + 2 * (i - from) / 3, whole);
            }
        }
        for i in from..end {
            self.rows[i].at = self.stations[i].beside(self.centre[i] - MID as f32);
        }
    }

    /// True if there is nothing but even metal behind row `end` of a joint so many grey values deep: no edge, no line, no tack.
    pub(super) fn is_plain_behind(&self, end: usize, depth: f32) -> bool {
        const ROWS: usize = 16;
        const BOX: usize = 4;
        const APART: usize = BOX + 3;
        let most = PLAIN * depth * (BOX * ROWS) as f32;
        let behind = &self.strip.grey[(end + ROWS / 2).min(self.strip.grey.len())..];
        behind.chunks_exact(ROWS).all(|rows| {
            let mut sum = [0.0; COLS];
            rows.iter().for_each(|row| sum.iter_mut().zip(row).for_each(|(s, g)| *s += g));
            let boxes: [f32; COLS - BOX + 1] = std::array::from_fn(|j| sum[j..j + BOX].iter().sum());
            boxes.iter().zip(&boxes[APART..]).all(|(a, b)| (a - b).abs() < most)
        })
    }

    /// True where both sides of the joint are in the picture.
    pub(super) fn is_whole(&self, i: usize, picture: &Picture) -> bool {
        let (right, bottom) = ((picture.width - 1) as f32, (picture.height - 1) as f32);
        [-1.0, 1.0].iter().all(|side| {
            let across = self.centre[i] - MID as f32 + side * 1.5 * self.rows[i].width;
            let [x, y] = self.stations[i].beside(across);
            (0.0..=right).contains(&x) && (0.0..=bottom).contains(&y)
        })
    }
}
