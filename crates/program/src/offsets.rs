use seamwright_document::{Document, DocumentError, Transform};
use seamwright_message::Message;
use std::collections::BTreeMap;

/// Work offsets by name: each is the part's frame in the machine's work frame.
pub type Offsets = BTreeMap<String, Transform>;

/// Checks the key `offset` of a file against its `offsets`: names are plain, and the one in force is among them.
///
/// # Errors
/// With the key's address and the names that there are.
pub fn check_offset<T>(file: &Document<T>, offset: Option<&str>, offsets: &Offsets) -> Result<(), DocumentError> {
    if let Some(bad) = offsets.keys().find(|name| !is_offset_name(name)) {
        let message = Message::new("program-offset-name-invalid").text("name", bad);
        return Err(file.error_at("offsets", message, OFFSET_NAMES));
    }
    match offset {
        Some(name) if !offsets.contains_key(name) => {
            let known: Vec<&str> = offsets.keys().map(String::as_str).collect();
            let mut error = file.unknown_name("offset", name, &known);
            if known.is_empty() {
                error.allowed = Some(Message::new("program-offset-table").text("name", name));
            }
            Err(error)
        }
        _ => Ok(()),
    }
}

/// Allowed characters of a work offset's name.
pub const OFFSET_NAMES: Message = Message::new("program-offset-names");

/// True if `name` can be the name of a work offset: a key of a file without quotes.
pub fn is_offset_name(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
}
