//! Invalid input: one screen that names file, line, key, value and the allowed values; exit code 2; no files written.
//! Jobs that the machine cannot weld: exit code 1 with every finding.

use crate::common::{self, bad, example, free_example, has_all, run, run_with};
use std::fs;
use std::path::Path;

/// Checks a job or plans it into a new folder: exit code, errors, and whether anything was written.
fn run_on(verb: &str, text: &str) -> (i32, String, bool) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("job.toml"), text).unwrap();
    let [job, out] = ["job.toml", "out"].map(|name| folder.path().join(name).display().to_string());
    let output = if verb == "plan" { run(&[verb, &job, "-o", &out]) } else { run(&[verb, &job]) };
    assert!(verb != "plan" || output.status.success() || output.stdout.is_empty());
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap(), Path::new(&out).exists())
}

fn plan(changes: &[(&str, &str)]) -> (i32, String, bool) {
    plan_changed(fs::read_to_string(example("saddle")).unwrap(), changes)
}

fn plan_changed(text: String, changes: &[(&str, &str)]) -> (i32, String, bool) {
    let text = changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    run_on("plan", &text)
}

fn refused(from: &str, to: &str, words: &[&str]) {
    let (code, text, written) = plan(&[(from, to)]);
    println!("{text}");
    assert_eq!(code, 2, "{text}");
    assert!(!written && text.lines().count() <= 12);
    assert!(text.contains("job.toml:") && text.contains("allowed: "), "{text}");
    has_all(&text, words);
}

#[test]
fn sizes() {
    refused("radius_mm = 250", "radius_mm = 900", &["seam.nozzle.radius_mm = 900", "does not close", "radius 800 mm"]);
    refused("radius_mm = 800", "radius_mm = 200", &["seam.nozzle.radius_mm = 250"]);
    refused("origin_mm = [0, 0, 0]", "origin_mm = [0, 2000, 0]", &["seam.nozzle.origin_mm", "beside the body"]);
    for wrong in ["0", "-250", "nan", "inf", "-inf", "\"250\"", "[250]", "true"] {
        refused("radius_mm = 250", &format!("radius_mm = {wrong}"), &["seam.nozzle.radius_mm", "greater than 0"]);
    }
    refused("speed_mm_s = 10", "speed_mm_s = 0", &["weld.speed_mm_s = 0"]);
}

#[test]
fn heads() {
    let shell = "[seam.nozzle.body.cylinder]\nradius_mm = 800                   # outer radius of the shell\naxis = [1, 0, 0]\n";
    let head = |keys: &str, words: &[&str]| {
        let table = format!("[seam.nozzle.body.torispherical_head]\nouter_diameter_mm = 1600\n{keys}\n");
        refused(shell, &table, words);
    };
    let at = |key: &str| format!("seam.nozzle.body.torispherical_head.{key}");
    head(
        "thickness_mm = 10\nstandard = \"din_28011\"\nknuckle_radius_mm = 790",
        &[&at("knuckle_radius_mm = 790"), "does not fit", "less than the flange's, 790 mm"],
    );
    head(
        "thickness_mm = 10\nstandard = \"din_28013\"\ncrown_radius_mm = 780",
        &[&at("crown_radius_mm = 780"), "hemisphere", "more than the flange's inside radius, 790 mm"],
    );
    head("thickness_mm = 800\nstandard = \"asme_fd\"", &[&at("thickness_mm = 800"), "outer_diameter_mm = 1600"]);
    head("thickness_mm = 300\nstandard = \"asme_fd\"", &[&at("thickness_mm = 300"), "inside radius of 900 mm"]);
    head("thickness_mm = 10\ncrown_radius_mm = 1600", &["crown and knuckle are missing", "din_28011"]);
    head("thickness_mm = 10\nstandard = \"din_28012\"", &[&at("standard"), "din_28011, din_28013, asme_fd"]);
    // The head stands on its side: the nozzle leaves it over the end of the flange.
    head(
        "thickness_mm = 10\nstandard = \"din_28011\"\naxis = [1, 0, 0]\nflange_mm = 30",
        &["seam.nozzle.origin_mm", "beyond the end of the head's flange", "outer diameter 1600 mm"],
    );
    let bend = "[seam.nozzle.body.torus]\nbend_radius_mm = 300\nradius_mm = 400\n";
    refused(shell, bend, &["seam.nozzle.body.torus.bend_radius_mm = 300", "more than radius_mm = 400"]);
    let cone = "[seam.nozzle.body.conical_head]\nouter_diameter_mm = 1600\nthickness_mm = 10\nknuckle_radius_mm = 100\n\
                half_angle_deg = 90\n";
    refused(shell, cone, &["seam.nozzle.body.conical_head.half_angle_deg = 90", "less than 90"]);
}

