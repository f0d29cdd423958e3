//! Repeatedly missed cycles, and the alarms that must be raised nevertheless.

use crate::common::{Script, in_mode, short, up, weld};
use seamwright_executive::devices::DeviceSet;
use seamwright_executive::realtime::{ManualTime, Paced, Pacer, TimeSource as _};
use seamwright_executive::{
    Alarm, Ask, Command, Cycle, Devices, Executive, Mode, Note, Orders, Port, Reports, Slack, Start, Status,
};
use seamwright_machine::Machine;
use seamwright_simulation::devices::{
    Device, Fault, FaultKind, Faulty, SimulatedDrives, SimulatedInputs, SimulatedSource, When as FaultTime,
    simulated_devices,
};
use std::time::Duration;

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

/// Devices on a manual clock, and a freeze of the cycle while the arc burns.
struct Freezing<D> {
    devices: D,
    time: ManualTime,
    /// The freeze that is to come, and the number of cycles with the arc before it.
    freeze: Option<Duration>,
    burns: u32,
    /// Orders of each exchange after the freeze: the process, and the watchdog's late mark.
    after: Vec<(bool, bool)>,
}

impl<D: Devices> Devices for Freezing<D> {
    fn exchange(&mut self, orders: &Orders, reports: &mut Reports) {
        self.devices.exchange(orders, reports);
        if self.freeze.is_none() {
            self.after.push((orders.process.on, orders.watchdog.late));
        }
        self.burns += u32::from(reports.source.burning);
        if self.burns > 500
            && let Some(freeze) = self.freeze.take()
        {
            self.time.advance(freeze);
        }
    }

    fn rides_out(&self) -> Slack {
        self.devices.rides_out()
    }

    fn drives_late_s(&self) -> f64 {
        self.devices.drives_late_s()
    }
}

fn freezing(machine: &Machine, freeze: Duration) -> Paced<Freezing<impl Devices + use<>>, ManualTime> {
    let (time, devices) = (ManualTime::default(), simulated_devices(machine, 1).unwrap());
    let devices = Freezing { devices, time: time.clone(), freeze: Some(freeze), burns: 0, after: Vec::new() };
    Paced::new(devices, machine, Pacer::by(time, machine.servo_period_s))
}

/// A process that is frozen while it welds, or a computer that is suspended: the first orders after it take the process
/// off, and nothing brings it back. Alarm 19 has the length of the gap. The watchdog stands still until the cell is
/// reset.
#[test]
fn a_frozen_weld_goes_off_and_stays_off() {
    let planned = short();
    let machine = &planned.machine;
    for ms in [300, 2000, 5000, 10_000, 3_600_000] {
        let freeze = Duration::from_millis(ms);
        let mut paced = freezing(machine, freeze);
        let mut lines = up();
        lines.extend(weld());
        lines.extend([(in_mode(Mode::Fault), Ask::Acknowledge)]);
        lines.extend((0..2000).map(|_| (in_mode(Mode::Fault), Ask::Reset)));
        let mut script = FreezeScript { script: Script::new(lines), ends_after: 500, rested: 0 };
        Executive::new(machine, &mut paced, &mut script).serve(Some(&planned.work(Start::at_home(&planned.motion))));
        let notes = &script.script.notes;
        let alarms: Vec<_> =
            notes.iter().filter_map(|n| if let Note::Alarm(raised) = n { Some(*raised) } else { None }).collect();
        assert_eq!(alarms[0].alarm, Alarm::Overrun, "{alarms:?}");
        let gap_s = alarms[0].gap_s.unwrap();
        assert!((gap_s - freeze.as_secs_f64()).abs() <= 2.0 * machine.servo_period_s, "{gap_s} s of {ms} ms");
        let about = alarms[0].about(&[], &[]).unwrap().to_string();
        assert!(alarms[0].cause().to_string().contains(&about), "{about}: {}", alarms[0].cause());
        assert_eq!(script.script.modes().last(), Some(&Mode::Off));
        let after = &paced.devices.after;
        assert!(after.iter().all(|(on, _)| !on), "{ms} ms: the process came back");
        // Late from the first orders until the reset, and on time again after it.
        let late = after.iter().filter(|(_, late)| *late).count();
        assert!(late > 1 && after[..late].iter().all(|(_, late)| *late), "{late} of {}", after.len());
        assert!(after.len() > late + 400);
    }
}

