//! A raw file as a Parquet file: row groups of bounded size, each column in the encoding that keeps it small.

use super::column::{Column, Kind};
use super::raw::{Header, RawReader};
use crate::error::{Doing, Error};
use crate::whole_file;
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{DoubleType, FloatType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type};
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

/// Maximum rows of a row group, which is in memory at once.
pub(super) const ROW_GROUP: usize = 65_536;

enum Values {
    F64(Vec<f64>),
    F32(Vec<f32>),
    Whole(Vec<i32>),
}

impl Values {
    fn of(kind: Kind) -> Self {
        match kind {
            Kind::F64 => Self::F64(Vec::with_capacity(ROW_GROUP)),
            Kind::F32 => Self::F32(Vec::with_capacity(ROW_GROUP)),
            Kind::U32 | Kind::U8 => Self::Whole(Vec::with_capacity(ROW_GROUP)),
        }
    }

    /// Takes a value as the raw file has it.
    fn push(&mut self, raw: &[u8]) {
        match (self, raw) {
            (Self::F64(values), &[a, b, c, d, e, f, g, h]) => values.push(f64::from_le_bytes([a, b, c, d, e, f, g, h])),
            (Self::F32(values), &[a, b, c, d]) => values.push(f32::from_le_bytes([a, b, c, d])),
            // Parquet keeps unsigned numbers by their bits in signed ones.
            (Self::Whole(values), &[a, b, c, d]) => values.push(i32::from_le_bytes([a, b, c, d])),
            (Self::Whole(values), &[a]) => values.push(i32::from(a)),
            _ => {}
        }
    }
}

/// Writes the whole blocks of `raw` to the Parquet file `path`. Returns the number of rows.
pub(super) fn write(raw: &mut RawReader, path: &Path) -> Result<u64, Error> {
    let mut file = whole_file::create(path)?;
    let header = raw.header.clone();
    let failed = |e| Error::parquet(path, &e);
    let mut writer = writer(BufWriter::new(file.as_file_mut()), &header).map_err(failed)?;
    let mut columns: Vec<Values> = header.columns.iter().map(|c| Values::of(c.kind)).collect();
    let (mut rows, mut waiting, row_bytes) = (0, 0, raw.row_bytes());
    while let Some(block) = raw.block()? {
        for row in block.chunks_exact(row_bytes) {
            let mut rest = row;
            for (values, column) in columns.iter_mut().zip(&header.columns) {
                let (value, after) = rest.split_at(column.kind.bytes());
                values.push(value);
                rest = after;
            }
            (rows, waiting) = (rows + 1, waiting + 1);
            if waiting == ROW_GROUP {
                write_group(&mut writer, &mut columns).map_err(failed)?;
                waiting = 0;
            }
        }
    }
    if waiting > 0 {
        write_group(&mut writer, &mut columns).map_err(failed)?;
    }
    writer.into_inner().map_err(failed)?.flush().map_err(|e| Error::io(path, Doing::Write, e))?;
    whole_file::finish(file, path)?;
    Ok(rows)
}

fn writer<W: Write + Send>(out: W, header: &Header) -> Result<SerializedFileWriter<W>, ParquetError> {
    let fields = header.columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("trace").with_fields(fields).build()?);
    let units = header.columns.iter().map(|c| KeyValue::new(format!("unit:{}", c.name), c.unit.clone()));
    let about = header.about.iter().map(|(key, value)| KeyValue::new(key.clone(), value.clone()));
    let mut properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(units.chain(about).collect()));
    // Neighbouring values share sign, exponent and leading digits: bytes of one significance together compress well.
    for column in header.columns.iter().filter(|c| matches!(c.kind, Kind::F64 | Kind::F32)) {
        let path = ColumnPath::from(column.name.as_str());
        properties = properties
            .set_column_dictionary_enabled(path.clone(), false)
            .set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT);
    }
    SerializedFileWriter::new(out, schema, Arc::new(properties.build()))
}

fn field(column: &Column) -> Result<Arc<Type>, ParquetError> {
    let whole = |bit_width| (PhysicalType::INT32, Some(LogicalType::integer(bit_width, false)));
    let (physical, logical) = match column.kind {
        Kind::F64 => (PhysicalType::DOUBLE, None),
        Kind::F32 => (PhysicalType::FLOAT, None),
        Kind::U32 => whole(32),
        Kind::U8 => whole(8),
    };
    let field = Type::primitive_type_builder(&column.name, physical).with_repetition(Repetition::REQUIRED);
    field.with_logical_type(logical).build().map(Arc::new)
}

fn write_group<W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    columns: &mut [Values],
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for column in columns {
        let Some(mut out) = group.next_column()? else { continue };
        match column {
            Values::F64(values) => {
                out.typed::<DoubleType>().write_batch(values, None, None)?;
                values.clear();
            }
            Values::F32(values) => {
                out.typed::<FloatType>().write_batch(values, None, None)?;
                values.clear();
            }
            Values::Whole(values) => {
                out.typed::<Int32Type>().write_batch(values, None, None)?;
                values.clear();
            }
        }
        out.close()?;
    }
    group.close().map(drop)
}
