//! `seamwright teach`: simulated, recorded, by hand; refusals.

use crate::common::{self, bad, example, good, has_all, run, run_with};
use glam::DVec3;
use seamwright_frames::{FrameSource as _, Recorded, TimedFrame, write_frame};
use std::io::{BufRead as _, BufReader};
use std::net::TcpListener;
use std::path::{Path, PathBuf};

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

fn report(program: &str) -> String {
    std::fs::read_to_string(PathBuf::from(program).with_extension("report.json")).unwrap()
}

fn number(report: &str, key: &str) -> f64 {
    let at = report.find(&format!("\"{key}\": ")).unwrap_or_else(|| panic!("no {key}")) + key.len() + 4;
    let end = report[at..].find([',', '\n']).unwrap();
    report[at..at + end].trim().parse().unwrap_or_else(|_| panic!("{key}: {}", &report[at..at + end]))
}

fn short(folder: &Path) -> String {
    let job = path(folder, "short.toml");
    let text = "schema = 1\ntitle = \"short\"\nmachine = \"ebw-7axis\"\n[placement]\nmove_mm = [0, 0, 60]\n[seam.spline]\n\
        joint = \"butt\"\npoints_mm = [[-40, 0, 0], [-15, 12, 0], [15, 12, 0], [40, 30, 0]]\n[weld]\nspeed_mm_s = 8\n\
        [weld.process]\nbeam_ma = 30\n";
    std::fs::write(&job, text).unwrap();
    job
}

#[test]
fn taught_in_simulation_and_again_from_its_frames() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, program, frames) = (short(folder), path(folder, "taught.toml"), path(folder, "frames"));
    let simulated = ["teach", &job, "--frames", "simulated", "--seed", "4", "--tack", "30,34", "-o", &program];
    let told = good(&[&simulated[..], &["--record", &frames]].concat());
    assert!(told.starts_with("joint-end after ") && told.contains("truly 0.0"), "{told}");
    let live = report(&program);
    assert!(number(&live, "across_rms_mm") <= 0.05 && number(&live, "across_max_mm") <= 0.1);
    assert!(number(&live, "end_mm") <= 0.3 && number(&live, "greatest_error_mm") <= 0.05);
    // It is a program for the other verbs.
    assert!(good(&["check", &program]).contains("can be made"));
    good(&["plan", &program, "-o", &path(folder, "plan")]);
    assert!(good(&["post", &program, "--dialect", "sinumerik"]).contains("M30"));
    // From its frames alone the same line is found, without the truth.
    let again = path(folder, "again.toml");
    let told = good(&["teach", &job, "--frames", &frames, "-o", &again]);
    assert!(told.starts_with("joint-end after ") && !told.contains("truly"), "{told}");
    let (a, b) = (number(&live, "length_mm"), number(&report(&again), "length_mm"));
    assert!((a - b).abs() < 0.3, "{a} {b}");
    // The same seed gives the same program.
    let other = path(folder, "other.toml");
    let mut repeated = simulated;
    repeated[9] = &other;
    good(&repeated);
    assert_eq!(std::fs::read_to_string(&program).unwrap(), std::fs::read_to_string(&other).unwrap());
    let json = good(&[&repeated[..], &["--json"]].concat());
    assert!(json.contains("\"ended\": \"joint-end\"") && json.contains("\"truth\""));
    assert!(std::fs::read_to_string(path(folder, "taught.svg")).unwrap().starts_with("<svg"));
    // Frames that end too early; and the joint lost behind a tack.
    let list = path(&folder.join("frames"), "frames.csv");
    let text = std::fs::read_to_string(&list).unwrap();
    std::fs::write(&list, text.lines().take(4).map(|l| format!("{l}\n")).collect::<String>()).unwrap();
    let output = run(&["teach", &job, "--frames", &frames, "-o", &again]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("the frames end before the joint"));
    let output = run(&["teach", &job, "--frames", "simulated", "--tack", "40,80", "-o", &again]);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(report(&again).contains("\"ended\": \"lost\""));
    // A picture cut off, positions of another machine.
    std::fs::write(folder.join("frames/000001.png"), b"\x89PNG").unwrap();
    bad(2, &["teach", &job, "--frames", &frames, "-o", &again]);
    std::fs::write(&list, "file,t_s,x,y\n000000.png,0,1,2\n").unwrap();
    let errors = bad(2, &["teach", &job, "--frames", &frames, "-o", &again]);
    assert!(errors.contains("frames.csv:1"), "{errors}");
}

