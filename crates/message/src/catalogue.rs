use crate::argument::{Argument, Quantity};
use crate::language::Language;
use crate::message::Message;
use crate::sources::{AREAS, source};
use crate::unit::Unit;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use std::borrow::Cow;
use std::fmt;
use std::sync::LazyLock;

/// The words of one language.
pub struct Catalogue {
    language: Language,
    bundle: FluentBundle<FluentResource>,
}

/// Each is parsed when it is used first: most processes speak one language.
static CATALOGUES: [LazyLock<Catalogue>; 5] = [
    LazyLock::new(|| Catalogue::new(Language::English)),
    LazyLock::new(|| Catalogue::new(Language::Ukrainian)),
    LazyLock::new(|| Catalogue::new(Language::Chinese)),
    LazyLock::new(|| Catalogue::new(Language::German)),
    LazyLock::new(|| Catalogue::new(Language::Russian)),
];

impl Catalogue {
    /// The catalogue of `language`.
    pub fn of(language: Language) -> &'static Self {
        &CATALOGUES[language as usize]
    }

    /// Creates a catalogue of English with accents on its letters and 40 % more of them. Text that is not from a catalogue
    /// stands out in it, and so do places that have no room for a longer language.
    pub fn pseudo() -> Self {
        let mut pseudo = Self::new(Language::English);
        pseudo.bundle.set_transform(Some(accented));
        pseudo
    }

    fn new(language: Language) -> Self {
        let mut bundle = FluentBundle::new_concurrent(vec![language.identifier()]);
        // Terminals and logs show the marks of Unicode that would isolate arguments.
        bundle.set_use_isolating(false);
        for area in AREAS {
            // A part with a syntax error is left out, and the first definition of a code wins. Tests refuse both; a
            // program in a shop continues with the rest.
            let resource = match FluentResource::try_new(source(language, area).into_owned()) {
                Ok(resource) | Err((resource, _)) => resource,
            };
            let _ = bundle.add_resource(resource);
        }
        Self { language, bundle }
    }

    /// True if there are words for `code`.
    pub fn has(&self, code: &str) -> bool {
        self.bundle.get_message(code).is_some_and(|found| found.value().is_some())
    }

    /// Text of `message`. A message without words, or without an argument that its words need, is printed as its code and
    /// arguments.
    pub fn text(&self, message: &Message) -> String {
        let Some(pattern) = self.bundle.get_message(&message.code).and_then(|found| found.value()) else {
            return message.as_data();
        };
        let mut arguments = FluentArgs::new();
        for (name, argument) in &message.arguments {
            arguments.set(name.as_ref(), self.value(argument));
        }
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(&arguments), &mut errors);
        if errors.is_empty() { text.into_owned() } else { message.as_data() }
    }

    /// Text of a value with its unit.
    pub fn quantity(&self, quantity: Quantity) -> String {
        self.with_unit(&self.number(quantity), quantity.unit)
    }

    /// Symbol of a unit without a number, like `mm/s`; empty for numbers without a unit.
    pub fn symbol(&self, unit: Unit) -> String {
        self.with_unit("", unit).trim().to_owned()
    }

    fn number(&self, quantity: Quantity) -> String {
        let number = format!("{:.*}", usize::from(quantity.decimals), quantity.value);
        // No negative zero.
        let zero = number.starts_with('-') && number.chars().all(|c| matches!(c, '-' | '0' | '.'));
        let number = if zero { &number[1..] } else { &number };
        number.replace('.', &self.language.decimal_sign().to_string())
    }

    fn with_unit(&self, number: &str, unit: Unit) -> String {
        if unit == Unit::One {
            return number.to_owned();
        }
        let Some(pattern) = self.bundle.get_message(&unit.identifier()).and_then(|found| found.value()) else {
            return format!("{number} {unit}");
        };
        let mut arguments = FluentArgs::new();
        arguments.set("number", number);
        self.bundle.format_pattern(pattern, Some(&arguments), &mut Vec::new()).into_owned()
    }

    fn value<'a>(&self, argument: &'a Argument) -> FluentValue<'a> {
        match argument {
            Argument::Quantity(quantity) => self.quantity(*quantity).into(),
            Argument::Range(from, to) => {
                self.with_unit(&format!("{}–{}", self.number(*from), self.number(*to)), from.unit).into()
            }
            // As a number it selects the plural form.
            Argument::Count(count) => FluentValue::from(*count),
            // As text it has no plural form and no grouping.
            Argument::Pass(pass) => pass.to_string().into(),
            Argument::Axis(text) | Argument::Key(text) | Argument::Text(text) => text.as_str().into(),
            Argument::Message(message) => self.text(message).into(),
            Argument::List(items) => items.iter().map(|item| self.plain(item)).collect::<Vec<_>>().join(", ").into(),
        }
    }

    fn plain(&self, argument: &Argument) -> String {
        match argument {
            Argument::Count(count) => count.to_string(),
            other => match self.value(other) {
                FluentValue::String(text) => text.into_owned(),
                _ => other.to_string(),
            },
        }
    }
}

