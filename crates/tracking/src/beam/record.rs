use crate::lead::{Estimate, Sight};
use glam::DVec2;
use seamwright_message::{Message, Unit, display_by_message};
use std::fmt::Write as _;

/// Deviation of a seam at one station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Path length from the start of the weld, mm.
    pub s_mm: f64,
    /// Lateral and height, mm.
    pub deviation: DVec2,
    /// 0 to 1; 0 where the joint was not seen.
    pub confidence: f64,
}

/// Deviations of a seam by path length, stored with the program: at least two rows, s increasing.
#[derive(Debug, Clone, PartialEq)]
pub struct DeviationRecord {
    rows: Vec<Row>,
}

/// Invalid stored deviation, with its location.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordError {
    /// File name as given.
    pub file: String,
    /// Line number, counted from 1.
    pub line: usize,
    /// Column name.
    pub column: &'static str,
    /// Text of the field.
    pub value: String,
    /// Description of the error.
    pub wrong: Message,
    /// Description of the allowed values.
    pub allowed: Message,
}

display_by_message!(RecordError);

impl RecordError {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        Message::new("tracking-record")
            .text("file", &self.file)
            .text("line", self.line.to_string())
            .key("column", self.column)
            .text("value", &self.value)
            .message("wrong", self.wrong.clone())
            .message("allowed", self.allowed.clone())
    }
}

const COLUMNS: [&str; 4] = ["s_mm", "lateral_mm", "height_mm", "confidence"];
/// Allowed text.
const TABLE: Message = Message::new("tracking-record-table");
/// Maximum path length and deviation, mm; larger values are in a wrong unit.
const LONGEST_MM: f64 = 1e6;
const FARTHEST_MM: f64 = 1e3;

impl DeviationRecord {
    /// Returns the rows.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Returns the path lengths of the first and last row, mm.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        // Cannot fail: a record has at least two rows.
        [self.rows[0].s_mm, self.rows[self.rows.len() - 1].s_mm]
    }

    /// Interpolates the deviation linearly at `s_mm`, with the lower confidence of both rows. Beyond the ends it is
    /// constant.
    #[must_use]
    pub fn at(&self, s_mm: f64) -> Row {
        let after = self.rows.partition_point(|row| row.s_mm <= s_mm).clamp(1, self.rows.len() - 1);
        let (a, b) = (&self.rows[after - 1], &self.rows[after]);
        let part = ((s_mm - a.s_mm) / (b.s_mm - a.s_mm)).clamp(0.0, 1.0);
        Row { s_mm, deviation: a.deviation.lerp(b.deviation, part), confidence: a.confidence.min(b.confidence) }
    }

    /// Returns a copy with `by_mm` added to path lengths.
    #[must_use]
    pub fn moved(&self, by_mm: f64) -> Self {
        Self { rows: self.rows.iter().map(|row| Row { s_mm: row.s_mm + by_mm, ..*row }).collect() }
    }

    /// Returns a copy for the opposite direction of travel from `begin_mm`: path and lateral deviation change sign.
    #[must_use]
    pub fn turned(&self, begin_mm: f64) -> Self {
        let row = |row: &Row| Row {
            s_mm: begin_mm - row.s_mm,
            deviation: DVec2::new(-row.deviation.x, row.deviation.y),
            ..*row
        };
        Self { rows: self.rows.iter().rev().map(row).collect() }
    }

    /// Formats the record as CSV with columns `s_mm`, `lateral_mm`, `height_mm`, `confidence`; to 0.1 um.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut text = COLUMNS.join(",");
        text.push('\n');
        for Row { s_mm, deviation, confidence } in &self.rows {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{s_mm:.4},{:.4},{:.4},{confidence:.3}", deviation.x, deviation.y);
        }
        text
    }

    /// Parses CSV, called `file` in errors. Columns may have any order; other columns and empty lines are ignored.
    ///
    /// # Errors
    /// A [`RecordError`] for the first error.
    pub fn from_csv(file: &str, text: &str) -> Result<Self, RecordError> {
        let error = |line: usize, column: &'static str, value: &str, wrong: &'static str, allowed: Message| {
            let wrong = Message::new(wrong);
            let (file, value) = (file.to_owned(), value.chars().take(60).collect());
            RecordError { file, line: line + 1, column, value, wrong, allowed }
        };
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let (first, header) = lines.next().unwrap_or((0, ""));
        let names: Vec<&str> = header.trim_start_matches('\u{feff}').split(',').map(str::trim).collect();
        let mut places = [0; 4];
        for (place, column) in places.iter_mut().zip(COLUMNS) {
            let found = names.iter().position(|name| *name == column);
            *place = found.ok_or_else(|| error(first, column, header, "tracking-record-no-column", TABLE))?;
        }
        let mut rows: Vec<Row> = Vec::new();
        for (i, line) in lines {
            let fields: Vec<&str> = line.split(',').map(str::trim).collect();
            let mut values = [0.0; 4];
            for (k, column) in COLUMNS.into_iter().enumerate() {
                let field = fields.get(places[k]).copied().unwrap_or("");
                let number = field.parse().ok().filter(|v: &f64| v.is_finite());
                values[k] = number.ok_or_else(|| error(i, column, field, "tracking-record-not-finite", TABLE))?;
                let (min, max, unit) = match k {
                    0 => (-LONGEST_MM, LONGEST_MM, Unit::Mm),
                    3 => (0.0, 1.0, Unit::One),
                    _ => (-FARTHEST_MM, FARTHEST_MM, Unit::Mm),
                };
                if !(min..=max).contains(&values[k]) {
                    let allowed = Message::new("document-between").value("min", min, unit).value("max", max, unit);
                    return Err(error(i, column, field, "tracking-record-out-of-range", allowed));
                }
            }
            let [s_mm, lateral, height, confidence] = values;
            if rows.last().is_some_and(|last| s_mm <= last.s_mm) {
                let field = fields.get(places[0]).copied().unwrap_or("");
                let allowed = Message::new("tracking-record-path-lengths");
                return Err(error(i, "s_mm", field, "tracking-record-not-increasing", allowed));
            }
            rows.push(Row { s_mm, deviation: DVec2::new(lateral, height), confidence });
        }
        if rows.len() < 2 {
            return Err(error(text.lines().count().max(1) - 1, "s_mm", "", "tracking-record-too-short", TABLE));
        }
        Ok(Self { rows })
    }
}

