//! Checks the third-party packages of this repository by the rules of `deny.toml`, and prints the notices of one program.
//!
//! Exit codes: 0 no violation; 1 violations; 2 wrong usage, or an unreadable file.

use seamwright_supply_chain::{Cargo, CargoLock, Error, NpmLock, Rules, Toolchain, Tree, Violation, notices};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "usage: seamwright-supply-chain [--tree FILE] [--cargo-lock FILE] [--npm-lock FILE] [--rules FILE]
       seamwright-supply-chain --notices PACKAGE

Checks third-party packages by the rules of deny.toml. Without options: those of the repository in this folder.

  --tree FILE        packages, as printed by
                     cargo tree --workspace --prefix depth --format $'\\t{p}\\t{l}\\t{r}'
  --cargo-lock FILE  instead of Cargo.lock
  --npm-lock FILE    instead of web/package-lock.json and web/e2e/package-lock.json
  --rules FILE       instead of deny.toml
  --notices PACKAGE  prints what the licences require to go with the library or program of this package

Exit codes: 0 no violation; 1 violations; 2 wrong usage, or an unreadable file.
";

/// Files to read instead of those of the repository.
#[derive(Default)]
struct Options {
    tree: Option<PathBuf>,
    cargo_lock: Option<PathBuf>,
    npm_lock: Option<PathBuf>,
    rules: Option<PathBuf>,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help" || argument == "-h") {
        print!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    if let [option, package] = &arguments[..]
        && option == "--notices"
    {
        return match notices_of(package) {
            Ok(text) => {
                print!("{text}");
                ExitCode::SUCCESS
            }
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::from(2)
            }
        };
    }
    let Some(options) = options(&arguments) else {
        eprint!("{USAGE}");
        return ExitCode::from(2);
    };
    match check(&options) {
        Ok(found) if found.is_empty() => ExitCode::SUCCESS,
        Ok(found) => {
            for violation in &found {
                eprintln!("{violation}");
            }
            eprintln!("error: {} violations of the rules for third-party packages (deny.toml)", found.len());
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Notices of a package of this workspace: its third-party packages, then the texts of their licences.
fn notices_of(package: &str) -> Result<String, Error> {
    let folder = Path::new(".");
    let cargo = Cargo::on_this_platform(folder)?;
    let tree = Tree::of_program(&cargo, package)?;
    let (sources, rules) = (cargo.sources(&tree)?, Rules::read(Path::new("deny.toml"))?);
    let notices = notices(&sources, &tree, &rules, &Toolchain::for_platform(cargo.platform())?)?;
    let mut text = String::from("Software of others in this package, or that it was built with.\n\n");
    for noticed in &notices.packages {
        text += &format!("{} {}  {}  {}\n", noticed.name, noticed.version, noticed.licence, noticed.source);
    }
    let rule = "=".repeat(100);
    for notice in &notices.texts {
        text += &format!("\n{rule}\n{}\n{rule}\n{}\n", notice.packages.join(", "), notice.text.trim_end());
    }
    Ok(text)
}

/// Parses the options; none if they are wrong.
fn options(arguments: &[String]) -> Option<Options> {
    let mut options = Options::default();
    for pair in arguments.chunks(2) {
        let [name, file] = pair else { return None };
        let option = match name.as_str() {
            "--tree" => &mut options.tree,
            "--cargo-lock" => &mut options.cargo_lock,
            "--npm-lock" => &mut options.npm_lock,
            "--rules" => &mut options.rules,
            _ => return None,
        };
        if option.replace(PathBuf::from(file)).is_some() {
            return None;
        }
    }
    Some(options)
}

fn check(options: &Options) -> Result<Vec<Violation>, Error> {
    let folder = Path::new(".");
    let rules = Rules::read(options.rules.as_deref().unwrap_or(Path::new("deny.toml")))?;
    let lock = CargoLock::read(options.cargo_lock.as_deref().unwrap_or(Path::new("Cargo.lock")))?;
    let npm = match &options.npm_lock {
        Some(file) => vec![NpmLock::read(file)?],
        None => ["web/package-lock.json", "web/e2e/package-lock.json"]
            .map(|file| NpmLock::read(Path::new(file)))
            .into_iter()
            .collect::<Result<_, _>>()?,
    };
    let (all, built) = match &options.tree {
        Some(file) => {
            let tree = Tree::read(file)?;
            (tree.clone(), tree)
        }
        None => {
            let cargo = Cargo::on_this_platform(folder)?;
            (Tree::of_workspace(&cargo, "normal,build,dev")?, Tree::of_workspace(&cargo, "normal,build")?)
        }
    };
    Ok(rules.violations(&all, &built, &lock, &npm))
}
