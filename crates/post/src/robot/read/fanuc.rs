//! Reader of FANUC LS: instructions of /MN and the positions of /POS.

use super::scan::{Scan, positive};
use crate::read::error::{Fault, Read, Span};
use crate::robot::angles::from_euler_zyx;
use crate::robot::language::CNT_S;
use crate::robot::pose::RobotPose;
use crate::robot::program::{
    ArcEnd, ArcStart, JointTarget, RobotFrames, RobotProgram, RobotStep, TcpMove, ThroughPoint,
};
use crate::robot::weld_values::WeldValues;
use glam::DVec3;
use seamwright_message::Message;
use std::collections::BTreeMap;

/// Part of the text.
#[derive(Default, Clone, Copy, PartialEq, Eq)]
enum Section {
    #[default]
    Head,
    Program,
    Positions,
    End,
}

/// A position of /POS: its words with their numbers, and the configuration.
#[derive(Default, Clone)]
struct Position<'a> {
    numbers: BTreeMap<&'a str, f64>,
    /// The same of group 2, the positioner.
    second: BTreeMap<&'a str, f64>,
    in_second: bool,
    configuration: Vec<i32>,
}

/// A motion before its position is known.
struct Motion {
    point: i32,
    /// Through-point of an arc.
    via: Option<i32>,
    span: Span,
    speed_mm_s: f64,
    zone_mm: f64,
    is_line: bool,
    /// Whether the positioner leads: the move is straight or round on it.
    is_coordinated: bool,
}

enum Item {
    Step(RobotStep),
    Motion(Motion),
}

pub(super) fn read(text: &str) -> Read<RobotProgram> {
    let mut reader = Reader::default();
    let mut scan = Scan::new(text);
    while let Some(mut line) = scan.line() {
        reader.line(&mut line)?;
    }
    if reader.section != Section::End {
        return Err(scan.missing("/END"));
    }
    reader.finish(&scan)
}

#[derive(Default)]
struct Reader<'a> {
    section: Section,
    items: Vec<Item>,
    registers: BTreeMap<i32, [f64; 6]>,
    frames: BTreeMap<&'static str, [f64; 6]>,
    positions: BTreeMap<i32, Position<'a>>,
    /// Position under way.
    open: Option<(i32, Position<'a>)>,
    burning: bool,
    /// Through-point of an arc whose end is in the next line.
    via: Option<i32>,
}

impl<'a> Reader<'a> {
    fn line(&mut self, line: &mut Scan<'a>) -> Read {
        if line.is_empty() {
            return Ok(());
        }
        let heads = [("/MN", Section::Program), ("/POS", Section::Positions), ("/END", Section::End)];
        for (word, section) in heads {
            if self.open.is_none() && line.take(word) {
                self.section = section;
                return line.end_of_line("\r");
            }
        }
        match self.section {
            Section::Head => Ok(()),
            Section::Program => self.instruction(line),
            Section::Positions => self.position(line),
            Section::End => Err(line.unknown(line.at, "/END")),
        }
    }

    /// `12:L P[3] 6.0mm/sec CNT100 ;`
    fn instruction(&mut self, line: &mut Scan<'a>) -> Read {
        if let Some(via) = self.via.take() {
            line.expect(":")?;
            let from = line.at;
            line.expect("P[")?;
            self.motion(from, Some(via), line)?;
            line.expect(";")?;
            return line.end_of_line("\r");
        }
        line.number()?;
        line.expect(":")?;
        if line.take("!PASS ") {
            let name = line.until(';')?.trim().to_owned();
            self.items.push(Item::Step(RobotStep::Pass(name)));
            return Ok(());
        }
        if line.take("!") {
            return line.until(';').map(drop);
        }
        line.blanks();
        let from = line.at;
        if line.take("J P[") {
            let point = index(line)?;
            line.number()?;
            line.expect("% FINE")?;
            let motion = Motion {
                point,
                via: None,
                span: line.since(from),
                speed_mm_s: 0.0,
                zone_mm: 0.0,
                is_line: false,
                is_coordinated: true,
            };
            self.items.push(Item::Motion(motion));
        } else if line.take("L P[") {
            self.motion(from, None, line)?;
        } else if line.take("C P[") {
            self.via = Some(index(line)?);
            return line.end_of_line("\r");
        } else if line.take("Weld Start[1,") {
            self.weld_start(line)?;
        } else if line.take("Weld End[1,") {
            weld_values(line)?;
            line.expect(",")?;
            let crater_s = line.number()?;
            line.expect("s]")?;
            self.burning = false;
            self.items.push(Item::Step(RobotStep::ArcOff(ArcEnd { crater_s, postflow_s: 0.0 })));
        } else if line.take("WAIT") {
            let seconds = line.number()?;
            line.expect("(sec)")?;
            self.wait(seconds);
        } else if line.take("PR[") {
            self.register(line)?;
        } else if !(line.take("UFRAME_NUM=1") || line.take("UTOOL_NUM=1")) {
            self.set_frame(from, line)?;
        }
        line.expect(";")?;
        line.end_of_line("\r")
    }

