//! Homing: the drives find their references, then axes go home in the order of the machine file.

use super::bus::Devices;
use super::core::Doing;
use super::jogging::obey;
use super::mode::{Event, Mode};
use super::state::{Missing, Port};
use super::work::Work;
use super::{Alarm, Executive};
use seamwright_machine::{Joints, Level};
use seamwright_motion::jog::{self, Jog, Signals};

/// Least time for finding the references, s: old ones have to be forgotten first.
const HOMING_LEAST_S: f64 = 0.1;
/// Longest time for finding the references, s.
const HOMING_S: f64 = 120.0;
/// How often an axis on its way home is told where to and how fast, s.
const SAID_S: f64 = 0.05;
/// An axis this near to its home position, mm or rad, and this slow, mm/s or rad/s, is there.
const THERE: f64 = 1e-6;
/// An axis this near to its home position is at home, mm or rad.
const AT_HOME: f64 = 0.01;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Looks for the references until they are known; the drives move the axes then, and say where they are. After that axes go
    /// home.
    pub(super) fn home(&mut self, work: Option<&Work<'_>>) {
        if let Some(axis) = self.homes_one.take() {
            return self.send_home(&[axis], work);
        }
        let begun = self.now();
        let mut found = false;
        while self.mode == Mode::Homing && !found {
            self.orders.home = true;
            self.rest_at_actual();
            self.tick(Doing::default(), work);
            let took = self.now() - begun;
            found = self.unreferenced() == 0 && took > HOMING_LEAST_S;
            if took > HOMING_S && !found {
                self.happened(Alarm::NoReference, 0);
                self.event(Event::Abort);
            }
        }
        // Where a reference is found positions change their meaning: what is held from here on is where the axes say they are.
        self.orders.home = false;
        self.take_actual();
        if self.mode != Mode::Homing {
            return;
        }
        let machine = self.machine;
        self.send_home(&machine.home_order, work);
    }

    /// The axis of this number, if it may go home alone.
    ///
    /// # Errors
    /// [`Missing::References`] where one is not known: the drives find them together. [`Missing::HomesFirst`] where another axis of
    /// the machine file's order comes first and is not at home. [`Missing::Value`]: there is no such axis.
    pub(super) fn home_one(&self, axis: u8) -> Result<usize, Missing> {
        let one = usize::from(axis);
        if one >= self.machine.axes.len() {
            return Err(Missing::Value);
        }
        if self.unreferenced() != 0 {
            return Err(Missing::References(self.unreferenced()));
        }
        let order = &self.machine.home_order;
        let before = order.iter().position(|named| *named == one).unwrap_or(0);
        let home = self.machine.home();
        let away = |axis: usize| (self.orders.set[axis].position - home[axis]).abs() > AT_HOME;
        let first = order[..before].iter().copied().find(|&axis| away(axis));
        first.map_or(Ok(one), |axis| Err(Missing::HomesFirst(axis as u8)))
    }

    /// Sends axes to their home positions, one after another; then homing is over.
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

    /// Axis after axis to its home position, as by hand: slowly, clear of everything, and back at rest whatever comes.
    fn go_home(&mut self, jog: &mut Jog<'_>, axes: &[usize], work: Option<&Work<'_>>) {
        let machine = self.machine;
        let mut target = Joints::default();
        target.iter_mut().zip(&self.orders.set).for_each(|(q, set)| *q = set.position);
        if !jog.begin(&target) {
            return self.refuse_jog();
        }
        self.busy = true;
        let home = machine.home();
        let mut axes = axes.iter();
        let mut goes = axes.next();
        let mut said = None;
        while goes.is_some() || !jog.state().rests() {
            let wants = goes.filter(|_| self.mode == Mode::Homing);
            // Said again now and then, for another place and override; what is planned in every cycle anew may never end.
            if said.is_none_or(|(axis, until)| axis != wants || self.now() >= until) {
                let command = wants.map_or(jog::Command::Rest, |&axis| {
                    target[axis] = home[axis];
                    jog::Command::To(target)
                });
                obey(jog, machine, self.pace, command);
                said = Some((wants, self.now() + SAID_S));
            }
            let enabled = self.interlocks.unmet(Level::Motion, self.reports.inputs) == 0;
            let point = jog.step(&Signals { enabled, alive: true, hold: false });
            self.set(&point.state.q, &point.state.speed, &point.state.acceleration);
            self.tick(Doing::default(), work);
            if !self.power {
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
        self.busy = false;
    }
}

/// The axis has come to its place; what is left of its speed by rounding ends with the next order.
fn is_there(state: &jog::State, axis: usize, place: f64) -> bool {
    (state.q[axis] - place).abs() < THERE && state.speed[axis].abs() < THERE
}
