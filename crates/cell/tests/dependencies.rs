//! The process of the cycle has no database, no Parquet, no web server and no encryption in it.

use std::process::Command;

/// Names of packages that belong to the panel's process.
const FOREIGN: [&str; 10] = [
    "rusqlite",
    "libsqlite3-sys",
    "parquet",
    "tar",
    "axum",
    "hyper",
    "rustls",
    "argon2",
    "seamwright-server",
    "seamwright-report",
];

#[test]
fn the_cell_does_without_the_packages_of_its_panel() {
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--package", "seamwright-cell", "--edges", "normal", "--prefix", "none"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let tree = String::from_utf8(tree.stdout).unwrap();
    let names: Vec<&str> = tree.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.contains(&"seamwright-executive"), "{tree}");
    for foreign in FOREIGN {
        assert!(!names.contains(&foreign), "{foreign}");
    }
}
