//! FANUC teach pendant programs as text (LS) with the instructions of ArcTool.
//!
//! Source: FANUC, R-30iB Operator's Manual (Basic Operation) and ArcTool Operator's Manual: position data, motion
//! instructions L and C with CNT and COORD, groups, `Weld Start` and `Weld End`.

use super::RobotText;
use super::text::{head, plain};
use crate::robot::angles::euler_zyx;
use crate::robot::language::{CNT_S, RobotLanguage};
use crate::robot::pose::RobotPose;
use crate::robot::program::{JointTarget, RobotProgram, RobotStep, TcpMove};
use crate::robot::weld_values::WeldValues;
use crate::write::fixed;

/// Position registers from which user frame and tool are set.
const REGISTERS: [u32; 2] = [90, 91];
/// A remark is cut off behind so many characters.
const LONGEST_REMARK: usize = 32;

pub(super) fn write(program: &RobotProgram, options: &RobotText) -> String {
    let mut ls = Ls { carriers: options.arm.carriers(), is_coordinated: options.arm.has_positioner(), ..Ls::default() };
    for line in head(RobotLanguage::FanucLs, program, options) {
        ls.remark(&line);
    }
    let frames = RobotLanguage::FanucLs.frames(options.arm);
    ls.frame(REGISTERS[0], &frames.work, "UFRAME[1]");
    ls.frame(REGISTERS[1], &frames.tool, "UTOOL[1]");
    ls.line("  UFRAME_NUM=1 ;");
    ls.line("  UTOOL_NUM=1 ;");
    ls.steps(&program.steps);
    let title: String = plain(&program.title).chars().take(16).collect();
    let mut text =
        format!("/PROG  SEAMWRIGHT\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"{}\";\n", title.replace('"', "'"));
    let second = if ls.is_coordinated { '1' } else { '*' };
    text.push_str(&format!("LINE_COUNT\t= {};\nDEFAULT_GROUP\t= 1,{second},*,*,*;\n", ls.lines));
    text.push_str(&format!("/MN\n{}/POS\n{}/END\n", ls.program, ls.positions));
    text
}

#[derive(Default)]
struct Ls {
    program: String,
    positions: String,
    lines: usize,
    points: usize,
    values: WeldValues,
    /// Number of external axes that carry the arm: those of group 1.
    carriers: usize,
    /// Whether a positioner is group 2.
    is_coordinated: bool,
}

impl Ls {
    fn line(&mut self, line: &str) {
        self.lines += 1;
        self.program.push_str(&format!("{:4}:{line}\n", self.lines));
    }

    /// A remark, in as many lines as it needs.
    fn remark(&mut self, text: &str) {
        let chars: Vec<char> = text.chars().filter(|c| *c != ';').collect();
        for part in chars.chunks(LONGEST_REMARK - 1) {
            self.line(&format!("  !{} ;", part.iter().collect::<String>().trim()));
        }
    }

    /// Sets a frame by way of a position register.
    fn frame(&mut self, register: u32, pose: &RobotPose, frame: &str) {
        self.line(&format!("  PR[{register}]=LPOS ;"));
        for (value, k) in numbers(pose).into_iter().zip(1..) {
            self.line(&format!("  PR[{register},{k}]={value} ;"));
        }
        self.line(&format!("  {frame}=PR[{register}] ;"));
    }

    fn steps(&mut self, steps: &[RobotStep]) {
        for step in steps {
            match step {
                RobotStep::Pass(name) => self.line(&format!("  !PASS {} ;", plain(name).replace(';', ","))),
                RobotStep::Joints(target) => self.joints(target),
                RobotStep::Move(line) | RobotStep::JointsTo(line) => self.motion(line),
                RobotStep::ArcOn(on) => {
                    self.values = on.values;
                    self.line(&format!("  Weld Start[1,{}] ;", values(&on.values)));
                    if on.delay_s > 0.0 {
                        self.line(&format!("  WAIT {}(sec) ;", fixed(on.delay_s, 2)));
                    }
                }
                RobotStep::Values(now) => {
                    self.values = *now;
                    self.line(&format!("  Weld Start[1,{}] ;", values(now)));
                }
                RobotStep::ArcOff(off) => {
                    let values = values(&self.values);
                    self.line(&format!("  Weld End[1,{values},{}s] ;", fixed(off.crater_s, 2)));
                }
                // Only URScript has set-points.
                RobotStep::SetPoints(_) => {}
                RobotStep::Wait(seconds) => self.line(&format!("  WAIT {}(sec) ;", fixed(*seconds, 2))),
            }
        }
    }

