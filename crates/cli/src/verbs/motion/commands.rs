//! An operator's commands from a file.

use crate::refusals::unreadable;
use seamwright_message::{Message, Unit};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

/// Latest command, s: a day.
const LATEST_S: f64 = 86_400.0;
const COLUMNS: [&str; 3] = ["t_s", "command", "value"];
/// Minimum feed override, percent; lower ones hold.
pub(super) const MIN_OVERRIDE: f64 = 0.1;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Command {
    /// Percent of the planned speed.
    Override(f64),
    Hold,
    Resume,
    Reverse,
    /// Weld on by so many mm and hold.
    Step(f64),
    Abort,
}

/// A command and when it is given, s from the first set-point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Timed {
    pub(super) t: f64,
    pub(super) command: Command,
}

pub(super) fn read(file: &Path) -> Result<Vec<Timed>, Failure> {
    let source = file.display().to_string();
    let input = File::open(file).map_err(|e| unreadable(&source, &e))?;
    parse(&source, BufReader::new(input))
}

fn parse(source: &str, input: impl BufRead) -> Result<Vec<Timed>, Failure> {
    let (mut reader, _) = CsvReader::open(source, input, &[&COLUMNS])?;
    let mut all: Vec<Timed> = Vec::new();
    let mut stopped = false;
    while let Some(row) = reader.texts() {
        let row = row?;
        let [time, name, value] = [&row[0], &row[1], &row[2]];
        let last = all.last().map_or(0.0, |c| c.t);
        let t = number(time).filter(|t| *t >= last && *t <= LATEST_S).ok_or_else(|| {
            let allowed = Message::new("cli-command-time").value("from", last, Unit::One);
            let allowed = allowed.value("to", LATEST_S, Unit::One);
            reader.error("t_s", time, Message::new("cli-not-allowed"), allowed)
        })?;
        let command = command(name, value).map_err(|wrong| match wrong {
            Wrong::Command => {
                let fault = Message::new("cli-not-a-command");
                reader.error("command", name, fault, "override, hold, resume, reverse, step, abort")
            }
            Wrong::Value(allowed) => {
                let fault = Message::new("cli-command-value").text("command", name);
                reader.error("value", value, fault, Message::new(allowed))
            }
        })?;
        match command {
            Command::Override(percent) => stopped = percent < MIN_OVERRIDE,
            Command::Resume | Command::Step(_) if stopped => {
                let allowed = Message::new("cli-command-override-first").value("min", MIN_OVERRIDE, Unit::Percent);
                return Err(reader.error("command", name, Message::new("cli-command-without-speed"), allowed));
            }
            _ => {}
        }
        all.push(Timed { t, command });
    }
    Ok(all)
}

/// Fault of a row: its command, or its value (with the code of the allowed values).
enum Wrong {
    Command,
    Value(&'static str),
}

fn command(name: &str, value: &str) -> Result<Command, Wrong> {
    let plain = match name {
        "override" => {
            let percent = number(value).filter(|v| (0.0..=150.0).contains(v));
            return percent.map(Command::Override).ok_or(Wrong::Value("cli-command-percent"));
        }
        "step" => {
            let mm = number(value).filter(|v| *v >= 0.001);
            return mm.map(Command::Step).ok_or(Wrong::Value("cli-command-step"));
        }
        "hold" => Command::Hold,
        "resume" => Command::Resume,
        "reverse" => Command::Reverse,
        "abort" => Command::Abort,
        _ => return Err(Wrong::Command),
    };
    if value.is_empty() { Ok(plain) } else { Err(Wrong::Value("cli-command-nothing")) }
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|v: &f64| v.is_finite())
}
