//! The command of `scripts/supply-chain`.

use crate::root;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seamwright-supply-chain"));
    let Output { status, stdout, stderr } = command.args(arguments).current_dir(root()).output().unwrap();
    (status.code(), String::from_utf8([stdout, stderr].concat()).unwrap())
}

/// Writes a file of the repository with a change.
fn doctored(folder: &Path, file: &str, from: &str, to: &str) -> String {
    let text = fs::read_to_string(root().join(file)).unwrap();
    assert!(text.contains(from), "{file}: {from}");
    let path = folder.join(Path::new(file).file_name().unwrap());
    fs::write(&path, text.replacen(from, to, 1)).unwrap();
    path.display().to_string()
}

#[test]
fn packages_of_this_repository_pass() {
    assert_eq!(run(&[]), (Some(0), String::new()));
}

#[test]
fn notices_of_a_library_have_its_packages_and_their_texts() {
    let (code, text) = run(&["--notices", "seamwright-python"]);
    assert_eq!(code, Some(0), "{text}");
    for part in ["\npyo3 ", "\nnumpy ", "\nparquet ", "Permission is hereby granted", "Redistribution and use"] {
        assert!(text.contains(part), "{part}");
    }
    // The panel's server is in the command only.
    assert!(!text.contains("\naxum "));
    assert_eq!(run(&["--notices", "seamwright-none"]).0, Some(2));
}

#[test]
fn a_package_under_another_licence_fails() {
    let folder = tempfile::tempdir().unwrap();
    let tree = folder.path().join("tree.txt");
    let cargo = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--offline", "--workspace", "--edges", "normal,build", "--prefix", "depth"])
        .args(["--format", "\t{p}\t{l}\t{r}"])
        .current_dir(root())
        .output()
        .unwrap();
    let text = String::from_utf8(cargo.stdout).unwrap();
    let run_with = |text: &str| {
        fs::write(&tree, text).unwrap();
        run(&["--tree", tree.to_str().unwrap()])
    };
    assert_eq!(run_with(&text), (Some(0), String::new()));
    let (code, output) = run_with(&format!("{text}1\tevil v1.0.0\tGPL-3.0-only\t\n"));
    assert_eq!(code, Some(1), "{output}");
    assert!(output.contains("licence: evil 1.0.0: `GPL-3.0-only` is not allowed"), "{output}");
    assert!(output.contains("1 violations"), "{output}");
}

#[test]
fn a_banned_package_and_a_source_outside_the_registry_fail() {
    let folder = tempfile::tempdir().unwrap();
    let crates_io = "registry+https://github.com/rust-lang/crates.io-index";
    let lock = doctored(folder.path(), "Cargo.lock", "name = \"adler2\"", "name = \"openssl-sys\"");
    let (code, output) = run(&["--cargo-lock", &lock]);
    assert!(code == Some(1) && output.contains("banned: openssl-sys"), "{output}");
    let lock = doctored(folder.path(), "Cargo.lock", crates_io, "git+https://example.org/fork#abc");
    let (code, output) = run(&["--cargo-lock", &lock]);
    assert!(code == Some(1) && output.contains("source: adler2"), "{output}");
    let lock = doctored(folder.path(), "web/package-lock.json", "\"license\": \"MIT\"", "\"license\": \"SSPL-1.0\"");
    let (code, output) = run(&["--npm-lock", &lock]);
    assert!(code == Some(1) && output.contains("licence: npm @codemirror/commands"), "{output}");
}

#[test]
fn wrong_usage_and_unreadable_files_are_exit_code_2() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("empty");
    fs::write(&file, "").unwrap();
    let empty = file.to_str().unwrap();
    for (arguments, why) in [
        (&["--rules"][..], "usage:"),
        (&["check"], "usage:"),
        (&["--licence", "MIT"], "usage:"),
        (&["--rules", empty, "--rules", empty], "usage:"),
        (&["--rules", "missing.toml"], "missing.toml: No such file"),
        (&["--rules", empty], "missing field `licenses`"),
        (&["--tree", empty], "no packages"),
        (&["--cargo-lock", empty], "missing field `package`"),
        (&["--npm-lock", empty], "EOF"),
        (&["--rules", "crates"], "crates: Is a directory"),
    ] {
        let (code, output) = run(arguments);
        assert!(code == Some(2) && output.contains(why), "{arguments:?}: {output}");
    }
    assert_eq!(run(&["--help"]).0, Some(0));
}
