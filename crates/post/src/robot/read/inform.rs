//! Reader of Yaskawa INFORM jobs: positions in rectangular form and the instructions from NOP to END.

use super::scan::{Scan, positive};
use crate::read::error::{Fault, Read};
use crate::robot::angles::from_euler_zyx;
use crate::robot::language::POSITION_LEVEL_1_MM;
use crate::robot::pose::RobotPose;
use crate::robot::program::{ArcEnd, ArcStart, LineMove, RobotProgram, RobotStep};
use crate::robot::weld_values::WeldValues;
use glam::DVec3;
use seamwright_message::Message;
use std::collections::BTreeMap;

pub(super) fn read(text: &str) -> Read<RobotProgram> {
    let mut reader = Reader::default();
    let mut scan = Scan::new(text);
    while let Some(mut line) = scan.line() {
        reader.line(&mut line)?;
    }
    if reader.part != Part::Ended {
        return Err(scan.missing("END"));
    }
    if reader.points != Some(reader.positions.len()) {
        return Err(scan.missing("NPOS"));
    }
    Ok(RobotProgram { title: String::new(), frames: None, steps: reader.steps })
}

/// Part of the job.
#[derive(Default, Clone, Copy, PartialEq, Eq)]
enum Part {
    #[default]
    Head,
    Positions,
    Settings,
    Instructions,
    Ended,
}

#[derive(Default)]
struct Reader<'a> {
    part: Part,
    points: Option<usize>,
    /// Form of the positions that follow: all must be in the user frame, in rectangular form.
    in_user_frame: bool,
    rectangular: bool,
    configuration: Vec<i32>,
    positions: BTreeMap<&'a str, LineMove>,
    steps: Vec<RobotStep>,
}

impl<'a> Reader<'a> {
    fn line(&mut self, line: &mut Scan<'a>) -> Read {
        if line.is_empty() {
            return Ok(());
        }
        match self.part {
            Part::Head => {
                if line.take("//POS") {
                    self.part = Part::Positions;
                    return Ok(());
                }
                if line.take("/JOB") || line.take("//NAME") { Ok(()) } else { Err(line.missing("/JOB")) }
            }
            Part::Positions => self.position(line),
            Part::Settings => {
                if line.take("NOP") {
                    self.part = Part::Instructions;
                } else if !line.take("///") {
                    return Err(line.missing("NOP"));
                }
                Ok(())
            }
            Part::Instructions => self.instruction(line),
            Part::Ended => Err(line.unknown(line.at, "END")),
        }
    }

    /// A line between //POS and //INST.
    fn position(&mut self, line: &mut Scan<'a>) -> Read {
        if line.take("//INST") {
            self.part = Part::Settings;
        } else if line.take("///NPOS") {
            let counts = line.numbers::<6>(",")?;
            self.points = Some(counts[0].max(0.0) as usize);
        } else if line.take("///POSTYPE") {
            self.in_user_frame = line.name()? == "USER";
        } else if line.take("///RECTAN") {
            self.rectangular = true;
        } else if line.take("///RCONF") {
            self.configuration = line.numbers::<8>(",")?.map(|number| number as i32).to_vec();
        } else if line.take("///USER") || line.take("///TOOL") {
            line.number()?;
        } else {
            let from = line.at;
            let name = line.name()?;
            if !(self.in_user_frame && self.rectangular) || self.configuration.is_empty() {
                return Err(line.unknown(from, name));
            }
            line.expect("=")?;
            let [x, y, z, rx, ry, rz] = line.numbers(",")?;
            let turn = from_euler_zyx([rz, ry, rx].map(f64::to_radians));
            let to = RobotPose { point: DVec3::new(x, y, z), turn };
            let configuration = self.configuration.clone();
            let line = LineMove { to, externals: Vec::new(), configuration, speed_mm_s: 0.0, zone_mm: 0.0 };
            self.positions.insert(name, line);
        }
        line.end_of_line("\r")
    }

    fn instruction(&mut self, line: &mut Scan<'a>) -> Read {
        if line.take("'PASS ") {
            self.steps.push(RobotStep::Pass(line.rest().trim().to_owned()));
            return Ok(());
        }
        if line.take("'") {
            return Ok(());
        }
        let from = line.at;
        let word = line.name()?;
        match word {
            "MOVJ" => {
                let to = self.point(line)?;
                line.expect("VJ=")?;
                positive(line.number()?, line.since(from))?;
                line.expect("PL=0")?;
                self.steps.push(RobotStep::JointsTo(to));
            }
            "MOVL" => {
                let mut to = self.point(line)?;
                line.expect("V=")?;
                to.speed_mm_s = positive(line.number()?, line.since(from))?;
                line.expect("PL=")?;
                let level = line.number()?;
                to.zone_mm = match level {
                    0.0 => 0.0,
                    1.0 => POSITION_LEVEL_1_MM,
                    _ => return Err(Fault::new(line.since(from), "post-robot-zone")),
                };
                self.steps.push(RobotStep::Line(to));
            }
            "ARCON" => {
                let values = values(line)?;
                line.expect("T=")?;
                let delay_s = line.number()?;
                self.steps.push(RobotStep::ArcOn(ArcStart { preflow_s: 0.0, delay_s, values }));
            }
            "ARCSET" => self.steps.push(RobotStep::Values(values(line)?)),
            "ARCOF" => {
                line.expect("T=")?;
                let crater_s = line.number()?;
                self.steps.push(RobotStep::ArcOff(ArcEnd { crater_s, postflow_s: 0.0 }));
            }
            "TIMER" => {
                line.expect("T=")?;
                self.steps.push(RobotStep::Wait(line.number()?));
            }
            "END" => self.part = Part::Ended,
            _ => return Err(line.unknown(from, word)),
        }
        line.end_of_line("\r")
    }

    /// The position that a move names.
    fn point(&self, line: &mut Scan<'a>) -> Read<LineMove> {
        line.blanks();
        let from = line.at;
        let name = line.name()?;
        let undeclared = || Fault::new(line.since(from), Message::new("post-robot-undeclared").text("name", name));
        self.positions.get(name).cloned().ok_or_else(undeclared)
    }
}

fn values(line: &mut Scan) -> Read<WeldValues> {
    line.expect("AC=")?;
    let current_a = line.number()?;
    line.expect("AV=")?;
    let voltage_v = line.number()?;
    Ok(WeldValues { current_a, voltage_v, wire_feed_m_min: 0.0 })
}
