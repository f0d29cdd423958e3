//! Drives by simulated robot controls over sockets, in real time.

use crate::robot_looped::{EGM, Planned, RSI, RTDE, Run, arm, home, job, whole_weld};
use seamwright_executive::devices::robot::{Hindrance, ProtocolError, RobotDrives, RobotFault};
use seamwright_executive::devices::{DeviceSet, Drives as _, TrafficView};
use seamwright_executive::realtime::{Paced, Pacer, RealtimeRights};
use seamwright_executive::{DriveReport, Executive, Mode, Note, Orders, Start, Work};
use seamwright_machine::Machine;
use seamwright_program::Pass;
use seamwright_servo::SetPoint;
use seamwright_simulation::devices::{SimulatedInputs, SimulatedSource};
use seamwright_simulation::robot::{
    ControlServer, Disturbances, EgmControl, PacketFaults, RsiControl, RtdeControl, Servo,
};
use std::net::{SocketAddr, TcpListener, UdpSocket};
use std::time::Duration;

const SERVO: Servo = Servo { delay_s: 0.01, lag_s: 0.008 };
const PROTOCOLS: [&str; 3] = ["rtde", "egm", "rsi"];

/// A free UDP port of this computer.
fn free_port() -> SocketAddr {
    UdpSocket::bind("127.0.0.1:0").unwrap().local_addr().unwrap()
}

/// A simulated control that is started later, and the lines of a machine file that connect it.
struct Control {
    protocol: &'static str,
    lines: String,
    address: SocketAddr,
}

impl Control {
    fn new(protocol: &'static str) -> Self {
        // Long enough for a busy computer.
        const STORE: u32 = 150;
        let address = if protocol == "rtde" {
            TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap()
        } else {
            free_port()
        };
        let lines = if protocol == "rtde" {
            format!("[devices.arm.rtde]\naddress = \"{address}\"\nstore = {STORE}\n")
        } else {
            format!("[devices.arm.{protocol}]\nlisten = \"{address}\"\nfrom = \"127.0.0.1\"\nstore = {STORE}\n")
        };
        Self { protocol, lines, address }
    }

    fn start(&self) -> ControlServer {
        let server = match self.protocol {
            "rtde" => {
                let control = RtdeControl::new(500.0, SERVO, home(false)).patient(0.5);
                ControlServer::tcp(control, &self.address.to_string())
            }
            "egm" => ControlServer::udp(EgmControl::new(6, 0, SERVO, home(true)), self.address),
            _ => ControlServer::udp(RsiControl::new(0, 0.004, SERVO, home(true)), self.address),
        };
        server.unwrap()
    }
}

/// Starts a simulated control of `protocol`; returns it with the lines of a machine file that connect it.
fn control(protocol: &'static str) -> (ControlServer, String) {
    let control = Control::new(protocol);
    (control.start(), control.lines)
}

/// Drives with orders and reports, cycle by cycle in real time.
struct Bench {
    drives: RobotDrives,
    traffic: TrafficView,
    orders: Orders,
    report: DriveReport,
    pacer: Pacer,
    period_s: f64,
}

impl Bench {
    fn new(machine: &Machine) -> Self {
        RealtimeRights::ask(None);
        let device = machine.devices.robot.as_ref().unwrap();
        let (drives, traffic) = RobotDrives::connect(machine, device).unwrap_or_else(|e| panic!("{e}"));
        let period_s = machine.servo_period_s;
        let report = DriveReport { age_s: f64::INFINITY, ..DriveReport::default() };
        Self { drives, traffic, orders: Orders::default(), report, pacer: Pacer::new(period_s), period_s }
    }

    fn cycle(&mut self) {
        self.pacer.wait();
        self.drives.exchange(&self.orders, &mut self.report);
    }

    fn within(&mut self, s: f64, what: &str, is: impl Fn(&DriveReport) -> bool) {
        for _ in 0..(s / self.period_s) as usize {
            self.cycle();
            if is(&self.report) {
                return;
            }
        }
        panic!("not within {s} s: {what}: {:?} {:?}", self.report, self.traffic.get());
    }

