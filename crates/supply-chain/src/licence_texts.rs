//! Texts of licences in the folder of a package.

use crate::Error;
use spdx::{LicenseItem, LicenseReq};
use std::fs;
use std::path::{Path, PathBuf};

/// A text that must go with the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LicenceText {
    /// Name of its file; missing if the package has none and this is the standard text.
    pub file: Option<String>,
    /// The text.
    pub text: String,
}

/// Starts of the names of files with licences and notices, in lower case.
const FILES: [&str; 7] = ["license", "licence", "copying", "notice", "copyright", "unlicense", "patents"];

/// Folders with such files, in lower case.
const FOLDERS: [&str; 2] = ["licenses", "licences"];

/// Ends of names that are sources or data.
const NOT_TEXTS: [&str; 6] = ["rs", "toml", "json", "html", "spdx", "tmpl"];

/// Licences by words in the names of files, in lower case.
const WORDS: [(&str, &str); 11] = [
    ("mit", "MIT"),
    ("apache", "Apache-2.0"),
    ("zlib", "Zlib"),
    ("unlicense", "Unlicense"),
    ("boost", "BSL-1.0"),
    ("bsl", "BSL-1.0"),
    ("0bsd", "0BSD"),
    ("cc0", "CC0-1.0"),
    ("isc", "ISC"),
    ("gpl", "GPL-2.0-only"),
    ("mpl", "MPL-2.0"),
];

/// Returns the texts of the chosen terms: those in the folder, or the standard ones if it has none.
///
/// A file whose name is that of another term is left out: of `LICENSE-MIT` and `LICENSE-APACHE` only the first, if the
/// package is used under MIT.
pub(crate) fn texts(folder: &Path, chosen: &[LicenseReq]) -> Result<Vec<LicenceText>, Error> {
    let chosen: Vec<&str> = chosen.iter().filter_map(|term| term.license.id()).map(|id| id.name).collect();
    let mut found = Vec::new();
    for path in files(folder)? {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let named = named_licence(&name);
        if named.is_none_or(|id| chosen.contains(&id)) {
            let text = fs::read(&path).map_err(|why| Error::of_file(&path, why))?;
            found.push(LicenceText { file: Some(name), text: String::from_utf8_lossy(&text).trim_end().to_owned() });
        }
    }
    if found.iter().all(|text| text.text.trim().is_empty()) {
        found = standard(&chosen);
    }
    Ok(found)
}

/// Returns the standard texts of licences.
pub(crate) fn standard(ids: &[&str]) -> Vec<LicenceText> {
    let ids = ids.iter().filter_map(|id| spdx::license_id(id));
    ids.map(|id| LicenceText { file: None, text: id.text().trim_end().to_owned() }).collect()
}

/// Returns the identifier of a licence, without an exception.
pub(crate) fn id_of(term: &LicenseReq) -> Option<&'static str> {
    match &term.license {
        LicenseItem::Spdx { id, .. } => Some(id.name),
        LicenseItem::Other(_) => None,
    }
}

fn files(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(|why| Error::of_file(folder, why))? {
        let path = entry.map_err(|why| Error::of_file(folder, why))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        if path.is_dir() && FOLDERS.contains(&name.as_str()) {
            for entry in fs::read_dir(&path).map_err(|why| Error::of_file(&path, why))? {
                files.push(entry.map_err(|why| Error::of_file(&path, why))?.path());
            }
        } else if path.is_file() && FILES.iter().any(|start| name.starts_with(start)) {
            files.push(path);
        }
    }
    let is_text = |path: &PathBuf| path.extension().is_none_or(|end| !NOT_TEXTS.iter().any(|other| end == *other));
    files.retain(|path| path.is_file() && is_text(path));
    files.sort();
    Ok(files)
}

/// The licence that a file's name states, as `LICENSE-MIT`.
fn named_licence(name: &str) -> Option<&'static str> {
    let name = name.to_lowercase();
    let mut words = name.split(|c: char| !c.is_ascii_alphanumeric());
    // `unlicense` is a whole name, and `apache` the start of `apache2`.
    words.find_map(|word| WORDS.iter().find(|(start, _)| word.starts_with(start)).map(|(_, id)| *id))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn terms(expression: &str) -> Vec<LicenseReq> {
        spdx::Expression::parse(expression).unwrap().requirements().map(|term| term.req.clone()).collect()
    }

    fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        folder
    }

    fn found(files: &[(&str, &str)], chosen: &str) -> Vec<(Option<String>, String)> {
        let folder = folder(files);
        texts(folder.path(), &terms(chosen)).unwrap().into_iter().map(|text| (text.file, text.text)).collect()
    }

    #[test]
    fn only_texts_of_the_chosen_terms_are_taken() {
        let files = [
            ("LICENSE-APACHE", "apache"),
            ("LICENSE-MIT", "mit\n"),
            ("LICENSE-GPLv2", "gpl"),
            ("NOTICE", "notice"),
            ("license.rs", "fn main"),
            ("README.md", "readme"),
        ];
        let of = |name: &str, text: &str| (Some(name.to_owned()), text.to_owned());
        assert_eq!(found(&files, "MIT"), [of("LICENSE-MIT", "mit"), of("NOTICE", "notice")]);
        assert_eq!(found(&files, "Apache-2.0"), [of("LICENSE-APACHE", "apache"), of("NOTICE", "notice")]);
        let both = [of("LICENSE-APACHE", "apache"), of("LICENSE-MIT", "mit"), of("NOTICE", "notice")];
        assert_eq!(found(&files, "MIT AND Apache-2.0"), both);
        let folder = [("LICENSES/MIT.txt", "mit"), ("LICENSES/CC0-1.0.txt", "cc0")];
        assert_eq!(found(&folder, "MIT"), [of("MIT.txt", "mit")]);
    }

    #[test]
    fn without_a_file_the_text_is_the_standard_one() {
        for files in [&[][..], &[("LICENSE", " \n")], &[("LICENSE-APACHE", "of the other term")]] {
            let [(None, text)] = &found(files, "MIT")[..] else { panic!("{files:?}") };
            assert!(text.contains("Permission is hereby granted"), "{text}");
        }
    }
}
