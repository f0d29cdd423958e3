//! Reports of plans and simulated welds in all languages: only names are English, and no text is cut off.

use crate::common::{bad, example, free_example, good, part_of, root, run, write};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Words that are the same in all languages, or are not translated.
const SAME: [&str; 12] =
    ["seamwright", "rms", "iso", "utc", "csv", "svg", "report", "json", "oscillation", "mag", "min", "kwh"];
/// Words that German shares with English.
const GERMAN: [&str; 11] =
    ["name", "position", "plan", "orange", "hand", "simulation", "interpolation", "links", "zone", "was", "minus"];
/// Keys of files, which cures name.
const KEYS: [&str; 8] = ["tolerance", "attitude", "deg", "weld", "process", "cap", "spacing", "width"];

/// The words that are read, and those read aloud, without the job's own text and tables of files that cures name.
fn words(page: &str) -> BTreeSet<String> {
    let page = page.replace("[[part.solids]]", "").replace("[seam]", "");
    let page = page.split("<style>").flat_map(|part| part.split("</style>").skip(1)).collect::<String>();
    let page =
        page.split("<figure class=\"code\">").flat_map(|part| part.split("</figure>").skip(1)).collect::<String>()
            + page.split("<figure class=\"code\">").next().unwrap_or_default();
    let mut text = String::new();
    for piece in page.split('<') {
        let (tag, rest) = piece.split_once('>').unwrap_or(("", piece));
        let aloud = tag.split_once("aria-label=\"").map_or("", |(_, label)| label.split('"').next().unwrap());
        text += &format!("{aloud} {rest} ");
    }
    words_of(&text)
}

fn words_of(text: &str) -> BTreeSet<String> {
    let text = text.replace("&#39;", " ").to_lowercase();
    text.split(|c: char| !c.is_alphabetic()).filter(|word| word.chars().count() > 2).map(str::to_owned).collect()
}

/// Words of the names that people have given: in the job, the machine, the procedure.
fn names(report: &Value) -> BTreeSet<String> {
    let mut text = ["title", "file", "machine", "posts"].map(|key| report[key].to_string()).join(" ");
    text += &["number", "title"].map(|key| report["procedure"][key].to_string()).concat();
    // Words between names of bodies, and names given by the program.
    let mut bodies = String::new();
    for pass in report["passes"].as_array().unwrap() {
        text += &format!("{} {} ", pass["name"], pass["procedure"]["run"]);
        bodies += &["between", "watched"].map(|key| pass["clearance"][key].to_string()).join(" ");
        let axes = pass["plan"]["axes"].as_array().unwrap().iter().map(|axis| &axis["axis"]);
        let heads = pass["simulation"]["heads"].as_array().into_iter().flatten().map(|head| &head["head"]);
        axes.chain(heads).for_each(|name| text += &format!("{name} "));
    }
    let ours = ["and", "part", "fixtures", "zone", "permitted", "forbidden"];
    let bodies = words_of(&bodies).into_iter().filter(|word| !ours.contains(&word.as_str()));
    words_of(&text).into_iter().chain(bodies).collect()
}

/// Text in drawings that is cut off, as it would not fit.
fn cut(page: &str) -> Vec<&str> {
    page.split("</text>").filter(|text| text.ends_with('…')).map(|text| text.rsplit('>').next().unwrap()).collect()
}

/// All languages but English.
const TRANSLATED: [&str; 4] = ["uk", "zh", "de", "ru"];

/// The files of a run in `languages` are translations of the English page.
fn in_languages(arguments: &[&str], languages: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let written = |language: &str| {
        let out = folder.path().join(language).display().to_string();
        let output = run(&[arguments, &["-o", &out, "--language", language]].concat());
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(!told.contains("panicked") && output.status.code() != Some(2), "{arguments:?}, {language}: {told}");
        fs::read_to_string(Path::new(&out).join("report.html")).unwrap()
    };
    let json = |language: &str| fs::read_to_string(folder.path().join(language).join("report.json")).unwrap();
    let english = written("en");
    let names = names(&serde_json::from_str(&json("en")).unwrap());
    let said: BTreeSet<String> = words(&english).difference(&names).cloned().collect();
    assert!(said.len() > 120, "{said:?}");
    for language in languages {
        let page = written(language);
        assert!(page.contains(&format!("<html lang=\"{language}\">")));
        let same: &[&str] = if *language == "de" { &GERMAN } else { &[] };
        let known = |word: &&String| [&SAME, &KEYS[..], same].iter().any(|some| some.contains(&word.as_str()));
        let words = words(&page);
        let left: Vec<&String> = words.intersection(&said).filter(|word| !known(word)).collect();
        assert!(left.is_empty(), "{arguments:?}, {language}: {left:?}");
        assert_eq!(cut(&page), cut(&english), "{arguments:?}, {language}");
        assert_eq!(json(language), json("en"), "{language}: report.json is for programs");
    }
}

