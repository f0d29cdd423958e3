use std::str::FromStr;
use std::sync::atomic::{AtomicU8, Ordering::Relaxed};
use unic_langid::LanguageIdentifier;

/// A language that Seamwright speaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub enum Language {
    /// `en`.
    #[default]
    English,
    /// `uk`.
    Ukrainian,
    /// `zh`, in simplified characters.
    Chinese,
    /// `de`.
    German,
    /// `ru`.
    Russian,
}

/// See [`Language::speak`].
static OF_PROCESS: AtomicU8 = AtomicU8::new(Language::English as u8);

impl Language {
    /// Every language, English first.
    pub const ALL: [Self; 5] = [Self::English, Self::Ukrainian, Self::Chinese, Self::German, Self::Russian];

    /// Sets the language in which this process prints messages, as `setlocale` does for a C program. A server renders
    /// for each of its users with [`Message::in_language`](crate::Message::in_language) instead.
    pub fn speak(self) {
        OF_PROCESS.store(self as u8, Relaxed);
    }

    /// Language in which this process prints messages.
    pub fn of_process() -> Self {
        Self::ALL[usize::from(OF_PROCESS.load(Relaxed)) % Self::ALL.len()]
    }

    /// Code of the language (ISO 639-1).
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Ukrainian => "uk",
            Self::Chinese => "zh",
            Self::German => "de",
            Self::Russian => "ru",
        }
    }

    /// Decimal sign between the integer and fractional digits.
    pub fn decimal_sign(self) -> char {
        match self {
            Self::English | Self::Chinese => '.',
            Self::Ukrainian | Self::German | Self::Russian => ',',
        }
    }

    /// Returns the language of a locale name of the system, like `de_AT.UTF-8` or `zh-Hans`. `C` and `POSIX` are English;
    /// `None` for a language without a catalogue.
    pub fn from_locale(locale: &str) -> Option<Self> {
        let name = locale.split(['.', '@']).next().unwrap_or_default();
        if matches!(name, "C" | "POSIX") {
            return Some(Self::English);
        }
        let code = name.split(['_', '-']).next().unwrap_or_default().to_ascii_lowercase();
        code.parse().ok()
    }

    pub(crate) fn identifier(self) -> LanguageIdentifier {
        // Codes are well-formed (see the test); an undetermined language has the plural forms of no language.
        self.code().parse().unwrap_or_default()
    }
}

impl FromStr for Language {
    type Err = String;

    /// Parses a code.
    ///
    /// # Errors
    /// The codes that are allowed.
    fn from_str(text: &str) -> Result<Self, String> {
        let codes = Self::ALL.map(Self::code).join(", ");
        Self::ALL.into_iter().find(|language| language.code() == text).ok_or(format!("allowed: {codes}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_locales_are_languages() {
        let cases = [
            ("de_AT.UTF-8", Some(Language::German)),
            ("zh-Hans", Some(Language::Chinese)),
            ("uk", Some(Language::Ukrainian)),
            ("RU", Some(Language::Russian)),
            ("C.UTF-8", Some(Language::English)),
            ("POSIX", Some(Language::English)),
            ("fr_FR@euro", None),
            ("", None),
        ];
        for (locale, language) in cases {
            assert_eq!(Language::from_locale(locale), language, "{locale}");
        }
        for language in Language::ALL {
            assert_eq!(language.identifier().to_string(), language.code());
        }
    }
}
