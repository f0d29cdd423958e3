//! Words of [`Message`](seamwright_message::Message)s in every language.
//!
//! Catalogues are [Fluent](https://projectfluent.org) files, one per language and area, in the folder `messages/` of the
//! repository; the panel uses the same files. English is a catalogue like the others. They are part of the program; a
//! catalogue with an error fails the tests, and a code without words is printed with its arguments.
//!
//! ```
//! use seamwright_catalogue::{Catalogue, Language};
//! use seamwright_message::{Message, Unit};
//!
//! let message = Message::new("quantity").quantity("value", 4.4567, Unit::MmPerS, 2);
//! assert_eq!(Catalogue::of(Language::English).text(&message), "4.46 mm/s");
//! assert_eq!(Catalogue::of(Language::German).text(&message), "4,46 mm/s");
//! ```

mod catalogue;
mod language;
mod sources;

pub use catalogue::Catalogue;
pub use language::Language;
pub use sources::{AREAS, source};
