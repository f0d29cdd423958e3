//! Jogging: the hand on the keys, within the cell's cycle.

use super::bus::Devices;
use super::core::Doing;
use super::mode::{Event, Mode};
use super::state::Port;
use super::work::Work;
use super::{Alarm, Executive};
use seamwright_machine::{Joints, Level, Surroundings};
use seamwright_motion::jog::{self, Halt, Jog, JogSettings, Signals};

/// Without a sign of life from the panel for this long the axes stop, s.
const SILENCE_S: f64 = 0.2;

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
            if let Some(command) = wanted {
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
