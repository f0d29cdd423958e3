//! Packages and who uses them, as `cargo tree` prints them.

use crate::cargo::Key;
use crate::{Cargo, Error};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Origin of a package.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// This repository: its folder.
    Own(PathBuf),
    /// The registry of `Cargo.lock`.
    Registry,
    /// Another registry or a version control system: its address.
    Elsewhere(String),
}

/// A package of a build.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Package {
    /// Name in the registry.
    pub name: String,
    /// Version.
    pub version: String,
    /// Declared licence, an SPDX expression; some packages use an older form.
    pub licence: Option<String>,
    /// Address of its repository, if it declares one.
    pub repository: Option<String>,
    /// Its origin.
    pub origin: Origin,
    /// Other packages that it uses: their positions in [`Tree::packages`].
    pub uses: BTreeSet<usize>,
    /// Its code is in the program; otherwise it only takes part in the build.
    pub is_linked: bool,
}

impl Package {
    /// Returns true for packages of this repository.
    pub fn is_own(&self) -> bool {
        matches!(self.origin, Origin::Own(_))
    }

    pub(crate) fn key(&self) -> Key {
        (self.name.clone(), self.version.clone())
    }

    /// Returns name and version.
    pub fn title(&self) -> String {
        format!("{} {}", self.name, self.version)
    }
}

/// Packages of a build; equal ones once.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tree {
    /// The packages, in the order in which `cargo tree` meets them: a root is first.
    pub packages: Vec<Package>,
}

impl Tree {
    /// Returns the packages of the program: those linked, and those that only take part in its build.
    ///
    /// # Errors
    /// Those of [`Cargo::tree`].
    pub fn of_program(cargo: &Cargo, package: &str) -> Result<Self, Error> {
        let mut tree = Self::parse(&cargo.tree(Some(package), "normal,build")?)?;
        let linked = Self::parse(&cargo.tree(Some(package), "normal,no-proc-macro")?)?;
        let linked: BTreeSet<Key> = linked.packages.iter().map(Package::key).collect();
        for package in &mut tree.packages {
            package.is_linked = linked.contains(&package.key());
        }
        Ok(tree)
    }

    /// Returns the packages of the whole workspace; `edges` are those of `cargo tree --edges`.
    ///
    /// # Errors
    /// Those of [`Cargo::tree`].
    pub fn of_workspace(cargo: &Cargo, edges: &str) -> Result<Self, Error> {
        Self::parse(&cargo.tree(None, edges)?)
    }

    /// Reads a file with the output of [`Cargo::tree`].
    ///
    /// # Errors
    /// The file cannot be read, or has another form.
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::parse(&fs::read_to_string(path).map_err(|why| Error::of_file(path, why))?)
            .map_err(|why| Error::of_file(path, why))
    }

    /// Parses the output of [`Cargo::tree`]; all packages count as linked.
    ///
    /// # Errors
    /// A line that is not depth, package, licence and repository; no lines.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let mut tree = Self::default();
        let mut known: BTreeMap<Key, usize> = BTreeMap::new();
        // Packages from the root to the last line.
        let mut path: Vec<usize> = Vec::new();
        // Empty lines separate the trees of several roots.
        for line in text.lines().filter(|line| !line.trim().is_empty()) {
            let (depth, package) =
                parse_line(line).ok_or_else(|| Error::new("cargo tree", format!("line {line:?}")))?;
            let at = *known.entry(package.key()).or_insert(tree.packages.len());
            if at == tree.packages.len() {
                tree.packages.push(package);
            }
            path.truncate(depth);
            if let Some(user) = path.last() {
                tree.packages[*user].uses.insert(at);
            }
            path.push(at);
        }
        // An empty file must not pass as one without violations.
        if tree.packages.is_empty() { Err(Error::new("cargo tree", "no packages")) } else { Ok(tree) }
    }

    /// Returns the manifests of the packages of this repository.
    pub fn manifests(&self) -> impl Iterator<Item = PathBuf> {
        self.packages.iter().filter_map(|package| match &package.origin {
            Origin::Own(folder) => Some(folder.join("Cargo.toml")),
            Origin::Registry | Origin::Elsewhere(_) => None,
        })
    }

    /// Returns the packages that are not of this repository.
    pub fn third_party(&self) -> impl Iterator<Item = &Package> {
        self.packages.iter().filter(|package| !package.is_own())
    }
}

