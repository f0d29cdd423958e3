//! Limits of the torch tip: kept in every direction along a weld, under every command of an operator; reported where
//! they bind.

use crate::planning::{machine_of, plan, read};
use glam::DVec3;
use seamwright_machine::{AxisLimits, Joints, Machine};
use seamwright_motion::feed_override::{Command, FeedOverride, channel_limits};
use seamwright_motion::{Binding, LimitKind, PassMotion};

const TIP: AxisLimits = AxisLimits { speed: 25.0, acceleration: 40.0, jerk: 300.0 };
const PERIOD: f64 = 1e-3;

/// The saddle on the trunnion table, at a requested 30 mm/s: more than the tip's limit.
fn planned() -> (Machine, PassMotion) {
    let text = include_str!("../../../../examples/trunnion-saddle.toml");
    let line = |l: &str| match l {
        _ if l.starts_with("speed_mm_s =") => "speed_mm_s = 30\n".to_owned(),
        "[weld]" => "[weld]\non_limit = \"slow\"\n".to_owned(),
        _ => format!("{l}\n"),
    };
    let text: String = text.lines().filter(|l| !l.starts_with("on_limit")).map(line).collect();
    let welding = read(&text);
    let mut machine = machine_of(&welding);
    machine.tip = TIP;
    let motion = plan(&machine, &welding).unwrap();
    (machine, motion)
}

/// Maximum speed, acceleration and jerk of the tip by differences of its positions, as fractions of the limits.
fn used(machine: &Machine, rows: &[Joints]) -> [f64; 3] {
    let most = |v: &[DVec3]| v.iter().map(|v| v.length()).fold(0.0, f64::max);
    let slope = |v: &[DVec3]| -> Vec<DVec3> { v.windows(2).map(|w| (w[1] - w[0]) / PERIOD).collect() };
    let tips: Vec<DVec3> = rows.iter().map(|q| machine.forward(q).point).collect();
    let v = slope(&tips);
    let a = slope(&v);
    // Jerks by differences over ten periods: else they would be rounding.
    let j: Vec<DVec3> = a.windows(11).map(|w| (w[10] - w[0]) / (10.0 * PERIOD)).collect();
    [most(&v) / TIP.speed, most(&a) / TIP.acceleration, most(&j) / TIP.jerk]
}

#[test]
fn a_weld_keeps_them_and_says_so() {
    let (machine, motion) = planned();
    let rows: Vec<Joints> = motion.set_points(PERIOD).map(|p| p.q).collect();
    let parts = used(&machine, &rows);
    assert!(parts.iter().all(|u| *u <= 1.0 + 2e-3), "{parts:?}");
    assert!(parts[0] > 0.99 && parts[2] > 0.8, "{parts:?}");
    let bindings = motion.certificate.intervals.iter().filter_map(|i| Binding::new(&machine, i.bound));
    assert!(
        bindings.into_iter().any(|b| b.axis.is_none() && b.kind == LimitKind::Speed && (b.value - 25.0).abs() < 1e-12)
    );
    let told: Vec<String> = motion.findings.iter().map(|f| f.message.to_string()).collect();
    assert!(told.iter().any(|m| m.contains("the torch tip cannot keep 30.000 mm/s: its speed limit of 25.000 mm/s")));
}

#[test]
fn an_operator_cannot_break_them() {
    let (machine, motion) = planned();
    let timed = motion.timed(&machine);
    let mut feed_override = FeedOverride::new(&channel_limits(&machine), PERIOD, &timed).unwrap();
    let commands = [
        Command::Resume,
        Command::Override(0.3),
        Command::Override(1.0),
        Command::Hold,
        Command::Reverse,
        Command::Hold,
        Command::Resume,
    ];
    let mut rows = Vec::new();
    for command in commands.into_iter().chain(commands) {
        feed_override.command(command).unwrap();
        rows.extend((0..900).map(|_| feed_override.step().rates.q));
    }
    let parts = used(&machine, &rows);
    assert!(parts.iter().all(|u| *u <= 1.0 + 2e-3), "{parts:?}");
    assert!(parts[1] > 0.7 && parts[2] > 0.7, "{parts:?}");
}