#[test]
fn taught_by_hand() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, program, points) = (short(folder), path(folder, "hand.toml"), path(folder, "points.csv"));
    std::fs::write(&points, "x_mm,y_mm,z_mm\n-40,1,60.5\n40,31,60.5\n").unwrap();
    let told = good(&["teach", &job, "--semi-manual", &points, "-o", &program]);
    assert!(told.contains("operator's points"), "{told}");
    let text = std::fs::read_to_string(&program).unwrap();
    // Half a millimetre above the nominal seam all along, and the part is still an obstacle.
    assert!(text.contains("[seam.spline]") && good(&["check", &program]).contains("can be made"), "{text}");
    let heights = poses(&program).into_iter().map(|(point, _)| point.z);
    assert!(heights.clone().all(|z| (z - 60.5).abs() < 0.06), "{:?}", heights.collect::<Vec<_>>());
    for (rows, why) in [
        ("x_mm,y_mm,z_mm\n", "no points"),
        ("x_mm,y_mm,z_mm\n0,500,0\n", "farther than 15 mm"),
        ("x_mm,y_mm,z_mm\n-40,1,60.5\n-40,1,60.5\n", "at the same position"),
        ("x_mm,y_mm\n0,0\n", "column"),
    ] {
        std::fs::write(&points, rows).unwrap();
        let errors = bad(2, &["teach", &job, "--semi-manual", &points, "-o", &path(folder, "none.toml")]);
        assert!(errors.contains(why), "{errors}");
        assert!(!folder.join("none.toml").exists());
    }
}

#[test]
fn mistakes_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, none) = (short(folder), path(folder, "none.toml"));
    let refused = |arguments: &[&str], why: &str| {
        let errors = bad(2, &[&["teach"], arguments, &["-o", &none]].concat());
        assert!(errors.contains(why), "{arguments:?}: {errors}");
        assert!(!Path::new(&none).exists());
    };
    refused(&[&job], "--frames");
    for sensor in ["eye", "", "Beam"] {
        refused(&[&job, "--frames", "simulated", "--sensor", sensor], "allowed: beam");
    }
    refused(&[&job, "--frames", "simulated", "--start", "500,0,0"], "not near the nominal seam");
    refused(&[&job, "--frames", "simulated", "--start", "500,0"], "--start: 2 numbers");
    refused(&[&job, "--frames", "simulated", "--direction", "0,0,0"], "no length");
    refused(&[&job, "--frames", "simulated", "--distortion", "1,99,1"], "turn 99");
    refused(&[&job, "--frames", "simulated", "--tack", "9,3"], "FROM before TO");
    refused(&[&job, "--frames", "simulated", "--tolerance-mm", "0"], "--tolerance-mm");
    for tack in ["nan", "0", "-3"] {
        refused(&[&job, "--frames", "simulated", "--longest-tack-mm", tack], "--longest-tack-mm");
    }
    refused(&[&example("ellipse"), "--frames", "simulated"], "has no camera");
    for address in ["tcp://", "tcp://here", "tcp://:5000", "tcp://here:0", "tcp://here:99999", "http://here:80"] {
        refused(&[&job, "--frames", address], &format!("--frames {address}: "));
    }
    for timeout in ["0", "-1", "nan", "1e9"] {
        refused(&[&job, "--frames", "tcp://127.0.0.1:1", "--timeout-s", timeout], "allowed: 0.001 to 3600");
    }
    for step in ["0.1", "-8", "inf", "1000"] {
        refused(&[&job, "--frames", "simulated", "--step-mm", step], "allowed: 1 to 100");
    }
    for attitude in ["0", "nan", "91"] {
        refused(&[&job, "--frames", "simulated", "--attitude-deg", attitude], "--attitude-deg");
    }
    for method in ["best", "", "lines"] {
        refused(&[&job, "--frames", "simulated", "--method", method], "greedy, fewest, spline");
    }
    for seed in ["-1", "1.5", "one"] {
        refused(&[&job, "--frames", "simulated", "--seed", seed], "--seed");
    }
    for start in ["nan,0,60", "1,2,3,4", "a,b,c"] {
        refused(&[&job, "--frames", "simulated", "--start", start], "--start");
    }
    for direction in ["nan,0,0", "1", "inf,0,0"] {
        refused(&[&job, "--frames", "simulated", "--direction", direction], "--direction");
    }
    for distortion in ["1,2", "-1,0,0", "0,0,nan"] {
        refused(&[&job, "--frames", "simulated", "--distortion", distortion], "--distortion");
    }
    for tack in ["5", "a,b", "-1,-5"] {
        refused(&[&job, "--frames", "simulated", "--tack", tack], "--tack");
    }
    for tolerance in ["-1", "inf", "x"] {
        refused(&[&job, "--frames", "simulated", "--tolerance-mm", tolerance], "--tolerance-mm");
    }
    // Options of another source.
    for option in [&["--seed", "2"][..], &["--distortion", "1,1,1"], &["--tack", "1,2"], &["--no-height"]] {
        refused(&[&[&*job, "--frames", folder.to_str().unwrap()], option].concat(), "only with --frames simulated");
    }
    refused(&[&job, "--frames", "simulated", "--drive"], "only with --frames tcp://HOST:PORT");
    refused(&[&job, "--frames", folder.to_str().unwrap(), "--record", &none], "--record: not allowed here");
    for option in [&["--ask"][..], &["--start", "1,2,3"], &["--drive"], &["--timeout-s", "3"], &["--step-mm", "4"]] {
        refused(&[&[&*job, "--semi-manual", &none], option].concat(), "cannot be used with");
    }
    for beside in ["taught.svg", "taught.png"] {
        let output = path(folder, beside);
        let errors = bad(2, &["teach", &job, "--frames", "simulated", "-o", &output]);
        assert!(errors.contains("a file beside the program") && !Path::new(&output).exists(), "{errors}");
    }
    // A folder that is not there is a wrong name, no failure of the environment.
    assert!(bad(2, &["teach", &job, "--frames", &path(folder, "nowhere"), "-o", &none]).contains("frames.csv"));
}

