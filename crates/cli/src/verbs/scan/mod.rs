//! The groove in a series of stripe images or profiles along a seam, as `[[joint.fit_up]]` of its job.

mod fit_up;
mod series;

use super::positive;
use super::stripe::Scale;
use crate::args::scan::ScanArgs;
use crate::refusals::{between, in_file, not_allowed, of_option};
use crate::rows::{Cell, Rows, print_text};
use seamwright_message::{Language, Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::load::{Loaded, load};
use seamwright_vision::stripe::StripeReader;
use seamwright_weld::{GrooveScan, GrooveScanner, Measured, NoScan, SeamCurve, SeamJoint, SensorView, is_symmetrical};
use series::Row;
use std::io::{self, Write as _};
use std::path::Path;

const HEADER: &str = "s_mm,file,root_gap_mm,root_gap_u_mm,mismatch_mm,mismatch_u_mm,angle_deg,angle_u_deg,dihedral_deg,\
    dihedral_u_deg,area_mm2,area_u_mm2,remaining_mm2,remaining_u_mm2,scatter_mm,share,status";

/// Maximum angle of the sensor, degrees.
const MAX_TURN_DEG: f64 = 60.0;
/// Profiles that are compared with the mirrored joint.
const COMPARED: usize = 5;
/// A mirrored joint fits better if the points scatter less than this part of their scatter.
const FITS_BETTER: f64 = 0.5;

/// A profile of the series with its result.
struct Station {
    row: Row,
    found: Result<GrooveScan, Message>,
}

pub(crate) fn run(args: &ScanArgs) -> Result<(), Failure> {
    let bridge = positive("--bridge-mm", args.bridge_mm)?;
    if !(-MAX_TURN_DEG..=MAX_TURN_DEG).contains(&args.turn_deg) {
        return Err(not_allowed("--turn-deg", args.turn_deg, between(-MAX_TURN_DEG, MAX_TURN_DEG)));
    }
    let loaded = load(&args.job)?;
    let (seam, joint) = (loaded.seam()?, joint(&loaded)?);
    let scale = Scale::new(args.machine.as_deref(), args.sensor.as_deref(), args.mm_per_px)?;
    let view = SensorView { mirrored: args.mirrored, turn: args.turn_deg.to_radians() };
    let scanner = |view| {
        GrooveScanner::new(joint, args.after_layer > 0, view).ok_or_else(|| {
            let allowed = Message::verbatim(GrooveScanner::KINDS);
            loaded.welding.program.error_at("joint.preparation", Message::new("cli-scan-kind"), allowed)
        })
    };
    let mut upright = scanner(view)?;
    let mut mirrored = scanner(SensorView { mirrored: !view.mirrored, ..view })?;
    let rows = series::read(&args.series, seam)?;
    let folder = args.series.parent().unwrap_or(Path::new("."));
    let mut reader = StripeReader::new();
    let mut stations = Vec::new();
    let compared = if is_symmetrical(&joint.joint().preparation) { 0 } else { COMPARED };
    let step = rows.len().div_ceil(compared.max(1)).max(1);
    let (mut asked, mut better) = (0, 0);
    for (i, row) in rows.into_iter().enumerate() {
        let found = match series::points(&row, folder, &scale, &mut reader)? {
            Err(why) => Err(why),
            Ok(points) => {
                let at = seam.at(row.s);
                let found = upright.measure(&at, &points);
                if compared > 0 && i % step == 0 {
                    asked += 1;
                    better += usize::from(is_better(&mirrored.measure(&at, &points), &found));
                }
                found.map_err(|why| why.message())
            }
        };
        stations.push(Station { row, found });
    }
    if 2 * better > asked {
        let words = if args.mirrored { "cli-scan-without-mirrored" } else { "cli-scan-with-mirrored" };
        let message = of_option("--mirrored", Message::new("cli-scan-mirrored"));
        return Err(Failure::refused(message, Message::new(words)));
    }
    write(args, &stations)?;
    report_missing(&stations);
    check_bridges(&stations, seam, bridge)?;
    match &args.output {
        Some(path) => fit_up::write_job(args, joint, &stations, path),
        None => Ok(()),
    }
}

fn joint(loaded: &Loaded) -> Result<&SeamJoint, Failure> {
    loaded.welding.joint.as_ref().ok_or_else(|| {
        let allowed = Message::new("cli-section-joint");
        loaded.welding.program.error_at("joint", Message::new("cli-section-no-joint"), allowed).into()
    })
}

/// True if the mirrored joint fits a profile much better.
fn is_better(mirrored: &Result<GrooveScan, NoScan>, upright: &Result<GrooveScan, NoScan>) -> bool {
    match (mirrored, upright) {
        (Ok(a), Ok(b)) => a.scatter < FITS_BETTER * b.scatter && a.share >= b.share,
        (Ok(_), Err(_)) => true,
        (Err(_), _) => false,
    }
}

/// Writes the table, or the entries for a job.
fn write(args: &ScanArgs, stations: &[Station]) -> Result<(), Failure> {
    if args.toml {
        return print_text(&fit_up::entries(args.after_layer, stations));
    }
    let mut rows = Rows::with_header(HEADER, args.json);
    for Station { row, found } in stations {
        let mut cells = vec![Cell::Number(row.s), Cell::Text(&row.file)];
        let status;
        match found {
            Ok(scan) => {
                let pair = |m: Measured, unit: f64| [unit * m.value, unit * m.uncertainty].map(Cell::Number);
                let degrees = 1f64.to_degrees();
                cells.extend(pair(scan.gap, 1.0));
                cells.extend(pair(scan.mismatch, 1.0));
                cells.extend(scan.angle.map_or([Cell::Empty; 2], |angle| pair(angle, degrees)));
                cells.extend(pair(scan.dihedral, degrees));
                cells.extend(pair(scan.area, 1.0));
                cells.extend(pair(scan.remaining, 1.0));
                cells.extend([scan.scatter, scan.share].map(Cell::Number));
                cells.push(Cell::Text("ok"));
            }
            Err(why) => {
                status = why.in_language(Language::English);
                cells.extend([Cell::Empty; 14]);
                cells.push(Cell::Text(&status));
            }
        }
        rows.row(&cells)?;
    }
    rows.finish()
}

/// Lists the profiles without a result on standard error.
fn report_missing(stations: &[Station]) {
    // Errors are ignored: standard error may be closed.
    let mut err = io::stderr();
    for Station { row, found } in stations {
        if let Err(why) = found {
            let file = if row.file.is_empty() { "-" } else { &row.file };
            let at = Message::new("cli-scan-at").quantity("s", row.s, Unit::Mm, 1).message("why", why.clone());
            let _ = writeln!(err, "{}", in_file(file, at));
        }
    }
}

/// Refuses lengths of seam without a measured profile.
fn check_bridges(stations: &[Station], seam: &SeamCurve, bridge: f64) -> Result<(), Failure> {
    let good: Vec<f64> = stations.iter().filter(|at| at.found.is_ok()).map(|at| at.row.s).collect();
    let (Some(first), Some(last)) = (good.first(), good.last()) else {
        return Err(missing(0.0, seam.weld_length(), bridge));
    };
    let mut ends: Vec<(f64, f64)> = good.windows(2).map(|w| (w[0], w[1])).collect();
    if seam.all_round() {
        ends.push((*last, first + seam.length()));
    } else {
        ends.extend([(0.0, *first), (*last, seam.weld_length())]);
    }
    match ends.into_iter().find(|(from, to)| to - from > bridge) {
        Some((from, to)) => Err(missing(from, to, bridge)),
        None => Ok(()),
    }
}

fn missing(from: f64, to: f64, bridge: f64) -> Failure {
    let message = Message::new("cli-scan-not-measured").quantity("from", from, Unit::Mm, 1);
    let message = message.quantity("to", to, Unit::Mm, 1).quantity("bridge", bridge, Unit::Mm, 1);
    // Errors are ignored: standard error may be closed.
    let _ = writeln!(io::stderr(), "{message}");
    Failure::Printed
}
