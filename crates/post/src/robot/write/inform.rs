//! Yaskawa INFORM jobs (JBI) with arc instructions.
//!
//! Source: Yaskawa, INFORM Language manual for YRC1000 (RE-CKI-A467): job header, MOVJ, MOVL and MOVC with V and PL, SMOVL
//! and SMOVC with +MOVJ of a station, ARCON, ARCSET, ARCOF, TIMER. Yaskawa, DX100, data transmission (156191-1CD), job data
//! format: numbers of positions, base axis positions BC in rectangular form, RCONF, groups.

use super::RobotText;
use super::text::{head, joined, plain};
use crate::robot::angles::euler_zyx;
use crate::robot::language::RobotLanguage;
use crate::robot::pose::RobotPose;
use crate::robot::program::{RobotProgram, RobotStep, TcpMove};
use crate::robot::weld_values::WeldValues;
use crate::write::fixed;

/// A remark is cut off behind so many characters.
const LONGEST_REMARK: usize = 32;

pub(super) fn write(program: &RobotProgram, options: &RobotText) -> String {
    let (carriers, has_station) = (options.arm.carriers(), options.arm.has_positioner());
    let mut job = Job { carriers, has_station, ..Job::default() };
    for line in head(RobotLanguage::Inform, program, options) {
        job.remark(&line);
    }
    let frames = RobotLanguage::Inform.frames(options.arm);
    job.remark(&format!("UF#(1) {}", numbers(&frames.work)));
    job.remark(&format!("TOOL 1 {}", numbers(&frames.tool)));
    job.steps(&program.steps);
    let mut text = String::from("/JOB\n//NAME SEAMWRIGHT\n//POS\n");
    let [bases, stations] = [carriers > 0, has_station].map(|has| if has { job.points } else { 0 });
    text.push_str(&format!(
        "///NPOS {},{bases},{stations},0,0,0\n///USER 1\n///TOOL 1\n///POSTYPE USER\n///RECTAN\n",
        job.points
    ));
    text.push_str(&job.positions);
    if carriers > 0 {
        text.push_str(&format!("///POSTYPE BASE\n///RECTAN\n{}", job.bases));
    }
    if has_station {
        text.push_str(&format!("///POSTYPE ANGLE\n///ANGLE\n{}", job.stations));
    }
    let base = if carriers > 0 { ",BS1" } else { "" };
    let station = if has_station { "///GROUP2 ST1\n" } else { "" };
    text.push_str(&format!("//INST\n///ATTR SC,RW,RJ\n////FRAME USER 1\n///GROUP1 RB1{base}\n{station}NOP\n"));
    text.push_str(&job.program);
    text.push_str("END\n");
    text
}

#[derive(Default)]
struct Job {
    program: String,
    positions: String,
    /// Positions of the base axes.
    bases: String,
    /// Positions of the station.
    stations: String,
    /// Number of base axes: those that carry the arm.
    carriers: usize,
    has_station: bool,
    points: usize,
    configuration: Vec<i32>,
}

impl Job {
    fn line(&mut self, line: &str) {
        self.program.push_str(line);
        self.program.push('\n');
    }

    /// A remark, in as many lines as it needs.
    fn remark(&mut self, text: &str) {
        let chars: Vec<char> = text.chars().collect();
        for part in chars.chunks(LONGEST_REMARK) {
            self.line(&format!("'{}", part.iter().collect::<String>().trim()));
        }
    }

