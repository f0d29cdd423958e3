//! A seam taught by camera, from simulated, recorded or sent frames, or by the operator's points.

mod operator;
mod plot;
mod recorded;
mod report;
mod sent;
mod session;
mod simulated;

use super::positive;
use crate::args::teach::{TeachArgs, TeachMethod};
use crate::csv::CsvReader;
use crate::failure::Failure;
use crate::files;
use crate::load::load;
use crate::refusals::{between, in_file, not_allowed, of_option, refused, unreadable};
use glam::DVec3;
use seamwright_geometry::HeightTable;
use seamwright_geometry::reduce::Method;
use seamwright_machine::{Machine, Sensor};
use seamwright_message::Message;
use seamwright_teaching::{
    self as teaching, CameraPose, EVERY_MM, JointFollower, Kind, Outcome, ReductionTolerances, SeamLine, Settings,
    nominal, semi_manual,
};
use std::fs::File;
use std::io::BufReader;
use std::ops::RangeInclusive;
use std::path::Path;

/// Minimum and maximum step from frame to frame, mm: longer ones leave the frame.
const STEPS_MM: RangeInclusive<f64> = 1.0..=100.0;
/// Endings of the files beside the program.
const BESIDE: [&str; 3] = ["report.json", "svg", "png"];

pub(crate) fn run(args: &TeachArgs) -> Result<(), Failure> {
    let tolerance = positive("--tolerance-mm", args.tolerance_mm)?;
    let attitude = within("--attitude-deg", args.attitude_deg, 1e-6..=90.0)?.to_radians();
    let source = Source::read(args)?;
    check_output(&args.output)?;
    let loaded = load(&args.job)?;
    let nominal = nominal(&loaded.welding.program.value, loaded.seam()?);
    let (mut outcome, truth) = match source {
        Source::Points(points) => (by_points(points, &nominal)?, None),
        Source::Simulated => {
            let (outcome, truth) = simulated::teach(args, &loaded, &nominal)?;
            (outcome, Some(truth))
        }
        Source::Folder(folder) => (recorded::teach(args, folder, &loaded, &nominal)?, None),
        Source::Sender(address) => (sent::teach(args, address, &loaded, &nominal)?, None),
    };
    if outcome.smooth.len() < 2 {
        let why = outcome.finding.take().unwrap_or_else(|| Message::new("project-teach-no-joint"));
        return Err(Failure::Findings(vec![teaching::finding(why, 0.0)]));
    }
    let kind = match args.method {
        TeachMethod::Greedy => Kind::Arcs(Method::Greedy),
        TeachMethod::Fewest => Kind::Arcs(Method::Fewest),
        TeachMethod::Spline => Kind::Spline,
    };
    let output = args.output.display().to_string();
    let tolerances = ReductionTolerances { path_mm: tolerance, attitude_rad: attitude };
    let (reduced, written) = teaching::reduced(&loaded.welding, &nominal, &outcome.smooth, tolerances, kind, &output)?;
    let report = report::Report::new(args, &loaded.machine, &nominal, &outcome, &reduced, truth);
    let [json, svg, png] = BESIDE.map(|ending| args.output.with_extension(ending));
    files::write(&args.output, &written)?;
    files::write(&json, &report.to_json()?)?;
    files::write(&svg, &plot::draw(&report))?;
    if let Some(picture) = &outcome.picture {
        let drawn = picture.png().map_err(Failure::Environment)?;
        files::write_with(&png, |out| Ok(out.write_all(&drawn)?))?;
    }
    report.print(args.json)?;
    match outcome.finding {
        Some(why) => Err(Failure::Findings(vec![teaching::finding(why, outcome.line.length())])),
        None => Ok(()),
    }
}

