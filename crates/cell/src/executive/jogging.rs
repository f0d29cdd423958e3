//! Jogging: the hand on the keys, within the cell's cycle.

use super::bus::Devices;
use super::core::Doing;
use super::mode::{Event, Mode};
use super::state::Port;
use super::work::Work;
use super::{Alarm, Executive};
use seamwright_machine::{Joints, Level, Machine, Surroundings};
use seamwright_motion::jog::{self, Halt, Jog, JogSettings, Signals};

/// Without a sign of life from the panel for this long the axes stop, s.
const SILENCE_S: f64 = 0.2;

/// Highest speed of the torch's tip by hand, mm/s (ISO 10218-1, reduced speed).
pub const REDUCED_MM_S: f64 = 250.0;

/// A command of the hand with the tip no faster than [`REDUCED_MM_S`] from axis positions `q`.
fn reduced(machine: &Machine, q: &Joints, command: jog::Command) -> jog::Command {
    match command {
        jog::Command::Speeds(speeds) => {
            // What the tip can move until the panel would be silent.
            let by = speeds.map(|speed| speed * SILENCE_S);
            let part = (REDUCED_MM_S * SILENCE_S / machine.tip_travel(q, &by)).min(1.0);
            jog::Command::Speeds(speeds.map(|speed| speed * part))
        }
        jog::Command::Tip { frame, velocity } => {
            jog::Command::Tip { frame, velocity: velocity.clamp_length_max(REDUCED_MM_S) }
        }
        other => other,
    }
}

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Jogs until the mode ends; at rest when it returns, unless power has gone.
    pub(super) fn jog_on(&mut self, around: Option<&Surroundings<'_>>, work: Option<&Work<'_>>) {
        let mut start = Joints::default();
        start.iter_mut().zip(&self.orders.set).for_each(|(q, set)| *q = set.position);
        let settings =
            JogSettings { period_s: self.machine.servo_period_s, silence_s: SILENCE_S, ..JogSettings::default() };
        let machine = self.machine;
        let Ok(mut jog) = Jog::new(machine, around, &start, settings) else {
            self.happened(Alarm::JogStopped, 0);
            self.event(Event::Abort);
            return;
        };
        self.busy = true;
        let mut told = None;
        while matches!(self.mode, Mode::Jog | Mode::Teach) || !jog.state().rests() {
            let jogs = matches!(self.mode, Mode::Jog | Mode::Teach);
            let wanted = if jogs { self.jog } else { Some(jog::Command::Rest) };
            // At an override of 0 the keys do nothing.
            let wanted = wanted.filter(|_| !jogs || jog.set_override(self.pace).is_ok());
            if let Some(command) = wanted.map(|command| reduced(machine, &jog.state().q, command)) {
                // What cannot be is refused, and what was wanted before stays.
                jog.command(&command).ok();
            }
            let enabled = self.interlocks.unmet(Level::Motion, self.reports.inputs) == 0;
            let point = jog.step(&Signals { enabled, alive: self.jog.is_some(), hold: false });
            let state = point.state;
            self.set(&state.q, &state.speed, &state.acceleration);
            self.tick(Doing::default(), work);
            if point.halt != told {
                told = point.halt;
                match told {
                    Some(Halt::Silent) => self.happened(Alarm::PanelSilent, 0),
                    Some(_) => self.happened(Alarm::JogStopped, 0),
                    None => {}
                }
            }
            if !self.power {
                break;
            }
        }
        self.busy = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::shipped;

    /// Random speeds at random places: the tip, by differences, is never faster than the reduced speed, and slow ones stay.
    #[test]
    fn a_hand_never_moves_the_tip_faster() {
        let mut state = 7u64;
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
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
                let jog::Command::Speeds(slow) = reduced(&machine, &q, jog::Command::Speeds(speeds)) else { panic!() };
                let tip = |dt: f64| {
                    let mut moved = q;
                    moved.iter_mut().zip(slow).for_each(|(q, v)| *q += v * dt);
                    machine.forward(&moved).point
                };
                let speed = (tip(1e-4) - tip(-1e-4)).length() / 2e-4;
                assert!(speed <= REDUCED_MM_S * (1.0 + 1e-6), "{name}: {speed}");
                fastest = fastest.max(speed);
                let little = speeds.map(|v| v * 1e-3);
                assert_eq!(reduced(&machine, &q, jog::Command::Speeds(little)), jog::Command::Speeds(little));
            }
            assert!(fastest > 30.0, "{name}: {fastest}");
        }
    }
}
