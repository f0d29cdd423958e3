//! Teaching by camera: the functions common to command line and panel, from a job's nominal seam to the program of the
//! seam found.

mod figures;
mod ground;
mod outcome;
mod picture;

pub use figures::{Figures, TaughtPoint, bridged, from_nominal};
pub use ground::Ground;
pub use outcome::{Outcome, finding};
pub use picture::Picture;

use crate::failure::Failure;
use crate::load::Loaded;
use glam::DVec3;
use seamwright_executive::teach::JointFollower;
use seamwright_geometry::HeightTable;
use seamwright_message::Message;
use seamwright_program::Program;
use seamwright_tracking::teach::{
    CameraPose, End, Kind, Lean, LinePoint, Reduced, ReductionTolerances, Settings, TaughtLine, smoothed, to_program,
    torch_axes,
};
use seamwright_tracking::teach::{SeamLine, Station};
use seamwright_weld::Attitude;

/// Distance of the points of the smoothed line, mm.
pub const EVERY_MM: f64 = 0.5;
/// Reach of smoothing to both sides, mm.
const WINDOW_MM: f64 = 2.5;
/// A joint that ends further before the end of the nominal seam does not end: it is hidden.
const EARLY_MM: f64 = 15.0;

/// The nominal seam in the machine's work frame.
///
/// # Errors
/// A program without a seam.
pub fn nominal(loaded: &Loaded) -> Result<SeamLine, Failure> {
    let seam = loaded.seam()?;
    let place = loaded.welding.program.value.seam_in_work();
    let length = if seam.all_round() { seam.length() } else { seam.weld_length() };
    Ok(SeamLine::sampled(length, seam.all_round(), |s| {
        let p = seam.at(s);
        Station { point: place.transform_point3(p.point), normal: place.transform_vector3(p.bisector) }
    }))
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
pub fn follower(table: &HeightTable, longest_tack_mm: f64) -> Result<JointFollower, Failure> {
    let (low, high) = table.range();
    let middle = if low.is_finite() { 0.5 * (low + high) } else { 0.0 };
    let map = table.at(middle).map_err(|e| Failure::Input(e.message()))?;
    let scale = map.scale_at(map.parameters().centre_px).unwrap_or(1.0);
    Ok(JointFollower::new(longest_tack_mm / scale))
}

/// Start of the joint following at `point`, in the direction of the nominal seam nearby; `None` if it is not near.
pub fn start(nominal: &SeamLine, point: DVec3) -> Option<CameraPose> {
    let foot = Some(point).filter(|p| p.is_finite()).and_then(|p| nominal.foot(p))?;
    Some(CameraPose { point, normal: foot.at.normal, along: foot.along })
}

/// A line smoothed.
pub(super) fn smooth(line: &TaughtLine, end: Option<&End>) -> Vec<LinePoint> {
    smoothed(line, EVERY_MM, WINDOW_MM, matches!(end, Some(End::Closed { .. })))
}

/// The program of a smoothed line within `tolerances`, and its text. The text is read back, so that other verbs accept the
/// program. `name` appears in errors.
///
/// # Errors
/// A line from which no valid program can be made.
pub fn reduced(
    loaded: &Loaded,
    nominal: &SeamLine,
    line: &[LinePoint],
    tolerances: ReductionTolerances,
    kind: Kind,
    name: &str,
) -> Result<(Reduced, String), Failure> {
    let torch = torch(loaded, nominal, line)?;
    let like = &loaded.welding.program.value;
    let reduced = to_program(line, &torch, like, tolerances, kind)
        .map_err(|e| Failure::Input(Message::new("project-no-taught-program").message("why", e.message())))?;
    let written = reduced.program.to_toml().map_err(|e| Failure::Environment(Message::outside(&e)))?;
    Program::read(name, &written)?;
    Ok((reduced, written))
}

/// Unit vectors from the joint to the torch at each point of the line: as found, with the angles of the job's first
/// pass at the position beside it.
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
