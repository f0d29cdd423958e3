//! KUKA KRL with arc instructions.
//!
//! Source: KUKA, KSS 8.x Operating and Programming Instructions for System Integrators (LIN, CIRC, C_DIS, $APO, $ORI_TYPE, $CIRC_TYPE,
//! E6POS with S and T, EK for a coupled positioner).

use super::RobotText;
use super::text::{head, joined, plain};
use crate::robot::angles::euler_zyx;
use crate::robot::language::RobotLanguage;
use crate::robot::pose::RobotPose;
use crate::robot::program::{JointTarget, RobotProgram, RobotStep, TcpMove};
use crate::robot::weld_values::WeldValues;
use crate::write::fixed;

const M_PER_MM: f64 = 1e-3;

pub(super) fn write(program: &RobotProgram, options: &RobotText) -> String {
    let mut krl = Krl { text: String::from("&ACCESS RVP\n&REL 1\nDEF SEAMWRIGHT_WELD()\n"), speed: 0.0, zone: 0.0 };
    for line in head(RobotLanguage::Krl, program, options) {
        krl.line(&format!("; {line}"));
    }
    krl.line("BAS(#INITMOV,0)");
    krl.line("$ADVANCE=3");
    krl.line("$ORI_TYPE=#VAR");
    krl.line("$CIRC_TYPE=#PATH");
    krl.line(&format!("$TOOL={{{}}}", frame(&options.arm.tool)));
    let work = frame(&options.arm.work);
    krl.line(&match options.arm.has_positioner() {
        true => format!("$BASE=EK(MACHINE_DEF[2].ROOT,MACHINE_DEF[2].MECH_TYPE,{{{work}}})"),
        false => format!("$BASE={{{work}}}"),
    });
    krl.steps(&program.steps);
    krl.text.push_str("END\n");
    krl.text.push_str(STUBS);
    krl.text
}

/// Bodies for the power source; replace them by those of the cell's arc package.
const STUBS: &str = "DEF ARC_ON(PREFLOW_S:IN,DELAY_S:IN,CURRENT_A:IN,VOLTAGE_V:IN,WIRE_M_MIN:IN)
REAL PREFLOW_S,DELAY_S,CURRENT_A,VOLTAGE_V,WIRE_M_MIN
; gas on, wait PREFLOW_S, arc on, wait DELAY_S
END
DEF ARC_SWI(CURRENT_A:IN,VOLTAGE_V:IN,WIRE_M_MIN:IN)
REAL CURRENT_A,VOLTAGE_V,WIRE_M_MIN
; new values of the arc
END
DEF ARC_OFF(CRATER_S:IN,POSTFLOW_S:IN)
REAL CRATER_S,POSTFLOW_S
; wait CRATER_S, arc off, wait POSTFLOW_S, gas off
END
";

struct Krl {
    text: String,
    /// $VEL.CP and $APO.CDIS as last written.
    speed: f64,
    zone: f64,
}

impl Krl {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn steps(&mut self, steps: &[RobotStep]) {
        for step in steps {
            match step {
                RobotStep::Pass(name) => self.line(&format!(";PASS {}", plain(name))),
                RobotStep::Joints(target) => self.line(&joints(target)),
                RobotStep::Move(line) | RobotStep::JointsTo(line) => self.motion(line),
                RobotStep::ArcOn(on) => {
                    let times = joined([on.preflow_s, on.delay_s], 3, ",");
                    self.line(&format!("ARC_ON({times},{})", values(&on.values)));
                }
                RobotStep::Values(now) => {
                    // A trigger does not stop the advance run.
                    self.line(&format!("TRIGGER WHEN DISTANCE=0 DELAY=0 DO ARC_SWI({}) PRIO=-1", values(now)));
                }
                RobotStep::ArcOff(off) => {
                    self.line(&format!("ARC_OFF({})", joined([off.crater_s, off.postflow_s], 3, ",")));
                }
                // Only URScript has set-points.
                RobotStep::SetPoints(_) => {}
                RobotStep::Wait(seconds) => self.line(&format!("WAIT SEC {}", fixed(*seconds, 3))),
            }
        }
    }

    fn motion(&mut self, line: &TcpMove) {
        if self.speed.to_bits() != line.speed_mm_s.to_bits() {
            self.speed = line.speed_mm_s;
            self.line(&format!("$VEL.CP={}", fixed(line.speed_mm_s * M_PER_MM, 8)));
        }
        if line.zone_mm > 0.0 && self.zone.to_bits() != line.zone_mm.to_bits() {
            self.zone = line.zone_mm;
            self.line(&format!("$APO.CDIS={}", fixed(line.zone_mm, 4)));
        }
        let data = match line.configuration[..] {
            [status, turn] => format!(",S {status},T {turn}"),
            _ => String::new(),
        };
        let zone = if line.zone_mm > 0.0 { " C_DIS" } else { "" };
        let word = match &line.via {
            Some(via) => {
                let [x, y, z] = via.pose.point.to_array().map(|v| fixed(v, 4));
                format!("CIRC {{X {x},Y {y},Z {z}}},")
            }
            None => "LIN ".to_owned(),
        };
        self.line(&format!("{word}{{{}{data}{}}}{zone}", frame(&line.to), externals(&line.externals)));
    }
}

/// A: about z, B: about the new y, C: about the new x.
fn frame(pose: &RobotPose) -> String {
    let [x, y, z] = pose.point.to_array().map(|v| fixed(v, 4));
    let [a, b, c] = euler_zyx(pose.turn).map(|v| fixed(v.to_degrees(), 6));
    format!("X {x},Y {y},Z {z},A {a},B {b},C {c}")
}

fn externals(values: &[f64]) -> String {
    values.iter().zip(1..).map(|(value, n)| format!(",E{n} {}", fixed(*value, 4))).collect()
}

fn joints(target: &JointTarget) -> String {
    let arm: Vec<String> = target.arm.iter().zip(1..).map(|(deg, n)| format!("A{n} {}", fixed(*deg, 5))).collect();
    format!("PTP {{{}{}}}", arm.join(","), externals(&target.externals))
}

fn values(values: &WeldValues) -> String {
    joined(values.all(), 3, ",")
}
