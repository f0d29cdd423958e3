//! Measured values against what they may be.

/// A table of gates.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// What it is about.
    pub title: String,
    /// Its rows.
    pub rows: Vec<Gate>,
}

/// A measured value and its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Gate {
    /// Which frames.
    pub frames: String,
    /// What is measured.
    pub what: &'static str,
    /// The measured value.
    pub value: f64,
    /// What it may be.
    pub limit: Limit,
    /// Unit of both.
    pub unit: &'static str,
}

/// What a value may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// No more than this.
    Most(f64),
    /// No less than this.
    Least(f64),
}

impl Gate {
    /// True if the value is within its limit.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        match self.limit {
            Limit::Most(limit) => self.value <= limit,
            Limit::Least(limit) => self.value >= limit,
        }
    }
}
