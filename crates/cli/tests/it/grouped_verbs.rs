//! The groups of verbs, their former names, the language of the process, and what packages need.

use crate::common::{bad, example, good, part_of, run, run_with};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::process::{Command, Output};

fn verbs(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    lines
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.split_whitespace().next())
        .map(str::to_owned)
        .collect()
}

#[test]
fn the_verbs_are_grouped() {
    let top = verbs(&good(&["--help"]));
    let expected = [
        "plan", "check", "schedule", "study", "simulate", "run", "serve", "stop", "post", "import", "edit", "teach",
        "records", "machine", "vision", "tools", "examples", "schema", "licences", "help",
    ];
    assert_eq!(top, expected);
    let machine = verbs(&good(&["machine", "--help"]));
    let expected = [
        "list",
        "show",
        "import",
        "new",
        "place",
        "reach",
        "check",
        "tune",
        "kinematics",
        "move",
        "io",
        "robot-program",
        "latency",
        "help",
    ];
    assert_eq!(machine, expected);
    assert_eq!(verbs(&good(&["vision", "--help"])), ["joint", "stripe", "scan", "help"]);
}

#[test]
fn former_names_do_the_same_with_a_note() {
    let saddle = example("saddle");
    let cases: [(&[&str], &[&str]); 6] = [
        (&["seam", &saddle, "--points", "5"], &["tools", "seam", &saddle, "--points", "5"]),
        (&["machines"], &["machine", "list"]),
        (&["machines", "torch-5axis"], &["machine", "show", "torch-5axis"]),
        (&["machines", "--json"], &["machine", "list", "--json"]),
        (&["procedures"], &["examples", "--procedures"]),
        (
            &["interpolate", "--curve", "ellipse", "--summary"],
            &["tools", "interpolate", "--curve", "ellipse", "--summary"],
        ),
    ];
    for (former, present) in cases {
        let (former_run, present_run) = (run(former), run(present));
        assert_eq!(former_run.status.code(), Some(0), "{former:?}");
        assert_eq!(former_run.stdout, present_run.stdout, "{former:?}");
        assert!(present_run.stderr.is_empty());
        let note = String::from_utf8(former_run.stderr).unwrap();
        assert_eq!(note.lines().count(), 1, "{note}");
        assert!(note.contains(&format!("`seamwright {}` is now `seamwright {}", former[0], present[0])), "{note}");
    }
    let poses = "x,y\n1,2\n";
    let former = run_with(&["kinematics", "ellipse-xy", "--forward"], poses);
    assert_eq!(former.stdout, run_with(&["machine", "kinematics", "ellipse-xy", "--forward"], poses).stdout);
}

/// Each fails on its first input, which is cheap; `bench` has none.
#[test]
fn every_former_name_prints_its_note() {
    let cases: [(&[&str], &str); 13] = [
        (&["section", "nowhere.toml"], "tools section"),
        (&["motion", "nowhere.toml"], "tools motion"),
        (&["pulses", "nowhere.toml"], "tools pulses"),
        (&["follow", "nowhere.csv", "--machine", "torch-5axis", "--speed-mm-s", "5"], "tools follow"),
        (&["reduce", "nowhere.csv", "--tolerance-mm", "1"], "tools reduce"),
        (&["latency", "--period-ms", "0.1"], "machine latency"),
        (&["io", "ellipse-xy"], "machine io"),
        (&["kinematics", "nowhere.toml", "--forward"], "machine kinematics"),
        (&["move", "torch-5axis", "--to", "q=1"], "machine move"),
        (&["machines", "nowhere"], "machine show"),
        (&["read", "nowhere.ngc", "--machine", "torch-5axis"], "import"),
        (&["find-joint", "nowhere.png", "--start", "1,1", "--direction-deg", "0"], "vision joint"),
        (&["stripe", "nowhere.png", "--joint", "v"], "vision stripe"),
    ];
    for (former, present) in cases {
        let text = bad(2, former);
        let (note, error) = text.split_once('\n').unwrap();
        assert_eq!(note, format!("note: `seamwright {}` is now `seamwright {present}`", former[0]));
        let present: Vec<&str> = present.split(' ').collect();
        assert_eq!(error, bad(2, &[&present[..], &former[1..]].concat()), "{former:?}");
    }
}

