//! Yaskawa INFORM jobs (JBI) with arc instructions.
//!
//! Source: Yaskawa, INFORM Language manual for YRC1000 (RE-CKI-A467): job header, MOVJ, MOVL with V and PL, ARCON, ARCSET,
//! ARCOF, TIMER.

use super::RobotText;
use super::text::{head, joined, plain};
use crate::robot::angles::euler_zyx;
use crate::robot::language::RobotLanguage;
use crate::robot::pose::RobotPose;
use crate::robot::program::{LineMove, RobotProgram, RobotStep};
use crate::robot::weld_values::WeldValues;
use crate::write::fixed;

/// A remark is cut off behind so many characters.
const LONGEST_REMARK: usize = 32;

pub(super) fn write(program: &RobotProgram, options: &RobotText) -> String {
    let mut job = Job::default();
    for line in head(RobotLanguage::Inform, program, options) {
        job.remark(&line);
    }
    let frames = RobotLanguage::Inform.frames(options.arm);
    job.remark(&format!("UF#(1) {}", numbers(&frames.work)));
    job.remark(&format!("TOOL 1 {}", numbers(&frames.tool)));
    job.steps(&program.steps);
    let mut text = String::from("/JOB\n//NAME SEAMWRIGHT\n//POS\n");
    text.push_str(&format!("///NPOS {},0,0,0,0,0\n///USER 1\n///TOOL 1\n///POSTYPE USER\n///RECTAN\n", job.points));
    text.push_str(&job.positions);
    text.push_str("//INST\n///ATTR SC,RW,RJ\n////FRAME USER 1\n///GROUP1 RB1\nNOP\n");
    text.push_str(&job.program);
    text.push_str("END\n");
    text
}

#[derive(Default)]
struct Job {
    program: String,
    positions: String,
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
        for step in steps {
            match step {
                RobotStep::Pass(name) => {
                    let name: String = plain(name).chars().take(LONGEST_REMARK - 5).collect();
                    self.line(&format!("'PASS {name}"));
                }
                // Jobs have poses for these moves: see JointsTo.
                RobotStep::Joints(_) => {}
                RobotStep::JointsTo(line) => {
                    let point = self.position(line);
                    self.line(&format!("MOVJ {point} VJ=20.00 PL=0"));
                }
                RobotStep::Line(line) => {
                    let (point, speed) = (self.position(line), line.speed_mm_s);
                    let level = u32::from(line.zone_mm > 0.0);
                    self.line(&format!("MOVL {point} V={speed:.1} PL={level}"));
                }
                RobotStep::ArcOn(on) => {
                    self.line(&format!("ARCON {} T={}", values(&on.values), fixed(on.delay_s, 2)));
                }
                RobotStep::Values(now) => self.line(&format!("ARCSET {}", values(now))),
                RobotStep::ArcOff(off) => self.line(&format!("ARCOF T={}", fixed(off.crater_s, 2))),
                RobotStep::Wait(seconds) => self.line(&format!("TIMER T={seconds:.2}")),
            }
        }
    }

    /// Adds a position and gives its name. Configurations hold for the positions that follow.
    fn position(&mut self, line: &LineMove) -> String {
        if self.configuration != line.configuration {
            self.configuration.clone_from(&line.configuration);
            let data: Vec<String> = line.configuration.iter().map(i32::to_string).collect();
            self.positions.push_str(&format!("///RCONF {}\n", data.join(",")));
        }
        let name = format!("C{:05}", self.points);
        self.points += 1;
        self.positions.push_str(&format!("{name}={}\n", numbers(&line.to)));
        name
    }
}

/// X, Y, Z in mm, and Rx, Ry, Rz about the fixed x, y and z in degrees.
fn numbers(pose: &RobotPose) -> String {
    let [rz, ry, rx] = euler_zyx(pose.turn).map(f64::to_degrees);
    format!("{},{}", joined(pose.point.to_array(), 3, ","), joined([rx, ry, rz], 4, ","))
}

fn values(values: &WeldValues) -> String {
    format!("AC={} AV={}", fixed(values.current_a, 0), fixed(values.voltage_v, 1))
}
