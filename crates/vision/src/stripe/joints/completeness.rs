//! Completeness of a detected joint: lit from end to end, and dark beyond its ends.
//!
//! Reflections are as bright as the stripe, so shape alone is no proof. But a reflection is short, and its ends differ
//! from those of a joint's parts. A false joint made of one has dark columns on its parts, or light beyond their ends.

use super::{View, ramp};
use crate::stripe::edges::{LIT, Usual};
use crate::stripe::light::Course;
use crate::stripe::profile::Columns;

/// Columns beyond an end that must be dark, and the lit part of them for no and for full confidence.
const BEYOND: i32 = 10;
const LIT_BEYOND: [f64; 2] = [0.7, 0.4];

/// Part of the columns beyond an end not hidden by another object, for no and for full confidence.
const KNOWN: [f64; 2] = [0.4, 0.7];

/// Columns before an end, and the part of them lit by the stripe alone, for no and for full confidence.
const BEFORE: i32 = 24;
const LIT_BEFORE: [f64; 2] = [0.25, 0.45];

/// Part of the columns with a point but with the joint outside the image, for no and for full confidence.
const ELSEWHERE: [f64; 2] = [0.25, 0.15];

/// Consecutive dark columns on a part for no and for full confidence, in units of [`Usual::least_gap`].
const HOLE: [f64; 2] = [3.5, 2.2];

pub(super) struct Part {
    pub(super) course: Course,
    pub(super) columns: Columns,
    /// Distance beyond its first and last column from which it must be dark, columns; `None` if it may continue there.
    pub(super) dark_after: [Option<i32>; 2],
}