#[test]
fn corners() {
    let refuse = |value: &str, words: &[&str]| refused("[weld]\n", &format!("[weld]\ncorner = {value}\n"), words);
    for bad in ["0", "-0.2", "nan", "inf", "\"wide\""] {
        refuse(&format!("{{ blend_mm = {bad} }}"), &["weld.corner.blend_mm", "greater than 0"]);
    }
    refuse("{ blend_mm = 0.6 }", &["weld.corner.blend_mm = 0.6", "up to tolerance.path_mm = 0.5"]);
    refuse("{ blend_mm = 1e5 }", &["weld.corner.blend_mm = 1e5", "up to tolerance.path_mm = 0.5"]);
    for bad in ["\"halt\"", "\"blend_mm\"", "0.2", "true"] {
        refuse(bad, &[&format!("weld.corner = {bad}"), "\"refuse\", \"stop\" or { blend_mm = 0.2 }"]);
    }
    refuse("{ blend = 0.2 }", &["weld.corner", "blend_mm"]);
    refuse("{ blend_mm = 0.2, stop = true }", &["weld.corner"]);
    for good in ["\"refuse\"", "\"stop\"", "{ blend_mm = 0.5 }"] {
        let (code, _, written) =
            plan_changed(free_example("saddle"), &[("[weld]\n", &format!("[weld]\ncorner = {good}\n"))]);
        assert!(code == 0 && written, "{good}");
    }
}

#[test]
fn keys_and_units() {
    refused("overlap_mm = 20", "overlap = 20", &["start.overlap", "did you mean `overlap_mm`?"]);
    refused("radius_mm = 250", "radius_inch = 10", &["did you mean `radius_mm`? This value is given in mm"]);
    refused("speed_mm_s = 10", "speed_m_min = 0.6", &["did you mean `speed_mm_s`? This value is given in mm/s"]);
    refused("[torch]", "[torche]", &["did you mean `torch`?"]);
    refused("\"counter-clockwise\"", "\"anticlockwise\"", &["start.direction", "counter-clockwise, clockwise"]);
}

#[test]
fn machines_that_do_not_exist() {
    refused(
        "\"saddle-4axis\"",
        "\"saddle-5axis\"",
        &["machine = \"saddle-5axis\"", "torch-5axis", "path of a machine file"],
    );
}

#[test]
fn mistakes_in_the_machine_file_are_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let job = fs::read_to_string(example("saddle")).unwrap().replace("\"saddle-4axis\"", "\"mine.toml\"");
    fs::write(folder.path().join("job.toml"), job).unwrap();
    let machine = fs::read_to_string(common::root().join("machines/saddle-4axis.toml")).unwrap();
    fs::write(folder.path().join("mine.toml"), machine.replacen("max_speed_deg_s = 30", "max_speed_deg_s = -30", 1))
        .unwrap();
    let text = bad(2, &["check", &folder.path().join("job.toml").display().to_string()]);
    assert!(text.contains("mine.toml:") && text.contains("tool[0].max_speed_deg_s = -30"), "{text}");
}

