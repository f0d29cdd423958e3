use super::positive;
use crate::args::{Dialect, LevelArg, PostArgs};
use crate::failure::Failure;
use crate::files;
use crate::load::load;
use crate::rows::print_text;
use seamwright_post::{Level, Options, linuxcnc};

pub(crate) fn run(args: &PostArgs) -> Result<(), Failure> {
    let options = Options {
        level: match args.level {
            LevelArg::Joint => Level::Joint,
            LevelArg::Tip => Level::Tip,
        },
        tolerance_mm: positive("--tolerance-mm", args.tolerance_mm)?,
        retract_mm: positive("--retract-mm", args.retract_mm)?,
    };
    let loaded = load(&args.job)?;
    let motion = loaded.plan()?;
    let text = match args.dialect {
        Dialect::Linuxcnc => {
            linuxcnc(&loaded.machine, &loaded.welding.program.value, &loaded.welding.path(), &motion, &options)
        }
    };
    let text = text.map_err(|e| Failure::Input(e.to_string()))?;
    match &args.output {
        Some(path) => files::write(path, &text),
        None => print_text(&text),
    }
}
