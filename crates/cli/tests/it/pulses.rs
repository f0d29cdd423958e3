//! `seamwright tools pulses`: the value change dump read by a small parser of the format alone, against the set-points of
//! `seamwright tools motion`; the same as CSV; refusals.

use crate::common::{bad, column, example, good, has_all, json, part_of, root, run, run_with, table};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A value change dump: names of wires as `scope.wire`, and changes as (time in ns, wire, value).
struct Dump {
    wires: Vec<String>,
    initial: Vec<bool>,
    changes: Vec<(u64, usize, bool)>,
    end: u64,
}

/// Reads a dump of one-bit wires with a time unit of 1 ns (IEEE 1364, clause 18), strictly.
fn parse(text: &str) -> Dump {
    let (head, body) = text.split_once("$enddefinitions $end").unwrap();
    let mut words = head.split_whitespace();
    let (mut scopes, mut codes, mut wires, mut timescale) = (Vec::new(), BTreeMap::new(), Vec::new(), String::new());
    while let Some(section) = words.next() {
        let content: Vec<&str> = words.by_ref().take_while(|w| *w != "$end").collect();
        match section {
            "$scope" => scopes.push(content[1]),
            "$upscope" => assert!(scopes.pop().is_some()),
            "$timescale" => timescale = content.concat(),
            "$var" => {
                assert_eq!((content[0], content[1], content.len()), ("wire", "1", 4));
                assert!(codes.insert(content[2].to_owned(), wires.len()).is_none(), "a code twice");
                wires.push(format!("{}.{}", scopes.join("."), content[3]));
            }
            "$version" | "$comment" | "$date" => {}
            other => panic!("{other}"),
        }
    }
    assert!(scopes.is_empty() && timescale == "1ns");
    let mut dump = Dump { initial: vec![false; wires.len()], wires, changes: Vec::new(), end: 0 };
    let mut now: Option<u64> = None;
    let mut dumping = false;
    let mut dumped = 0;
    for line in body.lines().filter(|l| !l.is_empty()) {
        if let Some(time) = line.strip_prefix('#') {
            let time: u64 = time.parse().unwrap();
            assert!(now.is_none_or(|n| time > n), "time goes back at {line}");
            now = Some(time);
        } else if line.starts_with('$') {
            assert!(line == "$dumpvars" || line == "$end");
            dumping = line == "$dumpvars";
        } else {
            let wire = codes[&line[1..]];
            let value = &line[..1] == "1";
            assert!(value || &line[..1] == "0");
            if dumping {
                dump.initial[wire] = value;
                dumped += 1;
            } else {
                dump.changes.push((now.unwrap(), wire, value));
            }
        }
    }
    assert_eq!(dumped, dump.wires.len());
    dump.end = now.unwrap();
    dump
}

/// A sixth of the seam of the example head-nozzle: all five axes of its machine move.
fn part_of_nozzle(folder: &Path) -> String {
    part_of(folder, "head-nozzle", "overlap_mm = 15", "end_phi_deg = 150")
}

#[test]
fn the_dump_counts_to_every_set_point() {
    let folder = tempfile::tempdir().unwrap();
    let job = part_of_nozzle(folder.path());
    let file = folder.path().join("weld.vcd");
    let shown = file.display().to_string();
    let summary = json(&["tools", "pulses", &job, "--period-ms", "4", "--air", "--json", "-o", &shown]);
    let dump = parse(&fs::read_to_string(&file).unwrap());
    let motion = table(&good(&["tools", "motion", &job, "--period-ms", "4", "--air"]));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "job and dump");
    for axis in summary["axes"].as_array().unwrap() {
        let name = axis["axis"].as_str().unwrap();
        let number = |key: &str| axis[key].as_f64().unwrap();
        let wire = |what: &str| dump.wires.iter().position(|w| *w == format!("{name}.{what}")).unwrap();
        let (step, direction) = (wire("step"), wire("direction"));
        let positions = column(&motion, name);
        assert_eq!(dump.end, 4_000_000 * (positions.len() as u64 - 1));
        let mut changes = dump.changes.iter().filter(|c| c.1 == step || c.1 == direction).peekable();
        let (mut up, mut high) = (dump.initial[direction], dump.initial[step]);
        let (mut count, mut pulses) = (number("start_steps") as i64, 0u64);
        let (mut rise, mut fall, mut turn) = (-1e9, -1e9, -1e9);
        assert!(!high && count == (positions[0] * number("steps_per_unit") + 0.5).floor() as i64);
        for (k, position) in positions.iter().enumerate() {
            let end = 4_000_000 * k as u64;
            while let Some((time, wire, value)) = changes.next_if(|c| c.0 < end) {
                let t = *time as f64;
                if *wire == direction {
                    assert!(up != *value && !high && t - fall >= 5000.0);
                    (up, turn) = (*value, t);
                } else if *value {
                    assert!(!high && t - rise >= 5000.0 && t - fall >= 2500.0 && t - turn >= 5000.0);
                    (high, rise, pulses) = (true, t, pulses + 1);
                    count += if up { 1 } else { -1 };
                } else {
                    assert!(high && t - rise >= 2500.0);
                    (high, fall) = (false, t);
                }
            }
            let off = count as f64 - position * number("steps_per_unit");
            assert!(off.abs() <= 0.5 + 1e-6, "{name} {k}: {off}");
        }
        assert!(changes.next().is_none() && !high);
        assert_eq!((count, pulses), (number("end_steps") as i64, number("pulses") as u64));
        assert!(pulses > 50_000 && number("highest_hz") > 100.0 && number("highest_hz") < number("allowed_hz"));
        assert!(number("resolution") <= number("resolution_wanted"));
    }
}

