use crate::grid::{Grid, leaving};

/// A walk over the lattice from the path's start to its end: position, quadrant and remaining crossings.
///
/// Up to the last quadrant only crossings are counted. In the last one each axis moves towards the end's coordinate and
/// stops on it. An axis already past it (the quadrant's first point may be one pulse off) is corrected by closing
/// pulses, one axis at a time. So a walk always ends on the lattice point nearest to the path's end.
pub(crate) struct Course {
    pub(crate) grid: Grid,
    pub(crate) at: [i64; 3],
    quadrant: u32,
    left: u32,
}

/// The lattice points of the walk over `grid`, each with its clock; `rule` gives the next pulse, none at the end.
pub(crate) fn walk(
    grid: Grid,
    rule: fn(&Course) -> Option<[i64; 3]>,
) -> impl Iterator<Item = (u64, [i64; 3])> + Send + 'static {
    let mut course = Course { at: grid.start, quadrant: leaving(grid.start), left: grid.crossings, grid };
    let start = (0, course.at);
    let pulses = (1..).map_while(move |clock| rule(&course).map(|pulse| (clock, course.pulse(pulse))));
    std::iter::once(start).chain(pulses)
}

impl Course {
    /// Direction of the pulses of x and y in this quadrant.
    pub(crate) fn signs(&self) -> (i64, i64) {
        match self.quadrant {
            0 => (-1, 1),
            1 => (-1, -1),
            2 => (1, -1),
            _ => (1, 1),
        }
    }

    /// Flags for x and y that may still pulse.
    pub(crate) fn open(&self) -> (bool, bool) {
        let (sx, sy) = self.signs();
        let end = self.grid.end;
        (self.left > 0 || (end[0] - self.at[0]) * sx > 0, self.left > 0 || (end[1] - self.at[1]) * sy > 0)
    }

    fn pulse(&mut self, pulse: [i64; 3]) -> [i64; 3] {
        for (at, by) in self.at.iter_mut().zip(pulse) {
            *at += by;
        }
        if self.left > 0 && leaving(self.at) != self.quadrant {
            self.quadrant = leaving(self.at);
            self.left -= 1;
        }
        self.at
    }

    /// The pulse still needed when x and y may not pulse any more; none at the end.
    pub(crate) fn closing_pulse(&self) -> Option<[i64; 3]> {
        let axis = (0..3).find(|&i| self.at[i] != self.grid.end[i])?;
        let mut pulse = [0; 3];
        pulse[axis] = (self.grid.end[axis] - self.at[axis]).signum();
        Some(pulse)
    }
}
