//! Tables as files.

use crate::failure::Failure;
use seamwright_message::Message;
use std::io::{BufRead, Lines};

/// Rows of numbers (or texts) from CSV with a header line; columns in any order, others ignored. One line at a time is
/// in memory.
pub struct CsvReader<R> {
    source: String,
    lines: Lines<R>,
    header: Vec<String>,
    names: Vec<String>,
    /// Index of each name in a line.
    places: Vec<usize>,
    values: Vec<f64>,
    line: u64,
}

impl<R: BufRead> CsvReader<R> {
    /// A reader of `source` (its name, for messages) with the first of the sets of columns `wanted` that its header
    /// has; and which set that is.
    pub fn open(source: &str, mut reader: R, wanted: &[&[&str]]) -> Result<(Self, usize), Failure> {
        let mut line = String::new();
        reader.read_line(&mut line)?;
        let header: Vec<&str> = line.trim_start_matches('\u{feff}').split(',').map(str::trim).collect();
        let place = |name: &&str| header.iter().position(|h| h == name);
        let complete = |names: &&[&str]| names.iter().map(place).collect::<Option<Vec<usize>>>();
        let found = wanted.iter().enumerate().find_map(|(set, names)| Some((set, *names, complete(names)?)));
        let Some((set, names, places)) = found else {
            let missing = wanted.first().and_then(|names| names.iter().find(|n| place(n).is_none())).unwrap_or(&"");
            return Err(no_column(source, missing, &header, wanted));
        };
        // Some columns of a larger set beside a smaller one: the others must have been forgotten.
        let partly = |larger: &&&[&str]| {
            let mut others = larger.iter().filter(|name| !names.contains(name));
            names.iter().all(|name| larger.contains(name)) && others.any(|name| place(name).is_some())
        };
        if let Some(name) = wanted[..set].iter().find(partly).and_then(|l| l.iter().find(|n| place(n).is_none())) {
            return Err(no_column(source, name, &header, wanted));
        }
        let names: Vec<String> = names.iter().map(|n| (*n).to_owned()).collect();
        let (source, values) = (source.to_owned(), vec![0.0; names.len()]);
        let header = header.iter().map(|name| (*name).to_owned()).collect();
        Ok((Self { source, lines: reader.lines(), header, names, places, values, line: 1 }, set))
    }

    /// A reader of `source` with the columns `wanted` first, then all others that have a name; the names of these.
    pub fn open_with_others(source: &str, reader: R, wanted: &[&str]) -> Result<(Self, Vec<String>), Failure> {
        let (mut table, _) = Self::open(source, reader, &[wanted])?;
        let others = table.header.iter().enumerate();
        let others = others.filter(|(place, name)| !name.is_empty() && !table.places.contains(place));
        let (places, others): (Vec<usize>, Vec<String>) = others.map(|(place, name)| (place, name.clone())).unzip();
        table.places.extend(places);
        table.names.extend(others.iter().cloned());
        table.values.resize(table.names.len(), 0.0);
        Ok((table, others))
    }

    /// The number of the last line read.
    pub fn line(&self) -> u64 {
        self.line
    }

    /// The next line that is not empty, if any.
    fn next_line(&mut self) -> Option<Result<String, Failure>> {
        loop {
            self.line += 1;
            match self.lines.next()? {
                Ok(line) if line.trim().is_empty() => {}
                Ok(line) => return Some(Ok(line)),
                Err(error) => return Some(Err(error.into())),
            }
        }
    }

    /// The next row as texts, empty where the line has no such column.
    pub fn texts(&mut self) -> Option<Result<Vec<String>, Failure>> {
        let line = match self.next_line()? {
            Ok(line) => line,
            Err(failure) => return Some(Err(failure)),
        };
        let field = |place: &usize| line.split(',').nth(*place).map(str::trim).unwrap_or_default().to_owned();
        Some(Ok(self.places.iter().map(field).collect()))
    }

    /// Failure for a value in a column of the line read last, with the allowed values.
    pub fn error(&self, column: &str, value: &str, fault: impl Into<Message>, allowed: impl Into<Message>) -> Failure {
        let message = Message::new("project-csv-value").text("file", &self.source).number("line", self.line as f64, 0);
        let message = message.key("column", column).text("value", value).message("fault", fault.into());
        Failure::refused(message, allowed)
    }

    /// The next row, if any; empty lines are skipped.
    pub fn row(&mut self) -> Option<Result<&[f64], Failure>> {
        let line = match self.next_line()? {
            Ok(line) => line,
            Err(failure) => return Some(Err(failure)),
        };
        let field = |place: usize| line.split(',').nth(place).map(str::trim).unwrap_or_default();
        for ((value, place), name) in self.values.iter_mut().zip(&self.places).zip(&self.names) {
            match field(*place).parse().ok().filter(|v: &f64| v.is_finite()) {
                Some(number) => *value = number,
                None => {
                    let allowed = Message::new("project-header-line").text("columns", self.names.join(","));
                    let fault = Message::new("project-not-a-finite-number");
                    return Some(Err(self.error(name, field(*place), fault, allowed)));
                }
            }
        }
        Some(Ok(&self.values))
    }
}

/// Failure for a header line without the column `missing`.
fn no_column(source: &str, missing: &str, header: &[&str], wanted: &[&[&str]]) -> Failure {
    let sets = wanted.iter().map(|names| Message::verbatim(names.join(",")));
    let either = |a: Message, b: Message| Message::new("project-or").message("first", a).message("second", b);
    let commas = header.len() == 1 && header[0].contains([';', '\t']);
    let allowed = Message::new(if commas { "project-header-line-with-commas" } else { "project-header-line" });
    let message = Message::new("project-no-column").text("file", source).key("column", missing);
    Failure::refused(
        message.text("header", header.join(",")),
        allowed.message("columns", sets.reduce(either).unwrap_or_default()),
    )
}
