//! Two plates end to end.

use super::cover::Part;
use super::groove::mismatch;
use super::{Edge, Support, View, between, ramp, turn};
use crate::stripe::edges::Usual;
use crate::stripe::fit::line;
use crate::stripe::light::Course;
use crate::stripe::profile::Sample;
use crate::stripe::{Feature, Features, NoFeatures, Quantity, Segment};

/// Widest gap of a butt joint in columns.
const WIDEST: f64 = 120.0;

/// Columns of the window that tells the usual strength about a dark line, and half the width of such a line.
const AROUND: usize = 40;
const DARK: usize = 2;

/// Part of a gap's columns in which something may be seen below the plates.
const LIT: f64 = 0.4;

/// Least slope of the face of a plate's end: the wall of a groove is less steep.
const FACE: f64 = 8.0;

/// Part of the columns with other light than the stripe's for no, and for full confidence in a dark line.
const CROWD: [f64; 2] = [0.25, 0.18];

/// Part of the columns that each plate must have for no, and for full confidence.
const PLATE: [f64; 2] = [0.08, 0.15];

/// Most angle between the plates, rad, for no, and for full confidence.
const BEND: [f64; 2] = [0.2, 0.12];

/// Evidence that another line must bring to be a second plate.
const A_LINE: f64 = 20.0;

/// Columns beside a seam that are looked at for something else, and most of them that may have it.
const ABOUT: i32 = 12;
const HIDING: usize = 5;

/// Columns to each side of a step, and the part of them that must be on one line alone for no, and for full confidence.
const BESIDE_STEP: usize = 16;
const SHARP: [f64; 2] = [0.35, 0.6];

/// Columns beyond an end that show that it is one.
const TAIL: i32 = 6;

/// Least depth of a dark line, part of the strength, and in deviations of the strength along the stripe.
const LEAST_DIP: f64 = 0.25;
const STANDS_OUT: f64 = 6.0;

/// Where the seam of a butt joint is: last column of the left plate and first one of the right, and how sure it is.
struct Seam {
    left: i32,
    right: i32,
    lines: [Segment; 2],
    margin: f64,
    /// Whether something else is seen there.
    hidden: bool,
    /// A dark line only.
    dark: Option<f64>,
}

