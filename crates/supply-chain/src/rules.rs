//! Rules of `deny.toml`, and what violates them.
//!
//! `cargo deny` reads the same file and checks more (advisories, licences by their texts, all platforms). These checks
//! always run.

use crate::{CargoLock, Error, LockedPackage, NpmLock, NpmPackage, Origin, Package, Tree};
use serde::Deserialize;
use spdx::{Expression, LicenseReq, Licensee, ParseMode};
use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::path::Path;

/// Licence of every package of this repository.
const OWN_LICENCE: &str = "MIT OR Apache-2.0";

/// Registry of npm, as lock files name it.
const NPM_REGISTRY: &str = "https://registry.npmjs.org/";

/// Rules for third-party packages.
#[derive(Debug, Clone)]
pub struct Rules {
    /// Licences for every package, the preferred one first.
    allowed: Vec<Licensee>,
    /// Licences for single packages.
    exceptions: BTreeMap<String, Vec<Licensee>>,
    banned: Vec<Listed>,
    /// Versions that may be in the program beside another one.
    doubled: Vec<Listed>,
    registries: Vec<String>,
}

/// A rule that a package can violate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rule {
    /// Its licence is on the list.
    Licence,
    /// It is not banned.
    Ban,
    /// It is in the program in one version.
    OneVersion,
    /// It comes from an allowed registry.
    Source,
    /// The lock file has its checksum.
    Checksum,
    /// Each entry of `deny.toml` is of use.
    Entry,
}

/// A package that violates a rule.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Violation {
    /// The rule.
    pub rule: Rule,
    /// Name and version.
    pub package: String,
    /// Reason: the value that violates it.
    pub why: String,
}

/// Name of a package with all or some of its versions, and the reason of the entry.
#[derive(Debug, Clone)]
struct Listed {
    name: String,
    versions: Versions,
    reason: String,
}

#[derive(Debug, Clone)]
enum Versions {
    All,
    Exact(String),
    /// Those that start with these numbers.
    Start(String),
}

#[derive(Deserialize)]
struct File {
    licenses: Licences,
    bans: Bans,
    sources: Sources,
}

#[derive(Deserialize)]
struct Licences {
    allow: Vec<String>,
    #[serde(default)]
    exceptions: Vec<Exception>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Exception {
    #[serde(rename = "crate")]
    package: String,
    allow: Vec<String>,
}

#[derive(Deserialize)]
struct Bans {
    #[serde(default)]
    deny: Vec<Entry>,
    #[serde(default)]
    skip: Vec<Entry>,
}

/// An entry that is understood here as by `cargo deny`: other fields of its are refused.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    #[serde(rename = "crate")]
    package: String,
    reason: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
struct Sources {
    allow_registry: Vec<String>,
}

impl Rules {
    /// Reads `deny.toml`.
    ///
    /// # Errors
    /// The file cannot be read; an entry has no reason, an unknown licence, or a form that is not understood here.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = fs::read_to_string(path).map_err(|why| Error::of_file(path, why))?;
        Self::parse(&text).map_err(|why| Error::of_file(path, why))
    }

    /// Parses its text.
    ///
    /// # Errors
    /// As of [`read`](Self::read).
    pub fn parse(text: &str) -> Result<Self, Error> {
        let file: File = toml::from_str(text).map_err(|why| Error::new("rules", why.to_string().trim()))?;
        let exceptions = file.licenses.exceptions.into_iter().map(|one| Ok((one.package, licensees(&one.allow)?)));
        let listed = |entries: Vec<Entry>| entries.into_iter().map(Listed::try_from).collect::<Result<_, _>>();
        Ok(Self {
            allowed: licensees(&file.licenses.allow)?,
            exceptions: exceptions.collect::<Result<_, Error>>()?,
            banned: listed(file.bans.deny)?,
            doubled: listed(file.bans.skip)?,
            registries: file.sources.allow_registry,
        })
    }

