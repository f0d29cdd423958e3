use super::timed::{Rates, Timed, Tip};
use crate::{JointPath, LawPoint, SpeedLaw};

/// A pass in time: the axes' path, passed as a speed law says.
///
/// Rates follow by the chain rule from the path's derivatives by path length and the law's by time, without differences.
/// Borders are those of the law's cells, among which are all places where the path's third derivatives jump.
#[derive(Debug, Clone)]
pub struct PassTimed<'a> {
    path: &'a JointPath,
    law: &'a SpeedLaw,
    /// Start (s) of each of the law's cells, and the panel of the path in which the cell lies.
    cells: Vec<(f64, usize)>,
}

impl<'a> PassTimed<'a> {
    /// `law` must be one along `path`.
    pub fn new(path: &'a JointPath, law: &'a SpeedLaw) -> Self {
        let cell = |i| (law.cell_times(i).0, path.panel(law.in_cell(i, 0.5).s, false));
        Self { path, law, cells: (0..law.cells()).map(cell).collect() }
    }

    /// The cell in which time `t` is: the later one where two meet, unless `before`.
    fn cell(&self, t: f64, before: bool) -> usize {
        let begun = |c: &(f64, usize)| if before { c.0 < t } else { c.0 <= t };
        self.cells.partition_point(begun).saturating_sub(1)
    }

    fn law_in(&self, cell: usize, t: f64) -> LawPoint {
        let (from, to) = self.law.cell_times(cell);
        let part = if to > from { ((t - from) / (to - from)).clamp(0.0, 1.0) } else { 1.0 };
        self.law.in_cell(cell, part)
    }
}

impl Timed for PassTimed<'_> {
    fn duration(&self) -> f64 {
        self.law.duration()
    }

    fn at(&self, t: f64, before: bool) -> Rates {
        let duration = self.duration();
        let cell = self.cell(t.clamp(0.0, duration), before);
        let rest = |s| LawPoint { s, ..LawPoint::default() };
        let law = if t < 0.0 || (t <= 0.0 && before) {
            rest(0.0)
        } else if t > duration || (t >= duration && !before) {
            rest(self.path.length())
        } else {
            self.law_in(cell, t)
        };
        let LawPoint { s, v, a, j } = law;
        // Path lengths round: the cell knows on which side of a border they are.
        let p = self.path.point_in(self.cells[cell].1, s);
        Rates {
            q: p.q,
            v: std::array::from_fn(|i| p.d1[i] * v),
            a: std::array::from_fn(|i| p.d2[i] * v * v + p.d1[i] * a),
            j: std::array::from_fn(|i| p.d3[i] * v * v * v + 3.0 * p.d2[i] * v * a + p.d1[i] * j),
            tip: Tip { s, v, a, j },
        }
    }

    fn next_border(&self, t: f64, forward: bool) -> f64 {
        if forward {
            let next = self.cells.get(self.cells.partition_point(|c| c.0 <= t)).map(|c| c.0);
            next.unwrap_or(if t < self.duration() { self.duration() } else { f64::INFINITY })
        } else if t > self.duration() {
            self.duration()
        } else {
            let passed = self.cells.partition_point(|c| c.0 < t);
            passed.checked_sub(1).map_or(f64::NEG_INFINITY, |i| self.cells[i].0)
        }
    }

    fn time_of(&self, s: f64) -> f64 {
        self.law.time(s)
    }
}
