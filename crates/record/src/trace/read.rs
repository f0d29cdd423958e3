use super::column::{Column, Kind};
use super::parquet_file::ROW_GROUP;
use crate::error::{Doing, Error};
use parquet::basic::{LogicalType, Type as PhysicalType};
use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use seamwright_message::Message;
use std::fs::File;
use std::path::{Path, PathBuf};

/// A trace in a Parquet file, read a row group at a time.
pub struct Trace {
    path: PathBuf,
    reader: SerializedFileReader<File>,
    columns: Vec<Column>,
    about: Vec<(String, String)>,
}

impl Trace {
    /// Opens a trace.
    ///
    /// # Errors
    /// If the file cannot be read or is not a trace.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let file = File::open(path).map_err(|e| Error::io(path, Doing::Read, e))?;
        let reader = SerializedFileReader::new(file).map_err(|e| Error::parquet(path, &e))?;
        let metadata = reader.metadata().file_metadata();
        let pairs = metadata.key_value_metadata().into_iter().flatten();
        let pairs = pairs.map(|p| (p.key.clone(), p.value.clone().unwrap_or_default()));
        let (units, about): (Vec<_>, Vec<_>) = pairs.partition(|(key, _)| key.starts_with("unit:"));
        let columns = metadata.schema_descr().columns().iter().map(|column| {
            let kind = match (column.physical_type(), column.logical_type_ref()) {
                (PhysicalType::DOUBLE, _) => Kind::F64,
                (PhysicalType::FLOAT, _) => Kind::F32,
                (PhysicalType::INT32, Some(LogicalType::Integer(integer))) if integer.bit_width == 8 => Kind::U8,
                (PhysicalType::INT32, _) => Kind::U32,
                (other, _) => {
                    let why = Message::new("record-column-kind")
                        .text("column", column.name())
                        .text("kind", other.to_string());
                    return Err(Error::damaged(path, why, Message::new("record-own-trace")));
                }
            };
            let key = format!("unit:{}", column.name());
            let unit = units.iter().find(|(k, _)| *k == key).map_or("", |(_, unit)| unit.as_str());
            Ok(Column::new(column.name(), unit, kind))
        });
        let columns = columns.collect::<Result<_, _>>()?;
        Ok(Self { path: path.to_owned(), reader, columns, about })
    }

    /// Its columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Description of the weld from the start of the trace.
    pub fn about(&self) -> &[(String, String)] {
        &self.about
    }

    /// Number of rows.
    pub fn rows(&self) -> u64 {
        u64::try_from(self.reader.metadata().file_metadata().num_rows()).unwrap_or(0)
    }

    /// Calls `row` with the values of the columns `names`, row by row.
    pub fn read(&self, names: &[&str], mut row: impl FnMut(&[f64])) -> Result<(), Error> {
        let place = |name: &&str| {
            self.columns.iter().position(|c| c.name == *name).ok_or_else(|| {
                let all: Vec<&str> = self.columns.iter().map(|c| c.name.as_str()).collect();
                let what = Message::new("record-no-column").text("path", self.path.display().to_string());
                Error::wrong(what.text("column", *name), Message::verbatim(all.join(", ")))
            })
        };
        let places = names.iter().map(place).collect::<Result<Vec<usize>, _>>()?;
        let failed = |e| Error::parquet(&self.path, &e);
        let mut values = vec![0.0; names.len()];
        for group in 0..self.reader.num_row_groups() {
            let group = self.reader.get_row_group(group).map_err(failed)?;
            // The decoder panics on negative positions and lengths of columns.
            let is_placed = |column: &ColumnChunkMetaData| {
                let start = column.dictionary_page_offset().unwrap_or(column.data_page_offset());
                start >= 0 && column.compressed_size() >= 0 && column.data_page_offset() >= 0
            };
            let is_whole = group.metadata().columns().iter().all(is_placed);
            if !is_whole || !(0..=ROW_GROUP as i64).contains(&group.metadata().num_rows()) {
                return Err(self.unfit_groups());
            }
            let columns = places.iter().map(|i| column(&*group, *i, self.columns[*i].kind));
            let columns = columns.collect::<Result<Vec<_>, _>>().map_err(failed)?;
            if columns.iter().any(|values| values.len() != columns[0].len()) {
                return Err(self.unfit_groups());
            }
            for i in 0..columns.first().map_or(0, Vec::len) {
                for (value, column) in values.iter_mut().zip(&columns) {
                    *value = column[i];
                }
                row(&values);
            }
        }
        Ok(())
    }

    /// Error of row groups that [`super::TraceWriter`] does not write.
    fn unfit_groups(&self) -> Error {
        let why = Message::new("record-trace-groups").count("max", ROW_GROUP);
        Error::damaged(&self.path, why, Message::new("record-own-trace"))
    }
}

/// Reads a column of a group of [`ROW_GROUP`] rows at most.
fn column(group: &dyn RowGroupReader, place: usize, kind: Kind) -> Result<Vec<f64>, ParquetError> {
    let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
    Ok(match group.get_column_reader(place)? {
        ColumnReader::DoubleColumnReader(mut reader) => {
            let mut values = Vec::with_capacity(count);
            reader.read_records(count, None, None, &mut values)?;
            values
        }
        ColumnReader::FloatColumnReader(mut reader) => {
            let mut values = Vec::with_capacity(count);
            reader.read_records(count, None, None, &mut values)?;
            values.into_iter().map(f64::from).collect()
        }
        ColumnReader::Int32ColumnReader(mut reader) => {
            let mut values = Vec::with_capacity(count);
            reader.read_records(count, None, None, &mut values)?;
            let whole = |v: i32| if kind == Kind::U8 { f64::from(v) } else { f64::from(v as u32) };
            values.into_iter().map(whole).collect()
        }
        _ => Vec::new(),
    })
}
