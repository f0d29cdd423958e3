//! Packages that violate a rule.

use seamwright_supply_chain::{CargoLock, NpmLock, Rule, Rules, Tree};

const RULES: &str = r#"
[licenses]
allow = ["MIT", "Apache-2.0", "Apache-2.0 WITH LLVM-exception"]
exceptions = [{ crate = "leaf", allow = ["MPL-2.0"] }]
[bans]
deny = [{ crate = "openssl-sys", reason = "TLS is rustls" }, { crate = "time:0.1", reason = "old" }]
skip = [{ crate = "old:0.2", reason = "its user has not moved on" }]
[sources]
allow-registry = ["https://github.com/rust-lang/crates.io-index"]
"#;

const TREE: &str = "0\tcell v0.2.0 (/src/cell)\tMIT OR Apache-2.0\t\n\
    1\tleaf v1.0.0\tMPL-2.0\t\n\
    1\told v0.2.9\tMIT/Apache-2.0\t\n\
    1\told v0.3.1\tMIT OR GPL-3.0-only\t\n";

const LOCK: &str = r#"
[[package]]
name = "cell"
version = "0.2.0"
[[package]]
name = "leaf"
version = "1.0.0"
source = "registry+https://github.com/rust-lang/crates.io-index"
checksum = "320119579fcad9c21884f5c4861d16174d0e06250625266f50fe6898340abefa"
[[package]]
name = "old"
version = "0.2.9"
source = "registry+https://github.com/rust-lang/crates.io-index"
checksum = "320119579fcad9c21884f5c4861d16174d0e06250625266f50fe6898340abefa"
"#;

const NPM: &str = r#"{"packages": {"": {},
    "node_modules/three": {"version": "0.187.0", "license": "MIT", "integrity": "sha512-AA=="},
    "node_modules/vite": {"version": "8.0.0", "license": "GPL-3.0-only", "dev": true, "integrity": "sha512-AA=="}}}"#;

/// Rule and package of each violation.
fn found(tree: &str, lock: &str, npm: &str) -> Vec<(Rule, String)> {
    let tree = Tree::parse(tree).unwrap();
    let (lock, npm) = (CargoLock::parse(lock).unwrap(), NpmLock::parse(npm).unwrap());
    let found = Rules::parse(RULES).unwrap().violations(&tree, &tree, &lock, &[npm]);
    found.into_iter().map(|violation| (violation.rule, violation.package)).collect()
}

fn with_package(line: &str) -> Vec<(Rule, String)> {
    found(&format!("{TREE}1\t{line}\n"), LOCK, NPM)
}

fn with_locked(entry: &str) -> Vec<(Rule, String)> {
    found(TREE, &format!("{LOCK}[[package]]\n{entry}\n"), NPM)
}

fn with_npm(package: &str) -> Vec<(Rule, String)> {
    found(TREE, LOCK, &NPM.replacen("\"\": {},", &format!("\"\": {{}}, {package},"), 1))
}

fn one(rule: Rule, package: &str) -> Vec<(Rule, String)> {
    vec![(rule, package.to_owned())]
}

#[test]
fn allowed_packages_violate_nothing() {
    assert_eq!(found(TREE, LOCK, NPM), []);
    for licence in ["MIT", "(MIT OR Apache-2.0) AND MIT", "Apache-2.0 WITH LLVM-exception", "GPL-2.0-only OR MIT"] {
        assert_eq!(with_package(&format!("new v1.0.0\t{licence}\t")), [], "{licence}");
    }
}

#[test]
fn licences_that_are_not_allowed_are_found() {
    for licence in
        ["GPL-3.0-only", "MIT AND GPL-3.0-only", "MPL-2.0", "LGPL-3.0-or-later", "", "BSD", "see LICENSE", "("]
    {
        assert_eq!(with_package(&format!("new v1.0.0\t{licence}\t")), one(Rule::Licence, "new 1.0.0"), "{licence:?}");
    }
    // Packages of this repository have one licence.
    assert_eq!(with_package("own v0.2.0 (/src/own)\tMIT\t"), one(Rule::Licence, "own 0.2.0"));
}

