//! From a job to the seam to be taught, and from the line found to the program of its weld.

use crate::attitude::{Lean, torch_axes};
use crate::error::Error;
use crate::events::{CameraPose, End};
use crate::follower::JointFollower;
use crate::program::{Kind, Reduced, ReductionTolerances, to_program};
use crate::seam_line::{SeamLine, Station};
use crate::settings::Settings;
use crate::smoothing::{LinePoint, smoothed};
use crate::taught_line::TaughtLine;
use glam::DVec3;
use seamwright_geometry::HeightTable;
use seamwright_message::Message;
use seamwright_program::Program;
use seamwright_weld::{Attitude, SeamCurve, Welding};

/// Distance of the points of the smoothed line, mm.
pub const EVERY_MM: f64 = 0.5;
/// Reach of smoothing to both sides, mm.
const WINDOW_MM: f64 = 2.5;
/// A joint that ends further before the end of the nominal seam does not end: it is hidden.
const EARLY_MM: f64 = 15.0;

/// The nominal `seam` of `program` in the machine's work frame.
pub fn nominal(program: &Program, seam: &SeamCurve) -> SeamLine {
    let place = program.seam_in_work();
    let length = if seam.all_round() { seam.length() } else { seam.weld_length() };
    SeamLine::sampled(length, seam.all_round(), |s| {
        let p = seam.at(s);
        Station { point: place.transform_point3(p.point), normal: place.transform_vector3(p.bisector) }
    })
}

/// Settings of the joint following along this seam, in steps of at most `step_mm`.
pub fn settings(nominal: &SeamLine, step_mm: f64) -> Settings {
    let ends_after_mm = if nominal.is_closed() { f64::INFINITY } else { nominal.length() - EARLY_MM };
    Settings { step_mm, ends_after_mm, longest_mm: 2.0 * nominal.length() + 100.0, ..Settings::default() }
}

/// Joint follower in frames with the map `table`, over tacks of up to `longest_tack_mm`.
///
/// # Errors
/// A map without heights.
pub fn follower(table: &HeightTable, longest_tack_mm: f64) -> Result<JointFollower, Error> {
    let (low, high) = table.range();
    let middle = if low.is_finite() { 0.5 * (low + high) } else { 0.0 };
    let map = table.at(middle).map_err(|e| Error::Refused(e.message()))?;
    Ok(JointFollower::new(longest_tack_mm / map.scale_at(map.parameters().centre_px).unwrap_or(1.0)))
}

/// Start of the joint following at `point`, in the direction of the nominal seam nearby; `None` if it is not near.
pub fn start(nominal: &SeamLine, point: DVec3) -> Option<CameraPose> {
    let foot = Some(point).filter(|p| p.is_finite()).and_then(|p| nominal.foot(p))?;
    Some(CameraPose { point, normal: foot.at.normal, along: foot.along })
}

pub(crate) fn smooth(line: &TaughtLine, end: Option<&End>) -> Vec<LinePoint> {
    smoothed(line, EVERY_MM, WINDOW_MM, matches!(end, Some(End::Closed { .. })))
}

/// The program of a smoothed line within `tolerances`, and its text. The text is read back, so that other verbs accept the
/// program. `name` appears in errors.
///
/// # Errors
/// A line from which no valid program can be made.
pub fn reduced(
    welding: &Welding,
    nominal: &SeamLine,
    line: &[LinePoint],
    tolerances: ReductionTolerances,
    kind: Kind,
    name: &str,
) -> Result<(Reduced, String), Error> {
    let torch = torch(welding, nominal, line)?;
    let like = &welding.program.value;
    let reduced = to_program(line, &torch, like, tolerances, kind)
        .map_err(|e| Error::Refused(Message::new("project-no-taught-program").message("why", e.message())))?;
    let written = reduced.program.to_toml().map_err(|e| Error::Refused(Message::outside(&e)))?;
    Program::read(name, &written)?;
    Ok((reduced, written))
}

/// Unit vectors from the joint to the torch at each point of the line: as found, with the angles of the job's first
/// pass at the position beside it.
fn torch(welding: &Welding, nominal: &SeamLine, line: &[LinePoint]) -> Result<Vec<DVec3>, Error> {
    let program = &welding.program;
    let (Some(seam), Some(pass)) = (&welding.seam, program.value.passes.first()) else {
        return Ok(line.iter().map(|p| p.normal).collect());
    };
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