/// Puts accents on letters, and repeats every second vowel.
fn accented(text: &str) -> Cow<'_, str> {
    let mut longer = String::with_capacity(2 * text.len());
    for letter in text.chars() {
        let (accented, times) = match letter {
            'a' => ('á', 2),
            'e' => ('é', 2),
            'i' => ('í', 2),
            'o' => ('ó', 2),
            'u' => ('ú', 2),
            'n' => ('ñ', 1),
            'c' => ('ç', 1),
            's' => ('š', 1),
            'A' => ('Á', 2),
            'E' => ('É', 2),
            'S' => ('Š', 1),
            'C' => ('Ç', 1),
            other => (other, 1),
        };
        (0..times).for_each(|_| longer.push(accented));
    }
    Cow::Owned(longer)
}

impl Message {
    /// Returns the words in `language`.
    pub fn in_language(&self, language: Language) -> String {
        Catalogue::of(language).text(self)
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.in_language(Language::of_process()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_decimal_sign_and_units_of_the_language() {
        let value = |value: f64, unit, decimals| Quantity { value, unit, decimals };
        let text = |language, quantity| Catalogue::of(language).quantity(quantity);
        assert_eq!(text(Language::English, value(-118.2664, Unit::Mm, 3)), "-118.266 mm");
        assert_eq!(text(Language::German, value(-118.2664, Unit::Mm, 3)), "-118,266 mm");
        assert_eq!(text(Language::Russian, value(9.5, Unit::MmPerS, 1)), "9,5 мм/с");
        assert_eq!(text(Language::English, value(12.34, Unit::Deg, 1)), "12.3°");
        assert_eq!(text(Language::English, value(-1e-9, Unit::S, 2)), "0.00 s");
        let range =
            Message::new("quantity").with("value", Argument::Range(value(1.5, Unit::Mm, 1), value(2.0, Unit::Mm, 1)));
        assert_eq!(range.in_language(Language::German), "1,5–2,0 mm");
        assert_eq!(text(Language::English, value(0.5, Unit::One, 2)), "0.50");
    }

    #[test]
    fn a_code_without_words_or_arguments_is_printed_as_it_is() {
        let english = Catalogue::of(Language::English);
        assert_eq!(english.text(&Message::new("no-such-code").count("n", 3)), "no-such-code: n = 3");
        assert_eq!(english.text(&Message::new("quantity")), "quantity");
    }

    #[test]
    fn the_pseudo_language_leaves_arguments_as_they_are() {
        let message = Message::new("quantity").text("value", "saddle");
        assert_eq!(Catalogue::pseudo().text(&message), "saddle");
        assert_eq!(accented("speed"), "špééééd");
    }
}
