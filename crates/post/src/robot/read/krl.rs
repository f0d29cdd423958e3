//! Reader of KUKA KRL: one main program with frames, speeds, PTP, LIN and CIRC, and calls of the arc's subprograms.

use super::scan::{Scan, positive};
use crate::read::error::{Fault, Read};
use crate::robot::angles::from_euler_zyx;
use crate::robot::pose::RobotPose;
use crate::robot::program::{
    ArcEnd, ArcStart, JointTarget, RobotFrames, RobotProgram, RobotStep, TcpMove, ThroughPoint,
};
use crate::robot::weld_values::WeldValues;
use glam::DVec3;
use seamwright_message::Message;
use std::collections::BTreeMap;

const MM_PER_M: f64 = 1e3;

pub(super) fn read(text: &str) -> Read<RobotProgram> {
    let mut reader = Reader::default();
    let mut scan = Scan::new(text);
    while let Some(mut line) = scan.line() {
        reader.line(&mut line)?;
    }
    if reader.inside || reader.programs == 0 {
        return Err(scan.missing("END"));
    }
    for called in ["ARC_ON", "ARC_OFF"] {
        if reader.calls.contains(&called) && !reader.names.contains(&called) {
            return Err(scan.missing(called));
        }
    }
    let Some(tool) = reader.tool else { return Err(scan.missing("$TOOL")) };
    let Some(work) = reader.base else { return Err(scan.missing("$BASE")) };
    Ok(RobotProgram { title: String::new(), frames: Some(RobotFrames { tool, work }), steps: reader.steps })
}

#[derive(Default)]
struct Reader<'a> {
    steps: Vec<RobotStep>,
    tool: Option<RobotPose>,
    base: Option<RobotPose>,
    speed_mm_s: f64,
    zone_mm: f64,
    inside: bool,
    programs: usize,
    names: Vec<&'a str>,
    calls: Vec<&'static str>,
}

impl<'a> Reader<'a> {
    fn line(&mut self, line: &mut Scan<'a>) -> Read {
        if line.is_empty() || (!self.inside && line.take("&")) {
            return Ok(());
        }
        if line.take(";PASS ") {
            self.steps.push(RobotStep::Pass(line.rest().trim().to_owned()));
            return Ok(());
        }
        if line.take(";") {
            return Ok(());
        }
        let from = line.at;
        let word = line.name()?;
        match word.to_ascii_uppercase().as_str() {
            "DEF" if !self.inside => {
                self.names.push(line.name()?);
                line.expect("(")?;
                line.until(')')?;
                self.programs += 1;
                self.inside = true;
            }
            "END" if self.inside => self.inside = false,
            // Bodies of the arc's subprograms are the integrator's.
            _ if self.inside && self.programs > 1 => return Ok(()),
            upper if self.inside => self.statement(upper, from, line)?,
            _ => return Err(line.unknown(from, word)),
        }
        line.end_of_line(";")
    }

    fn statement(&mut self, word: &str, from: usize, line: &mut Scan<'a>) -> Read {
        match word {
            "BAS" => drop(line.until(')')?),
            "$CIRC_TYPE" => line.expect("=#PATH")?,
            "$ADVANCE" | "$ORI_TYPE" => {
                line.expect("=")?;
                line.take("#");
                line.name()?;
            }
            "$TOOL" => {
                line.expect("=")?;
                self.tool = Some(pose(&aggregate(line)?, line)?);
            }
            "$BASE" => {
                line.expect("=")?;
                let coupled = line.take("EK(MACHINE_DEF[2].ROOT,MACHINE_DEF[2].MECH_TYPE,");
                self.base = Some(pose(&aggregate(line)?, line)?);
                if coupled {
                    line.expect(")")?;
                }
            }
            "$VEL" => {
                line.expect(".CP=")?;
                self.speed_mm_s = MM_PER_M * positive(line.number()?, line.since(from))?;
            }
            "$APO" => {
                line.expect(".CDIS=")?;
                self.zone_mm = positive(line.number()?, line.since(from))?;
            }
            "PTP" => self.joints(line)?,
            "LIN" => self.motion(from, None, line)?,
            "CIRC" => {
                let via = through_point(line)?;
                self.motion(from, Some(via), line)?;
            }
            "ARC_ON" => {
                self.calls.push("ARC_ON");
                let [preflow_s, delay_s, current_a, voltage_v, wire_feed_m_min] = arguments(line)?;
                let values = WeldValues { current_a, voltage_v, wire_feed_m_min };
                self.steps.push(RobotStep::ArcOn(ArcStart { preflow_s, delay_s, values }));
            }
            "TRIGGER" => {
                line.expect("WHEN DISTANCE=0 DELAY=0 DO ARC_SWI")?;
                let [current_a, voltage_v, wire_feed_m_min] = arguments(line)?;
                line.expect("PRIO=-1")?;
                self.steps.push(RobotStep::Values(WeldValues { current_a, voltage_v, wire_feed_m_min }));
            }
            "ARC_OFF" => {
                self.calls.push("ARC_OFF");
                let [crater_s, postflow_s] = arguments(line)?;
                self.steps.push(RobotStep::ArcOff(ArcEnd { crater_s, postflow_s }));
            }
            "WAIT" => {
                line.expect("SEC")?;
                self.steps.push(RobotStep::Wait(line.number()?));
            }
            _ => return Err(line.unknown(from, word)),
        }
        Ok(())
    }

