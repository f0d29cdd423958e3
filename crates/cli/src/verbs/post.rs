use super::positive;
use crate::args::post::{FeedArg, InterpolationArg, LevelArg, PostArgs, PostTargetArg};
use crate::planning;
use crate::refusals::{at_least, at_most, between, not_allowed, of_option, refused};
use crate::rows::{json_text, print_text};
use seamwright_document::Positive;
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_post::robot::{RobotArm, RobotLanguage, RobotOptions, ServoStream};
use seamwright_post::{Control, Dialect, Feed, Interpolation, Level, Options, Verification};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::Loaded;
use seamwright_project::posting::{self, PostTarget, Unproven};
use std::io::{self, Write as _};

/// Maximum tolerance of a weld's path, mm.
const WIDEST_MM: f64 = 10.0;
/// Bounds of how far the tip's speed may be off inside blocks, percent: below them the words' decimals would show.
const MIN_PERCENT: f64 = 0.1;
const MAX_PERCENT: f64 = 100.0;
/// Words have six decimals.
const FINEST_MM: f64 = 0.000_02;
/// Some robot languages have three.
const FINEST_ROBOT_MM: f64 = 0.005;

pub(crate) fn run(args: &PostArgs) -> Result<(), Failure> {
    let request = request(args)?;
    let mut loaded = planning::load(&args.job, &args.planning)?;
    if let Some(mm) = args.retract_mm {
        loaded.welding.program.value.air.retract_mm =
            Positive::new(positive("--retract-mm", mm)?).unwrap_or(Positive::TEN);
    }
    request.check(&loaded)?;
    let motion = planning::plan(&loaded, &args.planning)?;
    if let Some(mm) = args.retract_mm
        && let Some(short) = motion.findings.iter().find(|f| f.kind == "retract")
    {
        let allowed = Message::new("cli-as-far-as-axes-reach");
        return Err(refused("--retract-mm", mm, short.message.clone(), allowed));
    }
    let (text, proof) = differences(request.proven(&loaded, &motion))?;
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

/// A control with the options of its program.
enum Request {
    Machine(Dialect, Options, Feed),
    Robot(RobotLanguage, RobotOptions),
}

impl Request {
    /// Refuses a machine that the control cannot have, before it is planned.
    fn check(&self, loaded: &Loaded) -> Result<(), Failure> {
        match self {
            Self::Machine(dialect, ..) => Control::new(&loaded.machine, *dialect).map(drop),
            Self::Robot(language, _) => RobotArm::new(&loaded.machine, *language).map(drop),
        }
        .map_err(|e| Failure::input(&e))
    }

    fn proven(&self, loaded: &Loaded, motion: &WeldMotion) -> Result<(String, Verification), Unproven> {
        match self {
            Self::Machine(dialect, options, feed) => {
                let control = Control::new(&loaded.machine, *dialect).map_err(|e| Failure::input(&e))?;
                posting::proven(loaded, motion, &control, options, *feed)
            }
            Self::Robot(language, options) => posting::proven_robot(loaded, motion, *language, options),
        }
    }
}

/// Reports the differences of a program whose proof failed.
pub(super) fn differences<T>(proven: Result<T, Unproven>) -> Result<T, Failure> {
    proven.map_err(|e| match e {
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

fn request(args: &PostArgs) -> Result<Request, Failure> {
    let target = PostTarget::from(args.dialect);
    let tolerance_mm = tolerance(args.tolerance_mm.unwrap_or(target.tolerance_mm()))?;
    let stream = stream(args, target)?;
    match target {
        PostTarget::Machine(dialect) => {
            let feed = match args.feed {
                None | Some(FeedArg::InverseTime) => Feed::InverseTime,
                Some(FeedArg::PerMinute) => Feed::PerMinute,
            };
            Ok(Request::Machine(dialect, options(args, dialect, tolerance_mm)?, feed))
        }
        PostTarget::Robot(language) => {
            let given = [("--level", args.level.is_some()), ("--feed", args.feed.is_some())];
            let given = given.into_iter().chain([("--interpolation", args.interpolation.is_some())]);
            if let Some((option, _)) = given.into_iter().find(|(_, is_given)| *is_given) {
                let message = of_option(option, Message::new("cli-not-for-robots"));
                return Err(Failure::refused(message, Message::new("cli-options-of-robots")));
            }
            if tolerance_mm < FINEST_ROBOT_MM {
                let fault = Message::new("cli-finer-than-decimals");
                let allowed = at_least(FINEST_ROBOT_MM, Unit::One);
                return Err(refused("--tolerance-mm", tolerance_mm, fault, allowed));
            }
            let usual = RobotOptions::default();
            let speed_percent = speed(args.speed_percent.unwrap_or(usual.speed_percent))?;
            Ok(Request::Robot(language, RobotOptions { tolerance_mm, speed_percent, stream, ..usual }))
        }
    }
}

/// The stream of set-points that is asked for.
fn stream(args: &PostArgs, target: PostTarget) -> Result<Option<ServoStream>, Failure> {
    let given = [("--servo-ms", args.servo_ms), ("--lookahead-s", args.lookahead_s), ("--gain", args.gain)];
    let Some((option, value)) = given.into_iter().find_map(|(option, value)| Some((option, value?))) else {
        return Ok(None);
    };
    if target != PostTarget::Robot(RobotLanguage::Urscript) {
        let allowed = Message::new("cli-servo-language");
        return Err(refused(option, value, Message::new("cli-servo-not-here"), allowed));
    }
    let Some(period_ms) = args.servo_ms else {
        return Err(refused(option, value, Message::new("cli-servo-alone"), Message::new("cli-servo-with-period")));
    };
    let cycles = period_ms * 1e-3 / ServoStream::CYCLE_S;
    let max_cycles = ServoStream::MAX_PERIOD_S / ServoStream::CYCLE_S;
    if !(1.0 - 1e-9..=max_cycles + 1e-9).contains(&cycles) || (cycles - cycles.round()).abs() > 1e-9 {
        let allowed = Message::new("cli-servo-period").value("step", 1e3 * ServoStream::CYCLE_S, Unit::Ms);
        return Err(not_allowed(
            "--servo-ms",
            period_ms,
            allowed.value("max", 1e3 * ServoStream::MAX_PERIOD_S, Unit::Ms),
        ));
    }
    let within = |option, value: f64, [min, max]: [f64; 2]| match (min..=max).contains(&value) {
        true => Ok(value),
        false => Err(not_allowed(option, value, between(min, max))),
    };
    let usual = ServoStream::with_period(cycles.round() * ServoStream::CYCLE_S);
    let lookahead_s = within("--lookahead-s", args.lookahead_s.unwrap_or(usual.lookahead_s), ServoStream::LOOKAHEAD_S)?;
    let gain = within("--gain", args.gain.unwrap_or(usual.gain), ServoStream::GAIN)?;
    Ok(Some(ServoStream { lookahead_s, gain, ..usual }))
}

fn tolerance(tolerance_mm: f64) -> Result<f64, Failure> {
    let tolerance_mm = positive("--tolerance-mm", tolerance_mm)?;
    if tolerance_mm > WIDEST_MM {
        let allowed = at_most(WIDEST_MM, Unit::One);
        return Err(refused("--tolerance-mm", tolerance_mm, Message::new("cli-too-coarse"), allowed));
    }
    if tolerance_mm < FINEST_MM {
        let fault = Message::new("cli-finer-than-decimals");
        return Err(refused("--tolerance-mm", tolerance_mm, fault, at_least(FINEST_MM, Unit::One)));
    }
    Ok(tolerance_mm)
}

fn speed(percent: f64) -> Result<f64, Failure> {
    let percent = positive("--speed-percent", percent)?;
    if !(MIN_PERCENT..=MAX_PERCENT).contains(&percent) {
        return Err(not_allowed("--speed-percent", percent, between(MIN_PERCENT, MAX_PERCENT)));
    }
    Ok(percent)
}

fn options(args: &PostArgs, dialect: Dialect, tolerance_mm: f64) -> Result<Options, Failure> {
    let speed_percent = speed(args.speed_percent.unwrap_or(Options::default().speed_percent))?;
    let interpolation = match (dialect, args.interpolation) {
        (Dialect::Pmac, None | Some(InterpolationArg::Pvt)) => Interpolation::Pvt,
        (Dialect::Pmac, Some(InterpolationArg::Spline1)) => Interpolation::Spline1,
        (Dialect::Sinumerik, Some(InterpolationArg::Poly)) => Interpolation::Poly,
        (_, None | Some(InterpolationArg::Linear)) => Interpolation::Linear,
        (_, Some(_)) => {
            let message = of_option("--interpolation", Message::new("cli-no-such-blocks"));
            return Err(Failure::refused(message, Message::new("cli-interpolations")));
        }
    };
    Ok(Options {
        level: match args.level {
            None | Some(LevelArg::Joint) => Level::Joint,
            Some(LevelArg::Tip) => Level::Tip,
        },
        tolerance_mm,
        speed_percent,
        interpolation,
    })
}

impl From<PostTargetArg> for PostTarget {
    fn from(arg: PostTargetArg) -> Self {
        match arg {
            PostTargetArg::Sinumerik => Self::Machine(Dialect::Sinumerik),
            PostTargetArg::Linuxcnc => Self::Machine(Dialect::Linuxcnc),
            PostTargetArg::Grblhal => Self::Machine(Dialect::Grblhal),
            PostTargetArg::Pmac => Self::Machine(Dialect::Pmac),
            PostTargetArg::Rapid => Self::Robot(RobotLanguage::Rapid),
            PostTargetArg::Krl => Self::Robot(RobotLanguage::Krl),
            PostTargetArg::FanucLs => Self::Robot(RobotLanguage::FanucLs),
            PostTargetArg::Inform => Self::Robot(RobotLanguage::Inform),
            PostTargetArg::Urscript => Self::Robot(RobotLanguage::Urscript),
        }
    }
}
