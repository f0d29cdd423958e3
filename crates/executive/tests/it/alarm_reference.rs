//! The reference of alarms in the book is made from the table of the executive.

use seamwright_executive::{Alarm, Priority, ResponseTime, Severity};
use seamwright_message::{Language, Message};
use std::fmt::Write;
use std::path::Path;

fn words(message: &Message) -> String {
    message.in_language(Language::English)
}

const HEAD: &str = "# Alarms

Every alarm of a cell with its rationalisation as ISA-18.2 asks for it. What to do when one comes: [respond to an
alarm](../how-to/alarm.md). How an alarm comes and goes: [the executive](../explanation/executive.md#alarms). This page
is made from the table in `crates/executive/src/executive/alarm_priority.rs`; do not edit it.

";

const PRIORITY: &str = "## Priority

The priority gives the order of actions. It follows from two facts: the severity of the consequence if the operator does not
act, and the time within which an action still averts it. Both count *after* the reaction of the cell, which has already
switched off what endangers people or part.

";

const OCCURRENCES: &str = "
Two alarms have another priority by what they stop:

- An interlock (1) that is lost where it was needed, so that it switches something off: medium.
- A warning of tracking (24), which stops nothing, while the weld goes on: medium.

Syslog severity and colours follow the priority: [audit log and export](../how-to/audit-export.md),
[panel](panel.md#alarms).

";

fn table() -> String {
    let mut text = String::from(
        "| no. | alarm | priority | cause | consequence | severity | operator action | time to respond | reaction of the cell | shelving |\n|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for alarm in Alarm::ALL {
        let (entry, row) = (alarm.entry(), alarm.rationalisation());
        let (number, title) = (alarm.number(), words(&entry.title));
        let _ = write!(text, "| {number} | [{title}](messages/alarms.md#alarm-{number}-title) |");
        let shelving = if alarm.is_shelvable(row.reaction) { "yes" } else { "no" };
        let columns = [
            row.priority().message(),
            entry.cause,
            entry.consequence,
            row.severity.message(),
            entry.action,
            row.response.message(),
            row.reaction.message(),
            Message::verbatim(shelving),
        ];
        for column in &columns {
            let _ = write!(text, " {} |", words(column));
        }
        text.push('\n');
    }
    text
}

fn matrix() -> String {
    let mut text = String::from("| severity |");
    for response in ResponseTime::ALL {
        let _ = write!(text, " {} |", words(&response.message()));
    }
    text.push_str("\n|---|---|---|---|\n");
    for severity in Severity::ALL.into_iter().rev() {
        let _ = write!(text, "| {} |", words(&severity.message()));
        for response in ResponseTime::ALL {
            let _ = write!(text, " {} |", words(&Priority::of(severity, response).message()));
        }
        text.push('\n');
    }
    text
}

/// Share of each priority beside the advice of the standard.
fn shares() -> String {
    let mut text = String::from("## Shares\n\n| priority | alarms | share | advice of ISA-18.2 |\n|---|---|---|---|\n");
    let advice = ["with *high* about 5 %", "about 5 %", "about 15 %", "about 80 %"];
    for (priority, advice) in Priority::ALL.into_iter().zip(advice) {
        let of = Alarm::ALL.into_iter().filter(|alarm| alarm.rationalisation().priority() == priority);
        let numbers: Vec<String> = of.map(|alarm| alarm.number().to_string()).collect();
        let share = (100.0 * numbers.len() as f64 / Alarm::ALL.len() as f64).round();
        let _ = writeln!(text, "| {} | {} | {share} % | {advice} |", words(&priority.message()), numbers.join(", "));
    }
    text
}

/// `SEAMWRIGHT_BLESS=1` writes the page.
#[test]
fn the_reference_of_alarms_is_current() {
    let page = format!("{HEAD}{}\n{PRIORITY}{}{OCCURRENCES}{}", table(), matrix(), shares());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/alarms.md");
    if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    let current = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(current == page, "docs/reference/alarms.md: run this test with SEAMWRIGHT_BLESS=1");
}
