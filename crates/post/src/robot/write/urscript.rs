//! Universal Robots URScript.
//!
//! Source: Universal Robots, The URScript Programming Language (5.12), `movep`, `movec`, `movel`, `movej`, `pose_trans`, `servoj`.

use super::RobotText;
use super::text::{head, joined, plain};
use crate::robot::angles::rotation_vector;
use crate::robot::language::RobotLanguage;
use crate::robot::pose::RobotPose;
use crate::robot::program::{ArcEnd, ArcStart, RobotProgram, RobotStep, TcpMove};
use crate::robot::stream::{ServoStream, SetPoints};
use crate::robot::weld_values::WeldValues;
use crate::write::fixed;
use std::fmt::Write as _;

const M_PER_MM: f64 = 1e-3;
/// Decimals of set-points, rad: at 2 ms fewer would show in the speed.
const SET_POINT_DECIMALS: usize = 9;

pub(super) fn write(program: &RobotProgram, options: &RobotText) -> String {
    let mut text = String::new();
    for line in head(RobotLanguage::Urscript, program, options) {
        text.push_str(&format!("# {line}\n"));
    }
    text.push_str("def seamwright_weld():\n");
    text.push_str(&functions(options));
    text.push_str(&format!("  set_tcp({})\n", pose(&options.arm.tool)));
    text.push_str(&format!("  work = {}\n", pose(&options.arm.work)));
    let mut burning = false;
    for step in &program.steps {
        let statement = match step {
            RobotStep::Pass(name) => format!("# pass: {}", plain(name)),
            RobotStep::Joints(target) => {
                let radians = target.arm.map(f64::to_radians);
                format!("movej([{}], a=0.8, v=0.5)", joined(radians, 8, ", "))
            }
            RobotStep::Move(line) | RobotStep::JointsTo(line) => motion(line, burning),
            RobotStep::ArcOn(start) => {
                burning = true;
                arc_on(start)
            }
            RobotStep::ArcOff(end) => {
                burning = false;
                arc_off(end)
            }
            RobotStep::Values(values) => format!("weld_values({})", numbers(values)),
            RobotStep::SetPoints(points) => servo(points),
            RobotStep::Wait(seconds) => format!("sleep({})", fixed(*seconds, 3)),
        };
        text.push_str(&format!("  {statement}\n"));
    }
    text.push_str("end\nseamwright_weld()\n");
    text
}

/// The functions that switch the process: replace their bodies by those of the power source's extension.
fn functions(options: &RobotText) -> String {
    let io = options.io();
    let output = |number: Option<u16>, on: &str| match number {
        Some(number) => format!("    set_standard_digital_out({number}, {on})\n"),
        None => String::new(),
    };
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write!(text, "  def weld_values(current_a, voltage_v, wire_feed_m_min):\n    sleep(0)\n  end\n");
    let (gas, wire, arc) = (io.gas.map(u16::from), io.wire.map(u16::from), io.arc.map(u16::from));
    let _ = write!(
        text,
        "  def arc_on(preflow_s, delay_s, current_a, voltage_v, wire_feed_m_min):\n{}",
        output(gas, "True")
    );
    let _ = write!(text, "    weld_values(current_a, voltage_v, wire_feed_m_min)\n    sleep(preflow_s)\n");
    let _ = write!(text, "{}{}    sleep(delay_s)\n  end\n", output(wire, "True"), output(arc, "True"));
    let _ = write!(text, "  def arc_off(crater_s, postflow_s):\n    sleep(crater_s)\n");
    let _ = write!(
        text,
        "{}{}    sleep(postflow_s)\n{}  end\n",
        output(arc, "False"),
        output(wire, "False"),
        output(gas, "False")
    );
    text
}

/// Position in m and rotation vector in rad.
fn pose(pose: &RobotPose) -> String {
    let point = joined((pose.point * M_PER_MM).to_array(), 7, ", ");
    format!("p[{point}, {}]", joined(rotation_vector(pose.turn).to_array(), 8, ", "))
}

/// Lines of a weld keep the speed of the tool round corners: movep. Others stop: movel. Arcs are movec; mode 0 turns the tool
/// from start to end, whatever the through-point's orientation.
fn motion(line: &TcpMove, burning: bool) -> String {
    let via = line.via.as_ref().map(|via| format!("pose_trans(work, {})", pose(&via.pose)));
    let pose = format!("pose_trans(work, {})", pose(&line.to));
    let speed = fixed(line.speed_mm_s * M_PER_MM, 8);
    if let Some(via) = via {
        let radius = fixed(line.zone_mm * M_PER_MM, 8);
        return format!("movec({via}, {pose}, a=1.2, v={speed}, r={radius}, mode=0)");
    }
    match burning || line.zone_mm > 0.0 {
        true => format!("movep({pose}, a=1.2, v={speed}, r={})", fixed(line.zone_mm * M_PER_MM, 8)),
        false => format!("movel({pose}, a=0.5, v={speed})"),
    }
}

/// A statement for each set-point: positions in rad, acceleration and speed (which `servoj` ignores), time, look-ahead time,
/// gain.
fn servo(points: &SetPoints) -> String {
    let ServoStream { period_s, lookahead_s, gain } = points.stream;
    let settings = format!("0, 0, {}, {}, {}", fixed(period_s, 6), fixed(lookahead_s, 6), fixed(gain, 3));
    let statement = |deg: &[f64; 6]| {
        format!("servoj([{}], {settings})", joined(deg.map(f64::to_radians), SET_POINT_DECIMALS, ", "))
    };
    points.positions.iter().map(statement).collect::<Vec<_>>().join("\n  ")
}

fn numbers(values: &WeldValues) -> String {
    joined(values.all(), 3, ", ")
}

fn arc_on(start: &ArcStart) -> String {
    format!("arc_on({}, {}, {})", fixed(start.preflow_s, 3), fixed(start.delay_s, 3), numbers(&start.values))
}

fn arc_off(end: &ArcEnd) -> String {
    format!("arc_off({}, {})", fixed(end.crater_s, 3), fixed(end.postflow_s, 3))
}
