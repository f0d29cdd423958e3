//! Comments and numbers that all languages share.

use super::RobotText;
use crate::robot::language::RobotLanguage;
use crate::robot::program::RobotProgram;
use crate::robot::weld_values::NAMES;
use crate::write::fixed;

/// A comment is cut off behind so many characters.
const LONGEST: usize = 200;

/// Numbers with at most so many decimals, separated by `between`.
pub(super) fn joined(values: impl IntoIterator<Item = f64>, decimals: usize, between: &str) -> String {
    values.into_iter().map(|value| fixed(value, decimals)).collect::<Vec<_>>().join(between)
}

/// `text` in printable ASCII.
pub(super) fn plain(text: &str) -> String {
    text.chars().take(LONGEST).map(|c| if c.is_ascii_graphic() || c == ' ' { c } else { '?' }).collect()
}

/// The comments at the start of a text.
pub(super) fn head(language: RobotLanguage, program: &RobotProgram, options: &RobotText) -> Vec<String> {
    let RobotText { machine, arm, remarks } = options;
    let mut lines = vec![
        format!("Seamwright {} for {}: {}", env!("CARGO_PKG_VERSION"), language.title(), program.title),
        format!("machine: {}", machine.title),
        "poses are those of the torch tip in the work frame; the tool is counted from the flange".to_owned(),
        "all axes go to the home position first: make sure that the way there is clear".to_owned(),
    ];
    if !arm.externals.is_empty() {
        let names: Vec<&str> = arm.externals.iter().map(|external| external.name.as_str()).collect();
        lines.push(format!("external axes: {}", names.join(", ")));
    }
    lines.push(format!("process values: {}", NAMES.join(", ")));
    lines.extend(remarks.iter().cloned());
    lines.iter().map(|line| plain(line)).collect()
}
