//! A plain follower of a dark line: mean profiles across the predicted course, the darkest box of the line's width, a
//! parabola through what was seen last.
//!
//! It is what teaching needs at least: guided, sub-pixel, with a confidence, coasting over tacks. It keeps one hypothesis
//! and the width that it finds at the start.

use crate::{Frame, Pixels};
use glam::DVec2;

/// Widths that are tried at the start, pixels.
const WIDTHS: [usize; 4] = [3, 5, 9, 15];
/// Pixels to both sides of the course that a profile covers.
const REACH: i32 = 24;
/// Pixels before and after a row that its profile is the mean of.
const GROUP: i32 = 4;
/// Rows to both sides that must mostly be dark for a row to be seen, and how many of them with it.
const NEIGHBOURS: (usize, usize) = (6, 7);
/// A row is dark from this many standard deviations on, and from this part of the usual contrast.
const DARK: (f64, f64) = (4.0, 0.4);
/// Rows that the course is carried on from.
const MEMORY: usize = 40;
/// How far beside the course the line is looked for: at first, while it is seen, and how much more for each pixel coasted.
const GATE: (f64, f64, f64) = (12.0, 4.0, 0.08);
/// The frame's rim, pixels.
const RIM: f64 = 6.0;

/// A row along the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RidgeRow {
    /// The midline there, pixels.
    pub px: DVec2,
    /// 0 to 1; 0 of rows that were coasted over.
    pub confidence: f64,
    /// Seen, and not only coasted over.
    pub seen: bool,
}

/// Why a line ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RidgeEnd {
    /// At the frame's rim.
    LeftImage,
    /// It was seen well, and then no longer for longer than the longest gap: it ends, or something long covers it.
    Ended,
    /// It was hardly seen at all.
    Lost,
}

/// A line in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Ridge {
    /// Rows a pixel apart; those after the last one seen are left out.
    pub rows: Vec<RidgeRow>,
    /// Why it ends.
    pub end: RidgeEnd,
    /// Its width, pixels, as far as the four that are tried tell it; 0 if nothing was found.
    pub width_px: f64,
}

/// Follows the dark line that begins near `start` and runs roughly along `direction` (pixels, x right, y down), over gaps of
/// up to `longest_gap` pixels.
#[must_use]
pub fn follow_ridge(frame: &Frame, start: DVec2, direction: DVec2, longest_gap: f64) -> Ridge {
    let nothing = Ridge { rows: Vec::new(), end: RidgeEnd::Lost, width_px: 0.0 };
    let Some(direction) = direction.try_normalize().filter(|_| start.is_finite()) else { return nothing };
    let mut course = Course { at: start, direction, bend: 0.0 };
    let mut profile = Profile::default();
    // The width that stands out most, over the first pixels.
    let mut best: Option<(f64, usize, f64)> = None;
    for step in 0..3 {
        profile.read(frame, course.at + f64::from(4 * step) * direction, direction);
        for width in WIDTHS {
            if let Some(found) = profile.darkest(width, (0.0, GATE.0)).filter(|f| f.sigmas > DARK.0)
                && best.is_none_or(|(sigmas, ..)| found.sigmas > sigmas)
            {
                best = Some((found.sigmas, width, found.depth));
            }
        }
    }
    let Some((_, width, contrast)) = best else { return nothing };
    let mut follower = Following { rows: Vec::new(), dark: Vec::new(), width, contrast, unseen: 0 };
    let end = loop {
        let (at, size) = (course.at, DVec2::new(frame.width() as f64, frame.height() as f64));
        if at.min_element() < RIM || (size - 1.0 - at).min_element() < RIM {
            break RidgeEnd::LeftImage;
        }
        if f64::from(follower.unseen) > longest_gap.max(10.0) {
            break RidgeEnd::Ended;
        }
        profile.read(frame, at, course.direction);
        follower.row(&profile, &course);
        follower.lead(&mut course);
    };
    follower.finish(end)
}

/// Where the line is expected, and how it goes on.
struct Course {
    at: DVec2,
    direction: DVec2,
    /// Turn of the direction a pixel, rad.
    bend: f64,
}

/// Grey values across the course, each the mean of a group along it.
struct Profile {
    values: [f64; 2 * REACH as usize + 1],
    /// Standard deviation of one of them.
    sigma: f64,
}

impl Default for Profile {
    fn default() -> Self {
        Self { values: [0.0; 2 * REACH as usize + 1], sigma: 0.0 }
    }
}

