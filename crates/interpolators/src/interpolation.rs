use crate::path::Path;
use crate::point::Point;

/// A running interpolation: an iterator over its points, the start first and the end last, in constant memory.
pub struct Interpolation {
    path: Path,
    points: Box<dyn Iterator<Item = Point> + Send>,
}

impl Interpolation {
    pub(crate) fn new(path: Path, points: impl Iterator<Item = Point> + Send + 'static) -> Self {
        Self { path, points: Box::new(points) }
    }

    /// The true curve.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Iterator for Interpolation {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        self.points.next()
    }
}