fn in_locale(arguments: &[&str], locale: &[(&str, &str)]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seamwright"));
    for name in ["LC_ALL", "LC_MESSAGES", "LANG"] {
        command.env_remove(name);
    }
    command.args(arguments).envs(locale.iter().copied()).output().unwrap()
}

#[test]
fn errors_are_in_the_language_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("job.toml").display().to_string();
    fs::write(&path, fs::read_to_string(example("saddle")).unwrap().replace("radius_mm = 250", "radius_mm = -250"))
        .unwrap();
    let error = |arguments: &[&str], locale: &[(&str, &str)]| {
        let output = in_locale(&[&["check", &path], arguments].concat(), locale);
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8(output.stderr).unwrap()
    };
    let german = "unzulässiger Wert";
    assert!(error(&["--language", "de"], &[]).contains(german));
    assert!(error(&[], &[("LANG", "de_AT.UTF-8")]).contains(german));
    assert!(error(&[], &[("LANG", "ru_RU.UTF-8"), ("LC_MESSAGES", "de_DE")]).contains(german));
    assert!(error(&["--language", "uk"], &[("LC_ALL", "de_DE")]).contains("дозволено"));
    for english in
        [error(&[], &[]), error(&[], &[("LANG", "C.UTF-8")]), error(&["--language", "en"], &[("LANG", "de")])]
    {
        assert!(english.contains("invalid value") && !english.contains("note:"), "{english}");
    }
}

#[test]
fn an_unknown_language_is_english_with_one_note() {
    for output in
        [in_locale(&["examples", "--language", "xx"], &[]), in_locale(&["examples"], &[("LANG", "fr_FR.UTF-8")])]
    {
        assert_eq!((output.status.code(), output.stdout), (Some(0), good(&["examples"]).into_bytes()));
        let note = String::from_utf8(output.stderr).unwrap();
        assert!(note.lines().count() == 1 && note.contains("so this is English"), "{note}");
    }
}

/// Words of at least four letters, but for keys, options, and names of files and of findings' kinds.
fn words_of(text: &str) -> BTreeSet<String> {
    let is_name = |token: &&str| {
        token.contains(['/', '[', '_', '`', '='])
            || token.contains("--")
            || token.ends_with("):")
            || token.trim_end_matches(',').ends_with(|c: char| c.is_ascii_alphabetic()) && token.contains('.')
    };
    let tokens = text.split_whitespace().filter(|token| !is_name(token)).collect::<Vec<_>>().join(" ").to_lowercase();
    tokens.split(|c: char| !c.is_alphabetic()).filter(|word| word.chars().count() > 3).map(str::to_owned).collect()
}

/// Words of names that people have given: in the job and in the machine file.
fn names_of(report: &Value) -> BTreeSet<String> {
    let mut text = format!("{} {} ", report["title"], report["machine"]);
    let mut bodies = String::new();
    for pass in report["passes"].as_array().unwrap() {
        text += &format!("{} ", pass["name"]);
        bodies += &["between", "watched"].map(|key| pass["clearance"][key].to_string()).join(" ");
        let axes = pass["plan"]["axes"].as_array().unwrap().iter().map(|axis| &axis["axis"]);
        axes.for_each(|name| text += &format!("{name} "));
    }
    let letters = |text: &str| -> BTreeSet<String> {
        text.to_lowercase().split(|c: char| !c.is_alphabetic()).map(str::to_owned).collect()
    };
    let ours = ["part", "fixtures", "zone", "permitted", "forbidden"];
    let bodies = letters(&bodies).into_iter().filter(|word| !ours.contains(&word.as_str()));
    letters(&text).into_iter().chain(bodies).collect()
}