    fn motion(&mut self, from: usize, via: Option<i32>, line: &mut Scan<'a>) -> Read {
        let point = index(line)?;
        let speed_mm_s = positive(line.number()?, line.since(from))?;
        line.expect("mm/sec")?;
        let zone_mm = if line.take("FINE") {
            0.0
        } else {
            line.expect("CNT")?;
            let part = line.number()?;
            if !(0.0..=100.0).contains(&part) {
                return Err(Fault::new(line.since(from), "post-robot-zone"));
            }
            0.01 * part * CNT_S * speed_mm_s
        };
        let is_coordinated = line.take("COORD");
        let span = line.since(from);
        let motion = Motion { point, via, span, speed_mm_s, zone_mm, is_line: true, is_coordinated };
        self.items.push(Item::Motion(motion));
        Ok(())
    }

    /// The first one of a weld ignites, others change the values.
    fn weld_start(&mut self, line: &mut Scan<'a>) -> Read {
        let values = weld_values(line)?;
        line.expect("]")?;
        self.items.push(Item::Step(match std::mem::replace(&mut self.burning, true) {
            false => RobotStep::ArcOn(ArcStart { preflow_s: 0.0, delay_s: 0.0, values }),
            true => RobotStep::Values(values),
        }));
        Ok(())
    }

    /// A wait behind the ignition is the delay of the travel.
    fn wait(&mut self, seconds: f64) {
        match self.items.last_mut() {
            Some(Item::Step(RobotStep::ArcOn(on))) => on.delay_s += seconds,
            _ => self.items.push(Item::Step(RobotStep::Wait(seconds))),
        }
    }

    /// `PR[90]=LPOS` or `PR[90,1]=12.3`
    fn register(&mut self, line: &mut Scan<'a>) -> Read {
        let from = line.at;
        let number = whole(line)?;
        if line.take("]=LPOS") {
            self.registers.insert(number, [0.0; 6]);
            return Ok(());
        }
        line.expect(",")?;
        let element = whole(line)?;
        line.expect("]=")?;
        let value = line.number()?;
        let register = self.registers.get_mut(&number);
        let slot = register.and_then(|register| register.get_mut(usize::try_from(element - 1).ok()?));
        let Some(slot) = slot else { return Err(line.unknown(from, "PR")) };
        *slot = value;
        Ok(())
    }

    fn set_frame(&mut self, from: usize, line: &mut Scan<'a>) -> Read {
        for name in ["UFRAME", "UTOOL"] {
            if line.take(name) {
                line.expect("[1]=PR[")?;
                let number = index(line)?;
                let Some(values) = self.registers.get(&number) else { return Err(line.unknown(from, name)) };
                self.frames.insert(name, *values);
                return Ok(());
            }
        }
        let word: String = line.rest().chars().take(20).collect();
        Err(line.unknown(from, &word))
    }

    /// Lines of a position: `P[1]{`, `GP1:`, words with numbers and units, `};`
    fn position(&mut self, line: &mut Scan<'a>) -> Read {
        let Some((number, mut position)) = self.open.take() else {
            line.expect("P[")?;
            let number = index(line)?;
            line.expect("{")?;
            self.open = Some((number, Position::default()));
            return line.end_of_line("\r");
        };
        if line.take("};") {
            self.positions.insert(number, position);
            return line.end_of_line("\r");
        }
        if line.take("GP2:") {
            position.in_second = true;
        } else if !line.take("GP1:") {
            words(line, &mut position)?;
        }
        self.open = Some((number, position));
        line.end_of_line("\r")
    }

    fn finish(self, scan: &Scan<'a>) -> Read<RobotProgram> {
        let mut steps = Vec::new();
        for item in self.items {
            let motion = match item {
                Item::Step(step) => {
                    steps.push(step);
                    continue;
                }
                Item::Motion(motion) => motion,
            };
            let undeclared = |point: i32| {
                let name = format!("P[{point}]");
                Fault::new(motion.span, Message::new("post-robot-undeclared").text("name", name))
            };
            if self
                .positions
                .get(&motion.point)
                .is_some_and(|at| at.in_second != motion.is_coordinated && motion.is_line)
            {
                let message = Message::new("post-robot-expected").text("token", "COORD, GP2");
                return Err(Fault::new(motion.span, message));
            }
            let at = |point: i32| self.positions.get(&point).ok_or_else(|| undeclared(point));
            let via = match motion.via {
                Some(point) => Some(through_point(at(point)?).ok_or_else(|| undeclared(point))?),
                None => None,
            };
            steps.push(step(&motion, via, at(motion.point)?).ok_or_else(|| undeclared(motion.point))?);
        }
        let frame = |name| self.frames.get(name).ok_or_else(|| scan.missing(name)).map(pose);
        let frames = RobotFrames { tool: frame("UTOOL")?, work: frame("UFRAME")? };
        Ok(RobotProgram { title: String::new(), frames: Some(frames), steps })
    }
}