/// Source of the line.
enum Source<'a> {
    /// Points jogged to by hand.
    Points(&'a Path),
    Simulated,
    /// Recorded frames.
    Folder(&'a Path),
    /// The address of a sender of frames.
    Sender(&'a str),
}

impl<'a> Source<'a> {
    /// Options of the command line; refuses those that another source has.
    fn read(args: &'a TeachArgs) -> Result<Self, Failure> {
        let source = match (&args.semi_manual, args.frames.as_deref()) {
            (Some(points), _) => Self::Points(points),
            (None, Some("simulated")) => Self::Simulated,
            (None, Some(frames)) => match frames.split_once("://") {
                Some(("tcp", address)) => Self::Sender(sent::address(frames, address)?),
                Some(_) => {
                    return Err(not_allowed("--frames", frames, Message::new("cli-teach-frames")));
                }
                None => Self::Folder(Path::new(frames)),
            },
            // The command line asks for one of them.
            (None, None) => return Err(Failure::input(Message::new("cli-teach-source"))),
        };
        let simulated = [
            ("--seed", args.seed.is_some()),
            ("--distortion", args.distortion.is_some()),
            ("--tack", !args.tack.is_empty()),
            ("--no-height", args.no_height),
        ];
        let elsewhere = |given: &[(&str, bool)], source: Message| match given.iter().find(|(_, given)| *given) {
            Some((name, _)) => {
                let allowed = Message::new("cli-teach-only-with").message("source", source);
                Err(Failure::refused(of_option(name, Message::new("cli-teach-not-here")), allowed))
            }
            None => Ok(()),
        };
        if !matches!(source, Self::Simulated) {
            elsewhere(&simulated, Message::verbatim("--frames simulated"))?;
        }
        if !matches!(source, Self::Sender(_)) {
            elsewhere(&[("--drive", args.drive)], Message::verbatim("--frames tcp://HOST:PORT"))?;
        }
        if matches!(source, Self::Folder(_)) {
            elsewhere(&[("--record", args.record.is_some())], Message::new("cli-teach-new-frames"))?;
        }
        Ok(source)
    }
}

/// Refuses a program file that one of those beside it would overwrite.
fn check_output(output: &Path) -> Result<(), Failure> {
    if BESIDE.iter().all(|ending| output.with_extension(ending) != *output) {
        return Ok(());
    }
    let allowed = Message::new("cli-teach-file");
    Err(refused("-o", output.display(), Message::new("cli-teach-beside"), allowed))
}

/// Returns the option's value if it is in the allowed range.
fn within(name: &str, value: f64, allowed: RangeInclusive<f64>) -> Result<f64, Failure> {
    if allowed.contains(&value) {
        return Ok(value);
    }
    Err(not_allowed(name, value, between(*allowed.start(), *allowed.end())))
}

/// The camera that is asked for, with its map.
fn camera<'a>(args: &TeachArgs, machine: &'a Machine) -> Result<(&'a Sensor, &'a HeightTable), Failure> {
    let cameras: Vec<_> = machine.cameras().collect();
    let names = || cameras.iter().map(|(s, _)| s.name.as_str()).collect::<Vec<_>>().join(", ");
    let refuse = |message: Message| {
        let allowed =
            if cameras.is_empty() { Message::new("cli-teach-camera-machine") } else { Message::verbatim(names()) };
        Err(Failure::refused(message, allowed))
    };
    let fault = |code| Message::new(code).text("machine", &machine.name);
    match (&args.sensor, cameras.as_slice()) {
        (Some(name), _) => match cameras.iter().find(|(s, _)| &s.name == name) {
            Some(found) => Ok(*found),
            None => refuse(of_option(format!("--sensor {name}"), fault("cli-teach-no-such-camera"))),
        },
        (None, [one]) => Ok(*one),
        (None, []) => refuse(fault("cli-teach-no-camera")),
        (None, _) => refuse(fault("cli-teach-several-cameras")),
    }
}

/// Settings of the joint following along this seam.
fn settings(args: &TeachArgs, nominal: &SeamLine) -> Result<Settings, Failure> {
    Ok(teaching::settings(nominal, within("--step-mm", args.step_mm, STEPS_MM)?))
}

fn follower(args: &TeachArgs, table: &HeightTable) -> Result<JointFollower, Failure> {
    Ok(teaching::follower(table, positive("--longest-tack-mm", args.longest_tack_mm)?)?)
}

/// Start of the joint following: at `point`, in the direction of the nominal seam nearby unless the command line gives
/// another.
fn start(args: &TeachArgs, nominal: &SeamLine, point: DVec3) -> Result<CameraPose, Failure> {
    let vector = |name: &str, given: &Option<Vec<f64>>| match given.as_deref() {
        None => Ok(None),
        Some([x, y, z]) => Ok(Some(DVec3::new(*x, *y, *z))),
        Some(other) => {
            let fault = Message::new("cli-teach-numbers").count("n", other.len());
            Err(Failure::refused(of_option(name, fault), Message::new("cli-teach-three-numbers")))
        }
    };
    let point = vector("--start", &args.start)?.unwrap_or(point);
    let far = || {
        let start = format!("({:.3}, {:.3}, {:.3})", point.x, point.y, point.z);
        let message = Message::new("cli-teach-start-off-seam").text("start", start);
        Failure::refused(message, Message::new("cli-teach-start-near"))
    };
    let begin = teaching::start(nominal, point).ok_or_else(far)?;
    let along = match vector("--direction", &args.direction)? {
        Some(way) => way.try_normalize().ok_or_else(|| {
            let message = of_option("--direction", Message::new("cli-direction-without-length"));
            Failure::refused(message, Message::new("cli-three-finite-numbers"))
        })?,
        None => begin.along,
    };
    Ok(CameraPose { along, ..begin })
}

/// The nominal seam brought to the operator's points.
fn by_points(path: &Path, nominal: &SeamLine) -> Result<Outcome, Failure> {
    let source = path.display().to_string();
    let file = File::open(path).map_err(|e| unreadable(&source, &e))?;
    let (mut reader, _) = CsvReader::open(&source, BufReader::new(file), &[&["x_mm", "y_mm", "z_mm"]])?;
    let mut points = Vec::new();
    while let Some(row) = reader.row() {
        let row = row?;
        points.push(DVec3::new(row[0], row[1], row[2]));
    }
    let smooth =
        semi_manual(nominal, &points, EVERY_MM).map_err(|e| Failure::input(in_file(&source, Message::outside(&e))))?;
    Ok(Outcome { smooth, ended: "points", ..Outcome::default() })
}
