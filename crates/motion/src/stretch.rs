use seamwright_program::PathRange;

/// A part of a path, between two path lengths (mm) or two values of its parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl From<Stretch> for PathRange {
    fn from(stretch: Stretch) -> Self {
        Self { from_mm: stretch.from, to_mm: stretch.to }
    }
}
