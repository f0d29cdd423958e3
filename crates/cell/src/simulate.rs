use crate::drives::Drives;
use crate::summary::{Summary, Tally};
use crate::{Error, Sample};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::{PassMotion, SetPoint};
use seamwright_program::TorchPath;

/// Plays `motion` on simulated drives, one set-point a servo period, and shows every period's [`Sample`] to `observer`.
///
/// The observer's errors end the simulation. The same seed gives the same weld, bit for bit.
///
/// # Errors
/// [`Error::Drive`] if the machine file's drive values make no drive; the observer's error.
pub fn simulate<E: From<Error>>(
    machine: &Machine,
    path: &dyn TorchPath,
    motion: &PassMotion,
    seed: u64,
    mut observer: impl FnMut(&Sample) -> Result<(), E>,
) -> Result<Summary, E> {
    let mut drives = Drives::new(machine, seed)?;
    let mut tally = Tally::new(machine.axes.len(), motion);
    drives.settle_at(&motion.path.at(0.0)[..machine.axes.len()]);
    let mut last_s = None;
    for set in motion.set_points(machine.servo_period_s) {
        let rates = set.rates(motion);
        let mut sample = Sample {
            set,
            q: Joints::default(),
            following_error: Joints::default(),
            current: Joints::default(),
            tip_s: 0.0,
            tip_speed: 0.0,
            planned_speed: 0.0,
            path_error: 0.0,
            attitude_error: 0.0,
        };
        for i in 0..machine.axes.len() {
            let state = drives.step(i, servo_set_point(&set, &rates, i));
            sample.q[i] = state.position;
            sample.following_error[i] = state.following_error;
            sample.current[i] = state.current;
        }
        measure(machine, path, &mut sample);
        if let Some((tip_s, set_s)) = last_s {
            sample.tip_speed = (sample.tip_s - tip_s) / machine.servo_period_s;
            sample.planned_speed = (set.law.s - set_s) / machine.servo_period_s;
        }
        last_s = Some((sample.tip_s, set.law.s));
        tally.add(&sample, &rates);
        observer(&sample)?;
    }
    Ok(tally.finish(machine, motion, seed))
}

fn servo_set_point(set: &SetPoint, rates: &(Joints, Joints), i: usize) -> seamwright_servo::SetPoint {
    seamwright_servo::SetPoint { position: set.q[i], velocity: rates.0[i], acceleration: rates.1[i] }
}

/// Finds the seam's point nearest to the true tip and how far the tip is from it.
fn measure(machine: &Machine, path: &dyn TorchPath, sample: &mut Sample) {
    let tip = machine.forward(&sample.q);
    let s = path.foot(tip.point, sample.set.law.s, (0.0, path.length()));
    let there = path.pose(s);
    sample.tip_s = s;
    let off = tip.point - there.point;
    let along = path.tangent(s);
    sample.path_error = (off - off.dot(along) * along).length();
    sample.attitude_error = angle(&tip, &there);
}

fn angle(a: &Pose, b: &Pose) -> f64 {
    2.0 * (a.direction - b.direction).length().atan2((a.direction + b.direction).length())
}
