//! Conformance of all drives with a fault plan before them: simulated ones, steppers and LinuxCNC's.

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use seamwright_executive::devices::{Drives, StepDrives};
use seamwright_executive::{DriveReport, Orders};
use seamwright_machine::{Machine, shipped};
use seamwright_servo::SetPoint;
use seamwright_simulation::devices::{Device, Fault, FaultKind, Faulty, SimulatedDrives, When};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// The third axis moves by this, mm or rad.
const WAY: f64 = 0.5;
const MOVED: usize = 2;
const SILENT_S: f64 = 0.3;
/// Time of the drives' restart, s.
const REBOOT_S: f64 = 7.0;

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
    /// Runs a cycle without an allocation.
    fn cycle(&mut self) {
        self.orders.watchdog = self.orders.watchdog.next(false);
        let Self { drives, orders, report, .. } = self;
        assert_no_alloc(|| drives.exchange(orders, report));
        self.cycles += 1;
        (self.wait)();
    }

    /// Runs cycles until `is` holds; returns false if it does not within `s` seconds.
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

    /// Returns the maximum time until orders appear in reports, s.
    fn delay_s(&self) -> f64 {
        f64::from(self.drives.rides_out().cycles.min(1000)) * self.machine.servo_period_s + 2.0 * self.drives.late_s()
    }

    fn all(&self) -> u16 {
        (1 << self.machine.axes.len()) - 1
    }

    /// Moves the set-points to the actual positions.
    fn take_actual(&mut self) {
        for (set, position) in self.orders.set.iter_mut().zip(self.report.position) {
            *set = SetPoint { position, ..SetPoint::default() };
        }
    }

    fn moved(&self) -> f64 {
        self.report.position[MOVED]
    }
}