    fn joints(&mut self, target: &JointTarget) {
        self.points += 1;
        self.line(&format!("J P[{}] 20% FINE ;", self.points));
        // The pendant counts J3 from the horizontal.
        let mut arm = target.arm;
        arm[2] -= arm[1];
        let angles: Vec<String> = arm.iter().zip(1..).map(|(deg, n)| format!("J{n}= {} deg", fixed(*deg, 4))).collect();
        let body = format!("UF : 1, UT : 1,\n\t{}", angles.join(",\t"));
        self.position(&body, &target.externals);
    }

    fn motion(&mut self, line: &TcpMove) {
        let via = line.via.as_ref().map(|via| self.pose(&via.pose, &via.configuration, &via.externals));
        let to = self.pose(&line.to, &line.configuration, &line.externals);
        let speed = fixed(line.speed_mm_s, 1);
        let end = match line.zone_mm > 0.0 {
            true => format!("CNT{}", (100.0 * line.zone_mm / (CNT_S * line.speed_mm_s)).round()),
            false => "FINE".to_owned(),
        };
        let end = if self.is_coordinated { format!("{end} COORD") } else { end };
        match via {
            // An arc has a line for each of its points.
            Some(via) => {
                self.line(&format!("C P[{via}]"));
                self.program.push_str(&format!("    :  P[{to}] {speed}mm/sec {end} ;\n"));
            }
            None => self.line(&format!("L P[{to}] {speed}mm/sec {end} ;")),
        }
    }

    /// Adds a pose and gives its number.
    fn pose(&mut self, to: &RobotPose, data: &[i32], external: &[f64]) -> usize {
        self.points += 1;
        let [x, y, z, w, p, r] = numbers(to);
        let body = format!(
            "UF : 1, UT : 1,\tCONFIG : '{}',\n\tX = {x} mm,\tY = {y} mm,\tZ = {z} mm,\n\tW = {w} deg,\tP = {p} deg,\tR = {r} deg",
            configuration(data)
        );
        self.position(&body, external);
        self.points
    }

    /// Group 1 is the arm with its extended axes, group 2 the positioner.
    fn position(&mut self, body: &str, external: &[f64]) {
        let (carriers, positioner) = external.split_at(self.carriers.min(external.len()));
        let extended = externals(carriers);
        self.positions.push_str(&format!("P[{}]{{\n   GP1:\n\t{body}{extended}\n", self.points));
        if !positioner.is_empty() {
            let of = |(value, n): (&f64, usize)| format!("J{n}= {} deg", fixed(*value, 4));
            let joints: Vec<String> = positioner.iter().zip(1..).map(of).collect();
            self.positions.push_str(&format!("   GP2:\n\tUF : 1, UT : 1,\n\t{}\n", joints.join(",\t")));
        }
        self.positions.push_str("};\n");
    }
}

/// X, Y, Z in mm; W, P, R about the fixed x, y and z, in degrees.
fn numbers(pose: &RobotPose) -> [String; 6] {
    let [x, y, z] = pose.point.to_array().map(|v| fixed(v, 3));
    let [r, p, w] = euler_zyx(pose.turn).map(|v| fixed(v.to_degrees(), 4));
    [x, y, z, w, p, r]
}

fn externals(values: &[f64]) -> String {
    let of = |(value, n): (&f64, usize)| format!(",\n\tE{n}= {} mm", fixed(*value, 3));
    values.iter().zip(1..).map(of).collect()
}

fn configuration(data: &[i32]) -> String {
    let [flip, up, front, j1, j4, j6] = *data else { return String::new() };
    let letter = |set: i32, letters: [&'static str; 2]| letters[usize::from(set != 0)];
    let letters = [letter(flip, ["N", "F"]), letter(up, ["D", "U"]), letter(front, ["B", "T"])];
    format!("{}, {j1}, {j4}, {j6}", letters.join(" "))
}

fn values(values: &WeldValues) -> String {
    format!("{}Volts,{}Amps", fixed(values.voltage_v, 1), fixed(values.current_a, 1))
}