/// Records a weld in progress: one row per step of path length that the torch reaches for the first time.
#[derive(Debug, Clone)]
pub struct Recorder {
    rows: Vec<Row>,
    step_mm: f64,
    noise_mm: f64,
}

impl Recorder {
    /// Creates a recorder for a weld of `length_mm`, a row every `step_mm`; confidence 1 means standard deviation
    /// `noise_mm`. Memory is allocated once: rows beyond twice the length are dropped.
    #[must_use]
    pub fn new(length_mm: f64, step_mm: f64, noise_mm: f64) -> Self {
        let room = (2.0 * length_mm / step_mm).ceil().clamp(2.0, 1e7) as usize + 2;
        Self { rows: Vec::with_capacity(room), step_mm, noise_mm }
    }

    /// Adds the estimate with the torch at `s_mm`, if a row is due.
    pub fn add(&mut self, s_mm: f64, estimate: &Estimate) {
        let due = self.rows.last().is_none_or(|last| s_mm >= last.s_mm + self.step_mm);
        if !due || self.rows.len() == self.rows.capacity() || !estimate.value.is_finite() {
            return;
        }
        let confidence = match estimate.sight {
            Sight::Seen | Sight::Bridged => (self.noise_mm / estimate.sigma_mm).clamp(0.0, 1.0),
            _ => 0.0,
        };
        self.rows.push(Row { s_mm, deviation: estimate.value, confidence });
    }

