//! Two sheets without a groove between them: lap and butt joints.

use super::groove::{SHOULDERS, mismatch};
use super::{Edge, Support, View, between, ramp, turn};
use crate::stripe::fit::line;
use crate::stripe::profile::Sample;
use crate::stripe::{Feature, Features, NoFeatures, Quantity, Segment};

/// Widest gap of a butt joint in columns.
const WIDEST: f64 = 120.0;

/// Columns of the window that tells the usual strength about a dark line, and half the width of such a line.
const AROUND: usize = 40;
const DARK: usize = 2;

/// How far the sheets of a lap joint may seem to overlap, columns.
const OVERLAP: f64 = 8.0;

/// Part of a gap's columns in which something may be seen.
const LIT: f64 = 0.4;

/// Least slope of the face of a plate's end: the wall of a groove is less steep.
const FACE: f64 = 8.0;

/// The same for no, and for full confidence in a butt joint: a reflection on a plate makes steps and gaps like a seam.
const BUTT_CROWD: [f64; 2] = [0.25, 0.18];

/// Part of the columns with other light than the stripe's from which on there are reflections.
const CROWDED: f64 = 0.1;

/// Part of the columns that each plate must have for no, and for full confidence.
const PLATE: [f64; 2] = [0.08, 0.15];

/// Least depth of a dark line, part of the strength, and in deviations of the strength along the stripe.
const LEAST_DIP: f64 = 0.25;
const STANDS_OUT: f64 = 6.0;

/// Where the seam of a butt joint is: last column of the left plate and first one of the right, and how sure it is.
struct Seam {
    left: i32,
    right: i32,
    margin: f64,
    /// A dark line only.
    dark: Option<f64>,
}

