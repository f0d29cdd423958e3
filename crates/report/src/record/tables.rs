use crate::block::paragraph;
use crate::number::{NONE, allowed, number};
use crate::{Block, Language, Table, Words as _, value_names};
use seamwright_message::Message;
use seamwright_record::figures::Value;
use seamwright_record::library::{Alarm, Event, Place, WeldFile, WeldRecord};

/// Returns the actual values against the allowed ones.
pub(super) fn values(values: &[Value], language: Language) -> Block {
    if values.is_empty() {
        return paragraph("report-no-values", language);
    }
    let number = |value| number(value, language);
    let outside = |v: &Value, value| if v.allowed.is_some() { number(value) } else { NONE.to_owned() };
    let verdict = |v: &Value| match v.allowed {
        None => "",
        Some(_) if v.outside_s > 0.0 => "report-outside",
        Some(_) => "report-within",
    };
    Table::of(language, values)
        .text("report-column-pass", |v| v.pass.to_string())
        .text("report-column-value", |v| value_names::value(language, &v.name))
        .number("report-column-min", |v| number(v.least))
        .number("report-column-mean", |v| number(v.mean))
        .number("report-column-max", |v| number(v.greatest))
        .text("report-column-allowed", |v| allowed(v.allowed, language))
        .text("report-column-outside-s", |v| outside(v, v.outside_s))
        .text("report-column-outside-mm", |v| outside(v, v.outside_mm))
        .text("", |v| language.words(verdict(v)))
        .captioned("report-caption-actual-values")
}

fn pass(place: &Place) -> String {
    place.pass.map_or(String::new(), |pass| pass.to_string())
}

fn optional(value: Option<f64>, language: Language) -> String {
    value.map_or_else(String::new, |value| number(value, language))
}

/// Words of the priority; empty in records of older versions.
fn priority(alarm: &Alarm, language: Language) -> String {
    match alarm.priority.as_str() {
        "critical" => language.words("alarm-priority-critical"),
        "high" => language.words("alarm-priority-high"),
        "medium" => language.words("alarm-priority-medium"),
        "low" => language.words("alarm-priority-low"),
        _ => String::new(),
    }
}

pub(super) fn alarms(alarms: &[Alarm], language: Language) -> Block {
    if alarms.is_empty() {
        return paragraph("report-no-alarms", language);
    }
    let acknowledged = |alarm: &Alarm| match &alarm.acknowledged {
        Some((by, at)) => format!("{by}, {at}"),
        None => language.words("report-no"),
    };
    Table::of(language, alarms)
        .text("report-column-alarm", |a| a.name.in_language(language))
        .text("report-column-priority", |a| priority(a, language))
        .text("report-column-cause", |a| a.cause.in_language(language))
        .number("report-column-pass", |a| pass(&a.place))
        .number("report-column-position-mm", |a| optional(a.place.s_mm, language))
        .number("report-column-time-s", |a| optional(a.place.t_s, language))
        .text("report-column-first-out", |a| language.words(if a.first_out { "report-first-out" } else { "" }))
        .text("report-column-acknowledged", |a| acknowledged(a))
        .captioned("report-caption-alarms")
}

pub(super) fn events(events: &[Event], language: Language) -> Block {
    Table::of(language, events)
        .text("report-column-time", |e| e.at.to_string())
        .text("report-column-event", |e| e.text.in_language(language))
        .number("report-column-pass", |e| pass(&e.place))
        .number("report-column-position-mm", |e| optional(e.place.s_mm, language))
        .number("report-column-time-s", |e| optional(e.place.t_s, language))
        .captioned("report-caption-events")
}

/// Returns the source texts of the weld with their versions.
pub(super) fn made_from(weld: &WeldRecord, language: Language) -> Block {
    let texts = [
        ("report-heading-job", weld.job.clone()),
        ("report-heading-program", Some((weld.program.0.clone(), weld.program.1))),
        ("report-meta-machine", Some(weld.machine.clone())),
        ("report-meta-procedure", weld.procedure.clone()),
    ];
    let caption = Message::new("report-caption-sources").text("sha256", &weld.program.2).in_language(language);
    let texts = texts.into_iter().filter_map(|(kind, text)| Some((kind, text?)));
    let table = Table::of(language, texts)
        .text("", |(kind, _)| language.words(kind))
        .text("report-column-text", |(_, (name, _))| name.clone())
        .number("report-column-version", |(_, (_, version))| version.to_string());
    Block::Table(table.table(caption))
}

pub(super) fn files(files: &[WeldFile], language: Language) -> Block {
    Table::of(language, files)
        .text("report-column-file", |f| f.name.clone())
        .number("report-column-rows", |f| f.rows.map_or(String::new(), |rows| rows.to_string()))
        .number("report-column-bytes", |f| f.bytes.to_string())
        .column("SHA-256".to_owned(), false, |f| f.sha256.clone())
        .captioned("report-caption-files")
}
