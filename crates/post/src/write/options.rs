/// Options of the writer.
#[derive(Debug, Clone, PartialEq)]
pub struct WriteOptions {
    /// The machine's title, for people.
    pub machine: String,
    /// Form of the blocks' times.
    pub feed: Feed,
    /// Rounding of corners between blocks by the control, mm; 0: the control's own default. LinuxCNC only.
    pub rounding_mm: f64,
    /// Remarks for the start of the text.
    pub remarks: Vec<String>,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self { machine: String::new(), feed: Feed::InverseTime, rounding_mm: 0.0, remarks: Vec::new() }
    }
}

/// Form of the blocks' times. PMAC: times, or a feed per second; its cubics and splines have times always.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feed {
    /// Blocks per minute, G93.
    InverseTime,
    /// mm/min along the way that the control counts, G94.
    PerMinute,
}
