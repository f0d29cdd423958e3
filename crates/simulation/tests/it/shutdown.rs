//! Shutdown without an order: by a signal, or by a fault of the program.

use crate::common::{Planned, Script, When, at, in_mode, short, up, weld};
use crate::modbus_cell::{PERIOD_S, parts, welder};
use crate::modbus_server::TestServer;
use seamwright_executive::devices::DeviceSet;
use seamwright_executive::realtime::{Shutdown, ShutdownCause, guarded};
use seamwright_executive::{
    Ask, Command, Cycle, Devices as _, End, Executive, Mode, Note, Orders, Port, Reports, Start,
};
use seamwright_machine::shipped;
use seamwright_simulation::devices::{
    Device, Fault, FaultKind, Faulty, SimulatedDrives, SimulatedInputs, SimulatedSource, When as FaultTime,
};
use std::time::{Duration, Instant};

/// A script, and a flag that is set when a condition is first met.
struct Flagged<'a, F> {
    script: Script<'a>,
    when: F,
    /// Number of cycles when the flag was set.
    set: Option<usize>,
}

impl<F: Fn(&Script<'_>) -> bool> Port for Flagged<'_, F> {
    fn command(&mut self, t: f64) -> Option<Command> {
        self.script.command(t)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.script.show(cycle);
        if self.set.is_none() && (self.when)(&self.script) {
            self.set = Some(self.script.cycles.len());
        }
    }

    fn note(&mut self, t: f64, note: Note) {
        self.script.note(t, note);
    }

    fn shuts_down(&self) -> bool {
        self.set.is_some()
    }
}

/// Lines that lead into a mode, and the condition there.
struct Way {
    lines: Vec<(When<'static>, Ask)>,
    /// Condition that sets the flag.
    when: Box<dyn Fn(&Script<'_>) -> bool>,
    /// Fault that takes the cell into the fault mode.
    fault: Option<Fault>,
}

impl Way {
    fn into(mode: Mode) -> Self {
        let then = |more: Vec<(When<'static>, Ask)>| up().into_iter().chain(more).collect::<Vec<_>>();
        let lines = match mode {
            Mode::Off => Vec::new(),
            Mode::Idle | Mode::Homing | Mode::Ready | Mode::Fault => up(),
            Mode::Jog => then(vec![(in_mode(Mode::Ready), Ask::StartJog)]),
            Mode::Teach => then(vec![(in_mode(Mode::Ready), Ask::StartTeach)]),
            Mode::DryRun => then(vec![(in_mode(Mode::Ready), Ask::StartDryRun)]),
            Mode::Weld => then(weld()),
            Mode::Hold => then(weld().into_iter().chain([(at(3.0), Ask::Hold)]).collect()),
        };
        let when = move |script: &Script<'_>| {
            let there = script.cycles.last().filter(|c| c.mode == mode && script.cycles.len() > 5);
            there.is_some_and(|c| match mode {
                Mode::Weld => c.burning && c.place.s_mm > 3.0,
                Mode::DryRun => c.place.s_mm > 3.0,
                _ => true,
            })
        };
        let trips =
            Fault { device: Device::Inputs, kind: FaultKind::Wrong, when: FaultTime::At(1.0), lasts_s: 0.05, which: 0 };
        Self { lines, when: Box::new(when), fault: (mode == Mode::Fault).then_some(trips) }
    }
}

/// Runs a way until the flag is set; returns the record, and its number of cycles until then.
fn shut_down(planned: &Planned, way: Way) -> (Script<'static>, usize) {
    let machine = &planned.machine;
    let period = machine.servo_period_s;
    let inputs = SimulatedInputs::all_met(machine);
    let mut devices = DeviceSet {
        drives: SimulatedDrives::new(machine, 1).unwrap(),
        source: SimulatedSource::new(1, period),
        inputs: Faulty::new(inputs, Device::Inputs, way.fault.as_slice(), period),
    };
    let work = planned.work(Start::at_home(&planned.motion));
    let mut port = Flagged { script: Script::new(way.lines), when: way.when, set: None };
    let mut executive = Executive::new(machine, &mut devices, &mut port);
    assert_eq!(executive.serve(Some(&work)), End::Quit);
    drop(executive);
    (port.script, port.set.expect("it ended before"))
}

/// From every mode: no process with the very next orders, rest within the limits, power off, the end. Further orders
/// are ignored.
#[test]
fn a_shutdown_ends_every_mode_without_an_order() {
    let planned = short();
    let period = planned.machine.servo_period_s;
    for mode in Mode::ALL {
        let mut way = Way::into(mode);
        if mode != Mode::Off {
            // Later orders are ignored.
            way.lines.push((in_mode(Mode::Off), Ask::SwitchOn));
            way.lines.push((in_mode(Mode::Idle), Ask::Home));
        }
        let (script, set) = shut_down(&planned, way);
        let after = &script.cycles[set..];
        assert!(after.iter().all(|c| !c.on), "{mode}: the process is on after the flag");
        assert!((after.len() as f64) * period < 2.0, "{mode}: {} cycles", after.len());
        assert!(!after.last().unwrap().powered, "{mode}");
        for (k, axis) in planned.machine.axes.iter().enumerate() {
            let q: Vec<f64> = script.cycles[set - 2..].iter().filter(|c| c.powered).map(|c| c.q[k]).collect();
            for w in q.windows(3) {
                let a = (w[2] - 2.0 * w[1] + w[0]) / (period * period);
                assert!(a.abs() <= axis.max_acceleration * 1.01 + 1e-6, "{mode}: axis {k} stops with {a}");
            }
        }
    }
}

/// The thread of the cycle panics: its devices receive the order to switch off before they are dropped.
#[test]
fn a_panic_of_the_cycle_orders_the_devices_off() {
    let server = TestServer::new(welder);
    let parts = parts(&server);
    let machine = seamwright_machine::Machine::read("m.toml", shipped("ellipse-xy").unwrap().text).unwrap();
    let mut devices = DeviceSet {
        drives: SimulatedDrives::new(&machine, 1).unwrap(),
        source: parts.source.unwrap(),
        inputs: parts.inputs.unwrap(),
    };
    let shutdown = Shutdown::default();
    let panicked = guarded(&mut devices, &shutdown, |devices| {
        let (mut orders, mut reports) = (Orders::default(), Reports::default());
        orders.process.values = [f64::NAN; 16];
        let begun = Instant::now();
        while !reports.source.burning {
            assert!(begun.elapsed() < Duration::from_secs(30), "it does not strike");
            orders.process.on = reports.source.ready && reports.source.age_s < 0.05;
            orders.watchdog = orders.watchdog.next(false);
            devices.exchange(&orders, &mut reports);
            std::thread::sleep(Duration::from_secs_f64(PERIOD_S));
        }
        panic!("as it should");
    });
    assert!(panicked.is_err());
    assert_eq!(shutdown.cause(), Some(ShutdownCause::Panic));
    let begun = Instant::now();
    while server.bank().coils[1] {
        assert!(begun.elapsed() < Duration::from_secs(5), "the arc is still ordered on");
        std::thread::sleep(Duration::from_millis(2));
    }
    drop(devices);
    assert!(!server.bank().coils[1]);
}
