use crate::grid::Grid;
use crate::path::Path;
use crate::point::Point;
use std::f64::consts::TAU;

/// Turns clocks and lattice points into timed points in mm.
pub(crate) struct PulsePoints<I> {
    path: Path,
    grid: Grid,
    clock_s: f64,
    lattice: I,
    /// Angle of the last point, to unwrap the next one.
    u: f64,
}

impl<I> PulsePoints<I> {
    pub(crate) fn new(path: Path, grid: Grid, clock_s: f64, lattice: I) -> Self {
        Self { u: path.start_rad(), path, grid, clock_s, lattice }
    }
}

impl<I: Iterator<Item = (u64, [i64; 3])>> Iterator for PulsePoints<I> {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        let (clock, at) = self.lattice.next()?;
        let position = self.grid.position(at);
        let u = self.path.nearest(position).u_rad;
        self.u = u + TAU * ((self.u - u) / TAU).round();
        Some(Point { t_s: clock as f64 * self.clock_s, u_rad: self.u, position })
    }
}
