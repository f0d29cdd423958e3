//! Size limits of a program. A larger one is a mistake, and would take excessive memory or time.

use crate::pass::Pass;
use crate::program::Program;
use seamwright_document::{Document, DocumentError};
use seamwright_message::Message;

/// Most passes of a program, each as often as it is welded.
pub const MAX_PASSES: usize = 10_000;

/// Maximum number of rows of all passes (positions of beads, points), each as often as its pass is welded: about 1 GB.
pub const MAX_ROWS: usize = 4_000_000;

/// Longest seam, mm: a kilometre. Arc length of a longer one is not exact to 1e-9 mm any more.
pub const MAX_SEAM_MM: f64 = 1e6;

/// Longest travel of a pass, s: a day.
pub const MAX_TRAVEL_S: f64 = 86_400.0;

impl Pass {
    /// Rows that it holds: spans, positions of its beads, points.
    pub fn rows(&self) -> usize {
        let beads: usize = self.beads().map(|(bead, _)| bead.s_mm.len()).sum();
        self.spans.len() + beads + self.points.as_ref().map_or(0, crate::points::Points::count)
    }

    /// Time that it travels along the seam at the asked speed, s.
    pub fn travel_s(&self) -> f64 {
        let time = |span: &crate::span::Span| {
            let (from, to) = span.speed_mm_s.ends();
            let (low, high) = (from.min(to), from.max(to));
            // Linear in path length: the time is the length over the logarithmic mean of the speeds.
            let mean = if high - low < 1e-6 * high { low } else { (high - low) / (high / low).ln() };
            (span.to_mm.get() - span.from_mm.get()) / mean
        };
        self.spans.iter().map(time).sum()
    }
}

impl Program {
    /// Refuses a program that holds more than a plan can, before its passes are repeated. Fails with the key's address.
    pub(crate) fn check_extent(document: &Document<Self>) -> Result<(), DocumentError> {
        let (mut passes, mut rows) = (0, 0);
        for (i, pass) in document.value.passes.iter().enumerate() {
            let times = usize::from(pass.repeat.get());
            passes += times;
            rows += times * pass.rows();
            let wrong = |code, max: usize| {
                let key = if times > 1 { format!("passes[{i}].repeat") } else { format!("passes[{i}]") };
                let allowed = Message::new("program-up-to-in-all").number("max", max as f64, 0);
                Err(document.error_at(&key, Message::new(code), allowed))
            };
            if passes > MAX_PASSES {
                return wrong("program-too-many-passes", MAX_PASSES);
            }
            if rows > MAX_ROWS {
                return wrong("program-too-many-rows", MAX_ROWS);
            }
        }
        Ok(())
    }
}
