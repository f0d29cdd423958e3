//! Builds the panel into `OUT_DIR/web`, which is then embedded.

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

fn main() {
    println!("cargo:rerun-if-env-changed=SEAMWRIGHT_WEB");
    println!("cargo:rerun-if-changed=build.rs");
    // Read at run time: a build script copied with its target folder would otherwise build the panel of the old path.
    let here = env::var_os("CARGO_MANIFEST_DIR").expect("cargo gives a build script CARGO_MANIFEST_DIR");
    let web = Path::new(&here).join("../../web");
    for source in SOURCES {
        println!("cargo:rerun-if-changed={}", web.join(source).display());
    }
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo gives a build script OUT_DIR")).join("web");
    fs::create_dir_all(&out).expect("OUT_DIR can be written");
    let skipped = env::var("SEAMWRIGHT_WEB").is_ok_and(|v| v == "skip");
    let made = if skipped { Err("it was built with SEAMWRIGHT_WEB=skip".to_owned()) } else { build(&web, &out) };
    if let Err(why) = made {
        if !skipped {
            println!("cargo:warning=the panel was not built: {why}");
        }
        fs::write(out.join("index.html"), page(&why)).expect("OUT_DIR can be written");
    }
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
    let lock = fs::File::create(env::temp_dir().join("seamwright-npm.lock")).map_err(|e| e.to_string())?;
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
