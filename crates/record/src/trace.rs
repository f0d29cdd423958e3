use parquet::basic::{Compression, Repetition, Type as PhysicalType};
use parquet::data_type::DoubleType;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::Write;
use std::sync::Arc;
use thiserror::Error;

/// Rows kept in memory before they are written as one row group.
const ROW_GROUP: usize = 65_536;

/// Why a trace cannot be written.
#[derive(Debug, Error)]
#[error("the trace cannot be written: {0}")]
pub struct Error(#[from] parquet::errors::ParquetError);

/// Writes a trace row by row; all columns are 64-bit floats. Memory stays bounded by one row group.
pub struct TraceWriter<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    columns: Vec<Vec<f64>>,
}

impl<W: Write + Send> TraceWriter<W> {
    /// A trace with `columns` of (name, unit), and `about` as (key, value) pairs of metadata.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn new(out: W, columns: &[(String, &str)], about: &[(&str, String)]) -> Result<Self, Error> {
        let fields = columns.iter().map(|(name, _)| {
            let field = Type::primitive_type_builder(name, PhysicalType::DOUBLE).with_repetition(Repetition::REQUIRED);
            field.build().map(Arc::new)
        });
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let schema = Arc::new(Type::group_type_builder("trace").with_fields(fields).build()?);
        let units = columns.iter().map(|(name, unit)| KeyValue::new(format!("unit:{name}"), (*unit).to_owned()));
        let about = about.iter().map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()));
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(units.chain(about).collect()))
            .build();
        let writer = SerializedFileWriter::new(out, schema, Arc::new(properties))?;
        Ok(Self { writer, columns: vec![Vec::with_capacity(ROW_GROUP); columns.len()] })
    }

    /// Adds one row, with one value a column.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), Error> {
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(value);
        }
        if self.columns.first().is_some_and(|c| c.len() >= ROW_GROUP) {
            self.flush()?;
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Error> {
        let mut group = self.writer.next_row_group()?;
        for column in &mut self.columns {
            if let Some(mut writer) = group.next_column()? {
                writer.typed::<DoubleType>().write_batch(column, None, None)?;
                writer.close()?;
            }
            column.clear();
        }
        group.close()?;
        Ok(())
    }

    /// Writes what is left and the file's end.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn finish(mut self) -> Result<W, Error> {
        if self.columns.first().is_some_and(|c| !c.is_empty()) {
            self.flush()?;
        }
        Ok(self.writer.into_inner()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

    #[test]
    fn what_is_written_is_read() {
        let columns = [("t_s".to_owned(), "s"), ("x_mm".to_owned(), "mm")];
        let mut writer = TraceWriter::new(Vec::new(), &columns, &[("title", "a weld".to_owned())]).unwrap();
        let rows = ROW_GROUP + 10;
        for i in 0..rows {
            writer.row([i as f64 * 1e-3, -(i as f64)]).unwrap();
        }
        let bytes = bytes::Bytes::from(writer.finish().unwrap());
        let reader = SerializedFileReader::new(bytes).unwrap();
        let metadata = reader.metadata().file_metadata();
        assert_eq!(metadata.num_rows(), rows as i64);
        let pairs = metadata.key_value_metadata().unwrap();
        let value = |key: &str| pairs.iter().find(|p| p.key == key).and_then(|p| p.value.clone());
        assert_eq!(value("unit:x_mm").as_deref(), Some("mm"));
        assert_eq!(value("title").as_deref(), Some("a weld"));
        for (i, row) in reader.get_row_iter(None).unwrap().enumerate() {
            let row = row.unwrap();
            assert!((row.get_double(0).unwrap() - i as f64 * 1e-3).abs() < 1e-12);
            assert!((row.get_double(1).unwrap() + i as f64).abs() < 1e-12);
        }
    }
}
