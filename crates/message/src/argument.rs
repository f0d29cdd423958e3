use crate::message::Message;
use crate::unit::Unit;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A measured or allowed value, with the decimals that are worth showing.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Quantity {
    /// Value in `unit`.
    pub value: f64,
    /// Unit of `value`.
    pub unit: Unit,
    /// Number of decimals to show.
    pub decimals: u8,
}

/// An argument of a [`Message`].
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "type", content = "value", rename_all = "snake_case")]
pub enum Argument {
    /// A value with its unit.
    Quantity(Quantity),
    /// Values from the first to the second, in the same unit.
    Range(Quantity, Quantity),
    /// A number of things; selects the plural form.
    Count(u64),
    /// Name of an axis, as in the machine file.
    Axis(String),
    /// Key in a file, like `seam.nozzle.radius_mm`.
    Key(String),
    /// Pass, counted from 1.
    Pass(usize),
    /// Text shown as it is: a name, a value as written in a file, an address.
    Text(String),
    /// A message within the message.
    Message(Box<Message>),
    /// Several arguments, shown one after another.
    List(Vec<Argument>),
}

impl Quantity {
    /// A value with as many decimals as it has, up to nine; 9.999999999999998 has none.
    pub fn exact(value: f64, unit: Unit) -> Self {
        let text = format!("{value:.9}");
        let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.trim_end_matches('0').len());
        Self { value, unit, decimals: decimals as u8 }
    }
}

impl PartialEq for Quantity {
    /// Compares the bits of the values, so that messages can be compared and counted.
    fn eq(&self, other: &Self) -> bool {
        (self.value.to_bits(), self.unit, self.decimals) == (other.value.to_bits(), other.unit, other.decimals)
    }
}

impl Eq for Quantity {}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:.*}", usize::from(self.decimals), self.value)?;
        if self.unit == Unit::One { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}

impl fmt::Display for Argument {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Quantity(quantity) => quantity.fmt(f),
            Self::Range(from, to) => write!(f, "{from} to {to}"),
            Self::Count(count) => count.fmt(f),
            Self::Pass(pass) => pass.fmt(f),
            Self::Axis(text) | Self::Key(text) | Self::Text(text) => f.write_str(text),
            Self::Message(message) => write!(f, "({})", message.as_data()),
            Self::List(items) => {
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        f.write_str(", ")?;
                    }
                    item.fmt(f)?;
                }
                Ok(())
            }
        }
    }
}
