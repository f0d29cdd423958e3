use super::File;
use seamwright_document::DocumentError;

/// Maximum number of interlocks of a machine, and of inputs.
const MAX_INTERLOCKS: usize = 64;

/// Checks that interlocks have unique names and inputs and do not contradict each other.
pub(super) fn check(file: &File) -> Result<(), DocumentError> {
    let all = &file.value.interlocks;
    if all.len() > MAX_INTERLOCKS {
        let message = format!("the machine has {} conditions", all.len());
        return Err(file.error_at(
            &format!("interlocks[{MAX_INTERLOCKS}]"),
            message,
            format!("up to {MAX_INTERLOCKS}"),
        ));
    }
    for (i, one) in all.iter().enumerate() {
        let at = |key: &str| format!("interlocks[{i}].{key}");
        for (key, text) in [("name", &one.name), ("input", &one.input)] {
            if text.trim().is_empty() {
                return Err(file.error_at(&at(key), format!("the {key} is empty"), "a name"));
            }
        }
        if all[..i].iter().any(|other| other.name == one.name) {
            return Err(file.error_at(&at("name"), "another condition has this name", "a name of its own"));
        }
        if let Some(other) = all[..i].iter().find(|other| other.input == one.input && other.is != one.is) {
            let message = format!(
                "`{}` needs input {} to be {}, `{}` needs it to be {}: nothing could ever run",
                other.name, one.input, other.is, one.name, one.is
            );
            return Err(file.error_at(&at("is"), message, format!("{}, or another input", other.is)));
        }
        if let Some(other) = all[..i].iter().find(|other| other.input == one.input) {
            let message = format!("`{}` watches input {} already", other.name, one.input);
            let allowed =
                format!("one condition an input: for = \"{}\" is the stronger", one.level.min(other.level).name());
            return Err(file.error_at(&at("input"), message, allowed));
        }
    }
    Ok(())
}
