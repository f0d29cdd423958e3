//! Embeds the notices and the bill of materials of all third-party packages: `seamwright licences` prints them.
//!
//! They come from cargo and the folders of the packages, so that they are those of this build. If these cannot be read, the
//! build goes on, and the command reports why it cannot print them.

use flate2::Compression;
use flate2::write::GzEncoder;
use seamwright_supply_chain::{Cargo, CargoLock, Error, NpmLock, Rules, Toolchain, Tree, bill_of_materials, notices};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Files of the repository's root that decide which packages are in the program, and under which terms.
const INPUTS: [&str; 4] = ["Cargo.toml", "Cargo.lock", "deny.toml", "web/package-lock.json"];

/// The texts that the program prints, as JSON.
struct Documents {
    notices: Vec<u8>,
    bill: Vec<u8>,
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    // Read at run time: a build script copied with its target folder would otherwise read the packages of the old path.
    let here = env::var_os("CARGO_MANIFEST_DIR").expect("cargo gives a build script CARGO_MANIFEST_DIR");
    let root = Path::new(&here).join("../..");
    for input in INPUTS {
        println!("cargo:rerun-if-changed={}", root.join(input).display());
    }
    let made = documents(&root);
    if let Err(why) = &made {
        // A file that is missing: cargo tries again at the next build.
        println!("cargo:rerun-if-changed=notices-not-made");
        println!("cargo:warning=the notices of third-party packages were not made: {why}");
    }
    let why = made.as_ref().err().map(ToString::to_string).unwrap_or_default();
    let Documents { notices, bill } = made.unwrap_or(Documents { notices: Vec::new(), bill: Vec::new() });
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo gives a build script OUT_DIR"));
    write(&out.join("notices.json.gz"), &notices).expect("OUT_DIR can be written");
    write(&out.join("bill.json.gz"), &bill).expect("OUT_DIR can be written");
    fs::write(out.join("no-notices.txt"), why).expect("OUT_DIR can be written");
}

fn documents(root: &Path) -> Result<Documents, Error> {
    let platform = env::var("TARGET").expect("cargo gives a build script TARGET");
    let version = env::var("CARGO_PKG_VERSION").expect("cargo gives a build script CARGO_PKG_VERSION");
    let cargo = Cargo::new(root, platform.as_str());
    let tree = Tree::of_program(&cargo, "seamwright-cli")?;
    let sources = cargo.sources(&tree)?;
    for manifest in tree.manifests() {
        println!("cargo:rerun-if-changed={}", manifest.display());
    }
    let rules = Rules::read(&root.join("deny.toml"))?;
    let lock = CargoLock::read(&root.join("Cargo.lock"))?;
    let npm = NpmLock::read(&root.join("web/package-lock.json"))?;
    let toolchain = Toolchain::for_platform(platform)?;
    let notices = notices(&sources, &tree, &rules, &toolchain)?;
    let bill = bill_of_materials(&sources, &tree, &lock, &npm, &toolchain, &version)?;
    let json = |value: serde_json::Result<Vec<u8>>| value.expect("texts as keys are valid JSON");
    Ok(Documents { notices: json(serde_json::to_vec(&notices)), bill: json(serde_json::to_vec(&bill)) })
}

fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut encoder = GzEncoder::new(fs::File::create(path)?, Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish().map(drop)
}