impl View<'_> {
    /// Two plates in line with a gap, a mismatch or a dark line between them.
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
        // A step that the plates themselves do not show was something else's.
        let none = seam.dark.is_none() && gap <= 0.0 && step.abs() < 1.5 * self.grain();
        let bend = turn(&left.line, &right.line);
        let apart = gap / self.pitch();
        if step.abs() > self.task.least_step || bend.abs() > BEND[0] || apart > WIDEST || none {
            return Err(NoFeatures::NoSeam);
        }
        let shorter = f64::from((seam.left - first).min(last - seam.right)) / f64::from(last - first + 1);
        let hidden =
            seam.hidden || a.hidden || b.hidden || (seam.dark.is_none() && self.lit_gap((&a, &left), (&b, &right)));
        // Of a small step the other plate's light would be in the strip.
        let high = step.abs() > super::APART * self.profile.row;
        let dark_after = if high { [Some(1); 2] } else { [None; 2] };
        let parts = [
            Part {
                course: Course::Line(left.line),
                columns: (first, seam.left - 1),
                dark_after: [None, dark_after[1]],
            },
            Part {
                course: Course::Line(right.line),
                columns: (seam.right + 1, last),
                dark_after: [dark_after[0], None],
            },
        ];
        let cover = if hidden { 0.0 } else { self.cover(&parts) };
        let margin = seam.margin
            * cover
            * ramp(shorter, PLATE[0], PLATE[1])
            * ramp(bend.abs(), BEND[0], BEND[1])
            * ramp(step.abs() / self.task.least_step, 1.0, 0.85);
        let values = [(Quantity::Gap, gap), (Quantity::Mismatch, step), (Quantity::Bend, bend)];
        let points = [(Feature::Joint, joint), (Feature::LeftEdge, a.at), (Feature::RightEdge, b.at)];
        let support = Support { share: 1.0, segments: &[left, right], margin, covered: true };
        Ok(self.features(&points, &values, &support))
    }

    /// A gap in one line, or a place where one line ends and another, higher or lower, begins: where the light says so best.
    fn open_seam(&mut self) -> Option<Seam> {
        let mut evidence = std::mem::take(self.evidence);
        let seam = self.best_open_seam(&mut evidence);
        *self.evidence = evidence;
        seam
    }

    /// The same with room for the evidence of two lines.
    fn best_open_seam(&mut self, [on_main, on_second]: &mut [Vec<f64>; 2]) -> Option<Seam> {
        let lengths = self.lengths();
        let longest = (0..lengths.len()).max_by(|a, b| lengths[*a].total_cmp(&lengths[*b]))?;
        let main = self.segments[longest];
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
                if let Some((sum, a, b)) = seam
                    && best.as_ref().is_none_or(|((most, _, _), _)| sum - A_LINE > *most)
                {
                    best = Some(((sum - A_LINE, a, b), lines));
                }
            }
        }
        let ((_, left, right), lines) = best?;
        let of = |line: &Segment| if *line == main { &*on_main } else { &*on_second };
        let hidden = Self::else_about(of(&lines[0]), of(&lines[1]), (left, right));
        let margin = if lines[0] == lines[1] {
            let run = f64::from(right - left - 1);
            let second = longest_dark(&on_main[..=left as usize]).max(longest_dark(&on_main[right as usize..]));
            let clear = run / (1.5 * f64::from(second) + 3.0);
            if clear <= 1.0 {
                return None;
            }
            ramp(clear, 0.9, 1.3)
        } else {
            let (a, b) = (of(&lines[0]), of(&lines[1]));
            ramp(sharpness(a, b, left as usize, right as usize), SHARP[0], SHARP[1])
        };
        Some(Seam { left, right, lines, margin, hidden, dark: None })
    }

    /// Whether something else is seen in some columns about a seam.
    fn else_about(left: &[f64], right: &[f64], (a, b): (i32, i32)) -> bool {
        let unknown = |e: &[f64], from: i32, to: i32| {
            let (from, to) = (from.max(0) as usize, (to.max(0) as usize).min(e.len()));
            e.get(from..to).map_or(0, |e| e.iter().filter(|v| v.abs() < 1e-9).count())
        };
        let within = unknown(left, a + 1, b).max(unknown(right, a + 1, b));
        unknown(left, a + 1 - ABOUT, a + 1) + within + unknown(right, b, b + ABOUT) > HIDING
    }

    /// For every column of the profile, how much its light says that the stripe is on this line.
    fn gather_evidence(&mut self, s: &Segment, evidence: &mut Vec<f64>) -> Option<()> {
        let course = Course::Line(s.line);
        self.look_along(&course, s.columns);
        let usual = Usual::of(self.strip, self.scratch)?;
        self.look_along(&course, (0, self.profile.columns() as i32 - 1));
        evidence.clear();
        evidence.extend(self.strip.iter().map(|v| usual.evidence(*v)));
        Some(())
    }

    /// Whether anything but the faces of the ends is seen in a good part of the gap's columns: something that hides that
    /// it is none, or a groove.
    fn lit_gap(&self, (a, left): (&Edge, &Segment), (b, right): (&Edge, &Segment)) -> bool {
        let (from, to) = (a.column.ceil() as i32 + 2, b.column.floor() as i32 - 2);
        let below = |s: &Sample, e: &Edge, plate: &Segment| -plate.line.off(s.at) > FACE * (s.at.x - e.at.x).abs();
        let face = |s: &&Sample| below(s, a, left) || below(s, b, right);
        let under = |s: &&Sample| left.line.off(s.at).max(right.line.off(s.at)) < 0.0;
        let (mut lit, mut last) = (0, None);
        for s in self.profile.all_between(from, to).iter().filter(|s| under(s) && !face(s)) {
            lit += u32::from(last != Some(s.column));
            last = Some(s.column);
        }
        f64::from(lit) > LIT * f64::from(to - from + 1).max(4.0)
    }

    /// A robust line through the columns.
    fn plate(&mut self, from: i32, to: i32, start: &Segment) -> Option<Segment> {
        let samples = self.profile.between(from, to);
        if samples.len() < 8 {
            return None;
        }
        let (line, deviation) = line(samples, Some(start.line), 0.3 * self.grain(), self.scratch)?;
        let ends = [samples.first()?, samples.last()?].map(|s| line.foot(s.at));
        Some(Segment { line, columns: (from, to), deviation, ends })
    }

    /// The ends of both plates at the seam.
    fn facing_ends(&mut self, left: &Segment, right: &Segment, seam: &Seam) -> Option<(Edge, Edge)> {
        if let Some(column) = seam.dark {
            let at = self.profile.samples.iter().min_by_key(|s| (f64::from(s.column) - column).abs() as i64)?;
            let y = at.at.x + (column - f64::from(at.column)) * self.pitch();
            let on = |s: &Segment| s.line.at + s.line.along * ((y - s.line.at.x) / s.line.along.x.max(1e-6));
            let edge = |s| Edge { column, at: on(s), dark: 0.0, least_gap: 0.0, hidden: false };
            return Some((edge(left), edge(right)));
        }
        // The other plate's light is no tail of this one's.
        let place = (left.line.at + right.line.at) / 2.0;
        let high =
            mismatch(left, right, place, between(&left.line, &right.line)).abs() > super::APART * self.profile.row;
        let (to_left, to_right) =
            if high { (seam.left + TAIL, seam.right - TAIL) } else { (seam.right - 1, seam.left + 1) };
        Some((self.end_at(left, seam.left, to_left)?, self.end_at(right, seam.right, to_right)?))
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
        if clear <= 1.0 || sum <= 0.0 {
            return None;
        }
        let main = *self.segments.iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
        let crowd = self.crowd((0, self.profile.columns() as i32 - 1));
        let margin = ramp(clear, 0.9, 1.2) * ramp(crowd, CROWD[0], CROWD[1]);
        Some(Seam { left: at - 1, right: at + 1, lines: [main; 2], margin, hidden: false, dark: Some(column) })
    }
}

