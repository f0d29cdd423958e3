//! Welds as streams of set-points in URScript: the planned positions at the period, proven by reading back.

use crate::common::Planned;
use crate::robots::{OPTIONS, on, placed, plan, program_with, text};
use seamwright_document::Positive;
use seamwright_post::Error;
use seamwright_post::robot::{
    MAX_SET_POINTS, RobotImport, RobotLanguage, RobotOptions, RobotProgram, RobotStep, ServoStream, read_robot,
    robot_to_program, verify_robot,
};

const URSCRIPT: RobotLanguage = RobotLanguage::Urscript;

fn streamed(planned: &Planned, period_s: f64) -> Result<RobotProgram, Error> {
    let stream = Some(ServoStream::with_period(period_s));
    program_with(planned, URSCRIPT, &RobotOptions { stream, ..OPTIONS })
}

/// The angles of every `servoj`, rad, read from the text without the reader.
fn set_points(text: &str, settings: &str) -> Vec<Vec<f64>> {
    let points = text.lines().filter_map(|line| line.trim_start().strip_prefix("servoj(["));
    let angles = |line: &str| {
        let (angles, rest) = line.split_once("], ").unwrap();
        assert_eq!(rest.strip_suffix(')'), Some(settings));
        angles.split(", ").map(|angle| angle.parse().unwrap()).collect()
    };
    points.map(angles).collect()
}

/// The text has the planned positions at each period, and the end for the look-ahead time.
fn is_the_motion(planned: &Planned, text: &str, period_s: f64) {
    let motion = &planned.motion.passes[0];
    let duration = motion.profile.duration();
    let points = set_points(text, &format!("0, 0, {period_s}, 0.1, 300"));
    let moving = (duration / period_s).ceil() as usize;
    assert_eq!(points.len(), moving + (0.1 / period_s).ceil() as usize);
    for (k, point) in (1..).zip(&points) {
        let time = (f64::from(k) * period_s).min(duration);
        let q = motion.path.at(motion.profile.at(time, &mut 0).s);
        for (axis, angle) in point.iter().enumerate() {
            assert!((q[axis] - angle).abs() < 1e-9, "{k}: axis {axis}: {} {angle}", q[axis]);
        }
    }
}

/// A nozzle, and a weave whose current changes at its sides, on e-Series and CB3.
#[test]
fn a_stream_is_the_plan() {
    for (job, period_s) in [("nozzle", 0.008), ("weave", 0.002), ("weave", 0.008)] {
        let planned = match job {
            "nozzle" => on("ur10e"),
            example => {
                Planned::attempt(&placed(example, 200.0, "ur10e"), str::to_owned).unwrap_or_else(|e| panic!("{e:?}"))
            }
        };
        let asked = streamed(&planned, period_s).unwrap();
        let written = text(&planned, URSCRIPT, &asked);
        is_the_motion(&planned, &written, period_s);
        let read = read_robot(URSCRIPT, "p", &written).unwrap_or_else(|e| panic!("{e}"));
        let proof = verify_robot(&asked, &read, plan(&planned, URSCRIPT)).unwrap_or_else(|e| panic!("{e:?}"));
        println!("{job} {period_s} s, {} KB: {:?}", written.len() / 1000, proof.lines());
        let [pass] = &proof.passes[..] else { panic!("{}", proof.passes.len()) };
        assert!(pass.tip_mm < 2e-3 && pass.speed_inside_percent < 0.05, "{pass:?}");
        assert!(pass.lag_mm < 0.1, "{pass:?}");
        let late_s = pass.arc_s - planned.motion.passes[0].arc_on_s();
        // Times at rest have steps of 1 ms.
        assert!((-1e-9..period_s + 2e-3).contains(&late_s), "{late_s}");
        let changes = asked.steps.iter().filter(|step| matches!(step, RobotStep::Values(_))).count();
        assert_eq!(changes > 10, job == "weave", "{changes}");
    }
}

/// Changes of a text are found: an angle, a missing set-point, the period, a process value.
#[test]
fn a_wrong_stream_is_no_proof() {
    let planned = Planned::attempt(&placed("weave", 200.0, "ur10e"), str::to_owned).unwrap_or_else(|e| panic!("{e:?}"));
    let asked = streamed(&planned, 0.02).unwrap();
    let written = text(&planned, URSCRIPT, &asked);
    let judged = |text: &str| {
        let read = read_robot(URSCRIPT, "p", text).unwrap_or_else(|e| panic!("{e}"));
        verify_robot(&asked, &read, plan(&planned, URSCRIPT)).is_ok()
    };
    assert!(judged(&written));
    let lines: Vec<&str> = written.lines().collect();
    let at = lines.iter().position(|line| line.contains("servoj(")).unwrap() + 20;
    let with = |line: String| {
        let mut lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        lines[at] = line;
        judged(&lines.join("\n"))
    };
    let (first, rest) = lines[at].trim_start().strip_prefix("servoj([").unwrap().split_once(',').unwrap();
    let moved = first.parse::<f64>().unwrap() + 1e-3;
    assert!(!with(format!("  servoj([{moved},{rest}")));
    assert!(!with(String::new()));
    assert!(!with(lines[at].replace("0.02, 0.1, 300", "0.04, 0.1, 300")));
    assert!(!judged(&written.replace("0.02, 0.1, 300)", "0.02, 0.1, 400)")));
    let values = lines.iter().rposition(|line| line.trim_start().starts_with("weld_values(1")).unwrap();
    assert!(!judged(&written.replace(lines[values], "  weld_values(99, 20, 5)")), "{}", lines[values]);
}

/// A path of long pieces in axis space leaves the plan.
#[test]
fn a_long_period_is_no_proof() {
    let planned = on("ur10e");
    let asked = streamed(&planned, 2.0).unwrap();
    let read = read_robot(URSCRIPT, "p", &text(&planned, URSCRIPT, &asked)).unwrap();
    let wrong = verify_robot(&asked, &read, plan(&planned, URSCRIPT)).unwrap_err();
    assert!(wrong.iter().any(|message| message.as_data().contains("post-tip-off")), "{wrong:?}");
}

#[test]
fn streams_have_bounds() {
    let planned = on("ur10e");
    let seconds = planned.motion.passes[0].profile.duration();
    // So short that only the number is tried.
    let period_s = 0.5 * seconds / MAX_SET_POINTS as f64;
    let error = streamed(&planned, period_s).unwrap_err();
    assert!(matches!(error, Error::TooManySetPoints { count, .. } if count > 2 * MAX_SET_POINTS), "{error:?}");
    let stream = Some(ServoStream::with_period(0.008));
    let other = program_with(&on("irb-2600"), RobotLanguage::Rapid, &RobotOptions { stream, ..OPTIONS }).unwrap_err();
    assert!(matches!(other, Error::NoStream { language: RobotLanguage::Rapid }), "{other:?}");
    let read = read_robot(URSCRIPT, "p", &text(&planned, URSCRIPT, &streamed(&planned, 0.04).unwrap())).unwrap();
    let blend_mm = Positive::new(0.1).unwrap();
    let import = RobotImport { machine: &planned.machine, machine_name: "ur10e", language: URSCRIPT, blend_mm };
    assert_eq!(robot_to_program(&read, &import).unwrap_err(), Error::StreamRead);
}
