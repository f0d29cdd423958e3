//! Reasons why a command ends without its result.

use seamwright_document::DocumentError;
use seamwright_message::{Argument, Language, Message, Unit, display_by_message};
use seamwright_program::{Finding, FindingGroup, FindingPlace, Severity, group_findings};
use std::io::{self, Write};

/// Reason why the command ends without its result, by exit code.
#[derive(Debug)]
pub enum Failure {
    /// 1: the job is understood but cannot be welded as asked.
    Findings(Vec<Finding>),
    /// 1: the same, and the findings have been printed already.
    Printed,
    /// 2: bad input or usage.
    Input(Message),
    /// 2: the same, for a file with an address of the fault.
    Document(Box<DocumentError>),
    /// 3: a device or the environment failed.
    Environment(Message),
    /// 3: planning was cancelled.
    Cancelled,
    /// 0: the reader of our output has stopped reading.
    ReaderGone,
}

display_by_message!(Failure);

/// Maximum number of positions listed of one finding.
const MAX_PLACES: usize = 6;

/// Writes findings for people, in the language of the process: see [`findings_message`].
pub fn write_findings(out: &mut impl Write, findings: &[Finding]) -> io::Result<()> {
    writeln!(out, "{}", findings_message(findings))
}

/// Returns findings for people, equal ones once, those that prevent the weld first.
pub fn findings_message(findings: &[Finding]) -> Message {
    let groups = group_findings(findings);
    let mut lines = vec![match groups.iter().filter(|group| !group.finding.allowed).count() {
        0 if findings.is_empty() => Message::new("project-weld-possible"),
        0 => Message::new("project-weld-possible-with-remarks"),
        n => Message::new("project-weld-impossible").count("findings", n),
    }];
    for group in &groups {
        let finding = Message::new("project-finding").message("severity", severity(group.finding));
        lines.push(finding.text("kind", group.finding.kind.as_ref()).message("finding", group.message.clone()));
        lines.push(Message::new("project-where").message("places", places(group)).indented());
        if let Some(cure) = &group.cure {
            lines.push(Message::new("project-cure").message("cure", cure.clone()).indented());
        }
        if !group.message.is_verbatim() {
            lines.push(Message::new("document-code").text("code", group.message.code.clone()).indented());
        }
    }
    Message::lines(lines)
}

/// Word for a finding's severity at the command line.
pub fn severity_word(finding: &Finding) -> String {
    severity(finding).to_string()
}

fn severity(finding: &Finding) -> Message {
    Message::new(match finding.severity() {
        Severity::Error => "project-severity-error",
        Severity::Warning => "project-severity-warning",
        Severity::Note => "project-severity-note",
    })
}

/// Positions of a group's findings: `pass 1, s = 3.000 to 5.000 mm; passes 2 to 14, s = 0.000 mm`.
pub fn places(group: &FindingGroup<'_>) -> Message {
    let shown = group.places.iter().take(MAX_PLACES).map(place_message);
    let more = group.places.len().saturating_sub(MAX_PLACES);
    let more = (more > 0).then(|| Message::new("project-more-places").count("places", more));
    let both = |first, then| Message::new("project-places").message("first", first).message("then", then);
    shown.chain(more).reduce(both).unwrap_or_default()
}

/// A range of path length in one or several passes.
fn place_message(place: &FindingPlace) -> Message {
    let passes = match (place.first_pass, place.last_pass) {
        (first, last) if first == last => Message::new("project-pass").pass("pass", first),
        (first, last) => Message::new("project-passes").pass("first", first).pass("last", last),
    };
    match place.is_point() {
        true => Message::new("project-place").message("passes", passes).quantity("s", place.from_mm, Unit::Mm, 3),
        false => {
            let range = Message::new("project-place-range").message("passes", passes);
            range.number("from", place.from_mm, 3).quantity("to", place.to_mm, Unit::Mm, 3)
        }
    }
}

