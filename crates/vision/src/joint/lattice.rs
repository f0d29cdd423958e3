use super::strip::{COLS, GROUP, Line, MID, Strip};

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

/// Paths across the rows of a strip, one column a row, and how likely they are: the logarithm of the ratio of
/// likelihoods with a joint and without one, less what their moves cost.
#[derive(Debug, Clone, Default)]
pub(super) struct Lattice {
    pub(super) evidence: Vec<Line>,
    forward: Vec<Line>,
    backward: Vec<Line>,
}

impl Lattice {
    /// Evidence of each place for a joint of this depth in each row.
    pub(super) fn weigh(&mut self, strip: &Strip, contrast: impl Fn(usize) -> f32) {
        let (first, last) = strip.columns;
        // Groups overlap: each row counts once.
        let rows = (2 * GROUP + 1) as f32;
        self.evidence.clear();
        for (i, depth) in strip.depth.iter().enumerate() {
            let contrast = contrast(i);
            // At the joint's own depth the evidence is no more than the most: it peaks there.
            let part = (1.0 / (rows * strip.noise * strip.noise)).min(2.0 * MOST / (contrast * contrast));
            let mut row = depth.map(|depth| {
                let depth = depth.min(TOO_DEEP * contrast - depth);
                (contrast * (depth - 0.5 * contrast) * part).clamp(LEAST, MOST)
            });
            row[..first].fill(NEVER);
            row[last + 1..].fill(NEVER);
            self.evidence.push(row);
        }
    }

    /// The best path and its score. `cost` of beginning in a column.
    pub(super) fn best(&mut self, cost: impl Fn(usize) -> f32, path: &mut Vec<usize>) -> f32 {
        self.go_forward(cost);
        path.clear();
        path.resize(self.forward.len(), MID);
        let mut at = MID;
        for (i, place) in path.iter_mut().enumerate().rev() {
            let row = &self.forward[i];
            if i + 1 == self.forward.len() {
                // Of equal ends the one nearest to the axis.
                at = (0..COLS).fold(MID, |at, j| {
                    let nearer = j.abs_diff(MID) < at.abs_diff(MID);
                    if row[j] > row[at] || (row[j] >= row[at] && nearer) { j } else { at }
                });
            } else {
                let here = row[at];
                if at > 0 && row[at - 1] - MOVE > here && row[at - 1] >= row[(at + 1).min(COLS - 1)] {
                    at -= 1;
                } else if at + 1 < COLS && row[at + 1] - MOVE > here {
                    at += 1;
                }
            }
            *place = at;
        }
        self.forward.last().map_or(NEVER, |last| path.last().map_or(NEVER, |at| last[*at]))
    }

    /// How much worse the best path is that keeps away from column `path[i]` by more than `away` in row i, nats.
    pub(super) fn margins(&mut self, path: &[usize], away: usize, margins: &mut Vec<f32>) {
        self.go_backward();
        margins.clear();
        let rows = self.forward.iter().zip(&self.backward).zip(&self.evidence);
        margins.extend(rows.zip(path).map(|(((forward, backward), evidence), at)| {
            let through = |j: usize| forward[j] + backward[j] - evidence[j];
            let (low, high) = (at.saturating_sub(away), (at + away).min(COLS - 1));
            let best = (low..=high).map(through).fold(NEVER, f32::max);
            let rival = (0..low).chain(high + 1..COLS).map(through).fold(NEVER, f32::max);
            best - rival
        }));
    }

    fn go_forward(&mut self, cost: impl Fn(usize) -> f32) {
        self.forward.clear();
        let mut score = [0.0; COLS];
        for (j, score) in score.iter_mut().enumerate() {
            *score = -cost(j);
        }
        for (i, evidence) in self.evidence.iter().enumerate() {
            if i > 0 {
                score = arrive(&score);
            }
            score.iter_mut().zip(evidence).for_each(|(s, e)| *s += e);
            self.forward.push(score);
        }
    }

    fn go_backward(&mut self) {
        self.backward.clear();
        self.backward.resize(self.evidence.len(), [0.0; COLS]);
        let mut score = [0.0; COLS];
        for (i, (evidence, backward)) in self.evidence.iter().zip(&mut self.backward).rev().enumerate() {
            if i > 0 {
                score = arrive(&score);
            }
            score.iter_mut().zip(evidence).for_each(|(s, e)| *s += e);
            *backward = score;
        }
    }
}

/// The mean column of a path over the rows within `reach` of row `i`.
pub(super) fn column_about(path: &[usize], i: usize, reach: usize) -> f32 {
    let near = &path[i.saturating_sub(reach)..(i + reach + 1).min(path.len())];
    near.iter().sum::<usize>() as f32 / near.len() as f32
}

/// The best that leads to each column of the next row.
fn arrive(score: &Line) -> Line {
    let mut next = *score;
    for j in 1..COLS - 1 {
        next[j] = score[j].max(score[j - 1].max(score[j + 1]) - MOVE);
    }
    next[0] = score[0].max(score[1] - MOVE);
    next[COLS - 1] = score[COLS - 1].max(score[COLS - 2] - MOVE);
    next
}
