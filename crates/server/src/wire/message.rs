use schemars::JsonSchema;
use seamwright_message::{Argument, Language, Message, Quantity};
use serde::Serialize;
use ts_rs::TS;

/// A message as data, and its English text.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct MessageView {
    /// Identifier of the words in the catalogues; `text` is text as it stands.
    pub code: String,
    /// English text.
    pub text: String,
    /// Arguments by name.
    pub arguments: Vec<(String, ArgumentView)>,
}

/// An argument of a message.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
#[serde(tag = "type", content = "value", rename_all = "snake_case")]
pub enum ArgumentView {
    /// A value with its unit.
    Quantity(QuantityView),
    /// Smallest and largest value.
    Range(QuantityView, QuantityView),
    /// A number of things; selects the plural form.
    Count(u32),
    /// Name of an axis.
    Axis(String),
    /// Key in a file.
    Key(String),
    /// Pass, counted from 1.
    Pass(u32),
    /// Text shown as it is.
    Text(String),
    /// A message within the message.
    Message(Box<MessageView>),
    /// Several arguments, shown one after another.
    List(Vec<ArgumentView>),
}

/// A value with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct QuantityView {
    /// Value in `unit`.
    pub value: f64,
    /// Identifier of the unit in the catalogues, like `unit-mm-per-s`; empty for a number without a unit.
    pub unit: String,
    /// Number of decimals to show.
    pub decimals: u8,
}

impl From<&Message> for MessageView {
    fn from(message: &Message) -> Self {
        Self {
            code: message.code.to_string(),
            text: message.in_language(Language::English),
            arguments: message.arguments.iter().map(|(name, argument)| (name.to_string(), argument.into())).collect(),
        }
    }
}

impl From<Message> for MessageView {
    fn from(message: Message) -> Self {
        (&message).into()
    }
}

impl From<&Argument> for ArgumentView {
    fn from(argument: &Argument) -> Self {
        match argument {
            Argument::Quantity(quantity) => Self::Quantity(quantity.into()),
            Argument::Range(from, to) => Self::Range(from.into(), to.into()),
            Argument::Count(count) => Self::Count(u32::try_from(*count).unwrap_or(u32::MAX)),
            Argument::Axis(text) => Self::Axis(text.clone()),
            Argument::Key(text) => Self::Key(text.clone()),
            Argument::Pass(pass) => Self::Pass(*pass as u32),
            Argument::Text(text) => Self::Text(text.clone()),
            Argument::Message(message) => Self::Message(Box::new(message.as_ref().into())),
            Argument::List(items) => Self::List(items.iter().map(Into::into).collect()),
        }
    }
}

impl From<&Quantity> for QuantityView {
    fn from(quantity: &Quantity) -> Self {
        let unit =
            if quantity.unit == seamwright_message::Unit::One { String::new() } else { quantity.unit.identifier() };
        Self { value: quantity.value, unit, decimals: quantity.decimals }
    }
}
