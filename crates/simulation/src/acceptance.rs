//! Acceptance limits of measured values.

/// A table of acceptance criteria.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Subject of the table.
    pub title: String,
    /// Its rows.
    pub rows: Vec<Gate>,
}

/// A measured value and its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Gate {
    /// Description of the frames.
    pub frames: String,
    /// Measured quantity.
    pub what: &'static str,
    /// The measured value.
    pub value: f64,
    /// Limit of the value.
    pub limit: Limit,
    /// Unit of both.
    pub unit: &'static str,
}

/// Acceptance limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// Maximum.
    Most(f64),
    /// Minimum.
    Least(f64),
}

impl Gate {
    /// Creates a value with a maximum.
    #[must_use]
    pub fn at_most(frames: &str, what: &'static str, value: f64, limit: f64, unit: &'static str) -> Self {
        Self { frames: frames.to_owned(), what, value, limit: Limit::Most(limit), unit }
    }

    /// Returns true if the value is within its limit.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        match self.limit {
            Limit::Most(limit) => self.value <= limit,
            Limit::Least(limit) => self.value >= limit,
        }
    }
}