/// Two lines: `message`, and the allowed values.
pub fn with_allowed(message: Message, allowed: impl Into<Message>) -> Message {
    let allowed = Message::new("document-allowed").message("allowed", allowed.into());
    Message::new("project-with-allowed").message("message", message).message("allowed", allowed)
}

/// Messages that only arrange others, with the argument that is the fault.
const FRAMES: [(&str, &str); 4] = [
    ("project-with-allowed", "message"),
    ("project-with-hint", "message"),
    ("cli-with-cure", "failure"),
    ("cli-two-lines", "first"),
];

/// Arguments with a fault in messages that say where it is.
const FAULTS: [&str; 3] = ["fault", "message", "why"];

/// Code of the innermost message that names the fault; none if all words come from outside.
fn code_of(message: &Message) -> Option<String> {
    let within = |name: &str| match message.argument(name) {
        Some(Argument::Message(fault)) => code_of(fault),
        _ => None,
    };
    if let Some((_, fault)) = FRAMES.iter().find(|(code, _)| *code == message.code) {
        return within(fault);
    }
    let own = || if message.is_verbatim() { None } else { Some(message.code.to_string()) };
    FAULTS.into_iter().find_map(within).or_else(own)
}

/// Two lines: `message`, and a hint.
pub(crate) fn with_hint(message: Message, hint: Message) -> Message {
    Message::new("project-with-hint").message("message", message).message("hint", hint)
}

impl From<DocumentError> for Failure {
    fn from(e: DocumentError) -> Self {
        Self::Document(Box::new(e))
    }
}

impl From<io::Error> for Failure {
    fn from(e: io::Error) -> Self {
        match e.kind() {
            io::ErrorKind::BrokenPipe => Self::ReaderGone,
            io::ErrorKind::InvalidData => {
                Self::Input(Message::new("project-standard-input").message("why", Message::outside(&e)))
            }
            _ => Self::Environment(Message::outside(&e)),
        }
    }
}

impl From<seamwright_frames::FrameError> for Failure {
    fn from(e: seamwright_frames::FrameError) -> Self {
        if e.is_environment() { Self::Environment(e.message()) } else { Self::Input(e.message()) }
    }
}

impl From<seamwright_executive::Error> for Failure {
    fn from(e: seamwright_executive::Error) -> Self {
        match e {
            seamwright_executive::Error::Drive { .. } => {
                Self::Input(Message::new("project-in-machine-file").message("why", e.message()))
            }
            seamwright_executive::Error::Values(_) => Self::Input(e.message()),
        }
    }
}

impl From<seamwright_simulation::Error> for Failure {
    fn from(e: seamwright_simulation::Error) -> Self {
        match e {
            seamwright_simulation::Error::Cell(e) => e.into(),
            e => Self::Input(e.message()),
        }
    }
}

impl From<seamwright_teaching::Error> for Failure {
    fn from(e: seamwright_teaching::Error) -> Self {
        match e {
            seamwright_teaching::Error::Document(e) => Self::Document(e),
            seamwright_teaching::Error::Findings(findings) => Self::Findings(findings),
            seamwright_teaching::Error::Refused(message) => Self::Input(message),
        }
    }
}

impl From<seamwright_record::Error> for Failure {
    fn from(e: seamwright_record::Error) -> Self {
        if e.is_input() { Self::Input(e.message()) } else { Self::Environment(e.message()) }
    }
}

impl Failure {
    /// Bad input or usage.
    pub fn input(message: impl Into<Message>) -> Self {
        Self::Input(message.into())
    }

    /// Bad input or usage, with the allowed values.
    pub fn refused(message: Message, allowed: impl Into<Message>) -> Self {
        Self::Input(with_allowed(message, allowed))
    }

    /// A device or the environment failed.
    pub fn environment(message: impl Into<Message>) -> Self {
        Self::Environment(message.into())
    }

