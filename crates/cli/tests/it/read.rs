//! `read`: part programs as weld programs, posted back and welded in simulation.

use crate::common::{good, json, json_file, run as seamwright, write};
use serde_json::Value;
use std::fs;

/// A nozzle on a shell, near enough for the arms.
const NOZZLE: &str = include_str!("../../../../tests/data/nozzle-on-arm.toml");

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// EBW-2004, Fig. 1, as printed: it reads, goes along its triangle with its ramps in the printed times, and is written
/// back as it was but for formatting.
#[test]
fn the_electron_beam_welder_s_program_reads_welds_and_comes_back() {
    let dir = tempfile::tempdir().unwrap();
    let program = dir.path().join("fig1.toml");
    let path = program.to_str().unwrap();
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ebw-fig1.mpf");
    let read = seamwright(&["import", example, "--machine", "ebw-7axis", "-o", path]);
    assert!(read.status.success() && text(&read.stderr).contains("46.739 s by its feeds"), "{}", text(&read.stderr));

    let motion = good(&["tools", "motion", path, "--period-ms", "100"]);
    let mut lines = motion.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|n| *n == name).unwrap();
    let [t, pass, z, w, beam, focus] = ["t_s", "pass", "z", "w", "beam_a", "focus_a"].map(column);
    let rows: Vec<Vec<f64>> = lines.map(|l| l.split(',').map(|v| v.parse().unwrap_or(f64::NAN)).collect()).collect();
    let weld: Vec<&Vec<f64>> = rows.iter().filter(|row| (row[pass] - 2.0).abs() < 0.5).collect();
    assert!(weld.len() > 460 && weld.len() < 475, "{}", weld.len());
    // Z over W is a triangle wave of 25 mm about 25 mm; its corners are rounded by the blend.
    let triangle = |w: f64| 25.0 - 25.0 * (2.0 / std::f64::consts::PI) * w.to_radians().sin().asin();
    for row in &weld {
        assert!((row[z] - triangle(row[w])).abs() < 0.15, "{} {}", row[w], row[z]);
    }
    // Blocks take 60 / F seconds, without acceleration and deceleration phases.
    let when = |angle: f64| weld.iter().find(|row| row[w] >= angle).unwrap()[t] - weld[0][t];
    let feeds = [(20.89, 20.0), (90.0, 8.05), (180.0, 4.64), (270.0, 4.64), (339.64, 8.0)];
    let mut expected = 0.0;
    for (angle, feed) in feeds {
        expected += 60.0 / feed;
        assert!((when(angle) - expected).abs() < 0.25, "{angle}: {} {expected}", when(angle));
    }
    // Beam and focus ramp from block end to block end.
    let at = |angle: f64, i: usize| {
        weld.iter().min_by(|a, b| (a[w] - angle).abs().total_cmp(&(b[w] - angle).abs())).unwrap()[i]
    };
    for (angle, value) in
        [(0.0, 0.0), (20.89, 0.2), (55.4, 0.35), (90.0, 0.5), (150.0, 0.5), (225.0, 0.35), (300.0, 0.2)]
    {
        assert!((at(angle, beam) - value).abs() < 0.01, "{angle}: {}", at(angle, beam));
    }
    assert!((at(10.4, focus) - 5.0).abs() < 0.06 && (at(225.0, focus) - 5.5).abs() < 0.03);

    let posted = good(&["post", path, "--dialect", "sinumerik"]);
    let plain = |line: &str| line.replace(' ', "");
    let blocks: Vec<String> = posted.lines().filter(|l| !l.starts_with(';')).map(plain).collect();
    for block in ["M54", "G4F=0,5;before", "PRESETON(CF,4)", "N12G1Z=0W=90CW=0,5F=8,05", "N22G1Z=25W=180F=4,64", "M30"]
    {
        assert!(blocks.iter().any(|b| b == block), "{block}: {posted}");
    }
    assert!(!posted.contains("A_OUT"), "the beam is switched by its current: {posted}");
    let again = write(dir.path(), "again.mpf", &posted);
    let second = good(&["import", &again, "--machine", "ebw-7axis"]);
    let points = |toml: &str| -> Vec<String> {
        toml.lines().filter(|l| l.trim_start().starts_with('[') && l.ends_with("],")).map(str::to_owned).collect()
    };
    let first = points(&fs::read_to_string(&program).unwrap());
    let second = points(&second);
    assert_eq!(first.len(), second.len());
    for (a, b) in first.iter().zip(&second) {
        let numbers = |row: &str| -> Vec<f64> {
            row.trim().trim_matches(|c| "[],".contains(c)).split(", ").map(|v| v.parse().unwrap()).collect()
        };
        assert!(numbers(a).iter().zip(numbers(b)).all(|(x, y)| (x - y).abs() < 1e-6), "{a} {b}");
    }

    let report = dir.path().join("out");
    good(&["simulate", path, "-o", report.to_str().unwrap(), "--appendix"]);
    assert!(fs::read_to_string(report.join("report.html")).unwrap().contains("Process values"));
}