#[test]
fn summaries_are_in_the_language_that_is_asked_for() {
    // Words that German shares with English.
    let shared = ["name", "position", "plan", "simulation", "zone", "alarm"];
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    let many_passes = part_of(folder.path(), "thick-saddle", "overlap_mm = 20", "end_phi_deg = 80");
    for (job, verbs) in [(example("first-weld"), &["check", "plan", "simulate"][..]), (many_passes, &["plan"][..])] {
        let report = run(&["plan", &job, "-o", &out, "--json"]).stdout;
        let names = names_of(&serde_json::from_slice(&report).unwrap());
        for verb in verbs {
            let arguments: &[&str] = if *verb == "check" { &[verb, &job] } else { &[verb, &job, "-o", &out] };
            let words = |language: &str| {
                let output = run(&[arguments, &["--language", language]].concat());
                let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap()).join(" ");
                // Codes and kinds of findings are the same in every language.
                let is_code = |line: &&str| ["code: ", "Code: ", "код: "].iter().any(|of| line.trim().starts_with(of));
                let lines: Vec<&str> = text.lines().filter(|line| !is_code(line)).collect();
                let kinds = ["(attitude)", "(unwind)"];
                words_of(&kinds.iter().fold(lines.join("\n"), |text, kind| text.replace(kind, " ")))
            };
            let english: BTreeSet<String> = words("en").difference(&names).cloned().collect();
            assert!(!english.is_empty(), "{verb} {job}");
            for language in ["de", "uk"] {
                let left: Vec<String> = words(language).intersection(&english).cloned().collect();
                let left: Vec<&String> = left.iter().filter(|word| !shared.contains(&word.as_str())).collect();
                assert!(left.is_empty(), "{verb} {job}, {language}: {left:?}");
            }
        }
    }
}

#[test]
fn output_for_programs_is_the_same_in_every_language() {
    let job = example("first-weld");
    let cases: [&[&str]; 4] = [
        &["check", &job, "--json"],
        &["machine", "list", "--json"],
        &["tools", "seam", &job, "--points", "3"],
        &["check", &job, "no-such-job", "--json"],
    ];
    for arguments in cases {
        let output = |language: &str| run(&[arguments, &["--language", language]].concat()).stdout;
        assert_eq!(String::from_utf8_lossy(&output("de")), String::from_utf8_lossy(&output("en")), "{arguments:?}");
    }
    // Files of a weld with an alarm.
    let folder = tempfile::tempdir().unwrap();
    let files = |language: &str| {
        let out = folder.path().join(language);
        let job = example("ellipse");
        let fault = ["--fault", "source:wrong@12+0.3", "--language", language];
        run(&[&["simulate", &job, "-o", &out.display().to_string()], &fault[..]].concat());
        ["run.json", "events.jsonl", "report.json"].map(|name| fs::read_to_string(out.join(name)).unwrap())
    };
    assert_eq!(files("de"), files("en"));
}

#[test]
fn packages_get_completions_and_manual_pages() {
    for shell in ["bash", "zsh", "fish"] {
        let text = good(&["completions", shell]);
        assert!(text.contains("seamwright") && text.contains("simulate"), "{shell}");
        assert!(!text.contains("find-joint") && !text.contains("answer-one-question"), "{shell}: hidden verbs");
    }
    assert!(bad(2, &["completions", "cmd"]).contains("bash"));
    assert!(bad(2, &["man", "/proc/seamwright"]).contains("/proc/seamwright"));
    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("deep/man1");
    good(&["man", &pages.display().to_string()]);
    let names: BTreeSet<String> =
        fs::read_dir(&pages).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    for name in ["seamwright.1", "seamwright-plan.1", "seamwright-machine-kinematics.1", "seamwright-tools-seam.1"] {
        assert!(names.contains(name), "{names:?}");
    }
    assert!(!names.contains("seamwright-seam.1"), "former names have no page");
    let page = fs::read_to_string(pages.join("seamwright-machine-kinematics.1")).unwrap();
    assert!(page.starts_with(".ie") || page.contains(".TH"), "{page}");
    assert!(page.contains("inverse"));
}

#[test]
fn present_verbs_are_suggested() {
    let told = bad(2, &["pulse"]);
    assert!(told.contains("'pulse'") && !told.contains("'pulses'"), "{told}");
    assert!(bad(2, &["simulat"]).contains("'simulate'"));
    assert!(bad(2, &["tools", "pulsse"]).contains("'pulses'"));
}

#[test]
fn groups_of_verbs_have_examples() {
    for group in [&["machine"][..], &["machine", "list"], &["vision"], &["tools"], &["tools", "bench"], &["records"]] {
        assert!(good(&[group, &["--help"]].concat()).contains("Example"), "{group:?}");
    }
}
