//! Reader of ABB RAPID: data declarations, procedures without arguments, moves and arc moves.

use super::scan::{Scan, positive};
use crate::read::error::{Fault, Read, Span};
use crate::robot::pose::RobotPose;
use crate::robot::program::{
    ArcEnd, ArcStart, JointTarget, RobotFrames, RobotProgram, RobotStep, TcpMove, ThroughPoint,
};
use crate::robot::weld_values::WeldValues;
use glam::{DQuat, DVec3};
use seamwright_message::Message;
use std::collections::BTreeMap;

/// Lists within lists.
const DEEPEST: usize = 8;
/// Numbers from here on stand for an axis that is not there.
const NO_AXIS: f64 = 8.9e9;
const MM_S_PER_M_MIN: f64 = 1000.0 / 60.0;
/// Deviation of a quaternion's length from 1.
const NOT_UNIT: f64 = 1e-3;

/// A value with its place in the text.
#[derive(Debug, Clone)]
struct Value<'a> {
    span: Span,
    what: Literal<'a>,
}

#[derive(Debug, Clone)]
enum Literal<'a> {
    List(Vec<Value<'a>>),
    Number(f64),
    Text,
    Name(&'a str),
}

pub(super) fn read(text: &str) -> Read<RobotProgram> {
    let mut reader = Reader::default();
    let mut scan = Scan::new(text);
    while let Some(mut line) = scan.line() {
        reader.line(&mut line)?;
    }
    reader.finish(&scan)
}

/// Data, procedures and state of the text so far.
#[derive(Default)]
struct Reader<'a> {
    data: BTreeMap<&'a str, Value<'a>>,
    procedures: BTreeMap<&'a str, Vec<RobotStep>>,
    /// Procedures that `main` calls.
    calls: Vec<(&'a str, Span)>,
    inside: Option<&'a str>,
    module: bool,
    ended: bool,
    /// Values of the weld under way.
    values: Option<WeldValues>,
}

impl<'a> Reader<'a> {
    fn line(&mut self, line: &mut Scan<'a>) -> Read {
        if line.is_empty() || line.take("!") || line.take("%%%") {
            return Ok(());
        }
        let from = line.at;
        let word = line.name()?;
        match word.to_ascii_uppercase().as_str() {
            "MODULE" if !self.module => {
                line.name()?;
                self.module = true;
            }
            "VERSION" | "LANGUAGE" if !self.module => return Ok(()),
            "ENDMODULE" if self.module && self.inside.is_none() => self.ended = true,
            "PERS" | "CONST" | "VAR" | "LOCAL" => self.declaration(line)?,
            "PROC" if self.inside.is_none() => {
                let name = line.name()?;
                line.expect("(")?;
                line.expect(")")?;
                if self.procedures.insert(name, Vec::new()).is_some() {
                    return Err(Fault::new(line.since(from), Message::new("post-program-twice").text("name", name)));
                }
                self.inside = Some(name);
            }
            "ENDPROC" if self.inside.is_some() => self.inside = None,
            _ => self.statement(word, from, line)?,
        }
        line.end_of_line("!")
    }

    /// `PERS type name:=value;`
    fn declaration(&mut self, line: &mut Scan<'a>) -> Read {
        line.name()?;
        let name = line.name()?;
        line.expect(":=")?;
        let value = value(line, 0)?;
        line.expect(";")?;
        self.data.insert(name, value);
        Ok(())
    }

    fn statement(&mut self, word: &'a str, from: usize, line: &mut Scan<'a>) -> Read {
        let Some(inside) = self.inside else { return Err(line.unknown(from, word)) };
        if line.take(";") {
            self.calls.push((word, line.since(from)));
            return Ok(());
        }
        let steps = match word.to_ascii_uppercase().as_str() {
            "MOVEABSJ" => self.joints(line)?,
            "MOVEL" => self.move_tcp(line, false)?,
            "MOVEC" => self.move_tcp(line, true)?,
            "ARCLSTART" => self.arc_start(line)?,
            "ARCL" => self.arc_line(line, false)?,
            "ARCC" => self.arc_line(line, true)?,
            "ARCLEND" => self.arc_end(line, false)?,
            "ARCCEND" => self.arc_end(line, true)?,
            "WAITTIME" => vec![RobotStep::Wait(line.number()?)],
            _ => return Err(line.unknown(from, word)),
        };
        line.expect(";")?;
        self.procedures.entry(inside).or_default().extend(steps);
        Ok(())
    }

    fn joints(&self, line: &mut Scan<'a>) -> Read<Vec<RobotStep>> {
        let target = value(line, 0)?;
        let [arm, externals] = self.list(&target)?;
        let arm = self.numbers::<6>(arm)?;
        let externals = self.externals(externals)?;
        self.arguments(line, 2)?;
        tool(line)?;
        Ok(vec![RobotStep::Joints(JointTarget { arm, externals })])
    }

    fn move_tcp(&self, line: &mut Scan<'a>, is_arc: bool) -> Read<Vec<RobotStep>> {
        let mut to = self.targets(line, is_arc)?;
        let arguments = self.arguments(line, 2)?;
        let [speed, zone] = <[Value; 2]>::try_from(arguments).map_err(|_| line.missing("zone"))?;
        to.speed_mm_s = self.speed(&speed)?;
        to.zone_mm = zone_mm(&zone)?;
        tool(line)?;
        Ok(vec![RobotStep::Move(to)])
    }

    /// Target, speed, seam, weld and zone of an arc instruction.
    fn arc(&self, line: &mut Scan<'a>, is_arc: bool) -> Read<ArcMove<'a>> {
        let to = self.targets(line, is_arc)?;
        let arguments = self.arguments(line, 4)?;
        tool(line)?;
        let [speed, seam, weld, zone] = <[Value; 4]>::try_from(arguments).map_err(|_| line.missing("zone"))?;
        Ok(ArcMove { to: TcpMove { zone_mm: zone_mm(&zone)?, ..to }, speed, seam, weld })
    }

    fn arc_start(&mut self, line: &mut Scan<'a>) -> Read<Vec<RobotStep>> {
        let ArcMove { mut to, speed, seam, weld } = self.arc(line, false)?;
        to.speed_mm_s = self.speed(&speed)?;
        let (_, values) = self.weld(&weld)?;
        let seam = self.resolve(&seam)?;
        let parts = self.list::<16>(seam)?;
        let start = ArcStart { preflow_s: self.number(parts[1])?, delay_s: self.number(parts[3])?, values };
        self.values = Some(values);
        Ok(vec![RobotStep::Move(to), RobotStep::ArcOn(start)])
    }

    fn arc_line(&mut self, line: &mut Scan<'a>, is_arc: bool) -> Read<Vec<RobotStep>> {
        let from = line.at;
        let ArcMove { mut to, weld, .. } = self.arc(line, is_arc)?;
        let (speed, values) = self.weld(&weld)?;
        let Some(before) = self.values.replace(values) else {
            return Err(Fault::new(line.since(from), "post-robot-no-arc"));
        };
        to.speed_mm_s = speed;
        let change = (before != values).then_some(RobotStep::Values(values));
        Ok(change.into_iter().chain([RobotStep::Move(to)]).collect())
    }

    fn arc_end(&mut self, line: &mut Scan<'a>, is_arc: bool) -> Read<Vec<RobotStep>> {
        let mut again = *line;
        let mut steps = self.arc_line(line, is_arc)?;
        self.values = None;
        let ArcMove { seam, .. } = self.arc(&mut again, is_arc)?;
        let parts = self.list::<16>(self.resolve(&seam)?)?;
        let (crater_s, postflow_s) = (self.number(parts[10])?, self.number(parts[15])?);
        steps.push(RobotStep::ArcOff(ArcEnd { crater_s, postflow_s }));
        Ok(steps)
    }

    /// The end of a move, behind the through-point of an arc.
    fn targets(&self, line: &mut Scan<'a>, is_arc: bool) -> Read<TcpMove> {
        if !is_arc {
            return self.target(line);
        }
        let TcpMove { to: pose, externals, configuration, .. } = self.target(line)?;
        line.expect(",")?;
        let via = Some(ThroughPoint { pose, externals, configuration });
        Ok(TcpMove { via, ..self.target(line)? })
    }

    /// The pose of a robtarget, with its configuration and external axes.
    fn target(&self, line: &mut Scan<'a>) -> Read<TcpMove> {
        let given = value(line, 0)?;
        let [point, turn, configuration, externals] = self.list(self.resolve(&given)?)?;
        let configuration = self.numbers::<4>(configuration)?.map(|number| number as i32).to_vec();
        let to = self.pose(point, turn)?;
        let externals = self.externals(externals)?;
        Ok(TcpMove { via: None, to, externals, configuration, speed_mm_s: 0.0, zone_mm: 0.0 })
    }

    /// Values with commas before them.
    fn arguments(&self, line: &mut Scan<'a>, count: usize) -> Read<Vec<Value<'a>>> {
        (0..count)
            .map(|_| {
                line.expect(",")?;
                value(line, 0)
            })
            .collect()
    }

    fn pose(&self, point: &Value<'a>, turn: &Value<'a>) -> Read<RobotPose> {
        let point = DVec3::from_array(self.numbers(point)?);
        let [w, x, y, z] = self.numbers(turn)?;
        let given = DQuat::from_xyzw(x, y, z, w);
        if (given.length() - 1.0).abs() > NOT_UNIT {
            return Err(Fault::new(turn.span, "post-robot-quaternion"));
        }
        Ok(RobotPose { point, turn: given.normalize() })
    }

    /// Positions of the external axes that are there.
    fn externals(&self, value: &Value<'a>) -> Read<Vec<f64>> {
        let all = self.numbers::<6>(value)?;
        Ok(all.into_iter().filter(|position| position.abs() < NO_AXIS).collect())
    }

    /// Speed of the tool centre point of a speeddata or of one of the usual names.
    fn speed(&self, value: &Value<'a>) -> Read<f64> {
        let usual = match value.what {
            Literal::Name(name) if !self.data.contains_key(name) => Some(numbered(name, 'v', value.span)?),
            _ => None,
        };
        let speed = match usual {
            Some(speed) => speed,
            None => {
                let parts: [&Value; 4] = self.list(self.resolve(value)?)?;
                self.number(parts[0])?
            }
        };
        positive(speed, value.span)
    }

    /// Speed and values of weld data.
    fn weld(&self, value: &Value<'a>) -> Read<(f64, WeldValues)> {
        let [speed, _, main, _] = self.list(self.resolve(value)?)?;
        let [_, _, voltage_v, wire, _, current_a, ..] = self.numbers::<9>(main)?;
        let wire = (wire / MM_S_PER_M_MIN * 1e3).round() / 1e3;
        Ok((positive(self.number(speed)?, value.span)?, WeldValues { current_a, voltage_v, wire_feed_m_min: wire }))
    }

    /// The declared value of a name.
    fn resolve<'b>(&'b self, value: &'b Value<'a>) -> Read<&'b Value<'a>> {
        let Literal::Name(name) = value.what else { return Ok(value) };
        let unknown = || Fault::new(value.span, Message::new("post-robot-undeclared").text("name", name));
        self.data.get(name).ok_or_else(unknown)
    }

    fn list<'b, const N: usize>(&self, value: &'b Value<'a>) -> Read<[&'b Value<'a>; N]> {
        let wrong = || Fault::new(value.span, Message::new("post-robot-list").count("n", N));
        let Literal::List(parts) = &value.what else { return Err(wrong()) };
        let parts: Vec<&Value> = parts.iter().collect();
        parts.try_into().map_err(|_| wrong())
    }

    fn numbers<const N: usize>(&self, value: &Value<'a>) -> Read<[f64; N]> {
        let mut all = [0.0; N];
        for (number, part) in all.iter_mut().zip(self.list::<N>(value)?) {
            *number = self.number(part)?;
        }
        Ok(all)
    }

    fn number(&self, value: &Value<'a>) -> Read<f64> {
        match value.what {
            Literal::Number(number) => Ok(number),
            _ => Err(Fault::new(value.span, "post-number-missing")),
        }
    }

    fn finish(mut self, scan: &Scan<'a>) -> Read<RobotProgram> {
        if !self.ended {
            return Err(scan.missing("ENDMODULE"));
        }
        let mut steps = Vec::new();
        for (name, span) in std::mem::take(&mut self.calls) {
            let missing = || Fault::new(span, Message::new("post-robot-undeclared").text("name", name));
            steps.push(RobotStep::Pass(name.to_owned()));
            steps.extend(self.procedures.get(name).ok_or_else(missing)?.iter().cloned());
        }
        Ok(RobotProgram { title: String::new(), frames: Some(self.frames(scan)?), steps })
    }

    /// Frames of the tool and the work object that the moves name.
    fn frames(&self, scan: &Scan<'a>) -> Read<RobotFrames> {
        let of = |name: &str| self.data.get(name).ok_or_else(|| scan.missing(name));
        let [_, tool, _] = self.list(of("tTorch")?)?;
        let [_, _, _, user, object] = self.list(of("wWork")?)?;
        let frame = |value: &Value<'a>| {
            let [point, turn] = self.list(value)?;
            self.pose(point, turn)
        };
        let (user, object) = (frame(user)?, frame(object)?);
        let work = RobotPose { point: user.point + user.turn * object.point, turn: user.turn * object.turn };
        Ok(RobotFrames { tool: frame(tool)?, work })
    }
}