/// Gaps that the drives tolerate do not end a weld.
#[test]
fn a_short_freeze_is_ridden_out() {
    let planned = short();
    let machine = &planned.machine;
    let mut paced = freezing(machine, Duration::from_millis(200));
    let mut lines = up();
    lines.extend(weld());
    lines.extend(crate::common::down());
    let mut script = Script::new(lines);
    Executive::new(machine, &mut paced, &mut script).serve(Some(&planned.work(Start::at_home(&planned.motion))));
    assert!(!script.notes.iter().any(|n| matches!(n, Note::Alarm(_))), "{:?}", script.notes);
    assert!(paced.devices.after.iter().all(|(_, late)| !late));
}

/// Ages of silent devices, with a plan of faults before them, follow the clock over random gaps.
#[test]
fn silent_devices_age_by_the_clock() {
    let planned = short();
    let machine = &planned.machine;
    let period = machine.servo_period_s;
    let silent = |device| {
        [Fault { device, kind: FaultKind::Silent, when: FaultTime::At(0.1), lasts_s: f64::INFINITY, which: 0 }]
    };
    let time = ManualTime::default();
    let devices = DeviceSet {
        drives: Faulty::new(SimulatedDrives::new(machine, 1).unwrap(), Device::Drives, &silent(Device::Drives), period),
        source: Faulty::new(SimulatedSource::new(1, period), Device::Source, &silent(Device::Source), period),
        inputs: Faulty::new(SimulatedInputs::all_met(machine), Device::Inputs, &silent(Device::Inputs), period),
    };
    let mut paced = Paced::new(devices, machine, Pacer::by(time.clone(), period));
    let (orders, mut reports) = (Orders::default(), Reports::default());
    let mut state = 5u64;
    let mut silent_since = None;
    for k in 0..3000u32 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if state >> 60 == 0 {
            time.advance(Duration::from_millis((state >> 33) % 5000));
        }
        paced.exchange(&orders, &mut reports);
        let now = time.now();
        let since = *silent_since.get_or_insert(now);
        if reports.drives.age_s <= 0.0 {
            assert!(k < 110, "the drives report");
            silent_since = Some(now);
            continue;
        }
        let elapsed_s = now.since(since).as_secs_f64();
        for age_s in [reports.drives.age_s, reports.source.age_s, reports.inputs_age_s] {
            assert!((age_s - elapsed_s).abs() <= 1.01 * period, "cycle {k}: {age_s} s instead of {elapsed_s} s");
        }
    }
    assert!(reports.drives.age_s > 60.0);
}

/// Ends the executive a while after it came to rest.
struct FreezeScript<'a> {
    script: Script<'a>,
    ends_after: u32,
    rested: u32,
}

impl Port for FreezeScript<'_> {
    fn command(&mut self, t: f64) -> Option<Command> {
        let command = self.script.command(t);
        if self.rested > self.ends_after { Some(Command::of(Ask::Quit)) } else { command }
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        // The script's own clock has a limit that a suspend exceeds.
        let status = Status { t: cycle.t % 100.0, ..cycle.status };
        self.script.show(&Cycle { status, ..*cycle });
        let rests = cycle.mode == Mode::Off && self.script.next > 4;
        self.rested = if rests { self.rested + 1 } else { 0 };
    }

    fn note(&mut self, t: f64, note: Note) {
        self.script.note(t, note);
    }
}
