//! "Why can't I start": the missing permissives of an action.

use super::bus::Devices;
use super::mode::{Event, Mode};
use super::state::{Missing, Port, SilentDevice};
use super::supervision::LATE_S;
use super::work::Work;
use super::{Alarm, Executive, Reaction};
use arrayvec::ArrayVec;
use seamwright_machine::Level;

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
                if self.busy {
                    add(Missing::Moving);
                }
                self.standing().for_each(|(alarm, detail)| add(Missing::Alarm(alarm, detail)));
                return missing;
            }
            _ => return missing,
        };
        if self.busy && self.mode != Mode::Hold {
            add(Missing::Moving);
        }
        if event == Event::SwitchOff {
            return missing;
        }
        let silent = |age_s: f64| age_s.is_nan() || age_s > LATE_S;
        for (device, age_s, needed) in [
            (SilentDevice::Drives, self.reports.drives.age_s, true),
            (SilentDevice::Inputs, self.reports.inputs_age_s, true),
            (SilentDevice::Source, self.reports.source.age_s, event == Event::Weld),
        ] {
            if needed && silent(age_s) {
                add(Missing::Silent(device));
            }
        }
        if event != Event::SwitchOn {
            if !(self.power && self.reports.drives.powered) {
                add(Missing::Power);
            }
            if event != Event::Home && self.unreferenced() != 0 {
                add(Missing::References(self.unreferenced()));
            }
        }
        let unmet = self.interlocks.unmet(level, self.reports.inputs);
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
            if !self.reports.source.ready || self.reports.source.fault != 0 {
                add(Missing::Source);
            }
            if !self.is_armed() {
                add(Missing::Arming);
            }
        }
        missing
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
        let off = |i: usize| (self.orders.set[i].position - start[i]).abs();
        let worst = (0..self.machine.axes.len()).max_by(|a, b| off(*a).total_cmp(&off(*b)))?;
        // A NaN position is out of tolerance.
        let there = off(worst) <= AT_START;
        (!there).then_some(worst as u8)
    }
}
