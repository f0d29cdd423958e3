//! A weld to record.

use seamwright_message::Message;
use seamwright_record::figures::{Basis, HEAT_INPUT, Judged, Power};
use seamwright_record::trace::{Column, Kind};
use seamwright_record::{DataFolder, Outcome, Plan};
use tempfile::TempDir;

pub(crate) use seamwright_record::library::WeldResult;

/// Speed of the test weld, mm/s.
pub(crate) const SPEED: f64 = 10.0;

pub(crate) fn empty() -> (TempDir, DataFolder) {
    let folder = tempfile::tempdir().unwrap();
    let data = DataFolder::open(folder.path()).unwrap();
    (folder, data)
}

/// Welds `part` at 240 A (window 220 to 260) and 27 V.
pub(crate) fn plan(part: &str) -> Plan {
    let column = |name: &str, unit: &str, kind| Column::new(name, unit, kind);
    let text = |name: &str, text: &str| (name.to_owned(), text.to_owned());
    Plan {
        part: part.to_owned(),
        title: format!("Weld of {part}"),
        simulated: true,
        job: Some(text("job.toml", "a job")),
        program: text("a program", "schema = 1"),
        machine: text("saddle-4axis", "a machine"),
        procedure: Some(text("WPS 1", "a procedure")),
        welder: Some("A. Welder".to_owned()),
        columns: vec![
            column("t_s", "s", Kind::F64),
            column("pass", "1", Kind::U32),
            column("s_mm", "mm", Kind::F64),
            column("arc", "1", Kind::U8),
            column("path_error_mm", "mm", Kind::F32),
            column("current_a", "a", Kind::F32),
            column("voltage_v", "v", Kind::F32),
        ],
        about: vec![("part", part.to_owned())],
        most_rows: 3_600_000,
        rows: 10_000,
        basis: Basis {
            power: Some(Power {
                factors: vec![("current_a".to_owned(), 1.0), ("voltage_v".to_owned(), 1.0)],
                efficiency: 0.8,
            }),
            judged: vec![
                Judged { pass: 1, name: "current_a".to_owned(), allowed: Some((220.0, 260.0)), along: Vec::new() },
                Judged { pass: 1, name: HEAT_INPUT.to_owned(), allowed: Some((0.4, 0.52)), along: vec![(10.0, 90.0)] },
            ],
        },
        note: Message::default(),
    }
}

/// The row at `i` ms: an arc from 1 s to 11 s over 100 mm; 270 A from 50 to 54 mm; 0.2 mm off at 30 mm.
pub(crate) fn row(i: u32) -> [f64; 7] {
    let t = f64::from(i) * 1e-3;
    let s = SPEED * (t - 1.0).clamp(0.0, 10.0);
    let arc = (1000..11_000).contains(&i);
    let current = if (50.0..54.0).contains(&s) { 270.0 } else { 240.0 };
    let off = if i == 4000 { 0.2 } else { 0.05 };
    [t, 1.0, s, f64::from(u8::from(arc)), off, current, 27.0]
}

pub(crate) fn outcome(result: WeldResult) -> Outcome {
    Outcome { result, note: Message::default(), files: vec![("report.json".to_owned(), "{}\n".to_owned())] }
}