    fn power(&mut self) {
        self.within(2.0, "reports", |r| r.age_s < 0.1);
        self.take_actual();
        self.orders.power = true;
        self.within(2.0, "power", |r| r.powered);
    }

    fn take_actual(&mut self) {
        for (set, position) in self.orders.set.iter_mut().zip(self.report.position) {
            *set = SetPoint { position, ..SetPoint::default() };
        }
    }

    /// Moves an axis by `by` rad, smoothly, in `s` seconds. Returns the worst following error.
    fn turn(&mut self, axis: usize, by: f64, s: f64) -> f64 {
        let from = self.orders.set[axis].position;
        let steps = (s / self.period_s) as u32;
        let mut worst = 0.0f64;
        for k in 1..=steps {
            let w = std::f64::consts::PI / s;
            let t = self.period_s * f64::from(k);
            self.orders.set[axis] = SetPoint {
                position: from + by * 0.5 * (1.0 - (w * t).cos()),
                velocity: if k == steps { 0.0 } else { by * 0.5 * w * (w * t).sin() },
                acceleration: 0.0,
            };
            self.cycle();
            worst = worst.max(self.report.following_error[axis].abs());
        }
        worst
    }
}

/// Every protocol: reports without orders, power by a handshake, set-points followed, the latency measured, packets
/// lost, doubled, overtaken and garbled; at the end the arm stands, and has confirmed it.
#[test]
fn drives_by_every_protocol() {
    for protocol in PROTOCOLS {
        let (server, lines) = control(protocol);
        let mut bench = Bench::new(&arm(&lines));
        bench.within(1.0, "reports", |r| r.age_s < 0.1 && r.referenced == 0x3f);
        assert!(!bench.report.powered && bench.report.starts == 1, "{protocol}: {:?}", bench.report);
        bench.power();
        if protocol != "rtde" {
            server.spoil(PacketFaults { lost: 0.02, doubled: 0.05, overtaken: 0.02, garbage: 0.02 });
        }
        let from = bench.orders.set[0].position;
        let worst = [0.2, -0.3, 0.3].map(|by| bench.turn(0, by, 1.2)).into_iter().fold(0.0, f64::max);
        bench.within(1.0, "arrival", |r| (r.position[0] - from - 0.2).abs() < 2e-4);
        let traffic = bench.traffic.get();
        let latency = traffic.latency.unwrap();
        println!("{protocol}: {latency:?}, following error {worst:.5}, {} reports", traffic.polls);
        // 18 ms of the servo, and up to two periods for packets and their hold.
        assert!((0.012..0.035).contains(&latency.mean_s), "{protocol}: {latency:?}");
        assert!(worst < 0.02 && traffic.connections == 1, "{protocol}: {worst} {traffic:?}");
        assert!(protocol == "rtde" || (traffic.missed > 0 && traffic.failed > 0), "{protocol}: {traffic:?}");
        assert!(bench.report.starved == 0, "{:?}", bench.report);
        let view = bench.traffic.clone();
        drop(bench);
        assert_eq!(view.get().safe, Some(Ok(())), "{protocol}");
        // The servo settles.
        std::thread::sleep(Duration::from_millis(200));
        let stands = server.positions();
        std::thread::sleep(Duration::from_millis(50));
        assert!(protocol != "rtde" || !server.follows());
        assert!(stands.iter().zip(server.positions()).all(|(a, b)| (a - b).abs() < 1e-4), "{protocol}: it moves");
    }
}

