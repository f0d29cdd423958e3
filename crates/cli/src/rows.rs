//! Tables on standard output, streamed as CSV or as a JSON array of objects.

use crate::refusals::not_json;
use seamwright_message::{Language, Message};
use seamwright_project::failure::Failure;
use serde::{Serialize as _, Serializer};
use std::borrow::Cow;
use std::io::{self, BufWriter, StdoutLock, Write};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell<'a> {
    Number(f64),
    Count(u64),
    Text(&'a str),
    Empty,
}

impl From<f64> for Cell<'_> {
    fn from(v: f64) -> Self {
        Self::Number(v)
    }
}

pub(crate) struct Rows {
    out: BufWriter<StdoutLock<'static>>,
    columns: Vec<String>,
    json: bool,
    /// The header has been written.
    begun: bool,
    rows: u64,
}

impl Rows {
    /// Creates a table. Its header is written with the first row, or at the end, so that bad input gives no output.
    pub(crate) fn new(columns: Vec<String>, json: bool) -> Self {
        let out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
        Self { out, columns, json, begun: false, rows: 0 }
    }

    pub(crate) fn with_header(header: &str, json: bool) -> Self {
        Self::new(header.split(',').map(str::to_owned).collect(), json)
    }

    fn begin(&mut self) -> Result<(), Failure> {
        match (std::mem::replace(&mut self.begun, true), self.json) {
            (true, _) => {}
            (false, true) => self.out.write_all(b"[")?,
            (false, false) => writeln!(self.out, "{}", self.columns.join(","))?,
        }
        Ok(())
    }

    pub(crate) fn row(&mut self, cells: &[Cell]) -> Result<(), Failure> {
        self.begin()?;
        if self.json {
            self.json_row(cells)?;
        } else {
            for (i, cell) in cells.iter().enumerate() {
                if i > 0 {
                    self.out.write_all(b",")?;
                }
                match cell {
                    // Rounding left over from a zero, without thirty decimals.
                    Cell::Number(v) if *v != 0.0 && v.abs() < 1e-5 => write!(self.out, "{v:e}")?,
                    // `+ 0.0` turns a negative zero into zero.
                    Cell::Number(v) => write!(self.out, "{}", v + 0.0)?,
                    Cell::Count(n) => write!(self.out, "{n}")?,
                    Cell::Text(t) => self.out.write_all(field(t).as_bytes())?,
                    Cell::Empty => {}
                }
            }
            self.out.write_all(b"\n")?;
        }
        self.rows += 1;
        Ok(())
    }

    fn json_row(&mut self, cells: &[Cell]) -> Result<(), Failure> {
        self.out.write_all(if self.rows > 0 { b",\n " } else { b"\n " })?;
        let object: serde_json::Map<String, serde_json::Value> = self
            .columns
            .iter()
            .zip(cells)
            .map(|(name, cell)| {
                let value = match cell {
                    Cell::Number(v) => serde_json::Value::from(v + 0.0),
                    Cell::Count(n) => serde_json::Value::from(*n),
                    Cell::Text(t) => serde_json::Value::from(*t),
                    Cell::Empty => serde_json::Value::Null,
                };
                (name.clone(), value)
            })
            .collect();
        serde_json::to_writer(&mut self.out, &object).map_err(io::Error::from)?;
        Ok(())
    }

    /// Makes all rows so far visible to readers.
    pub(crate) fn flush(&mut self) -> Result<(), Failure> {
        Ok(self.out.flush()?)
    }

    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.begin()?;
        if self.json {
            self.out.write_all(b"\n]\n")?;
        }
        self.out.flush()?;
        Ok(())
    }
}

/// First characters that make a formula of a cell in spreadsheets. Such a formula may run programs or send the
/// neighbouring cells elsewhere (OWASP, "CSV Injection").
const FORMULA: [char; 6] = ['=', '+', '-', '@', '\t', '\r'];

/// A text as a CSV field; an apostrophe before a text that looks like a formula keeps it a text.
fn field(text: &str) -> Cow<'_, str> {
    let is_number = text.parse::<f64>().is_ok();
    let text: Cow<'_, str> =
        if text.starts_with(FORMULA) && !is_number { format!("'{text}").into() } else { text.into() };
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")).into(),
        false => text,
    }
}

pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    serde_json::to_writer_pretty(&mut out, value).map_err(io::Error::from)?;
    writeln!(out)?;
    Ok(())
}

pub(crate) fn json_text(value: &impl serde::Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value).map(|json| json + "\n").map_err(not_json)
}

pub(crate) fn print_either(
    json: bool,
    value: &impl serde::Serialize,
    text: impl FnOnce() -> String,
) -> Result<(), Failure> {
    if json { print_json(value) } else { print_text(&text()) }
}

/// Writes a message in English, the language of data.
pub(crate) fn in_english<S: Serializer>(message: &Option<Message>, out: S) -> Result<S::Ok, S::Error> {
    message.as_ref().map(|message| message.in_language(Language::English)).serialize(out)
}

pub(crate) fn print_text(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::field;

    #[test]
    fn texts_are_no_formulas() {
        for (text, wanted) in [
            ("N-17", "N-17"),
            ("=1+1", "'=1+1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
            ("-2+3,5", "\"'-2+3,5\""),
            ("=HYPERLINK(\"http://x\")", "\"'=HYPERLINK(\"\"http://x\"\")\""),
            ("\t=1", "'\t=1"),
            ("\r=1", "\"'\r=1\""),
            ("-12.5", "-12.5"),
            ("a\nb", "\"a\nb\""),
            ("", ""),
        ] {
            assert_eq!(field(text), wanted);
        }
    }
}
