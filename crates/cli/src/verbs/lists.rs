use crate::args::ListArgs;
use crate::labels::{columns, padded};
use crate::rows::{print_json, print_text};
use seamwright_machine::{Machine, SHIPPED};
use seamwright_message::Message;
use seamwright_program::{PROCEDURES, Procedure};
use seamwright_project::examples::EXAMPLES;
use seamwright_project::failure::Failure;
use seamwright_weld::Welding;
use serde::Serialize;
use std::fmt::Write;

#[derive(Serialize)]
struct Entry {
    name: &'static str,
    title: String,
    detail: String,
}

pub(crate) fn machines(args: &ListArgs) -> Result<(), Failure> {
    let texts: Vec<_> = SHIPPED.iter().map(|s| (s.name, s.text)).collect();
    let describe = |name: &str, text: &str| -> Result<(String, String), Failure> {
        let machine = Machine::read(name, text)?;
        let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
        Ok((machine.title, axes.join(" ")))
    };
    list(args, &MACHINES, &texts, describe)
}

pub(crate) fn examples(args: &ListArgs) -> Result<(), Failure> {
    let texts: Vec<_> = EXAMPLES.iter().map(|e| (e.name, e.text)).collect();
    let describe = |name: &str, text: &str| -> Result<(String, String), Failure> {
        let program = Welding::read(name, text)?.program.value;
        Ok((program.title, program.machine))
    };
    list(args, &EXAMPLE_JOBS, &texts, describe)
}

pub(crate) fn procedures(args: &ListArgs) -> Result<(), Failure> {
    let texts: Vec<_> = PROCEDURES.iter().map(|p| (p.name, p.text)).collect();
    let describe = |name: &str, text: &str| -> Result<(String, String), Failure> {
        let procedure = Procedure::read(name, text)?.value;
        Ok((procedure.title, format!("{} {}", procedure.process.number, procedure.process.name)))
    };
    list(args, &SPECIFICATIONS, &texts, describe)
}

/// Codes of a list's words.
struct Words {
    /// Headings of the columns.
    name: &'static str,
    detail: &'static str,
    /// Error for an unknown name.
    missing: &'static str,
}

const MACHINES: Words = Words { name: "cli-list-machine", detail: "cli-list-axes", missing: "cli-no-machine" };
const EXAMPLE_JOBS: Words = Words { name: "cli-list-example", detail: "cli-list-machine", missing: "cli-no-example" };
const SPECIFICATIONS: Words =
    Words { name: "cli-list-procedure", detail: "cli-list-process", missing: "cli-no-procedure" };

/// Prints the list, or the text of the one that is named.
fn list(
    args: &ListArgs,
    words: &Words,
    texts: &[(&'static str, &'static str)],
    describe: impl Fn(&str, &str) -> Result<(String, String), Failure>,
) -> Result<(), Failure> {
    if let Some(wanted) = &args.name {
        let found = texts.iter().find(|(name, _)| name == wanted);
        let names = || texts.iter().map(|t| t.0).collect::<Vec<_>>().join(", ");
        let missing = || Failure::refused(Message::new(words.missing).text("name", wanted), names());
        return found.ok_or_else(missing).and_then(|(_, text)| print_text(text));
    }
    let mut entries = Vec::new();
    for &(name, text) in texts {
        let (title, detail) = describe(name, text)?;
        entries.push(Entry { name, title, detail });
    }
    if args.json {
        return print_json(&entries);
    }
    let width = entries.iter().map(|e| columns(&e.detail) + 2).fold(22, usize::max);
    let [name, detail] = [words.name, words.detail].map(|code| Message::new(code).to_string());
    let title = Message::new("cli-list-title");
    let mut text = format!("{}{}{title}\n", padded(&name, 22), padded(&detail, width));
    for e in &entries {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{}{}{}", padded(e.name, 22), padded(&e.detail, width), e.title);
    }
    print_text(&text)
}