    fn steps(&mut self, steps: &[RobotStep]) {
        for (i, step) in steps.iter().enumerate() {
            match step {
                RobotStep::Pass(name) => {
                    let name: String = plain(name).chars().take(LONGEST_REMARK - 5).collect();
                    self.line(&format!("'PASS {name}"));
                }
                // Jobs have poses for these moves: see JointsTo.
                RobotStep::Joints(_) => {}
                RobotStep::JointsTo(line) => {
                    let point = self.position(&line.to, &line.configuration, &line.externals);
                    let base = self.base(&point);
                    let station = if self.has_station { format!(" E{point}") } else { String::new() };
                    self.line(&format!("MOVJ {point}{base}{station} VJ=20.00 PL=0"));
                }
                RobotStep::Move(line) => self.motion(line, leads_to_arc(&steps[i + 1..])),
                RobotStep::ArcOn(on) => {
                    self.line(&format!("ARCON {} T={}", values(&on.values), fixed(on.delay_s, 2)));
                }
                RobotStep::Values(now) => self.line(&format!("ARCSET {}", values(now))),
                RobotStep::ArcOff(off) => self.line(&format!("ARCOF T={}", fixed(off.crater_s, 2))),
                // Only URScript has set-points.
                RobotStep::SetPoints(_) => {}
                RobotStep::Wait(seconds) => self.line(&format!("TIMER T={seconds:.2}")),
            }
        }
    }

    /// An arc goes through three positions of MOVC: the line that leads to it has the first.
    fn motion(&mut self, line: &TcpMove, leads_to_arc: bool) {
        let (speed, level) = (line.speed_mm_s, u32::from(line.zone_mm > 0.0));
        if let Some(via) = &line.via {
            let point = self.position(&via.pose, &via.configuration, &via.externals);
            self.tcp_move("MOVC", &point, &format!("V={speed:.1}"));
        }
        let point = self.position(&line.to, &line.configuration, &line.externals);
        let word = if leads_to_arc || line.via.is_some() { "MOVC" } else { "MOVL" };
        self.tcp_move(word, &point, &format!("V={speed:.1} PL={level}"));
    }

    /// The position of the base axes at `point`, behind it.
    fn base(&self, point: &str) -> String {
        if self.carriers > 0 { format!(" B{point}") } else { String::new() }
    }

    /// With a station the move is coordinated: S, and the station's own move.
    fn tcp_move(&mut self, word: &str, point: &str, rest: &str) {
        let base = self.base(point);
        self.line(&match self.has_station {
            true => format!("S{word} {point}{base} {rest} +MOVJ E{point}"),
            false => format!("{word} {point}{base} {rest}"),
        });
    }

    /// Adds a position and gives its name. Configurations hold for the positions that follow.
    fn position(&mut self, to: &RobotPose, configuration: &[i32], externals: &[f64]) -> String {
        if self.configuration != configuration {
            self.configuration = configuration.to_vec();
            let data: Vec<String> = configuration.iter().map(i32::to_string).collect();
            self.positions.push_str(&format!("///RCONF {}\n", data.join(",")));
        }
        let name = format!("C{:05}", self.points);
        self.points += 1;
        let (base, station) = externals.split_at(self.carriers.min(externals.len()));
        if self.carriers > 0 {
            self.bases.push_str(&format!("B{name}={}\n", joined(base.iter().copied(), 3, ",")));
        }
        if self.has_station {
            self.stations.push_str(&format!("E{name}={}\n", joined(station.iter().copied(), 4, ",")));
        }
        self.positions.push_str(&format!("{name}={}\n", numbers(to)));
        name
    }
}

/// Whether the next move is an arc.
fn leads_to_arc(steps: &[RobotStep]) -> bool {
    let next = steps.iter().find(|step| !matches!(step, RobotStep::Values(_)));
    matches!(next, Some(RobotStep::Move(TcpMove { via: Some(_), .. })))
}

/// X, Y, Z in mm, and Rx, Ry, Rz about the fixed x, y and z in degrees.
fn numbers(pose: &RobotPose) -> String {
    let [rz, ry, rx] = euler_zyx(pose.turn).map(f64::to_degrees);
    format!("{},{}", joined(pose.point.to_array(), 3, ","), joined([rx, ry, rz], 4, ","))
}

fn values(values: &WeldValues) -> String {
    format!("AC={} AV={}", fixed(values.current_a, 0), fixed(values.voltage_v, 1))
}