/// The darkest place of a profile.
struct Darkest {
    /// Pixels beside the course.
    offset: f64,
    /// By how much it is darker than the darker of its sides.
    depth: f64,
    /// The same in standard deviations.
    sigmas: f64,
    /// The same of the next best place that is another one, as a part of it.
    rival: f64,
}

impl Profile {
    fn read(&mut self, frame: &Frame, at: DVec2, along: DVec2) {
        let across = along.perp();
        for (i, value) in self.values.iter_mut().enumerate() {
            let from = at + (i as f64 - f64::from(REACH)) * across;
            let sum: f64 = (-GROUP..=GROUP).map(|k| grey(frame, from + f64::from(k) * along)).sum();
            *value = sum / f64::from(2 * GROUP + 1);
        }
        // Differences next to each other are noise nearly everywhere.
        let mut steps: Vec<f64> = self.values.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
        let middle = steps.len() / 2;
        let median = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
        self.sigma = (1.4826 * median / std::f64::consts::SQRT_2).max(0.15);
    }

    /// The darkest box of `width` pixels within `gate` pixels of `about`, against the darker of the boxes beside it.
    fn darkest(&self, width: usize, (about, gate): (f64, f64)) -> Option<Darkest> {
        let mean = |from: usize, to: usize| self.values[from..to].iter().sum::<f64>() / (to - from) as f64;
        // A bell of this width still darkens its surroundings by a third of it: sides stand off by that.
        let (half, off) = (width / 2, width.div_ceil(3));
        let side = width.max(4);
        let depth = |i: usize| {
            let (left, right) = (i.checked_sub(half + off + side)?, i + half + off + 1);
            let right = (right + side <= self.values.len()).then(|| mean(right, right + side))?;
            Some(mean(left, left + side).min(right) - mean(i - half, i + half + 1))
        };
        let offset = |i: usize| i as f64 - f64::from(REACH);
        let depths: Vec<(usize, f64)> = (0..self.values.len()).filter_map(|i| Some((i, depth(i)?))).collect();
        let near = depths.iter().filter(|(i, _)| (offset(*i) - about).abs() <= gate);
        let &(i, depth) = near.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let other = depths.iter().filter(|(k, _)| k.abs_diff(i) >= 2 * width && (offset(*k) - about).abs() <= gate);
        let rival = other.map(|(_, d)| *d).fold(0.0, f64::max) / depth.max(1e-9);
        let sigma = self.sigma * (1.0 / width as f64 + 1.0 / side as f64).sqrt();
        let centre = self.centroid(i, half + off)?;
        Some(Darkest { offset: centre - f64::from(REACH), depth, sigmas: depth / sigma, rival })
    }

    /// Centre of what is darker than the straight line between both sides of place `i`.
    fn centroid(&self, i: usize, reach: usize) -> Option<f64> {
        let (left, right) = (i.checked_sub(reach)?, i + reach);
        if left == 0 || right + 1 >= self.values.len() {
            return None;
        }
        let side = |k: usize| (self.values[k - 1] + self.values[k] + self.values[k + 1]) / 3.0;
        let (a, b) = (side(left), side(right));
        let (mut sum, mut weight) = (0.0, 0.0);
        for k in left..=right {
            let base = a + (b - a) * (k - left) as f64 / (right - left) as f64;
            let w = (base - self.values[k]).max(0.0);
            sum += w * k as f64;
            weight += w;
        }
        (weight > 0.0).then(|| sum / weight)
    }
}

/// What was followed so far.
struct Following {
    rows: Vec<RidgeRow>,
    /// Whether each row is dark by itself.
    dark: Vec<bool>,
    width: usize,
    contrast: f64,
    /// Rows since one was seen.
    unseen: u32,
}

impl Following {
    fn row(&mut self, profile: &Profile, course: &Course) {
        let gate = if self.rows.is_empty() { GATE.0 } else { GATE.1 + GATE.2 * f64::from(self.unseen) };
        let found = profile.darkest(self.width, (0.0, gate.min(GATE.0)));
        let dark = found.filter(|f| f.sigmas > DARK.0 && f.depth > DARK.1 * self.contrast);
        let offset = dark.as_ref().map_or(0.0, |f| f.offset);
        let confidence = dark.as_ref().map_or(0.0, |f| {
            let stands_out = 1.0 - (-(f.sigmas - DARK.0) / 4.0).exp();
            let usual = (f.depth / self.contrast).min(self.contrast / f.depth);
            stands_out * usual.sqrt().min(1.0) * (1.6 - f.rival).clamp(0.0, 1.0)
        });
        self.rows.push(RidgeRow { px: course.at + offset * course.direction.perp(), confidence, seen: false });
        self.dark.push(dark.is_some());
        let recent = self.dark.iter().rev().take(NEIGHBOURS.0).filter(|d| **d).count();
        if dark.is_some() && recent > NEIGHBOURS.0 / 2 {
            self.unseen = 0;
            if let Some(f) = dark {
                self.contrast += 0.05 * (f.depth - self.contrast);
            }
        } else {
            self.unseen += 1;
        }
    }