/// The step of a motion; `None` if its position lacks a number.
fn step(motion: &Motion, via: Option<ThroughPoint>, position: &Position) -> Option<RobotStep> {
    if motion.is_line {
        let ThroughPoint { pose: to, externals, configuration } = through_point(position)?;
        let (speed_mm_s, zone_mm) = (motion.speed_mm_s, motion.zone_mm);
        return Some(RobotStep::Move(TcpMove { via, to, externals, configuration, speed_mm_s, zone_mm }));
    }
    let of = |name: &str| position.numbers.get(name).copied();
    let externals = position.externals();
    let mut arm = [of("J1")?, of("J2")?, of("J3")?, of("J4")?, of("J5")?, of("J6")?];
    // J3 of the pendant is counted from the horizontal.
    arm[2] += arm[1];
    Some(RobotStep::Joints(JointTarget { arm, externals }))
}

/// The pose of a position; `None` if it lacks a number.
fn through_point(position: &Position) -> Option<ThroughPoint> {
    let of = |name: &str| position.numbers.get(name).copied();
    let pose = pose(&[of("X")?, of("Y")?, of("Z")?, of("W")?, of("P")?, of("R")?]);
    let configuration = position.configuration.clone();
    Some(ThroughPoint { pose, externals: position.externals(), configuration })
}

impl Position<'_> {
    /// Extended axes of the arm, then those of the positioner.
    fn externals(&self) -> Vec<f64> {
        let extended = ["E1", "E2", "E3"].iter().map_while(|name| self.numbers.get(name).copied());
        let positioner = ["J1", "J2", "J3"].iter().map_while(|name| self.second.get(name).copied());
        extended.chain(positioner).collect()
    }
}

/// X, Y, Z, and W, P, R about the fixed x, y and z.
fn pose(numbers: &[f64; 6]) -> RobotPose {
    let [x, y, z, w, p, r] = *numbers;
    RobotPose { point: DVec3::new(x, y, z), turn: from_euler_zyx([r, p, w].map(f64::to_radians)) }
}

/// `X = 1.0 mm,` and `CONFIG : 'N U T, 0, 0, 0',`
fn words<'a>(line: &mut Scan<'a>, position: &mut Position<'a>) -> Read {
    while !line.is_empty() {
        let from = line.at;
        let name = line.name()?;
        if name == "CONFIG" {
            line.expect(":")?;
            line.expect("'")?;
            position.configuration = configuration(line)?;
            line.expect("'")?;
        } else if line.take(":") {
            line.number()?;
        } else {
            line.expect("=")?;
            let value = line.number()?;
            if !line.take("mm") && !line.take("deg") {
                return Err(line.missing("mm"));
            }
            let numbers = if position.in_second { &mut position.second } else { &mut position.numbers };
            if numbers.insert(name, value).is_some() {
                return Err(line.unknown(from, name));
            }
        }
        if !line.take(",") {
            break;
        }
    }
    Ok(())
}

fn configuration(line: &mut Scan) -> Read<Vec<i32>> {
    let mut data = Vec::new();
    for [clear, set] in [["N", "F"], ["D", "U"], ["B", "T"]] {
        let is_set = line.take(set);
        if !is_set {
            line.expect(clear)?;
        }
        data.push(i32::from(is_set));
    }
    for _ in 0..3 {
        line.expect(",")?;
        data.push(whole(line)?);
    }
    Ok(data)
}

fn weld_values(line: &mut Scan) -> Read<WeldValues> {
    let voltage_v = line.number()?;
    line.expect("Volts,")?;
    let current_a = line.number()?;
    line.expect("Amps")?;
    Ok(WeldValues { current_a, voltage_v, wire_feed_m_min: 0.0 })
}

fn whole(line: &mut Scan) -> Read<i32> {
    let from = line.at;
    let number = line.number()?;
    if number.fract() == 0.0 && number.abs() < 1e9 {
        return Ok(number as i32);
    }
    Err(Fault::new(line.since(from), "post-robot-whole"))
}

/// A whole number and the bracket behind it.
fn index(line: &mut Scan) -> Read<i32> {
    let number = whole(line)?;
    line.expect("]")?;
    Ok(number)
}
