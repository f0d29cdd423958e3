//! The commands in the book run as printed.

use crate::common::root;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            pages(&path, found);
        } else if path.extension().is_some_and(|end| end == "md") {
            found.push(path);
        }
    }
}

/// The blocks of a page that are fenced as `sh`, without the indentation of the list around them.
fn script(page: &str) -> String {
    let mut script = String::new();
    let mut lines = page.lines();
    while let Some(fence) = lines.by_ref().find(|line| line.trim_start() == "```sh") {
        let indent = fence.strip_suffix("```sh").unwrap_or_default();
        for line in lines.by_ref().take_while(|line| line.trim_start() != "```") {
            script.push_str(line.strip_prefix(indent).unwrap_or(line));
            script.push('\n');
        }
    }
    script
}

/// Runs the blocks of every page in `part` of the book in an empty folder each.
fn run_part(part: &str) {
    let mut found = Vec::new();
    pages(&root().join("docs").join(part), &mut found);
    let program = Path::new(env!("CARGO_BIN_EXE_seamwright")).parent().unwrap().display().to_string();
    let path = format!("{program}:{}", std::env::var("PATH").unwrap());
    let mut run = 0;
    for page in found {
        let script = script(&std::fs::read_to_string(&page).unwrap());
        if script.is_empty() {
            continue;
        }
        let folder = tempfile::tempdir().unwrap();
        let output = Command::new("bash")
            .args(["-e", "-o", "pipefail", "-c", &script])
            .current_dir(folder.path())
            .env("PATH", &path)
            .env("LC_ALL", "C.UTF-8")
            .output()
            .unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {}\n{script}\n{errors}", page.display(), output.status);
        assert!(!errors.contains("is now `seamwright"), "{}: a former name of a verb: {errors}", page.display());
        run += 1;
    }
    assert!(run > 0, "no commands in docs/{part}");
}

#[test]
fn commands_of_the_tutorials_run() {
    run_part("tutorials");
}

#[test]
fn commands_of_the_how_to_guides_run() {
    run_part("how-to");
}

#[test]
fn every_page_is_in_the_navigation_once() {
    let navigation = std::fs::read_to_string(root().join("mkdocs.yml")).unwrap();
    let entries: Vec<&str> = navigation.lines().filter_map(|line| line.trim().strip_prefix("- ")).collect();
    let folder = root().join("docs");
    let mut found = Vec::new();
    pages(&folder, &mut found);
    for page in found {
        let name = page.strip_prefix(&folder).unwrap().display().to_string();
        let titled = format!(": {name}");
        let listed = entries.iter().filter(|entry| **entry == name || entry.ends_with(&titled)).count();
        assert_eq!(listed, 1, "{name} in the nav of mkdocs.yml");
    }
    // An entry is `PAGE.md` or `Title: PAGE.md`.
    let listed = entries.iter().filter_map(|entry| entry.rsplit(' ').next()).filter(|name| name.ends_with(".md"));
    for name in listed {
        assert!(folder.join(name).is_file(), "the nav of mkdocs.yml names {name}, which is missing");
    }
}

/// Every library of a `Cargo.toml` has its purpose in the book, and no other is there.
#[test]
fn every_library_has_its_reason() {
    let table = |path: &Path| std::fs::read_to_string(path).unwrap().parse::<toml_edit::DocumentMut>().unwrap();
    let mut used = BTreeSet::new();
    for entry in std::fs::read_dir(root().join("crates")).unwrap() {
        let file = table(&entry.unwrap().path().join("Cargo.toml"));
        let targets = file.get("target").and_then(|of| of.as_table()).into_iter().flat_map(|of| of.iter());
        let tables = targets.filter_map(|(_, target)| target.as_table()).chain([file.as_table()]);
        for kind in tables.flat_map(|of| of.iter()).filter(|(name, _)| name.ends_with("dependencies")) {
            used.extend(kind.1.as_table().unwrap().iter().map(|(name, _)| name.to_owned()));
        }
    }
    used.retain(|name| !name.starts_with("seamwright"));
    let page = std::fs::read_to_string(root().join("docs/explanation/dependencies.md")).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split(" |").next());
    let named: BTreeSet<String> = rows.flat_map(|row| row.split(", ")).map(|name| name.replace('`', "")).collect();
    assert_eq!(named, used);
}

/// Every crate has a row in the code map, with files that exist, and depends on no crate of a higher layer.
#[test]
fn code_map_of_the_architecture_is_current() {
    let page = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let mut layers = BTreeMap::new();
    for row in page.lines().filter(|line| line.starts_with("| ") && line.matches('|').count() == 6) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(|cell| cell.trim().trim_matches('`')).collect();
        let folder = root().join("crates").join(cells[1]);
        if !folder.is_dir() {
            continue;
        }
        for file in cells[4].split("`, `") {
            assert!(folder.join("src").join(file).exists() || folder.join(file).exists(), "{}: {file}", cells[1]);
        }
        // Benchmarks and tests may use everything.
        layers.insert(cells[1], cells[0].parse::<u32>().unwrap_or(u32::MAX));
    }
    for entry in std::fs::read_dir(root().join("crates")).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let layer = *layers.get(name.as_str()).unwrap_or_else(|| panic!("{name} has no row"));
        let file = std::fs::read_to_string(entry.path().join("Cargo.toml")).unwrap();
        let file = file.parse::<toml_edit::DocumentMut>().unwrap();
        let used = file.get("dependencies").and_then(|of| of.as_table()).into_iter().flat_map(|of| of.iter());
        for below in used.filter_map(|(used, _)| used.strip_prefix("seamwright-")) {
            assert!(layers[below] <= layer, "{name} depends on {below}");
        }
    }
}
