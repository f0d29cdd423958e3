//! The `seamwright` command: arguments in, one call down, text out.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod args;
mod clock;
mod planning;
mod progress;
mod rows;
mod verbs;

use args::{Cli, Verb};
use clap::Parser;
use failure::Failure;
use seamwright_project::{csv, examples, failure, files, load, overlay};
use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            // Help and version are asked for; anything else is wrong usage.
            let _ = e.print();
            return ExitCode::from(if e.use_stderr() { 2 } else { 0 });
        }
    };
    match run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => report(&failure),
    }
}

fn run(cli: Cli) -> Result<(), Failure> {
    match cli.verb {
        None => verbs::serve::run(&cli.serve),
        Some(Verb::Seam(a)) => verbs::seam::run(&a),
        Some(Verb::Section(a)) => verbs::section::run(&a),
        Some(Verb::Plan(a)) => verbs::plan::run(&a),
        Some(Verb::Check(a)) => verbs::check::run(&a),
        Some(Verb::Motion(a)) => verbs::motion::run(&a),
        Some(Verb::Pulses(a)) => verbs::pulses::run(&a),
        Some(Verb::Simulate(a)) => verbs::simulate::run(&a),
        Some(Verb::Run(a)) => verbs::run::run(&a),
        Some(Verb::Serve(a)) => verbs::serve::run(&a),
        Some(Verb::AnswerOneQuestion(a)) => verbs::serve::answer_one_question(&a),
        Some(Verb::Latency(a)) => verbs::latency::run(&a),
        Some(Verb::Io(a)) => verbs::io::run(&a),
        Some(Verb::Post(a)) => verbs::post::run(&a),
        Some(Verb::Read(a)) => verbs::read::run(&a),
        Some(Verb::Kinematics(a)) => verbs::kinematics::run(&a),
        Some(Verb::Interpolate(a)) => verbs::interpolate::run(&a),
        Some(Verb::Follow(a)) => verbs::follow::run(&a),
        Some(Verb::Reduce(a)) => verbs::reduce::run(&a),
        Some(Verb::FindJoint(a)) => verbs::find_joint::run(&a),
        Some(Verb::Records(a)) => verbs::records::run(&a),
        Some(Verb::Bench(a)) => verbs::bench::run(&a),
        Some(Verb::Teach(a)) => verbs::teach::run(&a),
        Some(Verb::Edit(a)) => verbs::edit::run(&a),
        Some(Verb::Move(a)) => verbs::move_to::run(&a),
        Some(Verb::Machine(a)) => verbs::machine::run(&a),
        Some(Verb::Stripe(a)) => verbs::stripe::run(&a),
        Some(Verb::Machines(a)) => verbs::lists::machines(&a),
        Some(Verb::Procedures(a)) => verbs::lists::procedures(&a),
        Some(Verb::Examples(a)) => verbs::lists::examples(&a),
        Some(Verb::Schema(a)) => verbs::schema::run(&a),
    }
}

/// Writes the failure to standard error; its exit code.
fn report(failure: &Failure) -> ExitCode {
    let mut err = std::io::stderr().lock();
    // Errors are ignored: standard error itself may be closed.
    let _ = match failure {
        Failure::Findings(findings) => failure::write_findings(&mut err, findings),
        Failure::Printed | Failure::ReaderGone => Ok(()),
        _ => writeln!(err, "error: {}", failure.text()),
    };
    ExitCode::from(failure.exit_code())
}
