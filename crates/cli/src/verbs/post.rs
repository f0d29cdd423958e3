use super::positive;
use crate::args::{Dialect, LevelArg, PostArgs};
use crate::failure::Failure;
use crate::files;
use crate::load::load;
use crate::rows::print_text;
use seamwright_document::Positive;
use seamwright_post::{Error, Level, Options, linuxcnc};
use seamwright_program::TorchPath;

/// A weld that may stray further is none.
const WIDEST_MM: f64 = 10.0;

pub(crate) fn run(args: &PostArgs) -> Result<(), Failure> {
    let options = Options {
        level: match args.level {
            LevelArg::Joint => Level::Joint,
            LevelArg::Tip => Level::Tip,
        },
        tolerance_mm: positive("--tolerance-mm", args.tolerance_mm)?,
    };
    if options.tolerance_mm > WIDEST_MM {
        let message = format!("--tolerance-mm {}: too coarse\n   allowed: up to {WIDEST_MM}", options.tolerance_mm);
        return Err(Failure::Input(message));
    }
    let mut loaded = load(&args.job)?;
    if let Some(mm) = args.retract_mm {
        loaded.welding.program.value.air.retract_mm =
            Positive::new(positive("--retract-mm", mm)?).unwrap_or(Positive::TEN);
    }
    let motion = loaded.plan()?;
    let paths = loaded.paths();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    let text = match args.dialect {
        Dialect::Linuxcnc => linuxcnc(&loaded.machine, &loaded.welding.program.value, &paths, &motion, &options),
    };
    let text = text.map_err(|e| match &e {
        Error::TooFine { .. } => Failure::Input(format!("--tolerance-mm {}: {e}", args.tolerance_mm)),
        _ => Failure::Input(e.to_string()),
    })?;
    match &args.output {
        Some(path) => files::write(path, &text),
        None => print_text(&text),
    }
}
