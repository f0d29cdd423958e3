/// Range of path lengths of a pass or a seam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathRange {
    /// Path length at its start, mm.
    pub from_mm: f64,
    /// Path length at its end, mm.
    pub to_mm: f64,
}

impl PathRange {
    /// Range from the start of a path to the path length `to_mm`.
    pub fn up_to(to_mm: f64) -> Self {
        Self { from_mm: 0.0, to_mm }
    }

    /// Range without length at the path length `s_mm`.
    pub fn at(s_mm: f64) -> Self {
        Self { from_mm: s_mm, to_mm: s_mm }
    }
}