#[test]
fn mistakes_have_line_and_column() {
    let dir = tempfile::tempdir().unwrap();
    let read = |name: &str, program: &str, more: &[&str]| {
        let file = dir.path().join(name);
        fs::write(&file, program).unwrap();
        let mut args = vec!["import", file.to_str().unwrap(), "--machine", "table-tilting-xyzac"];
        args.extend(more);
        let out = seamwright(&args);
        (out.status.code().unwrap(), text(&out.stderr).to_string())
    };
    for (program, place, words) in [
        ("G21\nG93\nG1 X10\n", "a.ngc:3:", "F"),
        ("G21\nG1 X10 F100\nG2 X20 Y0 I3 J0\n", "a.ngc:3:", "circle"),
        ("G21\nG1 X10 F100 ABC\n", "a.ngc:2:", "A"),
        ("G21\nM7\nG1 X10 F100\n", "a.ngc:2:", "M7"),
        ("G21\n", "a.ngc", "moves"),
        ("G1 U5 F10\n", "a.ngc:1:", "U"),
    ] {
        let (code, told) = read("a.ngc", program, &[]);
        assert!(code == 2 && told.contains(place) && told.contains(words), "{program}: {told}");
    }
    let (code, told) = read("a.ngc", "G21\nM7\nG1 X10 F100\n", &["--lenient"]);
    assert!(code == 0 && told.contains("left out") && told.contains(":2:1:"), "{told}");
    for more in [["--blend-mm", "0"], ["--blend-mm", "2"], ["--blend-mm", "nan"]] {
        let (code, told) = read("a.ngc", "G1 X10 F100\n", &more);
        assert!(code == 2 && told.contains("--blend-mm"), "{told}");
    }
    let out = seamwright(&["import", "nowhere.ngc", "--machine", "saddle-4axis"]);
    assert_eq!(out.status.code(), Some(2));
}

/// A weld that was posted for a robot is read back as a program, planned and posted again; faults have their line.
#[test]
fn robot_programs_are_read() {
    for (machine, dialect, file, wrong) in [
        ("irb-2600", "rapid", "weld.mod", ["ArcL ", "ArcX "]),
        ("kr-16", "krl", "weld.src", ["LIN {", "LIM {"]),
        ("arc-mate-120id", "fanuc-ls", "weld.ls", ["L P[", "X P["]),
        ("ur10e", "urscript", "weld.script", ["movep(", "movex("]),
        ("ar1440", "inform", "weld.jbi", ["MOVL ", "MOVX "]),
    ] {
        read_back(machine, dialect, file, wrong);
    }
}

/// Posts a nozzle in `dialect` to `file`, imports it and posts the program that was read. A text with `wrong[1]` in the
/// place of `wrong[0]` is refused with the line.
fn read_back(machine: &str, dialect: &str, file: &str, wrong: [&str; 2]) {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    fs::write(at("job.toml"), NOZZLE.replace("MACHINE", machine)).unwrap();
    good(&["post", &at("job.toml"), "--dialect", dialect, "-o", &at(file)]);
    let read = seamwright(&["import", &at(file), "--machine", machine, "-o", &at("weld.toml"), "--json"]);
    let said = text(&read.stderr);
    assert!(read.status.success() && said.contains(&format!("{dialect} program")), "{said}");
    // A job in INFORM has no frames: its reader can compare none.
    assert_eq!(said.contains("no frames of tool and work"), dialect == "inform", "{said}");
    let summary: Value = serde_json::from_slice(&read.stdout).unwrap();
    let planned = json(&["plan", &at("job.toml"), "--json", "-o", &at("plan")]);
    let welded_s = planned["plan"]["arc_on_s"].as_f64().unwrap();
    assert!((summary["seconds"].as_f64().unwrap() / welded_s - 1.0).abs() < 1e-3, "{summary} {planned}");
    good(&["post", &at("weld.toml"), "--dialect", dialect, "-o", &at("again")]);
    let damaged = fs::read_to_string(at(file)).unwrap().replacen(wrong[0], wrong[1], 1);
    fs::write(at(file), &damaged).unwrap();
    let line = damaged.lines().position(|line| line.contains(wrong[1])).unwrap() + 1;
    let refused = seamwright(&["import", &at(file), "--machine", machine]);
    let said = text(&refused.stderr);
    assert!(refused.status.code() == Some(2) && said.contains(&format!("{file}:{line}:")), "{said}");
    let refused = seamwright(&["import", &at(file), "--machine", machine, "--lenient"]);
    assert_eq!(refused.status.code(), Some(2));
}

