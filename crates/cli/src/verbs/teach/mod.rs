//! A seam taught by eye, from simulated, recorded or sent frames, or by the operator's points.

mod operator;
mod outcome;
mod picture;
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
use crate::load::{Loaded, load};
use glam::DVec3;
use outcome::Outcome;
use seamwright_cell::eyes::{SeamLine, Station};
use seamwright_cell::teach::{JointFollower, semi_manual};
use seamwright_geometry::HeightTable;
use seamwright_geometry::reduce::Method;
use seamwright_machine::{Machine, Sensor, Sight};
use seamwright_program::Program;
use seamwright_tracking::teach::{
    End, EyePose, Kind, Lean, LinePoint, Settings, TaughtLine, smoothed, to_program, torch_axes,
};
use seamwright_weld::Attitude;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Distance of the points of the smoothed line, mm, and how far to both sides it looks.
const EVERY_MM: f64 = 0.5;
const WINDOW_MM: f64 = 2.5;
/// A joint that ends further before the end of the nominal seam does not end: it is hidden.
const EARLY_MM: f64 = 15.0;

/// Shortest and longest step from frame to frame, mm: shorter ones are none, longer ones leave the frame.
const STEPS_MM: (f64, f64) = (1.0, 100.0);
/// Endings of the files beside the program.
const BESIDE: [&str; 3] = ["report.json", "svg", "png"];

pub(crate) fn run(args: &TeachArgs) -> Result<(), Failure> {
    let tolerance = positive("--tolerance-mm", args.tolerance_mm)?;
    let attitude = within("--attitude-deg", args.attitude_deg, (1e-6, 90.0))?.to_radians();
    let source = Source::read(args)?;
    check_output(&args.output)?;
    let loaded = load(&args.job)?;
    let nominal = nominal(&loaded)?;
    let mut outcome = match source {
        Source::Points(points) => by_points(points, &nominal)?,
        Source::Simulated => simulated::teach(args, &loaded, &nominal)?,
        Source::Folder(folder) => recorded::teach(args, folder, &loaded, &nominal)?,
        Source::Sender(address) => sent::teach(args, address, &loaded, &nominal)?,
    };
    if outcome.smooth.len() < 2 {
        let why = outcome.finding.take().unwrap_or_else(|| "no joint was found".to_owned());
        return Err(Failure::Findings(vec![outcome::finding(why, 0.0)]));
    }
    let kind = match args.method {
        TeachMethod::Greedy => Kind::Arcs(Method::Greedy),
        TeachMethod::Fewest => Kind::Arcs(Method::Fewest),
        TeachMethod::Spline => Kind::Spline,
    };
    let torch = torch(&loaded, &nominal, &outcome.smooth)?;
    let like = &loaded.welding.program.value;
    let reduced = to_program((&outcome.smooth, &torch), like, (tolerance, attitude), kind)
        .map_err(|e| Failure::Input(format!("what was found makes no program: {e}")))?;
    let written = reduced.program.to_toml().map_err(|e| Failure::Environment(e.to_string()))?;
    // What is written is read by all other verbs: a program that they refuse is none.
    Program::read(&args.output.display().to_string(), &written)?;
    let report = report::Report::new(args, &loaded.machine, &nominal, &outcome, &reduced);
    let [json, svg, png] = BESIDE.map(|ending| args.output.with_extension(ending));
    files::write(&args.output, &written)?;
    files::write(&json, &report.to_json()?)?;
    files::write(&svg, &plot::draw(&report))?;
    if let Some(picture) = &outcome.picture {
        let drawn = picture.png()?;
        files::write_with(&png, |out| Ok(out.write_all(&drawn)?))?;
    }
    report.print(args.json)?;
    match outcome.finding {
        Some(why) => Err(Failure::Findings(vec![outcome::finding(why, outcome.line.length())])),
        None => Ok(()),
    }
}

