use super::strip::{COLS, EVIDENCE_FROM, HALF, ROWS, Strip};

/// One row's evidence counts at most this much, so that a scratch does not outweigh many rows.
const MOST: f32 = 8.0;
/// What a step to the next column costs.
const MOVE: f32 = 1.0;
/// What each column of distance from where the path is expected to begin costs, beyond the free ones.
const AWAY: f32 = 0.8;

/// The best paths across the rows of a strip.
#[derive(Debug, Clone)]
pub(super) struct Paths {
    /// Column in each row.
    pub(super) best: [usize; ROWS],
    /// The best path that keeps away from that one.
    pub(super) rival: [usize; ROWS],
    score: Vec<[f32; COLS]>,
    from: Vec<[i8; COLS]>,
}

impl Paths {
    pub(super) fn new() -> Self {
        let (best, rival) = ([HALF; ROWS], [HALF; ROWS]);
        Self { best, rival, score: vec![[0.0; COLS]; ROWS], from: vec![[0; COLS]; ROWS] }
    }

    /// Finds both. The best begins within `free` columns of the axis or pays for it; the rival may be anywhere at least
    /// `apart` columns away.
    pub(super) fn find(&mut self, strip: &Strip, free: f32, apart: usize) {
        self.forward(strip, |_, _| false, |j| AWAY * ((j as f32 - HALF as f32).abs() - free).max(0.0));
        self.best = self.backward(strip.columns);
        let best = self.best;
        self.forward(strip, |i, j| best[i].abs_diff(j) < apart, |_| 0.0);
        self.rival = self.backward(strip.columns);
    }

    fn forward(&mut self, strip: &Strip, taken: impl Fn(usize, usize) -> bool, cost: impl Fn(usize) -> f32) {
        let (low, high) = strip.columns;
        for i in 0..ROWS {
            for j in low..=high {
                let evidence = (strip.depth[i][j] / strip.noise - EVIDENCE_FROM).clamp(0.0, MOST);
                let evidence = if taken(i, j) { -MOST } else { evidence };
                let (before, step) = if i == 0 { (-cost(j), 0) } else { self.arrive(i - 1, j, low, high) };
                self.score[i][j] = before + evidence;
                self.from[i][j] = step;
            }
        }
    }

    fn arrive(&self, row: usize, j: usize, low: usize, high: usize) -> (f32, i8) {
        let score = &self.score[row];
        let mut found = (score[j], 0);
        if j > low && score[j - 1] - MOVE > found.0 {
            found = (score[j - 1] - MOVE, -1);
        }
        if j < high && score[j + 1] - MOVE > found.0 {
            found = (score[j + 1] - MOVE, 1);
        }
        found
    }

    fn backward(&self, (low, high): (usize, usize)) -> [usize; ROWS] {
        let last = &self.score[ROWS - 1];
        // Of equal ends the one nearest to the axis.
        let mut at = HALF.clamp(low, high);
        for j in low..=high {
            let nearer = j.abs_diff(HALF) < at.abs_diff(HALF);
            if last[j] > last[at] || (last[j] >= last[at] && nearer) {
                at = j;
            }
        }
        let mut path = [at; ROWS];
        for i in (0..ROWS).rev() {
            path[i] = at;
            at = at.saturating_add_signed(isize::from(self.from[i][at]));
        }
        path
    }
}