#[test]
fn plans_are_told_in_all_languages() {
    in_languages(&["plan", &example("first-weld"), "--post", "linuxcnc"], &TRANSLATED);
    // Each of these has words of its own, in two of the languages: a missing translation fails other tests.
    let folder = tempfile::tempdir().unwrap();
    let many_passes = part_of(folder.path(), "thick-saddle", "overlap_mm = 20", "end_phi_deg = 80");
    in_languages(&["plan", &many_passes], &TRANSLATED[..2]);
    let examples = ["taught-saddle", "set-in-nozzle", "weave", "points", "radiator", "oblique-girth"];
    for (name, languages) in examples.iter().zip([&TRANSLATED[2..], &TRANSLATED[..2]].iter().cycle()) {
        in_languages(&["plan", &example(name)], languages);
    }
}

#[test]
fn simulated_welds_are_told_in_all_languages() {
    in_languages(&["simulate", &example("first-weld")], &TRANSLATED[..2]);
    in_languages(&["simulate", &example("t-joint")], &TRANSLATED[2..]);
    let distortion = root().join("examples/distortions/half-ring.toml").display().to_string();
    let folder = tempfile::tempdir().unwrap();
    let ring = part_of(folder.path(), "half-ring", "end_phi_deg = 210", "end_phi_deg = 75");
    in_languages(&["simulate", &ring, "--distortion", &distortion], &TRANSLATED[1..2]);
    in_languages(&["simulate", &ring, "--distortion", &distortion, "--no-tracking"], &TRANSLATED[3..]);
}

#[test]
fn findings_are_told_in_all_languages() {
    let folder = tempfile::tempdir().unwrap();
    let job = |name: &str, text: &str| write(folder.path(), name, text);
    let text = fs::read_to_string(example("first-weld")).unwrap();
    let fast = text.replace("speed_mm_s = 10", "speed_mm_s = 13");
    assert!(fast != text);
    in_languages(&["plan", &job("fast.toml", &fast)], &TRANSLATED);
    let strict = free_example("first-weld") + "\n[tolerance]\npath_mm = 0.001\nspeed_percent = 0.01\n";
    in_languages(&["simulate", &job("strict.toml", &strict)], &TRANSLATED);
}

#[test]
fn the_language_stands_before_or_after_the_verb() {
    let after = good(&["check", "ellipse", "--language", "de"]);
    assert_eq!(good(&["--language", "de", "check", "ellipse"]), after);
    assert_ne!(good(&["check", "ellipse", "--language", "en"]), after);
}

#[test]
fn refusals_print_their_code_in_all_languages() {
    for (language, code) in [("en", "code: "), ("uk", "код: "), ("zh", "代码："), ("de", "Code: "), ("ru", "код: ")]
    {
        let told = bad(2, &["tools", "seam", "ellipse", "--points", "1", "--language", language]);
        assert!(told.ends_with(&format!("\n   {code}cli-not-allowed\n")), "{told}");
    }
}

#[test]
fn the_server_refuses_in_the_language_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    for arguments in [&["serve"][..], &[]] {
        let told =
            |language| bad(2, &[arguments, &["--data", &data, "--job", "nope", "--language", language]].concat());
        assert!(told("de").contains("Code: cli-serve-no-job"), "{}", told("de"));
        let english = told("xx");
        assert!(english.contains("note: there is no language `xx`") && english.contains("no such job"), "{english}");
    }
}

#[test]
fn standard_input_has_a_name_in_the_language() {
    let told = bad(2, &["machine", "kinematics", "ellipse-xy", "--inverse", "--language", "de"]);
    assert!(!told.contains("standard input"), "{told}");
}
