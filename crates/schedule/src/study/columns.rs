//! Result files of a study, and columns read back one at a time: a million draws do not fit into memory together.

use super::draw::DrawResult;
use super::open::Study;
use crate::columns::{Column, Kind, ResultFiles, Value, of_parquet};
use crate::output::findings_text;
use crate::plan_row::Status;
use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use seamwright_project::failure::Failure;
use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;

/// Columns that are neither quantities nor figures.
pub(crate) const OWN: [&str; 6] = ["row", "status", "weldable", "blocking", "findings", "error"];

/// Counts over all draws.
#[derive(Debug, Clone, Default)]
pub(crate) struct Counts {
    /// Draws by outcome.
    pub(crate) outcomes: BTreeMap<&'static str, u64>,
    /// Draws with a finding, by its code.
    pub(crate) findings: BTreeMap<String, u64>,
    /// First fault of an invalid or failed draw.
    pub(crate) first_error: Option<String>,
}

impl Counts {
    fn add(&mut self, result: &DrawResult) {
        *self.outcomes.entry(result.status.word()).or_default() += 1;
        for code in result.findings.keys() {
            *self.findings.entry(code.clone()).or_default() += 1;
        }
        if self.first_error.is_none() {
            self.first_error.clone_from(&result.error);
        }
    }
}

/// Writes a line for each draw, and counts.
pub(crate) fn write_rows(
    study: &Study,
    [csv, parquet]: [&Path; 2],
    result_of: &dyn Fn(&[f64]) -> Result<DrawResult, Failure>,
) -> Result<Counts, Failure> {
    let number = |name: &str| Column::new(name.to_owned(), Kind::Number);
    let mut columns = vec![Column::new("row", Kind::Whole)];
    columns.extend(study.quantities.iter().map(|quantity| number(&quantity.name)));
    columns.extend([Column::new("status", Kind::Text), Column::new("weldable", Kind::Number)]);
    columns.extend(study.figures.iter().map(|figure| number(&figure.name)));
    columns.push(Column::new("blocking", Kind::Whole));
    columns.extend(["findings", "error"].map(|name| Column::new(name, Kind::Text)));
    let mut counts = Counts::default();
    let files = ResultFiles { name: "study", csv, parquet, decimals: None };
    files.write(columns, &mut |rows| {
        for row in 0..study.rows() {
            let values = study.values(row);
            let result = result_of(&values)?;
            counts.add(&result);
            rows.push(cells(study, row, values, result))?;
        }
        Ok(())
    })?;
    Ok(counts)
}

fn cells(study: &Study, row: u64, values: Vec<f64>, result: DrawResult) -> Vec<Value> {
    let is_weldable = f64::from(u8::from(result.status == Status::Weldable));
    let figure = |i: usize| Value::Number(result.figures.get(i).copied().flatten());
    let mut cells = vec![Value::Whole(row as i64 + 1)];
    cells.extend(values.into_iter().map(|value| Value::Number(Some(value))));
    cells.extend([Value::Text(result.status.word().to_owned()), Value::Number(Some(is_weldable))]);
    cells.extend((0..study.figures.len()).map(figure));
    cells.push(Value::Whole(result.blocking as i64));
    cells.push(Value::Text(findings_text(&result.findings)));
    cells.push(Value::Text(result.error.unwrap_or_default()));
    cells
}

/// Columns of a written file.
pub(crate) struct Columns {
    reader: SerializedFileReader<File>,
    quantities: usize,
}

impl Columns {
    pub(crate) fn open(study: &Study, parquet: &Path) -> Result<Self, Failure> {
        let reader = SerializedFileReader::new(File::open(parquet)?).map_err(|e| of_parquet(&e))?;
        Ok(Self { reader, quantities: study.quantities.len() })
    }

    /// Values of quantity `i`, row by row.
    pub(crate) fn quantity(&self, i: usize) -> Result<Vec<f64>, Failure> {
        self.numbers(1 + i)
    }

    /// 1 for draws that can be welded, 0 for others.
    pub(crate) fn weldable(&self) -> Result<Vec<f64>, Failure> {
        self.numbers(self.quantities + 2)
    }

    /// Values of figure `i`, row by row; NaN where a draw has none.
    pub(crate) fn figure(&self, i: usize) -> Result<Vec<f64>, Failure> {
        self.numbers(self.quantities + 3 + i)
    }

    fn numbers(&self, column: usize) -> Result<Vec<f64>, Failure> {
        self.try_numbers(column).map_err(|e| of_parquet(&e))
    }

    fn try_numbers(&self, column: usize) -> Result<Vec<f64>, ParquetError> {
        let mut all = Vec::with_capacity(self.reader.metadata().file_metadata().num_rows() as usize);
        for i in 0..self.reader.num_row_groups() {
            let group = self.reader.get_row_group(i)?;
            let ColumnReader::DoubleColumnReader(mut reader) = group.get_column_reader(column)? else {
                return Err(ParquetError::General(format!("column {column}")));
            };
            let rows = group.metadata().num_rows() as usize;
            let (mut levels, mut values) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
            while levels.len() < rows {
                let (read, ..) = reader.read_records(rows - levels.len(), Some(&mut levels), None, &mut values)?;
                if read == 0 {
                    break;
                }
            }
            let mut present = values.into_iter();
            all.extend(
                levels.iter().map(|level| if *level > 0 { present.next().unwrap_or(f64::NAN) } else { f64::NAN }),
            );
        }
        Ok(all)
    }
}
