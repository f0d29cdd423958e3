//! Butt joints: two plates end to end.

mod evidence;

use self::evidence::{Gap, UNKNOWN, best_seam, expected_runs, longest_dark, sharpness};
use super::completeness::Part;
use super::groove::mismatch;
use super::{Edge, Support, View, between, ramp, turn};
use crate::stripe::edges::Usual;
use crate::stripe::features::{Feature, Features, NoFeatures, Quantity};
use crate::stripe::fit::line;
use crate::stripe::light::Course;
use crate::stripe::profile::{Columns, Sample};
use crate::stripe::segments::Segment;

/// Maximum gap of a butt joint, columns.
const WIDEST: f64 = 120.0;

/// Half the window for the usual strength about a dark line, and half the width of such a line, columns.
const AROUND: usize = 40;
const DARK: usize = 2;

/// Maximum part of a gap's columns with points below the plates.
const LIT: f64 = 0.4;

/// Minimum slope of the face of a plate's end; the wall of a groove is less steep.
const FACE: f64 = 8.0;

/// Part of the columns with other light than the stripe's, for no and for full confidence in a dark line.
const CROWD: [f64; 2] = [0.25, 0.18];

/// Part of the columns on each plate for no and for full confidence.
const PLATE: [f64; 2] = [0.08, 0.15];

/// Angle between the plates, rad, for no and for full confidence.
const BEND: [f64; 2] = [0.2, 0.12];

/// Additional evidence required for a second line.
const A_LINE: f64 = 20.0;

/// Columns beside a seam searched for another object, and the maximum number with one.
const ABOUT: i32 = 12;
const HIDING: usize = 5;

/// Part of the columns beside a step on one line alone, for no and for full confidence.
const SHARP: [f64; 2] = [0.35, 0.6];

/// Expected number of random dark runs as long as the gap, for no and for full confidence in it, powers of ten.
const CHANCE: [f64; 2] = [-4.0, -5.0];

/// Columns beyond an end that confirm it.
const TAIL: i32 = 6;

/// Minimum depth of a dark line, as a part of the strength, and in deviations of the strength along the stripe.
const MIN_DIP: f64 = 0.25;
const STANDS_OUT: f64 = 6.0;

/// Seam of a butt joint: the last column of the left plate, the first one of the right, and their lines.
struct Seam {
    left: i32,
    right: i32,
    lines: [Segment; 2],
    margin: f64,
    /// True if another object is seen there.
    hidden: bool,
    /// Column of a seam that is a dark line only.
    dark: Option<f64>,
}

