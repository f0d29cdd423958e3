//! The end that nobody orders: by a signal, or by a fault of the program.

use crate::common::{Planned, Script, in_mode, short, up, weld};
use crate::modbus_cell::{PERIOD_S, parts, welder};
use crate::modbus_server::TestServer;
use seamwright_cell::devices::{DeviceSet, SimulatedDrives, SimulatedInputs, SimulatedSource};
use seamwright_cell::executive::{
    Ask, Command, Cycle, Devices as _, End, Executive, Interlocks, Mode, Note, Orders, Port, Reports, Start,
};
use seamwright_cell::realtime::{Shutdown, ShutdownCause, guarded};
use seamwright_machine::shipped;
use std::time::{Duration, Instant};

/// A script, and a flag that is set when something is seen for the first time.
struct Flagged<'a, F> {
    script: Script<'a>,
    when: F,
    /// Cycles when the flag was set.
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

/// Runs `lines` until the flag is set; what was seen, and how often until then.
fn shut_down<'a>(
    planned: &Planned,
    lines: Vec<(crate::common::When<'a>, Ask)>,
    when: impl Fn(&Script<'_>) -> bool,
) -> (Script<'a>, usize) {
    let machine = &planned.machine;
    let mut devices = DeviceSet {
        drives: SimulatedDrives::new(machine, 1).unwrap(),
        source: SimulatedSource::new(1, machine.servo_period_s),
        inputs: SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met()),
    };
    let work = planned.work(Start::at_home(&planned.motion));
    let mut port = Flagged { script: Script::new(lines), when, set: None };
    let mut executive = Executive::new(machine, &mut devices, &mut port);
    assert_eq!(executive.serve(Some(&work)), End::Quit);
    drop(executive);
    (port.script, port.set.expect("it ended before"))
}

/// When the flag is set.
type Moment = Box<dyn Fn(&Script<'_>) -> bool>;

/// From every mode: no process with the very next orders, rest within the limits, power off, the end, and no order obeyed any more.
#[test]
fn a_shutdown_ends_every_mode_without_an_order() {
    let planned = short();
    let period = planned.machine.servo_period_s;
    let welding = |script: &Script<'_>| script.cycles.last().is_some_and(|c| c.burning && c.place.s_mm > 3.0);
    let mode = |mode: Mode| move |script: &Script<'_>| script.cycles.last().is_some_and(|c| c.mode == mode);
    let jog = || vec![(in_mode(Mode::Ready), Ask::StartJog)];
    let cases: Vec<(Vec<_>, Moment)> = vec![
        (vec![], Box::new(|script| script.cycles.len() > 5)),
        (up(), Box::new(mode(Mode::Idle))),
        (up(), Box::new(mode(Mode::Homing))),
        (up(), Box::new(mode(Mode::Ready))),
        ([up(), jog()].into_iter().flatten().collect(), Box::new(mode(Mode::Jog))),
        ([up(), weld()].into_iter().flatten().collect(), Box::new(welding)),
    ];
    for (i, (mut lines, when)) in cases.into_iter().enumerate() {
        // What comes after is not heard.
        lines.push((in_mode(Mode::Off), Ask::SwitchOn));
        lines.push((in_mode(Mode::Idle), Ask::Home));
        let lines = if i == 0 { vec![] } else { lines };
        let (script, set) = shut_down(&planned, lines, when);
        let after = &script.cycles[set..];
        assert!(after.iter().all(|c| !c.on), "case {i}: the process is on after the flag");
        assert!((after.len() as f64) * period < 2.0, "case {i}: {} cycles", after.len());
        assert!(!after.last().unwrap().powered, "case {i}");
        for (k, axis) in planned.machine.axes.iter().enumerate() {
            let q: Vec<f64> = script.cycles[set - 2..].iter().filter(|c| c.powered).map(|c| c.q[k]).collect();
            for w in q.windows(3) {
                let a = (w[2] - 2.0 * w[1] + w[0]) / (period * period);
                assert!(a.abs() <= axis.max_acceleration * 1.01 + 1e-6, "case {i}: axis {k} stops with {a}");
            }
        }
    }
}

/// The thread of the cycle panics: its devices hear that everything is off, before they are dropped.
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
            orders.watchdog = !orders.watchdog;
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
