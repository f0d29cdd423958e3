//! A seam taught by camera, from simulated, recorded or sent frames, or by the operator's points.

mod live_frames;
mod operator;
mod plot;
mod recorded_frames;
mod report;
mod session;
mod setup;
mod simulated;

use super::positive;
use crate::args::teach::{TeachArgs, TeachMethod};
use crate::refusals::{in_file, not_allowed, of_option, refused, unreadable};
use glam::DVec3;
use seamwright_geometry::reduce::Method;
use seamwright_message::Message;
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::load;
use seamwright_teaching as teaching;
use seamwright_teaching::{EVERY_MM, Kind, Outcome, ReductionTolerances, SeamLine, nominal, semi_manual};
use setup::within;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

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
        Source::Folder(folder) => (recorded_frames::teach(args, folder, &loaded, &nominal)?, None),
        Source::Sender(address) => (live_frames::teach(args, address, &loaded, &nominal)?, None),
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
                Some(("tcp", address)) => Self::Sender(live_frames::address(frames, address)?),
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
