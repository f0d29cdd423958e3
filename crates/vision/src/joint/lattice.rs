use super::make_room;
use super::strip::{COLS, Columns, GROUP, Line, MID, Strip, greater, greatest, lesser};
use crate::aligned::Aligned;
use crate::simd::{Work, wide};
use pulp::Simd;

/// Cost of a step to the next column, nats.
const MOVE: f32 = 2.5;
/// Maximum evidence of one row for a joint, nats: a scratch does not outweigh many rows ...
const MAX_EVIDENCE: f32 = 3.0;
/// ... and the minimum: an object may lie on the joint.
const MIN_EVIDENCE: f32 = -1.0;
/// A line nearly this many times as deep as the joint is something else. (Two crossing joints are twice as deep.)
const TOO_DEEP: f32 = 3.5;
/// Score of unreachable places.
const NEVER: f32 = -1e6;

/// Columns of a strip in which a joint is searched. Others have no depth, except for the narrowest joints.
const FROM: usize = 8;
const SPAN: usize = COLS - 2 * FROM;
/// One value per searched column.
type Span = Aligned<SPAN>;

/// Paths across the rows of a strip, one column per row, with their scores. A score is the log likelihood ratio with
/// and without a joint, less the cost of the moves, nats.
#[derive(Debug, Clone, Default)]
pub(super) struct Lattice {
    evidence: Vec<Span>,
    forward: Vec<Span>,
}

impl Lattice {
    /// Reserves capacity for this many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        for spans in [&mut self.evidence, &mut self.forward] {
            make_room(spans, rows);
        }
    }

    pub(super) fn evidence(&self, row: usize, column: usize) -> f32 {
        self.evidence[row][column - FROM]
    }

    /// Finds the best path across a strip and returns its score. `contrast`: the joint's depth in each row; `cost`: the
    /// cost of each start column, nats.
    pub(super) fn best(
        &mut self,
        strip: &Strip,
        contrast: impl Fn(usize) -> f32,
        cost: impl Fn(usize) -> f32,
        path: &mut Vec<usize>,
    ) -> f32 {
        const MIDDLE: usize = MID - FROM;
        self.go_forward(strip, contrast, Span::from_fn(|j| -cost(j + FROM)));
        path.clear();
        path.resize(self.forward.len(), MID);
        let Some(last) = self.forward.last() else { return NEVER };
        // Of equal ends the one nearest to the axis wins.
        let mut at = (0..SPAN).fold(MIDDLE, |at, j| {
            let nearer = j.abs_diff(MIDDLE) < at.abs_diff(MIDDLE);
            if last[j] > last[at] || (last[j] >= last[at] && nearer) { j } else { at }
        });
        let score = last[at];
        for (i, (place, row)) in path.iter_mut().zip(&self.forward).enumerate().rev() {
            if i + 1 < self.forward.len() {
                let here = row[at];
                if at > 0 && row[at - 1] - MOVE > here && row[at - 1] >= row[(at + 1).min(SPAN - 1)] {
                    at -= 1;
                } else if at + 1 < SPAN && row[at + 1] - MOVE > here {
                    at += 1;
                }
            }
            *place = at + FROM;
        }
        score
    }

    /// Computes the margin of each row: the score above the best path more than `away` columns from `path[i]` in row i,
    /// nats.
    pub(super) fn margins(&self, path: &[usize], away: usize, margins: &mut Vec<f32>) {
        margins.clear();
        margins.resize(path.len(), 0.0);
        wide(Margins { lattice: self, path, away, margins });
    }

    fn go_forward(&mut self, strip: &Strip, contrast: impl Fn(usize) -> f32, begin: Span) {
        let rows = strip.depth.len();
        self.evidence.resize(rows, Span::default());
        self.forward.resize(rows, Span::default());
        let Columns { first, last } = strip.columns;
        let columns = Columns { first: first.max(FROM) - FROM, last: last.min(FROM + SPAN - 1) - FROM };
        // Groups of rows overlap; the division counts each row once.
        let rows_counted = (2 * GROUP + 1) as f32;
        let least = 1.0 / (rows_counted * strip.noise * strip.noise);
        let Self { evidence, forward } = self;
        wide(Forward { depth: &strip.depth, evidence, forward, contrast, columns, least, begin });
    }
}

