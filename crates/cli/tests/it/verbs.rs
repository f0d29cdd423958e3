//! Every verb from the outside: columns, numbers, files.

use crate::common::{bad, column, example, good, has_all, json, root, run, run_with, table};
use std::fs;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::process::{Command, Stdio};

#[test]
fn seam_has_the_contract_s_columns_and_the_reference_s_values() {
    let csv = good(&["tools", "seam", &example("saddle"), "--phi-deg", "0,90,-30"]);
    let t = table(&csv);
    assert_eq!(t.0.join(","), "s_mm,phi_deg,x_mm,y_mm,z_mm,tx,ty,tz,n1x,n1y,n1z,n2x,n2y,n2z,bx,by,bz,dihedral_deg");
    assert_eq!(column(&t, "phi_deg"), [0.0, 90.0, -30.0]);
    assert!((column(&t, "dihedral_deg")[1] - 108.209_956_864_283_01).abs() < 1e-8);
    assert!((column(&t, "z_mm")[1] - 759.934_207_678_533_2).abs() < 1e-9);
}

#[test]
fn seam_points_are_equally_far_apart() {
    let t = table(&good(&["tools", "seam", &example("ellipse"), "--points", "50"]));
    let s = column(&t, "s_mm");
    assert_eq!(s.len(), 50);
    let step = (s[49] - s[0]) / 49.0;
    assert!(s.windows(2).all(|w| (w[1] - w[0] - step).abs() < 1e-12));
    let t = table(&good(&["tools", "seam", &example("ellipse"), "--every-mm", "10"]));
    assert_eq!(t.1.len(), 13);
    assert!((column(&t, "s_mm")[12] - s[49]).abs() < 1e-12);
}

#[test]
fn json_says_the_same_as_csv() {
    let arguments = ["tools", "seam", &example("ellipse"), "--points", "5"];
    let t = table(&good(&arguments));
    let json = json(&[&arguments[..], &["--json"]].concat());
    let rows = json.as_array().unwrap();
    assert_eq!(rows.len(), 5);
    for (row, csv) in rows.iter().zip(&t.1) {
        for (name, value) in t.0.iter().zip(csv) {
            assert!((row[name].as_f64().unwrap() - value).abs() <= 1e-15 * value.abs());
        }
    }
}

