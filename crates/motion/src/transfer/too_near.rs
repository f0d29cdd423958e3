use glam::DVec3;
use seamwright_clearance::{Evaluation, Profile};
use seamwright_machine::{Joints, Surroundings};
use seamwright_message::{Argument, Message, Unit};
use seamwright_program::TorchPath;

/// Distance below which two solids collide, mm.
const COLLISION_MM: f64 = 0.005;

/// Root of the joint at a position of a pass, in the work frame.
pub(crate) struct RootAt {
    point: DVec3,
    /// Unit vector out of the joint.
    face: DVec3,
}

impl RootAt {
    /// The root at path length `s`, if the path has a joint.
    pub(crate) fn of(path: &dyn TorchPath, s: f64) -> Option<Self> {
        Some(Self { point: path.root(s)?, face: path.groove(s)?.face })
    }
}

/// Farther from the root than this no height over it is reported, mm.
const NEAR_ROOT_MM: f64 = 200.0;

/// Reports two solids that are too near, and their distance; near the `root` of a joint also the height over it.
pub(crate) fn too_near(around: &Surroundings, watch: usize, found: &Evaluation, root: Option<&RootAt>) -> Message {
    let message = bodies_too_near(around, watch, found);
    let (Some(root), Some(place)) = (root.filter(|_| around.is_part(watch)), &found.place) else { return message };
    let from_root = place.on_b - root.point;
    if from_root.length() > NEAR_ROOT_MM {
        return message;
    }
    let (height, code) = match from_root.dot(root.face) {
        below if below < 0.0 => (-below, "motion-below-root"),
        above => (above, "motion-above-root"),
    };
    Message::new(code).message("contact", message).quantity("height", height, Unit::Mm, 0)
}

fn bodies_too_near(around: &Surroundings, watch: usize, found: &Evaluation) -> Message {
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
    let finding = match finding.argument("contact") {
        Some(Argument::Message(contact)) => contact.as_ref(),
        _ => finding,
    };
    let named = |name: &str| match finding.argument(name) {
        Some(Argument::Message(solid)) => Some(solid.as_ref()),
        _ => None,
    };
    let (first, second) = around.nearest_bodies(watch, &found);
    named("first") == Some(&first) && named("second") == Some(&second)
}
