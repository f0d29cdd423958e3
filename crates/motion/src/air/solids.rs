use seamwright_clearance::{Evaluation, Watch};
use seamwright_machine::{Joints, Surroundings};
use seamwright_message::{Argument, Message, Unit};

/// Distance below which two solids collide, mm.
const COLLISION_MM: f64 = 0.005;

/// Names the two nearest solids of an evaluation of `watch`; without a nearest point, its two groups.
pub fn solids(around: &Surroundings, watch: usize, found: &Evaluation) -> [Message; 2] {
    let scene = around.scene();
    let watched = &scene.watches()[watch];
    let (a, b) = watched.groups();
    let solid = |group: usize, at: usize| {
        let group = &scene.groups()[group];
        match found.place.as_ref().and_then(|place| group.solids.get(place.solids[at])) {
            Some(solid) => of_group(&group.name, solid.name()),
            None => Message::verbatim(group.name.as_str()),
        }
    };
    let second = match watched {
        Watch::Apart { .. } => solid(b, 1),
        Watch::Inside { zones, .. } => {
            let zone = zones.get(found.place.as_ref().map_or(0, |place| place.solids[1]));
            Message::new("motion-permitted-zone").text("name", zone.map_or("", |zone| zone.name()))
        }
    };
    [solid(a, 0), second]
}

/// Names a solid; one of the job with its group, since a job's nozzle is not a torch's.
fn of_group(group: &str, name: &str) -> Message {
    match group {
        "part" if name != group => Message::new("motion-solid-of-part").text("name", name),
        "fixtures" if name != group => Message::new("motion-solid-of-fixtures").text("name", name),
        _ => Message::verbatim(name),
    }
}

/// Reports two solids that are too near, and their distance.
pub(crate) fn too_near(around: &Surroundings, watch: usize, found: &Evaluation) -> Message {
    let [first, second] = solids(around, watch, found);
    let message = match found.distance > COLLISION_MM {
        true => Message::new("motion-too-near").quantity("distance", found.distance, Unit::Mm, 2),
        false => Message::new("motion-collision"),
    };
    message.message("first", first).message("second", second).value(
        "minimum",
        around.scene().watches()[watch].least_mm(),
        Unit::Mm,
    )
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
    let [first, second] = solids(around, watch, &found);
    named("first") == Some(&first) && named("second") == Some(&second)
}
