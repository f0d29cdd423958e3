use crate::Phrases as _;
use crate::said;
use crate::weld::table;
use crate::{Block, Language, format_number};
use seamwright_record::figures::Value;
use seamwright_record::library::{Alarm, Event, Place, WeldFile, WeldRecord};

fn number(value: f64) -> String {
    format_number(value, 5)
}

/// Returns the actual values against the allowed ones.
pub(super) fn values(values: &[Value], language: Language) -> Block {
    if values.is_empty() {
        return Block::Paragraph(language.say("Nothing of it is known.").to_owned());
    }
    let rows = values.iter().map(|v| {
        let allowed = match v.allowed {
            Some((least, greatest)) => language.fill("{0} to {1}", &[&number(least), &number(greatest)]),
            None => language.say("not limited").to_owned(),
        };
        let verdict = match v.allowed {
            None => "",
            Some(_) if v.outside_s > 0.0 => "outside",
            Some(_) => "within",
        };
        let outside = |value: f64| if v.allowed.is_some() { number(value) } else { "–".to_owned() };
        let numbers = [v.least, v.mean, v.greatest].map(number);
        [
            vec![v.pass.to_string(), said::value(language, &v.name)],
            numbers.to_vec(),
            vec![allowed, outside(v.outside_s), outside(v.outside_mm), language.say(verdict).to_owned()],
        ]
        .concat()
    });
    let head = ["pass", "Value", "least", "mean", "greatest", "allowed", "Outside, s", "Outside, mm", ""];
    let caption =
        "Actual values while the pass was travelled, without holds, starts and ends, against the procedure's windows";
    table(language.say(caption), &head.map(|head| language.say(head)), rows.collect(), 2..5)
}

fn place(place: &Place) -> [String; 3] {
    let some = |value: Option<f64>| value.map_or(String::new(), number);
    [place.pass.map_or(String::new(), |p| p.to_string()), some(place.s_mm), some(place.t_s)]
}

pub(super) fn alarms(alarms: &[Alarm], language: Language) -> Block {
    if alarms.is_empty() {
        return Block::Paragraph(language.say("None.").to_owned());
    }
    let rows = alarms.iter().map(|a| {
        let [pass, s, t] = place(&a.place);
        let seen = a.acknowledged.as_ref().map_or(language.say("no").to_owned(), |(by, at)| format!("{by}, {at}"));
        let first = language.say(if a.first_out { "first" } else { "" }).to_owned();
        vec![said::alarm(language, &a.name), said::cause(language, a), pass, s, t, first, seen]
    });
    let head = ["alarm", "alarm.cause", "pass", "s, mm", "t, s", "First-out", "Acknowledged"];
    let head = head.map(|head| language.say(head));
    table(language.say("Alarms in the order in which they came"), &head, rows.collect(), 2..5)
}

pub(super) fn events(events: &[Event], language: Language) -> Block {
    let rows = events.iter().map(|e| {
        let [pass, s, t] = place(&e.place);
        vec![e.at.to_string(), said::event(language, &e.text.to_string()), pass, s, t]
    });
    let head = ["event.time", "event.text", "pass", "s, mm", "t, s"].map(|head| language.say(head));
    table(language.say("Events in the order in which they came"), &head, rows.collect(), 2..5)
}

/// Returns the source texts of the weld with their versions.
pub(super) fn made_from(weld: &WeldRecord, language: Language) -> Block {
    let mut rows = Vec::new();
    let mut row = |kind, name: &str, version: i64| {
        rows.push(vec![language.say(kind).to_owned(), name.to_owned(), version.to_string()]);
    };
    weld.job.iter().for_each(|(name, version)| row("job.head", name, *version));
    row("program", &weld.program.0, weld.program.1);
    row("record.machine", &weld.machine.0, weld.machine.1);
    weld.procedure.iter().for_each(|(name, version)| row("record.procedure", name, *version));
    let caption = "Made from these texts, which the library keeps; SHA-256 of the program {0}";
    let head = ["", "Text", "Version"].map(|head| language.say(head));
    table(&language.fill(caption, &[&weld.program.2]), &head, rows, 2..3)
}

pub(super) fn files(files: &[WeldFile], language: Language) -> Block {
    let rows = files.iter().map(|f| {
        let rows = f.rows.map_or(String::new(), |n| n.to_string());
        vec![f.name.clone(), rows, f.bytes.to_string(), f.sha256.clone()]
    });
    let [file, rows_, bytes] = ["File", "Rows", "Bytes"].map(|head| language.say(head));
    table(language.say("Files of the record"), &[file, rows_, bytes, "SHA-256"], rows.collect(), 1..3)
}