#[test]
fn banned_packages_are_found_also_on_other_platforms() {
    let source = "source = \"registry+https://github.com/rust-lang/crates.io-index\"\n\
        checksum = \"320119579fcad9c21884f5c4861d16174d0e06250625266f50fe6898340abefa\"";
    let ban = |name: &str, version: &str| with_locked(&format!("name = \"{name}\"\nversion = \"{version}\"\n{source}"));
    assert_eq!(ban("openssl-sys", "0.9.1"), one(Rule::Ban, "openssl-sys 0.9.1"));
    assert_eq!(ban("time", "0.1.45"), one(Rule::Ban, "time 0.1.45"));
    assert_eq!(ban("time", "0.10.0"), []);
}

#[test]
fn several_versions_are_found() {
    assert_eq!(with_package("old v0.4.0\tMIT\t"), one(Rule::OneVersion, "old"));
    assert_eq!(with_package("leaf v2.0.0\tMIT\t"), one(Rule::OneVersion, "leaf"));
}

#[test]
fn other_sources_are_found() {
    let fork = with_package("fork v0.1.0 (https://example.org/fork?rev=1#abc)\tMIT\t");
    assert_eq!(fork, one(Rule::Source, "fork 0.1.0"));
    let locked = |source: &str| with_locked(&format!("name = \"fork\"\nversion = \"0.1.0\"\nsource = \"{source}\""));
    for source in
        ["git+https://example.org/fork#abc", "registry+https://example.org/index", "sparse+https://index.crates.io/"]
    {
        assert_eq!(locked(source), one(Rule::Source, "fork 0.1.0"), "{source}");
    }
    assert_eq!(
        locked("registry+https://github.com/rust-lang/crates.io-index"),
        one(Rule::Checksum, "fork 0.1.0"),
        "without a checksum"
    );
}

#[test]
fn npm_packages_of_the_panel_are_checked() {
    let package = |fields: &str| with_npm(&format!("\"node_modules/new\": {{\"version\": \"1.0.0\", {fields}}}"));
    let hash = "\"integrity\": \"sha512-AA==\"";
    assert_eq!(package(&format!("\"license\": \"Apache-2.0\", {hash}")), []);
    assert_eq!(package(&format!("\"license\": \"GPL-3.0-only\", {hash}")), one(Rule::Licence, "npm new 1.0.0"));
    assert_eq!(package(hash), one(Rule::Licence, "npm new 1.0.0"));
    assert_eq!(package("\"license\": \"MIT\""), one(Rule::Checksum, "npm new 1.0.0"));
    let fork = "\"resolved\": \"git+ssh://git@example.org/new.git\"";
    assert_eq!(package(&format!("\"license\": \"MIT\", {hash}, {fork}")), one(Rule::Source, "npm new 1.0.0"));
    // Development packages are distributed nowhere, but run here.
    assert_eq!(package(&format!("\"license\": \"GPL-3.0-only\", \"dev\": true, {hash}")), []);
    assert_eq!(package("\"license\": \"MIT\", \"dev\": true"), one(Rule::Checksum, "npm new 1.0.0"));
}

#[test]
fn entries_without_a_package_are_found() {
    let lock = LOCK.replace("0.2.9", "0.3.9").replace("leaf", "other");
    assert_eq!(found(TREE, &lock, NPM), [(Rule::Entry, "leaf".to_owned()), (Rule::Entry, "old".to_owned())]);
}

#[test]
fn rules_that_are_not_understood_are_errors() {
    for (from, to, why) in [
        ("\"MIT\", ", "\"MTI\", ", "licence `MTI`"),
        (", reason = \"old\"", "", "missing field `reason`"),
        ("reason = \"old\"", "reason = \" \"", "the reason is empty"),
        ("time:0.1", "time:<0.2", "without operators"),
        ("reason = \"old\"", "reason = \"old\", wrappers = [\"a\"]", "unknown field `wrappers`"),
        ("[sources]", "[source]", "missing field `sources`"),
        ("[bans]", "[bans", "unclosed table"),
    ] {
        let rules = RULES.replace(from, to);
        assert_ne!(rules, RULES);
        let error = Rules::parse(&rules).unwrap_err().to_string();
        assert!(error.contains(why), "{to}: {error}");
    }
}
