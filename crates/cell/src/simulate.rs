use crate::drives::Drives;
use crate::summary::{Summary, Tally};
use crate::{Error, Sample};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::corners::foot_in_blend;
use seamwright_motion::{PassMotion, SetPoint, WeldMotion};
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
            let planned = &motion.passes[pass - 1];
            measure(machine, paths[pass - 1], planned, &mut sample);
            match last.filter(|l| l.pass == pass) {
                Some(last) => {
                    let way = |from: f64, to: f64| (to - from) * planned.path.speed_rate(machine, 0.5 * (from + to));
                    sample.tip_speed = way(last.tip_s, sample.tip_s) / machine.servo_period_s;
                    sample.planned_speed = way(last.set.law.s, set.law.s) / machine.servo_period_s;
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

/// Finds the place of the planned path nearest to the true tip, and how far the tip is from the seam.
fn measure(machine: &Machine, path: &dyn TorchPath, planned: &PassMotion, sample: &mut Sample) {
    let tip = machine.forward(&sample.q);
    let whole = (0.0, path.length());
    // Where the planned path is blended it is not the seam: a place on the seam would jump at the corner.
    let s = match planned.path.blends().is_empty() {
        // A tip may stand still or turn back while the axes go on: they tell the place.
        _ if path.is_timed() => planned.path.foot(machine, &sample.q, sample.set.law.s),
        true => path.foot(tip.point, sample.set.law.s, whole),
        false => planned.tip_path(machine).foot(tip.point, sample.set.law.s, whole),
    };
    sample.tip_s = s;
    let along = path.tangent(s);
    let woven = planned.path.is_woven();
    let errors = |tip: &Pose, pose: &dyn Fn(f64) -> Pose| match foot_in_blend(&planned.path, pose, tip.point, s) {
        _ if path.is_timed() => (tip.point.distance(pose(s).point), angle(tip, &pose(s))),
        Some(foot) => (tip.point.distance(pose(foot).point), angle(tip, &pose(foot))),
        None if woven => {
            let foot = nearest(|s| pose(s).point, tip.point, sample.set.law.s, whole);
            (tip.point.distance(pose(foot).point), angle(tip, &pose(foot)))
        }
        None => {
            let off = tip.point - pose(s).point;
            ((off - off.dot(along) * along).length(), angle(tip, &pose(s)))
        }
    };
    (sample.path_error, sample.attitude_error) = errors(&tip, &|s| path.pose(s));
    // Of two torches the one that is farther off counts.
    if path.second(s).is_some() {
        let second = errors(&machine.forward_of(1, &sample.q), &|s| path.second(s).unwrap_or_else(|| path.pose(s)));
        sample.path_error = sample.path_error.max(second.0);
        sample.attitude_error = sample.attitude_error.max(second.1);
    }
}

/// Where the path that `place` goes along, near `guess`, is nearest to `point`: from there both ways while it comes
/// nearer, in steps that the distance there allows and that grow, then by thirds. What is found is never nearer than
/// the nearest.
fn nearest(place: impl Fn(f64) -> DVec3, point: DVec3, guess: f64, (from, to): (f64, f64)) -> f64 {
    let away = |s: f64| place(s).distance_squared(point);
    let start = away(guess);
    let mut best = (start, guess, start.sqrt() / 16.0);
    for sense in [-1.0, 1.0] {
        let (mut s, mut step, mut last) = (guess, start.sqrt() / 16.0, start);
        while let next = (s + sense * step).clamp(from, to)
            && (next - s).abs() > 0.0
            && away(next) < last
        {
            (s, last) = (next, away(next));
            if last < best.0 {
                best = (last, s, step);
            }
            step *= 1.5;
        }
    }
    let (mut low, mut high) = ((best.1 - best.2).max(from), (best.1 + 1.5 * best.2).min(to));
    if best.1 < guess {
        (low, high) = ((best.1 - 1.5 * best.2).max(from), (best.1 + best.2).min(to));
    }
    for _ in 0..24 {
        let [a, b] = [low + (high - low) * 0.4, low + (high - low) * 0.6];
        if away(a) < away(b) { high = b } else { low = a }
    }
    let found = 0.5 * (low + high);
    if away(found) < best.0 { found } else { best.1 }
}

fn angle(a: &Pose, b: &Pose) -> f64 {
    2.0 * (a.direction - b.direction).length().atan2((a.direction + b.direction).length())
}
