//! Software in the program that is no package of a registry.

use crate::cargo::rustc_version;
use crate::package_url::purl;
use crate::{Error, Package};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Compiler and platform of the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Toolchain {
    /// Version of rustc and of its standard library.
    pub rust: String,
    /// Target triple.
    pub platform: String,
}

/// Software in the program that is no package of a registry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Bundled {
    pub(crate) name: String,
    pub(crate) version: String,
    pub(crate) licence: &'static str,
    pub(crate) source: &'static str,
    /// Name in databases of vulnerabilities, before the version.
    cpe: &'static str,
}

impl Toolchain {
    /// Returns that of rustc on this computer, for a platform.
    ///
    /// # Errors
    /// rustc cannot be run.
    pub fn for_platform(platform: impl Into<String>) -> Result<Self, Error> {
        let version = rustc_version()?;
        let release = version.lines().find_map(|line| line.strip_prefix("release: "));
        let rust = release.ok_or_else(|| Error::new("rustc -vV", "no line `release:`"))?.to_owned();
        Ok(Self { rust, platform: platform.into() })
    }

    pub(crate) fn standard_library(&self) -> Bundled {
        Bundled {
            name: "rust-std".to_owned(),
            version: self.rust.clone(),
            licence: "MIT OR Apache-2.0",
            source: "https://github.com/rust-lang/rust",
            cpe: "cpe:2.3:a:rust-lang:rust",
        }
    }
}

/// Returns what a package brings in its folder: SQLite, whose vulnerabilities are reported for its own version.
pub(crate) fn bundled(package: &Package, folder: &Path) -> Result<Option<Bundled>, Error> {
    if package.name != "libsqlite3-sys" {
        return Ok(None);
    }
    let header = folder.join("sqlite3/sqlite3.h");
    let text = fs::read(&header).map_err(|why| Error::of_file(&header, why))?;
    let text = String::from_utf8_lossy(&text);
    let version = text
        .lines()
        .find_map(|line| line.strip_prefix("#define SQLITE_VERSION ")?.trim().strip_prefix('"')?.strip_suffix('"'));
    let version = version.ok_or_else(|| Error::of_file(&header, "no SQLITE_VERSION"))?.to_owned();
    Ok(Some(Bundled {
        name: "sqlite".to_owned(),
        version,
        licence: "blessing",
        source: "https://www.sqlite.org",
        cpe: "cpe:2.3:a:sqlite:sqlite",
    }))
}

impl Bundled {
    pub(crate) fn reference(&self) -> String {
        purl("generic", &self.name, &self.version)
    }

    pub(crate) fn component(&self) -> Value {
        json!({
            "type": "library",
            "bom-ref": self.reference(),
            "name": self.name,
            "version": self.version,
            "scope": "required",
            "licenses": [{ "expression": self.licence }],
            "cpe": format!("{}:{}:*:*:*:*:*:*:*", self.cpe, self.version),
            "purl": self.reference(),
            "externalReferences": [{ "type": "website", "url": self.source }],
        })
    }
}
