use crate::args::ListArgs;
use crate::examples::EXAMPLES;
use crate::failure::Failure;
use crate::rows::{print_json, print_text};
use seamwright_machine::{Machine, SHIPPED};
use seamwright_program::{PROCEDURES, Procedure};
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
    list(args, "machine", "axes", &texts, describe)
}

pub(crate) fn examples(args: &ListArgs) -> Result<(), Failure> {
    let texts: Vec<_> = EXAMPLES.iter().map(|e| (e.name, e.text)).collect();
    let describe = |name: &str, text: &str| -> Result<(String, String), Failure> {
        let program = Welding::read(name, text)?.program.value;
        Ok((program.title, program.machine))
    };
    list(args, "example", "machine", &texts, describe)
}

pub(crate) fn procedures(args: &ListArgs) -> Result<(), Failure> {
    let texts: Vec<_> = PROCEDURES.iter().map(|p| (p.name, p.text)).collect();
    let describe = |name: &str, text: &str| -> Result<(String, String), Failure> {
        let procedure = Procedure::read(name, text)?.value;
        Ok((procedure.title, format!("{} {}", procedure.process.number, procedure.process.name)))
    };
    list(args, "procedure", "process", &texts, describe)
}

/// Prints the list, or the text of the one that is named.
fn list(
    args: &ListArgs,
    what: &str,
    detail: &str,
    texts: &[(&'static str, &'static str)],
    describe: impl Fn(&str, &str) -> Result<(String, String), Failure>,
) -> Result<(), Failure> {
    if let Some(wanted) = &args.name {
        let found = texts.iter().find(|(name, _)| name == wanted);
        let names = || texts.iter().map(|t| t.0).collect::<Vec<_>>().join(", ");
        let missing = || Failure::input(format!("{wanted}: there is no such {what}\n   allowed: {}", names()));
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
    let width = entries.iter().map(|e| e.detail.len() + 2).fold(22, usize::max);
    let mut text = format!("{what:<22}{detail:<width$}title\n");
    for e in &entries {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{:<22}{:<width$}{}", e.name, e.detail, e.title);
    }
    print_text(&text)
}
