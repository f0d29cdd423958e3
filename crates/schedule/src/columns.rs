//! Result files with a line for each row: CSV and Parquet, written row by row.

use parquet::basic::{Compression, ConvertedType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_record::WholeFile;
use std::borrow::Cow;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

/// Rows of a group in the Parquet file.
const GROUP: usize = 10_000;

/// Kind of the values of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Text,
    Whole,
    /// A number that may be missing.
    Number,
}

/// A column of the result files.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Column {
    pub(crate) name: Cow<'static, str>,
    pub(crate) kind: Kind,
}

impl Column {
    pub(crate) fn new(name: impl Into<Cow<'static, str>>, kind: Kind) -> Self {
        Self { name: name.into(), kind }
    }
}

/// Value of a column in a row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    Text(String),
    Whole(i64),
    Number(Option<f64>),
}

/// Both files.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ResultFiles<'a> {
    /// Name of the rows in the Parquet file.
    pub(crate) name: &'a str,
    pub(crate) csv: &'a Path,
    pub(crate) parquet: &'a Path,
    /// Decimals of numbers in the CSV file; none for all.
    pub(crate) decimals: Option<usize>,
}

/// Takes the rows.
pub(crate) struct RowWriter<'a> {
    csv: &'a mut dyn Write,
    groups: Groups<BufWriter<&'a mut WholeFile>>,
    decimals: Option<usize>,
}

impl ResultFiles<'_> {
    /// Writes the rows that `fill` pushes.
    pub(crate) fn write(
        &self,
        columns: Vec<Column>,
        fill: &mut dyn FnMut(&mut RowWriter<'_>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let failed = |e: std::io::Error| files::not_writable(self.parquet, &e);
        let mut parquet = WholeFile::create(self.parquet).map_err(failed)?;
        files::write_with(self.csv, |csv| {
            let names: Vec<String> = columns.iter().map(|column| quoted(&column.name)).collect();
            writeln!(csv, "{}", names.join(","))?;
            let groups = Groups::new(BufWriter::new(&mut parquet), self.name, columns).map_err(|e| of_parquet(&e))?;
            let mut rows = RowWriter { csv, groups, decimals: self.decimals };
            fill(&mut rows)?;
            rows.groups.finish().map_err(|e| of_parquet(&e))
        })?;
        parquet.finish().map_err(failed)
    }
}

impl RowWriter<'_> {
    /// Adds a row, in the order of the columns.
    pub(crate) fn push(&mut self, row: Vec<Value>) -> Result<(), Failure> {
        writeln!(self.csv, "{}", csv_line(&row, self.decimals))?;
        self.groups.push(row).map_err(|e| of_parquet(&e))
    }
}

pub(crate) fn of_parquet(error: &ParquetError) -> Failure {
    Failure::environment(error.to_string())
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

fn csv_line(values: &[Value], decimals: Option<usize>) -> String {
    let number = |v: f64| decimals.map_or_else(|| v.to_string(), |decimals| format!("{v:.decimals$}"));
    let cell = |value: &Value| match value {
        Value::Text(text) => quoted(text),
        Value::Whole(number) => number.to_string(),
        Value::Number(value) => value.map_or(String::new(), number),
    };
    values.iter().map(cell).collect::<Vec<_>>().join(",")
}

/// Rows of the Parquet file, written in groups.
struct Groups<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    columns: Vec<Column>,
    rows: Vec<Vec<Value>>,
}

impl<W: Write + Send> Groups<W> {
    fn new(out: W, name: &str, columns: Vec<Column>) -> Result<Self, ParquetError> {
        let field = |Column { name, kind }: &Column| {
            let (physical, repetition) = match kind {
                Kind::Text => (PhysicalType::BYTE_ARRAY, Repetition::REQUIRED),
                Kind::Whole => (PhysicalType::INT64, Repetition::REQUIRED),
                Kind::Number => (PhysicalType::DOUBLE, Repetition::OPTIONAL),
            };
            let field = Type::primitive_type_builder(name, physical).with_repetition(repetition);
            let field = if *kind == Kind::Text { field.with_converted_type(ConvertedType::UTF8) } else { field };
            field.build().map(Arc::new)
        };
        let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
        let schema = Arc::new(Type::group_type_builder(name).with_fields(fields).build()?);
        let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
        Ok(Self { writer: SerializedFileWriter::new(out, schema, Arc::new(properties))?, columns, rows: Vec::new() })
    }

    fn push(&mut self, row: Vec<Value>) -> Result<(), ParquetError> {
        self.rows.push(row);
        if self.rows.len() == GROUP { self.write_group() } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        let mut group = self.writer.next_row_group()?;
        for i in 0..self.columns.len() {
            let Some(mut out) = group.next_column()? else { continue };
            let column = self.rows.iter().map(|row| &row[i]);
            match self.columns[i].kind {
                Kind::Text => {
                    let text = |value: &Value| match value {
                        Value::Text(text) => ByteArray::from(text.as_str()),
                        _ => ByteArray::from(""),
                    };
                    let texts: Vec<ByteArray> = column.map(text).collect();
                    out.typed::<ByteArrayType>().write_batch(&texts, None, None)?;
                }
                Kind::Whole => {
                    let whole = |value: &Value| if let Value::Whole(number) = value { *number } else { 0 };
                    out.typed::<Int64Type>().write_batch(&column.map(whole).collect::<Vec<_>>(), None, None)?;
                }
                Kind::Number => {
                    let number = |value: &Value| if let Value::Number(number) = value { *number } else { None };
                    let numbers: Vec<Option<f64>> = column.map(number).collect();
                    let levels: Vec<i16> = numbers.iter().map(|v| i16::from(v.is_some())).collect();
                    let present: Vec<f64> = numbers.into_iter().flatten().collect();
                    out.typed::<DoubleType>().write_batch(&present, Some(&levels), None)?;
                }
            }
            out.close()?;
        }
        group.close()?;
        self.rows.clear();
        Ok(())
    }

    fn finish(mut self) -> Result<(), ParquetError> {
        if !self.rows.is_empty() {
            self.write_group()?;
        }
        self.writer.into_inner()?.flush().map_err(|e| ParquetError::External(Box::new(e)))
    }
}
