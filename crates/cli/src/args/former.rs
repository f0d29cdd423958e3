//! Names of verbs before they were grouped. They go on working, and a note names the new ones.

use std::ffi::OsString;

/// A former name and the present verb.
pub(crate) type Renamed = (&'static str, &'static str);

/// All former names.
const FORMER: [Renamed; 17] = [
    ("seam", "tools seam"),
    ("section", "tools section"),
    ("motion", "tools motion"),
    ("pulses", "tools pulses"),
    ("follow", "tools follow"),
    ("reduce", "tools reduce"),
    ("interpolate", "tools interpolate"),
    ("bench", "tools bench"),
    ("latency", "machine latency"),
    ("io", "machine io"),
    ("kinematics", "machine kinematics"),
    ("move", "machine move"),
    ("machines", "machine list"),
    ("procedures", "examples --procedures"),
    ("read", "import"),
    ("find-joint", "vision joint"),
    ("stripe", "vision stripe"),
];

/// Puts the present verb in place of a former name in the arguments of the process.
pub(super) fn rename(arguments: &mut Vec<OsString>) -> Option<Renamed> {
    let text = |i: usize| arguments.get(i).and_then(|argument| argument.to_str());
    // Options other than the language are refused before a verb.
    let mut at = 1;
    while let Some(word) = text(at).filter(|word| word.starts_with("--language") || *word == "help") {
        at += if word == "--language" { 2 } else { 1 };
    }
    let (former, present) = FORMER.into_iter().find(|(former, _)| text(at) == Some(former))?;
    // `machines NAME` printed the file of this machine.
    let is_name = |i: usize| text(i).is_none_or(|word| !word.starts_with('-')) && text(i - 1) != Some("--language");
    let shows = former == "machines" && (at + 1..arguments.len()).any(is_name);
    let present = if shows { "machine show" } else { present };
    arguments.splice(at..=at, present.split(' ').map(OsString::from));
    Some((former, present))
}

#[cfg(test)]
mod tests {
    use super::super::Cli;
    use super::*;
    use clap::CommandFactory as _;
    use clap::error::ErrorKind;

    fn renamed(line: &str) -> (String, Option<Renamed>) {
        let mut arguments: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        let renamed = rename(&mut arguments);
        (arguments.join(" ".as_ref()).into_string().unwrap(), renamed)
    }

    #[test]
    fn every_former_name_is_a_present_verb() {
        for (former, present) in FORMER {
            let (line, names) = renamed(&format!("seamwright {former} --help"));
            assert_eq!((line.as_str(), names), (&*format!("seamwright {present} --help"), Some((former, present))));
            let error = Cli::command().try_get_matches_from(line.split(' ')).unwrap_err();
            assert_eq!(error.kind(), ErrorKind::DisplayHelp, "{present}");
            assert!(Cli::command().get_subcommands().all(|verb| verb.get_name() != former), "{former}");
        }
    }

    #[test]
    fn only_the_verb_is_renamed() {
        for (line, present) in [
            ("seamwright --language de seam seam", "seamwright --language de tools seam seam"),
            ("seamwright machines --json", "seamwright machine list --json"),
            ("seamwright machines --language de", "seamwright machine list --language de"),
            ("seamwright machines ellipse-xy", "seamwright machine show ellipse-xy"),
            ("seamwright help stripe", "seamwright help vision stripe"),
            ("seamwright plan seam", "seamwright plan seam"),
            ("seamwright", "seamwright"),
        ] {
            assert_eq!(renamed(line).0, present);
        }
    }
}
