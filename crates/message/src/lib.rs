//! Messages as data: a stable code with named, typed arguments.
//!
//! Findings, refusals, document errors, alarms and events are [`Message`]s. The words of each code are in one catalogue
//! per language (crate `seamwright-catalogue`, folder `messages/`); no code reads a sentence back. This crate has no words,
//! so that a changed sentence rebuilds only what prints.
//!
//! ```
//! use seamwright_message::{Message, Unit};
//!
//! let message = Message::new("axis-range-exceeded")
//!     .axis("axis", "z")
//!     .quantity("position", -118.266, Unit::Mm, 3)
//!     .quantity("limit", -100.0, Unit::Mm, 3);
//! assert_eq!(message.to_string(), "axis-range-exceeded: axis = z, position = -118.266 mm, limit = -100.000 mm");
//! ```

mod argument;
mod message;
mod unit;

pub use argument::{Argument, Quantity};
pub use message::Message;
pub use unit::Unit;