/// Frames of a recorded folder, as the short job's machine has them.
fn frames(folder: &str) -> Vec<TimedFrame> {
    let axes = ["x", "y", "z", "v", "q", "u", "w"];
    let text = std::fs::read_to_string(Path::new(folder).join("frames.csv")).unwrap();
    let named: Vec<&str> = text.lines().next().unwrap().split(',').filter(|c| axes.contains(c)).collect();
    let mut recorded = Recorded::open(Path::new(folder), &named).unwrap();
    std::iter::from_fn(|| recorded.next().unwrap()).collect()
}

/// Sends frames to the first client. Returns the address, and the commands received.
fn sender(frames: Vec<TimedFrame>, driven: bool) -> (String, std::thread::JoinHandle<Vec<String>>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = format!("tcp://{}", listener.local_addr().unwrap());
    let sender = std::thread::spawn(move || {
        let (mut stream, _) = listener.accept().unwrap();
        let mut lines = BufReader::new(stream.try_clone().unwrap()).lines();
        let mut told = Vec::new();
        for (i, frame) in frames.iter().enumerate() {
            // The first one comes unasked.
            if driven && i > 0 {
                let Some(Ok(line)) = lines.next() else { return told };
                told.push(line);
            }
            if write_frame(frame, &mut stream).is_err() {
                return told;
            }
        }
        told
    });
    (address, sender)
}

/// Distance of axes from the straight way from `a` to `b`: the maximum of all, mm and degrees, at the station where the
/// first three are nearest.
fn off(a: &[f64], b: &[f64], at: &[f64]) -> f64 {
    let dot = |p: &[f64], q: &[f64]| (0..3).map(|k| (p[k] - a[k]) * (q[k] - a[k])).sum::<f64>();
    let part = (dot(at, b) / dot(b, b).max(1e-9)).clamp(0.0, 1.0);
    a.iter().zip(b).zip(at).map(|((a, b), at)| (a + part * (b - a) - at).abs()).fold(0.0, f64::max)
}

