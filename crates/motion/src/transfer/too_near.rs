use seamwright_clearance::{Evaluation, Profile};
use seamwright_machine::{Joints, Surroundings};
use seamwright_message::{Argument, Message, Unit};

/// Distance below which two solids collide, mm.
const COLLISION_MM: f64 = 0.005;

/// Reports two solids that are too near, and their distance.
pub(crate) fn too_near(around: &Surroundings, watch: usize, found: &Evaluation) -> Message {
    let (first, second) = around.nearest_bodies(watch, found);
    let message = match found.distance > COLLISION_MM {
        true => Message::new("motion-too-near").quantity("distance", found.distance, Unit::Mm, 2),
        false => Message::new("motion-collision"),
    };
    let least_mm = around.scene().watches()[watch].least_mm();
    message.message("first", first).message("second", second).value("minimum", least_mm, Unit::Mm)
}

/// The minimum distance (mm) in a profile, its position, and the two solids; none if all exceed the cut-off.
pub(crate) fn nearest(around: &Surroundings, profile: &Profile) -> Option<(f64, f64, [Message; 2])> {
    let near = profile.traces.iter().enumerate().filter(|(_, trace)| trace.nearest.1.place.is_some());
    let (watch, trace) = near.min_by(|a, b| a.1.nearest.1.distance.total_cmp(&b.1.nearest.1.distance))?;
    let (s, found) = trace.nearest;
    Some((found.distance, s, around.nearest_bodies(watch, &found).into()))
}

/// True if `finding`, the message of a clearance finding, names the two solids that are nearest with the axes at `q`
/// (mm, rad) and closer than `within` (mm).
pub fn names_nearest(finding: &Message, around: &Surroundings, q: &Joints, within: f64) -> bool {
    let Some((watch, found)) = around.nearest(q, within) else { return false };
    if found.place.is_none() || found.distance >= within {
        return false;
    }
    let named = |name: &str| match finding.argument(name) {
        Some(Argument::Message(solid)) => Some(solid.as_ref()),
        _ => None,
    };
    let (first, second) = around.nearest_bodies(watch, &found);
    named("first") == Some(&first) && named("second") == Some(&second)
}