/// Forward pass: evidence of each place by its depth, and the best score to reach it from the start scores `begin`.
/// (Each row waits for the one before; the evidence is computed meanwhile.)
struct Forward<'a, C> {
    depth: &'a [Line],
    evidence: &'a mut [Span],
    forward: &'a mut [Span],
    contrast: C,
    columns: Columns,
    least: f32,
    begin: Span,
}

impl<C: Fn(usize) -> f32> Work for Forward<'_, C> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let mut ways = Ways::begin(self.begin);
        let rows = self.depth.iter().zip(self.evidence).zip(self.forward);
        for (i, ((depth, evidence), forward)) in rows.enumerate() {
            weigh(evidence, depth, (self.contrast)(i), self.columns, self.least);
            *forward = ways.go_on(evidence);
        }
    }
}

/// Computes the evidence of a row's places for a joint of this depth.
#[inline(always)]
fn weigh(evidence: &mut Span, depth: &Line, contrast: f32, columns: Columns, least: f32) {
    // The factor limits the evidence at the joint's own depth to the maximum.
    let part = least.min(2.0 * MAX_EVIDENCE / (contrast * contrast));
    for (evidence, depth) in evidence.iter_mut().zip(&depth[FROM..FROM + SPAN]) {
        let depth = lesser(*depth, TOO_DEEP * contrast - depth);
        *evidence = (contrast * (depth - 0.5 * contrast) * part).clamp(MIN_EVIDENCE, MAX_EVIDENCE);
    }
    evidence[..columns.first].fill(NEVER);
    evidence[columns.last + 1..].fill(NEVER);
}

/// See [`Lattice::margins`].
struct Margins<'a> {
    lattice: &'a Lattice,
    path: &'a [usize],
    away: usize,
    margins: &'a mut [f32],
}

impl Work for Margins<'_> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let Lattice { forward, evidence } = self.lattice;
        let mut ways = Ways::begin(Span::default());
        let rows = self.margins.iter_mut().zip(forward).zip(evidence).zip(self.path);
        for (((margin, forward), evidence), at) in rows.rev() {
            let backward = ways.go_on(evidence);
            let mut through = Span::from_fn(|j| forward[j] + backward[j] - evidence[j]);
            let near = (at - FROM).saturating_sub(self.away)..=(at - FROM + self.away).min(SPAN - 1);
            let mut best = NEVER;
            for through in &mut through[near] {
                best = greater(best, *through);
                *through = NEVER;
            }
            *margin = best - greatest(&through);
        }
    }
}

/// Scores of the best paths to each place of a row, between two unreachable columns, so that borders need no special
/// case.
struct Ways {
    scores: [f32; SPAN + 2],
    /// Before the first row: the scores are those of the start columns.
    at_begin: bool,
}

impl Ways {
    #[inline(always)]
    fn begin(begin: Span) -> Self {
        let mut scores = [f32::MIN; SPAN + 2];
        scores[1..=SPAN].copy_from_slice(&*begin);
        Self { scores, at_begin: true }
    }

    /// Advances to the next row and returns its scores.
    #[inline(always)]
    fn go_on(&mut self, evidence: &Span) -> Span {
        let Self { scores, at_begin } = self;
        let next = if std::mem::replace(at_begin, false) {
            Span::from_fn(|j| scores[j + 1] + evidence[j])
        } else {
            Span::from_fn(|j| arrive(scores[j], scores[j + 1], scores[j + 2]) + evidence[j])
        };
        scores[1..=SPAN].copy_from_slice(&*next);
        next
    }
}

/// Returns the best score that reaches a place from the columns to the left, below and to the right.
#[inline(always)]
fn arrive(left: f32, here: f32, right: f32) -> f32 {
    greater(here, greater(left, right) - MOVE)
}

