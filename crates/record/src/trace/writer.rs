use super::column::Column;
use super::raw::{Header, RawWriter};
use crate::error::Error;
use std::path::{Path, PathBuf};

/// Writes a trace row by row, so that a crash loses no more than its last 100 ms.
///
/// Memory is bounded, and a row costs no allocation. A row may wait for the disk (up to tens of ms, twice a second), so
/// rows belong into a thread that may wait. In the absence of rows, [`TraceWriter::flush`] puts the last ones on the
/// disk.
#[derive(Debug)]
pub struct TraceWriter {
    /// The first part's Parquet file.
    path: PathBuf,
    header: Header,
    most_rows: u64,
    in_part: u64,
    /// Rows of parts before this one, and rows between parts, that could not be written.
    lost: u64,
    raw: RawWriter,
    /// The number of the part that is being written, from 1.
    number: usize,
}

impl TraceWriter {
    /// Creates the trace `path` (`trace.parquet`), and `trace-2.parquet` and so on beside it if there are more than
    /// `most_rows`, for example an hour of them. Until it is finished the rows are in `trace.raw`, `trace-2.raw`. `about`
    /// are (key, value) pairs of metadata.
    ///
    /// # Errors
    /// If the file cannot be written, or a crash has left a trace of that name.
    pub fn create(path: &Path, columns: &[Column], about: &[(&str, String)], most_rows: u64) -> Result<Self, Error> {
        let about = about.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect();
        let header = Header { columns: columns.to_vec(), about };
        let raw = RawWriter::create(&path.with_extension("raw"), &header)?;
        Ok(Self { path: path.to_owned(), header, most_rows: most_rows.max(1), in_part: 0, lost: 0, raw, number: 1 })
    }

    /// Reserves room on the disk for the first `rows` rows, or for a whole part of them.
    ///
    /// # Errors
    /// If the disk has not so much room. File systems that cannot reserve are no error.
    pub fn reserve(&self, rows: u64) -> Result<(), Error> {
        self.raw.reserve(rows.min(self.most_rows))
    }

    /// Adds one row, with one value a column.
    ///
    /// # Errors
    /// If the row has another length (it is then left out), or the file cannot be written: rows of the last second may
    /// then be lost, and later ones may be tried.
    pub fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), Error> {
        if self.in_part == self.most_rows
            && let Err(error) = self.next_part()
        {
            self.lost += 1;
            return Err(error);
        }
        self.in_part += 1;
        self.raw.row(values)
    }

    /// Puts all rows so far on the disk.
    pub fn flush(&mut self) -> Result<(), Error> {
        self.raw.flush()
    }

    /// Rows that could not be written so far.
    pub fn lost(&self) -> u64 {
        self.lost + self.raw.lost
    }

    /// Goes on in a new raw file.
    fn next_part(&mut self) -> Result<(), Error> {
        self.raw.flush()?;
        let raw = RawWriter::create(&self.part_path(self.number + 1).with_extension("raw"), &self.header)?;
        let last = std::mem::replace(&mut self.raw, raw);
        self.lost += last.lost;
        (self.number, self.in_part) = (self.number + 1, 0);
        Ok(())
    }

    /// The Parquet file of the `number`th part, from 1.
    fn part_path(&self, number: usize) -> PathBuf {
        if number == 1 {
            return self.path.clone();
        }
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        self.path.with_file_name(format!("{stem}-{number}.parquet"))
    }

    /// Ends the trace. Its rows are still in raw files: [`super::recover()`] makes Parquet files of them.
    ///
    /// # Errors
    /// If the last rows cannot be written.
    pub fn close(mut self) -> Result<(), Error> {
        self.raw.flush()
    }

    /// Ends the trace: its Parquet files, in order.
    ///
    /// # Errors
    /// If a file cannot be written; its rows are then still in the raw file, for [`super::recover()`].
    #[cfg(feature = "library")]
    pub fn finish(self) -> Result<Vec<super::RecoveredPart>, Error> {
        let folder = self.path.parent().map(Path::to_owned).unwrap_or_default();
        let closed = self.close();
        let parts = super::recover(&folder)?;
        closed.map(|()| parts)
    }
}

#[cfg(all(test, feature = "library"))]
mod tests {
    use super::*;
    use crate::trace::column::Kind;
    use crate::trace::read::Trace;
    use crate::trace::recover::{RecoveredPart, recover};
    use std::fs;

