//! A row of a trace costs no allocation, also while blocks are written.

use seamwright_record::trace::{Column, Kind, TraceWriter};
use seamwright_testkit::no_alloc;

#[test]
fn rows_do_not_allocate() {
    let folder = tempfile::tempdir().unwrap();
    let columns: Vec<Column> = (0..40)
        .map(|i| Column::new(format!("c{i}"), "mm", [Kind::F64, Kind::F32, Kind::U32, Kind::U8][i % 4]))
        .collect();
    let mut writer = TraceWriter::create(&folder.path().join("trace.parquet"), &columns, &[], u64::MAX).unwrap();
    let mut row = [0.0; 40];
    // More than ten blocks.
    no_alloc(|| {
        for i in 0..10_000 {
            row[0] = f64::from(i) * 1e-3;
            writer.row(row).unwrap();
        }
        writer.flush().unwrap();
    });
    assert_eq!(writer.finish().unwrap()[0].rows, 10_000);
}
