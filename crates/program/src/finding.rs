use serde::Serialize;

/// A fault that keeps a weld from being made as requested, or a note about it. It has its position on the seam and the
/// operator action.
///
/// `allowed` and `cure` together give its [`Severity`]; so a warning always has an operator action.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// Short kind, stable for programs: `reach`, `range`, `speed`, `attitude`, `access`, `singular`, `jump`, `hold`,
    /// `pulses`, `steps`, `pace`, `stop`, `blend`, `least_speed`, `time`, `turn`, `bead`, `procedure`.
    pub kind: &'static str,
    /// Description of the fault, with the value found and the value allowed.
    pub message: String,
    /// Pass, counted from 1.
    pub pass: usize,
    /// Path length at its start and end, mm.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
    /// Operator action; empty if none is needed.
    pub cure: String,
    /// True if the weld can be made nevertheless (it was asked to slow down, or the shortcoming is only reported).
    pub allowed: bool,
}

/// Severity of a [`Finding`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// Information, without an operator action.
    Note,
    /// The weld can be made; the operator should consider the action first.
    Warning,
    /// The weld cannot be made as asked.
    Error,
}

impl Finding {
    /// A note of pass `pass` (counted from 1) on a range of its path length, mm: information that asks for no action.
    pub fn note(kind: &'static str, message: String, pass: usize, (from_mm, to_mm): (f64, f64)) -> Self {
        Self { kind, message, pass, from_mm, to_mm, cure: String::new(), allowed: true }
    }

    /// Severity of the finding: an error forbids the weld, a warning asks for an action, a note informs.
    pub fn severity(&self) -> Severity {
        match (self.allowed, self.cure.is_empty()) {
            (false, _) => Severity::Error,
            (true, false) => Severity::Warning,
            (true, true) => Severity::Note,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_warning_has_a_cure_and_a_note_has_none() {
        let note = Finding::note("blend", "goes round".to_owned(), 2, (1.0, 2.0));
        assert_eq!(note.severity(), Severity::Note);
        let warning = Finding { cure: "make it wider".to_owned(), ..note.clone() };
        assert_eq!(warning.severity(), Severity::Warning);
        let error = Finding { allowed: false, ..note };
        assert_eq!(error.severity(), Severity::Error);
        assert!(Severity::Error > Severity::Warning && Severity::Warning > Severity::Note);
    }
}