    fn columns() -> Vec<Column> {
        vec![
            Column::new("t_s", "s", Kind::F64),
            Column::new("x_mm", "mm", Kind::F32),
            Column::new("pass", "1", Kind::U32),
            Column::new("phase", "1", Kind::U8),
        ]
    }

    fn row(i: u32) -> [f64; 4] {
        let t = f64::from(i) * 1e-3;
        [
            t,
            if i.is_multiple_of(7) { f64::NAN } else { -t.sin() },
            f64::from(i.wrapping_mul(65_537)),
            f64::from(i % 256),
        ]
    }

    fn read(path: &Path) -> Vec<[f64; 4]> {
        let mut rows = Vec::new();
        let trace = Trace::open(path).unwrap();
        assert_eq!(trace.columns(), columns());
        trace.read(&["t_s", "x_mm", "pass", "phase"], |v| rows.push([v[0], v[1], v[2], v[3]])).unwrap();
        assert_eq!(rows.len() as u64, trace.rows());
        rows
    }

    fn check(rows: &[[f64; 4]], first: u32) {
        for (i, found) in (first..).zip(rows) {
            let wanted = row(i);
            assert_eq!(found[0].to_bits(), wanted[0].to_bits());
            assert!(found[1].to_bits() == f64::from(wanted[1] as f32).to_bits(), "{i}");
            assert_eq!([found[2] as u32, found[3] as u32], [i.wrapping_mul(65_537), i % 256]);
        }
    }

    #[test]
    fn what_is_written_is_read_part_by_part() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trace.parquet");
        // More than a row group, and a part that ends in the middle of one.
        let most = 66_000;
        let mut writer = TraceWriter::create(&path, &columns(), &[("title", "a weld".to_owned())], most).unwrap();
        for i in 0..140_000 {
            writer.row(row(i)).unwrap();
        }
        let parts = writer.finish().unwrap();
        let names: Vec<_> = parts.iter().map(|p| p.path.file_name().unwrap().to_str().unwrap()).collect();
        assert_eq!(names, ["trace.parquet", "trace-2.parquet", "trace-3.parquet"]);
        assert_eq!(parts.iter().map(|p| p.rows).collect::<Vec<_>>(), [66_000, 66_000, 8_000]);
        let mut first = 0;
        for part in &parts {
            let rows = read(&part.path);
            assert_eq!(rows.len() as u64, part.rows);
            check(&rows, first);
            first += rows.len() as u32;
        }
        let trace = Trace::open(&path).unwrap();
        assert_eq!(trace.about(), [("title".to_owned(), "a weld".to_owned())]);
        let told = trace.read(&["y_mm"], |_| {}).unwrap_err().to_string();
        assert!(told.contains("column y_mm does not exist") && told.contains("t_s, x_mm"), "{told}");
        // No other files are left.
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
    }

    #[test]
    fn many_parts_follow_each_other() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trace.parquet");
        let mut writer = TraceWriter::create(&path, &columns(), &[], 5).unwrap();
        (0..1000).for_each(|i| writer.row(row(i)).unwrap());
        let parts = writer.finish().unwrap();
        assert_eq!(parts.len(), 200);
        for (first, part) in (0..).step_by(5).zip(&parts) {
            check(&read(&part.path), first);
        }
    }

    #[test]
    fn what_a_crash_leaves_is_recovered() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("trace.parquet");
        let mut writer = TraceWriter::create(&path, &columns(), &[], u64::MAX).unwrap();
        (0..5000).for_each(|i| writer.row(row(i)).unwrap());
        writer.flush().unwrap();
        assert!(recover(folder.path()).unwrap().is_empty(), "it is being written");
        let raw = folder.path().join("trace.raw");
        let whole = fs::read(&raw).unwrap();
        drop(writer);
        fs::write(&raw, [&whole[..], b"BLCK torn"].concat()).unwrap();
        let recovered = recover(folder.path()).unwrap();
        assert_eq!(recovered, [RecoveredPart { path: path.clone(), rows: 5000, unread_bytes: 9 }]);
        check(&read(&path), 0);
        assert!(!raw.exists() && recover(folder.path()).unwrap().is_empty());
        // Without a header no rows are readable, and no file is removed.
        fs::write(&raw, &whole[..30]).unwrap();
        assert_eq!(recover(folder.path()).unwrap()[0].rows, 0);
        assert_eq!(fs::read(folder.path().join("trace.raw.damaged")).unwrap(), &whole[..30]);
    }
}