fn parse_line(line: &str) -> Option<(usize, Package)> {
    // A package met before is printed again without what it uses.
    let mut parts = line.strip_suffix(" (*)").unwrap_or(line).split('\t');
    let depth = parts.next()?.parse().ok()?;
    let mut words = parts.next()?.splitn(3, ' ');
    let [licence, repository] = [parts.next()?, parts.next()?].map(|part| Some(part.trim().to_owned()));
    let name = words.next().filter(|name| !name.is_empty())?.to_owned();
    let version = words.next()?.strip_prefix('v')?.to_owned();
    let origin = origin(words.next().unwrap_or_default());
    let [licence, repository] = [licence, repository].map(|part| part.filter(|text| !text.is_empty()));
    Some((depth, Package { name, version, licence, repository, origin, uses: BTreeSet::new(), is_linked: true }))
}

/// The origin in ` (proc-macro) (FOLDER OR ADDRESS)`, both optional.
fn origin(notes: &str) -> Origin {
    let notes = notes.strip_prefix("(proc-macro)").unwrap_or(notes).trim();
    match notes.strip_prefix('(').and_then(|notes| notes.strip_suffix(')')) {
        None => Origin::Registry,
        Some(place) if Path::new(place).is_absolute() => Origin::Own(PathBuf::from(place)),
        Some(place) => Origin::Elsewhere(place.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "0\tcell v0.2.0 (/src/cell)\tMIT OR Apache-2.0\t\n\
        1\tserde v1.0.2\tMIT OR Apache-2.0\thttps://github.com/serde-rs/serde\n\
        2\tserde_derive v1.0.2 (proc-macro)\tMIT OR Apache-2.0\t\n\
        1\tfork v0.1.0 (https://example.org/fork?rev=1#abc)\t\t\n\
        2\tserde v1.0.2\tMIT OR Apache-2.0\thttps://github.com/serde-rs/serde (*)\n\
        \n\
        0\ttool v0.2.0 (proc-macro) (/src/tool)\tMIT\t\n\
        1\tserde v1.0.2\tMIT OR Apache-2.0\thttps://github.com/serde-rs/serde (*)\n";

    #[test]
    fn lines_become_packages_with_who_uses_them() {
        let tree = Tree::parse(TEXT).unwrap();
        let names: Vec<&str> = tree.packages.iter().map(|package| package.name.as_str()).collect();
        assert_eq!(names, ["cell", "serde", "serde_derive", "fork", "tool"]);
        let uses: Vec<Vec<usize>> = tree.packages.iter().map(|p| p.uses.iter().copied().collect()).collect();
        assert_eq!(uses, [vec![1, 3], vec![2], vec![], vec![1], vec![1]]);
        let fork = "https://example.org/fork?rev=1#abc".to_owned();
        let [cell, tool] = ["/src/cell", "/src/tool"].map(|folder| Origin::Own(PathBuf::from(folder)));
        let registry = Origin::Registry;
        let origins: Vec<&Origin> = tree.packages.iter().map(|package| &package.origin).collect();
        assert_eq!(origins, [&cell, &registry, &registry, &Origin::Elsewhere(fork), &tool]);
        assert_eq!(tree.packages[3].licence, None);
        assert_eq!(tree.packages[1].repository.as_deref(), Some("https://github.com/serde-rs/serde"));
        assert_eq!(tree.third_party().count(), 3);
    }

    #[test]
    fn other_lines_are_errors() {
        assert_eq!(Tree::parse("\n").unwrap_err().to_string(), "cargo tree: no packages");
        for line in
            ["serde v1", "x\tserde v1.0.2\tMIT\t", "1\tserde 1.0.2\tMIT\t", "1\tserde v1.0.2\tMIT", "1\t\tMIT\t"]
        {
            assert!(Tree::parse(line).unwrap_err().to_string().contains("cargo tree: line"), "{line}");
        }
    }
}
