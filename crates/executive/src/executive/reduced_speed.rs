//! Reduced speed of the torch tip while an operator jogs the axes.

use seamwright_machine::{Joints, Machine, Surroundings};
use seamwright_motion::jog::{self, Halt, Jog, JogError, JogSettings, Signals};
use std::cell::RefCell;

/// Time without a sign of life from the panel after which the axes stop, s.
const SILENCE_S: f64 = 0.2;

/// Maximum torch tip speed during jogging, mm/s (ISO 10218-1, reduced speed).
pub const REDUCED_MM_S: f64 = 250.0;

/// Maximum angular speed of the torch about its resting tip during jogging, rad/s: the flange of a torch of 500 mm then
/// moves at the reduced speed.
pub const REDUCED_RAD_S: f64 = 0.5;

/// Returns the factor of the axis `speeds` that keeps the tip within [`REDUCED_MM_S`] from positions `q`, for the time
/// until the panel counts as silent.
fn part(machine: &Machine, q: &Joints, speeds: &Joints) -> f64 {
    let by = speeds.map(|speed| speed * SILENCE_S);
    (REDUCED_MM_S * SILENCE_S / machine.tip_travel(q, &by)).min(1.0)
}

/// Prepares jogging before the first cycle; `None` for an invalid servo period.
pub(super) fn hand<'a>(machine: &'a Machine, around: Option<&'a Surroundings<'a>>) -> RefCell<Option<Jog<'a>>> {
    let settings = JogSettings { period_s: machine.servo_period_s, silence_s: SILENCE_S, ..JogSettings::default() };
    RefCell::new(Jog::prepared(machine, around, settings).ok())
}

/// Returns a jog command with the tip within [`REDUCED_MM_S`] from axis positions `q`, and the factor of the axis
/// speeds for that.
fn reduced(machine: &Machine, q: &Joints, command: jog::Command) -> (jog::Command, f64) {
    // Axes with a target may move at their maximum speed.
    let highest = |goes: &dyn Fn(usize) -> bool| {
        let mut speeds = Joints::default();
        machine.axes.iter().enumerate().filter(|(i, _)| goes(*i)).for_each(|(i, axis)| speeds[i] = axis.max_speed);
        speeds
    };
    match command {
        jog::Command::Speeds(speeds) => {
            let part = part(machine, q, &speeds);
            (jog::Command::Speeds(speeds.map(|speed| speed * part)), 1.0)
        }
        jog::Command::Tip { frame, velocity } => {
            (jog::Command::Tip { frame, velocity: velocity.clamp_length_max(REDUCED_MM_S) }, 1.0)
        }
        jog::Command::Turn { frame, velocity } => {
            (jog::Command::Turn { frame, velocity: velocity.clamp_length_max(REDUCED_RAD_S) }, 1.0)
        }
        jog::Command::To(target) => (command, part(machine, q, &highest(&|i| (target[i] - q[i]).abs() > 0.0))),
        jog::Command::Step { axis, .. } => (command, part(machine, q, &highest(&|i| i == axis))),
        jog::Command::Rest => (command, 1.0),
    }
}

/// Passes a command to `jog`, with the reduced speed and the feed override `feed_override` (0 to 1); at 0 the axes rest.
pub(super) fn obey(jog: &mut Jog<'_>, machine: &Machine, feed_override: f64, wanted: jog::Command) {
    let (command, part) = reduced(machine, &jog.state().q, wanted);
    let moves = jog.set_override(feed_override * part).is_ok();
    // An invalid command is refused, and the previous one stays.
    jog.command(if moves { &command } else { &jog::Command::Rest }).ok();
}

/// Period of a motion that is computed in advance, s: the proof of each set-point covers its period and stop, so a longer
/// period than the cell's is stricter.
const FORESEEN_PERIOD_S: f64 = 8e-3;
/// Time between renewed commands, s, as from a held key.
const RENEWED_S: f64 = 0.05;
/// Maximum duration of a motion that is computed in advance, s: any axis crosses its range in this time.
const MAX_FORESEEN_S: f64 = 300.0;

/// Distance of an axis from its target at which it has arrived, mm or rad.
const ARRIVED: f64 = 1e-6;

