//! ABB RAPID with the instructions of RobotWare Arc.
//!
//! Source: ABB, Technical reference manual RAPID instructions, functions and data types (3HAC050917), and Application
//! manual Arc and Arc Sensor (3HAC050988).

use super::RobotText;
use super::text::{head, joined};
use crate::robot::language::RobotLanguage;
use crate::robot::pose::RobotPose;
use crate::robot::program::{ArcEnd, ArcStart, JointTarget, RobotProgram, RobotStep, TcpMove};
use crate::robot::weld_values::WeldValues;
use crate::write::fixed;
use std::fmt::Write as _;

/// An external axis that is not there.
const NO_AXIS: &str = "9E9";
/// mm/s in a m/min: arcdata count the wire in mm/s.
const MM_S_PER_M_MIN: f64 = 1000.0 / 60.0;
const NO_ARC: &str = "[0,0,0,0,0,0,0,0,0]";
const TOOL: &str = r"tTorch\WObj:=wWork";

pub(super) fn write(program: &RobotProgram, options: &RobotText) -> String {
    let mut rapid = Rapid::default();
    rapid.steps(&program.steps);
    let mut text = String::from("MODULE SeamwrightWeld\n");
    for line in head(RobotLanguage::Rapid, program, options) {
        text.push_str(&format!("  ! {line}\n"));
    }
    text.push_str("  ! units of Arc: mm/s for speed and wire (SI_UNITS)\n");
    let tool = pose(&options.arm.tool);
    text.push_str(&format!("  PERS tooldata tTorch:=[TRUE,{tool},[3,[0,0,100],[1,0,0,0],0,0,0]];\n"));
    text.push_str(&work_object(options));
    for line in &rapid.data {
        text.push_str(&format!("  {line}\n"));
    }
    text.push_str("  PROC main()\n");
    for k in 1..=rapid.passes {
        text.push_str(&format!("    pass_{k};\n"));
    }
    text.push_str("  ENDPROC\n");
    text.push_str(&rapid.body);
    text.push_str("ENDMODULE\n");
    text
}

/// With a positioner the work frame is coordinated with its mechanical unit.
fn work_object(options: &RobotText) -> String {
    let work = pose(&options.arm.work);
    let none = pose(&RobotPose::IDENTITY);
    match options.arm.has_positioner() {
        true => format!("  PERS wobjdata wWork:=[FALSE,FALSE,\"STN_1\",{none},{work}];\n"),
        false => format!("  PERS wobjdata wWork:=[FALSE,TRUE,\"\",{work},{none}];\n"),
    }
}

/// Position and orientation with the scalar part of the quaternion first.
fn pose(pose: &RobotPose) -> String {
    let [x, y, z, w] = pose.turn.to_array();
    format!("[[{}],[{}]]", joined(pose.point.to_array(), 4, ","), joined([w, x, y, z], 8, ","))
}

#[derive(Default)]
struct Rapid {
    /// Declarations of weld and seam data.
    data: Vec<String>,
    body: String,
    /// Weld data so far: speed and values.
    welds: Vec<(f64, WeldValues)>,
    passes: usize,
}

impl Rapid {
    fn steps(&mut self, steps: &[RobotStep]) {
        let mut values: Option<WeldValues> = None;
        let mut seam = 0;
        for (i, step) in steps.iter().enumerate() {
            match step {
                RobotStep::Pass(name) => self.pass(name),
                RobotStep::Joints(target) => self.joints(target),
                RobotStep::Move(line) | RobotStep::JointsTo(line) => {
                    let next = steps.get(i + 1);
                    if let Some(RobotStep::ArcOn(start)) = next {
                        seam += 1;
                        self.seam(seam, start, ending(&steps[i + 1..]));
                        values = Some(start.values);
                        self.arc("ArcLStart", line, seam, (first_speed(&steps[i + 2..]), start.values));
                    } else if let Some(now) = values {
                        let is_end = matches!(next, Some(RobotStep::ArcOff(_)));
                        let word = match (line.via.is_some(), is_end) {
                            (false, false) => "ArcL",
                            (false, true) => "ArcLEnd",
                            (true, false) => "ArcC",
                            (true, true) => "ArcCEnd",
                        };
                        self.arc(word, line, seam, (line.speed_mm_s, now));
                    } else {
                        self.line(line);
                    }
                }
                RobotStep::Values(now) => values = Some(*now),
                RobotStep::ArcOff(_) => values = None,
                // Only URScript has set-points.
                RobotStep::SetPoints(_) => {}
                RobotStep::Wait(seconds) => self.statement(&format!("WaitTime {}", fixed(*seconds, 3))),
                RobotStep::ArcOn(_) => {}
            }
        }
        if self.passes > 0 {
            self.body.push_str("  ENDPROC\n");
        }
    }

