use crate::drives::Drives;
use crate::summary::{Summary, Tally};
use crate::{Error, Sample};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::{SetPoint, WeldMotion};
use seamwright_program::TorchPath;

/// Plays `motion`, whose passes follow `paths`, on simulated drives, one set-point a servo period, from the start of
/// the first weld to the end of the last, and shows every period's [`Sample`] to `observer`. A summary of each pass.
///
/// The observer's errors end the simulation. The same seed gives the same weld, bit for bit.
///
/// # Errors
/// [`Error::Drive`] if the machine file's drive values make no drive; the observer's error.
pub fn simulate<E: From<Error>>(
    machine: &Machine,
    paths: &[&dyn TorchPath],
    motion: &WeldMotion,
    seed: u64,
    mut observer: impl FnMut(&Sample) -> Result<(), E>,
) -> Result<Vec<Summary>, E> {
    let mut drives = Drives::new(machine, seed)?;
    let mut tallies: Vec<Tally> = motion.passes.iter().map(|p| Tally::new(machine.axes.len(), p)).collect();
    let mut last: Option<Sample> = None;
    let mut begun = 0.0;
    motion.play(machine.servo_period_s, false, |pass, set, rates| {
        let mut sample = Sample { pass, set, ..Sample::nowhere() };
        let first = last.is_none();
        if first {
            drives.settle_at(&set.q[..machine.axes.len()]);
        }
        for i in 0..machine.axes.len() {
            let state = drives.step(i, servo_set_point(&set, &rates, i));
            sample.q[i] = state.position;
            sample.following_error[i] = state.following_error;
            sample.current[i] = state.current;
        }
        if pass > 0 {
            measure(machine, paths[pass - 1], &mut sample);
            match last.filter(|l| l.pass == pass) {
                Some(last) => {
                    sample.tip_speed = (sample.tip_s - last.tip_s) / machine.servo_period_s;
                    sample.planned_speed = (set.law.s - last.set.law.s) / machine.servo_period_s;
                }
                None => {
                    begun = set.t;
                    (sample.tip_speed, sample.planned_speed) = (0.0, 0.0);
                }
            }
            tallies[pass - 1].add(&sample, &rates, set.t - begun);
        }
        last = Some(sample);
        observer(&sample)
    })?;
    let passes = tallies.into_iter().zip(&motion.passes);
    Ok(passes.map(|(tally, pass)| tally.finish(machine, pass, seed)).collect())
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
    let along = path.tangent(s);
    let beside = |tip: &Pose, there: &Pose| {
        let off = tip.point - there.point;
        (off - off.dot(along) * along).length()
    };
    sample.path_error = beside(&tip, &there);
    sample.attitude_error = angle(&tip, &there);
    // Of two torches the one that is farther off counts.
    if let Some(there) = path.second(s) {
        let tip = machine.forward_of(1, &sample.q);
        sample.path_error = sample.path_error.max(beside(&tip, &there));
        sample.attitude_error = sample.attitude_error.max(angle(&tip, &there));
    }
}

fn angle(a: &Pose, b: &Pose) -> f64 {
    2.0 * (a.direction - b.direction).length().atan2((a.direction + b.direction).length())
}
