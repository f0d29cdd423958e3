use crate::weld::table;
use crate::{Block, format_number};
use seamwright_record::figures::Value;
use seamwright_record::library::{Alarm, Event, Place, WeldFile, WeldRecord};

fn number(value: f64) -> String {
    format_number(value, 5)
}

/// What was found against what is allowed.
pub(super) fn values(values: &[Value]) -> Block {
    if values.is_empty() {
        return Block::Paragraph("Nothing of it is known.".to_owned());
    }
    let rows = values.iter().map(|v| {
        let allowed = v.allowed.map_or("not limited".to_owned(), |(l, g)| format!("{} to {}", number(l), number(g)));
        let verdict = match v.allowed {
            None => "",
            Some(_) if v.outside_s > 0.0 => "outside",
            Some(_) => "within",
        };
        let outside = |value: f64| if v.allowed.is_some() { number(value) } else { "–".to_owned() };
        let numbers = [v.least, v.mean, v.greatest].map(number);
        [
            vec![v.pass.to_string(), v.name.clone()],
            numbers.to_vec(),
            vec![allowed, outside(v.outside_s), outside(v.outside_mm), verdict.to_owned()],
        ]
        .concat()
    });
    let head = ["Pass", "Value", "Least", "Mean", "Greatest", "Allowed", "Outside, s", "Outside, mm", ""];
    let caption = "Actual values with the arc on, between run-up and run-down, against the procedure's windows";
    table(caption, &head, rows.collect(), 2..5)
}

fn place(place: &Place) -> [String; 3] {
    let some = |value: Option<f64>| value.map_or(String::new(), number);
    [place.pass.map_or(String::new(), |p| p.to_string()), some(place.s_mm), some(place.t_s)]
}

pub(super) fn alarms(alarms: &[Alarm]) -> Block {
    if alarms.is_empty() {
        return Block::Paragraph("None.".to_owned());
    }
    let rows = alarms.iter().map(|a| {
        let [pass, s, t] = place(&a.place);
        let seen = a.acknowledged.as_ref().map_or("no".to_owned(), |(by, at)| format!("{by}, {at}"));
        let first = if a.first_out { "first" } else { "" };
        vec![a.name.clone(), a.cause.clone(), pass, s, t, first.to_owned(), seen]
    });
    let head = ["Alarm", "Cause", "Pass", "s, mm", "t, s", "First-out", "Acknowledged"];
    table("Alarms in the order in which they came", &head, rows.collect(), 2..5)
}

pub(super) fn events(events: &[Event]) -> Block {
    let rows = events.iter().map(|e| {
        let [pass, s, t] = place(&e.place);
        vec![e.at.to_string(), e.text.clone(), pass, s, t]
    });
    table("Events in the order in which they came", &["Time", "Event", "Pass", "s, mm", "t, s"], rows.collect(), 2..5)
}

/// What the weld was made from, in which versions.
pub(super) fn made_from(weld: &WeldRecord) -> Block {
    let mut rows = Vec::new();
    let mut row = |kind: &str, name: &str, version: i64| {
        rows.push(vec![kind.to_owned(), name.to_owned(), version.to_string()]);
    };
    weld.job.iter().for_each(|(name, version)| row("Job", name, *version));
    row("Program", &weld.program.0, weld.program.1);
    row("Machine", &weld.machine.0, weld.machine.1);
    weld.procedure.iter().for_each(|(name, version)| row("Procedure", name, *version));
    let caption = format!("Made from these texts, which the library keeps; SHA-256 of the program {}", weld.program.2);
    table(&caption, &["", "Name", "Version"], rows, 2..3)
}

pub(super) fn files(files: &[WeldFile]) -> Block {
    let rows = files.iter().map(|f| {
        let rows = f.rows.map_or(String::new(), |n| n.to_string());
        vec![f.name.clone(), rows, f.bytes.to_string(), f.sha256.clone()]
    });
    table("Files of the record", &["File", "Rows", "Bytes", "SHA-256"], rows.collect(), 1..3)
}
