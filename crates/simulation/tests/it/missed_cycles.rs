//! Repeatedly missed cycles, and the alarms that must be raised nevertheless.

use crate::common::{Script, in_mode, short, up, weld};
use seamwright_executive::{Alarm, Ask, Devices, Executive, Mode, Note, Orders, Reports, Slack, Start};
use seamwright_machine::Machine;
use seamwright_simulation::devices::simulated_devices;

/// Devices whose cycle misses some periods each time, and whose inputs may die.
struct Gappy<D> {
    devices: D,
    period_s: f64,
    /// Number of exchanges between losses, and cycles missed in each.
    every: u32,
    lost: u32,
    exchanges: u32,
    slack: Option<Slack>,
    /// Time for which the arc burns before the inputs die, s; infinite if they live.
    dies_after_s: f64,
    burns_s: f64,
    /// Age of the inputs since they died, s.
    age_s: Option<f64>,
}

impl<D: Devices> Devices for Gappy<D> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        self.devices.exchange(orders, reports);
        self.exchanges += 1;
        reports.missed = if self.exchanges.is_multiple_of(self.every) { self.lost } else { 0 };
        let passed = f64::from(1 + reports.missed) * self.period_s;
        if reports.source.burning {
            self.burns_s += passed;
        }
        if self.burns_s > self.dies_after_s {
            reports.inputs_age_s = self.age_s.unwrap_or(0.0) + passed;
            // Age at which the arc was ordered off.
            if orders.process.on {
                self.age_s = Some(reports.inputs_age_s);
            }
        }
    }

    fn rides_out(&self) -> Slack {
        self.slack.unwrap_or(self.devices.rides_out())
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }
}

fn gappy(machine: &Machine, lost: u32, every: u32) -> Gappy<impl Devices + use<>> {
    let devices = simulated_devices(machine, 1).unwrap();
    Gappy {
        devices,
        period_s: machine.servo_period_s,
        every,
        lost,
        exchanges: 0,
        slack: None,
        dies_after_s: f64::INFINITY,
        burns_s: 0.0,
        age_s: None,
    }
}

/// Inputs, including the emergency stop, die in a weld on a desktop that misses some cycles in each fifty
/// milliseconds. The arc is off as soon as without missed cycles, and the drives tolerate every loss.
#[test]
fn dead_inputs_end_a_weld_although_cycles_are_missed_all_the_time() {
    let planned = short();
    let machine = &planned.machine;
    let cycles = |s: f64| (s / machine.servo_period_s).round() as u32;
    let mut devices = Gappy { dies_after_s: 1.0, ..gappy(machine, cycles(0.005), cycles(0.045)) };
    let mut lines = up();
    lines.extend(weld());
    // Refused until everything has come to rest.
    lines.extend((0..5000).map(|_| (in_mode(Mode::Fault), Ask::Quit)));
    let mut script = Script::new(lines);
    Executive::new(machine, &mut devices, &mut script).serve(Some(&planned.work(Start::at_home(&planned.motion))));
    let raised = |alarm: Alarm| script.notes.iter().any(|n| matches!(n, Note::Alarm(raised) if raised.alarm == alarm));
    assert!(raised(Alarm::InputsSilent) && !raised(Alarm::Overrun), "{:?}", script.notes);
    let age_s = devices.age_s.unwrap();
    assert!(age_s < 0.2, "the arc burns {age_s} s after the inputs died");
}

#[test]
fn too_many_missed_cycles_are_noted_once() {
    let planned = short();
    let machine = &planned.machine;
    let mut devices = Gappy { slack: Some(Slack::stored(3)), ..gappy(machine, 5, 10) };
    let mut script = Script::new(vec![(Box::new(|c| c.t > 1.0), Ask::Quit)]);
    Executive::new(machine, &mut devices, &mut script).serve(None);
    assert_eq!(script.notes.iter().filter(|n| matches!(n, Note::Missed(..))).count(), 1, "{:?}", script.notes);
}
