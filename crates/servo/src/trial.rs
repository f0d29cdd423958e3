//! Short trial runs of a drive, as for the commissioning of a machine.

use crate::axis::ServoAxis;
use crate::drive::Drive;
use crate::error::Error;
use crate::parameters::DriveParameters;
use crate::position_loop::SetPoint;
use crate::response::{check_run_up, gentle};

/// Observation time of an oscillation (s), and the length of its windows (s).
const WATCHED_S: f64 = 10.0;
const WINDOW_S: f64 = 0.5;
/// An oscillation has ended when the speed is within this part of the set speed.
const STILL: f64 = 0.01;

/// Accelerates `drive` to `speed` (u/s, either sign) with the gentle acceleration.
fn run_up(drive: &mut Drive, period_s: f64, speed: f64) {
    let step = gentle(drive.parameters()) * period_s;
    for k in 0..(speed.abs() / step).ceil() as u64 {
        drive.step(speed.signum() * step * k as f64, 0.0, 0.0);
    }
}

/// Returns true if the velocity loop settles at `speed` (u/s) after a step of a fifth of it: oscillations of motor and
/// load decay.
pub(crate) fn settles(parameters: &DriveParameters, period_s: f64, speed: f64) -> Result<bool, Error> {
    check_run_up(parameters, speed)?;
    let mut drive = Drive::new(*parameters, period_s)?;
    run_up(&mut drive, period_s, 0.8 * speed);
    let window = (WINDOW_S / period_s).ceil() as u64;
    let mut swing = || {
        (0..window).fold(0.0_f64, |worst, _| {
            drive.step(speed, 0.0, 0.0);
            let off = |v: f64| (v - speed).abs();
            worst.max(off(drive.velocity())).max(off(drive.motor_velocity()))
        })
    };
    // The first window contains the step itself.
    swing();
    let first = swing();
    let mut last = first;
    for _ in 2..(WATCHED_S / WINDOW_S) as u32 {
        if last < STILL * speed {
            return Ok(true);
        }
        last = swing();
    }
    Ok(last < 0.5 * first)
}

/// Returns the mean of `value` over the second second at constant `speed` (u/s).
fn mean_at(
    parameters: &DriveParameters,
    period_s: f64,
    speed: f64,
    value: impl Fn(&Drive) -> f64,
) -> Result<f64, Error> {
    let mut drive = Drive::new(*parameters, period_s)?;
    run_up(&mut drive, period_s, speed);
    let count = (1.0 / period_s).ceil() as u64;
    let mut sum = 0.0;
    for k in 0..2 * count {
        drive.step(speed, 0.0, 0.0);
        sum += if k >= count { value(&drive) } else { 0.0 };
    }
    Ok(sum / count as f64)
}

/// Measures Coulomb friction (N or N m): the current at two constant speeds, one half of the other, extrapolated to
/// standstill.
pub(crate) fn friction(parameters: &DriveParameters, period_s: f64, speed: f64) -> Result<f64, Error> {
    let hold = |speed: f64| -> Result<f64, Error> {
        let current = mean_at(parameters, period_s, speed, Drive::mean_current)?;
        Ok(current * parameters.peak / parameters.per_force)
    };
    let coulomb = 2.0 * hold(0.5 * speed)? - hold(speed)?;
    // Less than a thousandth of the peak is not worth a feed-forward.
    Ok(if coulomb > 1e-3 * parameters.peak / parameters.per_force { coulomb } else { 0.0 })
}

/// Measures lost motion (u): the difference of the load's position at one encoder reading between both directions. A
/// dial gauge at the load shows it when the axis creeps at `speed` (u/s).
pub(crate) fn lost_motion(parameters: &DriveParameters, period_s: f64, speed: f64) -> Result<f64, Error> {
    let behind = |speed: f64| mean_at(parameters, period_s, speed, |drive| drive.measured() - drive.position());
    Ok(behind(speed)? - behind(-speed)?)
}

/// Following errors of an axis at constant speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Following {
    /// Maximum following error in the loop (counts).
    pub(crate) counts: f64,
    /// Maximum distance of the load from the set position (u).
    pub(crate) load: f64,
}

impl Following {
    fn worst(self, other: Self) -> Self {
        Self { counts: self.counts.max(other.counts), load: self.load.max(other.load) }
    }
}

/// Measures the following error over a second at constant `speed` (u/s). Before it come a smooth acceleration phase and
/// up to ten seconds until the axis is within one count.
pub(crate) fn following(axis: &ServoAxis, speed: f64) -> Following {
    let mut axis = *axis;
    let parameters = *axis.drive().parameters();
    let (period_s, count) = (axis.position_loop().period_s(), parameters.encoder().count());
    // Half a cosine, whose maximum acceleration is the gentle one.
    let ramp = std::f64::consts::FRAC_PI_2 * speed / gentle(&parameters);
    let ramp = ramp.max(0.1);
    let w = std::f64::consts::PI / ramp;
    let start = axis.drive().measured();
    let mut step = |k: u64| {
        let t = k as f64 * period_s;
        let set = if t < ramp {
            let (sine, cosine) = (w * t).sin_cos();
            SetPoint {
                position: start + 0.5 * speed * (t - sine / w),
                velocity: 0.5 * speed * (1.0 - cosine),
                acceleration: 0.5 * speed * w * sine,
            }
        } else {
            SetPoint { position: start + speed * (t - 0.5 * ramp), velocity: speed, acceleration: 0.0 }
        };
        let load = axis.step(set, 0.0).following_error.abs();
        Following { counts: axis.position_loop().error().abs() / count, load }
    };
    let (up, second) = ((ramp / period_s).ceil() as u64, (1.0 / period_s).ceil() as u64);
    (0..up).for_each(|k| {
        step(k);
    });
    let mut seconds =
        (0..11).map(|i| (0..second).map(|k| step(up + i * second + k)).fold(Following::default(), Following::worst));
    let mut worst = seconds.next().unwrap_or_default();
    for next in seconds {
        // The second after the settled one counts.
        let settled = worst.counts <= 1.0;
        worst = next;
        if settled {
            break;
        }
    }
    worst
}
