//! The packages of this repository.

use crate::root;
use seamwright_supply_chain::{Cargo, CargoLock, NpmLock, Rules, Toolchain, Tree, bill_of_materials, notices};

#[test]
fn no_package_violates_the_rules() {
    let root = root();
    let cargo = Cargo::on_this_platform(&root).unwrap();
    let all = Tree::of_workspace(&cargo, "normal,build,dev").unwrap();
    let built = Tree::of_workspace(&cargo, "normal,build").unwrap();
    let lock = CargoLock::read(&root.join("Cargo.lock")).unwrap();
    let npm =
        ["web/package-lock.json", "web/e2e/package-lock.json"].map(|file| NpmLock::read(&root.join(file)).unwrap());
    let rules = Rules::read(&root.join("deny.toml")).unwrap();
    // Enough to be the packages of this repository at all.
    assert!(all.third_party().count() > 200 && built.third_party().count() > 150 && npm[0].packages.len() > 50);
    let found: Vec<String> = rules.violations(&all, &built, &lock, &npm).iter().map(ToString::to_string).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_package_of_the_program_has_a_text_and_a_component() {
    let root = root();
    let cargo = Cargo::on_this_platform(&root).unwrap();
    let tree = Tree::of_program(&cargo, "seamwright-cli").unwrap();
    let sources = cargo.sources(&tree).unwrap();
    let rules = Rules::read(&root.join("deny.toml")).unwrap();
    let toolchain = Toolchain::for_platform("x86_64-unknown-linux-gnu").unwrap();
    let notices = notices(&sources, &tree, &rules, &toolchain).unwrap();
    let lock = CargoLock::read(&root.join("Cargo.lock")).unwrap();
    let npm = NpmLock::read(&root.join("web/package-lock.json")).unwrap();
    let bill = bill_of_materials(&sources, &tree, &lock, &npm, &toolchain, "1.2.3").unwrap();
    let components = bill["components"].as_array().unwrap();
    for package in tree.third_party() {
        let title = package.title();
        let has_text = notices.texts.iter().any(|text| text.packages.contains(&title) && text.text.len() > 100);
        assert!(has_text, "{title} has no text");
        assert!(notices.packages.iter().any(|noticed| format!("{} {}", noticed.name, noticed.version) == title));
        let is_it = |of: &&serde_json::Value| of["name"] == *package.name && of["version"] == *package.version;
        assert_eq!(components.iter().filter(is_it).count(), 1, "{title}");
    }
    // The choice is made: `MIT OR Apache-2.0` needs no text of Apache-2.0, and nothing is under the GPL.
    let text_of = |name: &str| {
        let texts = notices.texts.iter().filter(|text| text.packages.iter().any(|title| title.starts_with(name)));
        texts.map(|text| text.text.as_str()).collect::<String>()
    };
    assert!(
        text_of("serde ").contains("Permission is hereby granted") && !text_of("serde ").contains("Apache License")
    );
    assert!(text_of("self_cell ").contains("Apache License"));
    assert!(text_of("triple_buffer ").contains("Mozilla Public License"));
    assert!(!notices.texts.iter().any(|text| text.text.contains("GNU GENERAL PUBLIC LICENSE")));
    // What packages bring in their folders, and what every program of Rust has.
    for name in ["sqlite", "rust-std"] {
        assert!(notices.packages.iter().any(|noticed| noticed.name == name), "{name}");
        assert!(components.iter().any(|component| component["name"] == name && component["cpe"].is_string()), "{name}");
    }
}
