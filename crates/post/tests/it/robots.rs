//! Examples on robots, in every language that fits: written, read back and verified.

use crate::common::Planned;
use glam::{DQuat, DVec3};
use seamwright_document::Positive;
use seamwright_geometry::Pose;
use seamwright_machine::{Machine, shipped};
use seamwright_post::robot::{
    ArcEnd, ArcStart, JointTarget, PlannedRobot, RobotArm, RobotImport, RobotLanguage, RobotOptions, RobotPose,
    RobotProgram, RobotStep, RobotText, TcpMove, ThroughPoint, WeldValues, read_robot, robot_program, robot_to_program,
    verify_robot, write_robot,
};
use seamwright_post::{Error, Verification};
use seamwright_program::{Program, TorchPath};
use seamwright_testkit::{Random, cases};
use std::f64::consts::PI;

pub(crate) const OPTIONS: RobotOptions =
    RobotOptions { tolerance_mm: 0.05, speed_percent: 2.0, arcs: true, stream: None };
/// A nozzle on a shell, near enough for all arms.
const NOZZLE: &str = include_str!("../../../../tests/data/nozzle-on-arm.toml");

pub(crate) fn on(machine: &str) -> Planned {
    Planned::job(&NOZZLE.replace("MACHINE", machine))
}

fn program(planned: &Planned, language: RobotLanguage) -> Result<RobotProgram, Error> {
    program_with(planned, language, &OPTIONS)
}

pub(crate) fn program_with(
    planned: &Planned,
    language: RobotLanguage,
    options: &RobotOptions,
) -> Result<RobotProgram, Error> {
    let count = planned.welding.program.value.passes.len();
    let paths: Vec<_> = (0..count).map(|i| planned.welding.path(i)).collect();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    robot_program(&planned.machine, language, &planned.welding.program.value, &paths, &planned.motion, options)
}

pub(crate) fn text(planned: &Planned, language: RobotLanguage, program: &RobotProgram) -> String {
    let arm = RobotArm::new(&planned.machine, language).unwrap();
    write_robot(language, program, &RobotText { machine: &planned.machine, arm: &arm, remarks: &[] })
}

pub(crate) fn plan(planned: &Planned, language: RobotLanguage) -> PlannedRobot<'_> {
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

/// Moves of the weld, and the poses of their text: an arc has two.
fn moves_and_poses(program: &RobotProgram) -> [usize; 2] {
    let moves =
        program.steps.iter().filter_map(|step| if let RobotStep::Move(step) = step { Some(step) } else { None });
    moves.fold([0, 0], |[moves, poses], step| [moves + 1, poses + 1 + usize::from(step.via.is_some())])
}

/// The plan is proven, with at most `max_part` of the moves that lines alone need.
fn proven_with_arcs(machine: &str, language: RobotLanguage, max_part: f64) {
    let planned = on(machine);
    proven(&planned, language);
    let with_arcs = program(&planned, language).unwrap();
    assert_eq!(stops_beside_arcs(&with_arcs), 0);
    let with = moves_and_poses(&with_arcs);
    let lines = program_with(&planned, language, &RobotOptions { arcs: false, ..OPTIONS }).unwrap();
    let without = moves_and_poses(&lines);
    println!("{} moves and poses: {with:?} with arcs, {without:?} with lines", language.name());
    assert!(with[0] as f64 <= max_part * without[0] as f64, "{with:?} {without:?}");
}

/// Corners between an arc and another move of a weld at which the control would stop.
fn stops_beside_arcs(program: &RobotProgram) -> usize {
    let pairs = program.steps.windows(2).filter_map(|pair| match pair {
        [RobotStep::Move(a), RobotStep::Move(b)] => Some((a, b)),
        _ => None,
    });
    pairs.filter(|(a, b)| a.zone_mm <= 0.0 && (a.via.is_some() || b.via.is_some())).count()
}

#[test]
fn rapid_is_the_plan() {
    proven_with_arcs("irb-2600", RobotLanguage::Rapid, 0.5);
}

#[test]
fn urscript_is_the_plan() {
    proven_with_arcs("ur10e", RobotLanguage::Urscript, 0.8);
}

#[test]
fn krl_is_the_plan() {
    proven_with_arcs("kr-16", RobotLanguage::Krl, 0.5);
}