/// `--servo-ms`: set-points with the given settings, proven; bad settings are refused with what is allowed.
#[test]
fn urscript_is_posted_as_set_points() {
    let dir = tempfile::tempdir().unwrap();
    let job = write(dir.path(), "job.toml", NOZZLE.replace("MACHINE", "ur10e"));
    let post = |extra: &[&str]| seamwright(&[&["post", &job, "--dialect", "urscript"], extra].concat());
    let out = post(&["--servo-ms", "8", "--lookahead-s", "0.05", "--gain", "500", "--verify"]);
    let said = text(&out.stderr);
    assert!(out.status.success() && said.contains("proven by reading back"), "{said}");
    let script = text(&out.stdout);
    assert!(script.matches("], 0, 0, 0.008, 0.05, 500)\n").count() > 7000 && !script.contains("movep("), "{said}");
    let refused = |extra: &[&str], words: [&str; 2]| {
        let out = post(extra);
        let said = text(&out.stderr);
        assert!(out.status.code() == Some(2) && words.iter().all(|word| said.contains(word)), "{extra:?}: {said}");
    };
    refused(&["--servo-ms", "3"], ["--servo-ms 3", "2 ms to 40 ms in steps of 2 ms"]);
    refused(&["--servo-ms", "42"], ["--servo-ms 42", "2 ms to 40 ms"]);
    refused(&["--servo-ms", "nan"], ["--servo-ms NaN", "2 ms to 40 ms"]);
    refused(&["--servo-ms", "8", "--lookahead-s", "0.3"], ["--lookahead-s 0.3", "0.03"]);
    refused(&["--servo-ms", "8", "--gain", "50"], ["--gain 50", "2000"]);
    refused(&["--gain", "300"], ["--gain 300", "--servo-ms"]);
    let other = seamwright(&["post", &job, "--dialect", "rapid", "--servo-ms", "8"]);
    let said = text(&other.stderr);
    assert!(other.status.code() == Some(2) && said.contains("--servo-ms 8") && said.contains("urscript"), "{said}");
}

/// Posts state their proof; text that the control cannot express is not written.
#[test]
fn posts_say_how_they_were_proven() {
    let dir = tempfile::tempdir().unwrap();
    let (file, proof) = (dir.path().join("saddle.ngc"), dir.path().join("proof.json"));
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/saddle.toml");
    let out = seamwright(&[
        "post",
        example,
        "--dialect",
        "linuxcnc",
        "--verify",
        "-o",
        file.to_str().unwrap(),
        "--proof",
        proof.to_str().unwrap(),
    ]);
    assert!(out.status.success() && text(&out.stderr).contains("proven by reading back"), "{}", text(&out.stderr));
    let written = fs::read_to_string(&file).unwrap();
    assert!(written.contains("(proven by reading back:") && written.contains("(pass 1: tip 0.00"));
    let json = json_file(&proof);
    assert!(json["passes"][0]["tip_mm"].as_f64().unwrap() < 0.0101);
    let refused = seamwright(&["post", example, "--dialect", "linuxcnc", "--interpolation", "pvt"]);
    assert!(refused.status.code() == Some(2) && text(&refused.stderr).contains("PMAC"));
}

/// `plan --post`: the text beside the plan, its proof in the report and on the page; Sinumerik's polynomials read back.
#[test]
fn a_plan_comes_with_its_part_programs() {
    let dir = tempfile::tempdir().unwrap();
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/trunnion-saddle.toml");
    let folder = dir.path().join("plan");
    let at = folder.to_str().unwrap();
    good(&["plan", example, "-o", at, "--post", "sinumerik", "--post", "linuxcnc"]);
    let json = json_file(folder.join("report.json"));
    for (i, file) in ["sinumerik.mpf", "linuxcnc.ngc"].into_iter().enumerate() {
        assert_eq!(json["posts"][i]["file"], file);
        let tip = json["posts"][i]["proof"]["passes"][0]["tip_mm"].as_f64().unwrap();
        assert!(tip > 0.001 && tip < 0.0101, "{tip}");
        assert!(fs::read_to_string(folder.join(file)).unwrap().contains("proven by reading back"));
    }
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains("Part programs") && page.contains("Maximum deviations of sinumerik.mpf"));

    let file = dir.path().join("poly.mpf");
    let path = file.to_str().unwrap();
    // The speed inside long polynomials is uneven: half the blocks of lines need a larger tolerance for it.
    let loose = ["--interpolation", "poly", "--speed-percent", "5"];
    good(&[&["post", example, "--dialect", "sinumerik", "-o", path], &loose[..]].concat());
    let count = |name: &str, word: &str| fs::read_to_string(name).unwrap().matches(word).count();
    let (poly, plain) = (count(path, " POLY "), folder.join("sinumerik.mpf"));
    assert!(poly > 10 && 2 * poly < count(plain.to_str().unwrap(), "F="), "{poly}");
    let back = good(&["import", path, "--machine", "table-tilting-xyzac"]);
    assert!(back.contains("along = \"cubic\""), "{back}");
}

