/// A row of the gates' table.
#[derive(Debug, Clone, PartialEq)]
pub struct GateRow {
    /// What is measured.
    pub what: String,
    /// The measured value.
    pub value: f64,
    /// Most that it may be.
    pub limit: f64,
    /// Unit of both.
    pub unit: &'static str,
}

/// Gates.
pub fn stripe_gates(_cases: u64) -> Vec<GateRow> {
    Vec::new()
}
