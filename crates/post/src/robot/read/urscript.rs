//! Reader of URScript: one program with moves, its own functions for the process, and assignments of poses.

use super::scan::{Scan, positive};
use crate::read::error::{Fault, Read};
use crate::robot::angles::from_rotation_vector;
use crate::robot::pose::RobotPose;
use crate::robot::program::{
    ArcEnd, ArcStart, JointTarget, RobotFrames, RobotProgram, RobotStep, TcpMove, ThroughPoint,
};
use crate::robot::stream::{ServoStream, SetPoints};
use crate::robot::weld_values::WeldValues;
use glam::{DQuat, DVec3};
use seamwright_message::Message;
use std::collections::BTreeMap;

const MM_PER_M: f64 = 1e3;
/// Functions that the program defines for the process.
const FUNCTIONS: [&str; 3] = ["weld_values", "arc_on", "arc_off"];

pub(super) fn read(text: &str) -> Read<RobotProgram> {
    let mut reader = Reader::default();
    let mut scan = Scan::new(text);
    while let Some(mut line) = scan.line() {
        reader.line(&mut line)?;
    }
    if reader.depth > 0 || !reader.called {
        return Err(scan.missing(if reader.depth > 0 { "end" } else { "call" }));
    }
    let Some(tool) = reader.tool else { return Err(scan.missing("set_tcp")) };
    let Some(work) = reader.poses.get("work").copied() else { return Err(scan.missing("work")) };
    Ok(RobotProgram { title: String::new(), frames: Some(RobotFrames { tool, work }), steps: reader.steps })
}

#[derive(Default)]
struct Reader<'a> {
    steps: Vec<RobotStep>,
    tool: Option<RobotPose>,
    poses: BTreeMap<&'a str, RobotPose>,
    /// Functions around the line: 1 in the program, 2 in one of its functions.
    depth: u32,
    program: &'a str,
    called: bool,
}

/// A pose and the speed and radius behind it.
struct Motion {
    to: RobotPose,
    speed_mm_s: f64,
    zone_mm: f64,
}

impl<'a> Reader<'a> {
    fn line(&mut self, line: &mut Scan<'a>) -> Read {
        if line.is_empty() {
            return Ok(());
        }
        if line.take("#") {
            if line.take("pass:") {
                self.steps.push(RobotStep::Pass(line.rest().trim().to_owned()));
            }
            return Ok(());
        }
        let from = line.at;
        let word = line.name()?;
        match (word, self.depth) {
            ("def", 0) => self.program = line.name()?,
            ("def", 1) => {
                let name = line.name()?;
                if !FUNCTIONS.contains(&name) {
                    return Err(line.unknown(from, name));
                }
            }
            ("end", 1 | 2) => {
                self.depth -= 1;
                return line.end_of_line("#");
            }
            // Bodies of the functions for the process are the integrator's.
            (_, 2) => return Ok(()),
            (name, 0) if name == self.program && !name.is_empty() => {
                line.expect("()")?;
                self.called = true;
                return line.end_of_line("#");
            }
            (_, 1) => return self.statement(word, from, line),
            _ => return Err(line.unknown(from, word)),
        }
        line.until(')')?;
        line.expect(":")?;
        self.depth += 1;
        line.end_of_line("#")
    }

    fn statement(&mut self, word: &'a str, from: usize, line: &mut Scan<'a>) -> Read {
        if line.take("=") {
            let pose = self.pose(line)?;
            self.poses.insert(word, pose);
            return line.end_of_line("#");
        }
        line.expect("(")?;
        match word {
            "set_tcp" => self.tool = Some(self.pose(line)?),
            "movej" => {
                line.expect("[")?;
                let arm = line.numbers::<6>(",")?.map(f64::to_degrees);
                line.expect("]")?;
                self.options(line)?;
                self.steps.push(RobotStep::Joints(JointTarget { arm, externals: Vec::new() }));
            }
            "movel" | "movep" | "movec" => {
                let via = if word == "movec" { Some(self.through_point(line)?) } else { None };
                let Motion { to, speed_mm_s, zone_mm } = self.motion(line)?;
                let line = TcpMove { via, to, externals: Vec::new(), configuration: Vec::new(), speed_mm_s, zone_mm };
                self.steps.push(RobotStep::Move(line));
            }
            "servoj" => self.servo(from, line)?,
            "arc_on" => {
                let [preflow_s, delay_s, current_a, voltage_v, wire_feed_m_min] = line.numbers(",")?;
                let values = WeldValues { current_a, voltage_v, wire_feed_m_min };
                self.steps.push(RobotStep::ArcOn(ArcStart { preflow_s, delay_s, values }));
            }
            "arc_off" => {
                let [crater_s, postflow_s] = line.numbers(",")?;
                self.steps.push(RobotStep::ArcOff(ArcEnd { crater_s, postflow_s }));
            }
            "weld_values" => {
                let [current_a, voltage_v, wire_feed_m_min] = line.numbers(",")?;
                self.steps.push(RobotStep::Values(WeldValues { current_a, voltage_v, wire_feed_m_min }));
            }
            "sleep" => self.steps.push(RobotStep::Wait(line.number()?)),
            _ => return Err(line.unknown(from, word)),
        }
        line.expect(")")?;
        line.end_of_line("#")
    }

