use super::margin::Judgement;
use super::placement::{Placement, ReachGrid};

/// Placements judged at once in the grid: enough to keep every core busy.
const BATCH: usize = 64;
/// Number of cells from which the local search starts.
const STARTS: usize = 3;
/// Step at which the local search ends, as a part of the first one; tried on the examples, where a finer one gained less
/// than 0.001 of the range.
const FINEST: f64 = 1.0 / 64.0;
/// Maximum number of rounds of a local search.
const MAX_ROUNDS: usize = 60;
/// Minimum gain of a round.
const GAIN: f64 = 1e-6;

/// A placement with its judgement.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The placement.
    pub placement: Placement,
    /// The cells of the grid, if it is one of them.
    pub cell: Option<[usize; 4]>,
    /// The judgement.
    pub judgement: Judgement,
}

/// Everything judged by a search, in the order of judging: first the present placement, then the grid, then the local
/// search.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SearchResult {
    /// The placements.
    pub judged: Vec<Judged>,
    /// True if the search was not stopped.
    pub is_complete: bool,
}

impl SearchResult {
    /// The placements from the best to the worst, each once; those of equal rank in the order of judging.
    pub fn ranked(&self) -> Vec<&Judged> {
        let mut ranked: Vec<&Judged> = self.judged.iter().collect();
        ranked.sort_by(|a, b| b.judgement.score().total_cmp(&a.judgement.score()));
        ranked
    }

    /// The present placement.
    pub fn present(&self) -> Option<&Judged> {
        self.judged.first()
    }

    fn known(&self, placement: &Placement) -> Option<&Judged> {
        self.judged.iter().find(|judged| judged.placement == *placement)
    }

    /// Judges `placements`. Returns false if the judge stopped the search.
    fn add(&mut self, placements: Vec<(Placement, Option<[usize; 4]>)>, judge: &mut JudgeAll) -> bool {
        let only: Vec<Placement> = placements.iter().map(|(placement, _)| *placement).collect();
        let judgements = judge(&only);
        let complete = judgements.len() == placements.len() && judgements.iter().all(Option::is_some);
        for ((placement, cell), judgement) in placements.into_iter().zip(judgements) {
            self.judged.extend(judgement.map(|judgement| Judged { placement, cell, judgement }));
        }
        complete
    }
}

/// Judges several placements, with an entry for each; none for one that was not judged because the search is to stop.
type JudgeAll<'a> = dyn FnMut(&[Placement]) -> Vec<Option<Judgement>> + 'a;

/// Searches `grid`, then locally from its best cells. `judge` may judge the placements of a call at the same time; the
/// result does not depend on it.
pub fn search(grid: &ReachGrid, judge: &mut JudgeAll) -> SearchResult {
    let mut result = SearchResult::default();
    result.is_complete = result.add(vec![(Placement::default(), None)], judge)
        && search_grid(grid, &mut result, judge)
        && search_locally(grid, &mut result, judge);
    result
}

fn search_grid(grid: &ReachGrid, result: &mut SearchResult, judge: &mut JudgeAll) -> bool {
    let present = result.judged.clone();
    grid.order().chunks(BATCH).all(|cells| {
        let mut placements = Vec::with_capacity(cells.len());
        for &at in cells {
            let (placement, cell) = (grid.placement(at), Some(at));
            match present.iter().find(|judged| judged.placement == placement) {
                Some(known) => result.judged.push(Judged { cell, ..known.clone() }),
                None => placements.push((placement, cell)),
            }
        }
        result.add(placements, judge)
    })
}

/// Compass searches from the best placements so far.
fn search_locally(grid: &ReachGrid, result: &mut SearchResult, judge: &mut JudgeAll) -> bool {
    let inside = |p: &Placement| {
        let ends = grid.spans.iter().map(super::placement::ReachSpan::ends);
        p.coordinates().iter().zip(ends).all(|(v, (from, to))| (from..=to).contains(v))
    };
    let mut starts: Vec<Start> = Vec::new();
    for judged in result.ranked().into_iter().filter(|judged| inside(&judged.placement)) {
        if starts.len() == STARTS {
            break;
        }
        if starts.iter().all(|start| start.at != judged.placement) {
            starts.push(Start { at: judged.placement, score: judged.judgement.score() });
        }
    }
    starts.into_iter().all(|start| climb(grid, start, result, judge))
}

/// A placement from which a local search starts, with its rank.
#[derive(Clone, Copy)]
struct Start {
    at: Placement,
    score: f64,
}

/// A compass search. Placements that an earlier one has judged are not judged again.
fn climb(grid: &ReachGrid, start: Start, result: &mut SearchResult, judge: &mut JudgeAll) -> bool {
    let mut best = start;
    let mut part = 0.5;
    for _ in 0..MAX_ROUNDS {
        if part < FINEST {
            break;
        }
        let around = neighbours(grid, &best.at, part);
        let new = around.iter().filter(|p| result.known(p).is_none()).map(|p| (*p, None)).collect();
        if !result.add(new, judge) {
            return false;
        }
        // The first of several that are equally good.
        let ranks = around.iter().filter_map(|p| result.known(p));
        let ranks = ranks.map(|judged| Start { at: judged.placement, score: judged.judgement.score() });
        let next = ranks.reduce(|best, other| if other.score > best.score { other } else { best });
        match next.filter(|next| next.score > best.score + GAIN) {
            Some(next) => best = next,
            None => part *= 0.5,
        }
    }
    true
}

/// Placements one step, `part` of a cell, to each side along each coordinate, within the ranges.
fn neighbours(grid: &ReachGrid, at: &Placement, part: f64) -> Vec<Placement> {
    let mut around = Vec::new();
    for (i, span) in grid.spans.iter().enumerate() {
        let (from, to) = span.ends();
        for sense in [-1.0, 1.0] {
            let mut moved = at.coordinates();
            moved[i] = (moved[i] + sense * part * span.step()).clamp(from, to);
            if (moved[i] - at.coordinates()[i]).abs() > 0.0 {
                around.push(Placement::of(moved));
            }
        }
    }
    around
}
