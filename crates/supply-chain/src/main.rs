//! Checks the third-party packages of this repository by the rules of `deny.toml`.
//!
//! Exit codes: 0 no violation; 1 violations; 2 wrong usage, or an unreadable file.

use seamwright_supply_chain::{Cargo, CargoLock, Error, NpmLock, Rules, Tree, Violation};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "usage: seamwright-supply-chain [--tree FILE] [--cargo-lock FILE] [--npm-lock FILE] [--rules FILE]

Checks third-party packages by the rules of deny.toml. Without options: those of the repository in this folder.

  --tree FILE        packages, as printed by
                     cargo tree --workspace --prefix depth --format $'\\t{p}\\t{l}\\t{r}'
  --cargo-lock FILE  instead of Cargo.lock
  --npm-lock FILE    instead of web/package-lock.json and web/e2e/package-lock.json
  --rules FILE       instead of deny.toml

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
