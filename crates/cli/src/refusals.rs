//! Refused values of options and files.

use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use std::fmt::Display;
use std::io;

/// Lines of an error: its words, and its code to look up.
pub(crate) fn error_text(failure: &Failure) -> String {
    let text = format!("{}\n", Message::new("cli-error").text("error", failure.text()));
    match failure.code() {
        Some(code) => format!("{text}   {}\n", Message::new("document-code").text("code", code)),
        None => text,
    }
}

/// Fault of an option, like `--points 1: not allowed`.
pub(crate) fn of_option(option: impl Display, fault: Message) -> Message {
    Message::new("cli-option").text("option", option.to_string()).message("fault", fault)
}

pub(crate) fn refused(option: &str, value: impl Display, fault: Message, allowed: impl Into<Message>) -> Failure {
    Failure::refused(of_option(format!("{option} {value}"), fault), allowed)
}

pub(crate) fn not_allowed(option: &str, value: impl Display, allowed: impl Into<Message>) -> Failure {
    refused(option, value, Message::new("cli-not-allowed"), allowed)
}

/// Fault of a file or another source.
pub(crate) fn in_file(file: &str, why: impl Into<Message>) -> Message {
    Message::new("project-in-file").text("file", file).message("why", why.into())
}

pub(crate) fn unreadable(file: &str, error: &io::Error) -> Failure {
    Failure::input(Message::new("project-unreadable").text("file", file).message("why", Message::outside(error)))
}

pub(crate) fn not_json(error: impl Display) -> Failure {
    Failure::environment(Message::outside(&error))
}

pub(crate) fn between(min: f64, max: f64) -> Message {
    Message::new("document-between").value("min", min, Unit::One).value("max", max, Unit::One)
}

pub(crate) fn at_most(max: f64, unit: Unit) -> Message {
    Message::new("document-at-most").value("max", max, unit)
}

pub(crate) fn at_least(min: f64, unit: Unit) -> Message {
    Message::new("document-at-least").value("min", min, unit)
}

pub(crate) fn range(from: f64, to: f64, unit: Unit, decimals: u8) -> Message {
    Message::new("cli-range").number("from", from, decimals).quantity("to", to, unit, decimals)
}

pub(crate) fn signed(value: f64, unit: Unit, decimals: u8) -> Message {
    let code = if value > 0.0 { "cli-plus" } else { "quantity" };
    Message::new(code).quantity("value", value, unit, decimals)
}

pub(crate) fn unit_of(symbol: &str) -> Unit {
    Unit::from_symbol(symbol).unwrap_or(Unit::One)
}
