//! Machine files of arms from other descriptions.

use crate::args::arm::ArmArgs;
use crate::refusals::{not_allowed, refused};
use seamwright_machine::{ImportedArm, Machine};
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use std::io::{self, Write as _};
use std::path::Path;

/// Folder of a file.
pub(super) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Writes the machine file of `arm` as the arguments ask for it; `load` reads the STL files that it names.
pub(super) fn write_arm(
    mut arm: ImportedArm,
    args: &ArmArgs,
    load: &dyn Fn(&str) -> std::io::Result<Vec<u8>>,
) -> Result<(), Failure> {
    arm.tool = args.tool;
    arm.direction = args.direction;
    arm.work = args.work.unwrap_or(arm.work);
    if let Some(name) = &args.name {
        arm.name.clone_from(name);
        arm.title.clone_from(name);
    }
    arm.choose_home(load)?;
    if !args.home.is_empty() {
        set_home(&mut arm, &args.home)?;
    }
    let text = arm.to_toml();
    // The file that is written is read as every machine file is.
    Machine::read_with(&arm.name, &text, load)?;
    for note in &arm.notes {
        writeln!(io::stderr(), "{}", Message::new("cli-arm-note").message("note", note.clone()))?;
    }
    let mut out = io::stdout().lock();
    let Some(output) = &args.output else { return Ok(out.write_all(text.as_bytes())?) };
    files::write(output, &text)?;
    let shown = output.display().to_string();
    writeln!(out, "{}", Message::new("cli-wrote").text("files", &shown))?;
    writeln!(out, "{}", Message::new("cli-arm-next").text("file", shown))?;
    Ok(())
}

fn set_home(arm: &mut ImportedArm, home: &[f64]) -> Result<(), Failure> {
    let shown = home.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
    if home.len() != arm.axes.len() {
        let names: Vec<&str> = arm.axes.iter().map(|axis| axis.name.as_str()).collect();
        return Err(not_allowed("--home", shown, Message::verbatim(names.join(","))));
    }
    for (axis, home) in arm.axes.iter_mut().zip(home) {
        let own = if axis.is_rotary { home.to_radians() } else { *home };
        if let Some([low, high]) = axis.range.filter(|[low, high]| !(*low..=*high).contains(&own)) {
            let unit = if axis.is_rotary { Unit::Deg } else { Unit::Mm };
            let file = |v: f64| if axis.is_rotary { v.to_degrees() } else { v };
            let allowed = crate::refusals::range(file(low), file(high), unit, 3);
            let fault = Message::new("cli-arm-home").axis("axis", &axis.name);
            return Err(refused("--home", shown, fault, allowed));
        }
        axis.home = own;
    }
    Ok(())
}
