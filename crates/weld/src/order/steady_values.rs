use seamwright_document::{Document, DocumentError};
use seamwright_message::Message;
use seamwright_program::{ProcessValues, check_process};

/// Checks the process values in the table `path` of a short pass: values that the weld has, without a ramp, which is
/// refused with `ramp`.
pub(super) fn check_steady<T>(
    file: &Document<T>,
    path: &str,
    values: &ProcessValues,
    of_weld: &ProcessValues,
    ramp: &'static str,
) -> Result<(), DocumentError> {
    check_process(file, path, values)?;
    for (key, value) in values {
        let path = format!("{path}.{key}");
        if !of_weld.contains_key(key) {
            let known: Vec<&str> = of_weld.keys().map(String::as_str).collect();
            return Err(file.unknown_name(&path, key, &known));
        }
        if value.is_ramp() {
            return Err(file.error_at(&path, Message::new(ramp), Message::new("document-number")));
        }
    }
    Ok(())
}
