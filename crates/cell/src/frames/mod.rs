//! Where frames come from.

mod decode;

pub use decode::{DecodeError, decode};
