use super::answer::Refused;
use crate::limits::MAX_PLACE_POINTS;
use crate::wire::{PlaceAnswer, PlaceMethod, PlaceText, TouchedPoint};
use glam::{DAffine3, DVec3};
use seamwright_geometry::fit::{Touch, best_fit, chuck, outliers, plane_line_point, rms, three_points};
use seamwright_message::{Message, Unit};
use seamwright_program::Program;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::work_offset;
use seamwright_weld::SeamSurfaces;
use std::path::Path;

/// Name of the offset.
const NAME: &str = "touched";
/// Maximum ball radius, mm, and maximum coordinate of a point.
const LARGEST_MM: f64 = 1000.0;
const FARTHEST_MM: f64 = 1e7;

/// Pose of the part, from touched points.
struct Found {
    /// The part's frame in the work frame.
    offset: DAffine3,
    residuals: Vec<f64>,
    notes: Vec<Message>,
}

/// Finds the pose of a job's part; files that it names are in `jobs`.
///
/// # Errors
/// An invalid job, or points that do not determine a pose.
pub(crate) fn found_place(asked: &PlaceText, jobs: &Path) -> Result<PlaceAnswer, Refused> {
    check(asked)?;
    let loaded = load_foreign("job.toml", &asked.text, jobs)?;
    let program = &loaded.welding.program.value;
    let (points, radius) = (&asked.points, asked.probe_radius_mm);
    let found = match asked.method {
        PlaceMethod::BestFit => fitted(&loaded, points, radius)?,
        PlaceMethod::PlaneLinePoint => faces(program, points, radius)?,
        PlaceMethod::ThreePoints => marks(program, points, radius)?,
        PlaceMethod::Chuck => round(program, points, radius)?,
    };
    let answer = answer(&asked.text, found)?;
    // Verifies that the changed text is a valid job.
    load_foreign("job.toml", &answer.text, jobs)?;
    Ok(answer)
}

fn check(asked: &PlaceText) -> Result<(), Refused> {
    let features: &[&str] = match asked.method {
        PlaceMethod::BestFit => &["nozzle", "body"],
        PlaceMethod::PlaneLinePoint => &["plane", "line", "point"],
        PlaceMethod::ThreePoints => &["plane", "origin", "direction"],
        PlaceMethod::Chuck => &["face", "round"],
    };
    if !(0.0..=LARGEST_MM).contains(&asked.probe_radius_mm) {
        return Err(Message::new("server-probe-radius")
            .value("value", asked.probe_radius_mm, Unit::Mm)
            .value("max", LARGEST_MM, Unit::Mm)
            .into());
    }
    if asked.points.len() > MAX_PLACE_POINTS {
        return Err(Message::new("server-too-many-points")
            .count("n", asked.points.len())
            .count("max", MAX_PLACE_POINTS)
            .into());
    }
    for (i, point) in asked.points.iter().enumerate() {
        let number = i + 1;
        if !features.contains(&point.feature.as_str()) {
            let allowed = features.join(", ");
            return Err(Message::new("server-feature")
                .count("point", number)
                .text("feature", &point.feature)
                .text("allowed", allowed)
                .into());
        }
        if point.tip.iter().any(|v| v.is_nan() || v.abs() > FARTHEST_MM) {
            return Err(Message::new("server-point-far")
                .count("point", number)
                .quantity("max", FARTHEST_MM, Unit::Mm, 0)
                .into());
        }
    }
    Ok(())
}

/// Converts the reason for which points do not determine a pose.
fn refused(e: &seamwright_geometry::Error) -> Refused {
    Refused::input(Message::new("server-more-points").message("why", e.message()))
}