/// A control that cuts the connection or begins anew, falls silent, or stops the arm: power is off until it is ordered
/// off and on again.
#[test]
fn nothing_starts_again_by_itself() {
    for protocol in PROTOCOLS {
        let (server, lines) = control(protocol);
        let mut bench = Bench::new(&arm(&lines));
        bench.power();
        bench.turn(1, 0.1, 0.3);
        server.cut();
        bench.within(3.0, "restart", |r| !r.powered && r.starts == 2 && r.age_s < 0.1);
        for _ in 0..100 {
            bench.cycle();
            assert!(!bench.report.powered, "{protocol}");
        }
        bench.orders.power = false;
        for _ in 0..100 {
            bench.cycle();
        }
        server.disturb(Disturbances::default());
        bench.power();
        bench.turn(1, -0.05, 0.3);
        // Silence.
        server.disturb(Disturbances { mute: true, ..Disturbances::default() });
        bench.within(1.0, "silence", |r| r.age_s > 0.1);
        bench.within(2.0, "loss", |r| !r.powered);
        server.disturb(Disturbances::default());
        bench.orders.power = false;
        if protocol == "rsi" {
            // Without answers RSI has ended: its program is started again.
            server.cut();
        }
        bench.within(4.0, "reports", |r| r.age_s < 0.05);
        assert!(bench.report.starts >= 3, "{protocol}");
        server.cut();
        bench.within(4.0, "reports", |r| r.age_s < 0.05 && r.starts >= 3);
        server.disturb(Disturbances::default());
        bench.power();
        // A fault of the arm.
        if protocol != "rsi" {
            server.disturb(Disturbances { emergency_stop: true, ..Disturbances::default() });
            bench.within(1.0, "stop", |r| !r.powered);
            let expected = if protocol == "rtde" { Hindrance::EmergencyStop } else { Hindrance::MotorsOff };
            std::thread::sleep(Duration::from_millis(300));
            assert_eq!(bench.traffic.get().trouble, Some(expected.message()), "{protocol}");
        }
    }
}

/// Set-points cease, and later jump: the robot brakes or stays, and does not follow until power was off.
#[test]
fn missing_and_wild_set_points() {
    let (server, lines) = control("rtde");
    let mut bench = Bench::new(&arm(&lines.replace("store = 150", "store = 20")));
    bench.power();
    let from = bench.orders.set[0].position;
    // At speed, then no cycle for longer than the store lasts.
    for k in 1..=200 {
        let t = bench.period_s * f64::from(k);
        bench.orders.set[0] = SetPoint { position: from + 0.5 * t * t, velocity: t, acceleration: 1.0 };
        bench.cycle();
    }
    let speed = bench.orders.set[0].velocity;
    std::thread::sleep(Duration::from_millis(400));
    bench.within(0.5, "starved", |r| r.starved == 1 && !r.powered);
    let stood = server.positions();
    let braked = stood[0] - bench.orders.set[0].position;
    // 480 degrees/s² of the axis, and no farther than a stop from that speed needs.
    let way = 0.5 * speed * speed / 480f64.to_radians();
    assert!(braked > 0.2 * way && braked < 1.2 * way + 1e-3, "{braked} {way}");
    bench.orders.power = false;
    for _ in 0..50 {
        bench.cycle();
    }
    bench.power();
    bench.orders.set[2].position += 0.3;
    bench.within(0.5, "jump", |r| !r.powered);
    std::thread::sleep(Duration::from_millis(250));
    bench.cycle();
    assert_eq!(bench.traffic.get().trouble, Some(Hindrance::Jump.message()));
    assert!((server.positions()[2] - stood[2]).abs() < 2e-3);
}

/// A weld with a hold and overrides by the executive, paced in real time, over each protocol. Without real-time rights
/// a busy computer can be later than any store; so there are three attempts.
fn weld_over(protocol: &'static str) {
    for _ in 0..2 {
        if std::panic::catch_unwind(|| weld_once(protocol)).is_ok() {
            return;
        }
    }
    weld_once(protocol);
}

