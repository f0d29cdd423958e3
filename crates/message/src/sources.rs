use crate::language::Language;
use std::borrow::Cow;

/// Declares the areas, each a file in the folder of every language.
macro_rules! areas {
    ($($area:literal),* $(,)?) => {
        /// Names of the areas: the file names of the catalogues.
        pub const AREAS: &[&str] = &[$($area),*];

        /// The catalogue of `language` and `area` in Fluent's syntax; empty if there is no such area.
        #[cfg(not(debug_assertions))]
        pub fn source(language: Language, area: &str) -> Cow<'static, str> {
            macro_rules! of {
                ($code:literal) => {
                    match area {
                        $($area => include_str!(concat!("../../../messages/", $code, "/", $area, ".ftl")),)*
                        _ => "",
                    }
                };
            }
            Cow::Borrowed(match language {
                Language::English => of!("en"),
                Language::Ukrainian => of!("uk"),
                Language::Chinese => of!("zh"),
                Language::German => of!("de"),
                Language::Russian => of!("ru"),
            })
        }
    };
}

areas![
    "units",
    "words",
    "keys",
    "document",
    "machine",
    "program",
    "weld",
    "motion",
    "geometry",
    "clearance",
    "vision",
    "tracking",
    "alarms",
    "cell",
    "record",
    "post",
    "report",
    "schedule",
    "study",
    "project",
    "server",
    "panel",
    "cli",
];

/// The catalogue of `language` and `area` in Fluent's syntax; empty if there is no such area.
///
/// Builds with debug assertions read the files of the working copy, so that a changed sentence rebuilds nothing; release
/// builds have them in the program.
#[cfg(debug_assertions)]
pub fn source(language: Language, area: &str) -> Cow<'static, str> {
    let path = format!("{}/../../messages/{}/{area}.ftl", env!("CARGO_MANIFEST_DIR"), language.code());
    Cow::Owned(std::fs::read_to_string(path).unwrap_or_default())
}