    /// `[q1, q2, q3, q4, q5, q6], a, v, t, lookahead_time, gain`
    fn servo(&mut self, from: usize, line: &mut Scan<'a>) -> Read {
        line.expect("[")?;
        let positions = line.numbers::<6>(",")?.map(f64::to_degrees);
        line.expect("]")?;
        line.expect(",")?;
        let [_, _, period_s, lookahead_s, gain] = line.numbers(",")?;
        let period_s = positive(period_s, line.since(from))?;
        let stream = ServoStream { period_s, lookahead_s, gain };
        match self.steps.last_mut() {
            Some(RobotStep::SetPoints(points)) if points.stream == stream => points.positions.push(positions),
            _ => self.steps.push(RobotStep::SetPoints(SetPoints { stream, positions: vec![positions] })),
        }
        Ok(())
    }

    /// `p[x, y, z, rx, ry, rz]` in m and rad.
    fn pose(&self, line: &mut Scan) -> Read<RobotPose> {
        line.expect("p[")?;
        let [x, y, z, rx, ry, rz] = line.numbers(",")?;
        line.expect("]")?;
        let turn = from_rotation_vector(DVec3::new(rx, ry, rz));
        Ok(RobotPose { point: MM_PER_M * DVec3::new(x, y, z), turn })
    }

    /// The through-point of an arc and the comma behind it; its rotation is ignored.
    fn through_point(&self, line: &mut Scan<'a>) -> Read<ThroughPoint> {
        let pose = RobotPose { turn: DQuat::IDENTITY, ..self.work_pose(line)? };
        line.expect(",")?;
        Ok(ThroughPoint { pose, externals: Vec::new(), configuration: Vec::new() })
    }

    /// `pose_trans(work, p[...])`
    fn work_pose(&self, line: &mut Scan<'a>) -> Read<RobotPose> {
        line.expect("pose_trans(")?;
        let from = line.at;
        let name = line.name()?;
        if name != "work" || !self.poses.contains_key(name) {
            let message = Message::new("post-robot-undeclared").text("name", name);
            return Err(Fault::new(line.since(from), message));
        }
        line.expect(",")?;
        let pose = self.pose(line)?;
        line.expect(")")?;
        Ok(pose)
    }

    /// A pose, `a=, v=, r=`; only mode 0 of arcs is known.
    fn motion(&self, line: &mut Scan<'a>) -> Read<Motion> {
        let to = self.work_pose(line)?;
        let from = line.at;
        let options = self.options(line)?;
        if options.get("mode").is_some_and(|mode| *mode != 0.0) {
            return Err(line.unknown(from, "mode"));
        }
        let speed = options.get("v").copied().unwrap_or(0.25);
        let zone_mm = MM_PER_M * options.get("r").copied().unwrap_or(0.0).max(0.0);
        Ok(Motion { to, speed_mm_s: MM_PER_M * positive(speed, line.since(from))?, zone_mm })
    }

    /// Named arguments.
    fn options(&self, line: &mut Scan<'a>) -> Read<BTreeMap<&'a str, f64>> {
        let mut all = BTreeMap::new();
        while line.take(",") {
            let from = line.at;
            let name = line.name()?;
            if !["a", "v", "t", "r", "mode"].contains(&name) {
                return Err(line.unknown(from, name));
            }
            line.expect("=")?;
            all.insert(name, line.number()?);
        }
        Ok(all)
    }
}
