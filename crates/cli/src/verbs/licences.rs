//! Licences of all software in the program, and its bill of materials: what `build.rs` embeds for the packages of Rust,
//! and the panel carries for those of npm.

use crate::args::licences::LicencesArgs;
use crate::rows::{print_json, print_text};
use flate2::read::GzDecoder;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_record::Moment;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::{Display, Write as _};

/// Compressed JSON of [`Notices`].
const NOTICES: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/notices.json.gz"));

/// Compressed bill of materials, with all packages of npm that the panel may contain.
const BILL: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/bill.json.gz"));

/// Reason why the build could not make them; empty if it could.
const NOT_MADE: &str = include_str!(concat!(env!("OUT_DIR"), "/no-notices.txt"));

/// Licences of Seamwright itself.
const OWN: [&str; 2] = [include_str!("../../../../LICENSE-MIT"), include_str!("../../../../LICENSE-APACHE")];

/// Maximum width of a heading, in columns.
const WIDTH: usize = 100;

#[derive(Deserialize)]
struct Notices {
    packages: Vec<Package>,
    texts: Vec<Text>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    version: String,
    licence: String,
    source: String,
}

#[derive(Deserialize)]
struct Text {
    /// Names and versions.
    packages: Vec<String>,
    text: String,
}

/// A package of npm in the panel.
#[derive(Deserialize)]
struct PanelPackage {
    name: String,
    version: String,
    #[serde(rename = "identifier")]
    licence: Option<String>,
    text: Option<String>,
}

pub(crate) fn run(args: &LicencesArgs) -> Result<(), Failure> {
    if !NOT_MADE.is_empty() {
        return Err(missing(&NOT_MADE));
    }
    let panel = panel_packages()?;
    if args.sbom { print_json(&bill(&panel)?) } else { print_text(&text(&panel)?) }
}

fn missing(why: &dyn Display) -> Failure {
    Failure::environment(Message::new("cli-no-notices").message("why", Message::outside(why)))
}

fn unpacked<T: DeserializeOwned>(zipped: &[u8]) -> Result<T, Failure> {
    serde_json::from_reader(GzDecoder::new(zipped)).map_err(|why| missing(&why))
}

/// Returns the packages in the panel; none if the program was built without it.
fn panel_packages() -> Result<Vec<PanelPackage>, Failure> {
    let json = seamwright_server::panel_packages().unwrap_or(b"[]");
    serde_json::from_slice(json).map_err(|why| missing(&why))
}

/// Returns the bill of materials of this very program, made now.
fn bill(panel: &[PanelPackage]) -> Result<Value, Failure> {
    let mut bill: Value = unpacked(BILL)?;
    let in_panel: Vec<String> = panel
        .iter()
        .map(|package| format!("pkg:npm/{}@{}", package.name.replace('@', "%40"), package.version))
        .collect();
    // Packages that only build the panel, as the compiler in the package `svelte`, are in no file of it.
    let is_in = |reference: &Value| {
        reference.as_str().is_some_and(|text| !text.starts_with("pkg:npm/") || in_panel.iter().any(|one| one == text))
    };
    if let Some(components) = bill["components"].as_array_mut() {
        components.retain(|component| is_in(&component["purl"]));
    }
    if let Some(dependencies) = bill["dependencies"].as_array_mut() {
        dependencies.retain(|dependency| is_in(&dependency["ref"]));
        // An index would add the missing ones.
        let used = dependencies.iter_mut().filter_map(|dependency| dependency.get_mut("dependsOn")?.as_array_mut());
        used.for_each(|used| used.retain(is_in));
    }
    bill["metadata"]["timestamp"] = Moment::now().to_string().replace(" UTC", "Z").replace(' ', "T").into();
    Ok(bill)
}

/// Returns the notices: a table of packages, then the texts of the licences.
fn text(panel: &[PanelPackage]) -> Result<String, Failure> {
    let Notices { packages, texts } = unpacked(NOTICES)?;
    let version = env!("CARGO_PKG_VERSION");
    let mut out = format!(
        "Seamwright {version} is licensed under MIT or Apache-2.0, as you choose. Both texts follow the tables.\n\n\
         It contains software of others, or was built with it. \"A OR B\" is used under the term whose text follows.\n\n"
    );
    let npm: Vec<Package> = panel.iter().map(PanelPackage::listed).collect();
    table(&mut out, "Packages of Rust, and what they contain", &packages);
    table(&mut out, "Packages of npm in the panel", &npm);
    section(&mut out, &["Seamwright".to_owned()], &OWN.join("\n"));
    for text in texts.iter().chain(&panel_texts(panel)) {
        section(&mut out, &text.packages, &text.text);
    }
    Ok(out)
}

fn table(out: &mut String, title: &str, packages: &[Package]) {
    let width = |of: fn(&Package) -> &String| packages.iter().map(|package| of(package).len()).max().unwrap_or(0);
    let [name, version, licence] = [width(|p| &p.name), width(|p| &p.version), width(|p| &p.licence)];
    // Writing to a String cannot fail.
    let _ = writeln!(out, "{title}: {}\n", packages.len());
    for p in packages {
        let _ = writeln!(out, "{:name$}  {:version$}  {:licence$}  {}", p.name, p.version, p.licence, p.source);
    }
    out.push('\n');
}

/// Adds a text under the packages that it belongs to.
fn section(out: &mut String, packages: &[String], text: &str) {
    let rule = "=".repeat(WIDTH);
    let mut column = 0;
    out.push_str(&rule);
    for (i, package) in packages.iter().enumerate() {
        let comma = if i + 1 < packages.len() { "," } else { "" };
        // The last part of a line is a comma.
        let fits = i > 0 && column + 1 + package.len() < WIDTH;
        column = if fits { column + 1 } else { 0 } + package.len() + comma.len();
        let _ = write!(out, "{}{package}{comma}", if fits { ' ' } else { '\n' });
    }
    let _ = write!(out, "\n{rule}\n{}\n\n", text.trim_end());
}

impl PanelPackage {
    fn listed(&self) -> Package {
        let source = format!("https://www.npmjs.com/package/{}/v/{}", self.name, self.version);
        let licence = self.licence.clone().unwrap_or_default();
        Package { name: self.name.clone(), version: self.version.clone(), licence, source }
    }
}

/// Returns the texts of the panel's packages, equal ones once.
fn panel_texts(panel: &[PanelPackage]) -> Vec<Text> {
    let mut texts: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for package in panel {
        let text = package.text.as_deref().unwrap_or(match package.licence.as_deref() {
            Some("Apache-2.0") => OWN[1],
            _ => "This package has no text of its licence.",
        });
        texts.entry(text).or_default().push(format!("{} {}", package.name, package.version));
    }
    texts.into_iter().map(|(text, packages)| Text { packages, text: text.to_owned() }).collect()
}