    /// Returns all violations, sorted.
    ///
    /// `all` are the packages of the workspace with its tests, `built` those without. `npm` are the lock files of the
    /// panel and of its tests.
    pub fn violations(&self, all: &Tree, built: &Tree, cargo: &CargoLock, npm: &[NpmLock]) -> Vec<Violation> {
        let mut found: Vec<Violation> =
            all.packages.iter().filter_map(|package| self.licence_violation(package)).collect();
        found.extend(cargo.packages.iter().filter_map(|package| self.ban(package)));
        found.extend(cargo.packages.iter().filter_map(|package| self.source(package)));
        found.extend(all.packages.iter().filter_map(foreign));
        found.extend(self.several_versions(built));
        found.extend(npm.iter().flat_map(|lock| &lock.packages).filter_map(|package| self.npm_violation(package)));
        found.extend(self.unused_entries(cargo));
        found.sort();
        found.dedup();
        found
    }

    /// Returns the terms of its licence under which a package is used: the preferred ones of a choice.
    ///
    /// # Errors
    /// No allowed licence; the text is the reason.
    pub fn chosen(&self, name: &str, licence: Option<&str>) -> Result<Vec<LicenseReq>, String> {
        let licence = licence.ok_or("no licence is declared")?;
        let expression = expression(licence).ok_or_else(|| format!("`{licence}` is no SPDX expression"))?;
        let own = self.exceptions.get(name).into_iter().flatten();
        let minimum = expression.minimized_requirements(self.allowed.iter().chain(own));
        minimum.map_err(|_| format!("`{licence}` is not allowed"))
    }

    fn licence_violation(&self, package: &Package) -> Option<Violation> {
        let why = match package.origin {
            Origin::Own(_) if package.licence.as_deref() == Some(OWN_LICENCE) => return None,
            Origin::Own(_) => format!("packages of this repository are `{OWN_LICENCE}`"),
            Origin::Registry | Origin::Elsewhere(_) => self.chosen(&package.name, package.licence.as_deref()).err()?,
        };
        Some(Violation { rule: Rule::Licence, package: package.title(), why })
    }

    fn ban(&self, package: &LockedPackage) -> Option<Violation> {
        let ban = self.banned.iter().find(|ban| ban.has(&package.name, &package.version))?;
        let package = format!("{} {}", package.name, package.version);
        Some(Violation { rule: Rule::Ban, package, why: ban.reason.clone() })
    }

    fn source(&self, package: &LockedPackage) -> Option<Violation> {
        // Packages of this repository have none.
        let source = package.source.as_deref()?;
        let registry = source.strip_prefix("registry+");
        let title = format!("{} {}", package.name, package.version);
        if !registry.is_some_and(|registry| self.registries.iter().any(|allowed| allowed == registry)) {
            return Some(Violation { rule: Rule::Source, package: title, why: format!("`{source}` is not allowed") });
        }
        let is_hash = |sum: &str| sum.len() == 64 && sum.bytes().all(|byte| byte.is_ascii_hexdigit());
        let has_checksum = package.checksum.as_deref().is_some_and(is_hash);
        let why = "Cargo.lock has no SHA-256 of it".to_owned();
        (!has_checksum).then_some(Violation { rule: Rule::Checksum, package: title, why })
    }

    fn several_versions(&self, built: &Tree) -> Vec<Violation> {
        let mut versions: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for package in built.third_party() {
            if !self.doubled.iter().any(|entry| entry.has(&package.name, &package.version)) {
                versions.entry(&package.name).or_default().push(&package.version);
            }
        }
        let several = versions.into_iter().filter(|(_, versions)| versions.len() > 1);
        let violation = |(name, versions): (&str, Vec<&str>)| Violation {
            rule: Rule::OneVersion,
            package: name.to_owned(),
            why: format!("the program has the versions {}", versions.join(", ")),
        };
        several.map(violation).collect()
    }

    /// A licence matters for what is distributed; source and checksum for all that runs on a computer of ours.
    fn npm_violation(&self, package: &NpmPackage) -> Option<Violation> {
        let violation =
            |rule, why| Some(Violation { rule, package: format!("npm {} {}", package.name, package.version), why });
        if let Some(elsewhere) = package.resolved.as_deref().filter(|address| !address.starts_with(NPM_REGISTRY)) {
            return violation(Rule::Source, format!("`{elsewhere}` is not allowed"));
        }
        if !package.integrity.as_deref().is_some_and(|sum| sum.starts_with("sha512-")) {
            return violation(Rule::Checksum, "package-lock.json has no SHA-512 of it".to_owned());
        }
        if package.is_development {
            return None;
        }
        violation(Rule::Licence, self.chosen(&package.name, package.licence.as_deref()).err()?)
    }

