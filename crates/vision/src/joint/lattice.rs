use super::make_room;
use super::strip::{COLS, GROUP, MID, Strip, greater, greatest, lesser};

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
        let rows = (2 * GROUP + 1) as f32;
        let (first, last) = (first.max(FROM) - FROM, last.min(FROM + SPAN - 1) - FROM);
        for (i, (row, depth)) in self.evidence.iter_mut().zip(&strip.depth).enumerate() {
            let contrast = contrast(i);
            // At the joint's own depth the evidence is no more than the most: it peaks there.
            let part = (1.0 / (rows * strip.noise * strip.noise)).min(2.0 * MOST / (contrast * contrast));
            for (evidence, depth) in row.iter_mut().zip(&depth[FROM..FROM + SPAN]) {
                let depth = lesser(*depth, TOO_DEEP * contrast - depth);
                *evidence = (contrast * (depth - 0.5 * contrast) * part).clamp(LEAST, MOST);
            }
            row[..first].fill(NEVER);
            row[last + 1..].fill(NEVER);
        }
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
        let rows = self.forward.iter().zip(&self.backward).zip(&self.evidence);
        margins.extend(rows.zip(path).map(|(((forward, backward), evidence), at)| {
            let mut through = [0.0; SPAN];
            let ways = forward.iter().zip(backward).zip(evidence);
            through.iter_mut().zip(ways).for_each(|(through, ((f, b), e))| *through = f + b - e);
            let near = &mut through[(at - FROM).saturating_sub(away)..=(at - FROM + away).min(SPAN - 1)];
            let best = near.iter().copied().fold(NEVER, greater);
            near.fill(NEVER);
            best - greatest(&through)
        }));
    }

    fn go_forward(&mut self, cost: impl Fn(usize) -> f32) {
        let begin: Span = std::array::from_fn(|j| -cost(j));
        self.forward.resize(self.evidence.len(), [0.0; SPAN]);
        go(self.evidence.iter().zip(&mut self.forward), begin);
    }

    fn go_backward(&mut self) {
        self.backward.resize(self.evidence.len(), [0.0; SPAN]);
        go(self.evidence.iter().zip(&mut self.backward).rev(), [0.0; SPAN]);
    }
}

/// The best way to each place of row after row, from the score `begin` of each way to begin.
fn go<'a>(ways: impl Iterator<Item = (&'a Span, &'a mut Span)>, begin: Span) {
    // Between two columns out of reach: none of the others is a case of its own.
    let mut score = [f32::MIN; SPAN + 2];
    for (i, (evidence, way)) in ways.enumerate() {
        let next: Span = if i == 0 {
            std::array::from_fn(|j| begin[j] + evidence[j])
        } else {
            std::array::from_fn(|j| arrive(score[j], score[j + 1], score[j + 2]) + evidence[j])
        };
        score[1..=SPAN].copy_from_slice(&next);
        *way = next;
    }
}

/// The best that leads to a place from the columns to the left, below and to the right.
fn arrive(left: f32, here: f32, right: f32) -> f32 {
    greater(here, greater(left, right) - MOVE)
}

/// The mean column of a path over the rows within `reach` of row `i`.
pub(super) fn column_about(path: &[usize], i: usize, reach: usize) -> f32 {
    let near = &path[i.saturating_sub(reach)..(i + reach + 1).min(path.len())];
    near.iter().sum::<usize>() as f32 / near.len() as f32
}
