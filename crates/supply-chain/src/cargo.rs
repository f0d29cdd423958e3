//! Calls of cargo.

use crate::{Error, Package, Tree};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Cargo in the folder of a workspace, for one platform.
///
/// Every call is tried without a network first.
#[derive(Debug, Clone)]
pub struct Cargo {
    program: PathBuf,
    workspace: PathBuf,
    platform: String,
}

/// Folders of all packages on this computer.
#[derive(Debug, Clone)]
pub struct Sources(BTreeMap<Key, Source>);

/// Source of a package on this computer.
#[derive(Debug, Clone)]
pub(crate) struct Source {
    pub(crate) folder: PathBuf,
    pub(crate) authors: Vec<String>,
}

/// Name and version of a package.
pub(crate) type Key = (String, String);

#[derive(Deserialize)]
struct Metadata {
    packages: Vec<MetadataPackage>,
}

#[derive(Deserialize)]
struct MetadataPackage {
    name: String,
    version: String,
    authors: Vec<String>,
    manifest_path: PathBuf,
}

#[derive(Deserialize)]
struct Manifest {
    package: ManifestPackage,
}

#[derive(Deserialize)]
struct ManifestPackage {
    #[serde(default)]
    authors: Vec<String>,
}

impl Cargo {
    /// Takes the cargo that runs this process, or that of the path. A platform is a target triple of Rust.
    pub fn new(workspace: &Path, platform: impl Into<String>) -> Self {
        let program = env::var_os("CARGO").map_or_else(|| PathBuf::from("cargo"), PathBuf::from);
        Self { program, workspace: workspace.to_owned(), platform: platform.into() }
    }

    /// The same for the platform of this computer.
    ///
    /// # Errors
    /// rustc cannot be run.
    pub fn on_this_platform(workspace: &Path) -> Result<Self, Error> {
        Ok(Self::new(workspace, host(&rustc_version()?)?))
    }

    /// The platform, a target triple of Rust.
    pub fn platform(&self) -> &str {
        &self.platform
    }

    /// Returns the output of `cargo tree` for [`Tree::parse`](crate::Tree::parse): depth, name and version, licence,
    /// repository.
    ///
    /// `selection` is a package, or none for the workspace; `edges` are those of `cargo tree --edges`.
    ///
    /// # Errors
    /// Cargo fails: `Cargo.lock` is not current, or packages are not downloaded and there is no network.
    pub fn tree(&self, selection: Option<&str>, edges: &str) -> Result<String, Error> {
        let selection = selection.map_or_else(|| vec!["--workspace"], |package| vec!["--package", package]);
        let form = ["--edges", edges, "--target", &self.platform, "--prefix", "depth", "--format", "\t{p}\t{l}\t{r}"];
        self.run("tree", &[&selection[..], &form].concat())
    }

    /// Returns the folders of third-party packages.
    ///
    /// `cargo metadata` needs the packages of tests too. Where they were not downloaded the folders are looked for in
    /// the home of cargo: a build must not use the network for its notices, if it can do without.
    ///
    /// # Errors
    /// As of [`tree`](Self::tree).
    pub fn sources(&self, tree: &Tree) -> Result<Sources, Error> {
        let arguments = ["--format-version", "1", "--filter-platform", &self.platform];
        if let Ok(text) = self.run_once("metadata", &[&["--offline"][..], &arguments].concat()) {
            return Sources::parse(&text);
        }
        let found = home().and_then(|home| Sources::find(&home, tree));
        found.map_or_else(|| Sources::parse(&self.run_once("metadata", &arguments)?), Ok)
    }

    fn run(&self, verb: &str, arguments: &[&str]) -> Result<String, Error> {
        // Unused packages need no download, so that this succeeds after every build.
        self.run_once(verb, &[&["--offline"][..], arguments].concat()).or_else(|_| self.run_once(verb, arguments))
    }