#[test]
fn files_and_folders() {
    let text = bad(2, &["check", "no/such/job.toml"]);
    assert!(text.contains("no/such/job.toml"), "{text}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, [0xff, 0xfe, 0x00, 0x80]).unwrap();
    let shown = file.display().to_string();
    bad(2, &["check", &shown]);
    // A file where the output folder should be.
    let text = bad(2, &["plan", &example("ellipse"), "-o", &shown]);
    assert!(text.contains(&shown), "{text}");
    assert_eq!(fs::read(&file).unwrap().len(), 4);
    let text = bad(2, &["simulate", &example("ellipse"), "-o", "/proc/seamwright"]);
    assert!(text.contains("/proc/seamwright"), "{text}");
    assert!(!Path::new("/proc/seamwright").exists());
}

#[test]
fn numbers_on_the_command_line() {
    for bad in ["0", "-1", "nan", "inf"] {
        let period = format!("--period-ms={bad}");
        assert_eq!(run(&["tools", "motion", &example("ellipse"), &period]).status.code(), Some(2), "{bad}");
        let every = format!("--every-mm={bad}");
        assert_eq!(run(&["tools", "seam", &example("ellipse"), &every]).status.code(), Some(2), "{bad}");
        let tolerance = format!("--tolerance-mm={bad}");
        let post = ["post", &example("ellipse"), "--dialect", "linuxcnc", &tolerance];
        assert_eq!(run(&post).status.code(), Some(2), "{bad}");
        for flag in ["--a-mm", "--pulse-mm", "--speed-mm-s", "--period-ms"] {
            let argument = format!("{flag}={bad}");
            let interpolate = ["tools", "interpolate", "--curve", "ellipse", "--method", "dda", &argument];
            assert_eq!(run(&interpolate).status.code(), Some(2), "{argument}");
        }
    }
    assert_eq!(run(&["tools", "seam", &example("ellipse"), "--points", "1"]).status.code(), Some(2));
    assert_eq!(run(&["post", &example("ellipse"), "--dialect", "fanuc"]).status.code(), Some(2));
    assert_eq!(run(&["weld", &example("ellipse")]).status.code(), Some(2));
    assert_eq!(run(&["tools", "seam", &example("ellipse"), "--phi-deg", "nan"]).status.code(), Some(2));
    assert_eq!(run(&["--help"]).status.code(), Some(0));
}

#[test]
fn tables_on_standard_input() {
    for (input, words) in [
        ("", "there is no column `x_mm`"),
        ("x_mm,y_mm\n1,2\n", "there is no column `z_mm`"),
        ("x_mm,y_mm,z_mm,ax,ay,az\n1,2,three,0,0,-1\n", "standard input:2: z_mm = `three`: not a finite number"),
        ("x_mm,y_mm,z_mm,ax,ay,az\n1,2\n", "standard input:2: z_mm = ``"),
    ] {
        let output = run_with(&["machine", "kinematics", "ellipse-xy", "--inverse"], input);
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && text.contains(words), "{text}");
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn what_cannot_be_welded_lists_every_finding() {
    let fast = ("speed_mm_s = 10", "speed_mm_s = 200");
    let (code, text, written) = plan(&[fast]);
    assert!(code == 1 && !written, "{text}");
    has_all(
        &text,
        &[
            "finding (speed)",
            "axis theta cannot keep 200",
            "its speed limit of 30.000 °/s",
            "where: pass 1, s = ",
            "cure: ",
        ],
    );
    // Reach and speed are not hidden by each other.
    let low = ("move_mm = [0, 0, -800]", "move_mm = [0, 0, -550]");
    let (code, text, _) = plan(&[fast, low]);
    assert!(code == 1 && text.contains("finding (range)") && text.contains("finding (speed)"), "{text}");
    let (code, text, _) = plan(&[("work_angle_deg = 0", "work_angle_deg = 60")]);
    assert!(code == 1 && text.contains("finding (access)"), "{text}");
    let slow = ("[weld]\n", "[weld]\non_limit = \"slow\"\n");
    let (code, _, written) = plan_changed(free_example("saddle"), &[slow, fast]);
    assert!(code == 0 && written);
}

#[test]
fn axes_that_cannot_be_held() {
    let text = fs::read_to_string(example("oblique-girth")).unwrap();
    let check = |hold: &str| run_on("check", &text.replace("# hold = { u = 90 }", &format!("hold = {{ {hold} }}")));
    assert_eq!(check("u = 88").0, 0);
    for (hold, words) in [
        ("tilt = 90", ["spare_axes.hold.tilt", "there is no axis tilt", "allowed: x, y, z, v, q, u, w"]),
        ("u = 88, v = 0, w = 0", ["spare_axes.hold.u", "with u, v, w held", "allowed: up to 2 axes, or others"]),
        (
            "u = 106",
            [
                "spare_axes.hold.u = 106",
                "axis u would be held at 106°, outside its range",
                "allowed: -15.000° to 105.000°",
            ],
        ),
        ("u = nan", ["spare_axes.hold.u", "nan", "allowed: a finite number"]),
    ] {
        let (code, text, _) = check(hold);
        println!("{text}");
        assert_eq!(code, 2);
        assert!(text.contains("job.toml:31"), "{text}");
        words.iter().for_each(|word| assert!(text.contains(word), "{word} in {text}"));
    }
    // On a machine without redundant axes wishes have no effect, but there is no axis to hold.
    let spare = |table: &str| ("[torch]", format!("[spare_axes]\n{table}\n[torch]"));
    let (from, to) = spare("hold = { s = 1 }");
    refused(from, &to, &["spare_axes.hold.s = 1", "axis s is not redundant: a torch pose determines all axes here"]);
    let (from, to) = spare("position = \"up\"");
    refused(from, &to, &["spare_axes.position", "allowed: flat, any"]);
    let (from, to) = spare("weights = { motion = -1 }");
    refused(from, &to, &["spare_axes.weights.motion = -1"]);
    let (from, to) = spare("weights = { motion = 2 }");
    assert_eq!(run_on("check", &fs::read_to_string(example("saddle")).unwrap().replace(from, &to)).0, 0);
}

#[test]
fn distorted_parts() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bent.toml");
    let out = folder.path().join("out").display().to_string();
    let simulate = |job: &str, text: &str, more: &[&str]| {
        fs::write(&file, text).unwrap();
        let file = file.display().to_string();
        let output = run(&[&["simulate", &example(job), "-o", &out, "--distortion", &file], more].concat());
        (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let bad = [
        ("saddle", "schema = 1\n[[displacement]]\nshfit = {}\n", "shift"),
        ("saddle", "schema = 1\n[[displacement]]\nstep = { at_mm = -5, by = {} }\n", "at_mm"),
        ("ellipse", "schema = 1\n", "no stripe sensor"),
    ];
    for (job, text, words) in bad {
        let (code, told) = simulate(job, text, &[]);
        assert!(code == 2 && told.contains(words) && !Path::new(&out).exists(), "{code} {told}");
    }
    let misplaced = "schema = 1\n[placement]\nshift_mm = [0, 1, 0]\n";
    let (code, told) = simulate("t-joint", misplaced, &["--no-tracking"]);
    assert!(code == 1 && told.contains("deviates"), "{code} {told}");
    let (code, told) = simulate("t-joint", misplaced, &["--no-tracking", "--json", "--seed", "x"]);
    assert!(code == 2 && told.contains("seed"), "{code} {told}");
    common::bad(2, &["simulate", &example("saddle"), "-o", &out, "--distortion", "no-such.toml"]);
}
