//! Paths of entries: keys joined by points, elements of lists in brackets, as errors write them.

use std::fmt::Write as _;

/// A step of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Step {
    /// A key of a table.
    Key(String),
    /// An element of a list, from 0.
    Nth(usize),
}

/// Splits a path like `passes[0].points`; keys with other characters than letters, digits, `_` and `-` are quoted.
/// `None` if it is not a path.
pub fn steps(path: &str) -> Option<Vec<Step>> {
    let mut found = Vec::new();
    let mut left = path;
    while !left.is_empty() {
        if let Some(rest) = left.strip_prefix('[') {
            let (digits, rest) = rest.split_once(']')?;
            found.push(Step::Nth(digits.parse().ok()?));
            left = rest;
            continue;
        }
        if !found.is_empty() {
            left = left.strip_prefix('.')?;
        }
        let (key, rest) = if let Some(quoted) = left.strip_prefix('"') {
            let mut is_escaped = false;
            let is_end = |c: char| {
                let ends = c == '"' && !is_escaped;
                is_escaped = c == '\\' && !is_escaped;
                ends
            };
            let (key, rest) = left.split_at(quoted.find(is_end)? + 2);
            (key.parse::<toml_edit::Key>().ok()?.get().to_owned(), rest)
        } else {
            let (key, rest) = left.split_at(left.find(['.', '[']).unwrap_or(left.len()));
            (Some(key.to_owned()).filter(|key| !key.is_empty())?, rest)
        };
        found.push(Step::Key(key));
        left = rest;
    }
    Some(found)
}

pub(crate) fn with_key(path: &str, key: &str) -> String {
    let point = if path.is_empty() { "" } else { "." };
    format!("{path}{point}{}", written_key(key))
}

/// A key as it stands in a file.
pub(crate) fn written_key(key: &str) -> String {
    let is_bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if is_bare { key.to_owned() } else { serde_json::Value::from(key).to_string() }
}

/// Writes steps as a path.
pub fn path_of(steps: &[Step]) -> String {
    steps.iter().fold(String::new(), |mut path, step| match step {
        Step::Key(key) => with_key(&path, key),
        Step::Nth(nth) => {
            // Writing to a string cannot fail.
            let _ = write!(path, "[{nth}]");
            path
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_split_and_joined_again() {
        for path in [
            "",
            "a",
            "a.b",
            "passes[0].spans[12].points[3][2]",
            "offsets.\"my.part \\\"1\\\"\".move_mm[2]",
            "\"a\\\\\".b",
        ] {
            assert_eq!(path_of(&steps(path).unwrap()), path);
        }
        for wrong in ["a.", ".a", "a[", "a[x]", "a[0]b", "a..b", "\"a"] {
            assert_eq!(steps(wrong), None, "{wrong}");
        }
    }
}
