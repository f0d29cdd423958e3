use crate::args::CheckArgs;
use crate::planning;
use crate::refusals::error_text;
use crate::rows::{print_json, print_text};
use seamwright_message::{Language, Message};
use seamwright_program::Finding;
use seamwright_project::failure::{Failure, write_findings};
use serde_json::{Value, json};
use std::io;
use std::path::Path;

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    let [job] = args.jobs.as_slice() else { return several(args) };
    let findings = check(job, args)?;
    let printed = if args.json {
        print_json(&findings)
    } else {
        write_findings(&mut io::stdout().lock(), &findings).map_err(Failure::from)
    };
    read_or_not(printed)?;
    if against(&findings) { Err(Failure::Printed) } else { Ok(()) }
}

/// The exit code is the answer, even without a reader of the output.
fn read_or_not(printed: Result<(), Failure>) -> Result<(), Failure> {
    match printed {
        Err(Failure::ReaderGone) => Ok(()),
        printed => printed,
    }
}

fn check(job: &Path, args: &CheckArgs) -> Result<Vec<Finding>, Failure> {
    let loaded = planning::load(job, &args.planning)?;
    Ok(planning::try_plan(&loaded, &args.planning)?.map_or_else(|findings| findings, |motion| motion.findings))
}

fn against(findings: &[Finding]) -> bool {
    findings.iter().any(|f| !f.allowed)
}

/// Checks several jobs, also those after an invalid one; the maximum exit code counts.
fn several(args: &CheckArgs) -> Result<(), Failure> {
    let mut worst = Ok(());
    let mut all: Vec<Value> = Vec::new();
    for job in &args.jobs {
        let checked = check(job, args);
        if args.json {
            all.push(as_json(job, &checked));
        } else {
            read_or_not(print_text(&as_text(job, &checked)))?;
        }
        let failure = match checked {
            Ok(findings) if !against(&findings) => continue,
            Ok(_) => Failure::Printed,
            Err(failure) => failure,
        };
        if worst.as_ref().map_or_else(Failure::exit_code, |()| 0) < failure.exit_code() {
            worst = Err(failure);
        }
    }
    if args.json {
        read_or_not(print_json(&all))?;
    }
    // Each error was reported with its job.
    match worst {
        Err(Failure::Input(_) | Failure::Document(_)) => Err(Failure::input(Message::new("cli-jobs-unreadable"))),
        worst => worst,
    }
}

fn as_json(job: &Path, checked: &Result<Vec<Finding>, Failure>) -> Value {
    match checked {
        Ok(findings) => json!({ "job": job, "findings": findings }),
        Err(failure) => json!({ "job": job, "error": failure.text_in(Language::English) }),
    }
}

fn as_text(job: &Path, checked: &Result<Vec<Finding>, Failure>) -> String {
    let mut text = format!("{}: ", job.display()).into_bytes();
    match checked {
        // Writing to memory cannot fail.
        Ok(findings) => drop(write_findings(&mut text, findings)),
        Err(failure) => text.extend(error_text(failure).bytes()),
    }
    String::from_utf8_lossy(&text).into_owned()
}
