//! What all drives must do, simulated ones and LinuxCNC's, with a plan of faults before them.

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use seamwright_cell::devices::{Device, Drives, Fault, FaultKind, Faulty, SimulatedDrives, When};
use seamwright_cell::executive::{DriveReport, Orders};
use seamwright_machine::{Machine, shipped};
use seamwright_servo::SetPoint;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// The third axis moves by this, mm or rad.
const WAY: f64 = 0.5;
const MOVED: usize = 2;
const SILENT_S: f64 = 0.3;
/// When the drives start anew, s.
const REBOOT_S: f64 = 5.0;

/// Drives with orders and reports, cycle by cycle.
struct Bench<'a, D> {
    machine: &'a Machine,
    drives: Faulty<D, DriveReport>,
    orders: Orders,
    report: DriveReport,
    cycles: usize,
    wait: Box<dyn FnMut()>,
}

impl<D: Drives> Bench<'_, D> {
    /// A cycle, without an allocation.
    fn cycle(&mut self) {
        self.orders.watchdog = !self.orders.watchdog;
        let Self { drives, orders, report, .. } = self;
        assert_no_alloc(|| drives.exchange(orders, report));
        self.cycles += 1;
        (self.wait)();
    }

    /// Cycles until it is so; false if it is not after so many seconds.
    fn within(&mut self, s: f64, is: impl Fn(&DriveReport, f64) -> bool) -> bool {
        let late = self.drives.late_s();
        for _ in 0..(s / self.machine.servo_period_s) as usize {
            self.cycle();
            if is(&self.report, late) {
                return true;
            }
        }
        false
    }

    /// Time in which orders are seen in reports, s.
    fn delay_s(&self) -> f64 {
        f64::from(self.drives.rides_out().min(1000)) * self.machine.servo_period_s + 2.0 * self.drives.late_s()
    }

    fn all(&self) -> u16 {
        (1 << self.machine.axes.len()) - 1
    }

    /// Set-points where the axes are.
    fn take_actual(&mut self) {
        for (set, position) in self.orders.set.iter_mut().zip(self.report.position) {
            *set = SetPoint { position, ..SetPoint::default() };
        }
    }

    fn moved(&self) -> f64 {
        self.report.position[MOVED]
    }
}

