//! Reasons why a command ends without its result.

use seamwright_document::DocumentError;
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
    Input(String),
    /// 2: the same, for a file with an address of the fault.
    Document(Box<DocumentError>),
    /// 3: a device or the environment failed.
    Environment(String),
    /// 3: planning was cancelled.
    Cancelled,
    /// 0: the reader of our output has stopped reading.
    ReaderGone,
}

/// Maximum number of positions listed of one finding.
const MAX_PLACES: usize = 6;

/// Findings for people, equal ones once, those that stand against the weld first.
pub fn write_findings(out: &mut impl Write, findings: &[Finding]) -> io::Result<()> {
    let groups = group_findings(findings);
    match groups.iter().filter(|group| !group.finding.allowed).count() {
        0 if findings.is_empty() => writeln!(out, "the weld can be made as asked")?,
        0 => writeln!(out, "the weld can be made, with remarks")?,
        1 => writeln!(out, "the weld cannot be made as asked: 1 finding")?,
        n => writeln!(out, "the weld cannot be made as asked: {n} findings")?,
    }
    for group in &groups {
        let f = group.finding;
        writeln!(out, "{} ({}): {}", severity_word(f), f.kind, group.message)?;
        writeln!(out, "   where: {}", places_text(group))?;
        if let Some(cure) = &group.cure {
            writeln!(out, "   cure: {cure}")?;
        }
    }
    Ok(())
}

/// Word for a finding's severity at the command line.
pub fn severity_word(finding: &Finding) -> &'static str {
    match finding.severity() {
        Severity::Error => "finding",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

/// Positions of a group's findings: `pass 1, s = 3.000 to 5.000 mm; passes 2 to 14, s = 0.000 mm`.
pub fn places_text(group: &FindingGroup<'_>) -> String {
    let text = |place: &FindingPlace| {
        let passes = match (place.first_pass, place.last_pass) {
            (first, last) if first == last => format!("pass {first}"),
            (first, last) => format!("passes {first} to {last}"),
        };
        match place.is_point() {
            true => format!("{passes}, s = {:.3} mm", place.from_mm),
            false => format!("{passes}, s = {:.3} to {:.3} mm", place.from_mm, place.to_mm),
        }
    };
    let mut places: Vec<String> = group.places.iter().take(MAX_PLACES).map(text).collect();
    match group.places.len().saturating_sub(MAX_PLACES) {
        0 => {}
        1 => places.push("1 more place".to_owned()),
        more => places.push(format!("{more} more places")),
    }
    places.join("; ")
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
            io::ErrorKind::InvalidData => Self::Input(format!("standard input: {e}")),
            _ => Self::Environment(e.to_string()),
        }
    }
}

impl From<seamwright_cell::frames::FrameError> for Failure {
    fn from(e: seamwright_cell::frames::FrameError) -> Self {
        if e.is_environment() { Self::Environment(e.to_string()) } else { Self::Input(e.to_string()) }
    }
}

impl From<seamwright_cell::Error> for Failure {
    fn from(e: seamwright_cell::Error) -> Self {
        match e {
            seamwright_cell::Error::Drive { .. } => Self::Input(format!("machine file: {e}")),
            _ => Self::Input(e.to_string()),
        }
    }
}

impl From<seamwright_cell::tracking::Error> for Failure {
    fn from(e: seamwright_cell::tracking::Error) -> Self {
        Self::Input(e.to_string())
    }
}

impl From<seamwright_record::Error> for Failure {
    fn from(e: seamwright_record::Error) -> Self {
        if e.is_input() { Self::Input(e.to_string()) } else { Self::Environment(e.to_string()) }
    }
}

impl From<seamwright_motion::textbook::Error> for Failure {
    fn from(e: seamwright_motion::textbook::Error) -> Self {
        Self::Input(e.to_string())
    }
}

impl Failure {
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

    /// Description of the failure.
    pub fn text(&self) -> String {
        match self {
            Self::Findings(findings) => {
                let mut out = Vec::new();
                // Writing to memory cannot fail.
                drop(write_findings(&mut out, findings));
                String::from_utf8_lossy(&out).trim_end().to_owned()
            }
            Self::Input(text) | Self::Environment(text) => text.trim_end().to_owned(),
            Self::Document(error) => error.to_string().trim_end().to_owned(),
            Self::Cancelled => "planning was cancelled".to_owned(),
            Self::Printed | Self::ReaderGone => "it failed".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_findings_are_printed_once_with_where_they_are() {
        let at = |pass, from_mm, to_mm| Finding::note("process", "no gas".to_owned(), pass, (from_mm, to_mm));
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