fn fitted(loaded: &Loaded, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let program = &loaded.welding.program;
    let Some(seam) = &program.value.seam else {
        return Err(Message::new("server-no-surfaces").into());
    };
    let surfaces = SeamSurfaces::new(program, seam).map_err(seamwright_project::Failure::from)?;
    let touch = |point: &TouchedPoint| {
        let surface = if point.feature == "nozzle" { &surfaces.first } else { &surfaces.second };
        Touch { point: DVec3::from_array(point.tip), surface: surface.as_ref(), outside: radius }
    };
    let touches: Vec<Touch> = points.iter().map(touch).collect();
    let fit = best_fit(&touches, &program.value.seam_in_work(), false).map_err(|e| refused(&e))?;
    let placed = program.value.work_offset().inverse() * program.value.seam_in_work();
    let not_determined = |free: &_| Message::new("server-not-determined").text("what", format!("{free}"));
    let mut notes: Vec<Message> = fit.free.iter().map(not_determined).collect();
    if fit.deviation.is_none() {
        notes.push(Message::new("server-no-spare-points"));
    }
    Ok(Found { offset: fit.transform * placed.inverse(), residuals: fit.residuals, notes })
}

fn of(points: &[TouchedPoint], feature: &str) -> Vec<DVec3> {
    points.iter().filter(|p| p.feature == feature).map(|p| DVec3::from_array(p.tip)).collect()
}

/// Merges residuals by feature into the order of the points.
fn in_order<const N: usize>(points: &[TouchedPoint], lists: [(&str, &[f64]); N]) -> Vec<f64> {
    let mut lists = lists.map(|(feature, residuals)| (feature, residuals.iter()));
    let next = |p: &TouchedPoint| lists.iter_mut().find(|l| l.0 == p.feature).and_then(|l| l.1.next().copied());
    points.iter().filter_map(next).collect()
}

fn faces(program: &Program, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let [plane, line, point] = ["plane", "line", "point"].map(|feature| of(points, feature));
    let fit = plane_line_point(&plane, &line, &point, radius, &program.work_offset()).map_err(|e| refused(&e))?;
    let residuals = in_order(points, [("plane", &fit.plane), ("line", &fit.line), ("point", &fit.point)]);
    Ok(Found { offset: fit.transform, residuals, notes: Vec::new() })
}

fn marks(program: &Program, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let [plane, origin, direction] = ["plane", "origin", "direction"].map(|feature| of(points, feature));
    let found = three_points([&plane, &origin, &direction], radius, &program.work_offset());
    let found = found.map_err(|e| refused(&e))?;
    let [plane, origin, direction] = &found.residuals;
    let residuals = in_order(points, [("plane", plane), ("origin", origin), ("direction", direction)]);
    let notes = three_alone(plane.len(), "server-three-points-plane").into_iter().collect();
    Ok(Found { offset: found.transform, residuals, notes })
}

fn round(program: &Program, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let [face, round] = ["face", "round"].map(|feature| of(points, feature));
    let found = chuck(&face, &round, radius, &program.work_offset())
        .map_err(|e| Refused::input(Message::new("server-more-points-round").message("why", e.message())))?;
    let [face, round, _] = &found.residuals;
    let residuals = in_order(points, [("face", face), ("round", round)]);
    let mut notes: Vec<Message> = found
        .radius_mm
        .map(|r| Message::new("server-round-diameter").quantity("diameter", 2.0 * r, Unit::Mm, 3))
        .into_iter()
        .collect();
    notes.push(Message::new("server-not-determined").message("what", Message::new("server-turn-about-axis")));
    notes.extend(
        [(face.len(), "server-three-points-face"), (round.len(), "server-three-points-round")]
            .into_iter()
            .filter_map(|(n, of)| three_alone(n, of)),
    );
    Ok(Found { offset: found.transform, residuals, notes })
}

/// Returns a note if three points determine a feature without redundancy.
fn three_alone(points: usize, code: &'static str) -> Option<Message> {
    (points == 3).then(|| Message::new(code))
}

fn answer(text: &str, found: Found) -> Result<PlaceAnswer, Refused> {
    let transform =
        work_offset::rounded(&found.offset).ok_or_else(|| Refused::input(Message::new("server-no-position")))?;
    let placed = work_offset::put_into(text, NAME, &transform).map_err(|e| Refused::input(e.message()))?;
    let text = placed.ok_or_else(|| Refused::input(Message::new("server-offsets-no-table")))?;
    Ok(PlaceAnswer {
        text,
        move_mm: transform.move_mm.get().to_array(),
        angle_deg: transform.angle_deg.get(),
        rms_mm: rms(&found.residuals),
        outliers: outliers(&found.residuals),
        residuals_mm: found.residuals,
        notes: found.notes.into_iter().map(Into::into).collect(),
    })
}
