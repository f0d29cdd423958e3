//! Notices and the bill of materials of the program.

use crate::common::{bad, good, json, root, start};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::Read as _;
use std::process::{Command, Stdio};

/// Names and versions of the packages that `cargo tree` lists for the program, without those of this repository.
fn packages_of_cargo() -> BTreeSet<String> {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--offline", "--package", "seamwright-cli", "--edges", "normal,build"])
        .args(["--prefix", "none", "--format", "{p}"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let third_party = text.lines().filter(|line| !line.contains("(/"));
    third_party.map(|line| line.split(' ').take(2).collect::<Vec<_>>().join(" ").replace(" v", " ")).collect()
}

/// Checksums of `Cargo.lock` by name and version.
fn checksums() -> BTreeMap<String, String> {
    let lock = std::fs::read_to_string(root().join("Cargo.lock")).unwrap();
    let lock = lock.parse::<toml_edit::DocumentMut>().unwrap();
    let packages = lock["package"].as_array_of_tables().unwrap().iter();
    let text = |table: &toml_edit::Table, key: &str| table.get(key).and_then(|value| value.as_str()).map(str::to_owned);
    let row = |table| Some((format!("{} {}", text(table, "name")?, text(table, "version")?), text(table, "checksum")?));
    packages.filter_map(row).collect()
}

fn text<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_else(|| panic!("no {key} in {value}"))
}

fn title(component: &Value) -> String {
    format!("{} {}", text(component, "name"), text(component, "version"))
}

fn components(bill: &Value) -> Vec<&Value> {
    bill["components"].as_array().unwrap().iter().collect()
}

#[test]
fn bill_lists_every_package_with_address_licence_and_checksum() {
    let bill = json(&["licences", "--sbom"]);
    assert_eq!([text(&bill, "bomFormat"), text(&bill, "specVersion")], ["CycloneDX", "1.6"]);
    assert_eq!(text(&bill["metadata"]["component"], "version"), env!("CARGO_PKG_VERSION"));
    let time = text(&bill["metadata"], "timestamp");
    assert!(time.len() == 20 && time.ends_with('Z') && &time[10..11] == "T", "{time}");

    let cargo: Vec<&Value> =
        components(&bill).into_iter().filter(|c| text(c, "purl").starts_with("pkg:cargo/")).collect();
    let listed: BTreeSet<String> = cargo.iter().map(|component| title(component)).collect();
    assert_eq!(listed, packages_of_cargo());
    let checksums = checksums();
    for component in &cargo {
        let title = title(component);
        assert_eq!(component["hashes"][0]["alg"], "SHA-256", "{title}");
        assert_eq!(text(&component["hashes"][0], "content"), checksums[&title]);
        assert_eq!(text(component, "purl").replace("%2B", "+"), format!("pkg:cargo/{}", title.replace(' ', "@")));
    }
    for component in components(&bill) {
        let expression = text(&component["licenses"][0], "expression");
        assert!(!expression.is_empty() && !expression.contains('/'), "{}: {expression}", title(component));
    }
    let scope = |name: &str| text(cargo.iter().find(|component| component["name"] == name).unwrap(), "scope");
    assert_eq!([scope("clap"), scope("clap_derive"), scope("spdx")], ["required", "excluded", "excluded"]);
}

#[test]
fn bill_says_which_package_needs_which() {
    let bill = json(&["licences", "--sbom"]);
    let references: BTreeSet<&str> = components(&bill).iter().map(|component| text(component, "bom-ref")).collect();
    assert_eq!(references.len(), components(&bill).len(), "each reference once");
    let dependencies = bill["dependencies"].as_array().unwrap();
    let uses: BTreeMap<&str, Vec<&str>> = dependencies
        .iter()
        .map(|of| {
            (
                text(of, "ref"),
                of.get("dependsOn")
                    .into_iter()
                    .flat_map(|used| used.as_array().unwrap())
                    .map(|on| on.as_str().unwrap())
                    .collect(),
            )
        })
        .collect();
    assert_eq!(uses.len(), dependencies.len());
    // From the program every package is reached, and nothing else.
    let mut reached = BTreeSet::new();
    let mut open = vec!["seamwright"];
    while let Some(next) = open.pop() {
        if reached.insert(next) {
            open.extend(uses.get(next).unwrap_or_else(|| panic!("{next} has no entry")));
        }
    }
    assert!(reached.remove("seamwright"));
    assert_eq!(reached, references);
    let of = |name: &str| uses.iter().find(|(package, _)| package.starts_with(name)).unwrap().1;
    assert!(of("pkg:cargo/libsqlite3-sys@").iter().any(|used| used.starts_with("pkg:generic/sqlite@")));
    assert!(of("pkg:cargo/rusqlite@").iter().any(|used| used.starts_with("pkg:cargo/libsqlite3-sys@")));
}

/// The panel's packages are in the bill and have their texts, unless the program was built without the panel.
#[test]
fn packages_of_the_panel_are_listed() {
    let bill = json(&["licences", "--sbom"]);
    let npm: Vec<&Value> = components(&bill).into_iter().filter(|c| text(c, "purl").starts_with("pkg:npm/")).collect();
    let Some(panel) = seamwright_server::panel_packages() else {
        assert!(npm.is_empty());
        return;
    };
    let panel: Vec<Value> = serde_json::from_slice(panel).unwrap();
    // A package that `package.json` lists for development only is missing in the bill.
    assert_eq!(npm.iter().map(|c| title(c)).collect::<BTreeSet<_>>(), panel.iter().map(title).collect());
    let names: Vec<&str> = npm.iter().map(|component| text(component, "name")).collect();
    assert!(["svelte", "three", "uplot", "@codemirror/state"].iter().all(|name| names.contains(name)), "{names:?}");
    for component in npm {
        assert_eq!(component["hashes"][0]["alg"], "SHA-512");
        assert_eq!(text(&component["hashes"][0], "content").len(), 128);
    }
    assert!(!good(&["licences"]).contains("no text of its licence"));
}

#[test]
fn notices_have_every_package_with_its_text() {
    let notices = good(&["licences"]);
    assert!(
        notices.starts_with(&format!("Seamwright {} is licensed under MIT or Apache-2.0", env!("CARGO_PKG_VERSION")))
    );
    // A heading is between two rules, the text after it.
    let rule = format!("{}\n", "=".repeat(100));
    let parts: Vec<&str> = notices.split(&rule).collect();
    let tables = parts[0];
    let texts: String = parts.iter().copied().skip(2).step_by(2).collect();
    let headings: String = parts.iter().copied().skip(1).step_by(2).collect::<String>().replace('\n', " ");
    let rows = tables.lines().filter(|line| line.contains("https://"));
    let rows: BTreeSet<String> =
        rows.map(|line| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ")).collect();
    for package in packages_of_cargo() {
        assert!(rows.contains(&package), "{package} is in no table");
        assert!(headings.contains(&package), "{package} has no text");
    }
    for words in
        ["Copyright (c) 2026 The Seamwright authors", "The Rust Project Contributors", "Mozilla Public License"]
    {
        assert!(texts.contains(words), "{words}");
    }
    assert!(tables.contains("https://crates.io/crates/triple_buffer/"), "MPL-2.0 requires where the source is");
}

#[test]
fn other_spelling_works_and_help_has_it() {
    assert_eq!(good(&["licenses"]), good(&["licences"]));
    assert!(good(&["--help"]).contains("licences"));
    assert!(good(&["licences", "--help"]).contains("CycloneDX 1.6"));
}

#[test]
fn wrong_usage_is_refused() {
    for (arguments, why) in [
        (&["licences", "serde"][..], "unexpected argument 'serde'"),
        (&["licences", "--json"], "unexpected argument '--json'"),
        (&["licences", "--sbom=spdx"], "unexpected value 'spdx'"),
        (&["licences", "--sbom", "--sbom"], "cannot be used multiple times"),
    ] {
        let error = bad(2, arguments);
        assert!(error.contains(why), "{arguments:?}: {error}");
    }
}

#[test]
fn a_full_disk_is_reported_and_a_closed_pipe_is_not() {
    let program = env!("CARGO_BIN_EXE_seamwright");
    let full = File::options().write(true).open("/dev/full").unwrap();
    let output = Command::new(program).arg("licences").stdout(full).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(output.status.code(), Some(3), "{}", String::from_utf8_lossy(&output.stderr));
    let mut child = start(&["licences"]);
    let mut first = [0; 10];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    assert_eq!((&first, child.wait().unwrap().code()), (b"Seamwright", Some(0)));
}
