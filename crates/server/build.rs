//! Builds the panel into `OUT_DIR/web`, and writes `OUT_DIR/panel.rs`, the table of its files that is then embedded.
//!
//! Without Node.js the panel comes from `panel.tar.gz`, if that was built from the same sources.

use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use flate2::{Compression, Crc};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Sources of the panel, relative to folder `web`; a change triggers a new build.
const SOURCES: [&str; 8] = [
    "src",
    "../messages",
    "public",
    "index.html",
    "package.json",
    "package-lock.json",
    "vite.config.ts",
    "svelte.config.js",
];

/// Ends of the names of files among them that are in no panel: tests, and the words of the command line and of reports.
const NOT_SOURCES: [&str; 6] =
    [".test.ts", ".stub.ts", "words/formatted.json", "/cli.ftl", "/report.ftl", "international.txt"];

/// The panel as it was last packed: the test `packed_panel_is_current` writes it.
const PACKED: &str = "panel.tar.gz";

/// File in it with the checksum of its sources.
const SOURCES_HASH: &str = "sources.txt";

fn main() {
    println!("cargo:rerun-if-env-changed=SEAMWRIGHT_WEB");
    println!("cargo:rerun-if-changed=build.rs");
    // Read at run time: a build script copied with its target folder would otherwise build the panel of the old path.
    let here = env::var_os("CARGO_MANIFEST_DIR").expect("cargo gives a build script CARGO_MANIFEST_DIR");
    let web = Path::new(&here).join("../../web");
    for source in SOURCES {
        println!("cargo:rerun-if-changed={}", web.join(source).display());
    }
    let sources = sources(&web).expect("the sources of the panel can be read");
    println!("cargo:rustc-env=SEAMWRIGHT_PANEL_SOURCES={sources}");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo gives a build script OUT_DIR"));
    let panel = out.join("web");
    clear(&panel).expect("OUT_DIR can be written");
    let made = match env::var("SEAMWRIGHT_WEB").as_deref() {
        Ok("skip") => Err("it was built with SEAMWRIGHT_WEB=skip".to_owned()),
        Ok("packed") => unpack(&Path::new(&here).join(PACKED), &sources, &panel),
        _ => build(&web, &panel).or_else(|why| {
            unpack(&Path::new(&here).join(PACKED), &sources, &panel).map_err(|also| format!("{why}; {also}"))
        }),
    };
    if let Err(why) = made {
        println!("cargo:warning=the panel was not built: {why}");
        clear(&panel).expect("OUT_DIR can be written");
        fs::write(panel.join("index.html"), page(&why)).expect("OUT_DIR can be written");
    }
    let mut files = Vec::new();
    list(&panel, "", &mut files).expect("OUT_DIR can be read");
    files.sort();
    let rows: String = files.iter().map(|name| row(&out, &panel, name).expect("OUT_DIR can be written")).collect();
    fs::write(out.join("panel.rs"), format!("&[\n{rows}]\n")).expect("OUT_DIR can be written");
}

/// Makes a folder empty: an earlier build may have left its panel there.
fn clear(folder: &Path) -> io::Result<()> {
    if folder.is_dir() {
        fs::remove_dir_all(folder)?;
    }
    fs::create_dir_all(folder)
}

/// Returns a checksum, the same with every version of Rust.
fn checksum(crc: &Crc) -> String {
    format!("{:08x}-{:x}", crc.sum(), crc.amount())
}

/// Returns a checksum of all files that the panel is built from.
fn sources(web: &Path) -> io::Result<String> {
    let mut crc = Crc::new();
    for source in SOURCES {
        let path = web.join(source);
        let mut files = Vec::new();
        if path.is_dir() {
            list(&path, "", &mut files)?;
            files.retain(|name| !NOT_SOURCES.iter().any(|end| name.ends_with(end)));
            files.sort();
        } else if path.is_file() {
            files.push(String::new());
        }
        for name in files {
            let file = if name.is_empty() { path.clone() } else { path.join(&name) };
            crc.update(format!("{source}/{name}\n").as_bytes());
            crc.update(&fs::read(file)?);
        }
    }
    Ok(checksum(&crc))
}

