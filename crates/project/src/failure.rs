//! Why a command ends without doing what was asked.

use seamwright_document::DocumentError;
use seamwright_program::{Finding, Severity};
use std::io::{self, Write};

/// Why the command ends without doing what was asked, by exit code.
#[derive(Debug)]
pub enum Failure {
    /// 1: the job is understood but cannot be welded as asked.
    Findings(Vec<Finding>),
    /// 1: the same, and the findings have been printed already.
    Printed,
    /// 2: bad input or usage.
    Input(String),
    /// 2: the same, of a file that says where.
    Document(Box<DocumentError>),
    /// 3: a device or the environment failed.
    Environment(String),
    /// 3: planning was cancelled.
    Cancelled,
    /// 0: whoever reads our output has stopped reading.
    ReaderGone,
}

/// Findings for people, the forbidding ones first.
pub fn write_findings(out: &mut impl Write, findings: &[Finding]) -> io::Result<()> {
    let forbidding = findings.iter().filter(|f| !f.allowed).count();
    match forbidding {
        0 if findings.is_empty() => writeln!(out, "the weld can be made as asked")?,
        0 => writeln!(out, "the weld can be made, with remarks")?,
        1 => writeln!(out, "the weld cannot be made as asked: 1 finding")?,
        n => writeln!(out, "the weld cannot be made as asked: {n} findings")?,
    }
    let (allowed, not): (Vec<&Finding>, Vec<&Finding>) = findings.iter().partition(|f| f.allowed);
    for f in not.into_iter().chain(allowed) {
        let word = match f.severity() {
            Severity::Error => "finding",
            Severity::Warning => "warning",
            Severity::Note => "note",
        };
        writeln!(out, "{word} ({}): {}", f.kind, f.message)?;
        let place = if f.to_mm > f.from_mm {
            format!("{:.3} to {:.3}", f.from_mm, f.to_mm)
        } else {
            format!("{:.3}", f.from_mm)
        };
        writeln!(out, "   where: pass {}, s = {place} mm", f.pass)?;
        if !f.cure.is_empty() {
            writeln!(out, "   cure: {}", f.cure)?;
        }
    }
    Ok(())
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
    /// What is wrong, in words.
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
