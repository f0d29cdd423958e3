use schemars::JsonSchema;
use seamwright_message::{Argument, Language, Message, Quantity};
use serde::Serialize;
use ts_rs::TS;

/// A message as data, and its English text.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
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

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_message::{Catalogue, Unit};
    use serde_json::json;

    fn messages() -> Vec<Message> {
        let quantity = |value, unit, decimals| Quantity { value, unit, decimals };
        let speed = Argument::Range(quantity(1.5, Unit::MmPerS, 1), quantity(2.25, Unit::MmPerS, 1));
        vec![
            Message::verbatim("a name: {x}"),
            Message::new("document-between").value("min", 0.5, Unit::Mm).value("max", 1000.0, Unit::Mm),
            Message::new("document-at-least").quantity("min", -118.2664, Unit::Deg, 1),
            Message::new("document-at-most").quantity("max", 0.125, Unit::KiloJPerMm, 2),
            Message::new("document-more-than").number("min", 2.5, 0),
            Message::new("quantity").with("value", speed),
            Message::new("quantity").message("value", Message::new("document-too-large")),
            Message::new("quantity").pass("value", 12),
            Message::new("quantity")
                .list("value", [Argument::Axis("x".into()), Argument::Count(1200), Argument::Pass(3)]),
            Message::new("panel-audit-whole").count("n", 1),
            Message::new("panel-audit-whole").count("n", 3),
            Message::new("panel-audit-whole").count("n", 12_345),
            Message::new("document-unknown-key").key("key", "weld.speed_mm_s"),
            Message::new("document-up-to")
                .value("max", 1e6, Unit::MmPerS3)
                .message("reason", Message::new("document-bound-hour")),
        ]
    }

    /// The panel formats these as this program does: a test of `web/src/words` reads the file. `SEAMWRIGHT_BLESS=1`
    /// rewrites it.
    #[test]
    fn the_panel_has_messages_to_compare_with() {
        let cases: Vec<_> = messages()
            .iter()
            .map(|message| {
                let mut text: serde_json::Map<_, _> = Language::ALL
                    .map(|of| (of.code().to_owned(), message.in_language(of).into()))
                    .into_iter()
                    .collect();
                text.insert("pseudo".to_owned(), Catalogue::pseudo().text(message).into());
                json!({ "message": MessageView::from(message), "text": text })
            })
            .collect();
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web/src/words/formatted.json");
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            let lines: Vec<String> = cases.iter().map(ToString::to_string).collect();
            std::fs::write(path, format!("[\n{}\n]\n", lines.join(",\n"))).unwrap();
        }
        let file: Vec<serde_json::Value> = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        assert!(file == cases, "{path}: SEAMWRIGHT_BLESS=1 writes it anew");
    }
}