/// Checks the drives' conformance; `wait` waits for the next cycle. Drives with their own clock may run out of
/// set-points on a busy computer: that is tested by `make peers`.
fn conform<D: Drives>(machine: &Machine, drives: D, own_clock: bool, wait: Box<dyn FnMut()>) {
    let told = Arc::new(AtomicBool::new(false));
    let fault = |kind, when, lasts_s| Fault { device: Device::Drives, kind, when, lasts_s, which: 0 };
    let faults = [
        fault(FaultKind::Silent, When::Flagged, SILENT_S),
        fault(FaultKind::Reboot, When::At(REBOOT_S), f64::INFINITY),
    ];
    let drives = Faulty::new(drives, Device::Drives, &faults, machine.servo_period_s).flagged_by(&told);
    let report = DriveReport { age_s: f64::INFINITY, ..DriveReport::default() };
    let mut bench = Bench { machine, drives, orders: Orders::default(), report, cycles: 0, wait };

    // They report without orders, and do nothing without power.
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
    // Earlier orders cause no following error.
    assert!(!bench.within(delay_s, |r, _| r.following_error.iter().any(|e| e.abs() > 0.1)), "{:?}", bench.report);
    assert!((bench.moved() - machine.home()[MOVED]).abs() < 0.02, "{}", bench.moved());

    // They follow set-points, and arrive.
    let from = bench.moved();
    let steps = 1000;
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

    // Without power they keep their position.
    bench.orders.power = false;
    assert!(bench.within(1.0 + delay_s, |r, _| !r.powered));
    assert!((bench.moved() - from - WAY).abs() < 0.02);
    let report = bench.report;
    assert!((report.fault, report.limit_switch, report.starts) == (0, 0, 1), "{report:?}");
    assert!(own_clock || report.starved == 0, "{report:?}");

    // A restart is counted.
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

#[test]
fn drives_by_steps_conform() {
    let machine = machine("[devices.drives.steps]");
    let device = machine.devices.steps.clone().unwrap();
    conform(&machine, StepDrives::new(&machine, &device).unwrap(), false, Box::new(|| ()));
}

/// Runs in real time, with a store larger than the longest delay of a busy computer. Cases: no hardware; HAL files
/// that HAL refuses; a HAL file of slow hardware. They run in sequence: a computer has one HAL.
#[cfg(target_os = "linux")]
#[test]
fn linuxcnc_drives_conform() {
    use seamwright_executive::devices::{LinuxCncDrives, LinuxCncError};
    use std::io::Write as _;
    use std::os::unix::fs::PermissionsExt as _;

    let folder = tempfile::tempdir().unwrap();
    // HAL may run as another user.
    std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
    let start = |lines: &str| {
        let machine = machine(&format!("[devices.drives.linuxcnc]\nstore = 150\n{lines}"));
        let device = machine.devices.linuxcnc.clone().unwrap();
        let drives = LinuxCncDrives::start(&machine, &device, folder.path(), |text| println!("{text}"));
        (machine, drives)
    };
    let run = |machine: &Machine, drives: LinuxCncDrives| conform(machine, drives, true, in_real_time(machine));
    let (machine, drives) = start("");
    match drives {
        Ok(drives) => run(&machine, drives),
        Err(why @ (LinuxCncError::NotInstalled(_) | LinuxCncError::Running(_))) => {
            // Bypasses the capture of a test's output.
            let _ = writeln!(std::io::stderr(), "SKIPPED: drives by LinuxCNC were not tested: {why}");
            return;
        }
        Err(error) => panic!("{error}"),
    }
    // HAL's message about the file is reported with the file's name; the next start is clean.
    for (text, said) in [
        (Some("loadrt nosuchcomponent\n"), "nosuchcomponent"),
        (Some("# ours\nnet seamwright.q.set => nosuch.pin\n"), "nosuch.pin"),
        (Some("addf nosuch.function cell\n"), "nosuch.function"),
        (None, "absent.hal"),
    ] {
        let name = if text.is_some() { "refused.hal" } else { "absent.hal" };
        if let Some(text) = text {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        match start(&format!("hal = \"{name}\"")).1 {
            Err(LinuxCncError::Refused { file, output: all }) => {
                assert!(file.to_string().ends_with(name) && all.to_string().contains(said), "{file}: {all}");
            }
            other => panic!("{text:?}: {other:?}"),
        }
    }
    std::fs::write(folder.path().join("hardware.hal"), hardware(&machine)).unwrap();
    let (machine, drives) = start("hal = \"hardware.hal\"");
    run(&machine, drives.unwrap_or_else(|e| panic!("{e}")));
    // HAL with a killed part.
    let (machine, drives) = start("hal = \"hardware.hal\"");
    comes_back(&machine, drives.unwrap_or_else(|e| panic!("{e}")));
}

/// Waits for the next cycle of a machine.
#[cfg(target_os = "linux")]
fn in_real_time(machine: &Machine) -> Box<dyn FnMut()> {
    let mut pacer = seamwright_executive::realtime::Pacer::new(machine.servo_period_s);
    Box::new(move || {
        pacer.wait();
    })
}

/// Each of HAL's programs is killed with -9 under power. The drives are silent, and stay so while power is requested.
/// Then they start once more, without power and references. The cycle allocates nothing.
#[cfg(target_os = "linux")]
fn comes_back<D: Drives>(machine: &Machine, drives: D) {
    let wait = in_real_time(machine);
    let drives = Faulty::new(drives, Device::Drives, &[], machine.servo_period_s);
    let report = DriveReport { age_s: f64::INFINITY, ..DriveReport::default() };
    let mut bench = Bench { machine, drives, orders: Orders::default(), report, cycles: 0, wait };
    assert!(bench.within(1.0, |r, late| r.age_s <= late));
    let delay_s = bench.delay_s();
    for (k, program) in ["rtapi_app", "halstreamer", "halsampler"].into_iter().enumerate() {
        bench.take_actual();
        bench.orders.power = true;
        assert!(bench.within(1.0 + delay_s, |r, _| r.powered), "{program}: {:?}", bench.report);
        bench.orders.home = true;
        let all = bench.all();
        assert!(bench.within(2.0 + delay_s, |r, _| r.referenced == all));
        bench.orders.home = false;
        kill(program);
        assert!(bench.within(1.0, |r, late| r.age_s > late), "{program}");
        let starts = k as u32 + 1;
        // Longer than HAL takes to start.
        assert!(!bench.within(8.0, |r, _| r.starts != starts), "{program}: it comes back under power");
        bench.orders.power = false;
        assert!(bench.within(8.0, |r, late| r.starts == starts + 1 && r.age_s <= late), "{program}");
        assert!(!bench.report.powered && bench.report.referenced == 0, "{program}: {:?}", bench.report);
    }
    assert_eq!(violation_count(), 0);
}

/// Kills a program of HAL's, of which there is one on a computer, and ours.
#[cfg(target_os = "linux")]
fn kill(program: &str) {
    // A terminated process stays listed as a zombie until its parent waits for it.
    let runs = format!("({program}) ");
    let named = |folder: &std::path::Path| {
        std::fs::read_to_string(folder.join("stat"))
            .is_ok_and(|stat| stat.split_once(&runs).is_some_and(|(_, state)| !state.starts_with('Z')))
    };
    let processes = std::fs::read_dir("/proc").unwrap().flatten().map(|entry| entry.path());
    let found: Vec<_> = processes.filter(|folder| named(folder)).collect();
    assert_eq!(found.len(), 1, "{program}: {found:?}");
    let process = found[0].file_name().unwrap();
    assert!(std::process::Command::new("kill").arg("-9").arg(process).status().unwrap().success());
}

/// A HAL file as a user writes it, with HAL's own components for hardware. Power follows `enable`, axes have a
/// maximum speed and acceleration. References are known once an axis has reached its home position by itself.
fn hardware(machine: &Machine) -> String {
    let names = |kind: &str| {
        let names: Vec<String> = machine.axes.iter().map(|axis| format!("{kind}.{}", axis.name)).collect();
        names.join(",")
    };
    let mut hal = format!(
        "loadrt mux4 names={}\nloadrt limit3 names={}\nloadrt near names={}\nloadrt flipflop names={}\n\
         loadrt and2 names=power,search,{}\nsetp power.in1 1\n\
         net seamwright.enable => power.in0 search.in0\nnet seamwright.home => search.in1\n\
         net seamwright.powered power.out\nnet searching search.out\naddf power cell\naddf search cell\n",
        names("goal"),
        names("motor"),
        names("switch"),
        names("reference"),
        names("found")
    );
    for (axis, home) in machine.axes.iter().zip(machine.home()) {
        let (x, home) = (&axis.name, axis.to_file(home));
        hal += &format!(
            "setp goal.{x}.in3 {home}\nsetp motor.{x}.maxv 500\nsetp motor.{x}.maxa 50000\n\
             setp switch.{x}.in2 {home}\nsetp switch.{x}.difference 0.001\n\
             net seamwright.enable => goal.{x}.sel0\nnet searching => goal.{x}.sel1 found.{x}.in0\n\
             net seamwright.{x}.set => goal.{x}.in1\nnet goal.{x} goal.{x}.out => motor.{x}.in\n\
             net seamwright.{x}.position motor.{x}.out => goal.{x}.in0 switch.{x}.in1\n\
             net near.{x} switch.{x}.out => found.{x}.in1\nnet found.{x} found.{x}.out => reference.{x}.set\n\
             net seamwright.{x}.homed reference.{x}.out\n\
             addf goal.{x} cell\naddf motor.{x} cell\naddf switch.{x} cell\naddf found.{x} cell\naddf reference.{x} cell\n"
        );
    }
    hal
}
