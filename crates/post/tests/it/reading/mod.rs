//! A machine for reader tests, and short ways to read.

#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use seamwright_machine::Machine;
use seamwright_post::{Control, Dialect, Event, Move, PartProgram, ReadError, ReadOptions, Reading, What, read};

/// Five axes, outputs for the process, and addresses that every dialect has its own way for.
pub const MACHINE: &str = include_str!("../../data/machine.toml");

pub fn control(dialect: Dialect) -> Control {
    Control::new(&Machine::read("test.toml", MACHINE).unwrap_or_else(|e| panic!("{e}")), dialect).unwrap()
}

pub fn try_read(dialect: Dialect, text: &str) -> Result<Reading, ReadError> {
    read(&control(dialect), "test", text, &ReadOptions::default())
}

pub fn good(dialect: Dialect, text: &str) -> PartProgram {
    try_read(dialect, text).unwrap_or_else(|e| panic!("{text}\n{e}")).program
}

/// The error's position and message; checks that it prints whole.
pub fn bad(dialect: Dialect, text: &str) -> (usize, usize, String) {
    let error = try_read(dialect, text).expect_err(text);
    let shown = error.to_string();
    assert!(shown.starts_with(&format!("test:{}:{}: ", error.line, error.column)), "{shown}");
    assert!(shown.contains('^') && shown.contains(&error.text), "{shown}");
    assert_eq!(error.text, text.lines().nth(error.line - 1).unwrap_or_default().replace('\t', " "), "{shown}");
    (error.line, error.column, error.message.to_string())
}

/// Checks an error's position and a part of its message.
pub fn refused(dialect: Dialect, text: &str, line: usize, column: usize, part: &str) {
    let (at_line, at_column, message) = bad(dialect, text);
    assert!(message.contains(part), "{text:?}: {message}");
    assert_eq!((at_line, at_column), (line, column), "{text:?}: {message}");
}

pub fn moves(program: &PartProgram) -> Vec<Move> {
    program.steps.iter().filter_map(|s| if let What::Move(m) = &s.what { Some(*m) } else { None }).collect()
}

/// Rows of the moves, in order.
pub fn rows(program: &PartProgram) -> Vec<Vec<f64>> {
    moves(program).iter().map(|m| program.row(m.row).to_vec()).collect()
}

pub fn events(program: &PartProgram) -> Vec<(Event, bool)> {
    let event =
        |what: &What| if let What::Event { event, at_once } = what { Some((event.clone(), *at_once)) } else { None };
    program.steps.iter().filter_map(|s| event(&s.what)).collect()
}

/// Channel, value and whether at once of all values that are set.
pub fn sets(program: &PartProgram) -> Vec<(u16, f64, bool)> {
    let set = |what: &What| {
        if let What::Set { channel, value, at_once } = what { Some((*channel, *value, *at_once)) } else { None }
    };
    program.steps.iter().filter_map(|s| set(&s.what)).collect()
}

pub fn near(a: &[f64], b: &[f64], within: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= within)
}