impl View<'_> {
    /// Detects two plates in line with a gap, a mismatch or a dark line between them.
    pub(super) fn butt(&mut self) -> Result<Features, NoFeatures> {
        let seam = self.open_seam().or_else(|| self.dark()).ok_or(NoFeatures::NoSeam)?;
        let (first, last) = (0, self.profile.columns() as i32 - 1);
        let left = self.plate(first, seam.left, &seam.lines[0]).ok_or(NoFeatures::NoSeam)?;
        let right = self.plate(seam.right, last, &seam.lines[1]).ok_or(NoFeatures::NoSeam)?;
        let along = between(&left.line, &right.line);
        let (a, b) = self.facing_ends(&left, &right, &seam).ok_or(NoFeatures::NoSeam)?;
        let joint = (a.at + b.at) / 2.0;
        let open = f64::from(seam.right - seam.left - 1) >= a.least_gap.max(b.least_gap);
        let gap = if seam.dark.is_none() && open { (b.at - a.at).dot(along).max(0.0) } else { 0.0 };
        let step = mismatch(&left, &right, joint, along);
        // Without a step between the plates' own lines, the step belonged to another line.
        let none = seam.dark.is_none() && gap <= 0.0 && step.abs() < 1.5 * self.grain();
        let bend = turn(&left.line, &right.line);
        let apart = gap / self.pitch();
        if step.abs() > self.task.least_step || bend.abs() > BEND[0] || apart > WIDEST || none {
            return Err(NoFeatures::NoSeam);
        }
        let shorter = f64::from((seam.left - first).min(last - seam.right)) / f64::from(last - first + 1);
        let hidden =
            seam.hidden || a.hidden || b.hidden || (seam.dark.is_none() && self.lit_gap([&a, &b], [&left, &right]));
        // At a small step the other plate's light would be in the strip.
        let high = step.abs() > super::APART * self.profile.row;
        let dark_after = if high { [Some(1); 2] } else { [None; 2] };
        let parts = [
            Part {
                course: Course::Line(left.line),
                columns: Columns { from: first, to: seam.left - 1 },
                dark_after: [None, dark_after[1]],
            },
            Part {
                course: Course::Line(right.line),
                columns: Columns { from: seam.right + 1, to: last },
                dark_after: [dark_after[0], None],
            },
        ];
        let cover = if hidden { 0.0 } else { self.cover(&parts) };
        let margin = seam.margin
            * ramp(shorter, PLATE[0], PLATE[1])
            * ramp(bend.abs(), BEND[0], BEND[1])
            * ramp(step.abs() / self.task.least_step, 1.0, 0.85);
        let values = [(Quantity::Gap, gap), (Quantity::Mismatch, step), (Quantity::Bend, bend)];
        let points = [(Feature::Joint, joint), (Feature::LeftEdge, a.at), (Feature::RightEdge, b.at)];
        let support = Support { share: 1.0, segments: &[left, right], margin, cover, covered: true };
        Ok(self.features(&points, &values, &support))
    }

    /// Finds the best evidence for a gap in one line, or for the change from one line to a higher or lower one.
    fn open_seam(&mut self) -> Option<Seam> {
        let mut evidence = std::mem::take(self.evidence);
        let seam = self.best_open_seam(&mut evidence);
        *self.evidence = evidence;
        seam
    }

    /// Does the same with buffers for the evidence of two lines.
    fn best_open_seam(&mut self, [on_main, on_second]: &mut [Vec<f64>; 2]) -> Option<Seam> {
        let lengths = self.lengths();
        let main = self.segments[(0..lengths.len()).max_by(|a, b| lengths[*a].total_cmp(&lengths[*b]))?];
        let least = 1.5 * self.grain();
        let other = |s: &&Segment| {
            let off = s.ends.map(|e| main.line.off(e).abs());
            turn(&main.line, &s.line).abs() < BEND[0]
                && off[0].min(off[1]) < 2.0 * self.task.least_step
                && off[0].max(off[1]) > least
        };
        let second = self.segments.iter().filter(other).max_by(|a, b| a.length().total_cmp(&b.length())).copied();
        self.gather_evidence(&main, on_main)?;
        on_second.clear();
        let mut best = best_seam(on_main, on_main, self.scratch).map(|s| (s, [main; 2]));
        if let Some(second) = second {
            self.gather_evidence(&second, on_second)?;
            for (lines, left, right) in
                [([main, second], &*on_main, &*on_second), ([second, main], &*on_second, &*on_main)]
            {
                let seam = best_seam(left, right, self.scratch);
                if let Some((sum, gap)) = seam
                    && best.as_ref().is_none_or(|((most, _), _)| sum - A_LINE > *most)
                {
                    best = Some(((sum - A_LINE, gap), lines));
                }
            }
        }
        let ((_, gap), lines) = best?;
        let Gap { left, right } = gap;
        let of = |line: &Segment| if *line == main { &*on_main } else { &*on_second };
        let hidden = Self::else_about(of(&lines[0]), of(&lines[1]), gap);
        let margin = if lines[0] == lines[1] {
            let run = f64::from(right - left - 1);
            let second = longest_dark(&on_main[..=left as usize]).max(longest_dark(&on_main[right as usize..]));
            let clear = run / (1.5 * f64::from(second) + 3.0);
            let chance = expected_runs(on_main, gap).log10();
            if clear <= 1.0 || chance >= CHANCE[0] {
                return None;
            }
            ramp(clear, 0.9, 1.3) * ramp(chance, CHANCE[0], CHANCE[1])
        } else {
            let (a, b) = (of(&lines[0]), of(&lines[1]));
            ramp(sharpness(a, b, left as usize, right as usize), SHARP[0], SHARP[1])
        };
        Some(Seam { left, right, lines, margin, hidden, dark: None })
    }

    /// Returns true if another object is seen in some columns about a seam.
    fn else_about(left: &[f64], right: &[f64], gap: Gap) -> bool {
        let Gap { left: a, right: b } = gap;
        let unknown = |e: &[f64], from: i32, to: i32| {
            let (from, to) = (from.max(0) as usize, (to.max(0) as usize).min(e.len()));
            e.get(from..to).map_or(0, |e| e.iter().filter(|v| v.abs() <= UNKNOWN).count())
        };
        let within = unknown(left, a + 1, b).max(unknown(right, a + 1, b));
        unknown(left, a + 1 - ABOUT, a + 1) + within + unknown(right, b, b + ABOUT) > HIDING
    }

    /// Computes the evidence of every column of the profile for this line.
    fn gather_evidence(&mut self, s: &Segment, evidence: &mut Vec<f64>) -> Option<()> {
        let course = Course::Line(s.line);
        self.look_along(&course, s.columns);
        let usual = Usual::of(self.strip, self.scratch)?;
        self.look_along(&course, Columns { from: 0, to: self.profile.columns() as i32 - 1 });
        evidence.clear();
        evidence.extend(self.strip.iter().map(|v| usual.evidence(*v)));
        Some(())
    }

    /// Returns true if points other than the faces of the plates' ends are seen in many of the gap's columns: an object
    /// in the gap, or a groove.
    fn lit_gap(&self, ends: [&Edge; 2], plates: [&Segment; 2]) -> bool {
        let ([a, b], [left, right]) = (ends, plates);
        let (from, to) = (a.column.ceil() as i32 + 2, b.column.floor() as i32 - 2);
        let below = |s: &Sample, e: &Edge, plate: &Segment| -plate.line.off(s.at) > FACE * (s.at.x - e.at.x).abs();
        let face = |s: &&Sample| below(s, a, left) || below(s, b, right);
        let under = |s: &&Sample| left.line.off(s.at).max(right.line.off(s.at)) < 0.0;
        let (mut lit, mut last) = (0, None);
        for s in self.profile.all_between(Columns { from, to }).iter().filter(|s| under(s) && !face(s)) {
            lit += u32::from(last != Some(s.column));
            last = Some(s.column);
        }
        f64::from(lit) > LIT * f64::from(to - from + 1).max(4.0)
    }

    /// Fits a robust line through the columns.
    fn plate(&mut self, from: i32, to: i32, start: &Segment) -> Option<Segment> {
        let columns = Columns { from, to };
        let samples = self.profile.between(columns);
        if samples.len() < 8 {
            return None;
        }
        let (line, deviation) = line(samples, Some(start.line), 0.3 * self.grain(), self.scratch)?;
        let ends = [samples.first()?, samples.last()?].map(|s| line.foot(s.at));
        Some(Segment { line, columns, deviation, ends })
    }

    /// Returns the ends of both plates at the seam.
    fn facing_ends(&mut self, left: &Segment, right: &Segment, seam: &Seam) -> Option<(Edge, Edge)> {
        if let Some(column) = seam.dark {
            let at = self.profile.samples.iter().min_by_key(|s| (f64::from(s.column) - column).abs() as i64)?;
            let y = at.at.x + (column - f64::from(at.column)) * self.pitch();
            let on = |s: &Segment| s.line.at + s.line.along * ((y - s.line.at.x) / s.line.along.x.max(1e-6));
            let edge = |s| Edge { column, at: on(s), dark: 0.0, least_gap: 0.0, hidden: false };
            return Some((edge(left), edge(right)));
        }
        // The other plate's light must not extend this one's.
        let place = (left.line.at + right.line.at) / 2.0;
        let high =
            mismatch(left, right, place, between(&left.line, &right.line)).abs() > super::APART * self.profile.row;
        let (to_left, to_right) =
            if high { (seam.left + TAIL, seam.right - TAIL) } else { (seam.right - 1, seam.left + 1) };
        Some((self.end_at(left, seam.left, to_left)?, self.end_at(right, seam.right, to_right)?))
    }

    /// Returns the darkest point of the stripe, if it is clearly darker than all others.
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
        let clear = (dip / (1.5 * second)).min(dip / MIN_DIP).min(dip / (STANDS_OUT * (squares / count).sqrt()));
        // Centre weighted by darkness.
        let (mut sum, mut moment) = (0.0, 0.0);
        let usual = mean(best, AROUND);
        for s in &samples[best - 2 * DARK..=best + 2 * DARK] {
            let weight = (usual - s.strength?).max(0.0);
            sum += weight;
            moment += weight * f64::from(s.column);
        }
        let column = moment / sum;
        let at = column.round() as i32;
        if clear <= 1.0 || sum <= 0.0 {
            return None;
        }
        let main = *self.segments.iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
        let crowd = self.crowd(Columns { from: 0, to: self.profile.columns() as i32 - 1 });
        let margin = ramp(clear, 0.9, 1.2) * ramp(crowd, CROWD[0], CROWD[1]);
        Some(Seam { left: at - 1, right: at + 1, lines: [main; 2], margin, hidden: false, dark: Some(column) })
    }
}
