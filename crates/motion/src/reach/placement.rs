use glam::{DAffine3, DQuat, DVec3};

/// Subject of placements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moved {
    /// The work, in the work frame.
    Work,
    /// The machine's base with all that stands on it, in the base frame.
    Base,
}

impl Moved {
    /// Name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Work => "work",
            Self::Base => "base",
        }
    }
}

/// A displacement of the work, or of the machine's base, from its present position.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Placement {
    /// Displacement in the frame of what is moved, mm.
    pub by: DVec3,
    /// Rotation about the vertical through the pivot, rad.
    pub turn: f64,
}

/// Axis about which placements turn, in the frame of what is moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pivot {
    /// A point on the axis, mm.
    pub point: DVec3,
    /// Unit vector against gravity with the machine at home.
    pub up: DVec3,
}

impl Placement {
    /// The displacement as a map of points in that frame: the rotation about `pivot`, then the translation.
    pub fn affine(&self, pivot: &Pivot) -> DAffine3 {
        let turned = DAffine3::from_quat(DQuat::from_axis_angle(pivot.up, self.turn));
        DAffine3::from_translation(self.by + pivot.point) * turned * DAffine3::from_translation(-pivot.point)
    }

    /// The same, rounded to 0.1 mm and 0.1 degrees: as a person would set it.
    pub fn rounded(&self) -> Self {
        // `+ 0.0` turns a rounded negative zero into zero.
        let tenth = |v: f64| (v * 10.0).round() / 10.0 + 0.0;
        let by = DVec3::from_array(self.by.to_array().map(tenth));
        Self { by, turn: tenth(self.turn.to_degrees()).to_radians() }
    }

    /// Coordinates x, y, z (mm) and turn (rad).
    pub fn coordinates(&self) -> [f64; 4] {
        [self.by.x, self.by.y, self.by.z, self.turn]
    }

    pub(super) fn of([x, y, z, turn]: [f64; 4]) -> Self {
        Self { by: DVec3::new(x, y, z), turn }
    }
}

/// Searched range of one coordinate of placements, and its cells in the grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReachSpan {
    from: f64,
    to: f64,
    cells: usize,
}

/// Reason why a range of placements is invalid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpanError {
    /// An end is not finite.
    NotFinite,
    /// The start is above the end.
    Reversed,
    /// There are no cells.
    NoCells,
}

impl ReachSpan {
    /// A range from `from` to `to`, mm or rad, with `cells` places in the grid, the first and last at the ends. A single
    /// cell is at the present placement if it lies in the range, else in the middle.
    ///
    /// # Errors
    /// Ends that are reversed or not finite, or no cells.
    pub fn new(from: f64, to: f64, cells: usize) -> Result<Self, SpanError> {
        if !from.is_finite() || !to.is_finite() {
            return Err(SpanError::NotFinite);
        }
        if from > to {
            return Err(SpanError::Reversed);
        }
        if cells == 0 {
            return Err(SpanError::NoCells);
        }
        Ok(Self { from, to, cells: if from < to { cells } else { 1 } })
    }

    /// The ends, mm or rad.
    pub fn ends(&self) -> (f64, f64) {
        (self.from, self.to)
    }

    /// Number of places in the grid.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// The place of cell `i` of the grid.
    pub fn at(&self, i: usize) -> f64 {
        match self.cells {
            1 if (self.from..=self.to).contains(&0.0) => 0.0,
            1 => 0.5 * (self.from + self.to),
            cells => self.from + (self.to - self.from) * i as f64 / (cells - 1) as f64,
        }
    }

    /// Distance of neighbouring cells; half the range of a single one.
    pub fn step(&self) -> f64 {
        let steps = if self.cells == 1 { 2 } else { self.cells - 1 };
        (self.to - self.from) / steps as f64
    }
}

/// The placements to search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReachGrid {
    /// Ranges of x, y, z (mm) and of the turn (rad).
    pub spans: [ReachSpan; 4],
}

impl ReachGrid {
    /// Number of places in the grid.
    pub fn count(&self) -> usize {
        self.spans.iter().fold(1, |count, span| count.saturating_mul(span.cells))
    }

    /// The placement at the cells `at` of x, y, z and turn.
    pub fn placement(&self, at: [usize; 4]) -> Placement {
        Placement::of(std::array::from_fn(|i| self.spans[i].at(at[i])))
    }

    /// All cells, from coarse to fine: if the search ends early, those judged are spread over the grid.
    pub(super) fn order(&self) -> Vec<[usize; 4]> {
        let mut all: Vec<[usize; 4]> = (0..self.count())
            .map(|mut k| {
                self.spans.map(|span| {
                    let i = k % span.cells;
                    k /= span.cells;
                    i
                })
            })
            .collect();
        let fineness = |i: usize| if i == 0 { 0 } else { usize::BITS - i.trailing_zeros() };
        all.sort_by_key(|at| at.map(fineness).into_iter().max());
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_placement_turns_about_its_pivot() {
        let pivot = Pivot { point: DVec3::new(10.0, 20.0, 5.0), up: DVec3::Z };
        let placement = Placement { by: DVec3::new(1.0, 2.0, 3.0), turn: 0.5 * std::f64::consts::PI };
        let map = placement.affine(&pivot);
        assert!((map.transform_point3(pivot.point) - DVec3::new(11.0, 22.0, 8.0)).length() < 1e-12);
        let beside = pivot.point + DVec3::X;
        assert!((map.transform_point3(beside) - DVec3::new(11.0, 23.0, 8.0)).length() < 1e-12);
    }

    #[test]
    fn the_order_has_every_cell_once() {
        let span = |cells| ReachSpan::new(-1.0, 1.0, cells).unwrap();
        let grid = ReachGrid { spans: [span(5), span(4), span(1), span(3)] };
        let mut order = grid.order();
        assert_eq!(order[0], [0; 4]);
        assert_eq!(order.len(), grid.count());
        order.sort_unstable();
        order.dedup();
        assert_eq!(order.len(), 60);
    }

    #[test]
    fn a_single_cell_is_at_the_present_placement() {
        let is_at = |from, cells, i, at: f64| (ReachSpan::new(from, 30.0, cells).unwrap().at(i) - at).abs() < 1e-12;
        assert!(is_at(-10.0, 1, 0, 0.0) && is_at(10.0, 1, 0, 20.0) && is_at(10.0, 3, 2, 30.0));
        assert_eq!(ReachSpan::new(1.0, 0.0, 3), Err(SpanError::Reversed));
        assert_eq!(ReachSpan::new(0.0, 1.0, 0), Err(SpanError::NoCells));
        assert_eq!(ReachSpan::new(f64::NAN, 1.0, 1), Err(SpanError::NotFinite));
    }
}