/// What the drives do, whoever they are; `wait` waits for the next cycle. Those that run by a clock of their own may run out of
/// set-points where the computer has other things to do: that is for `make peers`.
fn conform<D: Drives>(machine: &Machine, drives: D, own_clock: bool, wait: Box<dyn FnMut()>) {
    let told = Arc::new(AtomicBool::new(false));
    let fault = |kind, when, lasts_s| Fault { device: Device::Drives, kind, when, lasts_s, which: 0 };
    let faults =
        [fault(FaultKind::Silent, When::Told, SILENT_S), fault(FaultKind::Reboot, When::At(REBOOT_S), f64::INFINITY)];
    let drives = Faulty::new(drives, Device::Drives, &faults, machine.servo_period_s).told_by(&told);
    let report = DriveReport { age_s: f64::INFINITY, ..DriveReport::default() };
    let mut bench = Bench { machine, drives, orders: Orders::default(), report, cycles: 0, wait };

    // They report by themselves, and do nothing without power.
    assert!(bench.within(1.0, |r, late| r.age_s <= late));
    assert!(!bench.report.powered && bench.report.starts == 1);
    bench.take_actual();
    let before = bench.moved();
    bench.orders.set[MOVED].position += 0.1;
    let delay_s = bench.delay_s();
    assert!(!bench.within(delay_s, |r, _| r.powered || (r.position[MOVED] - before).abs() > 1e-6));

    // Power, then references.
    bench.take_actual();
    bench.orders.power = true;
    assert!(bench.within(1.0 + delay_s, |r, _| r.powered));
    assert_eq!(bench.report.referenced, 0);
    bench.orders.home = true;
    let all = bench.all();
    assert!(bench.within(2.0 + delay_s, |r, _| r.referenced == all));
    bench.orders.home = false;
    bench.take_actual();
    // What was ordered before is no following error.
    assert!(!bench.within(delay_s, |r, _| r.following_error.iter().any(|e| e.abs() > 0.1)), "{:?}", bench.report);
    assert!((bench.moved() - machine.home()[MOVED]).abs() < 0.02, "{}", bench.moved());

    // They follow set-points, and arrive.
    let from = bench.moved();
    let steps = 400;
    for k in 1..=steps {
        let angle = std::f64::consts::PI * f64::from(k) / f64::from(steps);
        let rate = std::f64::consts::PI / (f64::from(steps) * machine.servo_period_s);
        bench.orders.set[MOVED] = SetPoint {
            position: from + WAY * 0.5 * (1.0 - angle.cos()),
            velocity: WAY * 0.5 * angle.sin() * rate,
            acceleration: WAY * 0.5 * angle.cos() * rate * rate,
        };
        bench.cycle();
        assert!(bench.report.following_error[MOVED].abs() < 0.2, "{k}: {:?}", bench.report);
    }
    bench.orders.set[MOVED] = SetPoint { position: from + WAY, ..SetPoint::default() };
    assert!(bench.within(0.5 + delay_s, |r, _| (r.position[MOVED] - from - WAY).abs() < 5e-3), "{:?}", bench.report);

    // Their silence ages, and passes.
    told.store(true, Ordering::Relaxed);
    assert!(bench.within(SILENT_S, |r, late| r.age_s > late));
    assert!(bench.within(SILENT_S + 0.5, |r, late| r.age_s <= late));

    // Without power at rest they stay where they are.
    bench.orders.power = false;
    assert!(bench.within(1.0 + delay_s, |r, _| !r.powered));
    assert!((bench.moved() - from - WAY).abs() < 0.02);
    let report = bench.report;
    assert!((report.fault, report.limit_switch, report.starts) == (0, 0, 1), "{report:?}");
    assert!(own_clock || report.starved == 0, "{report:?}");

    // A start is counted.
    let left_s = REBOOT_S - bench.cycles as f64 * machine.servo_period_s;
    assert!(left_s > 0.0, "all that took {} s", REBOOT_S - left_s);
    assert!(bench.within(left_s + 1.0, |r, _| r.starts == 2));
    assert_eq!(violation_count(), 0);
}

fn machine(devices: &str) -> Machine {
    Machine::read("m.toml", &format!("{}\n{devices}", shipped("torch-5axis").unwrap().text)).unwrap()
}

#[test]
fn simulated_drives_conform() {
    let machine = machine("");
    for seed in 0..10 {
        conform(&machine, SimulatedDrives::new(&machine, seed).unwrap(), false, Box::new(|| ()));
    }
}

/// In real time, with more in store than a busy computer takes at once.
#[cfg(target_os = "linux")]
#[test]
fn linuxcnc_drives_conform() {
    use seamwright_cell::devices::{LinuxCncDrives, LinuxCncError};
    use seamwright_cell::realtime::Pacer;
    use std::io::Write as _;

    let machine = machine("[devices.drives.linuxcnc]\nstore = 150");
    let device = machine.devices.linuxcnc.clone().unwrap();
    let drives = match LinuxCncDrives::start(&machine, &device, std::path::Path::new(".")) {
        Ok(drives) => drives,
        Err(why @ (LinuxCncError::NotInstalled(_) | LinuxCncError::Running(_))) => {
            // Past what a test's own output is hidden by.
            let _ = writeln!(std::io::stderr(), "SKIPPED: drives by LinuxCNC were not tested: {why}");
            return;
        }
        Err(error) => panic!("{error}"),
    };
    let mut pacer = Pacer::new(machine.servo_period_s);
    conform(
        &machine,
        drives,
        true,
        Box::new(move || {
            pacer.wait();
        }),
    );
}