#[test]
fn taught_from_frames_that_are_sent() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, program, kept) = (short(folder), path(folder, "taught.toml"), path(folder, "frames"));
    good(&["teach", &job, "--frames", "simulated", "--seed", "4", "--record", &kept, "-o", &program]);
    let simulated = std::fs::read_to_string(&program).unwrap();
    let played = path(folder, "played.toml");
    good(&["teach", &job, "--frames", &kept, "-o", &played]);
    let recorded = std::fs::read_to_string(&played).unwrap();
    // An external machine moves: as from the folder.
    let sent = path(folder, "sent.toml");
    let (address, thread) = sender(frames(&kept), false);
    let again = path(folder, "again");
    let told = good(&["teach", &job, "--frames", &address, "--record", &again, "-o", &sent]);
    assert!(told.starts_with("joint-end after "), "{told}");
    thread.join().unwrap();
    assert_eq!(std::fs::read_to_string(&sent).unwrap(), recorded);
    assert_eq!(frames(&again), frames(&kept));
    // The sender gets the moves of the simulated machine. Its first frame only shows its position.
    let all = frames(&kept);
    let asked_first: Vec<TimedFrame> =
        std::iter::once(TimedFrame { t_s: 0.0, ..all[0].clone() }).chain(all.clone()).collect();
    let (address, thread) = sender(asked_first, true);
    let begin = report(&program);
    let start = format!("{},{},{}", number(&begin, "x_mm"), number(&begin, "y_mm"), number(&begin, "z_mm"));
    let told = good(&["teach", &job, "--frames", &address, "--drive", "--start", &start, "-o", &sent]);
    assert!(told.starts_with("joint-end after "), "{told}");
    let lines = thread.join().unwrap();
    // Each frame was taken a little beside where it is asked for now: a step may be longer or shorter, but is on the same way.
    assert!(lines.len().abs_diff(all.len()) <= 1, "{} {told}", lines.len());
    let way: Vec<&[f64]> = all.iter().map(|frame| frame.axes.as_deref().unwrap()).collect();
    for line in &lines[1..] {
        let words = line.strip_prefix("look ").unwrap_or_else(|| panic!("{line}")).split(' ');
        let asked: Vec<f64> = words.map(|word| word.split_once('=').unwrap().1.parse().unwrap()).collect();
        let off = way.windows(2).map(|leg| off(leg[0], leg[1], &asked)).fold(f64::INFINITY, f64::min);
        assert!(off < 0.5, "{off} {line} {way:?}");
    }
    let (a, b) = (number(&report(&sent), "length_mm"), number(&report(&program), "length_mm"));
    assert!((a - b).abs() < 0.5 && !simulated.is_empty(), "{a} {b}");
    // Too few frames; a frame that never comes; invalid bytes; no sender.
    let (address, thread) = sender(all[..3].to_vec(), false);
    assert!(bad(1, &["teach", &job, "--frames", &address, "-o", &sent]).contains("the frames end before the joint"));
    thread.join().unwrap();
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = format!("tcp://{}", listener.local_addr().unwrap());
    let waited = bad(3, &["teach", &job, "--frames", &address, "--timeout-s", "0.2", "-o", &sent]);
    assert!(waited.contains("did not come in time"), "{waited}");
    let thread = std::thread::spawn(move || {
        // The one before is still in the queue.
        for _ in 0..2 {
            let (mut stream, _) = listener.accept().unwrap();
            let _ = std::io::Write::write_all(&mut stream, &[b'x'; 64]);
        }
    });
    let garbage = bad(2, &["teach", &job, "--frames", &address, "-o", &sent]);
    assert!(garbage.contains("frame 0: invalid first bytes") && garbage.contains("SWFR"), "{garbage}");
    thread.join().unwrap();
    assert_eq!(run(&["teach", &job, "--frames", &address, "-o", &sent]).status.code(), Some(3));
    // A frame of another machine in the middle: the frames before it can be played.
    let mut spoiled = all[..4].to_vec();
    spoiled[3].axes = Some(vec![0.0]);
    let (address, thread) = sender(spoiled, false);
    let some = path(folder, "some");
    let wrong = bad(2, &["teach", &job, "--frames", &address, "--record", &some, "-o", &sent]);
    assert!(wrong.contains("frame 3: invalid number of axes: 1") && wrong.contains("allowed: 7"), "{wrong}");
    thread.join().unwrap();
    assert_eq!(frames(&some), all[..3]);
}

