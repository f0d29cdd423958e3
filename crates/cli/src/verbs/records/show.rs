use super::data::{open, result};
use crate::args::records::ShowArgs;
use crate::labels::{padded, width_of};
use crate::rows::print_either;
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_record::figures::Value;
use seamwright_record::library::{Alarm, WeldDetail, WeldFile, WeldRecord};
use seamwright_report::format_number;
use std::fmt::{Display, Write};

/// Minimum width of the labels.
const MIN_WIDTH: usize = 14;

/// Labels whose width decides the width of all labels.
const LABELS: [&str; 15] = [
    "cli-label-part",
    "cli-label-result",
    "cli-label-begun",
    "cli-label-ended",
    "cli-label-welder",
    "cli-label-machine",
    "cli-label-procedure",
    "cli-label-job",
    "cli-label-program",
    "cli-label-heat-input",
    "cli-label-deviation",
    "cli-label-note",
    "cli-label-alarm",
    "cli-label-event",
    "cli-label-file",
];

pub(super) fn run(args: &ShowArgs) -> Result<(), Failure> {
    let detail = open(args.data.data.as_deref())?.library().detail(args.id)?;
    print_either(args.data.json, &detail, || text(&detail))
}

fn text(detail: &WeldDetail) -> String {
    let weld = &detail.weld;
    let heading = Message::new("cli-record-heading").text("weld", weld.id.to_string()).text("title", &weld.title);
    let mut text = format!("{heading}\n");
    about(&mut text, weld);
    for v in &detail.values {
        line(&mut text, &Message::new("cli-label-pass").pass("pass", v.pass as usize), value(v));
    }
    detail.alarms.iter().for_each(|found| labelled(&mut text, "cli-label-alarm", alarm(found)));
    detail.events.iter().for_each(|event| {
        labelled(&mut text, "cli-label-event", format!("{}: {}", event.at, event.text));
    });
    detail.files.iter().for_each(|found| labelled(&mut text, "cli-label-file", file(found)));
    text
}

fn line(text: &mut String, label: &Message, value: impl Display) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "  {} {value}", padded(&label.to_string(), width_of(&LABELS, MIN_WIDTH)));
}

fn labelled(text: &mut String, code: &'static str, value: impl Display) {
    line(text, &Message::new(code), value);
}

fn about(text: &mut String, weld: &WeldRecord) {
    labelled(text, "cli-label-part", &weld.part);
    let result = result(weld.result);
    let result = if weld.simulated { Message::new("cli-record-simulated").message("result", result) } else { result };
    labelled(text, "cli-label-result", result);
    labelled(text, "cli-label-begun", weld.begun);
    weld.ended.iter().for_each(|at| labelled(text, "cli-label-ended", at));
    weld.welder.iter().for_each(|name| labelled(text, "cli-label-welder", name));
    let document = |text: &mut String, code, name: &str, version: &dyn Display| {
        let document = Message::new("cli-record-version").text("name", name).text("version", version.to_string());
        labelled(text, code, document);
    };
    document(text, "cli-label-machine", &weld.machine.0, &weld.machine.1);
    weld.procedure.iter().for_each(|(name, version)| document(text, "cli-label-procedure", name, version));
    weld.job.iter().for_each(|(name, version)| document(text, "cli-label-job", name, version));
    document(text, "cli-label-program", &weld.program.0, &weld.program.1);
    if let Some([min, mean, max]) = weld.heat_input_kj_mm {
        let heat = Message::new("cli-record-heat-input").value("min", short(min), Unit::One);
        let heat = heat.value("max", short(max), Unit::KiloJPerMm).value("mean", short(mean), Unit::One);
        labelled(text, "cli-label-heat-input", heat);
    }
    if let Some((worst, at)) = weld.worst_deviation_mm {
        let deviation = Message::new("cli-record-deviation").value("max", short(worst), Unit::Mm);
        labelled(text, "cli-label-deviation", deviation.value("at", short(at), Unit::Mm));
    }
    if !weld.note.is_empty() {
        labelled(text, "cli-label-note", &weld.note);
    }
}

/// `value` with five significant digits.
fn short(value: f64) -> f64 {
    format_number(value, 5).parse().unwrap_or(value)
}

fn value(v: &Value) -> Message {
    let value = Message::new("cli-record-value").text("name", &v.name);
    let value = value.value("from", short(v.least), Unit::One).value("to", short(v.greatest), Unit::One);
    let Some((low, high)) = v.allowed else { return value };
    let outside = v.outside_s > 0.0;
    let allowed = Message::new(if outside { "cli-record-value-outside" } else { "cli-record-value-allowed" })
        .message("value", value)
        .value("min", short(low), Unit::One)
        .value("max", short(high), Unit::One);
    if outside { allowed.value("time", short(v.outside_s), Unit::S) } else { allowed }
}

fn alarm(alarm: &Alarm) -> Message {
    let mut message = alarm.name.clone();
    if !alarm.cause.is_empty() {
        let both = Message::new("cli-record-with-cause").message("alarm", message);
        message = both.message("cause", alarm.cause.clone());
    }
    match alarm.place.s_mm {
        Some(s) => Message::new("cli-record-at").message("alarm", message).value("at", short(s), Unit::Mm),
        None => message,
    }
}

fn file(file: &WeldFile) -> Message {
    let message = match file.rows {
        Some(rows) => Message::new("cli-record-table").count("rows", rows as usize),
        None => Message::new("cli-record-file"),
    };
    let message = message.text("file", &file.name).quantity("size", file.bytes as f64, Unit::Byte, 0);
    message.text("hash", &file.sha256)
}
