//! Edits of a program file, and its history.

mod journal;
mod operation;

use crate::args::edit::{EditArgs, EditVerb};
use crate::rows::{print_json, print_text};
use seamwright_message::{Language, Message};
use seamwright_program::Program;
use seamwright_program::edit::{Editor, History, Operation, Patch, Report};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_weld::Job;
use serde_json::{Value, json};
use std::io::{self, Write as _};
use std::path::Path;

pub(crate) fn run(args: &EditArgs) -> Result<(), Failure> {
    match (&args.operation, &args.script) {
        (Some(EditVerb::History), None) => history(args),
        (Some(EditVerb::Undo(step)), None) => back(args, step.force, &UNDO, Editor::undo),
        (Some(EditVerb::Redo(step)), None) => back(args, step.force, &REDO, Editor::redo),
        (Some(verb), None) => edit(args, &operation::operation(verb)?.into_iter().collect::<Vec<_>>()),
        (None, Some(script)) => edit(args, &operation::json::<Vec<Operation>>(script)?),
        _ => Err(Failure::refused(Message::new("cli-edit-no-operation"), Message::new("cli-edit-operations"))),
    }
}

fn edit(args: &EditArgs, operations: &[Operation]) -> Result<(), Failure> {
    let name = args.file.display().to_string();
    let text = read_program(&args.file)?;
    let (history, is_same) = journal::read(&args.file, &text)?;
    if !is_same {
        // Errors are ignored: standard error may be closed.
        let _ = writeln!(io::stderr(), "{}", Message::new("cli-edit-new-history").text("file", &name));
    }
    let mut editor = Editor::with_history(&name, &text, if is_same { history } else { History::default() })?;
    let reports = editor.apply_all(operations).map_err(|(i, e)| {
        let why = Message::outside(&e);
        let of = |why| Message::new("cli-edit-of-operation").number("number", (i + 1) as f64, 0).message("why", why);
        Failure::input(if operations.len() > 1 { of(why) } else { why })
    })?;
    finish(args, &text, &editor, &reports)
}

/// Reads the text of a program; refuses a job, which has no passes to be edited yet.
fn read_program(file: &Path) -> Result<String, Failure> {
    let text = files::read(file)?;
    if Job::read(&file.display().to_string(), &text).is_err() || Program::is_in(&text) {
        return Ok(text);
    }
    let stem = file.file_stem().unwrap_or(file.as_os_str()).display();
    let file = file.display().to_string();
    let plan = Message::new("cli-edit-plan-first").text("file", &file);
    let plan = plan.text("program", format!("out/{stem}/program.toml"));
    Err(Failure::refused(Message::new("cli-edit-job").text("file", file), plan))
}

/// Codes of the words of a step through the history.
struct Step {
    done: &'static str,
    nothing: &'static str,
}

const UNDO: Step = Step { done: "cli-edit-undone", nothing: "cli-edit-nothing-to-undo" };
const REDO: Step = Step { done: "cli-edit-redone", nothing: "cli-edit-nothing-to-redo" };

/// Undoes an edit, or makes it again.
fn back(
    args: &EditArgs,
    force: bool,
    how: &Step,
    step: fn(&mut Editor) -> Result<Option<Message>, seamwright_document::DocumentError>,
) -> Result<(), Failure> {
    let name = args.file.display().to_string();
    let text = read_program(&args.file)?;
    let (history, is_same) = journal::read(&args.file, &text)?;
    if !is_same && !force {
        let message = Message::new("cli-edit-by-hand").text("file", name);
        return Err(Failure::refused(message, Message::new("cli-edit-force")));
    }
    let mut editor = Editor::with_history(&name, &text, history)?;
    let Some(words) = step(&mut editor)? else {
        let message = Message::new(how.nothing).text("file", name);
        return Err(Failure::refused(message, Message::new("cli-edit-see-history")));
    };
    let report = Report { words: Message::new(how.done).message("edit", words), changed: true, touched: Vec::new() };
    finish(args, &text, &editor, &[report])
}

fn finish(args: &EditArgs, before: &str, editor: &Editor, reports: &[Report]) -> Result<(), Failure> {
    match &args.output {
        _ if args.dry_run => {}
        Some(path) => files::write(path, editor.text())?,
        None if editor.text() != before => journal::write(&args.file, editor)?,
        None => {}
    }
    if args.json {
        let difference: Vec<String> = if args.dry_run { difference(before, editor.text()) } else { Vec::new() };
        return print_json(&json!({
            "file": args.output.as_ref().unwrap_or(&args.file),
            "written": !args.dry_run && (args.output.is_some() || editor.text() != before),
            "reports": reports,
            "difference": difference,
        }));
    }
    let line = |report: &Report| match report.changed {
        true => format!("{}\n", report.words),
        false => format!("{}\n", Message::new("cli-edit-unchanged").message("edit", report.words.clone())),
    };
    let mut out: String = reports.iter().map(line).collect();
    if args.dry_run {
        difference(before, editor.text()).iter().for_each(|line| out.extend([line, "\n"]));
    }
    print_text(&out)
}

/// Removed and added lines, with their numbers; common lines at both ends are left out.
fn difference(before: &str, after: &str) -> Vec<String> {
    let (old, new): (Vec<&str>, Vec<&str>) = (before.lines().collect(), after.lines().collect());
    let first = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let (old, new) = (&old[first..], &new[first..]);
    let last = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
    let (old, new) = (&old[..old.len() - last], &new[..new.len() - last]);
    let line = |sign: char, i: usize, text: &str| format!("{sign}{:>5} | {text}", first + i + 1);
    if old.len() == new.len() {
        let pairs = old.iter().zip(new).enumerate().filter(|(_, (a, b))| a != b);
        return pairs.flat_map(|(i, (a, b))| [line('-', i, a), line('+', i, b)]).collect();
    }
    let gone = old.iter().enumerate().map(|(i, text)| line('-', i, text));
    gone.chain(new.iter().enumerate().map(|(i, text)| line('+', i, text))).collect()
}

fn history(args: &EditArgs) -> Result<(), Failure> {
    let text = read_program(&args.file)?;
    let (history, is_same) = journal::read(&args.file, &text)?;
    let names = |patches: &[Patch]| -> Vec<Value> {
        patches.iter().map(|p| p.name.in_language(Language::English).into()).collect()
    };
    if args.json {
        let (done, undone) = (names(history.done()), names(history.undone()));
        return print_json(&json!({ "done": done, "undone": undone, "changed_by_hand": !is_same }));
    }
    let mut out = String::new();
    for (i, patch) in history.done().iter().enumerate() {
        out += &format!("{:>4}  {}\n", i + 1, patch.name);
    }
    for patch in history.undone() {
        let undone = Message::new("cli-edit-undone-entry").message("edit", patch.name.clone());
        out += &format!("   -  {undone}\n");
    }
    if !is_same {
        out += &format!("{}\n", Message::new("cli-edit-by-hand-since"));
    }
    if out.is_empty() {
        out = format!("{}\n", Message::new("cli-edit-none"));
    }
    print_text(&out)
}