    fn pass(&mut self, name: &str) {
        if self.passes > 0 {
            self.body.push_str("  ENDPROC\n");
        }
        self.passes += 1;
        let name = super::text::plain(name);
        // Writing to a String cannot fail.
        let _ = write!(self.body, "  PROC pass_{}()\n    ! {name}\n", self.passes);
    }

    fn statement(&mut self, text: &str) {
        self.body.push_str(&format!("    {text};\n"));
    }

    fn externals(&self, values: &[f64]) -> String {
        let given = values.iter().map(|value| fixed(*value, 4));
        given.chain(std::iter::repeat(NO_AXIS.to_owned())).take(6).collect::<Vec<_>>().join(",")
    }

    fn joints(&mut self, target: &JointTarget) {
        let (arm, externals) = (joined(target.arm, 5, ","), self.externals(&target.externals));
        self.statement(&format!("MoveAbsJ [[{arm}],[{externals}]],v200,fine,tTorch"));
    }

    fn target(&self, to: &RobotPose, configuration: &[i32], externals: &[f64]) -> String {
        let pose = pose(to);
        let inner = &pose[1..pose.len() - 1];
        let data: Vec<String> = configuration.iter().map(i32::to_string).collect();
        format!("[{inner},[{}],[{}]]", data.join(","), self.externals(externals))
    }

    /// The end of a move, behind the through-point of an arc.
    fn targets(&self, line: &TcpMove) -> String {
        let to = self.target(&line.to, &line.configuration, &line.externals);
        match &line.via {
            Some(via) => format!("{},{to}", self.target(&via.pose, &via.configuration, &via.externals)),
            None => to,
        }
    }

    fn line(&mut self, line: &TcpMove) {
        let (targets, speed) = (self.targets(line), speed_data(line.speed_mm_s));
        let (word, zone) = (if line.via.is_some() { "MoveC" } else { "MoveL" }, zone(line.zone_mm));
        self.statement(&format!("{word} {targets},{speed},{zone},{TOOL}"));
    }

    fn arc(&mut self, word: &str, line: &TcpMove, seam: usize, weld: (f64, WeldValues)) {
        let weld = self.weld(weld);
        let (targets, zone) = (self.targets(line), zone(line.zone_mm));
        // Lines of a weld have the speed of their weld data; theirs is for trial runs without an arc.
        let speed = if word == "ArcLStart" { speed_data(line.speed_mm_s) } else { "v50".to_owned() };
        self.statement(&format!("{word} {targets},{speed},sm{seam},wd{weld},{zone},{TOOL}"));
    }

    /// Number of the weld data for a speed and values.
    fn weld(&mut self, weld: (f64, WeldValues)) -> usize {
        if let Some(known) = self.welds.iter().position(|w| *w == weld) {
            return known + 1;
        }
        self.welds.push(weld);
        let (speed, number) = (fixed(weld.0, 2), self.welds.len());
        self.data.push(format!("PERS welddata wd{number}:=[{speed},0,{},{NO_ARC}];", arc_data(&weld.1)));
        number
    }

    fn seam(&mut self, number: usize, start: &ArcStart, end: ArcEnd) {
        let arc = arc_data(&start.values);
        let [preflow, delay, crater, postflow] =
            [start.preflow_s, start.delay_s, end.crater_s, end.postflow_s].map(|s| fixed(s, 3));
        self.data.push(format!(
            "PERS seamdata sm{number}:=[0,{preflow},{arc},{delay},0,0,0,0,{arc},0,{crater},{arc},0,0,{NO_ARC},{postflow}];"
        ));
    }
}

/// sched, mode, voltage, wirefeed, control, current, voltage2, wirefeed2, control2.
fn arc_data(values: &WeldValues) -> String {
    let wire = fixed(values.wire_feed_m_min * MM_S_PER_M_MIN, 4);
    format!("[0,0,{},{wire},0,{},0,0,0]", fixed(values.voltage_v, 3), fixed(values.current_a, 3))
}

/// Speed of the tool centre point (mm/s); orientation and external axes have their usual limits.
fn speed_data(mm_s: f64) -> String {
    format!("[{},500,5000,1000]", fixed(mm_s, 2))
}

fn zone(zone_mm: f64) -> String {
    if zone_mm > 0.0 { format!("z{}", zone_mm.floor()) } else { "fine".to_owned() }
}

fn ending(steps: &[RobotStep]) -> ArcEnd {
    let end = steps.iter().find_map(|step| if let RobotStep::ArcOff(end) = step { Some(*end) } else { None });
    end.unwrap_or(ArcEnd { crater_s: 0.0, postflow_s: 0.0 })
}

fn first_speed(steps: &[RobotStep]) -> f64 {
    let speed =
        steps.iter().find_map(|step| if let RobotStep::Move(line) = step { Some(line.speed_mm_s) } else { None });
    speed.unwrap_or(1.0)
}