#[test]
fn motion_through_forward_kinematics_keeps_the_speed() {
    for (name, machine, speed) in [
        ("saddle", "saddle-4axis", 10.0),
        ("head-nozzle", "torch-5axis", 6.0),
        ("ellipse", "ellipse-xy", 5.0),
        ("trunnion-saddle", "table-tilting-xyzac", 8.0),
        ("oblique-girth", "ebw-7axis", 10.0),
    ] {
        let csv = good(&["tools", "motion", &example(name), "--period-ms", "20"]);
        let t = table(&csv);
        assert_eq!(t.0[..3], ["t_s", "pass", "s_mm"]);
        let poses = run_with(&["machine", "kinematics", machine, "--forward"], &csv);
        let p = table(&String::from_utf8(poses.stdout).unwrap());
        assert_eq!(p.0.join(","), "x_mm,y_mm,z_mm,ax,ay,az");
        let (s, v) = (column(&t, "s_mm"), column(&t, "speed_mm_s"));
        let length = s[s.len() - 1];
        for i in 1..s.len() {
            if s[i - 1] > 1.0 && s[i] < length - 1.0 {
                let chord = (0..3).map(|k| (p.1[i][k] - p.1[i - 1][k]).powi(2)).sum::<f64>().sqrt();
                // The chord is shorter than the arc by its sagitta's part only.
                assert!((chord / (speed * 0.02) - 1.0).abs() < 1e-5, "{name} row {i}: {chord}");
                assert!((v[i] - speed).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn process_columns_follow_the_arc() {
    let t = table(&good(&["tools", "motion", &example("saddle"), "--period-ms", "100"]));
    let (arc, current) = (column(&t, "arc"), column(&t, "current_a"));
    assert!(arc.iter().zip(&current).all(|(a, c)| (*c - 240.0 * a).abs() < 1e-12));
    assert!(arc[0] < 0.5 && arc[10] > 0.5 && arc[arc.len() - 1] < 0.5);
}

#[test]
fn plan_and_simulate_leave_whole_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("deep/out");
    let shown = out.display().to_string();
    good(&["plan", &example("ellipse"), "-o", &shown]);
    let mut names: Vec<_> =
        fs::read_dir(&out).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    assert_eq!(names, ["program.toml", "report.html", "report.json"]);
    // The program welds as the job does.
    let program = out.join("program.toml").display().to_string();
    let motion = |file: &str| good(&["tools", "motion", file, "--period-ms", "50"]);
    assert_eq!(motion(&program), motion(&example("ellipse")));
    let report = json(&["simulate", &program, "-o", &shown, "--json"]);
    // Length by speed, and the loss of the acceleration and deceleration phases.
    let weld_s = report["plan"]["weld_s"].as_f64().unwrap();
    let cruise_s = report["seam"]["weld_length_mm"].as_f64().unwrap() / 5.0;
    assert!(weld_s > cruise_s + 0.005 && weld_s < cruise_s + 0.2, "{weld_s} {cruise_s}");
    assert!(report["simulation"]["path_error_mm"]["max"].as_f64().unwrap() < 0.05);
    let file = fs::File::open(out.join("trace.parquet")).unwrap();
    let reader = parquet::file::reader::SerializedFileReader::new(file).unwrap();
    let metadata = parquet::file::reader::FileReader::metadata(&reader);
    // From switching on to home: homing and the strike take time beyond the plan.
    let planned_s = report["plan"]["total_s"].as_f64().unwrap();
    let more_s = metadata.file_metadata().num_rows() as f64 * 1e-3 - planned_s;
    assert!((0.5..20.0).contains(&more_s), "{more_s}");
    assert!(metadata.file_metadata().key_value_metadata().unwrap().iter().any(|p| p.key == "unit:tip_speed_mm_s"));
    let html = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(html.starts_with("<!DOCTYPE html>") && html.trim_end().ends_with("</html>"));
    for outside in ["http://", "https://", "<script", "@import", "url("] {
        let found = html.matches(outside).count()
            - html.matches("http://www.w3.org/").count() * usize::from(outside == "http://");
        assert_eq!(found, 0, "the report reaches for {outside}");
    }
}

#[test]
fn the_same_seed_gives_the_same_weld() {
    let folder = tempfile::tempdir().unwrap();
    let weld = |seed: &str, name: &str| {
        let out = folder.path().join(name);
        good(&["simulate", &example("ellipse"), "-o", &out.display().to_string(), "--seed", seed]);
        fs::read(out.join("trace.parquet")).unwrap()
    };
    assert!(weld("3", "a") == weld("3", "b"));
    assert!(weld("3", "a") != weld("4", "c"));
}

#[test]
fn kinematics_come_back() {
    let csv = "a,x,y,z,c\n8,7.1077,33.3687,32.0754,60\n-20,1,2,3,-60\n";
    let poses = run_with(&["machine", "kinematics", "table-tilting-xyzac", "--forward"], csv);
    let back = run_with(
        &["machine", "kinematics", "table-tilting-xyzac", "--inverse"],
        &String::from_utf8(poses.stdout).unwrap(),
    );
    let t = table(&String::from_utf8(back.stdout).unwrap());
    assert_eq!(t.0.join(","), "x,y,z,a,c,error,attitude_error_deg");
    for (row, want) in t.1.iter().zip([[7.1077, 33.3687, 32.0754, 8.0, 60.0], [1.0, 2.0, 3.0, -20.0, -60.0]]) {
        assert!(row.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-9), "{row:?}");
    }
    let far = run_with(
        &["machine", "kinematics", "ellipse-xy", "--inverse"],
        "x_mm,y_mm,z_mm,ax,ay,az\n700,0,0,0,0,-1\n1,2,5,0,0,-1\n",
    );
    let text = String::from_utf8(far.stdout).unwrap();
    assert!(
        text.contains("axis x would be at 700") && text.contains("100.000000 mm beyond its limit 600 mm"),
        "{text}"
    );
    assert!(text.contains("5.0000 mm off"), "{text}");
}

#[test]
fn interpolation_steps_are_what_they_say() {
    let exact = |curve: &str, step: &str| {
        let arguments = ["tools", "interpolate", "--curve", curve, "--step", step, "--full-turn"];
        table(&good(&arguments))
    };
    for (curve, wanted) in [("ellipse", 0.05), ("saddle", 0.2)] {
        let t = exact(curve, "chord");
        let chords = column(&t, "chord_mm");
        assert!(chords[1..chords.len() - 1].iter().all(|c| (c / wanted - 1.0).abs() < 1e-9), "{curve}");
    }
    let summary = table(&good(&["tools", "interpolate", "--curve", "ellipse", "--method", "all", "--summary"]));
    let (low, high) = (column(&summary, "chord_min_percent"), column(&summary, "chord_max_percent"));
    // ELLIPSE-2015 as printed: -20 % to +25 %; polar up to 2.5 %; tangent up to 0.032 %.
    assert!((low[1] + 20.0).abs() < 0.01 && (high[1] - 25.0).abs() < 0.01);
    assert!((high[2] - 2.53).abs() < 0.01 && (low[3] + 0.032).abs() < 0.001);
    assert!((column(&summary, "true_length_mm")[0] - 28.361_667_888_974_5).abs() < 1e-10);
}

#[test]
fn lists_and_copies() {
    for name in ["saddle-4axis", "torch-5axis", "ellipse-xy", "table-tilting-xyzac"] {
        assert!(good(&["machine", "list"]).contains(name));
        let text = good(&["machine", "show", name]);
        assert_eq!(text, fs::read_to_string(root().join("machines").join(format!("{name}.toml"))).unwrap());
    }
    let listed = good(&["examples"]);
    let names: Vec<&str> = listed.lines().skip(1).filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() >= 15 && names.contains(&"saddle"), "{listed}");
    for name in &names {
        assert_eq!(good(&["examples", name]), fs::read_to_string(example(name)).unwrap());
    }
    let checked: Vec<String> = std::iter::once("check".to_owned()).chain(names.iter().map(|n| example(n))).collect();
    good(&checked.iter().map(String::as_str).collect::<Vec<_>>());
}

#[test]
fn posted_programs_say_what_they_are() {
    let text = good(&["post", &example("trunnion-saddle"), "--dialect", "linuxcnc", "--level", "tip"]);
    has_all(&text, &["tip level", "G21 G17 G90", "G93", "M62 P0", "M63 P0", "M67 E0 Q200", "units mm", "M2"]);
    assert!(text.lines().all(|l| l.is_ascii() && l.len() < 256));
    // A looser tolerance needs fewer blocks.
    let blocks = |tolerance: &str| {
        let arguments = ["post", &example("saddle"), "--dialect", "linuxcnc", "--tolerance-mm", tolerance];
        good(&arguments).lines().filter(|l| l.starts_with("G1 ")).count()
    };
    assert!(blocks("0.1") < blocks("0.01") && blocks("0.01") < blocks("0.001"));
}

/// An arm without closed form: the search reports its progress when its time is over.
#[test]
fn a_search_ends_when_its_time_is_over() {
    let job = root().join("tests/data/field-trial/u3.toml").display().to_string();
    let output = run(&["check", &job, "--time-limit", "0.001"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("finding (search): no plan within 0.001 s") && text.contains("--time-limit"), "{text}");
    assert_eq!(run(&["check", &job, "--time-limit", "0"]).status.code(), Some(2));
    assert_eq!(run(&["plan", &job, "-o", "never", "--time-limit", "nan"]).status.code(), Some(2));
    // The option in the operator action exists in every verb that plans a weld.
    for verb in ["simulate", "run"] {
        let said = bad(1, &[verb, &job, "-o", "never", "--time-limit", "0.001"]);
        assert!(said.contains("no plan within 0.001 s") && said.contains("--time-limit"), "{verb}: {said}");
    }
}

#[test]
fn several_jobs_keep_their_exit_code_without_a_reader() {
    for json in [&[][..], &["--json"]] {
        let (reader, writer) = UnixStream::pair().unwrap();
        drop(reader);
        let mut check = Command::new(env!("CARGO_BIN_EXE_seamwright"));
        check.args(["check", "nowhere-1.toml", "nowhere-2.toml"]).args(json);
        let status = check.stdout(OwnedFd::from(writer)).stderr(Stdio::null()).status().unwrap();
        assert_eq!(status.code(), Some(2), "{json:?}");
    }
}

#[test]
fn a_far_point_is_out_of_reach_and_no_axis_of_the_wrist_is_blamed() {
    let far = "x_mm,y_mm,z_mm,ax,ay,az\n1e9,0,0,0,1,-0.3\n";
    let text = String::from_utf8(run_with(&["machine", "kinematics", "torch-5axis", "--inverse"], far).stdout).unwrap();
    assert!(text.contains("out of reach by 99") && text.contains("axis x"), "{text}");
}
