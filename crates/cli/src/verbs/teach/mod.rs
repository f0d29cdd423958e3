//! A seam taught by eye, from simulated or recorded frames, or by the operator's points.

mod outcome;
mod plot;
mod report;
mod simulated;

use super::positive;
use crate::args::reduce::MethodArg;
use crate::args::teach::TeachArgs;
use crate::csv::CsvReader;
use crate::failure::Failure;
use crate::files;
use crate::load::{Loaded, load};
use glam::DVec3;
use outcome::Outcome;
use seamwright_cell::eyes::{SeamLine, Station};
use seamwright_cell::frames::{FrameError, FrameSource, Recorded, TimedFrame};
use seamwright_cell::teach::{Replay, RidgeFollower, replay, semi_manual};
use seamwright_geometry::HeightTable;
use seamwright_geometry::reduce::Method;
use seamwright_machine::{Joints, Machine, Sensor, Sight};
use seamwright_program::Program;
use seamwright_tracking::teach::{Crawl, End, EyePose, LinePoint, Settings, TaughtLine, smoothed, to_program};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Distance of the points of the smoothed line, mm, and how far to both sides it looks.
const EVERY_MM: f64 = 0.5;
const WINDOW_MM: f64 = 2.5;
/// A joint that ends further before the end of the nominal seam does not end: it is hidden.
const EARLY_MM: f64 = 15.0;

pub(crate) fn run(args: &TeachArgs) -> Result<(), Failure> {
    let tolerance = positive("--tolerance-mm", args.tolerance_mm)?;
    let attitude = positive("--attitude-deg", args.attitude_deg)?.to_radians();
    let loaded = load(&args.job)?;
    let nominal = nominal(&loaded)?;
    let mut outcome = match (&args.semi_manual, args.frames.as_deref()) {
        (Some(points), _) => by_points(points, &nominal)?,
        (None, Some("simulated")) => simulated::teach(args, &loaded, &nominal)?,
        (None, Some(folder)) => from_folder(args, Path::new(folder), &loaded, &nominal)?,
        // The command line asks for one of them.
        (None, None) => return Err(Failure::Input("either --frames or --semi-manual".to_owned())),
    };
    if outcome.smooth.len() < 2 {
        let why = outcome.finding.take().unwrap_or_else(|| "no joint was found".to_owned());
        return Err(Failure::Findings(vec![outcome::finding(why, 0.0)]));
    }
    let method = match args.method {
        MethodArg::Greedy => Method::Greedy,
        MethodArg::Fewest => Method::Fewest,
    };
    let like = &loaded.welding.program.value;
    let reduced = to_program(&outcome.smooth, like, (tolerance, attitude), method)
        .map_err(|e| Failure::Input(format!("what was found makes no program: {e}")))?;
    let written = reduced.program.to_toml().map_err(|e| Failure::Environment(e.to_string()))?;
    // What is written is read by all other verbs: a program that they refuse is none.
    Program::read(&args.output.display().to_string(), &written)?;
    let report = report::Report::new(args, &loaded.machine, &nominal, &outcome, &reduced);
    let svg = plot::draw(&report);
    let beside = |ending: &str| args.output.with_extension(ending);
    files::write(&args.output, &written)?;
    files::write(&beside("report.json"), &report.to_json()?)?;
    files::write(&beside("svg"), &svg)?;
    report.print(args.json)?;
    match outcome.finding {
        Some(why) => Err(Failure::Findings(vec![outcome::finding(why, outcome.line.length())])),
        None => Ok(()),
    }
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
    let step_mm = positive("--step-mm", args.step_mm)?;
    Ok(Settings { step_mm, ends_after_mm, longest_mm: 2.0 * nominal.length() + 100.0, ..Settings::default() })
}

fn follower(args: &TeachArgs, table: &HeightTable) -> Result<RidgeFollower, Failure> {
    let tack = positive("--longest-tack-mm", args.longest_tack_mm)?;
    let (low, high) = table.range();
    let middle = if low.is_finite() { 0.5 * (low + high) } else { 0.0 };
    let map = table.at(middle).map_err(|e| Failure::Input(e.to_string()))?;
    let scale = map.scale_at(map.parameters().centre_px).unwrap_or(1.0);
    Ok(RidgeFollower { longest_gap_px: tack / scale })
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

/// The first frame again, then the others.
struct Again {
    first: Option<TimedFrame>,
    rest: Recorded,
}

impl FrameSource for Again {
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        match self.first.take() {
            Some(frame) => Ok(Some(frame)),
            None => self.rest.next(),
        }
    }
}

fn from_folder(args: &TeachArgs, folder: &Path, loaded: &Loaded, nominal: &SeamLine) -> Result<Outcome, Failure> {
    let machine = &loaded.machine;
    let (sensor, table) = camera(args, machine)?;
    let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
    let mut rest = Recorded::open(folder, &axes)?;
    let count = rest.len() as u64;
    let first = rest.next()?;
    let Some(frame) = &first else { return Err(Failure::Input(format!("{}: no frames", folder.display()))) };
    let mut q = Joints::default();
    for (value, (axis, given)) in q.iter_mut().zip(machine.axes.iter().zip(frame.axes.iter().flatten())) {
        *value = axis.from_file(*given);
    }
    let camera = machine.camera_frame(sensor, &q);
    let at = camera.transform_point3(DVec3::Z * frame.height_mm.unwrap_or(0.0));
    let mut crawl = Crawl::new(settings(args, nominal)?, table, nominal, start(args, nominal, at)?);
    let progress = crate::progress::Progress::new("looking at frames", count);
    let mut each = |_: &TimedFrame, _: &Crawl| {
        progress.all(1);
        Ok::<(), Failure>(())
    };
    let mut source = Again { first, rest };
    let eyes = (&mut crawl, &mut source as &mut dyn FrameSource);
    let (replayed, run) = replay((machine, sensor), eyes, &mut follower(args, table)?, &mut each)?;
    drop(progress);
    let finding = match replayed {
        Replay::Ended(_) => None,
        Replay::OutOfFrames => Some("the frames are at their end, and the joint is not".to_owned()),
        Replay::Lost(why) => Some(format!("after {} of {count} frames {why}", run.axes.len())),
    };
    Ok(Outcome::of(&crawl, &run, finding, None))
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

/// The line of a crawl, smoothed.
fn smooth(line: &TaughtLine, end: &End) -> Vec<LinePoint> {
    smoothed(line, EVERY_MM, WINDOW_MM, matches!(end, End::Closed { .. }))
}