/// Where the line comes from.
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
    /// What the command line asks for; refuses options that another source has.
    fn read(args: &'a TeachArgs) -> Result<Self, Failure> {
        let source = match (&args.semi_manual, args.frames.as_deref()) {
            (Some(points), _) => Self::Points(points),
            (None, Some("simulated")) => Self::Simulated,
            (None, Some(frames)) => match frames.split_once("://") {
                Some(("tcp", address)) => Self::Sender(sent::address(frames, address)?),
                Some(_) => {
                    let allowed = "a folder, tcp://HOST:PORT, simulated";
                    return Err(Failure::Input(format!("--frames {frames}: not allowed\n   allowed: {allowed}")));
                }
                None => Self::Folder(Path::new(frames)),
            },
            // The command line asks for one of them.
            (None, None) => return Err(Failure::Input("either --frames or --semi-manual".to_owned())),
        };
        let simulated = [
            ("--seed", args.seed.is_some()),
            ("--distortion", args.distortion.is_some()),
            ("--tack", !args.tack.is_empty()),
            ("--no-height", args.no_height),
        ];
        let elsewhere = |given: &[(&str, bool)], only: &str| match given.iter().find(|(_, given)| *given) {
            Some((name, _)) => Err(Failure::Input(format!("{name}: not allowed here\n   allowed: only with {only}"))),
            None => Ok(()),
        };
        if !matches!(source, Self::Simulated) {
            elsewhere(&simulated, "--frames simulated")?;
        }
        if !matches!(source, Self::Sender(_)) {
            elsewhere(&[("--drive", args.drive)], "--frames tcp://HOST:PORT")?;
        }
        if matches!(source, Self::Folder(_)) {
            elsewhere(&[("--record", args.record.is_some())], "frames that are not in a folder already")?;
        }
        Ok(source)
    }
}

/// Refuses a program file that one of those beside it would overwrite.
fn check_output(output: &Path) -> Result<(), Failure> {
    if BESIDE.iter().all(|ending| output.with_extension(ending) != *output) {
        return Ok(());
    }
    let output = output.display();
    Err(Failure::Input(format!(
        "-o {output}: is the name of a file beside the program\n   allowed: a file, as taught.toml"
    )))
}

/// A number within two others.
fn within(name: &str, value: f64, (least, most): (f64, f64)) -> Result<f64, Failure> {
    if (least..=most).contains(&value) {
        return Ok(value);
    }
    Err(Failure::Input(format!("{name} {value}: not allowed\n   allowed: {least} to {most}")))
}

/// Unit vectors from the joint to the torch at each point of the line: as it was found, with the angles that the job's
/// first pass has at the place beside it.
fn torch(loaded: &Loaded, nominal: &SeamLine, line: &[LinePoint]) -> Result<Vec<DVec3>, Failure> {
    let (program, seam) = (&loaded.welding.program, loaded.seam()?);
    let Some(pass) = program.value.passes.first() else { return Ok(line.iter().map(|p| p.normal).collect()) };
    let attitude = Attitude::new(program, "passes[0].torch", &pass.torch, seam)?;
    let lean = |p: &LinePoint| {
        // Beyond its ends and far away from it: as at the nearest end of the weld.
        let s = nominal.foot(p.point).map_or(p.way.clamp(0.0, nominal.length()), |foot| foot.way);
        let (at, (work, travel)) = (seam.at(s), attitude.angles(s));
        let first_is_left = at.bisector.cross(at.along).dot(at.towards_first) > 0.0;
        Lean { work, travel, first_is_left }
    };
    Ok(torch_axes(line, &lean))
}

/// The nominal seam in the machine's work frame.
fn nominal(loaded: &Loaded) -> Result<SeamLine, Failure> {
    let seam = loaded.seam()?;
    let place = loaded.welding.program.value.seam_in_work();
    let length = if seam.all_round() { seam.length() } else { seam.weld_length() };
    Ok(SeamLine::sampled(length, seam.all_round(), |s| {
        let p = seam.at(s);
        Station { point: place.transform_point3(p.point), normal: place.transform_vector3(p.bisector) }
    }))
}

