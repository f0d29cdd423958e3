//! Audit log and alarms as JSON lines, for other programs.

use super::data::open;
use crate::args::records::LinesArgs;
use crate::refusals::not_json;
use seamwright_project::failure::Failure;
use seamwright_record::library::Span;
use serde::Serialize;
use std::io::{BufWriter, StdoutLock, Write};

/// Lines on standard output.
struct Lines(BufWriter<StdoutLock<'static>>);

impl Lines {
    fn new() -> Self {
        Self(BufWriter::new(std::io::stdout().lock()))
    }

    fn line(&mut self, of: &impl Serialize) -> Result<(), Failure> {
        serde_json::to_writer(&mut self.0, of).map_err(|e| match e.io_error_kind() {
            Some(kind) => Failure::from(std::io::Error::from(kind)),
            None => not_json(e),
        })?;
        Ok(self.0.write_all(b"\n")?)
    }
}

fn span(args: &LinesArgs) -> Span {
    let all = Span::default();
    Span {
        after: args.after.unwrap_or(all.after),
        since: args.since.unwrap_or(all.since),
        until: args.until.unwrap_or(all.until),
    }
}

pub(super) fn audit(args: &LinesArgs) -> Result<(), Failure> {
    let (data, mut lines) = (open(args.data.as_deref())?, Lines::new());
    data.library().export_audit(&span(args), |entry| lines.line(entry))?;
    Ok(lines.0.flush()?)
}

pub(super) fn alarms(args: &LinesArgs) -> Result<(), Failure> {
    let (data, mut lines) = (open(args.data.as_deref())?, Lines::new());
    data.library().export_alarms(&span(args), |alarm| lines.line(alarm))?;
    Ok(lines.0.flush()?)
}
