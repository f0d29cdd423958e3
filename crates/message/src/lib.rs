//! Messages as data: a stable code with named, typed arguments, and the words of each code in every language.
//!
//! Findings, refusals, document errors, alarms and events are [`Message`]s. Each [`Language`] has a [`Catalogue`] of
//! their words: [Fluent](https://projectfluent.org) files, one per area, in the folder `messages/` of the repository,
//! which the panel uses too. English is a catalogue like the others. No code reads a sentence back. A catalogue with an
//! error fails the tests; a code without words is printed with its arguments.
//!
//! # Examples
//!
//! One message in two languages:
//!
//! ```
//! use seamwright_message::{Catalogue, Language, Message, Unit};
//!
//! let message = Message::new("quantity").quantity("value", 4.4567, Unit::MmPerS, 2);
//! assert_eq!(message.to_string(), "4.46 mm/s");
//! assert_eq!(Catalogue::of(Language::German).text(&message), "4,46 mm/s");
//! ```

mod argument;
mod catalogue;
mod gathered;
mod language;
mod message;
mod sources;
mod unit;

pub use argument::{Argument, Quantity};
pub use catalogue::Catalogue;
pub use language::Language;
pub use message::Message;
pub use sources::{AREAS, source};
pub use unit::Unit;

/// Implements [`Display`](std::fmt::Display), in the language of the process, and [`Error`](std::error::Error) for
/// types with a method `message` that returns their [`Message`].
#[macro_export]
macro_rules! display_by_message {
    ($($error:ty),+ $(,)?) => {
        $(
            impl ::std::fmt::Display for $error {
                fn fmt(&self, f: &mut ::std::fmt::Formatter) -> ::std::fmt::Result {
                    ::std::fmt::Display::fmt(&self.message(), f)
                }
            }

            impl ::std::error::Error for $error {}

            impl ::std::convert::From<&$error> for $crate::Message {
                fn from(error: &$error) -> Self {
                    error.message()
                }
            }
        )+
    };
}

/// Defines an enum without values whose variants have names for files and interfaces, each behind `=>`. Adds `ALL` and
/// `name`; with the code of its words behind each name also `message`. With codes alone, each behind `:`, it adds `ALL`
/// and `message`.
#[macro_export]
macro_rules! named_enum {
    ($(#[$of_enum:meta])* pub enum $Enum:ident { $($(#[$of_variant:meta])* $Variant:ident => $name:literal,)+ }) => {
        $(#[$of_enum])*
        pub enum $Enum { $($(#[$of_variant])* $Variant,)+ }

        impl $Enum {
            /// All variants, in the order of their definition.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$Variant),+];

            /// Its name in files and interfaces.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$Variant => $name,)+ }
            }
        }
    };
    ($(#[$of_enum:meta])* pub enum $Enum:ident { $($(#[$of_variant:meta])* $Variant:ident: $code:literal,)+ }) => {
        $(#[$of_enum])*
        pub enum $Enum { $($(#[$of_variant])* $Variant,)+ }

        impl $Enum {
            /// All variants, in the order of their definition.
            pub const ALL: [Self; [$($code),+].len()] = [$(Self::$Variant),+];

            /// Returns its words.
            pub const fn message(self) -> $crate::Message {
                $crate::Message::new(match self { $(Self::$Variant => $code,)+ })
            }
        }
    };
    ($(#[$of_enum:meta])* pub enum $Enum:ident {
        $($(#[$of_variant:meta])* $Variant:ident => $name:literal, $code:literal;)+
    }) => {
        $crate::named_enum! { $(#[$of_enum])* pub enum $Enum { $($(#[$of_variant])* $Variant => $name,)+ } }

        impl $Enum {
            /// Returns its words.
            pub const fn message(self) -> $crate::Message {
                $crate::Message::new(match self { $(Self::$Variant => $code,)+ })
            }
        }
    };
}
