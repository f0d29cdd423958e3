//! Distance to singular attitudes, in which the rotary axes lose a degree of freedom of the torch's direction.

use crate::joint_path::JointPath;
use crate::speed_findings::Runs;
use glam::DVec3;
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine};
use seamwright_message::{Message, Unit};
use seamwright_program::Finding;

/// Number of samples along the path.
const PLACES: usize = 1440;
/// Attitudes closer than this to a singular one are reported, rad, if an axis uses more than
const NEAR: f64 = 15.0 * std::f64::consts::PI / 180.0;
/// this fraction of its limit.
const MUCH: f64 = 0.5;

/// Distance of the attitude at `q` from a singular one: the area that the rotations of the rotary axes in `of` span on
/// the sphere of directions, for two axes the sine of the angle between them. None with fewer than two such axes. For a
/// six-axis arm the smallest distance from its singularities.
pub(crate) fn distance(machine: &Machine, of: AxisSet, q: &Joints) -> Option<f64> {
    if let Some(margins) = machine.arm_margins(q) {
        return Some(margins.min());
    }
    let rotary = |i: usize| of.has(i) && machine.axes[i].kind == AxisKind::Rotary;
    if (0..machine.axes.len()).filter(|&i| rotary(i)).count() < 2 {
        return None;
    }
    let columns = machine.jacobian(q);
    let mut square = 0.0;
    for i in (0..machine.axes.len()).filter(|&i| rotary(i)) {
        let turned: DVec3 = columns[i].1;
        square += (0..i).filter(|&k| rotary(k)).map(|k| turned.cross(columns[k].1).length_squared()).sum::<f64>();
    }
    Some(square.sqrt())
}

/// Reports stretches near a singular attitude in which an axis uses much of its speed or acceleration. Each note gives
/// the speed that the axes could hold there. Infeasible speeds are findings of the speed profile.
pub(crate) fn margins(
    machine: &Machine,
    path: &JointPath,
    decided: AxisSet,
    asked: &dyn Fn(f64) -> f64,
    pass: usize,
) -> Vec<Finding> {
    let mut runs = Runs::default();
    for i in 0..=PLACES {
        let s = path.length() * i as f64 / PLACES as f64;
        let p = path.point(s, i == PLACES);
        let near = distance(machine, decided, &p.q).filter(|d| *d < NEAR.sin());
        let speeds = machine.axes.iter().enumerate().map(|(k, axis)| {
            let by_speed = axis.max_speed / p.d1[k].abs();
            (by_speed.min((axis.max_acceleration / p.d2[k].abs()).sqrt()), k)
        });
        let (holds, axis) = speeds.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0));
        let holds = holds * path.speed_rate(machine, s);
        let used = asked(s) / holds;
        runs.add(
            s,
            near.filter(|_| used > MUCH && used <= 1.0).map(|distance| {
                let message = Message::new("motion-near-singular")
                    .quantity("distance", distance.min(1.0).asin().to_degrees(), Unit::Deg, 1)
                    .axis("axis", machine.axes[axis].name.as_str())
                    .quantity("used", 100.0 * used, Unit::Percent, 0)
                    .quantity("asked", asked(s), Unit::MmPerS, 3)
                    .quantity("holds", holds, Unit::MmPerS, 3);
                (axis, used, message)
            }),
        );
    }
    runs.findings(|run| {
        let cure = Message::new("motion-cure-near-singular");
        Finding { allowed: true, ..Finding::error("singular", run.message.clone(), pass, run.stretch(), cure) }
    })
}
