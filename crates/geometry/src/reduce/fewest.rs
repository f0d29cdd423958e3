//! The fewest spans: bounds from both ends, then dynamic programming over what they leave open.

use super::Span;
use super::feasible::{Care, Ends, Memory};
use super::track::Track;

/// Points looked at, for every point of the path, before the search for fewer spans ends.
const EFFORT: u64 = 2000;
/// The same for a path of any length.
const LEAST_EFFORT: u64 = 100_000_000;

const UNREACHED: u32 = u32::MAX;

/// Spans, and a number that no reduction is below.
pub(super) struct Fewest {
    pub(super) spans: Vec<Span>,
    pub(super) at_least: usize,
}

/// No more than k spans go further than to entry k from the start of the track.
///
/// From every point up to the bound of one span less: how far could one more span go? Points before the bound before
/// that were asked already.
fn bounds(track: &Track, effort: u64) -> Vec<usize> {
    let mut bounds = vec![0];
    let (mut top, mut before) = (0, None);
    while top < track.end() {
        let mut far = 0;
        let mut asked = Asked::default();
        let least = before.map_or(0, |b: usize| b + 1);
        let (mut step, mut first) = (1, top);
        loop {
            if track.work() > effort {
                // Nothing that starts at the top or before goes beyond this either.
                far = track.reach(top, far.max(top + 1), Ends::Free, &mut Memory::default());
                break;
            }
            far = asked.furthest(track, first, far);
            if first == least {
                break;
            }
            // Now and then a proof for all points further back.
            if top - first >= step {
                step *= 2;
                if far < track.end()
                    && track.excluded((first - 1, far + 1), Ends::Free, Care::Full, &mut Memory::default())
                {
                    break;
                }
            }
            first -= 1;
        }
        before = Some(top);
        top = far;
        bounds.push(top);
    }
    bounds
}

/// What is known from the starts asked before.
#[derive(Default)]
struct Asked {
    runs: Memory,
    barrier: Memory,
    /// An end that the last start could not go beyond.
    most: usize,
}

impl Asked {
    /// The furthest end of a run from `first`, or `far` if none goes beyond that.
    fn furthest(&mut self, track: &Track, first: usize, far: usize) -> usize {
        let least = far.max(first + 1);
        if least == track.end() || self.excluded(track, first, least + 1) {
            return least;
        }
        if self.most > least && self.excluded(track, first, self.most + 1) {
            // Nearly the start asked before: nearly the same end.
            while self.excluded(track, first, self.most) {
                self.most -= 1;
            }
        } else {
            self.most = track.reach(first, least, Ends::FixedStart, &mut self.barrier);
        }
        track.longest(first, least, self.most, &mut self.runs).map_or(least, |span| span.last)
    }

    fn excluded(&mut self, track: &Track, first: usize, last: usize) -> bool {
        last <= track.end() && track.excluded((first, last), Ends::FixedStart, Care::Glance, &mut self.barrier)
    }
}

/// For every point the first entry of the bounds that is not below it.
fn levels(bounds: &[usize]) -> Vec<u32> {
    let mut levels = vec![0];
    for (level, pair) in bounds.windows(2).enumerate() {
        levels.resize(pair[1] + 1, level as u32 + 1);
    }
    levels
}

/// The fewest spans for a track; `back` is the same track backwards.
pub(super) fn fewest(track: &Track, back: &Track) -> Fewest {
    let mut spans = track.greedy();
    let effort = track.work() + (EFFORT * track.points.len() as u64).max(LEAST_EFFORT);
    let ahead = bounds(track, effort);
    let at_least = ahead.len() - 1;
    if spans.len() > at_least {
        let reversed = back.greedy();
        if reversed.len() < spans.len() {
            let end = track.end();
            let turn = |s: &Span| track.span(end - s.last, end - s.first, &mut Memory::default());
            spans = reversed.iter().rev().filter_map(turn).collect();
        }
    }
    if spans.len() == at_least {
        return Fewest { spans, at_least };
    }
    let mut behind = levels(&bounds(back, effort));
    behind.reverse();
    let mut search = Search {
        track,
        ahead: levels(&ahead),
        behind,
        least: vec![UNREACHED; track.points.len()],
        from: vec![0; track.points.len()],
        better_than: spans.len() as u32,
    };
    match search.run(effort + track.work()) {
        Outcome::Better => Fewest { at_least: search.least[track.end()] as usize, spans: search.spans() },
        Outcome::NoBetter => Fewest { at_least: spans.len(), spans },
        Outcome::Spent => Fewest { spans, at_least },
    }
}

enum Outcome {
    Better,
    NoBetter,
    Spent,
}

/// Dynamic programming over the points that a better reduction could use.
struct Search<'a> {
    track: &'a Track<'a>,
    /// Spans that it takes at least from the start to each point.
    ahead: Vec<u32>,
    /// And from there to the end.
    behind: Vec<u32>,
    /// Fewest spans to each point.
    least: Vec<u32>,
    /// Where the last of them starts.
    from: Vec<u32>,
    /// Only reductions with fewer spans count.
    better_than: u32,
}

impl Search<'_> {
    fn run(&mut self, effort: u64) -> Outcome {
        let end = self.track.end();
        self.least[0] = 0;
        let (mut low, mut looked, mut memory) = (0, 0, Memory::default());
        for last in 1..=end {
            if self.ahead[last] + self.behind[last] >= self.better_than {
                continue;
            }
            if self.track.work() > effort {
                return Outcome::Spent;
            }
            if last >= looked {
                low = self.lowest(low, last);
                looked = last + (last - low).div_ceil(16);
            }
            self.reach(low, last, &mut memory);
        }
        if self.least[end] < self.better_than { Outcome::Better } else { Outcome::NoBetter }
    }

    /// No run that ends at `last` or later starts before this.
    fn lowest(&self, low: usize, last: usize) -> usize {
        let mut step = 1;
        let (mut closed, mut open) = (low, last - 1);
        while open > low {
            let next = open.saturating_sub(step).max(low);
            if self.track.excluded((next, last), Ends::Free, Care::Full, &mut Memory::default()) {
                closed = next + 1;
                break;
            }
            (open, step) = (next, 2 * step);
        }
        while open > closed + (last - closed) / 16 {
            let middle = usize::midpoint(open, closed);
            if self.track.excluded((middle, last), Ends::Free, Care::Full, &mut Memory::default()) {
                closed = middle + 1;
            } else {
                open = middle;
            }
        }
        closed
    }

    /// Finds the fewest spans to `last`, trying starts of runs by what it takes to get there.
    fn reach(&mut self, low: usize, last: usize, memory: &mut Memory) {
        let most = self.better_than - self.behind[last];
        for spans in self.ahead[last]..most {
            // Where the run to the point before started will mostly do again.
            let guess = self.from[last - 1] as usize;
            let starts = (guess >= low).then_some(guess).into_iter().chain(low..last);
            for first in starts {
                if self.least[first] == spans - 1 && self.track.span(first, last, memory).is_some() {
                    (self.least[last], self.from[last]) = (spans, first as u32);
                    return;
                }
            }
        }
    }

    fn spans(&self) -> Vec<Span> {
        let (mut spans, mut last) = (Vec::new(), self.track.end());
        while last > 0 {
            let first = self.from[last] as usize;
            spans.extend(self.track.span(first, last, &mut Memory::default()));
            last = first;
        }
        spans.reverse();
        spans
    }
}