fn weld_once(protocol: &'static str) {
    let control = Control::new(protocol);
    let lines = &control.lines;
    let planned = Planned::new(&job("").replace("[-30, 0, 0], [30, 0, 0]", "[-9, 0, 0], [9, 0, 0]"), lines, 0.0);
    let server = control.start();
    RealtimeRights::ask(None);
    let machine = &planned.machine;
    let device = machine.devices.robot.as_ref().unwrap();
    let (drives, traffic) = RobotDrives::connect(machine, device).unwrap_or_else(|e| panic!("{e}"));
    let source = SimulatedSource::new(1, machine.servo_period_s);
    let devices = DeviceSet { drives, source, inputs: SimulatedInputs::all_met(machine) };
    let mut paced = Paced::new(devices, machine, Pacer::new(machine.servo_period_s));
    let mut run = Run::new(whole_weld(3.0));
    let passes: Vec<&Pass> = planned.welding.program.value.passes.iter().collect();
    let work = Work::new(machine, None, &passes, &planned.motion, Start::at_home(&planned.motion)).unwrap();
    Executive::new(machine, &mut paced, &mut run).serve(Some(&work));
    let notes = &run.script.notes;
    // A busy computer may miss cycles: the store rides them out.
    assert!(!notes.iter().any(|n| matches!(n, Note::Alarm(_))), "{notes:?} {:?}", traffic.get());
    assert!(run.script.modes().contains(&Mode::Weld) && run.script.modes().ends_with(&[Mode::Off]));
    let took_s = run.script.cycles.last().unwrap().t;
    let latency = traffic.get().latency.unwrap();
    println!("{protocol}: {took_s:.1} s, {latency:?}, worst following error {:.5} rad", run.worst_error);
    assert!((0.012..0.035).contains(&latency.mean_s), "{latency:?}");
    drop(paced);
    drop(server);
}

#[test]
fn a_weld_over_a_socket_by_rtde() {
    weld_over("rtde");
}

#[test]
fn a_weld_over_a_socket_by_egm() {
    weld_over("egm");
}

#[test]
fn a_weld_over_a_socket_by_rsi() {
    weld_over("rsi");
}

fn fault_of(lines: &str) -> RobotFault {
    let machine = arm(lines);
    match RobotDrives::connect(&machine, machine.devices.robot.as_ref().unwrap()) {
        Err(error) => {
            println!("{error}");
            error.fault
        }
        Ok(_) => panic!("connected: {lines}"),
    }
}

/// Wrong addresses, ports in use, refusals: each error names its reason.
#[test]
fn controls_that_cannot_be_used() {
    let gone = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
    assert!(matches!(fault_of(&RTDE.replace("127.0.0.1", &gone.to_string())), RobotFault::Unreachable(_)));
    let taken = UdpSocket::bind("127.0.0.1:0").unwrap();
    let on = taken.local_addr().unwrap().to_string();
    assert_eq!(fault_of(&EGM.replace("127.0.0.1:6510", &on)), RobotFault::PortInUse);
    assert_eq!(fault_of(&RSI.replace("127.0.0.1:49152", &free_port().to_string())), RobotFault::NoReports);
    assert!(matches!(fault_of(&RSI.replace("127.0.0.1:49152", "192.0.2.1:4000")), RobotFault::NotListening(_)));
    let none = Disturbances::default();
    let cases = [
        (Disturbances { old_version: true, ..none.clone() }, ProtocolError::Version),
        (
            Disturbances { unknown_field: Some("output_int_register_26".to_owned()), ..none.clone() },
            ProtocolError::UnknownFields("output_int_register_26".to_owned()),
        ),
        (
            Disturbances { field_in_use: Some("input_double_register_27".to_owned()), ..none.clone() },
            ProtocolError::FieldsInUse("input_double_register_27".to_owned()),
        ),
    ];
    for (disturbances, error) in cases {
        let (server, lines) = control("rtde");
        server.disturb(disturbances);
        assert_eq!(fault_of(&lines), RobotFault::Protocol(error));
    }
    let (server, lines) = control("egm");
    server.disturb(Disturbances { joints_reported: Some(7), ..none });
    let error = ProtocolError::Joints { reported: 7, needed: 6 };
    assert_eq!(fault_of(&lines), RobotFault::Protocol(error));
}
