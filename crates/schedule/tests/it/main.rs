//! Schedules against single runs, interrupted ones, and wrong tables; studies.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod cluster;
mod study;

use seamwright_project::load::load_text;
use seamwright_report::{Language, WeldReport};
use seamwright_schedule::{Progress, Schedule, Summary, Table};
use seamwright_testkit::Random;
use std::collections::HashMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;

/// Random nozzles of one template: radius, position, speed.
fn nozzles(count: usize, seed: u8) -> String {
    let mut random = Random::new(seed);
    let mut text =
        "name,template,machine,count,setup_min,seam.nozzle.radius_mm,seam.nozzle.origin_mm,weld.speed_mm_s\n\
                    *,hillside,torch-5axis,,12,,,\n"
            .to_owned();
    for i in 1..=count {
        let (radius, aside) = (random.within(30.0, 70.0), random.within(0.0, 20.0));
        writeln!(text, "N{i},,,{},,{radius:.1},\"[0, {aside:.1}, 0]\",{:.1}", 1 + i % 3, random.within(4.0, 7.0))
            .unwrap();
    }
    text
}

fn schedule(table: &Path, output: &Path, threads: usize) -> (Summary, Progress) {
    let (table, _) = Table::open(table).unwrap();
    let last = Mutex::new(Progress { done: 0, kept: 0 });
    let schedule = Schedule {
        table: &table,
        output,
        threads,
        spark: None,
        limit: Duration::from_secs(60),
        post: None,
        cancel: None,
    };
    let summary = schedule.run(&|progress| *last.lock().unwrap() = progress).unwrap();
    let progress = *last.lock().unwrap();
    (summary, progress)
}

/// Rows of schedule.csv by name, each by column.
fn rows(output: &Path) -> Vec<HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(output.join("schedule.csv")).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

#[test]
fn rows_are_equal_to_single_runs() {
    let folder = tempfile::tempdir().unwrap();
    let (table, output) = (folder.path().join("nozzles.csv"), folder.path().join("out"));
    std::fs::write(&table, nozzles(4, 48)).unwrap();
    let (summary, progress) = schedule(&table, &output, 2);
    assert_eq!((summary.rows, progress.done, progress.kept), (4, 4, 0));
    let template = seamwright_project::examples::example("hillside").unwrap().text;
    let mut reader = csv::Reader::from_path(&table).unwrap();
    let given: Vec<csv::StringRecord> = reader.records().skip(1).map(Result::unwrap).collect();
    for (row, given) in rows(&output).iter().zip(&given) {
        let text =
            template.replace("radius_mm = 60\n", &format!("radius_mm = {}\norigin_mm = {}\n", &given[5], &given[6]));
        let text = text.replace("[weld]\nspeed_mm_s = 6.5", &format!("[weld]\nspeed_mm_s = {}", &given[7]));
        let loaded = load_text("single", &text, Path::new(".")).unwrap();
        match loaded.try_plan().unwrap() {
            Ok(motion) => {
                let (report, _) = WeldReport::new(&loaded.machine, &loaded.welding, &motion, None, Language::English);
                assert_eq!(row["passes"], report.totals.passes.to_string());
                assert_eq!(row["total_s"], format!("{:.3}", report.totals.total_s));
                assert_eq!(row["wire_kg"], report.totals.wire_kg.map_or(String::new(), |kg| format!("{kg:.3}")));
            }
            Err(findings) => {
                assert_eq!(row["status"], "not_weldable");
                assert_eq!(row["blocking"], findings.iter().filter(|f| !f.allowed).count().to_string());
            }
        }
    }
}

#[test]
fn an_interrupted_schedule_goes_on_and_a_changed_row_is_planned_again() {
    let folder = tempfile::tempdir().unwrap();
    let (table, output) = (folder.path().join("nozzles.csv"), folder.path().join("out"));
    let text = nozzles(4, 49);
    std::fs::write(&table, &text).unwrap();
    let (first, _) = schedule(&table, &output, 1);
    let results = std::fs::read(output.join("schedule.csv")).unwrap();
    // As if it had been killed while the third result was written.
    let journal = std::fs::read(output.join("rows.jsonl")).unwrap();
    let ends: Vec<usize> = (0..journal.len()).filter(|i| journal[*i] == b'\n').collect();
    std::fs::write(output.join("rows.jsonl"), &journal[..ends[1] + 40]).unwrap();
    let (again, progress) = schedule(&table, &output, 2);
    assert_eq!((first.rows, again.rows, progress.kept, progress.done), (4, 4, 2, 4));
    assert_eq!(std::fs::read(output.join("schedule.csv")).unwrap(), results);
    // One value changed, and one row more.
    let changed = text.replace("N2,,,3,", "N2,,,1,") + "N5,,,1,,45,,5\n";
    std::fs::write(&table, changed).unwrap();
    let (more, progress) = schedule(&table, &output, 2);
    // The number of parts is not part of a plan.
    assert_eq!((more.rows, progress.kept), (5, 4));
}

#[test]
fn a_row_that_fails_is_a_result_and_the_others_go_on() {
    let folder = tempfile::tempdir().unwrap();
    let (table, output) = (folder.path().join("t.csv"), folder.path().join("out"));
    std::fs::write(
        &table,
        "name,template,machine,seam.nozzle.radius_mm,joint.preparation.t_bevel.cut_deg,weld.process.current_a\n\
         good,hillside,,,,\nwide,hillside,,500,,\nunknown,hillside,no-such-machine,,,\nangle,hillside,,,\"steep\",\n\
         slow,hillside,saddle-4axis|torch-5axis,,,\n",
    )
    .unwrap();
    let (summary, _) = schedule(&table, &output, 2);
    let rows = rows(&output);
    let of = |name: &str, column: &str| rows.iter().find(|row| row["name"] == name).unwrap()[column].clone();
    assert_eq!(summary.rows, 5);
    assert_eq!(of("good", "status"), "weldable");
    for (name, part) in [("wide", "500"), ("unknown", "no-such-machine"), ("angle", "steep")] {
        assert_eq!(of(name, "status"), "invalid", "{name}");
        assert!(of(name, "error").contains(part), "{}", of(name, "error"));
    }
    assert!(of("wide", "error").contains("t.csv:3: seam.nozzle.radius_mm"), "{}", of("wide", "error"));
    // The best of two machines.
    assert_eq!((of("slow", "status"), of("slow", "machine")), ("weldable".to_owned(), "torch-5axis".to_owned()));
    let report = std::fs::read_to_string(output.join("report.html")).unwrap();
    assert!(report.contains("sortable") && report.contains("<svg"));
    assert!(output.join("schedule.parquet").is_file());
}
