//! Homing: the drives find their references, then axes go home in the order of the machine file.

use super::activity::Doing;
use super::alarm::Alarm;
use super::core::Executive;
use super::device_interface::Devices;
use super::mode::{Event, Mode};
use super::port::Port;
use super::reduced_speed::obey;
use super::work::Work;
use seamwright_machine::Level;
use seamwright_motion::jog::{self, Jog, Signals};

/// Minimum time to find the references, s: the drives must drop the old ones first.
const MIN_HOMING_S: f64 = 0.1;
/// Maximum time to find the references, s.
const HOMING_S: f64 = 120.0;
/// Interval between orders to an axis on its way home, s.
const SAID_S: f64 = 0.05;
/// Tolerance of arrival at the home position, mm or rad, and of rest, mm/s or rad/s.
const THERE: f64 = 1e-6;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Waits until all references are known; meanwhile the drives move the axes and report their positions. Then the
    /// axes go home.
    pub(super) fn home(&mut self, work: Option<&Work<'_>>) {
        if let Some(axis) = self.requests.homes_one.take() {
            return self.send_home(&[axis], work);
        }
        let begun = self.now();
        let mut found = false;
        while self.mode == Mode::Homing && !found {
            self.io.orders.home = true;
            self.rest();
            self.tick(Doing::default(), work);
            let took = self.now() - begun;
            found = self.io.unreferenced() == 0 && took > MIN_HOMING_S;
            if took > HOMING_S && !found {
                self.happened(Alarm::NoReference, 0);
                self.event(Event::Abort);
            }
        }
        // Positions change their meaning when a reference is found: hold the reported positions from here on.
        self.io.orders.home = false;
        self.io.take_actual();
        if self.mode != Mode::Homing {
            return;
        }
        self.send_home(&self.machine.home_order, work);
    }

    /// Sends axes to their home positions, one after another; then ends homing.
    fn send_home(&mut self, axes: &[usize], work: Option<&Work<'_>>) {
        let mut hand = work.and_then(|work| work.hand.try_borrow_mut().ok());
        match hand.as_deref_mut() {
            _ if axes.is_empty() => {}
            Some(Some(jog)) => self.go_home(jog, axes, work),
            _ => self.refuse_jog(),
        }
        if self.mode == Mode::Homing {
            self.event(Event::Homed);
        }
    }

    /// Jogs axis after axis to its home position: slowly, without collisions, and with a stop at rest in every case.
    fn go_home(&mut self, jog: &mut Jog<'_>, axes: &[usize], work: Option<&Work<'_>>) {
        let machine = self.machine;
        let mut target = self.io.positions();
        if !jog.begin(&target) {
            return self.refuse_jog();
        }
        self.activity.busy = true;
        let home = machine.home();
        let mut axes = axes.iter();
        let mut goes = axes.next();
        let mut said = None;
        while goes.is_some() || !jog.state().rests() {
            let wants = goes.filter(|_| self.mode == Mode::Homing);
            // Repeat the order at intervals, for a changed position or override; replanning in every cycle may never
            // arrive.
            if said.is_none_or(|(axis, until)| axis != wants || self.now() >= until) {
                let command = wants.map_or(jog::Command::Rest, |&axis| {
                    target[axis] = home[axis];
                    jog::Command::To(target)
                });
                obey(jog, machine, self.requests.feed_override, command);
                said = Some((wants, self.now() + SAID_S));
            }
            let enabled = self.supervision.interlocks.unmet(Level::Motion, self.io.reports.inputs) == 0;
            let point = jog.step(&Signals { enabled, alive: true, hold: false });
            self.io.set(&point.state.q, &point.state.speed, &point.state.acceleration);
            self.tick(Doing::default(), work);
            if !self.io.power {
                break;
            }
            if self.mode != Mode::Homing {
                goes = None;
            } else if point.halt.is_some() {
                self.refuse_jog();
            } else if goes.is_some_and(|&axis| is_there(&point.state, axis, home[axis])) {
                goes = axes.next();
            }
        }
        self.activity.busy = false;
    }
}

/// Returns true if the axis has arrived; the next order removes the rounding rest of its speed.
fn is_there(state: &jog::State, axis: usize, place: f64) -> bool {
    (state.q[axis] - place).abs() < THERE && state.speed[axis].abs() < THERE
}
