use super::positive;
use crate::args::post::{DialectArg, FeedArg, InterpolationArg, LevelArg, PostArgs};
use crate::planning;
use crate::refusals::{at_least, at_most, between, not_allowed, of_option, refused};
use crate::rows::{json_text, print_text};
use seamwright_document::Positive;
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_post::{Control, Dialect, Feed, Interpolation, Level, Options, Verification};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::{Loaded, load};
use seamwright_project::posting::{self, Unproven};
use std::io::{self, Write as _};

/// Maximum tolerance of a weld's path, mm.
const WIDEST_MM: f64 = 10.0;
/// Bounds of how far the tip's speed may be off inside blocks, percent: below them the words' decimals would show.
const MIN_PERCENT: f64 = 0.1;
const MAX_PERCENT: f64 = 100.0;
/// Words have six decimals.
const FINEST_MM: f64 = 0.000_02;

pub(crate) fn run(args: &PostArgs) -> Result<(), Failure> {
    let options = options(args)?;
    let mut loaded = load(&args.job)?;
    if let Some(mm) = args.retract_mm {
        loaded.welding.program.value.air.retract_mm =
            Positive::new(positive("--retract-mm", mm)?).unwrap_or(Positive::TEN);
    }
    let feed = match args.feed {
        FeedArg::InverseTime => Feed::InverseTime,
        FeedArg::PerMinute => Feed::PerMinute,
    };
    let control = Control::new(&loaded.machine, args.dialect.into()).map_err(|e| Failure::input(&e))?;
    let motion = planning::plan(&loaded, &args.planning)?;
    if let Some(mm) = args.retract_mm
        && let Some(short) = motion.findings.iter().find(|f| f.kind == "retract")
    {
        let allowed = Message::new("cli-as-far-as-axes-reach");
        return Err(refused("--retract-mm", mm, short.message.clone(), allowed));
    }
    let (text, proof) = proven(&loaded, &motion, &control, &options, feed)?;
    if let Some(path) = &args.proof {
        files::write(path, &json_text(&proof)?)?;
    }
    if args.verify {
        let mut err = io::stderr().lock();
        proof.messages().iter().try_for_each(|line| writeln!(err, "{line}"))?;
    }
    match &args.output {
        Some(path) => files::write(path, &text),
        None => print_text(&text),
    }
}

/// The part program of a planned weld, with its proof in the header; reports the differences if the proof fails.
pub(super) fn proven(
    loaded: &Loaded,
    motion: &WeldMotion,
    control: &Control,
    options: &Options,
    feed: Feed,
) -> Result<(String, Verification), Failure> {
    posting::proven(loaded, motion, control, options, feed).map_err(|e| match e {
        Unproven::Failure(failure) => failure,
        Unproven::Wrong(lines) => {
            let mut err = io::stderr().lock();
            // Errors are ignored: standard error may be closed.
            let _ = writeln!(err, "{}", Message::new("cli-post-differs"));
            lines.iter().for_each(|line| drop(writeln!(err, "  {line}")));
            Failure::Printed
        }
    })
}

fn options(args: &PostArgs) -> Result<Options, Failure> {
    let tolerance_mm = positive("--tolerance-mm", args.tolerance_mm)?;
    if tolerance_mm > WIDEST_MM {
        let allowed = at_most(WIDEST_MM, Unit::One);
        return Err(refused("--tolerance-mm", tolerance_mm, Message::new("cli-too-coarse"), allowed));
    }
    if tolerance_mm < FINEST_MM {
        let fault = Message::new("cli-finer-than-decimals");
        return Err(refused("--tolerance-mm", tolerance_mm, fault, at_least(FINEST_MM, Unit::One)));
    }
    let speed_percent = positive("--speed-percent", args.speed_percent)?;
    if !(MIN_PERCENT..=MAX_PERCENT).contains(&speed_percent) {
        return Err(not_allowed("--speed-percent", speed_percent, between(MIN_PERCENT, MAX_PERCENT)));
    }
    let interpolation = match (args.dialect, args.interpolation) {
        (DialectArg::Pmac, None | Some(InterpolationArg::Pvt)) => Interpolation::Pvt,
        (DialectArg::Pmac, Some(InterpolationArg::Spline1)) => Interpolation::Spline1,
        (DialectArg::Sinumerik, Some(InterpolationArg::Poly)) => Interpolation::Poly,
        (_, None | Some(InterpolationArg::Linear)) => Interpolation::Linear,
        (_, Some(_)) => {
            let message = of_option("--interpolation", Message::new("cli-no-such-blocks"));
            return Err(Failure::refused(message, Message::new("cli-interpolations")));
        }
    };
    Ok(Options {
        level: match args.level {
            LevelArg::Joint => Level::Joint,
            LevelArg::Tip => Level::Tip,
        },
        tolerance_mm,
        speed_percent,
        interpolation,
    })
}

impl From<DialectArg> for Dialect {
    fn from(arg: DialectArg) -> Self {
        match arg {
            DialectArg::Sinumerik => Self::Sinumerik,
            DialectArg::Linuxcnc => Self::Linuxcnc,
            DialectArg::Grblhal => Self::Grblhal,
            DialectArg::Pmac => Self::Pmac,
        }
    }
}
