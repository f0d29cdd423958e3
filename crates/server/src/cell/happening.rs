use crate::wire::LackView;

/// Events by key: kind, and English sentence with `{0}`, `{1}` .. for its parameters. Panels have translations
/// (`web/src/words`), checked against this table.
const HAPPENINGS: [(&str, &str, &str); 35] = [
    ("mode", "mode", "{0} -> {1}"),
    ("order", "order", "{0}"),
    ("refused", "refused", "{0}: {1}"),
    ("alarm", "alarm", "{0}: {1}"),
    ("alarm_of", "alarm", "{0} ({2}): {1}"),
    ("alarm_before", "alarm", "{0} of {1} was not acknowledged before the end"),
    ("cleared", "cleared", "{0} has gone"),
    ("cleared_of", "cleared", "{0} ({1}) has gone"),
    ("shelved", "alarm", "{0} shelved for {1} min"),
    ("unshelved", "alarm", "{0} is no longer shelved"),
    ("machine_changed", "work", "{0} changed in {1}: in force when a job of this machine is loaded anew"),
    ("tool_changed", "work", "tip of {0} changed in {1}: in force when a job of this machine is loaded anew"),
    ("sensor_changed", "work", "sensor {0} changed in {1}: in force when a job of this machine is loaded anew"),
    ("pass_ends", "pass", "pass {0} ends at {1} mm"),
    ("left", "left", "pass {0} was left, welded up to {1} mm"),
    (
        "left_before",
        "left",
        "weld {0} was left by a failure of power or program: look at the end of its bead before going on",
    ),
    ("stopped_by", "alarm", "the cell was stopped by {0}"),
    ("cycles_missed", "alarm", "{0} cycles were missed, up to {1} ms at once"),
    ("no_realtime", "alarm", "the cycle runs without real-time rights: {0}"),
    ("safe_unconfirmed", "alarm", "{0}: its outputs are not confirmed to be safe: {1}"),
    (
        "journal_damaged",
        "alarm",
        "the journal of positions is damaged: a weld left by a power failure would not be known; look at the part, then home",
    ),
    ("weld_lost", "record", "weld {0} has files but is not in the library, which is damaged: its entry was lost"),
    ("recorded", "record", "weld {0} recorded: {1}"),
    ("record_not_whole", "record", "weld {0}: the record is not complete: {1}"),
    ("record_interrupted", "record", "weld {0} was interrupted; its record is whole again"),
    ("record_fails", "record", "the record cannot be written: {0}"),
    ("not_recorded", "record", "this weld is not recorded: {0}"),
    ("audit_fails", "record", "the audit log cannot be written: {0}"),
    ("restored", "record", "all data were restored; what was there before is in {0}"),
    ("control_taken", "control", "control taken"),
    ("control_taken_over", "control", "control taken over"),
    ("control_lost", "control", "the control token was lost: no sign of life from its page"),
    ("loaded", "work", "loaded: {0}"),
    ("not_loaded", "work", "nothing is loaded: {0}"),
    ("teach_ended", "teach", "teaching {0} ended: {1}"),
];

/// An event.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Happening {
    /// Key in the table.
    pub(super) key: &'static str,
    /// Parameters, in the table's order.
    pub(super) of: Vec<String>,
    /// User who caused it, if any.
    pub(super) user: Option<String>,
    /// Reason, if it was refused.
    pub(super) why: Option<LackView>,
}

/// Creates an event from its key in the table and its parameters.
pub(crate) fn happening<const N: usize>(key: &'static str, of: [String; N]) -> Happening {
    debug_assert!(HAPPENINGS.iter().any(|row| row.0 == key), "{key} has no words");
    Happening { key, of: of.into(), user: None, why: None }
}

impl Happening {
    pub(crate) fn by(self, user: Option<String>) -> Self {
        Self { user, ..self }
    }

    /// Adds the reason of a refusal.
    pub(super) fn because(self, why: LackView) -> Self {
        Self { why: Some(why), ..self }
    }

    /// Returns kind, English sentence, and the event.
    pub(super) fn told(self) -> (&'static str, String, Self) {
        let (_, kind, words) = HAPPENINGS.iter().find(|row| row.0 == self.key).unwrap_or(&HAPPENINGS[1]);
        // One pass only, so that braces in a parameter are not replaced.
        let mut text = String::new();
        for (i, piece) in words.split('{').enumerate() {
            match piece.split_once('}') {
                Some((hole, rest)) if i > 0 => {
                    text.push_str(hole.parse().ok().and_then(|i: usize| self.of.get(i)).map_or("", String::as_str));
                    text.push_str(rest);
                }
                _ => text.push_str(piece),
            }
        }
        (kind, text, self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_one_sentence_and_parameters_are_text() {
        for (i, (key, kind, words)) in HAPPENINGS.iter().enumerate() {
            assert!(HAPPENINGS[..i].iter().all(|row| row.0 != *key), "{key}");
            assert!(!kind.is_empty() && !words.is_empty());
        }
        let (kind, text, _) = happening("alarm_of", ["a".to_owned(), "b".to_owned(), "c".to_owned()]).told();
        assert_eq!((kind, text.as_str()), ("alarm", "a (c): b"));
        let (_, text, _) = happening("recorded", ["{1}".to_owned(), "good".to_owned()]).told();
        assert_eq!(text, "weld {1} recorded: good");
    }
}
