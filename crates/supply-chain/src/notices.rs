//! Notices of third-party packages: what their licences require to go with the program.

use crate::bundled::{Bundled, Toolchain, bundled};
use crate::cargo::{Source, Sources};
use crate::licence_texts::{LicenceText, id_of, standard, texts};
use crate::rules::{canonical, expression};
use crate::{Error, Package, Rules, Tree};
use serde::Serialize;
use spdx::Expression;
use std::collections::BTreeMap;

/// Packages, and the texts of their licences.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Notices {
    /// The packages, sorted by name.
    pub packages: Vec<Noticed>,
    /// The texts, equal ones once.
    pub texts: Vec<NoticeText>,
}

/// A package of the notices.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Noticed {
    /// Name.
    pub name: String,
    /// Version.
    pub version: String,
    /// Licence, an SPDX expression.
    pub licence: String,
    /// Address of the source.
    pub source: String,
}

/// A text with the packages that it belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct NoticeText {
    /// Names and versions.
    pub packages: Vec<String>,
    /// The text.
    pub text: String,
}

/// Returns the notices of all packages that are in the program or take part in its build.
///
/// # Errors
/// The sources of a package are missing.
pub fn notices(sources: &Sources, tree: &Tree, rules: &Rules, toolchain: &Toolchain) -> Result<Notices, Error> {
    let mut notices = Notices { packages: Vec::new(), texts: Vec::new() };
    let mut places = BTreeMap::new();
    for package in tree.third_party() {
        let source = sources.of(package)?;
        notices.packages.push(noticed(package));
        for text in of_package(package, source, rules)? {
            notices.add(&mut places, package.title(), text);
        }
        notices.packages.extend(bundled(package, &source.folder)?.map(|bundled| bundled.noticed()));
    }
    let library = toolchain.standard_library();
    let text = format!("Copyright (c) The Rust Project Contributors\n\n{}", standard_text("MIT"));
    notices.add(&mut places, format!("{} {}", library.name, library.version), text);
    notices.packages.push(library.noticed());
    notices.packages.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
    Ok(notices)
}

impl Notices {
    /// Adds a text, or the package to an equal text. `places` are the positions of texts by their words.
    fn add(&mut self, places: &mut BTreeMap<String, usize>, package: String, text: String) {
        let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let at = *places.entry(words).or_insert(self.texts.len());
        if at == self.texts.len() {
            self.texts.push(NoticeText { packages: Vec::new(), text });
        }
        if self.texts[at].packages.last() != Some(&package) {
            self.texts[at].packages.push(package);
        }
    }
}

/// Returns the texts of a package.
fn of_package(package: &Package, source: &Source, rules: &Rules) -> Result<Vec<String>, Error> {
    // Without an allowed choice all texts are taken; the check of the rules reports the package.
    let terms = rules.chosen(&package.name, package.licence.as_deref()).unwrap_or_else(|_| {
        let expression = package.licence.as_deref().and_then(expression);
        expression.iter().flat_map(Expression::requirements).map(|term| term.req.clone()).collect()
    });
    let found = texts(&source.folder, &terms)?;
    let names = terms.iter().filter_map(id_of).collect::<Vec<_>>().join(", ");
    let text = |LicenceText { file, text }| match file {
        Some(_) => text,
        // Without a file only the manifest names the authors.
        None if source.authors.is_empty() => format!("Licence as declared: {names}\n\n{text}"),
        None => format!("Licence as declared: {names}\nAuthors: {}\n\n{text}", source.authors.join(", ")),
    };
    Ok(found.into_iter().map(text).collect())
}

fn noticed(package: &Package) -> Noticed {
    let (name, version) = package.key();
    let source = format!("https://crates.io/crates/{name}/{version}");
    let licence = canonical(package.licence.as_deref().unwrap_or_default());
    Noticed { name, version, licence, source }
}

fn standard_text(id: &str) -> String {
    standard(&[id]).into_iter().map(|text| text.text).collect()
}

impl Bundled {
    fn noticed(&self) -> Noticed {
        let [name, version] = [&self.name, &self.version].map(ToOwned::to_owned);
        Noticed { name, version, licence: self.licence.to_owned(), source: self.source.to_owned() }
    }
}