/// A motion to a target by hand, computed in advance.
#[derive(Debug, Clone, PartialEq)]
pub struct Foreseen {
    /// Positions on the way, evenly spaced in time, with the start and the end.
    pub way: Vec<Joints>,
    /// Duration, s.
    pub time_s: f64,
    /// Reason for an end before the target.
    pub halt: Option<Halt>,
}

/// Computes the motion of all axes from rest at `start` to `target` as the cell will jog it: with the same shield, and
/// with the torch tip within [`REDUCED_MM_S`]. Keeps about `samples` positions.
///
/// # Errors
/// A start that is out of range or not clear; a target out of range.
pub fn foresee(
    machine: &Machine,
    around: Option<&Surroundings<'_>>,
    start: &Joints,
    target: &Joints,
    samples: usize,
) -> Result<Foreseen, JogError> {
    let settings = JogSettings { period_s: machine.servo_period_s.max(FORESEEN_PERIOD_S), ..JogSettings::default() };
    let mut jog = Jog::new(machine, around, start, settings)?;
    jog.command(&jog::Command::To(*target))?;
    let renewed = (RENEWED_S / settings.period_s).ceil() as usize;
    let most = (MAX_FORESEEN_S / settings.period_s) as usize;
    let mut points = vec![*start];
    for cycle in 0..most {
        if cycle % renewed == 0 && jog.halt().is_none() {
            obey(&mut jog, machine, 1.0, jog::Command::To(*target));
        }
        jog.step(&Signals { enabled: true, alive: true, hold: false });
        points.push(jog.state().q);
        // Renewed commands may leave a motion of rounding at the target.
        let is_there = points[points.len() - 1].iter().zip(target).all(|(q, to)| (q - to).abs() < ARRIVED);
        if cycle > renewed && (is_there || jog.state().rests()) {
            break;
        }
    }
    let steps = points.len() - 1;
    let count = samples.clamp(1, steps.max(1));
    let way = (0..=count).map(|i| points[i * steps / count]).collect();
    Ok(Foreseen { way, time_s: steps as f64 * settings.period_s, halt: jog.halt() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DAffine3;
    use seamwright_clearance::{Shape, Solid};
    use seamwright_machine::{Clamped, shipped};

    /// The computed motion ends at the target; one into an obstacle ends before it, with the reason.
    #[test]
    fn a_motion_is_foreseen_to_its_target_or_to_what_stops_it() {
        let machine = Machine::read("m.toml", shipped("ur10e").unwrap().text).unwrap();
        let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
        let home = machine.home();
        let mut target = home;
        target[0] += 0.5;
        let clear = foresee(&machine, Some(&around), &home, &target, 20).unwrap();
        assert_eq!((clear.halt, clear.way.len(), clear.way[0]), (None, 21, home));
        let off = clear.way[20].iter().zip(target).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // 0.5 rad of an arm that reaches 0.9 m, at 250 mm/s.
        assert!(off <= ARRIVED && clear.time_s > 1.0 && clear.time_s < 10.0, "{off} {}", clear.time_s);
        // A ball at the target.
        let at = DAffine3::from_translation(machine.forward(&target).point);
        let ball = Solid::new("ball", Shape::Sphere { radius: 50.0 }, at).unwrap();
        let clamped = Clamped { part: vec![ball], least_mm: 1.0, ..Clamped::default() };
        let around = Surroundings::new(&machine, &clamped).unwrap();
        let stopped = foresee(&machine, Some(&around), &home, &target, 20).unwrap();
        assert!(matches!(stopped.halt, Some(Halt::TooNear(_))), "{:?}", stopped.halt);
        assert!(stopped.way.iter().all(|q| around.is_clear(q)));
        target[0] = 100.0;
        assert!(matches!(foresee(&machine, None, &home, &target, 20), Err(JogError::Range { .. })));
    }

    /// Uniform random numbers from 0 to 1.
    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 7u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    /// Random speeds at random positions: the tip speed, by differences, stays within the reduced speed. Slow ones do
    /// not change.
    #[test]
    fn a_hand_never_moves_the_tip_faster() {
        let mut random = numbers();
        for name in ["saddle-4axis", "torch-5axis", "ebw-7axis"] {
            let machine = Machine::read("m.toml", shipped(name).unwrap().text).unwrap();
            let mut fastest = 0.0f64;
            for _ in 0..1000 {
                let (mut q, mut speeds) = (Joints::default(), Joints::default());
                for (i, axis) in machine.axes.iter().enumerate() {
                    let (low, high) = axis.range.unwrap_or((-3.0, 3.0));
                    q[i] = low + (high - low) * (0.1 + 0.8 * random());
                    speeds[i] = axis.max_speed * (2.0 * random() - 1.0);
                }
                let (jog::Command::Speeds(slow), _) = reduced(&machine, &q, jog::Command::Speeds(speeds)) else {
                    panic!()
                };
                let tip = |dt: f64| {
                    let mut moved = q;
                    moved.iter_mut().zip(slow).for_each(|(q, v)| *q += v * dt);
                    machine.forward(&moved).point
                };
                let speed = (tip(1e-4) - tip(-1e-4)).length() / 2e-4;
                assert!(speed <= REDUCED_MM_S * (1.0 + 1e-6), "{name}: {speed}");
                fastest = fastest.max(speed);
                let little = speeds.map(|v| v * 1e-3);
                assert_eq!(reduced(&machine, &q, jog::Command::Speeds(little)).0, jog::Command::Speeds(little));
            }
            assert!(fastest > 30.0, "{name}: {fastest}");
        }
    }

    /// All axes arrive at their targets, also if the target changes on the way, and no set-point exceeds the reduced
    /// speed.
    #[test]
    fn a_hand_sends_the_axes_to_places_no_faster() {
        let mut random = numbers();
        for name in ["saddle-4axis", "torch-5axis", "ebw-7axis"] {
            let machine = Machine::read("m.toml", shipped(name).unwrap().text).unwrap();
            let period = 4e-3;
            let settings = JogSettings { period_s: period, silence_s: SILENCE_S, ..JogSettings::default() };
            let mut jog = Jog::new(&machine, None, &machine.home(), settings).unwrap();
            let (mut fastest, mut tip) = (0.0f64, machine.forward(&machine.home()).point);
            for k in 0..20 {
                let mut target = Joints::default();
                for (i, axis) in machine.axes.iter().enumerate() {
                    let (low, high) = axis.range.unwrap_or((-3.0, 3.0));
                    target[i] = low + (high - low) * random();
                }
                // Every third target is replaced on the way.
                let cycles = if k % 3 == 2 { 200 } else { 60_000 };
                for cycle in 0..cycles {
                    if cycle % 12 == 0 {
                        obey(&mut jog, &machine, 1.0, jog::Command::To(target));
                    }
                    let point = jog.step(&Signals { enabled: true, alive: cycle % 12 == 0, hold: false });
                    assert_eq!(point.halt, None, "{name}");
                    let next = machine.forward(&point.state.q).point;
                    fastest = fastest.max(next.distance(tip) / period);
                    tip = next;
                    if point.state.rests() && cycle > 10 {
                        break;
                    }
                }
                let off = jog.state().q.iter().zip(target).map(|(q, t)| (q - t).abs()).fold(0.0, f64::max);
                assert!(k % 3 == 2 || off < 1e-6, "{name}: {off}");
            }
            assert!(fastest > 30.0 && fastest <= REDUCED_MM_S * 1.001, "{name}: {fastest}");
        }
    }

    #[test]
    fn at_an_override_of_nothing_the_axes_stand() {
        let machine = Machine::read("m.toml", shipped("saddle-4axis").unwrap().text).unwrap();
        let mut jog = Jog::new(&machine, None, &machine.home(), JogSettings::default()).unwrap();
        let mut target = machine.home();
        target[0] += 1.0;
        for cycle in 0..3000 {
            obey(&mut jog, &machine, if cycle < 300 { 1.0 } else { 0.0 }, jog::Command::To(target));
            jog.step(&Signals { enabled: true, alive: true, hold: false });
        }
        let moved = jog.state().q[0] - machine.home()[0];
        assert!(jog.state().rests() && moved > 1e-4 && moved < 0.9, "{moved}");
    }
}
