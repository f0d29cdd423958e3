//! Lock files: versions, checksums and sources of packages.

use crate::Error;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// `Cargo.lock`: the packages of all platforms and features.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct CargoLock {
    /// The packages.
    #[serde(rename = "package")]
    pub packages: Vec<LockedPackage>,
}

/// A package of `Cargo.lock`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct LockedPackage {
    /// Name in the registry.
    pub name: String,
    /// Version.
    pub version: String,
    /// Registry or version control system; missing for packages of this repository.
    pub source: Option<String>,
    /// SHA-256 of the package file.
    pub checksum: Option<String>,
}

impl CargoLock {
    /// Reads the file.
    ///
    /// # Errors
    /// The file cannot be read, or is no lock file.
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::parse(&fs::read_to_string(path).map_err(|why| Error::of_file(path, why))?)
            .map_err(|why| Error::of_file(path, why))
    }

    /// Parses its text.
    ///
    /// # Errors
    /// The text is no lock file.
    pub fn parse(text: &str) -> Result<Self, Error> {
        toml::from_str(text).map_err(|why| Error::new("Cargo.lock", why.message()))
    }

    /// Returns the SHA-256 of a package file.
    pub fn checksum(&self, name: &str, version: &str) -> Option<&str> {
        let package = self.packages.iter().find(|package| package.name == name && package.version == version);
        package.and_then(|package| package.checksum.as_deref())
    }
}

/// `package-lock.json`: the npm packages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NpmLock {
    /// The packages, without the one that the file belongs to.
    pub packages: Vec<NpmPackage>,
}

/// A package of `package-lock.json`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NpmPackage {
    /// Name in the registry.
    pub name: String,
    /// Version.
    pub version: String,
    /// Declared licence.
    pub licence: Option<String>,
    /// Checksums of the package file in the form of npm: `sha512-` and base64.
    pub integrity: Option<String>,
    /// Address of the package file, if it is stated.
    pub resolved: Option<String>,
    /// Only needed to build or test.
    pub is_development: bool,
}

#[derive(Deserialize)]
struct NpmFile {
    packages: BTreeMap<String, NpmEntry>,
}

#[derive(Deserialize)]
struct NpmEntry {
    /// Only given if the folder has another name.
    name: Option<String>,
    #[serde(default)]
    version: String,
    license: Option<String>,
    integrity: Option<String>,
    resolved: Option<String>,
    #[serde(default)]
    dev: bool,
}

impl NpmLock {
    /// Reads the file.
    ///
    /// # Errors
    /// The file cannot be read, or is no lock file of version 2 or 3.
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::parse(&fs::read_to_string(path).map_err(|why| Error::of_file(path, why))?)
            .map_err(|why| Error::of_file(path, why))
    }

    /// Parses its text.
    ///
    /// # Errors
    /// The text is no lock file of version 2 or 3.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let file: NpmFile = serde_json::from_str(text).map_err(|why| Error::new("package-lock.json", why))?;
        // The entry without a folder is the panel itself.
        let installed = file.packages.into_iter().filter(|(folder, _)| !folder.is_empty());
        let packages = installed.map(|(folder, entry)| NpmPackage {
            name: entry.name.unwrap_or_else(|| folder.rsplit("node_modules/").next().unwrap_or_default().to_owned()),
            version: entry.version,
            licence: entry.license,
            integrity: entry.integrity,
            resolved: entry.resolved,
            is_development: entry.dev,
        });
        Ok(Self { packages: packages.collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn npm_packages_have_the_name_of_their_folder() {
        let text = r#"{"packages": {"": {"name": "panel"},
            "node_modules/@a/b": {"version": "1.0.0", "license": "MIT", "integrity": "sha512-AA=="},
            "node_modules/c/node_modules/d": {"version": "2.0.0", "dev": true},
            "node_modules/e": {"name": "f", "version": "3.0.0", "resolved": "git+ssh://x"}}}"#;
        let lock = NpmLock::parse(text).unwrap();
        let names: Vec<&str> = lock.packages.iter().map(|package| package.name.as_str()).collect();
        assert_eq!(names, ["@a/b", "d", "f"]);
        assert!(lock.packages[1].is_development && !lock.packages[0].is_development);
    }

    #[test]
    fn other_texts_are_no_lock_files() {
        for text in ["", "[]", "{}", "{\"packages\": 3}"] {
            assert!(NpmLock::parse(text).is_err(), "{text}");
        }
        for text in ["x", "package = 3", "[[package]]\nname = \"a\""] {
            assert!(CargoLock::parse(text).is_err(), "{text}");
        }
    }
}