/// The last column on the left line and the first one on the right line for which the evidence for both is best, with its
/// sum; `after` is scratch.
fn best_seam(left: &[f64], right: &[f64], after: &mut Vec<f64>) -> Option<(f64, i32, i32)> {
    // Best sum of the right line from any later column on.
    let n = left.len().min(right.len());
    after.clear();
    after.resize(n + 1, 0.0);
    let mut sum = 0.0;
    for i in (0..n).rev() {
        sum += right[i];
        after[i] = after[i + 1].max(sum);
    }
    let (mut sum, mut best) = (0.0, None::<(f64, usize)>);
    for i in 0..n {
        sum += left[i];
        if after[i + 1] > 0.0 && best.is_none_or(|(most, _)| sum + after[i + 1] > most) {
            best = Some((sum + after[i + 1], i));
        }
    }
    let (most, last) = best?;
    // The best sum begins where it gets less to the right.
    let first = (last + 1..n).find(|i| after[*i] > after[*i + 1])?;
    Some((most, last as i32, first as i32))
}

/// Least part of the columns beside a step in which there is light on one line and not on the other.
fn sharpness(left: &[f64], right: &[f64], a: usize, b: usize) -> f64 {
    let before = left[..=a].iter().zip(right).rev().take(BESIDE_STEP).map(|(l, r)| *l > 0.0 && *r <= 0.0);
    let after = right[b..].iter().zip(&left[b..]).take(BESIDE_STEP).map(|(r, l)| *r > 0.0 && *l <= 0.0);
    let part = |sharp: &mut dyn Iterator<Item = bool>| sharp.filter(|s| *s).count() as f64 / BESIDE_STEP as f64;
    part(&mut { before }).min(part(&mut { after }))
}

/// The longest run of columns that speak against the line.
fn longest_dark(evidence: &[f64]) -> i32 {
    let (mut run, mut longest) = (0, 0);
    for e in evidence {
        run = if *e < 0.0 { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Evidence of `count` columns, -2 to 2.
    fn chance(seed: u64, count: usize) -> Vec<f64> {
        let one = |i: u64| {
            let hash = (seed * 1000 + i + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let hash = (hash ^ (hash >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            (hash >> 40) as f64 / f64::from(1 << 22) - 2.0
        };
        (0..count as u64).map(one).collect()
    }

    #[test]
    fn the_best_seam_is_that_of_brute_force() {
        for seed in 0..2000 {
            let count = 2 + seed as usize % 25;
            let (left, right) = (chance(2 * seed, count), chance(2 * seed + 1, count));
            let sum = |a: usize, b: usize| left[..=a].iter().sum::<f64>() + right[b..].iter().sum::<f64>();
            // Of the right line something must be left.
            let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
            let some = pairs.filter(|(_, b)| right[*b..].iter().sum::<f64>() > 0.0);
            let best = some.map(|(a, b)| sum(a, b)).fold(f64::NEG_INFINITY, f64::max);
            match best_seam(&left, &right, &mut Vec::new()) {
                None => assert!(best.is_infinite(), "seed {seed}"),
                Some((most, a, b)) => {
                    assert!((most - best).abs() < 1e-9 && (sum(a as usize, b as usize) - best).abs() < 1e-9, "{seed}");
                }
            }
        }
    }

    #[test]
    fn a_gap_in_one_line_is_the_seam() {
        for (from, to) in [(10, 12), (30, 60), (1, 98)] {
            let mut on = [1.0; 100];
            on[from..to].fill(-1.0);
            let (sum, left, right) = best_seam(&on, &on, &mut Vec::new()).unwrap();
            assert_eq!((left, right), (from as i32 - 1, to as i32));
            assert!((sum - (100 - (to - from)) as f64).abs() < 1e-12);
            assert_eq!(longest_dark(&on), (to - from) as i32);
        }
        assert_eq!(longest_dark(&[]), 0);
    }

    #[test]
    fn a_step_is_as_sharp_as_its_duller_side() {
        // Lit on the left line up to column 49 and on the right line from column 50 on; on both in some columns.
        let line = |on: &dyn Fn(usize) -> bool| (0..100).map(|i| if on(i) { 1.0 } else { -1.0 }).collect::<Vec<f64>>();
        for both in 0..=BESIDE_STEP {
            let left = line(&|i| i < 50);
            let right = line(&|i| i >= 50 || i % BESIDE_STEP < both);
            let wanted = 1.0 - both as f64 / BESIDE_STEP as f64;
            assert!((sharpness(&left, &right, 49, 50) - wanted).abs() < 1e-12, "{both}");
            // The other way round the left line goes on.
            let (left, right) = (line(&|i| i < 50 || i % BESIDE_STEP < both), line(&|i| i >= 50));
            assert!((sharpness(&left, &right, 49, 50) - wanted).abs() < 1e-12, "{both}");
        }
    }
}
