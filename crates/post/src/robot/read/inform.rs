//! Reader of Yaskawa INFORM jobs: positions in rectangular form and the instructions from NOP to END.

use super::scan::{Scan, positive};
use crate::read::error::{Fault, Read};
use crate::robot::angles::from_euler_zyx;
use crate::robot::language::POSITION_LEVEL_1_MM;
use crate::robot::pose::RobotPose;
use crate::robot::program::{ArcEnd, ArcStart, RobotProgram, RobotStep, TcpMove, ThroughPoint};
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
    if reader.points != Some([reader.positions.len(), reader.bases.len(), reader.stations.len()]) {
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
    /// Numbers of positions of the arm, of the base axes and of the station.
    points: Option<[usize; 3]>,
    /// Form of the positions that follow: those of the arm must be in the user frame, those of the base axes in the base
    /// frame, both in rectangular form.
    frame: &'a str,
    rectangular: bool,
    configuration: Vec<i32>,
    positions: BTreeMap<&'a str, TcpMove>,
    /// Positions of the base axes, mm.
    bases: BTreeMap<&'a str, Vec<f64>>,
    /// Angles of the station, degrees.
    stations: BTreeMap<&'a str, Vec<f64>>,
    steps: Vec<RobotStep>,
    arc: ArcPoints,
}

/// Positions of an arc so far.
#[derive(Default)]
enum ArcPoints {
    #[default]
    None,
    Started,
    Through(ThroughPoint),
    Ended,
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
            self.points = Some([counts[0], counts[1], counts[2]].map(|count| count.max(0.0) as usize));
        } else if line.take("///POSTYPE") {
            self.frame = line.name()?;
        } else if line.take("///RECTAN") {
            self.rectangular = true;
        } else if line.take("///ANGLE") {
            self.rectangular = false;
        } else if line.take("///RCONF") {
            self.configuration = line.numbers::<8>(",")?.map(|number| number as i32).to_vec();
        } else if line.take("///USER") || line.take("///TOOL") {
            line.number()?;
        } else {
            let from = line.at;
            let name = line.name()?;
            if name.starts_with("EC") && !self.rectangular {
                let angles = numbers(line)?;
                self.stations.insert(name, angles);
                return line.end_of_line("\r");
            }
            if name.starts_with("BC") && self.frame == "BASE" && self.rectangular {
                let distances = numbers(line)?;
                self.bases.insert(name, distances);
                return line.end_of_line("\r");
            }
            if !(self.frame == "USER" && self.rectangular) || self.configuration.is_empty() {
                return Err(line.unknown(from, name));
            }
            line.expect("=")?;
            let [x, y, z, rx, ry, rz] = line.numbers(",")?;
            let turn = from_euler_zyx([rz, ry, rx].map(f64::to_radians));
            let to = RobotPose { point: DVec3::new(x, y, z), turn };
            let configuration = self.configuration.clone();
            let line = TcpMove { via: None, to, externals: Vec::new(), configuration, speed_mm_s: 0.0, zone_mm: 0.0 };
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
                let mut to = self.point(line)?;
                if !line.take("VJ=") {
                    to.externals.extend(Self::named(&self.stations, line)?);
                    line.expect("VJ=")?;
                }
                positive(line.number()?, line.since(from))?;
                line.expect("PL=0")?;
                self.steps.push(RobotStep::JointsTo(to));
            }
            "MOVL" | "MOVC" | "SMOVL" | "SMOVC" => self.motion(word, from, line)?,
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

    /// A move to a position. Of the positions of MOVC in a row the first is the start of an arc, to which a line leads, the
    /// second its through-point and the third its end.
    fn motion(&mut self, word: &str, from: usize, line: &mut Scan<'a>) -> Read {
        let (is_arc, is_coordinated) = (word.ends_with('C'), word.starts_with('S'));
        let mut to = self.point(line)?;
        line.expect("V=")?;
        to.speed_mm_s = positive(line.number()?, line.since(from))?;
        let zone = if line.take("PL=") { Some(line.number()?) } else { None };
        if is_coordinated {
            line.expect("+MOVJ")?;
            to.externals.extend(Self::named(&self.stations, line)?);
        }
        self.arc = match (is_arc, std::mem::take(&mut self.arc)) {
            (false, ArcPoints::None | ArcPoints::Ended) => ArcPoints::None,
            (true, ArcPoints::None) => ArcPoints::Started,
            (true, ArcPoints::Started) => {
                let TcpMove { to: pose, externals, configuration, .. } = to;
                self.arc = ArcPoints::Through(ThroughPoint { pose, externals, configuration });
                return Ok(());
            }
            (true, ArcPoints::Through(via)) => {
                to.via = Some(via);
                ArcPoints::Ended
            }
            _ => return Err(line.unknown(from, "MOVC")),
        };
        to.zone_mm = match zone {
            Some(0.0) => 0.0,
            Some(1.0) => POSITION_LEVEL_1_MM,
            None => return Err(line.missing("PL=")),
            Some(_) => return Err(Fault::new(line.since(from), "post-robot-zone")),
        };
        self.steps.push(RobotStep::Move(to));
        Ok(())
    }

    /// The position of `all` that a move names.
    fn named<T: Clone>(all: &BTreeMap<&'a str, T>, line: &mut Scan<'a>) -> Read<T> {
        line.blanks();
        let from = line.at;
        let name = line.name()?;
        let undeclared = || Fault::new(line.since(from), Message::new("post-robot-undeclared").text("name", name));
        all.get(name).cloned().ok_or_else(undeclared)
    }

    /// The position that a move names, with that of the base axes: `C00000 BC00000`
    fn point(&self, line: &mut Scan<'a>) -> Read<TcpMove> {
        let mut to = Self::named(&self.positions, line)?;
        line.blanks();
        if line.rest().starts_with("BC") {
            to.externals = Self::named(&self.bases, line)?;
        }
        Ok(to)
    }
}

/// `=12.5,30`
fn numbers(line: &mut Scan) -> Read<Vec<f64>> {
    line.expect("=")?;
    let mut all = vec![line.number()?];
    while line.take(",") {
        all.push(line.number()?);
    }
    Ok(all)
}

fn values(line: &mut Scan) -> Read<WeldValues> {
    line.expect("AC=")?;
    let current_a = line.number()?;
    line.expect("AV=")?;
    let voltage_v = line.number()?;
    Ok(WeldValues { current_a, voltage_v, wire_feed_m_min: 0.0 })
}