    fn unused_entries(&self, lock: &CargoLock) -> Vec<Violation> {
        let is_locked = |entry: &Listed| lock.packages.iter().any(|package| entry.has(&package.name, &package.version));
        let doubled = self.doubled.iter().filter(|entry| !is_locked(entry)).map(|entry| &entry.name);
        let is_package = |name: &&String| lock.packages.iter().any(|package| package.name == **name);
        let exceptions = self.exceptions.keys().filter(|name| !is_package(name));
        let violation = |name: &String| Violation {
            rule: Rule::Entry,
            package: name.clone(),
            why: "Cargo.lock has no such package".to_owned(),
        };
        doubled.chain(exceptions).map(violation).collect()
    }
}

/// A package of a version control system or of another folder; `Cargo.lock` does not show the latter.
fn foreign(package: &Package) -> Option<Violation> {
    let Origin::Elsewhere(place) = &package.origin else { return None };
    Some(Violation { rule: Rule::Source, package: package.title(), why: format!("`{place}` is not allowed") })
}

/// Parses a licence; `MIT/Apache-2.0`, an older form, means a choice.
pub(crate) fn expression(licence: &str) -> Option<Expression> {
    let canonical = Expression::canonicalize(licence).ok()?;
    Expression::parse_mode(canonical.as_deref().unwrap_or(licence), ParseMode::LAX).ok()
}

/// Returns a licence as an SPDX expression: `MIT/Apache-2.0` is `MIT OR Apache-2.0`.
pub(crate) fn canonical(licence: &str) -> String {
    Expression::canonicalize(licence).ok().flatten().unwrap_or_else(|| licence.to_owned())
}

fn licensees(licences: &[String]) -> Result<Vec<Licensee>, Error> {
    licences
        .iter()
        .map(|id| Licensee::parse(id).map_err(|why| Error::new(format!("licence `{id}`"), why.reason)))
        .collect()
}

impl Listed {
    fn has(&self, name: &str, version: &str) -> bool {
        self.name == name
            && match &self.versions {
                Versions::All => true,
                Versions::Exact(exact) => exact == version,
                Versions::Start(start) => {
                    version.strip_prefix(start.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
                }
            }
    }
}

impl TryFrom<Entry> for Listed {
    type Error = Error;

    /// Parses `NAME`, `NAME@VERSION` and `NAME:START`. For `cargo deny` the latter is a version requirement: the same if
    /// the start is what makes versions compatible, as 0.2 or 1.
    fn try_from(entry: Entry) -> Result<Self, Error> {
        let (name, versions) = match entry.package.split_once(['@', ':']) {
            None => (entry.package.as_str(), Versions::All),
            Some((name, exact)) if entry.package.contains('@') => (name, Versions::Exact(exact.to_owned())),
            Some((name, start)) => (name, Versions::Start(start.to_owned())),
        };
        if let Versions::Start(numbers) | Versions::Exact(numbers) = &versions
            && !numbers.starts_with(|first: char| first.is_ascii_digit())
        {
            let why = "versions are `NAME@1.2.3` or `NAME:1.2`, without operators";
            return Err(Error::new(format!("`{}`", entry.package), why));
        }
        if entry.reason.trim().is_empty() {
            return Err(Error::new(format!("`{}`", entry.package), "the reason is empty"));
        }
        Ok(Self { name: name.to_owned(), versions, reason: entry.reason })
    }
}

impl Rule {
    fn name(self) -> &'static str {
        match self {
            Self::Licence => "licence",
            Self::Ban => "banned",
            Self::OneVersion => "several versions",
            Self::Source => "source",
            Self::Checksum => "checksum",
            Self::Entry => "deny.toml",
        }
    }

    fn cure(self) -> &'static str {
        match self {
            Self::Licence => {
                "use another package; or, if MIT or Apache-2.0 programs may contain it, allow the licence in deny.toml"
            }
            Self::Ban => "use another package; `cargo tree --target all -i NAME` shows which package brings it",
            Self::OneVersion => {
                "update its users to one version; or list the older one in deny.toml under `skip`, with the reason"
            }
            Self::Source => "use a release of the registry",
            Self::Checksum => "write the lock file anew with cargo or npm",
            Self::Entry => "delete the entry",
        }
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: {}\n   {}", self.rule.name(), self.package, self.why, self.rule.cure())
    }
}
