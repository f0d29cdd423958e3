use serde::{Deserialize, Serialize};

/// Storage type of a column's values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// 64-bit float: time and positions.
    F64,
    /// 32-bit float, good to 7 digits.
    F32,
    /// Whole number up to 4,294,967,295.
    U32,
    /// A state: whole number up to 255.
    U8,
}

impl Kind {
    /// Bytes of a value in the raw file.
    pub(crate) fn bytes(self) -> usize {
        match self {
            Self::F64 => 8,
            Self::F32 | Self::U32 => 4,
            Self::U8 => 1,
        }
    }

    /// Appends `value`. Whole numbers are cut off at their ends; no number becomes 0.
    pub(crate) fn put(self, value: f64, out: &mut Vec<u8>) {
        match self {
            Self::F64 => out.extend_from_slice(&value.to_le_bytes()),
            Self::F32 => out.extend_from_slice(&(value as f32).to_le_bytes()),
            Self::U32 => out.extend_from_slice(&(value as u32).to_le_bytes()),
            Self::U8 => out.push(value as u8),
        }
    }
}

/// A column of a trace.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Name, which ends in the unit.
    pub name: String,
    /// Unit; `1` for numbers without a unit.
    pub unit: String,
    /// Storage type of its values.
    pub kind: Kind,
}

impl Column {
    /// A column of that name, unit and kind.
    pub fn new(name: impl Into<String>, unit: impl Into<String>, kind: Kind) -> Self {
        Self { name: name.into(), unit: unit.into(), kind }
    }
}
