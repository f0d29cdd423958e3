use super::Row;
use glam::{DQuat, DVec3};
use seamwright_geometry::{self as geometry, Curve};

/// The way from one point to the next, over a range of the path's parameter.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    /// Parameter at its begin and end, mm.
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Numbers at its begin and end.
    pub(crate) start: Row,
    pub(crate) end: Row,
    pub(crate) shape: Shape,
    /// True if the torch stops at its end.
    pub(crate) stops: bool,
    /// True if it goes on smoothly from the block before.
    pub(crate) is_continued: bool,
}

/// How the numbers go from begin to end, by the part of the block that is done.
#[derive(Debug, Clone)]
pub(crate) enum Shape {
    /// Evenly.
    Line,
    /// Three of them round an arc, the others evenly.
    Arc(Helix, [usize; 3]),
    /// By cubics with these slopes by the part done, at begin and end.
    Cubic(Box<[Row; 2]>),
}

/// An arc, or one that also goes along its axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Helix {
    centre: DVec3,
    axis: DVec3,
    /// From the centre to the start, across the axis.
    out: DVec3,
    sweep: f64,
    /// Height over the centre at the start, and what is added on the way.
    height: (f64, f64),
}

impl Helix {
    /// The arc from `start` through `via` to `end`; about `normal` through their projections, if that is given. None if
    /// they lie on a line.
    pub(crate) fn through(start: DVec3, via: DVec3, end: DVec3, normal: Option<DVec3>) -> Option<Self> {
        let flat = |p: DVec3| normal.map_or(p, |n| p - (p - start).dot(n) * n);
        let arc = geometry::Arc::through(start, flat(via), flat(end)).ok()?;
        let (centre, axis) = (arc.centre(), arc.axis());
        let height = |p: DVec3| (p - centre).dot(axis);
        let rise = height(end) - height(start);
        let (_, sweep) = arc.domain();
        Some(Self { centre, axis, out: start - centre, sweep, height: (0.0, rise) })
    }

    pub(crate) fn at(&self, f: f64) -> DVec3 {
        let turned = DQuat::from_axis_angle(self.axis, f * self.sweep) * self.out;
        self.centre + (self.height.0 + f * self.height.1) * self.axis + turned
    }
}

impl Block {
    /// The numbers at the part `f` of the block.
    pub(crate) fn at(&self, f: f64) -> Row {
        let (a, b) = (&self.start, &self.end);
        let mut row: Row = std::array::from_fn(|i| a[i] + f * (b[i] - a[i]));
        match &self.shape {
            Shape::Line => {}
            Shape::Arc(arc, columns) => {
                let place = arc.at(f);
                for (k, column) in columns.iter().enumerate() {
                    row[*column] = place[k];
                }
            }
            Shape::Cubic(slopes) => {
                for (i, value) in row.iter_mut().enumerate() {
                    let (rise, m0, m1) = (b[i] - a[i], slopes[0][i], slopes[1][i]);
                    let (c2, c3) = (3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise);
                    *value = a[i] + f * (m0 + f * (c2 + f * c3));
                }
            }
        }
        row
    }
}
