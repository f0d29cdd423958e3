use crate::level::Level;
use seamwright_message::{Argument, Language, Message, Quantity, Unit};
use serde_json::{Map, Value, json};
use std::fmt;

/// Logs a failure.
pub fn error(message: &Message) {
    event(Level::Error, message, None);
}

/// Logs an event that needs attention.
pub fn warn(message: &Message) {
    event(Level::Warn, message, None);
}

/// Logs a routine event.
pub fn info(message: &Message) {
    event(Level::Info, message, None);
}

/// Logs a detail for finding a fault.
pub fn debug(message: &Message) {
    event(Level::Debug, message, None);
}

/// Logs a message, with the user who caused it, if any.
pub fn event(level: Level, message: &Message, user: Option<&str>) {
    macro_rules! at {
        ($level:ident) => {
            tracing::event!(
                tracing::Level::$level,
                code = &*message.code,
                arguments = %Arguments(message),
                user,
                "{}",
                English(message)
            )
        };
    }
    // The level of an event is a part of its static description.
    match level {
        Level::Error => at!(ERROR),
        Level::Warn => at!(WARN),
        Level::Info => at!(INFO),
        Level::Debug => at!(DEBUG),
    }
}

/// English words of a message: made only if the event is written.
struct English<'a>(&'a Message);

impl fmt::Display for English<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.in_language(Language::English))
    }
}

/// Arguments of a message as a JSON object.
pub(crate) struct Arguments<'a>(pub(crate) &'a Message);

impl fmt::Display for Arguments<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values = self.0.arguments.iter().map(|(name, argument)| (name.to_string(), value(argument)));
        Value::Object(values.collect::<Map<_, _>>()).fmt(f)
    }
}

fn value(argument: &Argument) -> Value {
    match argument {
        Argument::Quantity(quantity) => number(quantity),
        Argument::Range(from, to) => json!([number(from), number(to)]),
        Argument::Count(count) => json!(count),
        Argument::Pass(pass) => json!(pass),
        Argument::Axis(text) | Argument::Key(text) | Argument::Text(text) => json!(text),
        Argument::Message(message) if message.is_verbatim() => json!(message.in_language(Language::English)),
        Argument::Message(message) => {
            json!({ "code": message.code, "text": message.in_language(Language::English) })
        }
        Argument::List(items) => items.iter().map(value).collect(),
    }
}

fn number(quantity: &Quantity) -> Value {
    match quantity.unit {
        Unit::One => json!(quantity.value),
        unit => json!({ "value": quantity.value, "unit": unit.symbol() }),
    }
}
