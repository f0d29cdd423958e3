//! A day of rows: parts of an hour, and memory that does not grow.

#![cfg(target_os = "linux")]

use seamwright_record::trace::{Column, Kind, Trace, TraceWriter};

/// Maximum memory of this process so far, MB.
fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap() / 1024
}

#[test]
#[ignore = "a day of rows; make soak"]
fn a_day_of_rows() {
    const HOUR: u64 = 3_600_000;
    let folder = tempfile::tempdir().unwrap();
    let column = |name: &str, kind| Column::new(name, "mm", kind);
    let columns = [column("t_s", Kind::F64), column("x", Kind::F64), column("v", Kind::F32), column("arc", Kind::U8)];
    let mut writer = TraceWriter::create(&folder.path().join("trace.parquet"), &columns, &[], HOUR).unwrap();
    let mut after_two = 0;
    for i in 0..24 * HOUR {
        let t = i as f64 * 1e-3;
        writer.row([t, (t * 0.1).sin(), t.cos(), 1.0]).unwrap();
        if i == 2 * HOUR {
            after_two = peak_mb();
        }
    }
    let parts = writer.finish().unwrap();
    assert_eq!(parts.iter().map(|p| p.rows).collect::<Vec<_>>(), [HOUR; 24]);
    // The second part is written while the first is converted to Parquet: that is the maximum of memory.
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
