use super::make_room;
use super::strip::{COLS, GROUP, Line, MID, Strip, greater, greatest, lesser};
use crate::wide::{Work, wide};

/// What a step to the next column costs, nats.
const MOVE: f32 = 2.5;
/// One row tells at most this much for a joint, nats: a scratch does not outweigh many rows ...
const MOST: f32 = 3.0;
/// ... and this much against it: something may lie on it.
const LEAST: f32 = -1.0;
/// What is nearly so many times as deep as the joint is something else. (Where two cross it is twice as deep.)
const TOO_DEEP: f32 = 3.5;
/// Out of reach.
const NEVER: f32 = -1e6;

/// The columns of a strip in which a joint is looked for: there is a depth in no other, but for the narrowest joints.
const FROM: usize = 8;
const SPAN: usize = COLS - 2 * FROM;
/// One value for each of them.
type Span = [f32; SPAN];

/// Paths across the rows of a strip, one column a row, and how likely they are: the logarithm of the ratio of
/// likelihoods with a joint and without one, less what their moves cost.
#[derive(Debug, Clone, Default)]
pub(super) struct Lattice {
    evidence: Vec<Span>,
    forward: Vec<Span>,
    backward: Vec<Span>,
}

impl Lattice {
    /// Room for so many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        for spans in [&mut self.evidence, &mut self.forward, &mut self.backward] {
            make_room(spans, rows);
        }
    }

    /// Evidence of each place for a joint of this depth in each row.
    pub(super) fn weigh(&mut self, strip: &Strip, contrast: impl Fn(usize) -> f32) {
        self.evidence.resize(strip.depth.len(), [0.0; SPAN]);
        let (first, last) = strip.columns;
        // Groups overlap: each row counts once.
        let rows_counted = (2 * GROUP + 1) as f32;
        let (first, last) = (first.max(FROM) - FROM, last.min(FROM + SPAN - 1) - FROM);
        let rows = self.evidence.iter_mut().zip(&strip.depth);
        wide(Weigh { rows, contrast, columns: (first, last), least: 1.0 / (rows_counted * strip.noise * strip.noise) });
    }

    /// The evidence of a row for a joint in a column.
    pub(super) fn evidence(&self, row: usize, column: usize) -> f32 {
        self.evidence[row][column - FROM]
    }

    /// The best path and its score. `cost` of beginning in a column.
    pub(super) fn best(&mut self, cost: impl Fn(usize) -> f32, path: &mut Vec<usize>) -> f32 {
        const MIDDLE: usize = MID - FROM;
        self.go_forward(|j| cost(j + FROM));
        path.clear();
        path.resize(self.forward.len(), MID);
        let Some(last) = self.forward.last() else { return NEVER };
        // Of equal ends the one nearest to the axis.
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

    /// How much worse the best path is that keeps away from column `path[i]` by more than `away` in row i, nats.
    pub(super) fn margins(&mut self, path: &[usize], away: usize, margins: &mut Vec<f32>) {
        self.go_backward();
        margins.clear();
        margins.resize(path.len(), 0.0);
        wide(Margins { lattice: self, path, away, margins });
    }

    fn go_forward(&mut self, cost: impl Fn(usize) -> f32) {
        let begin: Span = std::array::from_fn(|j| -cost(j));
        self.forward.resize(self.evidence.len(), [0.0; SPAN]);
        wide(Go { ways: self.evidence.iter().zip(&mut self.forward), begin });
    }

    fn go_backward(&mut self) {
        self.backward.resize(self.evidence.len(), [0.0; SPAN]);
        wide(Go { ways: self.evidence.iter().zip(&mut self.backward).rev(), begin: [0.0; SPAN] });
    }
}

/// Evidence of each place of each row by its depth; see [`Lattice::weigh`].
struct Weigh<R, C> {
    rows: R,
    contrast: C,
    columns: (usize, usize),
    least: f32,
}

impl<'a, R: Iterator<Item = (&'a mut Span, &'a Line)>, C: Fn(usize) -> f32> Work for Weigh<R, C> {
    #[inline(always)]
    fn run(self) {
        let (first, last) = self.columns;
        for (i, (row, depth)) in self.rows.enumerate() {
            let contrast = (self.contrast)(i);
            // At the joint's own depth the evidence is no more than the most: it peaks there.
            let part = self.least.min(2.0 * MOST / (contrast * contrast));
            for (evidence, depth) in row.iter_mut().zip(&depth[FROM..FROM + SPAN]) {
                let depth = lesser(*depth, TOO_DEEP * contrast - depth);
                *evidence = (contrast * (depth - 0.5 * contrast) * part).clamp(LEAST, MOST);
            }
            row[..first].fill(NEVER);
            row[last + 1..].fill(NEVER);
        }
    }
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
    fn run(self) {
        let Lattice { forward, backward, evidence } = self.lattice;
        let rows = forward.iter().zip(backward).zip(evidence).zip(self.path);
        for (margin, (((forward, backward), evidence), at)) in self.margins.iter_mut().zip(rows) {
            let mut through: Span = std::array::from_fn(|j| forward[j] + backward[j] - evidence[j]);
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

/// The best way to each place of row after row, from the score `begin` of each way to begin.
struct Go<W> {
    ways: W,
    begin: Span,
}

impl<'a, W: Iterator<Item = (&'a Span, &'a mut Span)>> Work for Go<W> {
    #[inline(always)]
    fn run(self) {
        // Between two columns out of reach: none of the others is a case of its own.
        let mut score = [f32::MIN; SPAN + 2];
        for (i, (evidence, way)) in self.ways.enumerate() {
            let next: Span = if i == 0 {
                std::array::from_fn(|j| self.begin[j] + evidence[j])
            } else {
                std::array::from_fn(|j| arrive(score[j], score[j + 1], score[j + 2]) + evidence[j])
            };
            score[1..=SPAN].copy_from_slice(&next);
            *way = next;
        }
    }
}

/// The best that leads to a place from the columns to the left, below and to the right.
#[inline(always)]
fn arrive(left: f32, here: f32, right: f32) -> f32 {
    greater(here, greater(left, right) - MOVE)
}

/// The mean column of a path over the rows within `reach` of row `i`.
pub(super) fn column_about(path: &[usize], i: usize, reach: usize) -> f32 {
    let near = &path[i.saturating_sub(reach)..(i + reach + 1).min(path.len())];
    near.iter().sum::<usize>() as f32 / near.len() as f32
}