/// Reads a part program for the trunnion machine and posts the result.
fn reposted(text: &str, dialect: &str, edits: &[&[&str]]) -> String {
    let dir = tempfile::tempdir().unwrap();
    let (source, program) = (dir.path().join("a.nc"), dir.path().join("a.toml"));
    fs::write(&source, text).unwrap();
    let (source, program) = (source.to_str().unwrap(), program.to_str().unwrap());
    let from = if text.contains("CIP") || text.contains("$A") { "sinumerik" } else { "linuxcnc" };
    good(&["import", source, "--machine", "table-tilting-xyzac", "--dialect", from, "-o", program]);
    for edit in edits {
        good(&[&["edit", program], *edit].concat());
    }
    good(&["post", program, "--dialect", dialect])
}

/// A pass without the arc that is planned anew, since LinuxCNC has no such arc, keeps the arc off; other outputs are
/// switched on the way.
#[test]
fn a_pass_without_the_arc_never_burns() {
    let dry = "G0 X0 Y0 Z400 A0 C0\nG1 X10 F600\nCIP X20 Y10 Z395 I1=13 J1=7 K1=397\nG1 X30\nM30\n";
    let dry = dry.replace("X10 F600", "X10 F600\n$A_OUT[8]=1\n");
    for dialect in ["linuxcnc", "grblhal", "pmac", "sinumerik"] {
        let text = reposted(&dry, dialect, &[]).replace("arc on 0 s", "");
        assert!(!text.contains("arc on") && !text.contains("gas on"), "{dialect}\n{text}");
    }
    let text = reposted(&dry, "linuxcnc", &[&["add-event", "--pass", "1", "--after", "3", "--message", "halfway"]]);
    assert!(text.contains("P7") && text.contains("halfway"), "{text}");
}

/// Every pass that a control can start again at goes to its start with the arc off, and sets its values.
#[test]
fn passes_start_again_with_the_arc_off() {
    let source = "G0 X0 Y0 Z400 A0 C0\nM68 E0 Q90\nM64 P0\nG1 X20 F600\nX30\nM65 P0\nG0 Z450\nG0 X100\nM64 P0\nG1 X120\nM65 P0\nM68 E0 Q0\nM2\n";
    let text = reposted(source, "linuxcnc", &[]);
    let subs: Vec<&str> = text.split("o10").filter(|part| part.contains(" sub")).collect();
    assert!(subs.len() > 1, "{text}");
    for sub in &subs {
        let at = |words: &str| sub.find(words);
        let Some(burns) = at("M64 P0").or(at("M62 P0")) else { continue };
        assert!(at("M65 P0").is_some_and(|off| off < burns), "{sub}");
        let goes = at("G0 X").or(at("G0 C").or(at("G0 A"))).unwrap_or(usize::MAX);
        assert!(goes < burns, "no way to its start before the arc: {sub}");
        assert!(sub.contains("E0 Q90"), "{sub}");
        assert!(sub.rfind("M68 E0 Q0").is_some_and(|off| off > burns), "{sub}");
    }
}

#[test]
fn rests_with_values_come_back() {
    let source = "G0 X0 Y0 Z400 A0 C0\n$A_OUTA[1]=180\n$A_OUT[1]=1\nG4 F0.3\nG1 X20 F600\n$A_OUT[1]=0\nM30\n";
    for dialect in ["linuxcnc", "grblhal", "pmac", "sinumerik"] {
        let text = reposted(source, dialect, &[]);
        assert!(text.contains("arc on") || dialect == "grblhal", "{text}");
    }
}

#[test]
fn what_cannot_be_stood_back_is_said() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/saddle.toml");
    let out = seamwright(&["post", example, "--dialect", "sinumerik", "--retract-mm", "1000"]);
    assert!(out.status.code() == Some(2) && text(&out.stderr).contains("--retract-mm 1000"), "{}", text(&out.stderr));
    let out = seamwright(&["post", example, "--dialect", "sinumerik", "--tolerance-mm", "1e-9"]);
    assert!(out.status.code() == Some(2) && text(&out.stderr).contains("six decimals"), "{}", text(&out.stderr));
}