    fn run_once(&self, verb: &str, arguments: &[&str]) -> Result<String, Error> {
        let mut command = Command::new(&self.program);
        command.arg(verb).arg("--locked").args(arguments).current_dir(&self.workspace);
        // A computer without a network must not wait through all retries.
        output(command.env("CARGO_NET_RETRY", "1").env("CARGO_TERM_COLOR", "never"), &format!("cargo {verb}"))
    }
}

impl Sources {
    pub(crate) fn of(&self, package: &Package) -> Result<&Source, Error> {
        self.0.get(&package.key()).ok_or_else(|| Error::new(package.title(), "no source folder"))
    }

    /// Parses the output of `cargo metadata`.
    fn parse(text: &str) -> Result<Self, Error> {
        let metadata: Metadata = serde_json::from_str(text).map_err(|why| Error::new("cargo metadata", why))?;
        let sources = metadata.packages.into_iter().map(|package| {
            let folder = package.manifest_path.parent().unwrap_or(&package.manifest_path).to_owned();
            ((package.name, package.version), Source { folder, authors: package.authors })
        });
        Ok(Self(sources.collect()))
    }

    /// Finds the packages in the registries of a home of cargo; none if one is missing.
    fn find(home: &Path, tree: &Tree) -> Option<Self> {
        let registries = fs::read_dir(home.join("registry/src")).ok()?;
        let registries: Vec<PathBuf> = registries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        let source = |package: &Package| {
            let name = format!("{}-{}", package.name, package.version);
            let folder = registries.iter().map(|registry| registry.join(&name)).find(|folder| folder.is_dir())?;
            let manifest: Manifest = toml::from_str(&fs::read_to_string(folder.join("Cargo.toml")).ok()?).ok()?;
            Some((package.key(), Source { folder, authors: manifest.package.authors }))
        };
        Some(Self(tree.third_party().map(source).collect::<Option<_>>()?))
    }
}

/// Returns the home of cargo.
fn home() -> Option<PathBuf> {
    env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")))
}

/// Returns the output of `rustc -vV`.
pub(crate) fn rustc_version() -> Result<String, Error> {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    output(Command::new(rustc).arg("-vV"), "rustc")
}

fn host(version: &str) -> Result<&str, Error> {
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    host.ok_or_else(|| Error::new("rustc -vV", "no line `host:`"))
}

fn output(command: &mut Command, name: &str) -> Result<String, Error> {
    let output = command.output().map_err(|why| Error::new(name, why))?;
    if !output.status.success() {
        return Err(Error::new(name, String::from_utf8_lossy(&output.stderr).trim()));
    }
    String::from_utf8(output.stdout).map_err(|why| Error::new(name, why))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TREE: &str = "0\tcell v0.2.0 (/src/cell)\tMIT\t\n1\tsnap v1.0.0\tMIT\t\n1\ttime v0.3.0\tMIT\t\n";

    #[test]
    fn sources_are_found_in_the_home_of_cargo() {
        let home = tempfile::tempdir().unwrap();
        let tree = Tree::parse(TREE).unwrap();
        assert!(Sources::find(home.path(), &tree).is_none());
        let put = |name: &str, manifest: &str| {
            let folder = home.path().join("registry/src/index.crates.io-1").join(name);
            fs::create_dir_all(&folder).unwrap();
            fs::write(folder.join("Cargo.toml"), manifest).unwrap();
        };
        put("snap-1.0.0", "[package]\nname = \"snap\"\nauthors = [\"A. Author\"]\n");
        assert!(Sources::find(home.path(), &tree).is_none(), "time is missing");
        put("time-0.3.0", "[package]\nname = \"time\"\n");
        let sources = Sources::find(home.path(), &tree).unwrap();
        let [cell, snap, time] = &tree.packages[..] else { panic!() };
        assert_eq!(sources.of(snap).unwrap().authors, ["A. Author"]);
        assert!(sources.of(time).unwrap().folder.ends_with("time-0.3.0"));
        assert_eq!(sources.of(cell).err().unwrap().to_string(), "cell 0.2.0: no source folder");
    }
}
