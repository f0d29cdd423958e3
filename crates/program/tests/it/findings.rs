//! Severities of findings.

use seamwright_message::Message;
use seamwright_program::{Finding, PathRange, Severity};

#[test]
fn a_warning_has_a_cure_and_a_note_has_none() {
    let note = Finding::note("blend", Message::new("blend"), 2, PathRange { from_mm: 1.0, to_mm: 2.0 });
    assert_eq!(note.severity(), Severity::Note);
    let warning = Finding { cure: Some(Message::new("wider")), ..note.clone() };
    assert_eq!(warning.severity(), Severity::Warning);
    let error = Finding { allowed: false, ..note };
    assert_eq!(error.severity(), Severity::Error);
    assert!(Severity::Error > Severity::Warning && Severity::Warning > Severity::Note);
}
