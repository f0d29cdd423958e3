//! `seamwright tools motion --commands`: the run under an operator's commands, and files that are refused.

use crate::common::{bad, column, example, good, run, table, write};
use std::process::Output;

fn commanded(job: &str, commands: &str, more: &[&str]) -> Output {
    let (_folder, file) = file_of(commands);
    run(&[&["tools", "motion", &example(job), "--period-ms", "4", "--commands", &file], more].concat())
}

type Table = (Vec<String>, Vec<Vec<f64>>);

/// Its table, the column of phases, and the text on standard error.
fn ran(job: &str, commands: &str) -> (Table, Vec<String>, String) {
    let output = commanded(job, commands, &[]);
    let (text, note) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(0), "{note}");
    let run = table(&text);
    let phase = run.0.iter().position(|c| c == "phase").unwrap();
    let phases = text.lines().skip(1).map(|l| l.split(',').nth(phase).unwrap().to_owned()).collect();
    (run, phases, note)
}

const AXES: [&str; 4] = ["theta", "s", "h", "beta"];

#[test]
fn without_commands_it_is_the_motion() {
    let (run, phases, note) = ran("saddle", "t_s,command,value\n");
    let plain = table(&good(&["tools", "motion", &example("saddle"), "--period-ms", "4"]));
    // The override rises to 1 within 16 periods, while the speed profile itself has hardly started.
    let (rows, of_plain) = (run.1.len(), plain.1.len());
    assert!(rows >= of_plain && rows <= of_plain + 16, "{rows} {of_plain}");
    for name in AXES.iter().chain(&["s_mm"]) {
        let (a, b) = (column(&run, name), column(&plain, name));
        assert!((a[0] - b[0]).abs() < 1e-9 && (a[a.len() - 1] - b[b.len() - 1]).abs() < 1e-9, "{name}");
    }
    assert!(phases.first().unwrap() == "preflow" && phases.last().unwrap() == "ended" && note.is_empty(), "{note}");
}

#[test]
fn commands_do_what_they_say() {
    let commands = "command,t_s,value\noverride,8,60\nhold,12,\nresume,20,\nreverse,25,\nhold,31,\nstep,32,12\n\
                    override,40,150\nresume,45,\noverride,60,100\n";
    let (run, phases, _) = ran("saddle", commands);
    let [t, s, speed, arc] = ["t_s", "s_mm", "speed_mm_s", "arc"].map(|c| column(&run, c));
    let at = |time: f64| t.iter().position(|t| *t >= time - 1e-9).unwrap();
    for (time, wanted, phase) in [
        (7.9, 10.0, "travel"),
        (11.9, 6.0, "travel"),
        (19.0, 0.0, "held"),
        (24.9, 6.0, "travel"),
        (30.0, -6.0, "move"),
        (31.9, 0.0, "held"),
        (44.9, 0.0, "held"),
        (59.9, 15.0, "travel"),
        (70.0, 10.0, "travel"),
    ] {
        let k = at(time);
        assert!((speed[k] - wanted).abs() < 1e-6 && phases[k] == phase, "{time}: {} {}", speed[k], phases[k]);
    }
    // The bead grows by exactly 12 mm.
    let welded = (0..at(32.0)).filter(|k| phases[*k] == "travel").map(|k| s[k + 1]).fold(0.0, f64::max);
    assert!((s[at(44.9)] - welded - 12.0).abs() < 1e-9, "{} {welded}", s[at(44.9)]);
    // The arc rests only where it is meant to; process values follow it.
    let current = column(&run, "current_a");
    for k in 0..t.len() {
        let on = ["travel_delay", "travel", "crater"].contains(&phases[k].as_str());
        assert!((arc[k] > 0.5) == on && (current[k] > 0.0) == on, "{} s: {}", t[k], phases[k]);
        assert!(speed[k].abs() < 1e-12 || ["travel", "move"].contains(&phases[k].as_str()), "{} s", t[k]);
    }
    // Speeds are those of the set-points, and the end is that without commands.
    let period = 0.004;
    for k in 1..t.len() {
        let mean = (s[k] - s[k - 1]) / period;
        assert!((mean - 0.5 * (speed[k] + speed[k - 1])).abs() < 0.05, "{} s: {mean} {}", t[k], speed[k]);
    }
    let plain = table(&good(&["tools", "motion", &example("saddle"), "--period-ms", "4"]));
    for name in AXES.iter().chain(&["s_mm"]) {
        let (a, b) = (column(&run, name), column(&plain, name));
        assert!((a[a.len() - 1] - b[b.len() - 1]).abs() < 1e-9, "{name}");
    }
}

