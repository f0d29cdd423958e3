use seamwright_document::RESERVED_COLUMNS;

/// Names of frames that no axis can have.
const FRAMES: [&str; 5] = ["base", "work", "torch", "part", "fixtures"];

/// Names of axes for a machine file: those of the source in lower case, without `joint`, each once.
pub(super) fn axis_names(source: &[&str]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in source {
        let mut name = short(&plain(name));
        if FRAMES.contains(&name.as_str()) || RESERVED_COLUMNS.contains(&name.as_str()) {
            name += "_axis";
        }
        let free = (1..).map(|n| if n == 1 { name.clone() } else { format!("{name}_{n}") });
        // Endless: one of the numbers is free.
        names.extend(free.into_iter().find(|name| !names.contains(name)));
    }
    names
}

fn plain(name: &str) -> String {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    name.chars().map(letter).collect()
}

/// The name without `joint` before or behind; `joint_1` is `j1`.
fn short(name: &str) -> String {
    let end = name.rsplit("joint").next().unwrap_or(name).trim_matches('_');
    if name.contains("joint") && !end.is_empty() && end.bytes().all(|b| b.is_ascii_digit()) {
        return format!("j{end}");
    }
    let bare = name.trim_start_matches("joint_").trim_end_matches("_joint").trim_matches('_');
    match bare.bytes().next() {
        Some(first) if first.is_ascii_lowercase() => bare.to_owned(),
        Some(_) => format!("j{bare}"),
        None => "joint".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_short_plain_and_different() {
        let source =
            ["shoulder_pan_joint", "joint_a1", "Joint-2", "iiwa_joint_7", "lbr", "lbr", "base", "1", "轴", "joint"];
        let names = ["shoulder_pan", "a1", "j2", "j7", "lbr", "lbr_2", "base_axis", "j1", "joint", "joint_2"];
        assert_eq!(axis_names(&source), names);
    }
}
