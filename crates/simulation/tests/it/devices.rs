//! Conformance of every process source and all inputs, simulated or on Modbus, with and without a fault plan before
//! them.

use crate::modbus_cell::{PERIOD_S, parts, welder};
use crate::modbus_server::TestServer;
use seamwright_executive::devices::modbus::{ModbusInputs, ModbusSource};
use seamwright_executive::devices::{DeviceSet, Drives, InputBits, Inputs, Source};
use seamwright_executive::{Devices as _, DriveReport, Orders, Reports, Slack, SourceReport};
use seamwright_simulation::devices::{Device, Fault, FaultKind, Faulty, SimulatedInputs, SimulatedSource, When};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Drives are not tested here.
struct NoDrives;

impl Drives for NoDrives {
    fn exchange(&mut self, _orders: &Orders, _report: &mut DriveReport) {}

    fn rides_out(&self) -> Slack {
        Slack::stored(0)
    }

    fn late_s(&self) -> f64 {
        0.0
    }
}

/// All three conditions of the test cell are met.
const MET: u64 = 0b111;

/// An event that happens to the devices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Event {
    /// The devices do not report for a while.
    Silence,
    /// The devices lose power for a while.
    Restart,
    /// The devices get no more orders.
    Loss,
}

/// Source and inputs, and their environment.
struct Bench<S, I> {
    set: DeviceSet<NoDrives, S, I>,
    orders: Orders,
    reports: Reports,
    /// Applies the start or end of an event to the devices.
    happens: Box<dyn FnMut(Event, bool)>,
    /// True while arc or beam is there.
    lit: Box<dyn Fn(&S) -> bool>,
    /// State of the watchdog output, if there is one.
    watchdog: Box<dyn Fn() -> Option<u16>>,
    real: bool,
}

impl<S: Source, I: Inputs> Bench<S, I> {
    /// Runs up to `most` cycles until `done`.
    fn cycles(&mut self, most: usize, done: impl Fn(&Self) -> bool) -> bool {
        for _ in 0..most {
            self.orders.watchdog = self.orders.watchdog.next(self.orders.watchdog.late);
            self.set.exchange(&self.orders, &mut self.reports);
            if self.real {
                std::thread::sleep(Duration::from_secs_f64(PERIOD_S));
            }
            if done(self) {
                return true;
            }
        }
        false
    }

    fn is_lit(&self) -> bool {
        (self.lit)(&self.set.source)
    }

    fn is_fresh(&self) -> bool {
        self.reports.source.age_s < 0.05 && self.reports.inputs_age_s < 0.05
    }

    /// Strikes the arc until it is reported.
    fn strike(&mut self) {
        self.orders.process.on = false;
        assert!(self.cycles(2000, |b| b.is_fresh() && b.reports.source.ready && !b.reports.source.burning));
        (self.orders.process.on, self.orders.process.gas) = (true, true);
        assert!(self.cycles(2000, |b| b.reports.source.burning), "it does not strike");
        assert!(self.is_lit());
    }
}

fn conforms<S: Source, I: Inputs>(mut bench: Bench<S, I>, events: &[Event]) {
    assert!(!bench.is_fresh(), "nothing is known yet");
    assert!(bench.cycles(2000, Bench::is_fresh));
    let starts = (bench.reports.source.starts, bench.reports.inputs_starts);
    assert!(starts.0 >= 1 && starts.1 >= 1);

    // Orders arrive, reports return.
    bench.orders.process.values = [f64::NAN; 16];
    bench.orders.process.values[0] = 150.0;
    bench.strike();
    assert!(bench.cycles(2000, |b| (b.reports.source.values[0] - 150.0).abs() < 15.0), "{:?}", bench.reports.source);
    assert_eq!((bench.reports.inputs, bench.reports.source.fault, bench.reports.source.stuck), (MET, 0, false));
    bench.orders.process.on = false;
    assert!(bench.cycles(2000, |b| !b.reports.source.burning), "it does not go out");
    assert!(!bench.is_lit());
    assert_eq!((bench.reports.source.starts, bench.reports.inputs_starts), starts, "nothing has restarted");

    watchdog_conforms(&mut bench);
    cut_off_conforms(&mut bench);
    for event in events {
        bench.strike();
        let starts = (bench.reports.source.starts, bench.reports.inputs_starts);
        (bench.happens)(*event, true);
        // A silence shows as age; the last report stays.
        let before = bench.reports;
        let old = |b: &Bench<S, I>| b.reports.source.age_s > 0.15 && b.reports.inputs_age_s > 0.15;
        if *event != Event::Loss {
            assert!(bench.cycles(2000, old), "{event:?}: {:?}", bench.reports);
            let kept = SourceReport { age_s: before.source.age_s, ..bench.reports.source };
            let same =
                |a: &SourceReport, b: &SourceReport| (a.ready, a.fault, a.starts) == (b.ready, b.fault, b.starts);
            assert!(same(&kept, &before.source), "{event:?}");
            assert_eq!(bench.reports.inputs, before.inputs);
        } else if bench.real {
            std::thread::sleep(Duration::from_millis(1200));
        } else {
            bench.cycles(300, |_| false);
        }
        if *event == Event::Loss {
            assert!(!bench.is_lit(), "it burns although nobody orders it to");
        }
        (bench.happens)(*event, false);
        bench.orders.process.on = false;
        assert!(bench.cycles(5000, Bench::is_fresh), "{event:?}: it does not come back");
        let after = (bench.reports.source.starts, bench.reports.inputs_starts);
        if *event == Event::Restart {
            assert!(after.0 > starts.0 && after.1 > starts.1, "{starts:?} {after:?}");
        }
        assert!(bench.cycles(2000, |b| !b.reports.source.burning && !b.is_lit()));
    }
}

