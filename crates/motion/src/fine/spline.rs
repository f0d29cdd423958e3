use seamwright_machine::{Joints, MAX_AXES};

/// Look-ahead, in set-points.
pub const LOOK_AHEAD: usize = 32;

/// The curve at a coarse set-point; mm or rad, s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Knot {
    /// Positions: those of the set-point.
    pub q: Joints,
    /// Speeds.
    pub v: Joints,
    /// Accelerations.
    pub a: Joints,
}

impl Knot {
    /// The control point of the uniform cubic B-spline with this curve, for knots `period` (s) apart: the curve
    /// passes a knot at a sixth of the sum of the control points before and after it and four times its own.
    pub fn control_point(&self, period: f64) -> Joints {
        std::array::from_fn(|i| self.q[i] - period * period / 6.0 * self.a[i])
    }
}

/// Set-points in a window, in a ring.
const WINDOW: usize = LOOK_AHEAD + 2;

/// The spline through equally spaced set-points of a motion from rest to rest, as they come. See the
/// [module](super).
///
/// `D` is the displacement of a period and `m` a speed times the period. Equal accelerations on both sides of a
/// set-point give its row, to which each side adds: a cubic `4 m + 2 m' = 6 D` with `m'` the speed at its other end, a
/// quartic first or last segment `6 m = 12 D`.
#[derive(Debug, Clone)]
pub struct CoarseSpline {
    period: f64,
    rows: [Row; WINDOW],
    /// Set-points taken, rows eliminated, and knots given.
    taken: usize,
    eliminated: usize,
    given: usize,
    finished: bool,
}

/// A set-point; once eliminated its speed times the period is `right - next * (that of the one after)`.
#[derive(Debug, Clone, Copy, Default)]
struct Row {
    q: Joints,
    right: Joints,
    next: f64,
}

impl CoarseSpline {
    /// For set-points `period` (s) apart.
    pub fn new(period: f64) -> Self {
        let rows = [Row::default(); WINDOW];
        Self { period, rows, taken: 0, eliminated: 0, given: 0, finished: false }
    }

    /// Takes the next set-point. Returns the knot [`LOOK_AHEAD`] before it, if any.
    pub fn push(&mut self, q: &Joints) -> Option<Knot> {
        self.rows[self.taken % WINDOW] = Row { q: *q, ..Row::default() };
        self.taken += 1;
        // The row of the last set-point but one waits: it may be the last of the motion.
        if self.taken > 3 {
            self.eliminate(false);
        }
        if self.taken > LOOK_AHEAD { Some(self.give()) } else { None }
    }

    /// After the last set-point: the knots that are left, one by one.
    pub fn finish(&mut self) -> Option<Knot> {
        if !self.finished {
            self.finished = true;
            if self.taken > 2 {
                self.eliminate(true);
            }
        }
        (self.given < self.taken).then(|| self.give())
    }

    /// Displacements in the periods before and after set-point `k`.
    fn ways(&self, k: usize) -> (Joints, Joints) {
        let [before, at, after] = [k - 1, k, k + 1].map(|i| &self.rows[i % WINDOW].q);
        (std::array::from_fn(|i| at[i] - before[i]), std::array::from_fn(|i| after[i] - at[i]))
    }

    fn eliminate(&mut self, last: bool) {
        self.eliminated += 1;
        let k = self.eliminated;
        let (left, right) = self.ways(k);
        // Coefficients of one side: of its own speed, the other end's speed, and the displacement.
        let side = |end: bool| if end { (6.0, 0.0, 12.0) } else { (4.0, 2.0, 6.0) };
        let ((own_l, other_l, way_l), (own_r, other_r, way_r)) = (side(k == 1), side(last));
        let before = self.rows[(k - 1) % WINDOW];
        let pivot = own_l + own_r - other_l * before.next;
        let row = &mut self.rows[k % WINDOW];
        row.next = other_r / pivot;
        for i in 0..MAX_AXES {
            row.right[i] = (way_l * left[i] + way_r * right[i] - other_l * before.right[i]) / pivot;
        }
    }

    fn give(&mut self) -> Knot {
        let k = self.given;
        self.given += 1;
        let q = self.rows[k % WINDOW].q;
        let end = self.taken - 1;
        if k == 0 || (self.finished && k == end) {
            return Knot { q, ..Knot::default() };
        }
        let last_row = if self.finished { end } else { end - 1 };
        // The end of the window uses the mean speed, the end of the motion zero.
        let mut m = if self.finished { Joints::default() } else { self.mean(end) };
        let mut after = m;
        for j in (k..last_row).rev() {
            let row = &self.rows[j % WINDOW];
            after = m;
            m = std::array::from_fn(|i| row.right[i] - row.next * m[i]);
        }
        let (_, way) = self.ways(k);
        let is_last = self.finished && k + 1 == end;
        let curve =
            |i: usize| if is_last { 12.0 * way[i] - 6.0 * m[i] } else { 6.0 * way[i] - 4.0 * m[i] - 2.0 * after[i] };
        let (h, hh) = (self.period, self.period * self.period);
        Knot { q, v: m.map(|m| m / h), a: std::array::from_fn(|i| curve(i) / hh) }
    }

    fn mean(&self, end: usize) -> Joints {
        let [before, at] = [end - 1, end].map(|i| &self.rows[i % WINDOW].q);
        std::array::from_fn(|i| at[i] - before[i])
    }
}