    fn joints(&mut self, line: &mut Scan<'a>) -> Read {
        let parts = aggregate(line)?;
        let mut arm = [0.0; 6];
        for (angle, name) in arm.iter_mut().zip(["A1", "A2", "A3", "A4", "A5", "A6"]) {
            *angle = part(&parts, name, line)?;
        }
        self.steps.push(RobotStep::Joints(JointTarget { arm, externals: externals(&parts) }));
        Ok(())
    }

    fn motion(&mut self, from: usize, via: Option<ThroughPoint>, line: &mut Scan<'a>) -> Read {
        let parts = aggregate(line)?;
        let to = pose(&parts, line)?;
        let data = ["S", "T"].map(|name| part(&parts, name, line));
        let [Ok(status), Ok(turn)] = data else { return Err(line.missing("S, T")) };
        let rounds = line.take("C_DIS");
        let speed_mm_s = positive(self.speed_mm_s, line.since(from))?;
        self.steps.push(RobotStep::Move(TcpMove {
            via,
            to,
            externals: externals(&parts),
            configuration: vec![status as i32, turn as i32],
            speed_mm_s,
            zone_mm: if rounds { self.zone_mm } else { 0.0 },
        }));
        Ok(())
    }
}

/// `{X 1,Y 2}`: names with numbers.
fn aggregate<'a>(line: &mut Scan<'a>) -> Read<BTreeMap<&'a str, f64>> {
    let mut parts = BTreeMap::new();
    line.expect("{")?;
    loop {
        let from = line.at;
        let name = line.name()?;
        if parts.insert(name, line.number()?).is_some() {
            return Err(Fault::new(line.since(from), Message::new("post-robot-unknown").text("word", name)));
        }
        if !line.take(",") {
            break;
        }
    }
    line.expect("}")?;
    Ok(parts)
}

/// The through-point of an arc and the comma behind it; only its position counts.
fn through_point(line: &mut Scan) -> Read<ThroughPoint> {
    let parts = aggregate(line)?;
    let of = |name| part(&parts, name, line);
    let pose = RobotPose { point: DVec3::new(of("X")?, of("Y")?, of("Z")?), ..RobotPose::IDENTITY };
    line.expect(",")?;
    Ok(ThroughPoint { pose, externals: Vec::new(), configuration: Vec::new() })
}

fn part(parts: &BTreeMap<&str, f64>, name: &str, line: &Scan) -> Read<f64> {
    parts.get(name).copied().ok_or_else(|| line.missing(name))
}

fn pose(parts: &BTreeMap<&str, f64>, line: &Scan) -> Read<RobotPose> {
    let of = |name| part(parts, name, line);
    let point = DVec3::new(of("X")?, of("Y")?, of("Z")?);
    let turn = from_euler_zyx([of("A")?, of("B")?, of("C")?].map(f64::to_radians));
    Ok(RobotPose { point, turn })
}

/// E1 to E6 as far as they are given in a row.
fn externals(parts: &BTreeMap<&str, f64>) -> Vec<f64> {
    ["E1", "E2", "E3", "E4", "E5", "E6"].iter().map_while(|name| parts.get(name).copied()).collect()
}

fn arguments<const N: usize>(line: &mut Scan) -> Read<[f64; N]> {
    line.expect("(")?;
    let numbers = line.numbers(",")?;
    line.expect(")")?;
    Ok(numbers)
}