    /// Returns the record; `None` with fewer than two rows.
    #[must_use]
    pub fn finish(self) -> Option<DeviationRecord> {
        (self.rows.len() >= 2).then_some(DeviationRecord { rows: self.rows })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    fn recorded() -> DeviationRecord {
        let mut recorder = Recorder::new(100.0, 0.5, 0.03);
        for i in 0..20_000 {
            // Forward, back for a while, and forward again.
            let t = f64::from(i);
            let s = if i < 8000 {
                0.005 * t
            } else if i < 9000 {
                40.0 - 0.005 * (t - 8000.0)
            } else {
                0.005 * (t - 2000.0)
            };
            let sight = if (20.0..24.0).contains(&s) { Sight::Coasted } else { Sight::Seen };
            let value = DVec2::new((0.1 * s).sin(), 0.01 * s);
            recorder.add(s, &Estimate { value, sigma_mm: 0.04, sight });
        }
        recorder.finish().unwrap()
    }

    #[test]
    fn what_is_written_is_read() {
        let record = recorded();
        assert!(record.rows().windows(2).all(|w| w[1].s_mm >= w[0].s_mm + 0.5) && record.rows().len() > 170);
        for i in 0..1790 {
            let s = 0.05 * f64::from(i);
            let row = record.at(s);
            assert!(row.deviation.distance(DVec2::new((0.1 * s).sin(), 0.01 * s)) < 5e-4, "{s}: {row:?}");
            assert!((19.49..24.01).contains(&s) || (row.confidence - 0.75).abs() < 1e-12, "{s}: {row:?}");
            assert!(!(20.01..23.4).contains(&s) || row.confidence == 0.0);
        }
        let again = DeviationRecord::from_csv("d.csv", &record.to_csv()).unwrap();
        for (a, b) in record.rows().iter().zip(again.rows()) {
            assert!((a.s_mm - b.s_mm).abs() < 1e-4 && a.deviation.distance(b.deviation) < 1e-4);
            assert!((a.confidence - b.confidence).abs() < 1e-3);
        }
        assert_eq!(record.rows().len(), again.rows().len());
        assert_eq!(again.to_csv(), record.to_csv());
    }

    #[test]
    fn moved_and_turned() {
        let record = recorded();
        let (moved, turned) = (record.moved(-7.0), record.turned(60.0));
        for i in 0..500 {
            let s = 0.1 * f64::from(i);
            let row = record.at(s);
            assert!(moved.at(s - 7.0).deviation.distance(row.deviation) < 1e-9);
            assert!(turned.at(60.0 - s).deviation.distance(row.deviation * DVec2::new(-1.0, 1.0)) < 1e-9);
        }
        assert!(turned.rows().windows(2).all(|w| w[0].s_mm < w[1].s_mm));
    }

    #[test]
    fn columns_in_any_order() {
        let text = "\u{feff}confidence, s_mm,note,height_mm,lateral_mm\r\n\r\n1,0,x,0.1,0.2\r\n0.5,10,,0.3,0.4\r\n";
        let record = DeviationRecord::from_csv("d.csv", text).unwrap();
        assert!(record.at(5.0).deviation.distance(DVec2::new(0.3, 0.2)) < 1e-12);
        assert!(record.at(-5.0).deviation.distance(DVec2::new(0.2, 0.1)) < 1e-12);
        assert!(record.at(50.0).deviation.distance(DVec2::new(0.4, 0.3)) < 1e-12);
    }

    #[test]
    fn errors_have_an_address() {
        let head = "s_mm,lateral_mm,height_mm,confidence\n";
        let cases = [
            ("s_mm,lateral_mm,confidence\n", 1, "height_mm", "header"),
            ("", 1, "s_mm", "header"),
            (&format!("{head}0,0,0,1\n"), 2, "s_mm", "two rows"),
            (&format!("{head}0,0,0,1\n1,x,0,1\n"), 3, "lateral_mm", "finite"),
            (&format!("{head}0,0,0,1\n\n1,0,0,-0.1\n"), 4, "confidence", "0 to 1"),
            (&format!("{head}0,0,0,1\n1,0\n"), 3, "height_mm", "finite"),
            (&format!("{head}0,0,0,1\n1,0,inf,1\n"), 3, "height_mm", "finite"),
            (&format!("{head}0,0,0,1\n1,5000,0,1\n"), 3, "lateral_mm", "-1000 mm to 1000 mm"),
            (&format!("{head}0,0,0,1\n0,0,0,1\n"), 3, "s_mm", "increasing"),
        ];
        for (text, line, column, says) in cases {
            let error = DeviationRecord::from_csv("d.csv", text).unwrap_err();
            assert_eq!((error.line, error.column), (line, column), "{error}");
            assert!(error.to_string().contains(says) && error.to_string().starts_with("d.csv:"), "{error}");
        }
    }

    /// A corrupted file is either read as ordered numbers or rejected.
    #[test]
    fn broken_files() {
        let whole = recorded().to_csv().into_bytes();
        let mut random = Random::new(5);
        let mut read = 0;
        for _ in 0..3000 {
            let lines = whole.split_inclusive(|b| *b == b'\n').take(3 + random.below(30));
            let mut text: Vec<u8> = lines.flatten().copied().collect();
            for _ in 0..random.below(4) {
                let at = random.below(text.len());
                text[at] = b"0123456789.,-e\nnaif \xff"[random.below(20)];
            }
            if let Ok(record) = DeviationRecord::from_csv("d.csv", &String::from_utf8_lossy(&text)) {
                read += 1;
                assert!(record.rows().windows(2).all(|w| w[0].s_mm < w[1].s_mm));
                assert!(record.rows().iter().all(|r| r.deviation.is_finite() && (0.0..=1.0).contains(&r.confidence)));
            }
        }
        assert!((800..2900).contains(&read), "{read}");
    }
}
