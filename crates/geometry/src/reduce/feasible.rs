//! Spans for runs, and proofs for many runs at once that no span exists.
//!
//! An arc between two given points is one direction at the first (`run.rs`). A point near the arc restricts the
//! direction to a disc, exactly. So a run has an arc if its discs have a common direction. By Helly's theorem (1923)
//! three discs prove that they have none; the same three mostly prove it for the following runs too.

use super::measure::{Bow, Course, Fault, measure};
use super::reduction::{Shape, Span};
use super::run::{Found, Near, Run, Witness};
use super::track::{Allowance, Track};

/// Reasons of earlier refusals, tried first on the next run.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Memory {
    witness: Option<Witness>,
    axis: Option<usize>,
    /// Index at which the points of the last run turned back, if that was the reason.
    pub(super) back: Option<usize>,
}

/// Known start of the runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    FixedStart,
    /// They start here or before.
    Free,
}

/// Number of points checked for a proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Care {
    /// A few points.
    Glance,
    /// All points.
    Full,
}

impl Track<'_> {
    /// The span for the points from `first` to `last`, if there is one: the line, else the arc of least squares, else
    /// the middle one of the arcs within tolerance of all points.
    pub(super) fn span(&self, first: usize, last: usize, memory: &mut Memory) -> Option<Span> {
        memory.back = None;
        let line = |max_error| Span { first, last, shape: Shape::Line, max_error };
        if last == first + 1 {
            return Some(line(0.0));
        }
        if !self.axes_hold(first, last, Allowance { at_start: 1.0, growth: 0.0 }, &mut memory.axis) {
            return None;
        }
        let Some(run) = Run::new(self, first, last, Near::constant(self.near)) else {
            return self.standing(first, last).map(line);
        };
        if memory.witness.is_some_and(|w| run.excluded_by(&w)) {
            return None;
        }
        match measure(self, &run, &Course::Line) {
            Ok(max_error) => return Some(line(max_error)),
            Err(Fault::Back(k)) => memory.back = Some(k),
            Err(_) => {}
        }
        let tangent = match run.search() {
            Found::Direction(tangent) => tangent,
            Found::None(witness) => {
                memory.witness = Some(witness);
                return None;
            }
            Found::GivenUp => return None,
        };
        // Closer ends do not distinguish a short arc from nearly a full turn.
        let bow = Bow::new(&run, tangent).filter(|_| run.length > self.near)?;
        match measure(self, &run, &Course::Arc(bow)) {
            Ok(max_error) => {
                let normal = if run.flipped { -bow.normal } else { bow.normal };
                let centre = run.origin + bow.radius * bow.inward;
                Some(Span { first, last, shape: Shape::Arc { centre, radius: bow.radius, normal }, max_error })
            }
            Err(fault) => {
                if let Fault::Back(k) = fault {
                    memory.back = Some(k);
                }
                None
            }
        }
    }

    /// Maximum distance from the common start and end of a run, if all its points are within tolerance of it.
    fn standing(&self, first: usize, last: usize) -> Option<f64> {
        self.add_work(last - first);
        let away = |k: usize| self.points[k].distance(self.points[first]);
        let mut greatest = 0.0f64;
        for k in first..last {
            greatest = greatest.max(away(k));
            if greatest > self.near {
                return None;
            }
        }
        Some(greatest)
    }

    /// True if it is proven that no run has a span that starts at `first` (or before, if free) and ends at `last` or
    /// later.
    ///
    /// Suppose such a span passes the points at `first` and `last` at a and m, at most the tolerance T away. The piece
    /// from a to m, moved, turned and scaled so that its ends come to the two points, moves no point x by more than `T
    /// |x - a| / |m - a|` if a stays, else by `T (1 + z^2)^(1/2)` with z the distance of x from the middle of a and m
    /// in units of half of theirs. So there must be an arc between the two points within T and that. Points that turn
    /// back over an end are within 3 T of it and left out.
    ///
    /// With [`Care::Glance`] only a few points are checked, or many of a short run: the proof remains valid.
    pub(super) fn excluded(&self, first: usize, last: usize, ends: Ends, care: Care, memory: &mut Memory) -> bool {
        let allowance = match ends {
            Ends::Free => Allowance { at_start: 2.0, growth: 0.0 },
            Ends::FixedStart => Allowance { at_start: 1.0, growth: 1.0 },
        };
        if last < first + 2 {
            return false;
        }
        if !self.axes_hold(first, last, allowance, &mut memory.axis) {
            return true;
        }
        let length = self.points[first].distance(self.points[last]);
        if length < 6.0 * self.near {
            return false;
        }
        let between = length - 2.0 * self.near;
        let near = match ends {
            Ends::FixedStart => {
                Near { at_start: self.near, growth: length / between, end: 3.0 * self.near, start: 0.0 }
            }
            Ends::Free => {
                let z = (self.widest(first, last) + 2.0 * self.near) / (0.5 * between);
                let near = self.near * (1.0 + z.hypot(1.0));
                Near { at_start: near, growth: 0.0, end: 3.0 * self.near, start: 3.0 * self.near }
            }
        };
        let Some(run) = Run::new(self, first, last, near) else { return false };
        if memory.witness.is_some_and(|w| run.excluded_by(&w)) {
            return true;
        }
        let found = match care {
            Care::Glance => run.sample(),
            Care::Full => run.search_any(),
        };
        let Found::None(witness) = found else { return false };
        memory.witness = Some(witness);
        true
    }

    /// Maximum distance of a run's points from the middle between its ends.
    fn widest(&self, first: usize, last: usize) -> f64 {
        let middle = self.points[first].midpoint(self.points[last]);
        self.add_work(last - first);
        self.points[first..=last].iter().map(|p| p.distance_squared(middle)).fold(0.0, f64::max).sqrt()
    }

    /// An upper bound of the end of runs from `first` (or before), at least `least`: found by doubling, then bisection,
    /// over ends proven excluded.
    pub(super) fn reach(&self, first: usize, least: usize, ends: Ends, memory: &mut Memory) -> usize {
        let (mut open, mut next) = (least, least + 1);
        let mut closed = loop {
            if open == self.end() {
                return open;
            }
            next = next.min(self.end());
            if self.excluded(first, next, ends, Care::Full, memory) {
                break next;
            }
            (open, next) = (next, next + (next - first));
        };
        while closed - open > 1 + (closed - first) / 128 {
            let middle = usize::midpoint(open, closed);
            if self.excluded(first, middle, ends, Care::Full, memory) { closed = middle } else { open = middle }
        }
        closed - 1
    }

    /// The longest run from `first` that ends beyond `least` and at most at `most`: every end is tried, from the last
    /// one down.
    pub(super) fn longest(&self, first: usize, least: usize, most: usize, memory: &mut Memory) -> Option<Span> {
        let (mut last, mut turned) = (most, None);
        while last > least {
            if let Some(span) = self.span(first, last, memory) {
                return Some(span);
            }
            last -= 1;
            if let Some(back) = memory.back.filter(|back| turned != Some(*back) && *back > first) {
                // Runs from a point where the track turns back are short.
                turned = Some(back);
                last = last.min(self.reach(back, back + 1, Ends::Free, &mut Memory::default()));
            }
        }
        None
    }

    /// Takes the longest run from each kept point.
    pub(super) fn greedy(&self) -> Vec<Span> {
        let (mut spans, mut first) = (Vec::new(), 0);
        while first < self.end() {
            let most = self.reach(first, first + 1, Ends::FixedStart, &mut Memory::default());
            let Some(span) = self.longest(first, first, most, &mut Memory::default()) else { break };
            first = span.last;
            spans.push(span);
        }
        spans
    }
}
