//! The fewest spans: bounds from both ends, then dynamic programming over the remaining points.

use super::feasible::{Care, Ends, Memory};
use super::reduction::Span;
use super::track::Track;

/// Limit of the search for fewer spans: points checked per point of the path.
const EFFORT: u64 = 2000;
/// Minimum of that limit for a short path, in points checked.
const MIN_EFFORT: u64 = 100_000_000;

const UNREACHED: u32 = u32::MAX;

/// Spans, and a lower bound of their number.
pub(super) struct Fewest {
    pub(super) spans: Vec<Span>,
    pub(super) at_least: usize,
}

/// Bounds of the reach: k spans from the start of the track end at entry k at the latest.
///
/// Entry k is the furthest end of a span from any point up to entry k - 1. Points up to entry k - 2 are already done.
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
                // This also bounds every run that starts at `top` or before.
                far = track.reach(top, far.max(top + 1), Ends::Free, &mut Memory::default());
                break;
            }
            far = asked.furthest(track, first, far);
            if first == least {
                break;
            }
            // Tries at times a proof for all points further back.
            if top - first >= step {
                step *= 2;
                if far < track.end()
                    && track.excluded(first - 1, far + 1, Ends::Free, Care::Full, &mut Memory::default())
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

/// Results of the earlier starts.
#[derive(Default)]
struct Asked {
    runs: Memory,
    barrier: Memory,
    /// Upper bound of the end from the last start.
    most: usize,
}

impl Asked {
    /// The furthest end of a run from `first`, at least `far`.
    fn furthest(&mut self, track: &Track, first: usize, far: usize) -> usize {
        let least = far.max(first + 1);
        if least == track.end() || self.excluded(track, first, least + 1) {
            return least;
        }
        if self.most > least && self.excluded(track, first, self.most + 1) {
            // The start is close to the last one: so is the end.
            while self.excluded(track, first, self.most) {
                self.most -= 1;
            }
        } else {
            self.most = track.reach(first, least, Ends::FixedStart, &mut self.barrier);
        }
        track.longest(first, least, self.most, &mut self.runs).map_or(least, |span| span.last)
    }

    fn excluded(&mut self, track: &Track, first: usize, last: usize) -> bool {
        last <= track.end() && track.excluded(first, last, Ends::FixedStart, Care::Glance, &mut self.barrier)
    }
}

/// For every point the index of the first bound that reaches it.
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
    let effort = track.work() + (EFFORT * track.points.len() as u64).max(MIN_EFFORT);
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

/// Dynamic programming over the points of a possible better reduction.
struct Search<'a> {
    track: &'a Track<'a>,
    /// Minimum number of spans from the start to each point.
    ahead: Vec<u32>,
    /// Minimum number of spans from each point to the end.
    behind: Vec<u32>,
    /// Fewest spans found to each point.
    least: Vec<u32>,
    /// Start of the last of these spans.
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

    /// Lower bound of the start of runs that end at `last` or later.
    fn lowest(&self, low: usize, last: usize) -> usize {
        let mut step = 1;
        let (mut closed, mut open) = (low, last - 1);
        while open > low {
            let next = open.saturating_sub(step).max(low);
            if self.track.excluded(next, last, Ends::Free, Care::Full, &mut Memory::default()) {
                closed = next + 1;
                break;
            }
            (open, step) = (next, 2 * step);
        }
        while open > closed + (last - closed) / 16 {
            let middle = usize::midpoint(open, closed);
            if self.track.excluded(middle, last, Ends::Free, Care::Full, &mut Memory::default()) {
                closed = middle + 1;
            } else {
                open = middle;
            }
        }
        closed
    }

    /// Finds the fewest spans to `last`, trying starts of runs by the number of spans to them.
    fn reach(&mut self, low: usize, last: usize, memory: &mut Memory) {
        let most = self.better_than - self.behind[last];
        for spans in self.ahead[last]..most {
            // The start of the run to the point before is mostly valid again.
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