/// The watchdog output changes while cycles are on time. After a late cycle it stands still until the reset, while
/// orders and reports go on.
fn watchdog_conforms<S: Source, I: Inputs>(bench: &mut Bench<S, I>) {
    let changes = |bench: &mut Bench<S, I>| {
        let mut seen = vec![(bench.watchdog)()];
        for _ in 0..20 {
            bench.cycles(10, |_| false);
            seen.push((bench.watchdog)());
        }
        seen.dedup();
        seen.len() - 1
    };
    let has_output = (bench.watchdog)().is_some();
    assert_eq!(changes(bench) > 2, has_output);
    bench.orders.watchdog.late = true;
    // A write may be in transit.
    bench.cycles(50, |_| false);
    assert_eq!(changes(bench), 0, "it goes on after a late cycle");
    bench.orders.process.gas = !bench.orders.process.gas;
    bench.strike();
    bench.orders.process.on = false;
    assert!(bench.cycles(2000, |b| !b.reports.source.burning && b.is_fresh()));
    bench.orders.watchdog.late = false;
    assert_eq!(changes(bench) > 2, has_output);
}

/// Without the cycle each device can be cut off: safe outputs, watchdog still. The arc does not come back with the cycle
/// unless it was ordered off.
fn cut_off_conforms<S: Source, I: Inputs>(bench: &mut Bench<S, I>) {
    bench.strike();
    let cut_offs = bench.set.cut_offs();
    assert_eq!(cut_offs.is_empty(), !bench.real, "a device on a network has a way of its own");
    if cut_offs.is_empty() {
        return;
    }
    // Cycles go on until here: the devices' own watchdogs have not acted.
    cut_offs.iter().for_each(|cut_off| cut_off.order());
    let begun = std::time::Instant::now();
    while !cut_offs.iter().all(|cut_off| cut_off.is_confirmed()) {
        assert!(begun.elapsed() < Duration::from_secs(10), "not confirmed");
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(!bench.is_lit());
    let count = (bench.watchdog)();
    std::thread::sleep(Duration::from_millis(50));
    assert_eq!((bench.watchdog)(), count);
    assert!(!bench.cycles(100, Bench::is_lit), "it came back by itself");
    bench.orders.watchdog.late = true;
    assert!(!bench.cycles(100, Bench::is_lit), "it came back by itself");
    bench.orders.watchdog.late = false;
    bench.strike();
    bench.orders.process.on = false;
    assert!(bench.cycles(2000, |b| !b.reports.source.burning));
}

const EVENTS: [Event; 3] = [Event::Silence, Event::Restart, Event::Loss];

/// A device with a fault that begins on request.
fn faulty<T, R: Copy + Default>(it: T, device: Device, kind: FaultKind, told: &Arc<AtomicBool>) -> Faulty<T, R> {
    let fault = Fault { device, kind, when: When::Flagged, lasts_s: 0.4, which: 1 };
    Faulty::new(it, device, &[fault], PERIOD_S).flagged_by(told)
}

/// Simulated devices fail by fault plans: the same kind before source and inputs.
fn simulated(event: Event) -> Bench<impl Source, impl Inputs> {
    let kind = match event {
        Event::Silence => FaultKind::Silent,
        Event::Restart => FaultKind::Reboot,
        Event::Loss => FaultKind::Disconnect,
    };
    let told = Arc::new(AtomicBool::new(false));
    let source = faulty(SimulatedSource::new(1, PERIOD_S), Device::Source, kind, &told);
    let inputs = faulty(SimulatedInputs::new(MET), Device::Inputs, kind, &told);
    Bench {
        set: DeviceSet { drives: NoDrives, source, inputs },
        orders: Orders::default(),
        reports: Reports::default(),
        happens: Box::new(move |_, begins| told.store(begins, Ordering::Relaxed)),
        lit: Box::new(|source: &Faulty<SimulatedSource, SourceReport>| source.device().burns()),
        watchdog: Box::new(|| None),
        real: false,
    }
}

#[test]
fn the_simulated_twins_conform() {
    for event in EVENTS {
        conforms(simulated(event), &[event]);
    }
}

/// Applies events to the device on the network; the bench itself causes a loss of the cycle.
fn on_modbus<S, I>(server: TestServer, source: S, inputs: I) -> Bench<S, I> {
    let server = Arc::new(std::sync::Mutex::new(server));
    let (other, shown) = (Arc::clone(&server), Arc::clone(&server));
    Bench {
        set: DeviceSet { drives: NoDrives, source, inputs },
        orders: Orders::default(),
        reports: Reports::default(),
        happens: Box::new(move |event, begins| match (event, begins) {
            (Event::Silence, _) => other.lock().unwrap().silence(begins),
            (Event::Restart, true) => {
                let mut server = other.lock().unwrap();
                server.stop();
                server.bank().coils.fill(false);
            }
            (Event::Restart, false) => other.lock().unwrap().start(),
            (Event::Loss, _) => {}
        }),
        lit: Box::new(move |_| server.lock().unwrap().bank().coils[1]),
        watchdog: Box::new(move || Some(shown.lock().unwrap().bank().holding[20])),
        real: true,
    }
}

#[test]
fn modbus_conforms() {
    let server = TestServer::new(welder);
    let parts = parts(&server);
    conforms(on_modbus(server, parts.source.unwrap(), parts.inputs.unwrap()), &EVENTS);
}

type FaultySource = Faulty<ModbusSource, SourceReport>;
type FaultyInputs = Faulty<ModbusInputs, InputBits>;

/// A fault plan works before devices on Modbus as before simulated ones: without effect until a fault comes ..
#[test]
fn modbus_conforms_behind_a_plan_of_faults() {
    let (bench, _) = faulty_modbus(FaultKind::Silent);
    conforms(bench, &EVENTS);
}

fn faulty_modbus(kind: FaultKind) -> (Bench<FaultySource, FaultyInputs>, Arc<AtomicBool>) {
    let server = TestServer::new(welder);
    let parts = parts(&server);
    let told = Arc::new(AtomicBool::new(false));
    let source = faulty(parts.source.unwrap(), Device::Source, kind, &told);
    let inputs = faulty(parts.inputs.unwrap(), Device::Inputs, kind, &told);
    (on_modbus(server, source, inputs), told)
}

/// .. and then with the same effect as on those.
#[test]
fn faults_come_over_modbus_devices() {
    for kind in FaultKind::ALL {
        let (mut bench, told) = faulty_modbus(kind);
        bench.strike();
        let starts = bench.reports.source.starts;
        told.store(true, Ordering::Relaxed);
        bench.cycles(250, |_| false);
        let reports = bench.reports;
        match kind {
            FaultKind::Silent => assert!(reports.source.age_s > 0.2 && reports.inputs_age_s > 0.2 && bench.is_lit()),
            FaultKind::Disconnect | FaultKind::Reconnect => assert!(reports.source.age_s > 0.2 && !bench.is_lit()),
            FaultKind::Reboot => assert!(reports.inputs_age_s > 0.2 && !bench.is_lit()),
            FaultKind::Slow => assert!(reports.source.age_s > 0.0 && bench.is_lit()),
            FaultKind::Wrong => assert!(!reports.source.burning && reports.inputs == MET ^ 2 && bench.is_lit()),
        }
        assert!(bench.cycles(3000, Bench::is_fresh));
        bench.cycles(400, |_| false);
        let reboots = u32::from(kind == FaultKind::Reboot);
        assert_eq!((bench.reports.source.starts, bench.reports.inputs), (starts + reboots, MET), "{kind:?}");
    }
}
