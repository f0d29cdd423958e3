//! From files to a planned weld.

use crate::failure::Failure;
use crate::files;
use seamwright_machine::{Machine, SHIPPED, shipped};
use seamwright_motion::PassMotion;
use seamwright_program::Finding;
use seamwright_weld::Welding;
use std::path::Path;

/// A job or program with its machine.
pub(crate) struct Loaded {
    pub(crate) welding: Welding,
    pub(crate) machine: Machine,
}

/// Reads a job or program file and its machine.
pub(crate) fn load(path: &Path) -> Result<Loaded, Failure> {
    load_text(&path.display().to_string(), &files::read(path)?, path.parent().unwrap_or(Path::new(".")))
}

/// The same from text; machine files are looked for from `folder`.
pub(crate) fn load_text(name: &str, text: &str, folder: &Path) -> Result<Loaded, Failure> {
    let welding = Welding::read(name, text)?;
    let wanted = &welding.program.value.machine;
    let machine = match machine_from(wanted, folder)? {
        Some(machine) => machine,
        None => {
            let allowed = format!("{}, or the path of a machine file", names());
            return Err(welding.program.error_at("machine", "there is no such machine", allowed).into());
        }
    };
    Ok(Loaded { welding, machine })
}

fn names() -> String {
    SHIPPED.iter().map(|s| s.name).collect::<Vec<_>>().join(", ")
}

/// The machine called `name`, or in the file `name` from `folder`; none if there is neither.
fn machine_from(name: &str, folder: &Path) -> Result<Option<Machine>, Failure> {
    if let Some(shipped) = shipped(name) {
        return Ok(Some(Machine::read(shipped.name, shipped.text)?));
    }
    let path = folder.join(name);
    if !path.is_file() {
        return Ok(None);
    }
    Ok(Some(Machine::read(&path.display().to_string(), &files::read(&path)?)?))
}

/// The machine that a command line names.
pub(crate) fn machine(name: &str) -> Result<Machine, Failure> {
    machine_from(name, Path::new("."))?.ok_or_else(|| {
        Failure::Input(format!(
            "{name}: there is no such machine\n   allowed: {}, or the path of a machine file",
            names()
        ))
    })
}

impl Loaded {
    /// Plans the weld.
    pub(crate) fn plan(&self) -> Result<PassMotion, Failure> {
        self.try_plan().map_err(Failure::Findings)
    }

    /// Plans the weld, or says what stands against it.
    pub(crate) fn try_plan(&self) -> Result<PassMotion, Vec<Finding>> {
        let mut findings = self.welding.findings();
        let planned = PassMotion::plan(&self.machine, &self.welding.path(), &self.welding.program.value.passes[0], 1);
        match planned {
            Ok(motion) if findings.iter().all(|f| f.allowed) => Ok(motion),
            Ok(motion) => {
                findings.extend(motion.findings);
                Err(findings)
            }
            Err(more) => {
                findings.extend(more);
                Err(findings)
            }
        }
    }
}
