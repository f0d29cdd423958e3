//! "Why can't I start": the missing permissives of an action.

use super::alarm::{Alarm, Reaction};
use super::core::Executive;
use super::device_interface::{Devices, LATE_S};
use super::missing_permissive::{Missing, SilentDevice};
use super::mode::{Event, Mode};
use super::port::Port;
use super::work::Work;
use arrayvec::ArrayVec;
use seamwright_machine::Level;

/// Distance within which an axis counts as at home, mm or rad.
const AT_HOME: f64 = 0.01;
/// Maximum distance of an axis from the start of the approach, mm or rad.
const AT_START: f64 = 0.01;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Returns the missing permissives of `event`: "why can't I start".
    pub fn missing(&self, event: Event, work: Option<&Work<'_>>) -> ArrayVec<Missing, 32> {
        let mut missing = ArrayVec::new();
        // Drop those beyond the capacity; the first ones suffice.
        let mut add = |m: Missing| missing.try_push(m).unwrap_or_default();
        if let Err(refused) = self.mode.after(event) {
            add(Missing::Mode(refused));
        }
        let level = match event {
            Event::SwitchOn | Event::SwitchOff => Level::Power,
            Event::Home | Event::Jog | Event::Teach | Event::DryRun => Level::Motion,
            Event::Weld => Level::Process,
            Event::Reset => {
                if self.activity.busy {
                    add(Missing::Moving);
                }
                self.standing().for_each(|(alarm, detail)| add(Missing::Alarm(alarm, detail)));
                return missing;
            }
            _ => return missing,
        };
        if self.activity.busy && self.mode != Mode::Hold {
            add(Missing::Moving);
        }
        if event == Event::SwitchOff {
            return missing;
        }
        let silent = |age_s: f64| age_s.is_nan() || age_s > LATE_S;
        for (device, age_s, needed) in [
            (SilentDevice::Drives, self.io.reports.drives.age_s, true),
            (SilentDevice::Inputs, self.io.reports.inputs_age_s, true),
            (SilentDevice::Source, self.io.reports.source.age_s, event == Event::Weld),
        ] {
            if needed && silent(age_s) {
                add(Missing::Silent(device));
            }
        }
        if event != Event::SwitchOn {
            if !self.io.is_powered() {
                add(Missing::Power);
            }
            if event != Event::Home && self.io.unreferenced() != 0 {
                add(Missing::References(self.io.unreferenced()));
            }
        }
        let unmet = self.supervision.interlocks.unmet(level, self.io.reports.inputs);
        (0..64u8).filter(|i| unmet >> i & 1 == 1).for_each(|i| add(Missing::Condition(i)));
        for raised in self.alarms.iter().filter(|r| r.reaction > Reaction::Tell) {
            add(Missing::Alarm(raised.alarm, raised.detail));
        }
        if matches!(event, Event::DryRun | Event::Weld) && self.mode != Mode::Hold {
            match work.filter(|work| !work.passes.is_empty()) {
                None => add(Missing::Work),
                Some(work) => self.off_start(work).into_iter().for_each(|axis| add(Missing::NotAtStart(axis))),
            }
        }
        if event == Event::Weld {
            if !self.io.reports.source.ready || self.io.reports.source.fault != 0 {
                add(Missing::Source);
            }
            if !self.process.is_armed(self.now()) {
                add(Missing::Arming);
            }
        }
        missing
    }

    /// Returns the index of `axis`, if it may go home alone. Errors: [`Missing::References`] if one is unknown: the
    /// drives find them together. [`Missing::HomesFirst`] if another axis comes first in the machine file's order and
    /// is not at home. [`Missing::Value`] if the axis does not exist.
    pub(super) fn home_one(&self, axis: u8) -> Result<usize, Missing> {
        let one = usize::from(axis);
        if one >= self.machine.axes.len() {
            return Err(Missing::Value);
        }
        if self.io.unreferenced() != 0 {
            return Err(Missing::References(self.io.unreferenced()));
        }
        let order = &self.machine.home_order;
        let before = order.iter().position(|named| *named == one).unwrap_or(0);
        let home = self.machine.home();
        let away = |axis: usize| (self.io.orders.set[axis].position - home[axis]).abs() > AT_HOME;
        let first = order[..before].iter().copied().find(|&axis| away(axis));
        first.map_or(Ok(one), |axis| Err(Missing::HomesFirst(axis as u8)))
    }

    /// Returns the alarms that keep the cell in fault: their causes are active.
    fn standing(&self) -> impl Iterator<Item = (Alarm, u8)> {
        let there = self.alarms.iter().filter(|r| r.reaction >= Reaction::Stop);
        there.filter(|r| self.alarms.is_active(r.alarm, r.detail)).map(|r| (r.alarm, r.detail))
    }

    /// Returns the axis farthest from the start of the approach, if it is out of tolerance.
    fn off_start(&self, work: &Work<'_>) -> Option<u8> {
        let start = work.start.approach.legs.first().map(|leg| *leg.start());
        let start = start.or_else(|| Some(work.passes.get(work.start.pass)?.planned.path.at(work.start.welded_mm)))?;
        let off = |i: usize| (self.io.orders.set[i].position - start[i]).abs();
        let worst = (0..self.machine.axes.len()).max_by(|a, b| off(*a).total_cmp(&off(*b)))?;
        // A NaN position is out of tolerance.
        let there = off(worst) <= AT_START;
        (!there).then_some(worst as u8)
    }
}
