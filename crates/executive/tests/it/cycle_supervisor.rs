//! The supervisor of the cycle: a cycle that hangs in a device, while the process is on at a source on Modbus.

use crate::modbus_cell::{MAP, VALUES, device, welder};
use crate::modbus_server::TestServer;
use seamwright_executive::devices::TrafficView;
use seamwright_executive::devices::modbus::{ModbusInputs, ModbusSource, connect};
use seamwright_executive::devices::{DeviceSet, Drives};
use seamwright_executive::realtime::{Paced, Shutdown, ShutdownCause};
use seamwright_executive::{Devices as _, DriveReport, Orders, Reports, Slack};
use seamwright_machine::{Machine, shipped};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Drives that hang while the flag is set; they tolerate gaps that are shorter than any limit.
struct Hanging(Arc<AtomicBool>);

impl Drives for Hanging {
    fn exchange(&mut self, _orders: &Orders, _report: &mut DriveReport) {
        while self.0.load(Ordering::SeqCst) {
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    fn rides_out(&self) -> Slack {
        Slack::stored(20)
    }

    fn late_s(&self) -> f64 {
        1.0
    }
}

type Cell = Paced<DeviceSet<Hanging, ModbusSource, ModbusInputs>>;

/// A cell whose cycle hangs with the arc on, in a thread of its own.
struct Hung {
    hangs: Arc<AtomicBool>,
    shutdown: Shutdown,
    begun: Instant,
    traffic: TrafficView,
    cycle: JoinHandle<(Cell, Orders, Reports)>,
}

/// Strikes the arc, prepares the server, and hangs. The device's own watchdog waits for 2 s.
fn hang(server: &TestServer, prepare: impl Fn(&TestServer)) -> Hung {
    let machine = Machine::read("m.toml", shipped("ellipse-xy").unwrap().text).unwrap();
    let map = MAP.replace("watchdog_s = 0.4", "watchdog_s = 2").replace("timeout_s = 0.5", "timeout_s = 1");
    let parts = connect(&device(&server.address.to_string(), &map), &VALUES.map(str::to_owned)).unwrap();
    let traffic = parts.traffic.clone();
    let (hangs, shutdown) = (Arc::new(AtomicBool::new(false)), Shutdown::default());
    let drives = Hanging(Arc::clone(&hangs));
    let devices = DeviceSet { drives, source: parts.source.unwrap(), inputs: parts.inputs.unwrap() };
    let mut paced = Paced::supervised(devices, &machine, &shutdown);
    let (mut orders, mut reports) = (Orders::default(), Reports::default());
    orders.process.values = [f64::NAN; 16];
    let begun = Instant::now();
    while !reports.source.burning {
        assert!(begun.elapsed() < Duration::from_secs(30), "it does not strike");
        // A loaded computer may miss cycles: then the process goes off, and is ordered anew.
        orders.process.on = reports.source.ready && reports.source.age_s < 0.05 && !reports.late;
        orders.watchdog = orders.watchdog.next(false);
        paced.exchange(&orders, &mut reports);
    }
    prepare(server);
    hangs.store(true, Ordering::SeqCst);
    let begun = Instant::now();
    let cycle = std::thread::spawn(move || {
        orders.watchdog = orders.watchdog.next(false);
        paced.exchange(&orders, &mut reports);
        orders.watchdog = orders.watchdog.next(false);
        paced.exchange(&orders, &mut reports);
        (paced, orders, reports)
    });
    Hung { hangs, shutdown, begun, traffic, cycle }
}

/// Waits until the arc is ordered off at the device; returns the time since the stop of the cycle.
fn off_after(server: &TestServer, begun: Instant) -> Duration {
    while server.bank().coils[1] {
        assert!(begun.elapsed() < Duration::from_secs(30), "the arc is still ordered on");
        std::thread::sleep(Duration::from_millis(1));
    }
    begun.elapsed()
}

/// The thread of the device writes the safe outputs, long before its own limit; the cell ends. When the cycle comes
/// back, its first orders are off.
#[test]
fn a_hung_cycle_loses_the_process_and_ends_the_cell() {
    let server = TestServer::new(welder);
    let Hung { hangs, shutdown, begun, cycle, .. } = hang(&server, |_| ());
    let took = off_after(&server, begun);
    // 60 ms as a rule; the computer may be loaded.
    assert!(took < Duration::from_millis(1500), "off after {took:?}");
    let count = server.bank().holding[20];
    while shutdown.cause().is_none() {
        assert!(begun.elapsed() < Duration::from_secs(30), "no end is requested");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(shutdown.cause(), Some(ShutdownCause::CycleStopped));
    assert!(begun.elapsed() > Duration::from_secs(1), "the cycle had no time to come back");
    assert_eq!(server.bank().holding[20], count, "the watchdog output goes on");
    hangs.store(false, Ordering::SeqCst);
    let (mut paced, mut orders, mut reports) = cycle.join().unwrap();
    assert!(reports.late && reports.missed > 500, "{reports:?}");
    // The executive keeps it off from here on; orders that stay on do not bring it back.
    orders.watchdog.late = true;
    orders.process.on = false;
    for _ in 0..200 {
        orders.watchdog = orders.watchdog.next(true);
        paced.exchange(&orders, &mut reports);
        assert!(!server.bank().coils[1], "the arc came back by itself");
    }
    assert_eq!(server.bank().holding[20], count, "the watchdog output goes on after a late cycle");
}

/// The connections of the device's own thread are stuck: the supervisor writes over one of its own.
#[test]
fn the_supervisor_has_a_connection_of_its_own() {
    let server = TestServer::new(welder);
    let Hung { hangs, begun, traffic, cycle, .. } = hang(&server, TestServer::silence_present);
    let took = off_after(&server, begun);
    // 110 ms as a rule, and the device's own thread still waits for the answer to its last write.
    assert!(took < Duration::from_millis(1500), "off after {took:?}");
    assert_eq!(traffic.get().connections, 1, "off after {took:?}");
    hangs.store(false, Ordering::SeqCst);
    drop(cycle.join().unwrap());
    assert!(!server.bank().coils[1]);
}
