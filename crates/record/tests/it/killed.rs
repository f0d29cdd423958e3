//! `kill -9` at random moments: the library is whole, the trace is readable, the journal has the last position.
//!
//! The test starts itself again as a program that welds without end, and kills it.

use crate::common::{WeldResult, plan, row};
use seamwright_message::Message;
use seamwright_record::journal::Position;
use seamwright_record::library::{Event, Place, Query};
use seamwright_record::trace::Trace;
use seamwright_record::{DataFolder, Moment};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const FOLDER: &str = "SEAMWRIGHT_TEST_WELDS_IN";

/// Welds for ever; prints the state of the disk: `position N` after entry N.
fn weld_for_ever(folder: &Path) {
    let mut data = DataFolder::open(folder).unwrap();
    let mut journal = data.journal().unwrap();
    let mut recording = data.begin(&plan("P-1")).unwrap();
    println!("begun");
    let weld = u64::try_from(recording.id()).unwrap();
    for i in 0u32.. {
        recording.row(row(i));
        if i.is_multiple_of(50) {
            let s = f64::from(i);
            let corrections = [[0.1, 0.2], [0.3, 0.4]];
            journal.write(&Position { time: s, weld, pass: 1, phase: 3, s, welded_to: s, corrections }).unwrap();
            println!("position {i}");
        }
        if i.is_multiple_of(500) {
            let event =
                Event { at: Moment::now(), text: Message::verbatim(format!("row {i}")), place: Place::default() };
            data.library().add_event(Some(recording.id()), &event).unwrap();
            println!("event {i}");
        }
    }
}

fn last_number(lines: &[String], what: &str) -> Option<u32> {
    lines.iter().rev().find_map(|l| l.strip_prefix(what)?.trim().parse().ok())
}

/// Kills a weld in another process so long after its start; false if that had not begun.
fn kill_at(after: Duration) -> bool {
    let folder = tempfile::tempdir().unwrap();
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["killed::killed", "--exact", "--nocapture", "--include-ignored"])
        .env(FOLDER, folder.path())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let out = child.stdout.take().unwrap();
    let reader = std::thread::spawn(move || BufReader::new(out).lines().map_while(Result::ok).collect::<Vec<_>>());
    let begin = Instant::now();
    while begin.elapsed() < after {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let lines = reader.join().unwrap();
    if !lines.iter().any(|l| l.ends_with("begun")) {
        return false;
    }
    let mut data = DataFolder::open(folder.path()).unwrap();
    assert_eq!(data.library().integrity().unwrap(), []);
    let last = data.journal().unwrap().last();
    if let Some(i) = last_number(&lines, "position") {
        let s = last.unwrap().s;
        assert!(s >= f64::from(i) && s <= f64::from(i + 50), "{s}, said {i}");
        let recovered = data.recover().unwrap();
        assert_eq!(recovered.len(), 1);
        let record = data.library().find(&Query::default()).unwrap().remove(0);
        assert_eq!(record.result, WeldResult::Interrupted);
        let events = data.library().events(record.id).unwrap();
        assert!(
            last_number(&lines, "event")
                .is_none_or(|i| events.iter().any(|e| e.text == Message::verbatim(format!("row {i}"))))
        );
        // Every row equals the written one, up to the last second of the clock.
        let trace = Trace::open(&data.weld_folder(record.id).join("trace.parquet")).unwrap();
        let mut next = 0;
        trace
            .read(&["t_s", "s_mm"], |v| {
                let wanted = row(next);
                assert!(v[0].to_bits() == wanted[0].to_bits() && v[1].to_bits() == wanted[2].to_bits());
                next += 1;
            })
            .unwrap();
        assert_eq!(u64::from(next), recovered[0].rows);
        assert!(data.verify().unwrap().problems.is_empty());
    }
    true
}

#[test]
fn killed() {
    if let Some(folder) = std::env::var_os(FOLDER) {
        return weld_for_ever(Path::new(&folder));
    }
    let begun = (0..8).filter(|i| kill_at(Duration::from_millis(40 + 97 * i))).count();
    assert!(begun > 0, "no weld had begun");
}

#[test]
#[ignore = "200 moments; make soak"]
fn killed_200_times() {
    let begun = (0..200).filter(|i| kill_at(Duration::from_millis(20 + (i * 7919) % 1800))).count();
    assert!(begun > 150, "{begun} welds had begun");
}