#[test]
fn the_operator_is_asked_and_it_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, program) = (short(folder), path(folder, "taught.toml"));
    let lost = ["teach", &job, "--frames", "simulated", "--seed", "4", "--tack", "30,55", "-o", &program];
    // Without an operator the program asks no question.
    assert_eq!(run(&lost).status.code(), Some(1));
    assert!(report(&program).contains("\"ended\": \"lost\""));
    let up_to = number(&report(&program), "length_mm");
    // The tack starts at 30.
    assert!((28.0..=31.0).contains(&up_to), "{up_to}");
    let ask = [&lost[..], &["--ask"]].concat();
    let answered = |input: &str| {
        let output = run_with(&ask, input);
        (output.status.code(), String::from_utf8(output.stderr).unwrap(), String::from_utf8(output.stdout).unwrap())
    };
    // Mistakes are reported and the question is repeated; then a point behind the tack, near enough to the hidden
    // joint.
    let mistakes = "there\n1,2\n900,0,60\n15,12,60.5,0,0,0\n1,2,nan\n";
    let (code, told, printed) = answered(&format!("{mistakes}19.5,13.9,60.5\n"));
    has_all(
        &told,
        &["lost after ", "not three or six numbers", "not within 15 mm of the nominal seam", "no length", "taught.png"],
    );
    assert_eq!(told.matches("allowed: X,Y,Z").count(), 5, "{told}");
    assert_eq!(code, Some(0), "{told}");
    assert!(printed.starts_with("joint-end after ") && printed.contains("asked: "), "{printed}");
    let whole = report(&program);
    assert!(number(&whole, "across_max_mm") <= 0.1 && number(&whole, "end_mm") <= 0.3, "{printed}");
    assert!(number(&whole, "length_mm") > up_to + 40.0 && number(&whole, "bridged_mm") > 20.0);
    // The same answer with a direction; the end; giving up, in words or by silence.
    assert_eq!(answered("19.5,13.9,60.5,1,0.2,0\n").0, Some(0));
    let (code, _, printed) = answered("end\n");
    assert!(code == Some(0) && printed.starts_with("operator after "), "{printed}");
    assert!((number(&report(&program), "length_mm") - up_to).abs() < 1e-9);
    for silent in ["stop\n", "", "nonsense\n"] {
        assert_eq!(answered(silent).0, Some(1));
        assert!(report(&program).contains("\"ended\": \"lost\""));
    }
}

#[test]
fn reduced_to_a_spline_with_the_torch_at_its_angles() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, program) = (short(folder), path(folder, "taught.toml"));
    let leaning = std::fs::read_to_string(&job).unwrap() + "[torch]\nwork_angle_deg = 12\ntravel_angle_deg = -8\n";
    let bent = path(folder, "leaning.toml");
    std::fs::write(&bent, leaning).unwrap();
    // Shifted and turned, not bent: then the torch is nearly that of the job.
    let rigid = ["--frames", "simulated", "--seed", "4", "--distortion", "1,0.3,0", "--method", "spline"];
    let told = good(&[&["teach", &bent], &rigid[..], &["-o", &program]].concat());
    assert!(told.contains("program: a spline of ") && told.contains(" of every raw point"), "{told}");
    let whole = report(&program);
    assert!(number(&whole, "greatest_error_mm") <= 0.05 && number(&whole, "greatest_from_raw_mm") <= 0.2);
    let text = std::fs::read_to_string(&program).unwrap();
    assert!(text.contains("along = \"spline\""), "{text}");
    let svg = std::fs::read_to_string(path(folder, "taught.svg")).unwrap();
    assert!(svg.contains("spline") && std::fs::read(path(folder, "taught.png")).unwrap().starts_with(b"\x89PNG"));
    // It is planned, and its torch leans as the job's does beside it: no more off than the part lies turned.
    let taught = poses(&program);
    let asked = poses(&bent);
    for (point, direction) in taught.iter().step_by(10) {
        let beside = asked.iter().min_by(|a, b| a.0.distance(*point).total_cmp(&b.0.distance(*point))).unwrap();
        let off = beside.1.angle_between(*direction);
        assert!(
            off < 0.03 && (-direction.z - 12f64.to_radians().cos() * 8f64.to_radians().cos()).abs() < 0.02,
            "{off}"
        );
    }
}

/// Positions and directions of the torch all along the planned motion of a job or program on the EBW machine.
fn poses(job: &str) -> Vec<(DVec3, DVec3)> {
    let axes = ["x", "y", "z", "v", "q", "u", "w"];
    let motion = common::table(&good(&["tools", "motion", job, "--period-ms", "20"]));
    let columns = axes.map(|name| common::column(&motion, name));
    let rows = (0..columns[0].len()).map(|i| columns.iter().map(|c| c[i].to_string()).collect::<Vec<_>>().join(","));
    let input = std::iter::once(axes.join(",")).chain(rows).map(|row| row + "\n").collect::<String>();
    let output = run_with(&["machine", "kinematics", "ebw-7axis", "--forward"], &input);
    let poses = common::table(&String::from_utf8(output.stdout).unwrap());
    let at = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"].map(|name| common::column(&poses, name));
    let vector = |i: usize, k: usize| DVec3::new(at[k][i], at[k + 1][i], at[k + 2][i]);
    (0..at[0].len()).map(|i| (vector(i, 0), vector(i, 3))).collect()
}