/// Arguments of an arc instruction.
struct ArcMove<'a> {
    to: TcpMove,
    speed: Value<'a>,
    seam: Value<'a>,
    weld: Value<'a>,
}

/// `,tool` and `\WObj:=work object`; every program has one of each.
fn tool(line: &mut Scan) -> Read {
    line.expect(",")?;
    line.expect("tTorch")?;
    if line.take("\\WObj:=") { line.expect("wWork") } else { Ok(()) }
}

fn zone_mm(value: &Value) -> Read<f64> {
    match value.what {
        Literal::Name(name) if name.eq_ignore_ascii_case("fine") => Ok(0.0),
        // z0 has 0.3 mm.
        Literal::Name(name) => numbered(name, 'z', value.span).map(|mm| mm.max(0.3)),
        _ => Err(Fault::new(value.span, "post-robot-zone")),
    }
}

/// The number in a usual name like v200 or z5.
fn numbered(name: &str, letter: char, span: Span) -> Read<f64> {
    let mut chars = name.chars();
    let is_letter = chars.next().is_some_and(|c| c.eq_ignore_ascii_case(&letter));
    let number = chars.as_str().parse::<u16>().ok().filter(|_| is_letter);
    let unknown = || Fault::new(span, Message::new("post-robot-undeclared").text("name", name));
    number.map(f64::from).ok_or_else(unknown)
}

/// A list, number, text, name, TRUE or FALSE.
fn value<'a>(line: &mut Scan<'a>, depth: usize) -> Read<Value<'a>> {
    line.blanks();
    let from = line.at;
    let what = if line.take("[") {
        if depth > DEEPEST {
            return Err(Fault::new(line.since(from), "post-nested-brackets"));
        }
        let mut parts = vec![value(line, depth + 1)?];
        while line.take(",") {
            parts.push(value(line, depth + 1)?);
        }
        line.expect("]")?;
        Literal::List(parts)
    } else if line.take("\"") {
        line.until('"')?;
        Literal::Text
    } else if line.rest().starts_with(|c: char| c.is_ascii_alphabetic()) {
        Literal::Name(line.word())
    } else {
        Literal::Number(line.number()?)
    };
    Ok(Value { span: line.since(from), what })
}