impl View<'_> {
    /// Two parallel sheets, one higher than the other by a step.
    pub(super) fn lap(&mut self) -> Result<Features, NoFeatures> {
        let (Some(&first), Some(&last)) = (self.segments.first(), self.segments.last()) else {
            return Err(NoFeatures::NoStep);
        };
        if self.segments.len() < 2 || turn(&first.line, &last.line).abs() > SHOULDERS {
            return Err(NoFeatures::NoStep);
        }
        let left = self.edge(&first, last.columns.0).ok_or(NoFeatures::NoStep)?;
        let right = self.edge(&last, first.columns.1).ok_or(NoFeatures::NoStep)?;
        // The upper sheet is the one whose end is above the other's line.
        let (upper, lower) = if last.line.off(left.at) > 0.0 { (left, last) } else { (right, first) };
        let height = lower.line.off(upper.at);
        let share = self.share(self.samples(), &[first, last]);
        let apart = (right.column - left.column) * self.pitch();
        if height < self.task.least_step
            || share < 0.55
            || apart > 1.2 * height + 10.0 * self.pitch()
            || apart < -OVERLAP * self.pitch()
        {
            return Err(NoFeatures::NoStep);
        }
        let (line, step) = if lower == last { (first.line, 1) } else { (last.line, -1) };
        let seen = if upper.hidden || self.hidden(&upper, &line, step, &[first, last]) { 0.0 } else { 1.0 };
        let margin = seen * ramp(height / self.task.least_step, 1.0, 1.2) * ramp(share, 0.7, 0.85);
        let mut values =
            [(Quantity::Height, height), (Quantity::Bend, turn(&first.line, &last.line)), (Quantity::Gap, 0.0)];
        let known = match self.task.thickness {
            Some(thickness) => {
                values[2].1 = (height - thickness).max(0.0);
                3
            }
            None => 2,
        };
        let points = [(Feature::Joint, lower.line.foot(upper.at)), (Feature::UpperEdge, upper.at)];
        let segments = [first, last];
        Ok(self.features(&points, &values[..known], &Support { share, segments: &segments, margin, covered: false }))
    }

    /// Two plates in line with a gap, a mismatch or a dark line between them.
    pub(super) fn butt(&mut self) -> Result<Features, NoFeatures> {
        let seam = self.seam().ok_or(NoFeatures::NoSeam)?;
        let (first, last) = (0, self.profile.columns() as i32 - 1);
        let left = self.plate(first, seam.left).ok_or(NoFeatures::NoSeam)?;
        let right = self.plate(seam.right, last).ok_or(NoFeatures::NoSeam)?;
        let along = between(&left.line, &right.line);
        let (a, b) = self.facing_ends(&left, &right, &seam).ok_or(NoFeatures::NoSeam)?;
        let joint = (a.at + b.at) / 2.0;
        let gap = if seam.dark.is_some() { 0.0 } else { (b.at - a.at).dot(along).max(0.0) };
        let step = mismatch(&left, &right, joint, along);
        // A step that the plates themselves do not show was something else's.
        let none = seam.dark.is_none() && gap < 1.5 * self.pitch() && step.abs() < 1.5 * self.grain();
        let share = self.share(self.samples(), &[left, right]);
        let bend = turn(&left.line, &right.line);
        let apart = gap / self.pitch();
        if step.abs() > self.task.least_step || bend.abs() > 0.2 || share < 0.6 || apart > WIDEST || none {
            return Err(NoFeatures::NoSeam);
        }
        let plates = [left, right];
        let shorter = f64::from((seam.left - first).min(last - seam.right)) / f64::from(last - first + 1);
        let hidden = seam.dark.is_none()
            && (a.hidden
                || b.hidden
                || self.hidden(&a, &left.line, 1, &plates)
                || self.hidden(&b, &right.line, -1, &plates)
                || self.lit_gap((&a, &left), (&b, &right)));
        let margin = if hidden { 0.0 } else { seam.margin }
            * ramp(share, 0.75, 0.9)
            * ramp(self.crowd((first, last)), BUTT_CROWD[0], BUTT_CROWD[1])
            * ramp(shorter, PLATE[0], PLATE[1])
            * ramp(bend.abs(), 0.2, 0.12)
            * ramp(step.abs() / self.task.least_step, 1.0, 0.85);
        let values = [(Quantity::Gap, gap), (Quantity::Mismatch, step), (Quantity::Bend, bend)];
        let points = [(Feature::Joint, joint), (Feature::LeftEdge, a.at), (Feature::RightEdge, b.at)];
        let segments = [left, right];
        Ok(self.features(&points, &values, &Support { share, segments: &segments, margin, covered: false }))
    }

    /// Whether anything but the faces of the ends is seen in a good part of the gap's columns: something that hides that
    /// it is none, or a groove.
    fn lit_gap(&self, (a, left): (&Edge, &Segment), (b, right): (&Edge, &Segment)) -> bool {
        let (from, to) = (a.column.ceil() as i32 + 2, b.column.floor() as i32 - 2);
        let below = |s: &Sample, e: &Edge, plate: &Segment| -plate.line.off(s.at) > FACE * (s.at.x - e.at.x).abs();
        // Where there is other light too, a face is not told from it.
        let dark = self.crowd((0, self.profile.columns() as i32 - 1)) < CROWDED;
        let face = |s: &&Sample| dark && (below(s, a, left) || below(s, b, right));
        let (mut lit, mut last) = (0, None);
        for s in self.profile.all_between(from, to).iter().filter(|s| !face(s)) {
            lit += u32::from(last != Some(s.column));
            last = Some(s.column);
        }
        f64::from(lit) > LIT * f64::from(to - from + 1).max(4.0)
    }

    /// A robust line through the columns.
    fn plate(&mut self, from: i32, to: i32) -> Option<Segment> {
        let samples = self.profile.between(from, to);
        if samples.len() < 8 {
            return None;
        }
        let near = |s: &&Segment| s.columns.0 <= to && s.columns.1 >= from;
        let overlap = |s: &Segment| s.columns.1.min(to) - s.columns.0.max(from);
        let start = self.segments.iter().filter(near).max_by_key(|s| overlap(s)).map(|s| s.line);
        let (line, deviation) = line(samples, start, 0.3 * self.grain(), self.scratch)?;
        let ends = [samples.first()?, samples.last()?].map(|s| line.foot(s.at));
        Some(Segment { line, columns: (from, to), deviation, ends })
    }

    /// The ends of both plates at the seam.
    fn facing_ends(&mut self, left: &Segment, right: &Segment, seam: &Seam) -> Option<(Edge, Edge)> {
        if let Some(column) = seam.dark {
            let at = self.profile.samples.iter().min_by_key(|s| (f64::from(s.column) - column).abs() as i64)?;
            let y = at.at.x + (column - f64::from(at.column)) * self.pitch();
            let on = |s: &Segment| s.line.at + s.line.along * ((y - s.line.at.x) / s.line.along.x.max(1e-6));
            let edge = |s| Edge { column, at: on(s), least_gap: 0.0, hidden: false };
            return Some((edge(left), edge(right)));
        }
        // Where the plates are in line the other one's places would do as well: not beyond the middle.
        let middle = (seam.left + seam.right).div_euclid(2);
        Some((self.edge(left, middle)?, self.edge(right, middle + 1)?))
    }

    /// The place of a step, of a gap in one line, or of a dark line.
    fn seam(&self) -> Option<Seam> {
        self.step().or_else(|| self.missing()).or_else(|| self.dark())
    }

    /// A cut between segments where one line ends and another, higher or lower, begins.
    fn step(&self) -> Option<Seam> {
        let grain = self.grain();
        let height = |w: &&[Segment]| {
            let at = (w[0].ends[1] + w[1].ends[0]) / 2.0;
            mismatch(&w[0], &w[1], at, between(&w[0].line, &w[1].line)).abs()
        };
        let pair = self.segments.windows(2).max_by(|a, b| height(a).total_cmp(&height(b)))?;
        let sure = height(&pair) / (pair[0].deviation + pair[1].deviation).max(grain);
        let seam = Seam { left: pair[0].columns.1, right: pair[1].columns.0, margin: ramp(sure, 1.5, 2.5), dark: None };
        (sure > 1.5).then_some(seam)
    }

    /// The longest run of columns without the stripe, if it is clearly longer than all others.
    fn missing(&self) -> Option<Seam> {
        let grain = self.grain();
        let line = self.segments.iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
        // Plates bend a little: near the line is enough.
        let within = line.within(grain) + 3.0 * grain;
        let (mut best, mut second, mut before) = ((0, 0, 0), 0, None);
        for s in self.profile.all.iter().filter(|s| line.line.off(s.at).abs() < within.max(s.covers)) {
            if let Some(last) = before {
                let run = s.column - last - 1;
                if run > best.0 {
                    (second, best) = (best.0, (run, last, s.column));
                } else {
                    second = second.max(run);
                }
            }
            before = Some(s.column);
        }
        let (run, left, right) = best;
        let clear = f64::from(run) / (1.5 * f64::from(second) + 3.0);
        (clear > 1.0).then_some(Seam { left, right, margin: ramp(clear, 0.9, 1.3), dark: None })
    }

    /// The darkest place of the stripe, if it is clearly darker than all others.
    fn dark(&self) -> Option<Seam> {
        let samples = self.samples();
        let n = samples.len();
        if n < 4 * AROUND || samples[0].strength.is_none() {
            return None;
        }
        let mean = |i: usize, by: usize| {
            let window = &samples[i - by..=i + by];
            window.iter().filter_map(|s| s.strength).sum::<f64>() / window.len() as f64
        };
        let depth = |i: usize| 1.0 - mean(i, DARK) / mean(i, AROUND).max(1e-9);
        let places = AROUND..n - AROUND;
        let best = places.clone().max_by(|a, b| depth(*a).total_cmp(&depth(*b)))?;
        let apart = |i: &usize| i.abs_diff(best) > 5 * DARK;
        let (mut second, mut squares, mut count) = (0.0f64, 0.0, 0.0);
        for d in places.filter(apart).map(depth) {
            second = second.max(d);
            squares += d * d;
            count += 1.0;
        }
        let dip = depth(best);
        let clear = (dip / (1.5 * second)).min(dip / LEAST_DIP).min(dip / (STANDS_OUT * (squares / count).sqrt()));
        // Its centre, weighted by how dark it is.
        let (mut sum, mut moment) = (0.0, 0.0);
        let usual = mean(best, AROUND);
        for s in &samples[best - 2 * DARK..=best + 2 * DARK] {
            let weight = (usual - s.strength?).max(0.0);
            sum += weight;
            moment += weight * f64::from(s.column);
        }
        let column = moment / sum;
        let at = column.round() as i32;
        let seam = Seam { left: at - 1, right: at + 1, margin: ramp(clear, 0.9, 1.2), dark: Some(column) };
        (clear > 1.0 && sum > 0.0).then_some(seam)
    }
}
