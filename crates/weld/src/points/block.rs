use super::Row;
use seamwright_program::ArcThrough;

/// The way from one point to the next, over a range of the path's parameter.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    /// Parameter at its start and end, mm.
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Numbers at its start and end.
    pub(crate) start: Row,
    pub(crate) end: Row,
    pub(crate) shape: Shape,
    /// True if the torch stops at its end.
    pub(crate) stops: bool,
    /// True if it continues the block before smoothly.
    pub(crate) is_continued: bool,
}

/// Change of the numbers from start to end, by the part of the block that is done.
#[derive(Debug, Clone)]
pub(crate) enum Shape {
    /// Evenly.
    Line,
    /// Three of them round an arc, the others evenly.
    Arc(ArcThrough, [Option<usize>; 3]),
    /// By cubics with these slopes by the part done, at start and end.
    Cubic(Box<[Row; 2]>),
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
                    if let Some(i) = column {
                        row[*i] = place[k];
                    }
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