impl View<'_> {
    /// Returns the confidence, 0 to 1, that the parts are complete and end as they should.
    pub(super) fn cover(&mut self, parts: &[Part]) -> f64 {
        let longest = parts.iter().max_by_key(|p| p.columns.to - p.columns.from);
        let Some(longest) = longest else { return 0.0 };
        self.look_along(&longest.course, longest.columns);
        let Some(usual) = Usual::of(self.strip, self.scratch) else { return 0.0 };
        let hole = usual.least_gap();
        let (mut sure, mut elsewhere): (f64, usize) = (1.0, 0);
        for part in parts.iter().filter(|p| p.columns.to > p.columns.from) {
            let Columns { from, to } = part.columns;
            let (run, out) = self.dark_and_out(part, &usual);
            elsewhere += out;
            sure *= ramp(run, HOLE[0] * hole, HOLE[1] * hole);
            let [before, after] = part.dark_after;
            for (end, step, skip) in [(from, -1, before), (to, 1, after)] {
                let Some(skip) = skip else { continue };
                sure *= self.lit_before(part, end, step, &usual);
                self.look_along(&part.course, Columns { from: end + step * skip, to: end + step * (skip + BEYOND) });
                let seen = || self.strip.iter().filter(|v| v.is_finite());
                let lit = seen().filter(|v| **v > LIT * usual.light).count() as f64;
                let known = seen().count() as f64;
                let out = self.strip.iter().filter(|v| v.is_nan()).count() as f64;
                sure *= ramp(lit / known.max(1.0), LIT_BEYOND[0], LIT_BEYOND[1]);
                sure *= ramp((known + out) / self.strip.len().max(1) as f64, KNOWN[0], KNOWN[1]);
            }
        }
        sure * ramp(elsewhere as f64 / self.samples().len() as f64, ELSEWHERE[0], ELSEWHERE[1])
    }

    /// Returns the confidence, 0 to 1, that a part is lit before one of its ends and not hidden.
    fn lit_before(&mut self, part: &Part, end: i32, step: i32, usual: &Usual) -> f64 {
        let length = part.columns.to - part.columns.from;
        self.look_along(&part.course, Columns { from: end, to: end - step * BEFORE.min(length) });
        let lit = self.strip.iter().filter(|v| v.is_finite() && **v > LIT * usual.light).count() as f64;
        let out = self.strip.iter().filter(|v| v.is_nan()).count();
        ramp(lit / (self.strip.len() - out).max(1) as f64, LIT_BEFORE[0], LIT_BEFORE[1])
    }

    /// Returns the longest run of dark columns on a part, and the number of points in columns where it is outside the
    /// image.
    fn dark_and_out(&mut self, part: &Part, usual: &Usual) -> (f64, usize) {
        self.look_along(&part.course, part.columns);
        let (mut run, mut longest) = (0, 0);
        for light in self.strip.iter().filter(|v| v.is_finite()) {
            run = if *light > LIT * usual.light { 0 } else { run + 1 };
            longest = longest.max(run);
        }
        let out = |c: i32| self.strip.get(c.abs_diff(part.columns.from) as usize).is_some_and(|v| v.is_nan());
        (f64::from(longest), self.profile.between(part.columns).iter().filter(|s| out(s.column)).count())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stripe::features::{JointKind, StripeTask};
    use crate::stripe::fit::StripeLine;
    use crate::stripe::profile::Profile;
    use glam::DVec2;

    /// Cover of `columns` on a level line of points, without the columns for which `missing` is true.
    fn cover(missing: impl Fn(i32) -> bool, columns: Columns, dark_after: [Option<i32>; 2]) -> f64 {
        let points: Vec<DVec2> = (0..400).filter(|c| !missing(*c)).map(|c| DVec2::new(f64::from(c), 5.0)).collect();
        let mut profile = Profile::default();
        profile.set_points(&points);
        let task = StripeTask::in_mm(JointKind::Butt);
        let (strip, evidence, scratch) = (&mut Vec::new(), &mut [Vec::new(), Vec::new()], &mut Vec::new());
        let mut view = View { profile: &profile, segments: &[], task: &task, light: None, strip, evidence, scratch };
        let line = StripeLine { at: DVec2::new(0.0, 5.0), along: DVec2::X };
        view.cover(&[Part { course: Course::Line(line), columns, dark_after }])
    }

    #[test]
    fn dark_runs_on_a_part_take_its_cover() {
        // In runs of three or more dark columns, the next is as likely dark as not. So a gap has ln(e^5) / ln 2
        // columns.
        let gap = 5.0 / 2f64.ln();
        for run in 3..40 {
            let wanted = ((HOLE[0] * gap - f64::from(run)) / ((HOLE[0] - HOLE[1]) * gap)).clamp(0.0, 1.0);
            let found = cover(|c| (150..150 + run).contains(&c), Columns { from: 0, to: 399 }, [None; 2]);
            assert!((found - wanted).abs() < 1e-9, "{run}: {found} {wanted}");
        }
        // The same number of separate dark columns does not matter.
        assert!((cover(|c| c % 10 == 5, Columns { from: 0, to: 399 }, [None; 2]) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_part_is_dark_beyond_its_ends() {
        for beyond in 0..=BEYOND + 4 {
            // The line continues for this many columns beyond column 200, or 100 on the other side.
            let on = f64::from(beyond.min(BEYOND + 1)) / f64::from(BEYOND + 1);
            let wanted = ((LIT_BEYOND[0] - on) / (LIT_BEYOND[0] - LIT_BEYOND[1])).clamp(0.0, 1.0);
            let gone = |c: i32| (201 + beyond..300).contains(&c);
            let found = cover(gone, Columns { from: 0, to: 200 }, [None, Some(1)]);
            assert!((found - wanted).abs() < 1e-9, "{beyond}: {found} {wanted}");
            let gone = |c: i32| (30..100 - beyond).contains(&c);
            let found = cover(gone, Columns { from: 100, to: 399 }, [Some(1), None]);
            assert!((found - wanted).abs() < 1e-9, "before, {beyond}: {found} {wanted}");
            // Ends that may continue are not checked.
            assert!((cover(gone, Columns { from: 100, to: 399 }, [None; 2]) - 1.0).abs() < 1e-9);
        }
    }
}
