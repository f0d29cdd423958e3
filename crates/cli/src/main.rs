//! The `seamwright` command: arguments in, one call down, text out.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod args;
mod clock;
mod interrupt;
mod labels;
mod planning;
mod progress;
mod refusals;
mod rows;
mod verbs;

use args::{Cli, ToolsVerb, Verb, VisionVerb};
use seamwright_message::{Language, Message};
use seamwright_project::failure;
use seamwright_project::failure::Failure;
use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match Cli::of_process() {
        Ok(cli) => cli,
        Err(e) => {
            // Help and version are asked for; anything else is wrong usage.
            let _ = e.print();
            return ExitCode::from(if e.use_stderr() { 2 } else { 0 });
        }
    };
    // Another process of ours reads the answers to questions: they are in no language.
    let language = match cli.verb {
        Some(Verb::AnswerOneQuestion(_) | Verb::Cell(_)) => Language::English,
        _ => choose_language(cli.language.as_deref()),
    };
    // The server renders for each of its users, and records are in no language.
    if !matches!(cli.verb, None | Some(Verb::Serve(_))) {
        language.speak();
    }
    match run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            language.speak();
            report(&failure)
        }
    }
}

/// Language of the process: `--language`, or that of the locale. Another one than ours is English, with a note.
fn choose_language(wanted: Option<&str>) -> Language {
    let of_locale = || {
        let mut locales = ["LC_ALL", "LC_MESSAGES", "LANG"].iter().filter_map(|name| std::env::var(name).ok());
        locales.find(|locale| !locale.is_empty())
    };
    let Some(locale) = wanted.map(str::to_owned).or_else(of_locale) else { return Language::English };
    Language::from_locale(&locale).unwrap_or_else(|| {
        let codes = Language::ALL.map(Language::code).join(", ");
        let note = Message::new("cli-unknown-language").text("language", locale).text("known", codes);
        // An error is ignored: standard error itself may be closed.
        let _ = writeln!(std::io::stderr().lock(), "{note}");
        Language::English
    })
}

fn run(cli: Cli) -> Result<(), Failure> {
    if let Some((former, present)) = cli.renamed {
        let note = Message::new("cli-verb-renamed").text("former", former).text("present", present);
        // An error is ignored: standard error itself may be closed.
        let _ = writeln!(std::io::stderr().lock(), "{note}");
    }
    cli.verb.map_or_else(|| verbs::serve::run(&cli.serve), dispatch)
}

fn dispatch(verb: Verb) -> Result<(), Failure> {
    match verb {
        Verb::Plan(a) => verbs::plan::run(&a),
        Verb::Check(a) => verbs::check::run(&a),
        Verb::Schedule(a) => verbs::schedule::run(&a),
        Verb::Study(a) => verbs::study::run(&a),
        Verb::Simulate(a) => verbs::simulate::run(&a),
        Verb::Run(a) => verbs::run::run(&a),
        Verb::Serve(a) => verbs::serve::run(&a),
        Verb::Stop(a) => verbs::cell::stop(&a),
        Verb::Cell(a) => verbs::cell::cell(&a),
        Verb::AnswerOneQuestion(a) => verbs::serve::answer_one_question(&a),
        Verb::Post(a) => verbs::post::run(&a),
        Verb::Import(a) => verbs::read::run(&a),
        Verb::Edit(a) => verbs::edit::run(&a),
        Verb::Teach(a) => verbs::teach::run(&a),
        Verb::Records(a) => verbs::records::run(&a),
        Verb::Machine(a) => verbs::machine::run(&a),
        Verb::Vision(a) => match a.verb {
            VisionVerb::Joint(a) => verbs::find_joint::run(&a),
            VisionVerb::Stripe(a) => verbs::stripe::run(&a),
            VisionVerb::Scan(a) => verbs::scan::run(&a),
        },
        Verb::Tools(a) => match a.verb {
            ToolsVerb::Seam(a) => verbs::seam::run(&a),
            ToolsVerb::Section(a) => verbs::section::run(&a),
            ToolsVerb::Motion(a) => verbs::motion::run(&a),
            ToolsVerb::Pulses(a) => verbs::pulses::run(&a),
            ToolsVerb::Follow(a) => verbs::follow::run(&a),
            ToolsVerb::Reduce(a) => verbs::reduce::run(&a),
            ToolsVerb::Interpolate(a) => verbs::interpolate::run(&a),
            ToolsVerb::Bench(a) => verbs::bench::run(&a),
        },
        Verb::Examples(a) if a.procedures => verbs::lists::procedures(&a.list),
        Verb::Examples(a) => verbs::lists::examples(&a.list),
        Verb::Schema(a) => verbs::schema::run(&a),
        Verb::Licences(a) => verbs::licences::run(&a),
        Verb::Completions(a) => verbs::shell::completions(&a),
        Verb::Man(a) => verbs::shell::man(&a),
    }
}

/// Writes the failure to standard error; its exit code.
fn report(failure: &Failure) -> ExitCode {
    let mut err = std::io::stderr().lock();
    // Errors are ignored: standard error itself may be closed.
    let _ = match failure {
        Failure::Findings(findings) => failure::write_findings(&mut err, findings),
        Failure::Printed | Failure::ReaderGone => Ok(()),
        _ => err.write_all(refusals::error_text(failure).as_bytes()),
    };
    ExitCode::from(failure.exit_code())
}
