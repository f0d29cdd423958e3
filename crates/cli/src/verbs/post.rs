use super::positive;
use crate::args::{DialectArg, FeedArg, InterpolationArg, LevelArg, PostArgs};
use crate::failure::Failure;
use crate::files;
use crate::load::load;
use crate::rows::print_text;
use seamwright_document::Positive;
use seamwright_post::{
    Control, Dialect, Error, Feed, Interpolation, Level, Options, WriteOptions, part_program, write,
};
use seamwright_program::TorchPath;

/// A weld that may stray further is none.
const WIDEST_MM: f64 = 10.0;

pub(crate) fn run(args: &PostArgs) -> Result<(), Failure> {
    let options = options(args)?;
    let mut loaded = load(&args.job)?;
    if let Some(mm) = args.retract_mm {
        loaded.welding.program.value.air.retract_mm =
            Positive::new(positive("--retract-mm", mm)?).unwrap_or(Positive::TEN);
    }
    let control = Control::new(&loaded.machine, dialect(args.dialect)).map_err(|e| Failure::Input(e.to_string()))?;
    let motion = loaded.plan()?;
    let paths = loaded.paths();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    let program = &loaded.welding.program.value;
    let part = part_program(&loaded.machine, &control, program, &paths, &motion, &options);
    let write_options = WriteOptions {
        machine: loaded.machine.title.clone(),
        feed: match args.feed {
            FeedArg::InverseTime => Feed::InverseTime,
            FeedArg::PerMinute => Feed::PerMinute,
        },
        rounding_mm: options.rounding_mm(),
    };
    let text = part.and_then(|part| write(&control, &part, &write_options)).map_err(|e| match &e {
        Error::TooFine { .. } => Failure::Input(format!("--tolerance-mm {}: {e}", args.tolerance_mm)),
        _ => Failure::Input(e.to_string()),
    })?;
    match &args.output {
        Some(path) => files::write(path, &text),
        None => print_text(&text),
    }
}

fn options(args: &PostArgs) -> Result<Options, Failure> {
    let tolerance_mm = positive("--tolerance-mm", args.tolerance_mm)?;
    if tolerance_mm > WIDEST_MM {
        let message = format!("--tolerance-mm {tolerance_mm}: too coarse\n   allowed: up to {WIDEST_MM}");
        return Err(Failure::Input(message));
    }
    if args.interpolation.is_some() && args.dialect != DialectArg::Pmac {
        let message = "--interpolation: only PMAC has a choice; the other controls get lines and arcs";
        return Err(Failure::Input(message.to_owned()));
    }
    Ok(Options {
        level: match args.level {
            LevelArg::Joint => Level::Joint,
            LevelArg::Tip => Level::Tip,
        },
        tolerance_mm,
        interpolation: match args.interpolation {
            None | Some(InterpolationArg::Pvt) => Interpolation::Pvt,
            Some(InterpolationArg::Spline1) => Interpolation::Spline1,
            Some(InterpolationArg::Linear) => Interpolation::Linear,
        },
    })
}

fn dialect(arg: DialectArg) -> Dialect {
    match arg {
        DialectArg::Sinumerik => Dialect::Sinumerik,
        DialectArg::Linuxcnc => Dialect::Linuxcnc,
        DialectArg::Grblhal => Dialect::Grblhal,
        DialectArg::Pmac => Dialect::Pmac,
    }
}
