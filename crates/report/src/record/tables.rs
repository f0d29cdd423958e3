use crate::block::Block;
use crate::names;
use crate::number::{from_to, significant};
use crate::weld::table;
use crate::words::Words as _;
use seamwright_message::{Language, Message};
use seamwright_record::figures::Value;
use seamwright_record::library::{Alarm, Event, Place, WeldFile, WeldRecord};

fn number(value: f64, language: Language) -> String {
    significant(value, 5, language)
}

/// Returns the actual values against the allowed ones.
pub(super) fn values(values: &[Value], language: Language) -> Block {
    if values.is_empty() {
        return Block::Paragraph(language.words("report-no-values"));
    }
    let number = |value| number(value, language);
    let rows = values.iter().map(|v| {
        let allowed = match v.allowed {
            Some((least, greatest)) => from_to(number(least), number(greatest), language),
            None => language.words("report-not-limited"),
        };
        let verdict = match v.allowed {
            None => "",
            Some(_) if v.outside_s > 0.0 => "report-outside",
            Some(_) => "report-within",
        };
        let outside = |value: f64| if v.allowed.is_some() { number(value) } else { "–".to_owned() };
        let numbers = [v.least, v.mean, v.greatest].map(number);
        [
            vec![v.pass.to_string(), names::value(language, &v.name)],
            numbers.to_vec(),
            vec![allowed, outside(v.outside_s), outside(v.outside_mm), language.words(verdict)],
        ]
        .concat()
    });
    let head = [
        "report-column-pass",
        "report-column-value",
        "report-column-min",
        "report-column-mean",
        "report-column-max",
        "report-column-allowed",
        "report-column-outside-s",
        "report-column-outside-mm",
        "",
    ];
    let caption = "report-caption-actual-values";
    table(&language.words(caption), &head.map(|head| language.words(head)), rows.collect(), 2..5)
}

fn place(place: &Place, language: Language) -> [String; 3] {
    let some = |value: Option<f64>| value.map_or_else(String::new, |value| number(value, language));
    [place.pass.map_or(String::new(), |p| p.to_string()), some(place.s_mm), some(place.t_s)]
}

pub(super) fn alarms(alarms: &[Alarm], language: Language) -> Block {
    if alarms.is_empty() {
        return Block::Paragraph(language.words("report-no-alarms"));
    }
    let rows = alarms.iter().map(|a| {
        let [pass, s, t] = place(&a.place, language);
        let seen =
            a.acknowledged.as_ref().map_or_else(|| language.words("report-no"), |(by, at)| format!("{by}, {at}"));
        let first = language.words(if a.first_out { "report-first-out" } else { "" });
        vec![a.name.in_language(language), a.cause.in_language(language), pass, s, t, first, seen]
    });
    let head = [
        "report-column-alarm",
        "report-column-cause",
        "report-column-pass",
        "report-column-position-mm",
        "report-column-time-s",
        "report-column-first-out",
        "report-column-acknowledged",
    ];
    let head = head.map(|head| language.words(head));
    table(&language.words("report-caption-alarms"), &head, rows.collect(), 2..5)
}

pub(super) fn events(events: &[Event], language: Language) -> Block {
    let rows = events.iter().map(|e| {
        let [pass, s, t] = place(&e.place, language);
        vec![e.at.to_string(), e.text.in_language(language), pass, s, t]
    });
    let head = [
        "report-column-time",
        "report-column-event",
        "report-column-pass",
        "report-column-position-mm",
        "report-column-time-s",
    ]
    .map(|head| language.words(head));
    table(&language.words("report-caption-events"), &head, rows.collect(), 2..5)
}

/// Returns the source texts of the weld with their versions.
pub(super) fn made_from(weld: &WeldRecord, language: Language) -> Block {
    let mut rows = Vec::new();
    let mut row = |kind, name: &str, version: i64| {
        rows.push(vec![language.words(kind), name.to_owned(), version.to_string()]);
    };
    weld.job.iter().for_each(|(name, version)| row("report-heading-job", name, *version));
    row("report-heading-program", &weld.program.0, weld.program.1);
    row("report-meta-machine", &weld.machine.0, weld.machine.1);
    weld.procedure.iter().for_each(|(name, version)| row("report-meta-procedure", name, *version));
    let head = ["", "report-column-text", "report-column-version"].map(|head| language.words(head));
    table(
        &Message::new("report-caption-sources").text("sha256", &weld.program.2).in_language(language),
        &head,
        rows,
        2..3,
    )
}

pub(super) fn files(files: &[WeldFile], language: Language) -> Block {
    let rows = files.iter().map(|f| {
        let rows = f.rows.map_or(String::new(), |n| n.to_string());
        vec![f.name.clone(), rows, f.bytes.to_string(), f.sha256.clone()]
    });
    let [file, rows_, bytes] =
        ["report-column-file", "report-column-rows", "report-column-bytes"].map(|head| language.words(head));
    table(&language.words("report-caption-files"), &[file, rows_, bytes, "SHA-256".to_owned()], rows.collect(), 1..3)
}