/// The camera that is asked for, with its map.
fn camera<'a>(args: &TeachArgs, machine: &'a Machine) -> Result<(&'a Sensor, &'a HeightTable), Failure> {
    let table = |sensor: &'a Sensor| match &sensor.sight {
        Sight::Camera(camera) => Some((sensor, &camera.table)),
        Sight::Stripe(_) => None,
    };
    let cameras: Vec<_> = machine.sensors.iter().filter_map(table).collect();
    let names = || cameras.iter().map(|(s, _)| s.name.as_str()).collect::<Vec<_>>().join(", ");
    let refuse = |message: String| {
        let allowed = if cameras.is_empty() {
            "a machine with a camera: [sensors.<name>] with kind = \"camera\" in its file".to_owned()
        } else {
            names()
        };
        Err(Failure::Input(format!("{message}\n   allowed: {allowed}")))
    };
    match (&args.sensor, cameras.as_slice()) {
        (Some(name), _) => match cameras.iter().find(|(s, _)| &s.name == name) {
            Some(found) => Ok(*found),
            None => refuse(format!("--sensor {name}: {} has no such camera", machine.name)),
        },
        (None, [one]) => Ok(*one),
        (None, []) => refuse(format!("{} has no camera", machine.name)),
        (None, _) => refuse(format!("{} has several cameras: --sensor says which", machine.name)),
    }
}

/// How the crawl goes along this seam.
fn settings(args: &TeachArgs, nominal: &SeamLine) -> Result<Settings, Failure> {
    let ends_after_mm = if nominal.is_closed() { f64::INFINITY } else { nominal.length() - EARLY_MM };
    let step_mm = within("--step-mm", args.step_mm, STEPS_MM)?;
    Ok(Settings { step_mm, ends_after_mm, longest_mm: 2.0 * nominal.length() + 100.0, ..Settings::default() })
}

fn follower(args: &TeachArgs, table: &HeightTable) -> Result<JointFollower, Failure> {
    let tack = positive("--longest-tack-mm", args.longest_tack_mm)?;
    let (low, high) = table.range();
    let middle = if low.is_finite() { 0.5 * (low + high) } else { 0.0 };
    let map = table.at(middle).map_err(|e| Failure::Input(e.to_string()))?;
    let scale = map.scale_at(map.parameters().centre_px).unwrap_or(1.0);
    Ok(JointFollower::new(tack / scale))
}

/// Where the crawl begins: at `point`, as the nominal seam runs nearby unless the command line says otherwise.
fn start(args: &TeachArgs, nominal: &SeamLine, point: DVec3) -> Result<EyePose, Failure> {
    let vector = |name: &str, given: &Option<Vec<f64>>| match given.as_deref() {
        None => Ok(None),
        Some([x, y, z]) => Ok(Some(DVec3::new(*x, *y, *z))),
        Some(other) => Err(Failure::Input(format!("{name}: {} numbers\n   allowed: three, X,Y,Z", other.len()))),
    };
    let point = vector("--start", &args.start)?.unwrap_or(point);
    let far = || {
        let message =
            format!("the start ({:.3}, {:.3}, {:.3}) is not near the nominal seam", point.x, point.y, point.z);
        Failure::Input(format!("{message}\n   allowed: --start within 15 mm of it, in the machine's work frame"))
    };
    let foot = Some(point).filter(|p| p.is_finite()).and_then(|p| nominal.foot(p)).ok_or_else(far)?;
    let along = match vector("--direction", &args.direction)? {
        Some(way) => way.try_normalize().ok_or_else(|| {
            Failure::Input(
                "--direction: it has no length\n   allowed: three finite numbers that are not all 0".to_owned(),
            )
        })?,
        None => foot.along,
    };
    Ok(EyePose { point, normal: foot.at.normal, along })
}

/// The nominal seam brought to the operator's points.
fn by_points(path: &Path, nominal: &SeamLine) -> Result<Outcome, Failure> {
    let source = path.display().to_string();
    let file = File::open(path).map_err(|e| Failure::Input(format!("{source}: cannot be read: {e}")))?;
    let (mut reader, _) = CsvReader::open(&source, BufReader::new(file), &[&["x_mm", "y_mm", "z_mm"]])?;
    let mut points = Vec::new();
    while let Some(row) = reader.row() {
        let row = row?;
        points.push(DVec3::new(row[0], row[1], row[2]));
    }
    let smooth = semi_manual(nominal, &points, EVERY_MM).map_err(|e| Failure::Input(format!("{source}: {e}")))?;
    Ok(Outcome { smooth, ended: "points", ..Outcome::default() })
}

/// A line smoothed.
fn smooth(line: &TaughtLine, end: Option<&End>) -> Vec<LinePoint> {
    smoothed(line, EVERY_MM, WINDOW_MM, matches!(end, Some(End::Closed { .. })))
}