    /// The exit code of a command that ends so: 0 done, 1 cannot be welded as asked, 2 bad input, 3 the environment
    /// failed. A file that was named and is not there is bad input.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::ReaderGone => 0,
            Self::Findings(_) | Self::Printed => 1,
            Self::Input(_) | Self::Document(_) => 2,
            _ => 3,
        }
    }

    /// Fault and allowed values, separately.
    pub(crate) fn fault_and_allowed(&self) -> (Message, Message) {
        let part = |message: &Message, name| match message.argument(name) {
            Some(Argument::Message(part)) if message.code == "project-with-allowed" => Some((**part).clone()),
            _ => None,
        };
        let allowed = |message: &Message| match part(message, "allowed")?.argument("allowed") {
            Some(Argument::Message(allowed)) => Some((**allowed).clone()),
            _ => None,
        };
        match self {
            Self::Document(e) => {
                let fault = Message::new("project-document-fault").text("file", &e.file).key("key", &e.key);
                let fault = fault.number("line", e.line as f64, 0).message("message", e.message.clone());
                (fault, e.allowed.clone().unwrap_or_default())
            }
            Self::Input(message) => {
                (part(message, "message").unwrap_or(message.clone()), allowed(message).unwrap_or_default())
            }
            other => (other.message(), Message::default()),
        }
    }

    /// Description of the failure.
    pub fn message(&self) -> Message {
        match self {
            Self::Findings(findings) => findings_message(findings),
            Self::Input(message) | Self::Environment(message) => message.clone(),
            Self::Document(error) => error.to_message(),
            Self::Cancelled => Message::new("project-planning-cancelled"),
            Self::Printed | Self::ReaderGone => Message::new("project-failed"),
        }
    }

    /// Code to look up, unless the words of the failure contain it, or come from outside.
    pub fn code(&self) -> Option<String> {
        match self {
            Self::Input(_) | Self::Environment(_) | Self::Cancelled => code_of(&self.message()),
            Self::Findings(_) | Self::Printed | Self::Document(_) | Self::ReaderGone => None,
        }
    }

    /// Words of the failure in `language`.
    pub fn text_in(&self, language: Language) -> String {
        self.message().in_language(language).trim_end().to_owned()
    }

    /// Words of the failure.
    pub fn text(&self) -> String {
        self.message().to_string().trim_end().to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_program::PathRange;

    #[test]
    fn the_code_of_a_failure_is_that_of_its_innermost_fault() {
        let option = |fault| Message::new("cli-option").text("option", "--points 1").message("fault", fault);
        let unreadable = Message::new("project-unreadable").text("file", "a.csv");
        for (failure, code) in [
            (Failure::refused(option(Message::new("cli-not-allowed")), "2 to 9"), Some("cli-not-allowed")),
            (Failure::input(option(Message::verbatim("odd"))), Some("cli-option")),
            (Failure::input(unreadable.message("why", Message::verbatim("gone"))), Some("project-unreadable")),
            (Failure::refused(Message::verbatim("odd"), "even"), None),
            (Failure::environment("the disk is full"), None),
            (Failure::Cancelled, Some("project-planning-cancelled")),
            (Failure::Printed, None),
        ] {
            assert_eq!(failure.code().as_deref(), code, "{failure}");
        }
    }

    #[test]
    fn equal_findings_are_printed_once_with_where_they_are() {
        let at = |pass, from_mm, to_mm| {
            Finding::note("process", Message::verbatim("no gas"), pass, PathRange { from_mm, to_mm })
        };
        let mut findings: Vec<Finding> = (1..=9).map(|pass| at(pass, 0.0, 0.0)).collect();
        findings.extend((1..=7).map(|i| at(3, 10.0 * f64::from(i), 10.0 * f64::from(i) + 1.0)));
        let mut out = Vec::new();
        write_findings(&mut out, &findings).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert_eq!(text.matches("no gas").count(), 1, "{text}");
        let places = "where: passes 1 to 9, s = 0.000 mm; pass 3, s = 10.000 to 11.000 mm; ";
        assert!(text.contains(places) && text.contains("; 2 more places\n"), "{text}");
        assert!(!text.contains("cure"), "{text}");
    }
}
