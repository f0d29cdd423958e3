use super::answer::Refused;
use crate::wire::{PlaceAnswer, PlaceMethod, PlaceText, TouchedPoint};
use glam::{DAffine3, DVec3};
use seamwright_geometry::fit::{Touch, best_fit, chuck, outliers, plane_line_point, rms, three_points};
use seamwright_program::Program;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::offset;
use seamwright_weld::SeamSurfaces;
use std::path::Path;

/// Name of the offset.
const NAME: &str = "touched";
/// Maximum number of points: touching by hand needs fewer.
const MAX_POINTS: usize = 1000;
/// Maximum ball radius, mm, and maximum coordinate of a point.
const LARGEST_MM: f64 = 1000.0;
const FARTHEST_MM: f64 = 1e7;

/// Pose of the part, from touched points.
struct Found {
    /// The part's frame in the work frame.
    offset: DAffine3,
    residuals: Vec<f64>,
    notes: Vec<String>,
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
        return Err(Refused::input(format!("probe_radius_mm {}: allowed: 0 to {LARGEST_MM}", asked.probe_radius_mm)));
    }
    if asked.points.len() > MAX_POINTS {
        return Err(Refused::input(format!("{} points; allowed: up to {MAX_POINTS}", asked.points.len())));
    }
    for (i, point) in asked.points.iter().enumerate() {
        let number = i + 1;
        if !features.contains(&point.feature.as_str()) {
            let allowed = features.join(", ");
            return Err(Refused::input(format!("point {number}: feature `{}`; allowed: {allowed}", point.feature)));
        }
        if point.tip.iter().any(|v| v.is_nan() || v.abs() > FARTHEST_MM) {
            return Err(Refused::input(format!("point {number}: allowed: up to {FARTHEST_MM:.0} mm")));
        }
    }
    Ok(())
}

/// Converts the reason for which points do not determine a pose.
fn refused(e: &seamwright_geometry::Error) -> Refused {
    Refused::input(format!("{e}; allowed: more points, spread over what they should tell, or another method"))
}

/// Fits the surfaces to the points by least squares.
fn fitted(loaded: &Loaded, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let program = &loaded.welding.program;
    let Some(seam) = &program.value.seam else {
        return Err(Refused::input("the job has no seam whose surfaces could have been touched; allowed: a job"));
    };
    let surfaces = SeamSurfaces::new(program, seam).map_err(seamwright_project::Failure::from)?;
    let touch = |point: &TouchedPoint| {
        let surface = if point.feature == "nozzle" { &surfaces.first } else { &surfaces.second };
        Touch { point: DVec3::from_array(point.tip), surface: surface.as_ref(), outside: radius }
    };
    let touches: Vec<Touch> = points.iter().map(touch).collect();
    let fit = best_fit(&touches, &program.value.seam_in_work(), false).map_err(|e| refused(&e))?;
    let placed = program.value.work_offset().inverse() * program.value.seam_in_work();
    let mut notes: Vec<String> = fit.free.iter().map(|free| format!("not seen: {free}; left as it was")).collect();
    if fit.deviation.is_none() {
        notes.push("there are no more points than unknowns: nothing would show a bad one".to_owned());
    }
    Ok(Found { offset: fit.transform * placed.inverse(), residuals: fit.residuals, notes })
}

/// Returns the points of a feature.
fn of(points: &[TouchedPoint], feature: &str) -> Vec<DVec3> {
    points.iter().filter(|p| p.feature == feature).map(|p| DVec3::from_array(p.tip)).collect()
}

/// Merges residuals by feature into the order of the points.
fn in_order<const N: usize>(points: &[TouchedPoint], lists: [(&str, &[f64]); N]) -> Vec<f64> {
    let mut lists = lists.map(|(feature, residuals)| (feature, residuals.iter()));
    let next = |p: &TouchedPoint| lists.iter_mut().find(|l| l.0 == p.feature).and_then(|l| l.1.next().copied());
    points.iter().filter_map(next).collect()
}

/// Aligns three faces of the part.
fn faces(program: &Program, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let [plane, line, point] = ["plane", "line", "point"].map(|feature| of(points, feature));
    let fit = plane_line_point((&plane, &line, &point), radius, &program.work_offset()).map_err(|e| refused(&e))?;
    let residuals = in_order(points, [("plane", &fit.plane), ("line", &fit.line), ("point", &fit.point)]);
    Ok(Found { offset: fit.transform, residuals, notes: Vec::new() })
}

/// Aligns a plane of the part and two marks on it.
fn marks(program: &Program, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let [plane, origin, direction] = ["plane", "origin", "direction"].map(|feature| of(points, feature));
    let found = three_points([&plane, &origin, &direction], radius, &program.work_offset());
    let found = found.map_err(|e| refused(&e))?;
    let [plane, origin, direction] = &found.residuals;
    let residuals = in_order(points, [("plane", plane), ("origin", origin), ("direction", direction)]);
    let notes = three_alone(plane.len(), "plane").into_iter().collect();
    Ok(Found { offset: found.transform, residuals, notes })
}

/// Aligns a round part in a chuck.
fn round(program: &Program, points: &[TouchedPoint], radius: f64) -> Result<Found, Refused> {
    let [face, round] = ["face", "round"].map(|feature| of(points, feature));
    let found = chuck(&face, &round, radius, &program.work_offset())
        .map_err(|e| Refused::input(format!("{e}; allowed: more points, spread over the face and all round")))?;
    let [face, round, _] = &found.residuals;
    let residuals = in_order(points, [("face", face), ("round", round)]);
    let mut notes: Vec<String> =
        found.radius_mm.map(|r| format!("diameter of the round: {:.3} mm", 2.0 * r)).into_iter().collect();
    notes.push("not seen: the turn about the axis; left as it was".to_owned());
    notes.extend([(face.len(), "face"), (round.len(), "round")].into_iter().filter_map(|(n, of)| three_alone(n, of)));
    Ok(Found { offset: found.transform, residuals, notes })
}

/// Returns a note if three points determine a feature without redundancy.
fn three_alone(points: usize, of: &str) -> Option<String> {
    (points == 3).then(|| format!("{of}: three points only, nothing would show a bad one"))
}

fn answer(text: &str, found: Found) -> Result<PlaceAnswer, Refused> {
    let transform = offset::rounded(&found.offset).ok_or_else(|| Refused::input("the points give no place"))?;
    let placed = offset::put_into(text, NAME, &transform).map_err(|e| Refused::input(e.to_string()))?;
    let text = placed.ok_or_else(|| Refused::input("`offsets` is no table; allowed: [offsets.NAME]"))?;
    Ok(PlaceAnswer {
        text,
        move_mm: transform.move_mm.get().to_array(),
        angle_deg: transform.angle_deg.get(),
        rms_mm: rms(&found.residuals),
        outliers: outliers(&found.residuals),
        residuals_mm: found.residuals,
        notes: found.notes,
    })
}