#[test]
fn rows_say_the_same_as_the_summary() {
    let folder = tempfile::tempdir().unwrap();
    let job = part_of_nozzle(folder.path());
    let summary = json(&["tools", "pulses", &job, "--period-ms", "10", "--json"]);
    let csv = good(&["tools", "pulses", &job, "--period-ms", "10"]);
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("t_s,axis,event,direction,steps"));
    let mut state: BTreeMap<String, (i64, i64, u64)> = BTreeMap::new();
    for axis in summary["axes"].as_array().unwrap() {
        let start = axis["start_steps"].as_i64().unwrap();
        state.insert(axis["axis"].as_str().unwrap().to_owned(), (start, 0, 0));
    }
    let mut last = 0.0;
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let (t, sign, steps): (f64, i64, i64) =
            (cells[0].parse().unwrap(), cells[3].parse().unwrap(), cells[4].parse().unwrap());
        assert!(t >= last);
        last = t;
        let (count, direction, pulses) = state.get_mut(cells[1]).unwrap();
        match cells[2] {
            "direction" => {
                assert!(*direction == -sign || *direction == 0);
                *direction = sign;
            }
            "step" => (*count, *pulses) = (*count + *direction, *pulses + 1),
            other => panic!("{other}"),
        }
        assert!(*count == steps && *direction == sign, "{line}");
    }
    for axis in summary["axes"].as_array().unwrap() {
        let (count, _, pulses) = state[axis["axis"].as_str().unwrap()];
        assert_eq!((Some(count), Some(pulses)), (axis["end_steps"].as_i64(), axis["pulses"].as_u64()));
    }
}

/// A job that is planned quickly, on a machine with steppers, with changes: exit code, errors, and whether the dump was
/// written.
fn changed(changes: &[(&str, &str)], arguments: &[&str]) -> (i32, String, bool) {
    let folder = tempfile::tempdir().unwrap();
    let job = fs::read_to_string(example("ellipse")).unwrap().replace("\"ellipse-xy\"", "\"mine.toml\"");
    let torch = fs::read_to_string(root().join("machines/torch-5axis.toml")).unwrap();
    let stepper = torch.split_once("[drives.x.stepper]").unwrap().1.split("\n[").next().unwrap();
    let mut machine = fs::read_to_string(root().join("machines/ellipse-xy.toml")).unwrap();
    for axis in ["x", "y"] {
        machine.push_str(&format!("[drives.{axis}.stepper]{stepper}\n"));
    }
    for (from, to) in changes {
        assert!(machine.contains(from), "{from}");
        machine = machine.replace(from, to);
    }
    fs::write(folder.path().join("job.toml"), job).unwrap();
    fs::write(folder.path().join("mine.toml"), machine).unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let output =
        run(&[&["tools", "pulses", &path("job.toml"), "--period-ms", "20", "-o", &path("weld.vcd")], arguments]
            .concat());
    let text = [output.stdout, output.stderr].map(|b| String::from_utf8(b).unwrap()).concat();
    println!("{text}");
    (output.status.code().unwrap(), text, Path::new(&path("weld.vcd")).exists())
}