/// Returns the mean column of a path over the rows within `reach` of row `i`.
pub(super) fn column_about(path: &[usize], i: usize, reach: usize) -> f32 {
    let near = &path[i.saturating_sub(reach)..(i + reach + 1).min(path.len())];
    near.iter().sum::<usize>() as f32 / near.len() as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// Best score by exhaustive dynamic programming, over all paths in allowed columns of one row.
    fn best_through(evidence: &[[f64; SPAN]], cost: &[f64; SPAN], row: usize, columns: &dyn Fn(usize) -> bool) -> f64 {
        let allowed = |i: usize, j: usize| i != row || columns(j);
        let mut scores: Vec<f64> =
            (0..SPAN).map(|j| if allowed(0, j) { evidence[0][j] - cost[j] } else { -1e9 }).collect();
        for (i, evidence) in evidence.iter().enumerate().skip(1) {
            let from = |j: usize, k: usize| scores[k] - if k == j { 0.0 } else { f64::from(MOVE) };
            let best = |j: usize| (j.saturating_sub(1)..SPAN.min(j + 2)).map(|k| from(j, k)).fold(f64::MIN, f64::max);
            scores = (0..SPAN).map(|j| if allowed(i, j) { best(j) + evidence[j] } else { -1e9 }).collect();
        }
        scores.into_iter().fold(f64::MIN, f64::max)
    }

    #[test]
    fn the_best_path_and_its_margins_are_those_of_all_paths() {
        let mut random = Random::new(7);
        let mut lattice = Lattice::default();
        for _ in 0..60 {
            let rows = 1 + random.below(20);
            let contrast: Vec<f32> = (0..rows).map(|_| random.within(10.0, 30.0) as f32).collect();
            let depth: Vec<Line> = (0..rows).map(|_| Line::from_fn(|_| random.within(-8.0, 22.0) as f32)).collect();
            let strip = Strip {
                depth,
                noise: random.within(2.0, 3.0) as f32,
                columns: Columns { first: 9, last: COLS - 10 },
                ..Strip::default()
            };
            let costs = Span::from_fn(|_| random.within(0.0, 3.0) as f32);
            let mut path = Vec::new();
            let score = lattice.best(&strip, |i| contrast[i], |j| costs[j - FROM], &mut path);
            let evidence = |i: usize, j: usize| {
                let (contrast, depth) = (f64::from(contrast[i]), f64::from(strip.depth[i][j + FROM]));
                let depth = depth.min(f64::from(TOO_DEEP) * contrast - depth);
                let variance = 9.0 * f64::from(strip.noise).powi(2);
                let part = (1.0 / variance).min(2.0 * f64::from(MAX_EVIDENCE) / contrast.powi(2));
                let told = (contrast * (depth - 0.5 * contrast) * part)
                    .clamp(f64::from(MIN_EVIDENCE), f64::from(MAX_EVIDENCE));
                if (9..COLS - 9).contains(&(j + FROM)) { told } else { f64::from(NEVER) }
            };
            let all: Vec<[f64; SPAN]> = (0..rows).map(|i| std::array::from_fn(|j| evidence(i, j))).collect();
            let cost: [f64; SPAN] = (*costs).map(f64::from);
            let best = best_through(&all, &cost, 0, &|_| true);
            assert!((f64::from(score) - best).abs() < 1e-3, "{score} {best}");
            // The path has this score.
            let moves = path.windows(2).map(|pair| pair[0].abs_diff(pair[1]));
            assert!(moves.clone().all(|step| step <= 1), "{path:?}");
            let moved = f64::from(MOVE) * moves.sum::<usize>() as f64;
            let along: f64 = path.iter().enumerate().map(|(i, j)| all[i][j - FROM]).sum();
            assert!((along - cost[path[0] - FROM] - moved - best).abs() < 1e-3, "{path:?}");
            let mut margins = Vec::new();
            lattice.margins(&path, 2, &mut margins);
            for (i, margin) in margins.iter().enumerate() {
                let here = best_through(&all, &cost, i, &|j| j.abs_diff(path[i] - FROM) <= 2);
                let elsewhere = best_through(&all, &cost, i, &|j| j.abs_diff(path[i] - FROM) > 2);
                // Scores of unreachable places are coarse numbers.
                let told = here - elsewhere;
                assert!((f64::from(*margin) - told).abs() < 1e-3 || told > 1e5, "{margin} {told}");
            }
        }
    }
}