    /// Carries the course on by a pixel: a parabola through the dark rows of late, a straight line through few.
    fn lead(&self, course: &mut Course) {
        let step = |course: &mut Course| {
            // A bend that was seen is not believed for long.
            course.bend *= 0.985;
            course.direction = DVec2::from_angle(course.bend).rotate(course.direction);
            course.at += course.direction;
        };
        let recent = self.dark.iter().rev().take(NEIGHBOURS.0).filter(|d| **d).count();
        if self.unseen > 0 || recent <= NEIGHBOURS.0 / 2 {
            return step(course);
        }
        let rows = self.rows.iter().zip(&self.dark).rev().take(MEMORY).filter(|(_, dark)| **dark);
        let (along, across) = (course.direction, course.direction.perp());
        let places: Vec<DVec2> =
            rows.map(|(r, _)| r.px - course.at).map(|p| DVec2::new(p.dot(along), p.dot(across))).collect();
        let Some((a, b, c)) = parabola(&places, places.len() >= MEMORY / 2) else { return step(course) };
        let (place, slope) = (a + b + c, b + 2.0 * c);
        course.at += along + place * across;
        course.direction = (along + slope * across).normalize();
        course.bend = 2.0 * c;
    }

    fn finish(mut self, end: RidgeEnd) -> Ridge {
        let (reach, least) = NEIGHBOURS;
        for i in 0..self.rows.len() {
            let around = &self.dark[i.saturating_sub(reach)..(i + reach + 1).min(self.dark.len())];
            // At the rim half of them are missing.
            let least = least * around.len() / (2 * reach + 1);
            self.rows[i].seen = self.dark[i] && around.iter().filter(|d| **d).count() >= least.max(2);
            if !self.rows[i].seen {
                self.rows[i].confidence = 0.0;
            }
        }
        let last = self.rows.iter().rposition(|r| r.seen).map_or(0, |i| i + 1);
        let seen = self.rows.iter().filter(|r| r.seen).count();
        let end = if seen < 2 * reach { RidgeEnd::Lost } else { end };
        // What was coasted over at the end has no use, but where the line leaves the frame it may go on.
        self.rows.truncate(last);
        Ridge { rows: self.rows, end, width_px: self.width as f64 }
    }
}

/// u = a + b v + c v^2 nearest to places (v, u); without c if they are few.
fn parabola(places: &[DVec2], bent: bool) -> Option<(f64, f64, f64)> {
    let count = if bent { 3 } else { 2 };
    if places.len() < 4 {
        return None;
    }
    let scale = MEMORY as f64;
    let mut normal = nalgebra::Matrix3::<f64>::identity() * 1e-6;
    let mut right = nalgebra::Vector3::<f64>::zeros();
    for p in places {
        let v = p.x / scale;
        let basis = [1.0, v, v * v];
        for i in 0..count {
            right[i] += basis[i] * p.y;
            for j in 0..count {
                normal[(i, j)] += basis[i] * basis[j];
            }
        }
    }
    let u = normal.cholesky()?.solve(&right);
    Some((u[0], u[1] / scale, if bent { u[2] / (scale * scale) } else { 0.0 }))
}

/// Grey value between pixels; outside that of the rim.
fn grey(frame: &Frame, at: DVec2) -> f64 {
    let (width, height) = (frame.width(), frame.height());
    let clamp = |v: f64, size: usize| v.clamp(0.0, size as f64 - 1.0);
    let (x, y) = (clamp(at.x, width), clamp(at.y, height));
    let (left, top) = (x as usize, y as usize);
    let (right, bottom) = ((left + 1).min(width - 1), (top + 1).min(height - 1));
    let (fx, fy) = (x - left as f64, y - top as f64);
    let value = |x: usize, y: usize| match frame.pixels() {
        Pixels::U8(p) => f64::from(p[y * width + x]),
        Pixels::U16(p) => f64::from(p[y * width + x]) / 257.0,
    };
    let upper = value(left, top) * (1.0 - fx) + value(right, top) * fx;
    let lower = value(left, bottom) * (1.0 - fx) + value(right, bottom) * fx;
    upper * (1.0 - fy) + lower * fy
}
