use seamwright_message::{AREAS, Language, source};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Areas whose codes are made from numbers or names in files, and general values that any file may use.
const BY_NAME: [&str; 6] = ["units", "words", "keys", "document", "alarms", "panel"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn files(folder: &Path, ends: &[&str], found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.map(|entry| entry.unwrap().path()) {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" {
            files(&path, ends, found);
        } else if ends.iter().any(|end| name.ends_with(end)) && name != "tests.rs" {
            found.push(path);
        }
    }
}

/// Rust sources of every crate without comments and tests: the crate's name and the text.
fn sources() -> Vec<(String, String)> {
    let mut all = Vec::new();
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let (path, name) = (entry.as_ref().unwrap().path(), entry.unwrap().file_name().into_string().unwrap());
        let mut found = Vec::new();
        files(&path.join("src"), &[".rs"], &mut found);
        for file in found {
            let text = fs::read_to_string(file).unwrap();
            let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
            all.push((name.clone(), lines.collect::<Vec<_>>().join("\n")));
        }
    }
    all
}

/// Pieces of `text` between quotation marks that have the form of a code.
fn literals(text: &str) -> impl Iterator<Item = &str> {
    let is_code = |text: &&str| {
        text.starts_with(|c: char| c.is_ascii_lowercase())
            && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
    };
    // Any two marks are tried, since quotation marks also stand in text.
    text.split(['"', '\'', '`']).filter(is_code)
}

fn codes() -> BTreeMap<String, &'static str> {
    let mut codes = BTreeMap::new();
    for area in AREAS {
        for line in source(Language::English, area).lines() {
            let Some((code, _)) = line.split_once(" =") else { continue };
            if literals(&format!("\"{code}\"")).next().is_some() {
                codes.insert(code.to_owned(), *area);
            }
        }
    }
    codes
}

#[test]
fn every_code_in_the_sources_has_words() {
    let codes = codes();
    for (name, text) in sources() {
        // Codes in `Message::new`, and those that start with the area of their crate.
        let direct = text.split("Message::new(").skip(1).filter_map(|rest| rest.trim_start().strip_prefix('"'));
        let direct = direct.filter_map(|rest| rest.split('"').next());
        let of_crate = literals(&text).filter(|code| {
            AREAS.contains(&name.as_str()) && code.strip_prefix(name.as_str()).is_some_and(|rest| rest.starts_with('-'))
        });
        for code in direct.chain(of_crate) {
            assert!(codes.contains_key(code), "{code}, in crates/{name}, has no words");
        }
    }
}

#[test]
fn every_code_in_the_catalogues_is_used() {
    let mut texts: Vec<String> = sources().into_iter().map(|(_, text)| text).collect();
    let mut panel = Vec::new();
    files(&root().join("web/src"), &[".ts", ".svelte"], &mut panel);
    texts.extend(panel.into_iter().map(|file| fs::read_to_string(file).unwrap()));
    let used: BTreeSet<&str> = texts.iter().flat_map(|text| literals(text)).collect();
    let codes = codes();
    let unused: Vec<&String> = codes
        .iter()
        .filter(|(code, area)| !BY_NAME.contains(area) && !used.contains(code.as_str()))
        .map(|(code, _)| code)
        .collect();
    assert!(unused.is_empty(), "{unused:?}");
}
