//! Inclination of the weld against gravity and angles of the torch along a planned pass.

use super::planned_pass::PlannedPass;
use crate::joint_path::PLACES;
use seamwright_program::{Inclination, TorchPath};

pub(super) struct Lie {
    pub(super) s: f64,
    pub(super) inclination: Inclination,
    /// Travel angle, and work angle if the faces are known, degrees.
    pub(super) travel: f64,
    pub(super) work: Option<f64>,
}

/// Samples at evenly spaced path lengths and at the path's knots.
pub(super) fn along(planned: PlannedPass) -> Vec<Lie> {
    let path = planned.path;
    let length = path.length();
    let mut places: Vec<f64> = (0..=PLACES).map(|i| length * i as f64 / PLACES as f64).collect();
    places.extend(path.knots());
    places.sort_by(f64::total_cmp);
    places.dedup();
    places.into_iter().map(|s| at(planned, s)).collect()
}

/// Sample at path length `s`, with the axes at their planned positions.
pub(super) fn at(planned: PlannedPass, s: f64) -> Lie {
    let PlannedPass { machine, path, motion, .. } = planned;
    let q = motion.path.at(s);
    let groove = path.groove(s);
    let (face, tangent) = (path.face(s), groove.map_or_else(|| path.line(s).1, |g| g.tangent));
    let torch = -machine.forward(&q).direction;
    let along = torch.dot(tangent);
    Lie {
        s,
        inclination: Inclination::new(tangent, face, machine.up_in_work(&q)),
        travel: along.atan2(torch.cross(tangent).length()).to_degrees(),
        work: groove.map(|g| torch.dot(g.towards_first).atan2(torch.dot(face)).to_degrees()),
    }
}

/// Minimum and maximum angle between the faces, rad; those of a butt weld if unknown.
pub(super) fn dihedrals(path: &dyn TorchPath, lies: &[Lie]) -> (f64, f64) {
    let angles = lies.iter().filter_map(|lie| path.groove(lie.s)).map(|g| g.dihedral);
    let ends = angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, g), a| (l.min(a), g.max(a)));
    if ends.0 <= ends.1 { ends } else { (std::f64::consts::PI, std::f64::consts::PI) }
}
