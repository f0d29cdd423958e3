//! Examples on robots, in every language that fits: written, read back and verified.

use crate::common::Planned;
use seamwright_machine::shipped;
use seamwright_post::robot::{
    PlannedRobot, RobotArm, RobotLanguage, RobotOptions, RobotProgram, RobotText, read_robot, robot_program,
    verify_robot, write_robot,
};
use seamwright_post::{Error, Verification};
use seamwright_program::TorchPath;

const OPTIONS: RobotOptions = RobotOptions { tolerance_mm: 0.05, speed_percent: 2.0 };
/// A nozzle on a shell, near enough for all arms.
const NOZZLE: &str = r#"
schema = 1
title = "nozzle 120 on shell 300"
machine = "MACHINE"
[placement]
move_mm = [0, 0, 160]
[seam.nozzle]
radius_mm = 60
wall_mm = 6
[seam.nozzle.body.cylinder]
radius_mm = 150
axis = [1, 0, 0]
[part]
body_length_mm = 300
nozzle_length_mm = 80
[start]
phi_deg = 0
overlap_mm = 10
[weld]
speed_mm_s = 6
[weld.process]
current_a = 220
voltage_v = 25
wire_feed_m_min = 7
"#;

fn on(machine: &str) -> Planned {
    Planned::job(&NOZZLE.replace("MACHINE", machine))
}

fn program(planned: &Planned, language: RobotLanguage) -> Result<RobotProgram, Error> {
    let count = planned.welding.program.value.passes.len();
    let paths: Vec<_> = (0..count).map(|i| planned.welding.path(i)).collect();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    robot_program(&planned.machine, language, &planned.welding.program.value, &paths, &planned.motion, &OPTIONS)
}

fn text(planned: &Planned, language: RobotLanguage, program: &RobotProgram) -> String {
    let arm = RobotArm::new(&planned.machine, language).unwrap();
    write_robot(language, program, &RobotText { machine: &planned.machine, arm: &arm, remarks: &[] })
}

fn plan(planned: &Planned, language: RobotLanguage) -> PlannedRobot<'_> {
    PlannedRobot {
        machine: &planned.machine,
        language,
        program: &planned.welding.program.value,
        motion: &planned.motion,
        tolerance_mm: OPTIONS.tolerance_mm,
        speed_percent: OPTIONS.speed_percent,
    }
}

/// Writes, reads back, verifies and prints.
fn proven(planned: &Planned, language: RobotLanguage) -> Verification {
    let asked = program(planned, language).unwrap_or_else(|e| panic!("{e}"));
    let written = text(planned, language, &asked);
    let told = read_robot(language, "p", &written).unwrap_or_else(|e| panic!("{e}"));
    let proof = verify_robot(&asked, &told, plan(planned, language));
    let proof = proof.unwrap_or_else(|wrong| panic!("{:?}", wrong.iter().map(ToString::to_string).collect::<Vec<_>>()));
    println!("{} {}: {:?}", planned.machine.name, language.name(), proof.lines());
    proof
}

#[test]
fn rapid_is_the_plan() {
    let proof = proven(&on("irb-2600"), RobotLanguage::Rapid);
    assert!(proof.moves < 200, "{}", proof.moves);
}

#[test]
fn urscript_is_the_plan() {
    proven(&on("ur10e"), RobotLanguage::Urscript);
}

/// A text that is cut anywhere, or has other bytes, is refused or differs; nothing panics.
fn damaged(planned: &Planned, language: RobotLanguage) {
    let asked = program(planned, language).unwrap();
    let written = text(planned, language, &asked);
    let mut random = seamwright_testkit::Random::new(41);
    let chars = b"0123456789.-+[]{}(),;:=!#'\"eE pxyz\n";
    for case in 0..seamwright_testkit::cases(60u32) {
        let at = random.within(0.0, written.len() as f64 - 1.0) as usize;
        let mut bytes = written.clone().into_bytes();
        if case % 2 == 0 {
            bytes.truncate(at);
        } else {
            bytes[at] = chars[random.within(0.0, chars.len() as f64 - 0.01) as usize];
        }
        let Ok(changed) = String::from_utf8(bytes) else { continue };
        let told = read_robot(language, "p", &changed);
        if case % 2 == 0 {
            assert!(told.is_err() || changed.trim_end() == written.trim_end(), "cut at {at} of {}", written.len());
        }
    }
    for text in ["", "\n", "MODULE a", "def f():", "\u{0}\u{ff}", "[[[[[[[[[[[[[[[[["] {
        assert!(read_robot(language, "p", text).is_err(), "{text}");
    }
}

#[test]
fn damaged_programs_are_refused() {
    damaged(&on("irb-2600"), RobotLanguage::Rapid);
    damaged(&on("ur10e"), RobotLanguage::Urscript);
}

/// Changes beyond the digits are found: a point, a speed, the zone, the configuration, the frames, a missing line.
#[test]
fn a_wrong_program_is_no_proof() {
    let planned = on("irb-2600");
    let language = RobotLanguage::Rapid;
    let asked = program(&planned, language).unwrap();
    let written = text(&planned, language, &asked);
    let judged = |text: &str| {
        let told = read_robot(language, "p", text).unwrap_or_else(|e| panic!("{e}"));
        verify_robot(&asked, &told, plan(&planned, language)).is_ok()
    };
    assert!(judged(&written));
    let lines: Vec<&str> = written.lines().collect();
    let at = lines.iter().position(|line| line.contains("ArcL [")).unwrap() + 10;
    let with = |line: &str| {
        let mut lines = lines.clone();
        lines[at] = line;
        lines.join("\n")
    };
    assert!(judged(&with(lines[at])));
    assert!(!judged(&with("")));
    let (head, rest) = lines[at].split_once(',').unwrap();
    let (_, x) = head.split_once("[[[").map_or_else(|| head.rsplit_once('[').unwrap(), |(_, x)| ("", x));
    let moved = format!("{}{},{rest}", &head[..head.len() - x.len()], x.parse::<f64>().unwrap() + 0.5);
    assert!(!judged(&with(&moved)), "{moved}");
    assert!(!judged(&written.replace("welddata wd2:=[", "welddata wd2:=[1")) || !written.contains("wd2"));
    assert!(!judged(&written.replace("tTorch:=[TRUE,[[90", "tTorch:=[TRUE,[[91")));
    assert!(!judged(&with(&lines[at].replacen(",z", ",z5", 1))));
}

#[test]
fn machines_that_do_not_fit_are_refused() {
    let of = |name: &str| seamwright_machine::Machine::read(name, shipped(name).unwrap().text).unwrap();
    for (machine, language, code) in [
        ("saddle-4axis", RobotLanguage::Rapid, "post-robot-no-arm"),
        ("ur10e", RobotLanguage::Rapid, "post-robot-not-spherical"),
        ("irb-2600", RobotLanguage::Urscript, "post-robot-not-parallel"),
        ("ur10e-positioner", RobotLanguage::Urscript, "post-robot-external-axes"),
    ] {
        let error = RobotArm::new(&of(machine), language).unwrap_err();
        assert!(error.message().as_data().contains(code), "{error:?}");
    }
}
