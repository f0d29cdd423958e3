//! The bill of materials (SBOM) in CycloneDX 1.6.

use crate::bundled::{Toolchain, bundled};
use crate::cargo::Sources;
use crate::package_url::purl;
use crate::rules::canonical;
use crate::{CargoLock, Error, NpmLock, NpmPackage, Package, Tree};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// Reference of the program itself.
const PROGRAM: &str = "seamwright";

/// Returns the bill of materials of the program: packages of Rust, and all of npm that the panel may contain.
///
/// Packages have `scope` `required` if their code is in the program, `excluded` if they only take part in its build.
/// There is no time in it, so that equal sources give equal bills.
///
/// # Errors
/// The sources of a package are missing; a checksum of npm is malformed.
pub fn bill_of_materials(
    sources: &Sources,
    tree: &Tree,
    lock: &CargoLock,
    npm: &NpmLock,
    toolchain: &Toolchain,
    version: &str,
) -> Result<Value, Error> {
    let library = toolchain.standard_library();
    let mut components = vec![library.component()];
    let mut dependencies = Vec::new();
    // Packages of this repository are the program: what they use, it uses.
    let mut program = BTreeSet::from([library.reference()]);
    for package in &tree.packages {
        let mut used: BTreeSet<String> = package.uses.iter().filter_map(|at| reference(&tree.packages[*at])).collect();
        let Some(this) = reference(package) else {
            program.extend(used);
            continue;
        };
        components.push(component(package, &this, lock));
        if let Some(bundled) = bundled(package, &sources.of(package)?.folder)? {
            used.insert(bundled.reference());
            dependencies.push(json!({ "ref": bundled.reference() }));
            components.push(bundled.component());
        }
        dependencies.push(json!({ "ref": this, "dependsOn": used }));
    }
    for package in npm.packages.iter().filter(|package| !package.is_development) {
        let component = npm_component(package)?;
        program.insert(npm_reference(package));
        dependencies.push(json!({ "ref": npm_reference(package) }));
        components.push(component);
    }
    dependencies.push(json!({ "ref": library.reference() }));
    dependencies.push(json!({ "ref": PROGRAM, "dependsOn": program }));
    components.sort_by_key(|component| component["bom-ref"].to_string());
    dependencies.sort_by_key(|dependency| dependency["ref"].to_string());
    Ok(json!({
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {
            "lifecycles": [{ "phase": "build" }],
            "tools": { "components": [{ "type": "application", "name": env!("CARGO_PKG_NAME"), "version": version }] },
            "component": {
                "type": "application",
                "bom-ref": PROGRAM,
                "name": PROGRAM,
                "version": version,
                "licenses": [{ "expression": "MIT OR Apache-2.0" }],
                "purl": format!("pkg:generic/{PROGRAM}@{version}"),
            },
            "properties": [{ "name": "seamwright:platform", "value": toolchain.platform }],
        },
        "components": components,
        "dependencies": dependencies,
    }))
}

/// Returns the package URL of a third-party package; none for those of this repository.
fn reference(package: &Package) -> Option<String> {
    // Other origins violate the rules; their packages are listed all the same.
    (!package.is_own()).then(|| purl("cargo", &package.name, &package.version))
}

fn component(package: &Package, reference: &str, lock: &CargoLock) -> Value {
    let mut component = json!({
        "type": "library",
        "bom-ref": reference,
        "name": package.name,
        "version": package.version,
        "scope": if package.is_linked { "required" } else { "excluded" },
        "licenses": [{ "expression": canonical(package.licence.as_deref().unwrap_or_default()) }],
        "purl": reference,
    });
    if let Some(checksum) = lock.checksum(&package.name, &package.version) {
        component["hashes"] = json!([{ "alg": "SHA-256", "content": checksum }]);
    }
    if let Some(repository) = &package.repository {
        component["externalReferences"] = json!([{ "type": "vcs", "url": repository }]);
    }
    component
}

fn npm_reference(package: &NpmPackage) -> String {
    purl("npm", &package.name, &package.version)
}

fn npm_component(package: &NpmPackage) -> Result<Value, Error> {
    let malformed = || Error::new(format!("npm {} {}", package.name, package.version), "its checksum is malformed");
    let base64 = package.integrity.as_deref().and_then(|sum| sum.strip_prefix("sha512-")).ok_or_else(malformed)?;
    let bytes = STANDARD.decode(base64).map_err(|_| malformed())?;
    let hash: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    Ok(json!({
        "type": "library",
        "bom-ref": npm_reference(package),
        "name": package.name,
        "version": package.version,
        "scope": "required",
        "hashes": [{ "alg": "SHA-512", "content": hash }],
        "licenses": [{ "expression": canonical(package.licence.as_deref().unwrap_or_default()) }],
        "purl": npm_reference(package),
    }))
}