#[test]
fn microsteps_are_chosen_and_explained() {
    let (code, text, written) = changed(&[("resolution_mm = 0.005", "resolution_mm = 0.05")], &[]);
    assert!(code == 0 && written && text.contains("y: 1 microsteps by resolution"), "{text}");
    // 20 full steps per mm and 5 mm/s: 100 Hz for each microstep.
    let (code, text, written) = changed(&[("max_pulse_hz = 200000", "max_pulse_hz = 1000")], &[]);
    assert!(code == 0 && written && text.contains("x: 8 microsteps by frequency"), "{text}");
    assert!(
        text.contains("note: axis x moves 0.006") && text.contains("with 8 microsteps, 0.005 mm is wanted"),
        "{text}"
    );
    let (code, text, _) = changed(&[("8, 16, 32, 64, 128]", "8]")], &[]);
    assert!(code == 0 && text.contains("x: 8 microsteps by driver") && text.contains("no finer setting"), "{text}");
}

#[test]
fn too_many_pulses_are_found_before_anything_is_written() {
    let (code, text, written) = changed(&[("max_pulse_hz = 200000", "max_pulse_hz = 50")], &[]);
    assert!(code == 1 && !written, "{text}");
    has_all(
        &text,
        &["axis ", " at t = ", "pulses a second", "50 is the maximum", "cure: ", "max_pulse_hz", "pass 1, s = "],
    );
}

#[test]
fn weak_motors_lose_steps() {
    let strong = "torque_n_m = [8.5, 7.6, 6.8, 4.6, 3.1, 2.2]";
    let weak = "torque_n_m = [0.3, 0.3, 0.3, 0.3, 0.3, 0.3]";
    let (code, text, written) = changed(&[(strong, weak)], &["--motors"]);
    assert!(code == 1 && written && text.contains("full steps, from t = "), "{text}");
    let (code, text, _) = changed(&[], &["--motors"]);
    assert!(code == 0 && text.matches("motor loses 0 full steps").count() == 2, "{text}");
}

#[test]
fn bad_input() {
    let job = example("head-nozzle");
    let refused = |arguments: &[&str], word: &str| {
        let output = run(&[&["tools", "pulses", &job], arguments].concat());
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty() && text.contains(word), "{text}");
    };
    for bad in ["0", "-1", "nan", "1e-9", "0.00015", "1e300"] {
        refused(&[&format!("--period-ms={bad}")], "allowed");
    }
    for bad in ["0", "-1", "1.5", "1000001", "x"] {
        refused(&[&format!("--tick-ns={bad}")], "--tick-ns");
    }
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    refused(&["-o", &path("pulses.txt")], "ends in .vcd");
    refused(&["-o", &path("pulses")], "ends in .vcd");
    refused(&["-o", &path("none/pulses.vcd")], "there is no such folder");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    let text = bad(2, &["tools", "pulses", &example("saddle")]);
    assert!(text.contains("saddle.toml:") && text.contains("stepper"), "{text}");
}

/// `run` on drives by pulses, as in docs/reference/machine.md: the pulses are in the file, within the driver's times, and all
/// step lines end low.
#[test]
fn a_cell_whose_drives_are_pulses() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let machine =
        format!("{}\n[devices.drives.steps]\nstream = \"pulses.vcd\"\n", good(&["machine", "show", "torch-5axis"]));
    fs::write(at("stepped.toml"), machine).unwrap();
    let job = fs::read_to_string(example("head-nozzle")).unwrap();
    let named = job.replace("machine = \"torch-5axis\"", "machine = \"stepped.toml\"");
    assert_ne!(job, named);
    fs::write(at("job.toml"), named).unwrap();
    let arguments = ["run", &at("job.toml").display().to_string(), "-o", &at("out").display().to_string()];
    let output = run_with(&arguments, "on\nhome\nwait ready\ndry\nwait 2 s\nstop\nwait ready\n");
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let dump = parse(&fs::read_to_string(at("pulses.vcd")).unwrap());
    assert_eq!(dump.wires.len(), 10);
    let mut last = vec![(0u64, false); dump.wires.len()];
    let mut pulses = 0;
    for (t, wire, value) in &dump.changes {
        let (before, was) = std::mem::replace(&mut last[*wire], (*t, *value));
        assert!(was != *value || before == 0, "{}", dump.wires[*wire]);
        assert!(before == 0 || t - before >= 2500, "{} at {t}", dump.wires[*wire]);
        pulses += u32::from(*value && dump.wires[*wire].ends_with("step"));
    }
    assert!(pulses > 1000, "{pulses}");
    let high = dump.wires.iter().zip(&last).find(|(name, (_, value))| name.ends_with("step") && *value);
    assert_eq!(high, None);
    // A stream that fails to start ends the run before anything moves.
    fs::remove_file(at("pulses.vcd")).unwrap();
    fs::create_dir(at("pulses.vcd")).unwrap();
    let refused = run_with(&arguments, "on\n");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(2) && said.contains("pulses.vcd"), "{said}");
}
