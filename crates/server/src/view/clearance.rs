use crate::wire::NearView;
use seamwright_machine::{Joints, Surroundings};

/// Returns the pair with the smallest margin with the axes at `q` (mm, rad), if its distance is below `within` (mm).
pub(crate) fn near(around: &Surroundings<'_>, q: &Joints, within: f64) -> Option<NearView> {
    let (watch, found) = around.nearest(q, within)?;
    let place = found.place.filter(|_| found.distance < within)?;
    let (first, second) = around.solids(watch, &found)?;
    Some(NearView {
        distance_mm: found.distance,
        least_mm: around.scene().watches().get(watch)?.least_mm(),
        between: [first, second],
        at: [place.on_a.to_array(), place.on_b.to_array()],
    })
}