#[test]
fn fanuc_ls_is_the_plan() {
    proven_with_arcs("arc-mate-120id", RobotLanguage::FanucLs, 0.5);
}

#[test]
fn inform_is_the_plan() {
    proven_with_arcs("ar1440", RobotLanguage::Inform, 0.9);
}

/// A text that is read as a weld program has its torch, speeds and values, and plans to the same weld.
#[test]
fn programs_come_back_as_welds() {
    comes_back("irb-2600", RobotLanguage::Rapid, Some(["tTorch:=[TRUE,[[90", "tTorch:=[TRUE,[[95"]));
    comes_back("kr-16", RobotLanguage::Krl, Some(["$TOOL={X 90", "$TOOL={X 95"]));
    comes_back("arc-mate-120id", RobotLanguage::FanucLs, Some(["PR[91,1]=-90", "PR[91,1]=-95"]));
    comes_back("ur10e", RobotLanguage::Urscript, Some(["set_tcp(p[0.09,", "set_tcp(p[0.095,"]));
    comes_back("ar1440", RobotLanguage::Inform, None);
}

/// On FANUC and Yaskawa poses stand still in space: the reader takes them back to the work on the positioner.
#[test]
fn programs_with_a_positioner_come_back_as_welds() {
    comes_back("arc-mate-120id-positioner", RobotLanguage::FanucLs, None);
    comes_back("ar1440-positioner", RobotLanguage::Inform, None);
}

/// The weld program made of the written text has the torch, speed and values of the plan. With the text `other_tool[0]`
/// replaced by `other_tool[1]` the tool is another one, which is refused.
fn comes_back(machine: &str, language: RobotLanguage, other_tool: Option<[&str; 2]>) {
    let planned = on(machine);
    let written = text(&planned, language, &program(&planned, language).unwrap());
    let read = read_robot(language, "p", &written).unwrap();
    let blend_mm = Positive::new(0.1).unwrap();
    let import = RobotImport { machine: &planned.machine, machine_name: machine, language, blend_mm };
    let imported = robot_to_program(&read, &import).unwrap();
    let again = Program::read("p.toml", &imported.program.to_toml().unwrap()).unwrap().value;
    let [pass] = &again.passes[..] else { panic!("{}", again.passes.len()) };
    let (points, first) = (pass.points.as_ref().unwrap(), &planned.motion.passes[0]);
    assert!((imported.seconds / first.profile.duration() - 1.0).abs() < 1e-3, "{}", imported.seconds);
    assert_eq!(points.count(), imported.moves);
    let rows: Vec<Vec<f64>> = points.rows().map(|row| row.iter().map(|v| v.get()).collect()).collect();
    let samples = tip_samples(&planned, 0.05);
    for row in &rows {
        let (point, direction) = (DVec3::from_slice(&row[..3]), DVec3::from_slice(&row[3..6]));
        let near = nearest(&samples, point);
        // Points have the decimals of the text: 0.001 mm, and 0.0001 degrees of the positioner at 400 mm.
        assert!(near.point.distance(point) < 4e-3, "{row:?} {near:?}");
        assert!(near.direction.distance(direction) < 1e-4, "{row:?} {near:?}");
    }
    let (process, values): (&[&str], &[f64]) = match language {
        // The wire is set at the power source.
        RobotLanguage::FanucLs | RobotLanguage::Inform => (&["current_a", "voltage_v"], &[220.0, 25.0]),
        _ => (&["current_a", "voltage_v", "wire_feed_m_min"], &[220.0, 25.0, 7.0]),
    };
    let speed_at = 6 + process.len();
    assert_eq!(points.columns[6..], [process, &["speed_mm_s"]].concat());
    for row in &rows[1..] {
        assert_eq!(&row[6..speed_at], values);
    }
    let middle = rows[rows.len() / 2][speed_at];
    assert!((middle / 6.0 - 1.0).abs() < 0.02, "{middle}");
    if let Some([own, other]) = other_tool {
        assert!(written.contains(own), "{own}");
        let refused = robot_to_program(&read_robot(language, "p", &written.replace(own, other)).unwrap(), &import);
        assert!(matches!(refused, Err(Error::OtherFrames { frame: "tool", .. })), "{refused:?}");
    }
}

