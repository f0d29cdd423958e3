//! Cost of recording: a row of the raw trace, and bytes a second of weld.

use crate::measure::time;
use seamwright_record::trace::{Column, Kind, TraceWriter};

/// The columns of a cell with ten axes: 17 of 64 bits, 35 of 32, two states.
fn columns() -> Vec<Column> {
    let kinds = [(17, Kind::F64), (35, Kind::F32), (2, Kind::U8)];
    let all = kinds.into_iter().flat_map(|(n, kind)| std::iter::repeat_n(kind, n));
    all.enumerate().map(|(i, kind)| Column::new(format!("c{i}"), "mm", kind)).collect()
}

pub(crate) fn rows() {
    let Ok(folder) = tempfile::tempdir() else { return };
    let columns = columns();
    let path = folder.path().join("trace.parquet");
    let mut writer = TraceWriter::create(&path, &columns, &[], u64::MAX).expect("the folder is ours");
    let mut row = vec![0.0; columns.len()];
    let mut t = 0.0f64;
    time("trace row, 54 columns", || {
        t += 1e-3;
        for (i, value) in row.iter_mut().enumerate() {
            *value = t + i as f64;
        }
        writer.row(row.iter().copied()).expect("there is room");
    });
}
