mod centres;

use super::axis::{Station, length};
use super::lattice::Lattice;
use super::levels::Picture;
use super::make_room;
use super::profile::{Profile, about};
use super::readings::Readings;
use super::sliding_parabola::{Rows, SlidingParabola};
use super::strip::{COLS, MID, Strip, lesser};
use super::trail::{Look, Place, Trail};
use pulp::Scalar;

/// Points before and after over which a station is averaged.
const SMOOTH: usize = 8;
/// Rows before and after over which depth, step and width are averaged.
const AROUND: usize = 12;
/// Depth, asymmetry and width change slowly: they are computed once per this many rows.
const SLOWLY: usize = 4;
/// Metal is uniform if boxes beside each other differ by less than this part of the joint's depth.
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
    /// Log likelihood ratio of the path here to the best one elsewhere, nats.
    pub(super) margin: f32,
    /// Log likelihood ratio of a joint to no joint in the rows about, nats.
    pub(super) strength: f32,
    /// The light steps across the joint.
    pub(super) stepped: bool,
    /// Depth of this row alone.
    pub(super) own_depth: f32,
    /// Spread of the middles between the rims by different measures, pixels.
    pub(super) asymmetry: f32,
    /// Dissimilarity of the rows about to the joint; 1 at the limit.
    pub(super) unlike: f32,
    /// Distance of the middle from the smooth line through rows before and after, pixels.
    pub(super) bump: f32,
}

/// The second pass along the whole trail: the best path by all evidence, and the middle between pixels.
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
    /// Middles of the rows, in the picture.
    places: Rows,
    even: SlidingParabola,
    /// Rows before and after for a parabola.
    line: usize,
    /// Number of seen rows before each row.
    seen_before: Vec<usize>,
    rests: Vec<f32>,
    sorted: Vec<f32>,
}

impl Midline {
    /// Reserves capacity for this many rows.
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

    pub(super) fn find(&mut self, picture: &Picture, trail: &Trail, look: &Look) {
        self.stand(&trail.places);
        self.strip.unroll(picture, self.stations.iter().copied());
        let deepest = trail.places.iter().map(|p| p.contrast).fold(0.0, f32::max);
        self.strip.measure(look.width, look.most(deepest));
        self.contrast.clear();
        self.contrast.extend(trail.places.iter().map(|p| p.contrast));
        // The joint lies near the stations.
        self.path.clear();
        self.path.resize(self.stations.len(), MID);
        // Default for strips with too few rows to measure the noise.
        self.strip.noise = look.noise;
        self.strip.noise = self.strip.noise_beside(&self.path, look.line());
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

    /// Places smooth stations along the points.
    fn stand(&mut self, places: &[Place]) {
        let count = places.len();
        self.stations.clear();
        // Cumulative sums, before each point.
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

    /// Updates the joint's depth near each row from rows that clearly show it.
    fn follow_contrast(&mut self, places: &[Place]) {
        const REACH: usize = 40;
        let count = self.path.len();
        // Depths along the path, stored in the buffer for the middles.
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

    /// Finds the last rows of a joint of `width` that ends before row `end` again, without the rows behind the end. The
    /// last row lies partly behind it.
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
                // Next to the end all rows are on one side, so more rows are used.
                self.centre[i] = self.fit(i, self.line + 2 * (i - from) / 3, whole);
            }
        }
        for i in from..end {
            self.rows[i].at = self.stations[i].beside(self.centre[i] - MID as f32);
        }
    }

    /// Returns true if only uniform metal, without edge, line or tack, follows row `end` of a joint of this depth, grey
    /// values.
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

    /// Returns true if both sides of the joint are in the picture.
    pub(super) fn is_whole(&self, i: usize, picture: &Picture) -> bool {
        let (right, bottom) = ((picture.width - 1) as f32, (picture.height - 1) as f32);
        [-1.0, 1.0].iter().all(|side| {
            let across = self.centre[i] - MID as f32 + side * 1.5 * self.rows[i].width;
            let [x, y] = self.stations[i].beside(across);
            (0.0..=right).contains(&x) && (0.0..=bottom).contains(&y)
        })
    }
}