/// Unpacks the panel that is kept beside this file, if it was built from these sources.
fn unpack(packed: &Path, sources: &str, out: &Path) -> Result<(), String> {
    println!("cargo:rerun-if-changed={}", packed.display());
    let file = fs::File::open(packed).map_err(|_| "there is no packed panel".to_owned())?;
    tar::Archive::new(GzDecoder::new(file)).unpack(out).map_err(|e| format!("the packed panel cannot be read: {e}"))?;
    let of = fs::read_to_string(out.join(SOURCES_HASH)).unwrap_or_default();
    if of == sources { Ok(()) } else { Err("the packed panel is of other sources".to_owned()) }
}

/// Adds the names of all files in a folder, relative to the panel's.
fn list(folder: &Path, before: &str, files: &mut Vec<String>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            list(&entry.path(), &format!("{name}/"), files)?;
        } else {
            files.push(name);
        }
    }
    Ok(())
}

/// Compresses a file, and returns its row in the table of files.
fn row(out: &Path, panel: &Path, name: &str) -> io::Result<String> {
    let plain = panel.join(name);
    let bytes = fs::read(&plain)?;
    let mut crc = Crc::new();
    crc.update(&bytes);
    let zipped = out.join(format!("{}.gz", name.replace('/', "-")));
    let mut encoder = GzEncoder::new(fs::File::create(&zipped)?, Compression::best());
    encoder.write_all(&bytes)?;
    encoder.finish()?;
    Ok(format!(
        "    File {{ name: {name:?}, hash: \"{}\", plain: include_bytes!({plain:?}), zipped: include_bytes!({zipped:?}) }},\n",
        checksum(&crc)
    ))
}

fn build(web: &Path, out: &Path) -> Result<(), String> {
    if !web.join("package.json").is_file() {
        return Err("its sources are missing (folder web)".to_owned());
    }
    let version = run(Command::new("node").arg("--version")).map_err(|_| "Node.js 20.19 or newer is missing")?;
    let numbers: Vec<u32> = version.trim().trim_start_matches('v').split('.').filter_map(|n| n.parse().ok()).collect();
    if numbers.as_slice() < &[20, 19] {
        return Err(format!("Node.js {} is too old: 20.19 or newer is needed", version.trim()));
    }
    // Two cargo runs must not install at the same time.
    let lock = fs::File::open(web.join("package-lock.json")).map_err(|e| e.to_string())?;
    lock.lock().map_err(|e| e.to_string())?;
    let time = |path: PathBuf| fs::metadata(path).and_then(|m| m.modified()).ok();
    let installed = time(web.join("node_modules/.package-lock.json"));
    if installed.is_none() || installed < time(web.join("package-lock.json")) {
        run(Command::new("npm")
            .args(["ci", "--no-audit", "--no-fund", "--ignore-scripts", "--fetch-retries=1", "--fetch-timeout=60000"])
            .current_dir(web))?;
    }
    let vite = web.join("node_modules/.bin/vite");
    run(Command::new(vite).args(["build", "--emptyOutDir", "--outDir"]).arg(out).current_dir(web)).map(drop)
}

fn run(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|e| format!("{}: {e}", command.get_program().display()))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let said = [output.stdout, output.stderr].concat();
    Err(format!("{} failed:\n{}", command.get_program().display(), String::from_utf8_lossy(&said)))
}

/// Returns the page that is embedded if the panel was not built.
fn page(why: &str) -> String {
    let why = why.replace('&', "&amp;").replace('<', "&lt;");
    format!(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Seamwright</title><h1>Seamwright</h1>\
         <p>The cell runs, but this program was built without its panel.</p><pre>{why}</pre>\
         <p>Install Node.js 20.19 or newer and build again.</p></html>"
    )
}
