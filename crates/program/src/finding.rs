use crate::path_range::PathRange;
use seamwright_message::{Language, Message};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// A fault that keeps a weld from being made as requested, or a note about it. It has its position on the seam and the
/// operator action.
///
/// `allowed` and `cure` together give its [`Severity`]; so a warning always has an operator action.
///
/// As JSON, `message` and `cure` are English text, and `code`, `arguments`, `cure_code` and `cure_arguments` are the
/// messages as data.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Short kind, stable for programs: `reach`, `range`, `speed`, `attitude`, `access`, `singular`, `jump`, `hold`,
    /// `pulses`, `steps`, `pace`, `stop`, `blend`, `least_speed`, `time`, `turn`, `bead`, `joint`, `procedure`,
    /// `plausible`, `pool`, `preheat`, `cooling`, `interpass`.
    pub kind: Cow<'static, str>,
    /// Description of the fault, with the value found and the value allowed.
    pub message: Message,
    /// Pass, counted from 1.
    pub pass: usize,
    /// Path length at its start and end, mm.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
    /// Operator action, if one is needed.
    pub cure: Option<Message>,
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
    /// A fault of pass `pass` (counted from 1) on a range of its path length that forbids the weld, and the operator
    /// action.
    pub fn error(
        kind: &'static str,
        message: Message,
        pass: usize,
        range: impl Into<PathRange>,
        cure: Message,
    ) -> Self {
        let PathRange { from_mm, to_mm } = range.into();
        Self { kind: kind.into(), message, pass, from_mm, to_mm, cure: Some(cure), allowed: false }
    }

    /// A note of pass `pass` (counted from 1) on a range of its path length: information that asks for no action.
    pub fn note(kind: &'static str, message: impl Into<Message>, pass: usize, range: PathRange) -> Self {
        let PathRange { from_mm, to_mm } = range;
        Self { kind: kind.into(), message: message.into(), pass, from_mm, to_mm, cure: None, allowed: true }
    }

    /// Returns the words of the operator action; empty if none is needed.
    pub fn cure_text(&self) -> String {
        self.cure.as_ref().map_or_else(String::new, ToString::to_string)
    }

    /// Severity of the finding: an error forbids the weld, a warning asks for an action, a note informs.
    pub fn severity(&self) -> Severity {
        match (self.allowed, self.cure.is_none()) {
            (false, _) => Severity::Error,
            (true, false) => Severity::Warning,
            (true, true) => Severity::Note,
        }
    }
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { kind, message, pass, from_mm, to_mm, cure, allowed } = self;
        let mut fields = serializer.serialize_struct("Finding", 11)?;
        fields.serialize_field("kind", kind)?;
        fields.serialize_field("message", &message.in_language(Language::English))?;
        fields.serialize_field("pass", pass)?;
        fields.serialize_field("from_mm", from_mm)?;
        fields.serialize_field("to_mm", to_mm)?;
        let text = cure.as_ref().map(|cure| cure.in_language(Language::English));
        fields.serialize_field("cure", &text.unwrap_or_default())?;
        fields.serialize_field("allowed", allowed)?;
        fields.serialize_field("code", &message.code)?;
        fields.serialize_field("arguments", &message.named_arguments())?;
        fields.serialize_field("cure_code", &cure.as_ref().map(|cure| &cure.code))?;
        fields.serialize_field("cure_arguments", &cure.as_ref().map(Message::named_arguments))?;
        fields.end()
    }
}

/// Findings as data between programs: messages with their codes and arguments, so that they are read back unchanged. Used
/// as `#[serde(with = "seamwright_program::finding_data")]` for lists.
pub mod finding_data {
    use super::Finding;
    use seamwright_message::Message;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use std::borrow::Cow;

    #[derive(Serialize, Deserialize)]
    struct Data<'a> {
        kind: Cow<'static, str>,
        message: Cow<'a, Message>,
        pass: usize,
        from_mm: f64,
        to_mm: f64,
        cure: Option<Cow<'a, Message>>,
        allowed: bool,
    }

    /// Writes a list of findings.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer>(findings: &[Finding], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(findings.iter().map(|f| Data {
            kind: f.kind.clone(),
            message: Cow::Borrowed(&f.message),
            pass: f.pass,
            from_mm: f.from_mm,
            to_mm: f.to_mm,
            cure: f.cure.as_ref().map(Cow::Borrowed),
            allowed: f.allowed,
        }))
    }

    /// Reads a list of findings.
    ///
    /// # Errors
    /// Those of the deserializer.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Finding>, D::Error> {
        let data = Vec::<Data<'static>>::deserialize(deserializer)?;
        Ok(data
            .into_iter()
            .map(|f| Finding {
                kind: f.kind,
                message: f.message.into_owned(),
                pass: f.pass,
                from_mm: f.from_mm,
                to_mm: f.to_mm,
                cure: f.cure.map(Cow::into_owned),
                allowed: f.allowed,
            })
            .collect())
    }
}
