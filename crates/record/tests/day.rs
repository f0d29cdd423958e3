//! A day of rows: parts of an hour, and memory that does not grow.

#![cfg(target_os = "linux")]

use seamwright_record::trace::{Column, Kind, RecoveredPart, Trace, TraceWriter};
use std::path::Path;

/// Maximum memory of this process so far, MB.
fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap() / 1024
}

const HOUR: u64 = 3_600_000;

/// Writes so many hours of rows; its parts.
fn written(folder: &Path, hours: u64) -> Vec<RecoveredPart> {
    let column = |name: &str, kind| Column::new(name, "mm", kind);
    let columns = [column("t_s", Kind::F64), column("x", Kind::F64), column("v", Kind::F32), column("arc", Kind::U8)];
    let mut writer = TraceWriter::create(&folder.join("trace.parquet"), &columns, &[], HOUR).unwrap();
    for i in 0..hours * HOUR {
        let t = i as f64 * 1e-3;
        writer.row([t, (t * 0.1).sin(), t.cos(), 1.0]).unwrap();
    }
    writer.finish().unwrap()
}

#[test]
#[ignore = "a day of rows; make soak"]
fn a_day_of_rows() {
    let [short, folder] = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    assert_eq!(written(short.path(), 2).len(), 2);
    let after_two = peak_mb();
    let parts = written(folder.path(), 24);
    assert_eq!(parts.iter().map(|p| p.rows).collect::<Vec<_>>(), [HOUR; 24]);
    // Parts become Parquet one after the other.
    let peak = peak_mb();
    assert!(peak <= after_two + 8, "{after_two} MB after two hours, {peak} MB in the end");
    println!("{after_two} MB after two hours, {peak} MB in the end");
    let last = Trace::open(&parts[23].path).unwrap();
    let mut first = None;
    last.read(&["t_s"], |v| {
        first.get_or_insert(v[0]);
    })
    .unwrap();
    assert!((first.unwrap() - 23.0 * 3600.0).abs() < 1e-6);
}
