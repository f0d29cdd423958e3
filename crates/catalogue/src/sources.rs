use crate::Language;

/// Declares the areas, each a file in the folder of every language.
macro_rules! areas {
    ($($area:literal),* $(,)?) => {
        /// Names of the areas: the file names of the catalogues.
        pub const AREAS: &[&str] = &[$($area),*];

        /// The catalogue of `language` and `area` in Fluent's syntax; empty if there is no such area.
        pub fn source(language: Language, area: &str) -> &'static str {
            macro_rules! of {
                ($code:literal) => {
                    match area {
                        $($area => include_str!(concat!("../../../messages/", $code, "/", $area, ".ftl")),)*
                        _ => "",
                    }
                };
            }
            match language {
                Language::English => of!("en"),
                Language::Ukrainian => of!("uk"),
                Language::Chinese => of!("zh"),
                Language::German => of!("de"),
                Language::Russian => of!("ru"),
            }
        }
    };
}

areas!["units"];
