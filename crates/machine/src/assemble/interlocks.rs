use crate::file::File;
use seamwright_document::DocumentError;
use seamwright_message::{Message, Unit};

const MAX_INTERLOCKS: usize = 64;

pub(super) fn check(file: &File) -> Result<(), DocumentError> {
    let all = &file.value.interlocks;
    if all.len() > MAX_INTERLOCKS {
        let message = Message::new("machine-interlocks-many").count("n", all.len());
        let allowed = Message::new("document-at-most").value("max", MAX_INTERLOCKS as f64, Unit::One);
        return Err(file.error_at(&format!("interlocks[{MAX_INTERLOCKS}]"), message, allowed));
    }
    for (i, one) in all.iter().enumerate() {
        let at = |key: &str| format!("interlocks[{i}].{key}");
        for (key, text, code) in [
            ("name", &one.name, "machine-interlock-name-empty"),
            ("input", &one.input, "machine-interlock-input-empty"),
        ] {
            if text.trim().is_empty() {
                return Err(file.error_at(&at(key), Message::new(code), Message::new("machine-a-name")));
            }
        }
        if all[..i].iter().any(|other| other.name == one.name) {
            return Err(file.fault_at(&at("name"), "machine-interlock-name-taken", "document-own-name"));
        }
        if let Some(other) = all[..i].iter().find(|other| other.input == one.input && other.is != one.is) {
            let message = Message::new("machine-interlocks-contradict")
                .text("first", &other.name)
                .text("first_value", other.is.to_string())
                .text("second", &one.name)
                .text("second_value", one.is.to_string())
                .text("input", &one.input);
            let allowed = Message::new("machine-value-or-other-input").text("value", other.is.to_string());
            return Err(file.error_at(&at("is"), message, allowed));
        }
        if let Some(other) = all[..i].iter().find(|other| other.input == one.input) {
            let message = Message::new("machine-input-taken").text("interlock", &other.name).text("input", &one.input);
            let stronger = one.level.min(other.level).name();
            let allowed = Message::new("machine-one-interlock-an-input").text("level", stronger);
            return Err(file.error_at(&at("input"), message, allowed));
        }
    }
    Ok(())
}
