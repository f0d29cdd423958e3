//! Jogging with the enabling switch, within the cell's cycle.

use super::activity::Doing;
use super::alarm::Alarm;
use super::core::Executive;
use super::device_interface::Devices;
use super::mode::{Event, Mode};
use super::port::Port;
use super::reduced_speed::obey;
use super::work::Work;
use seamwright_machine::Level;
use seamwright_motion::jog::{self, Halt, Jog, Signals};

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Jogs until the mode ends; returns at rest, except after a loss of power.
    pub(super) fn jog_on(&mut self, work: Option<&Work<'_>>) {
        let mut hand = work.and_then(|work| work.hand.try_borrow_mut().ok());
        match hand.as_deref_mut() {
            Some(Some(jog)) => self.jog_with(jog, work),
            _ => self.refuse_jog(),
        }
    }

    pub(super) fn refuse_jog(&mut self) {
        self.happened(Alarm::JogStopped, 0);
        self.event(Event::Abort);
    }

    fn jog_with(&mut self, jog: &mut Jog<'_>, work: Option<&Work<'_>>) {
        let start = self.io.positions();
        if !jog.begin(&start) {
            return self.refuse_jog();
        }
        let machine = self.machine;
        self.activity.busy = true;
        let mut told = None;
        while matches!(self.mode, Mode::Jog | Mode::Teach) || !jog.state().rests() {
            let jogs = matches!(self.mode, Mode::Jog | Mode::Teach);
            if let Some(wanted) = if jogs { self.requests.jog } else { Some(jog::Command::Rest) } {
                obey(jog, machine, self.requests.feed_override, wanted);
            }
            let enabled = self.supervision.interlocks.unmet(Level::Motion, self.io.reports.inputs) == 0;
            // The panel is silent by the clock: missed cycles count.
            jog.add_silence(self.clock.last_s() - machine.servo_period_s);
            let point = jog.step(&Signals { enabled, alive: self.requests.jog.is_some(), hold: false });
            let state = point.state;
            self.io.set(&state.q, &state.speed, &state.acceleration);
            self.tick(Doing::default(), work);
            if point.halt != told {
                told = point.halt;
                match told {
                    Some(Halt::Silent) => self.happened(Alarm::PanelSilent, 0),
                    Some(_) => self.happened(Alarm::JogStopped, 0),
                    None => {}
                }
            }
            if !self.io.power {
                break;
            }
        }
        self.activity.busy = false;
    }
}