#[test]
fn it_ends_where_nothing_follows() {
    let (run, phases, note) = ran("ellipse", "t_s,command,value\n4,hold,\n");
    assert!(phases.last().unwrap() == "held" && note.contains("note (held): pass 1 waits at s = "), "{note}");
    assert!(column(&run, "t_s").last().unwrap() < &30.0);
    let (run, phases, note) = ran("ellipse", "t_s,command,value\n4,abort,\n60,resume,\n");
    assert!(phases.last().unwrap() == "ended" && note.is_empty(), "{note}");
    assert!(column(&run, "t_s").last().unwrap() < &30.0);
    // At an override of 0 from the start it waits for the command to go on.
    let (_, phases, _) = ran("ellipse", "t_s,command,value\n0,override,0\n3,override,100\n5,resume,\n");
    assert!(phases[..1200].iter().all(|p| p != "travel") && phases.last().unwrap() == "ended");
    // Transfer moves go on; JSON has the same rows.
    let output = commanded("ellipse", "t_s,command,value\n0.1,hold,\n6,resume,\n", &["--air", "--json"]);
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let phases: Vec<&str> = rows.as_array().unwrap().iter().map(|r| r["phase"].as_str().unwrap()).collect();
    let mut order = phases.clone();
    order.dedup();
    assert_eq!((order[..2].to_vec(), *order.last().unwrap()), (vec!["air", "held"], "air"));
}

#[test]
fn bad_files_are_refused_before_anything_is_written() {
    for (rows, words) in [
        ("t_s,command\n1,hold\n", "commands.csv:1: there is no column `value`"),
        ("", "commands.csv:1: there is no column `t_s`"),
        (
            "t_s,command,value\n1,hold,\n2,wait,\n",
            "commands.csv:3: command = `wait`: not a command\n   allowed: override,",
        ),
        ("t_s,command,value\n1,Hold,\n", "commands.csv:2: command = `Hold`: not a command"),
        (
            "t_s,command,value\n1,override,151\n",
            "commands.csv:2: value = `151`: does not go with override\n   allowed: 0 to 150",
        ),
        ("t_s,command,value\n1,override,-1\n", "value = `-1`"),
        ("t_s,command,value\n1,override,nan\n", "value = `nan`"),
        ("t_s,command,value\n1,override\n", "value = ``"),
        ("t_s,command,value\n1,step,0\n", "value = `0`: does not go with step"),
        ("t_s,command,value\n1,hold,5\n", "value = `5`: does not go with hold\n   allowed: nothing"),
        ("t_s,command,value\n\n5,hold,\n4,resume,\n", "commands.csv:4: t_s = `4`: not allowed"),
        ("t_s,command,value\nsoon,hold,\n", "commands.csv:2: t_s = `soon`"),
        ("t_s,command,value\n-1,hold,\n", "t_s = `-1`"),
        ("t_s,command,value\n1,override,0\n2,resume,\n", "commands.csv:3: command = `resume`: cannot go on"),
    ] {
        let output = commanded("ellipse", rows, &[]);
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{rows}: {text}");
        assert!(text.contains(words) && text.contains("allowed"), "{rows}: {text}");
    }
    let job = example("ellipse");
    let text = bad(2, &["tools", "motion", &job, "--commands", "no-such-file.csv"]);
    assert!(text.contains("no-such-file.csv: cannot be read"), "{text}");
    let output = commanded("ellipse", "t_s,command,value\n", &["--coarse-ms", "8"]);
    assert_eq!(output.status.code(), Some(2));
    let file = file_of("t_s,command,value\n");
    let text = run(&["tools", "motion", &job, "--commands", &file.1, "--period-ms", "5"]);
    assert!(String::from_utf8(text.stderr).unwrap().contains("allowed: 0.25 to 4"));
}

fn file_of(commands: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = write(folder.path(), "commands.csv", commands);
    (folder, file)
}

#[test]
fn the_certificate_is_written_too_and_no_command_comes_after_a_day() {
    let folder = tempfile::tempdir().unwrap();
    let hold = write(folder.path(), "hold.csv", "t_s,command,value\n2,hold,\n");
    let late = write(folder.path(), "late.csv", "t_s,command,value\n0.5,hold,\n1e300,resume,\n");
    let (job, certificate) = (example("ellipse"), folder.path().join("certificate.json").display().to_string());
    good(&["tools", "motion", &job, "--commands", &hold, "--certificate", &certificate]);
    assert!(std::fs::read_to_string(&certificate).unwrap().contains("at_asked_percent"));
    let output = run(&["tools", "motion", &job, "--commands", &late]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{told}");
    assert!(told.contains("late.csv:3") && told.contains("0.5 to 86400"), "{told}");
}
