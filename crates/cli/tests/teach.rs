//! `seamwright teach`: simulated, recorded, by hand; what it refuses.

mod common;

use common::{example, good, run};
use std::path::{Path, PathBuf};

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

fn report(program: &str) -> String {
    std::fs::read_to_string(PathBuf::from(program).with_extension("report.json")).unwrap()
}

/// A number of the report by its key.
fn number(report: &str, key: &str) -> f64 {
    let at = report.find(&format!("\"{key}\": ")).unwrap_or_else(|| panic!("no {key}")) + key.len() + 4;
    let end = report[at..].find([',', '\n']).unwrap();
    report[at..at + end].trim().parse().unwrap_or_else(|_| panic!("{key}: {}", &report[at..at + end]))
}

/// A short open joint on the EBW machine.
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
    assert!(String::from_utf8_lossy(&output.stderr).contains("the frames are at their end"));
    let output = run(&["teach", &job, "--frames", "simulated", "--tack", "40,80", "-o", &again]);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(report(&again).contains("\"ended\": \"lost\""));
    // A picture cut off, positions of another machine.
    std::fs::write(folder.join("frames/000001.png"), b"\x89PNG").unwrap();
    let output = run(&["teach", &job, "--frames", &frames, "-o", &again]);
    assert_eq!(output.status.code(), Some(2));
    std::fs::write(&list, "file,t_s,x,y\n000000.png,0,1,2\n").unwrap();
    let output = run(&["teach", &job, "--frames", &frames, "-o", &again]);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && errors.contains("frames.csv:1"), "{errors}");
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
    // Half a millimetre above the nominal seam all along.
    assert!(text.contains("60.5") && good(&["check", &program]).contains("can be made"), "{text}");
    for (bad, why) in [
        ("x_mm,y_mm,z_mm\n", "no points"),
        ("x_mm,y_mm,z_mm\n0,500,0\n", "not within 15 mm"),
        ("x_mm,y_mm,z_mm\n-40,1,60.5\n-40,1,60.5\n", "in one place"),
        ("x_mm,y_mm\n0,0\n", "column"),
    ] {
        std::fs::write(&points, bad).unwrap();
        let output = run(&["teach", &job, "--semi-manual", &points, "-o", &path(folder, "none.toml")]);
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && errors.contains(why), "{errors}");
        assert!(!folder.join("none.toml").exists());
    }
}

#[test]
fn mistakes_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (job, none) = (short(folder), path(folder, "none.toml"));
    let refused = |arguments: &[&str], why: &str| {
        let output = run(&[&["teach"], arguments, &["-o", &none]].concat());
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && errors.contains(why), "{arguments:?}: {errors}");
        assert!(!Path::new(&none).exists());
    };
    refused(&[&job], "--frames");
    refused(&[&job, "--frames", "simulated", "--sensor", "eye"], "allowed: beam");
    refused(&[&job, "--frames", "simulated", "--start", "500,0,0"], "not near the nominal seam");
    refused(&[&job, "--frames", "simulated", "--start", "500,0"], "--start: 2 numbers");
    refused(&[&job, "--frames", "simulated", "--direction", "0,0,0"], "no length");
    refused(&[&job, "--frames", "simulated", "--distortion", "1,99,1"], "turn 99");
    refused(&[&job, "--frames", "simulated", "--tack", "9,3"], "FROM before TO");
    refused(&[&job, "--frames", "simulated", "--tolerance-mm", "0"], "--tolerance-mm");
    refused(&[&job, "--frames", "simulated", "--longest-tack-mm", "nan"], "--longest-tack-mm");
    refused(&[&example("ellipse"), "--frames", "simulated"], "has no camera");
    let output = run(&["teach", &job, "--frames", &path(folder, "nowhere"), "-o", &none]);
    assert_eq!(output.status.code(), Some(3));
}