/// Poses of the planned tip every `step_mm` along the first pass.
fn tip_samples(planned: &Planned, step_mm: f64) -> Vec<Pose> {
    let path = &planned.motion.passes[0].path;
    let count = (path.length() / step_mm).ceil() as usize;
    (0..=count).map(|k| planned.machine.forward(&path.at(path.length() * k as f64 / count as f64))).collect()
}

/// The pose nearest to `point` on the chords between `samples`.
fn nearest(samples: &[Pose], point: DVec3) -> Pose {
    let on_chord = |pair: &[Pose]| {
        let chord = pair[1].point - pair[0].point;
        let part = ((point - pair[0].point).dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
        Pose { point: pair[0].point + part * chord, direction: pair[0].direction.lerp(pair[1].direction, part) }
    };
    let poses = samples.windows(2).map(on_chord);
    poses.min_by(|a, b| a.point.distance(point).total_cmp(&b.point.distance(point))).unwrap()
}

/// The rail is an external axis.
#[test]
fn a_rail_goes_with_the_arm() {
    let planned = on("irb-2600-rail");
    for language in [RobotLanguage::Rapid, RobotLanguage::Krl, RobotLanguage::FanucLs, RobotLanguage::Inform] {
        proven(&planned, language);
    }
    let job = text(&planned, RobotLanguage::Inform, &program(&planned, RobotLanguage::Inform).unwrap());
    let count = |start: &str| job.lines().filter(|line| line.starts_with(start)).count();
    assert!(job.contains("///GROUP1 RB1,BS1\nNOP\n") && job.contains("///POSTYPE BASE\n///RECTAN\nBC00000="), "{job}");
    assert_eq!(job.lines().nth(3).unwrap(), format!("///NPOS {0},{0},0,0,0,0", count("C0")));
    assert_eq!(count("BC0"), count("C0"));
    let rail = planned.machine.axes.iter().position(|axis| axis.name == "rail").unwrap();
    let motion = &planned.motion.passes[0];
    let end = motion.path.at(motion.path.length())[rail];
    let bases: Vec<f64> =
        job.lines().filter_map(|line| line.strip_prefix("BC")).map(|line| line[6..].parse().unwrap()).collect();
    assert!(bases.iter().any(|mm| (mm - end).abs() < 1e-3), "{end} {bases:?}");
}

/// An arm on a rail beside a positioner: base axes and station of a job come back from its text.
#[test]
fn a_rail_and_a_positioner_come_back() {
    let [rail, positioner] = ["irb-2600-rail", "irb-2600-positioner"].map(|name| shipped(name).unwrap().text);
    let work = &positioner[positioner.find("[[work]]").unwrap()..positioner.find("# Shapes").unwrap()];
    let machine = rail.replace("[[work]]\nfixed = { move_mm = [900, 0, 0] }\n", work);
    let machine = Machine::read("both", &machine).unwrap();
    let arm = RobotArm::new(&machine, RobotLanguage::Inform).unwrap();
    assert_eq!(arm.externals.iter().map(|axis| axis.name.as_str()).collect::<Vec<_>>(), ["rail", "tilt", "turn"]);
    let mut random = Random::new(45);
    let mut step = |is_arc| {
        let mut step = random_step(&mut random, RobotLanguage::Inform, is_arc);
        let mut externals = || [2000.0, 90.0, 720.0].map(|max| random.within(-max, max)).to_vec();
        step.externals = externals();
        if let Some(via) = &mut step.via {
            via.externals = externals();
        }
        step
    };
    let mut steps = vec![RobotStep::Pass("p".to_owned())];
    steps.push(RobotStep::JointsTo(TcpMove { speed_mm_s: 0.0, ..step(false) }));
    steps.extend((0..40).map(|k| RobotStep::Move(step(k % 4 == 2))));
    let program = RobotProgram { title: "random".to_owned(), frames: None, steps };
    let remarks = RobotText { machine: &machine, arm: &arm, remarks: &[] };
    let text = write_robot(RobotLanguage::Inform, &program, &remarks);
    let back = read_robot(RobotLanguage::Inform, "p", &text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(back.steps.len(), program.steps.len());
    for (asked, read) in program.steps.iter().zip(&back.steps) {
        assert!(is_near(asked, read), "{asked:?} {read:?}");
    }
    // A position of the base axes that no line declares, and one too few.
    let at = text.lines().find(|line| line.starts_with("BC00003=")).unwrap();
    let missing = read_robot(RobotLanguage::Inform, "p", &text.replace(&format!("{at}\n"), "")).unwrap_err();
    assert!(missing.to_string().contains("BC00003"), "{missing}");
    let uncounted = text.replacen("///NPOS 51,51,", "///NPOS 51,50,", 1);
    assert_ne!(uncounted, text);
    assert!(read_robot(RobotLanguage::Inform, "p", &uncounted).is_err());
}

/// A positioner carries the work: lines and arcs are straight and round on it. On FANUC and Yaskawa poses stand still in
/// space.
#[test]
fn a_positioner_is_coordinated() {
    for (machine, language) in [
        ("irb-2600-positioner", RobotLanguage::Rapid),
        ("kr-16-positioner", RobotLanguage::Krl),
        ("arc-mate-120id-positioner", RobotLanguage::FanucLs),
        ("ar1440-positioner", RobotLanguage::Inform),
    ] {
        let planned = on(machine);
        proven(&planned, language);
        if language == RobotLanguage::FanucLs {
            stands_still_in_space(&planned);
        }
        let positions = |axis: &str| {
            let i = planned.machine.axes.iter().position(|a| a.name == axis).unwrap();
            let motion = &planned.motion.passes[0];
            let ends = [0.0, 0.5, 1.0].map(|f| motion.path.at(f * motion.path.length())[i].to_degrees());
            println!("{machine} {axis}: {ends:.1?} degrees");
            ends
        };
        assert!(["tilt", "turn"].map(positions).concat().iter().any(|deg| deg.abs() > 1.0), "{machine}");
    }
}

/// A weld on a tilted positioner by hand: the pose in space is the pose on the plate, turned by the plate.
fn stands_still_in_space(planned: &Planned) {
    let [rapid, fanuc] =
        [RobotLanguage::Rapid, RobotLanguage::FanucLs].map(|language| program(planned, language).unwrap());
    let first = |program: &RobotProgram| {
        let step = program
            .steps
            .iter()
            .find_map(|step| if let RobotStep::Move(step) = step { Some(step.clone()) } else { None });
        step.unwrap()
    };
    let (on_plate, standing) = (first(&rapid), first(&fanuc));
    let [tilt, turn] = on_plate.externals[..] else { panic!("{on_plate:?}") };
    // The plate is 100 mm above the tilt axis; the work frame is the plate's.
    let turned = DQuat::from_rotation_z(turn.to_radians()) * on_plate.to.point + DVec3::new(0.0, 0.0, 100.0);
    let expected = DQuat::from_rotation_y(tilt.to_radians()) * turned - DVec3::new(0.0, 0.0, 100.0);
    assert!(standing.to.point.distance(expected) < 1e-9, "{expected} {:?}", standing.to);
}

/// A move to a random pose with a configuration of the language.
fn random_move(random: &mut Random, language: RobotLanguage) -> TcpMove {
    let turn = DQuat::from_axis_angle(random.vector(1.0).normalize(), random.within(-PI, PI));
    let flag = |random: &mut Random| i32::from(random.within(0.0, 1.0) < 0.5);
    let quarter = |random: &mut Random| random.within(-3.0, 3.0) as i32;
    let configuration = match language {
        RobotLanguage::Rapid => vec![quarter(random), quarter(random), quarter(random), 5],
        RobotLanguage::Krl => vec![6, 35],
        RobotLanguage::FanucLs => {
            vec![flag(random), flag(random), flag(random), quarter(random), quarter(random), quarter(random)]
        }
        RobotLanguage::Inform => vec![flag(random), flag(random), 0, 1, 0, 0, 0, 0],
        RobotLanguage::Urscript => Vec::new(),
    };
    TcpMove {
        via: None,
        to: RobotPose { point: random.vector(2000.0), turn },
        externals: Vec::new(),
        configuration,
        speed_mm_s: (random.within(0.1, 200.0) * 10.0).ceil() / 10.0,
        zone_mm: 0.0,
    }
}

/// The same, possibly along an arc.
fn random_step(random: &mut Random, language: RobotLanguage, is_arc: bool) -> TcpMove {
    let step = random_move(random, language);
    if !is_arc {
        return step;
    }
    let TcpMove { to: mut pose, mut configuration, .. } = random_move(random, language);
    if matches!(language, RobotLanguage::Krl | RobotLanguage::Urscript) {
        (pose.turn, configuration) = (DQuat::IDENTITY, Vec::new());
    }
    TcpMove { via: Some(ThroughPoint { pose, externals: Vec::new(), configuration }), ..step }
}

/// Random poses and positions come back from the text, to its decimals.
#[test]
fn random_programs_come_back() {
    let machines = ["irb-2600", "kr-16", "arc-mate-120id", "ur10e", "ar1440"];
    for (language, name) in RobotLanguage::ALL.into_iter().zip(machines) {
        let machine = Machine::read(name, shipped(name).unwrap().text).unwrap();
        let arm = RobotArm::new(&machine, language).unwrap();
        let mut random = Random::new(43);
        let values = WeldValues { current_a: 200.0, voltage_v: 24.5, wire_feed_m_min: 0.0 };
        for _ in 0..cases(20u32) {
            let mut steps = vec![RobotStep::Pass("p".to_owned())];
            steps.push(match language {
                RobotLanguage::Inform => {
                    RobotStep::JointsTo(TcpMove { speed_mm_s: 0.0, ..random_move(&mut random, language) })
                }
                _ => RobotStep::Joints(JointTarget {
                    arm: [(); 6].map(|()| random.within(-180.0, 180.0)),
                    externals: Vec::new(),
                }),
            });
            steps.push(RobotStep::Move(random_move(&mut random, language)));
            steps.push(RobotStep::ArcOn(ArcStart { preflow_s: 0.0, delay_s: 0.25, values }));
            // Every fourth move is an arc between lines.
            steps.extend((0..20).map(|k| RobotStep::Move(random_step(&mut random, language, k % 4 == 2))));
            steps.push(RobotStep::ArcOff(ArcEnd { crater_s: 0.5, postflow_s: 0.0 }));
            steps.push(RobotStep::Wait(1.5));
            let program = RobotProgram { title: "random".to_owned(), frames: None, steps };
            let text = write_robot(language, &program, &RobotText { machine: &machine, arm: &arm, remarks: &[] });
            let back = read_robot(language, "p", &text).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(back.steps.len(), program.steps.len());
            for (asked, told) in program.steps.iter().zip(&back.steps) {
                assert!(is_near(asked, told), "{} {asked:?} {told:?}", language.name());
            }
        }
    }
}

fn is_near(asked: &RobotStep, told: &RobotStep) -> bool {
    match (asked, told) {
        (RobotStep::Move(a), RobotStep::Move(t)) | (RobotStep::JointsTo(a), RobotStep::JointsTo(t)) => {
            let is_same_via = match (&a.via, &t.via) {
                (Some(a), Some(t)) => {
                    a.pose.point.distance(t.pose.point) < 2e-3
                        && a.pose.angle_to(&t.pose) < 2e-5
                        && a.configuration == t.configuration
                }
                (a, t) => a.is_none() && t.is_none(),
            };
            let of = |step: &TcpMove| {
                let via = step.via.iter().flat_map(|via| via.externals.clone());
                via.chain(step.externals.clone()).collect::<Vec<f64>>()
            };
            let (externals, found) = (of(a), of(t));
            is_same_via
                && externals.len() == found.len()
                && externals.iter().zip(&found).all(|(a, t)| (a - t).abs() < 2e-3)
                && a.to.point.distance(t.to.point) < 2e-3
                && a.to.angle_to(&t.to) < 2e-5
                && a.configuration == t.configuration
                && (a.speed_mm_s - t.speed_mm_s).abs() < 1e-6
        }
        (RobotStep::Joints(a), RobotStep::Joints(t)) => a.arm.iter().zip(t.arm).all(|(a, t)| (a - t).abs() < 2e-4),
        (RobotStep::Pass(_), RobotStep::Pass(_)) => true,
        (a, t) => a == t,
    }
}

/// Examples that robots can weld, and the height of their work above the table, mm.
const EXAMPLES: [(&str, f64); 11] = [
    ("ellipse", 200.0),
    ("half-ring", 200.0),
    ("head-nozzle", 0.0),
    ("knuckle-nozzle", 40.0),
    ("radiator", 200.0),
    ("set-in-nozzle", 300.0),
    ("spline", 200.0),
    ("trunnion-saddle", 150.0),
    ("tube-plate", 200.0),
    ("weave", 200.0),
    ("y-branch", 120.0),
];

/// The text of an example with its work on the table of a robot.
pub(crate) fn placed(example: &str, height_mm: f64, machine: &str) -> String {
    let path = format!("{}/../../examples/{example}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines: Vec<String> = Vec::new();
    let mut has_placement = false;
    for line in text.lines() {
        if line.starts_with("machine = ") {
            lines.push(format!("machine = \"{machine}\""));
        } else if line.starts_with("move_mm = ") && lines.iter().any(|l| l.starts_with("[placement]")) && !has_placement
        {
            has_placement = true;
            lines.push(format!("move_mm = [0, 0, {height_mm}]"));
        } else {
            lines.push(line.to_owned());
        }
    }
    if !has_placement {
        lines.push(format!("[placement]\nmove_mm = [0, 0, {height_mm}]"));
    }
    lines.join("\n")
}

/// Every example on an arm of every language: what the arm can weld is proven, unless the language refuses it.
fn examples_on(machine: &str, language: RobotLanguage, min: usize) {
    let mut proven_count = 0;
    for (example, height) in EXAMPLES {
        let began = std::time::Instant::now();
        let Ok(planned) = Planned::attempt(&placed(example, height, machine), str::to_owned) else {
            println!("{machine} {example}: cannot be welded here, {:.1?}", began.elapsed());
            continue;
        };
        match program(&planned, language) {
            Ok(_) => {
                let proof = proven(&planned, language);
                assert!(proof.passes.iter().all(|pass| pass.tip_mm <= 0.05 + 1e-5 && pass.time_percent.abs() <= 0.1));
                proven_count += 1;
                println!("{example}: {:.1?}", began.elapsed());
            }
            Err(e) => println!("{machine} {example}: {e}"),
        }
    }
    assert!(proven_count >= min, "{proven_count}");
}

#[test]
fn examples_are_proven_in_rapid() {
    examples_on("irb-2600", RobotLanguage::Rapid, 10);
}

#[test]
fn examples_are_proven_in_urscript() {
    examples_on("ur10e", RobotLanguage::Urscript, 8);
}

#[test]
fn examples_are_proven_in_krl() {
    examples_on("kr-16", RobotLanguage::Krl, 10);
}

#[test]
fn examples_are_proven_in_fanuc_ls() {
    examples_on("arc-mate-120id", RobotLanguage::FanucLs, 10);
}

#[test]
fn examples_are_proven_in_inform() {
    examples_on("ar1440", RobotLanguage::Inform, 10);
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
    damaged(&on("kr-16"), RobotLanguage::Krl);
    damaged(&on("arc-mate-120id"), RobotLanguage::FanucLs);
    damaged(&on("ar1440"), RobotLanguage::Inform);
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

/// The tool is counted from the maker's flange: a torch that reaches 90 mm to the side of x on ABB reaches to the other
/// side on FANUC, where x points up.
#[test]
fn tools_are_counted_from_the_flange() {
    for (name, language, x) in [
        ("irb-2600", RobotLanguage::Rapid, 90.0),
        ("kr-16", RobotLanguage::Krl, 90.0),
        ("arc-mate-120id", RobotLanguage::FanucLs, -90.0),
        ("ar1440", RobotLanguage::Inform, -90.0),
        ("ur10e", RobotLanguage::Urscript, 90.0),
    ] {
        let machine = Machine::read(name, shipped(name).unwrap().text).unwrap();
        let tool = RobotArm::new(&machine, language).unwrap().tool;
        assert!(tool.point.distance(DVec3::new(x, 0.0, 330.0)) < 1e-9, "{name} {tool:?}");
        let along = tool.turn * DVec3::Z;
        assert!((along.x - x.signum() * 35f64.to_radians().sin()).abs() < 1e-9, "{name} {along}");
    }
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
    // INFORM counts base axes along x, y and z of the base frame.
    let rail = shipped("irb-2600-rail").unwrap().text;
    for along in ["[0, -1, 0]", "[1, 1, 0]"] {
        let machine = Machine::read("m", &rail.replacen("move = [0, 1, 0]", &format!("move = {along}"), 1)).unwrap();
        let error = RobotArm::new(&machine, RobotLanguage::Inform).unwrap_err();
        assert!(matches!(&error, Error::BaseAxis { axis, .. } if axis == "rail"), "{error:?}");
        assert!(RobotArm::new(&machine, RobotLanguage::Rapid).is_ok());
    }
}
