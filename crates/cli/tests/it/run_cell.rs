//! `run` in real time, `simulate --fault` in virtual time, `latency`.

use crate::common::{bad, beside_home, example, good, json, root, run, run_with, start, write};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use serde_json::Value;
use std::io::{BufRead as _, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};

fn json_file(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn events(folder: &Path) -> Vec<Value> {
    let text = std::fs::read_to_string(folder.join("events.jsonl")).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// An arc that goes out: off in the next cycle, held, given up, the position reported; the trace shows all of it.
#[test]
fn a_lost_arc_in_virtual_time() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    let job = example("ellipse");
    let message = bad(3, &["simulate", &job, "-o", &out, "--fault", "source:wrong@12+0.3"]);
    assert!(message.contains("arc or beam lost"), "{message}");
    let out = Path::new(&out);
    let summary = json_file(&out.join("run.json"));
    let left = summary["left"]["welded_mm"].as_f64().unwrap();
    assert!(left > 10.0 && summary["left"]["pass"] == 1, "{summary}");
    let events = events(out);
    let alarm = events.iter().find(|e| e["event"] == "alarm").unwrap();
    assert!(alarm["first_out"] == true && (alarm["t_s"].as_f64().unwrap() - 12.02).abs() < 0.01, "{alarm}");
    assert!(alarm["cause"].is_string() && alarm["action"].is_string() && alarm["consequence"].is_string());
    let modes: Vec<&str> = events.iter().filter(|e| e["event"] == "mode").map(|e| e["to"].as_str().unwrap()).collect();
    assert_eq!(modes, ["idle", "homing", "ready", "weld", "hold", "ready", "off"]);

    let reader = SerializedFileReader::new(std::fs::File::open(out.join("trace.parquet")).unwrap()).unwrap();
    let names: Vec<String> =
        reader.metadata().file_metadata().schema_descr().columns().iter().map(|c| c.name().to_owned()).collect();
    let column = |name: &str| names.iter().position(|n| n == name).unwrap();
    let (t, arc, s) = (column("t_s"), column("arc"), column("s_mm"));
    let rows: Vec<(f64, f64, f64)> = reader
        .get_row_iter(None)
        .unwrap()
        .map(|row| row.unwrap())
        .map(|row| (row.get_double(t).unwrap(), f64::from(row.get_ubyte(arc).unwrap()), row.get_double(s).unwrap()))
        .collect();
    assert!(rows.windows(2).all(|w| (w[1].0 - w[0].0 - 1e-3).abs() < 1e-9));
    assert!(rows.iter().filter(|r| r.0 > 12.0225).all(|r| r.1 < 0.5));
    assert!(rows.iter().any(|r| r.1 > 0.5 && r.2 > 10.0));
}

#[test]
fn a_fault_that_comes_too_late_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let output = run(&["simulate", &example("ellipse"), "-o", &out, "--fault", "inputs:silent@100", "--json"]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && told.contains("never came"), "{told}");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.lines().all(|line| serde_json::from_str::<Value>(line).is_ok()));
    assert!(text.contains("\"pass\""));
}

/// While the joint is looked for before a tracked weld, corrected set-points are not exactly at rest: the power was never
/// switched off, and neither `simulate` nor `run` ended.
#[test]
fn a_fault_in_the_search_before_a_tracked_weld_switches_the_power_off() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let distortion = root().join("examples/distortions/misplaced.toml").display().to_string();
    let tracked = ["simulate", &example("first-weld"), "-o", &out, "--distortion", &distortion];
    let output = run(&[&tracked[..], &["--fault", "inputs:silent@20+1"]].concat());
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(matches!(output.status.code(), Some(1 | 3)), "{errors}");
    let events = std::fs::read_to_string(folder.path().join("events.jsonl")).unwrap();
    assert!(events.contains("inputs silent"), "{events}");
}

/// In real time: orders are taken in their turn, refusals have a reason, the timing is in the summary.
#[test]
fn orders_in_real_time() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let job = example("ellipse");
    let output =
        run_with(&["run", &job, "-o", &out], "# up\non\nhome\nwait ready\ndry\n?\nwait 0.3 s\nhold\nresume\nstop\n");
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert_eq!(text.lines().filter(|line| line.contains("state")).count(), 1, "a question is asked once: {text}");
    let summary = json_file(&folder.path().join("run.json"));
    assert!(summary["timing"]["cycles"].as_u64().unwrap() > 800, "{summary}");
    assert_eq!(summary["mode"], "off");

    let output = run_with(&["run", &job, "-o", &out], "on\nhome\nwait ready\nweld\n");
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("not armed"), "{text}");
    let output = run_with(&["run", &job, "-o", &out], "go\n");
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().contains("allowed are on, off, home"));
}

#[test]
fn what_cannot_be() {
    let job = example("ellipse");
    assert!(bad(2, &["simulate", &job, "-o", "x", "--fault", "doors:open@1"]).contains("drives, source, inputs"));
    assert!(bad(2, &["simulate", &job, "-o", "x", "--fault", "drives:silent"]).contains("DEVICE:KIND@TIME"));
    assert!(bad(2, &["run", "missing.toml", "-o", "x"]).contains("missing.toml"));
    assert!(bad(2, &["run", &job]).contains("--output"));
    assert!(bad(2, &["machine", "latency", "--period-ms", "0.1"]).contains("0.25 to 4"));
    assert!(bad(2, &["machine", "latency", "--seconds=-1"]).contains("seconds"));
}

#[test]
fn latency_is_measured() {
    let told = json(&["machine", "latency", "--seconds", "0.5", "--json"]);
    let counted = told["cycles"].as_u64().unwrap() + told["missed"].as_u64().unwrap();
    assert!((500..=501).contains(&counted) || told["missed"].as_u64().unwrap() > 0, "{told}");
    let sum: u64 = told["histogram"].as_array().unwrap().iter().map(|b| b["cycles"].as_u64().unwrap()).sum();
    assert_eq!(sum, told["cycles"].as_u64().unwrap());
    assert!(good(&["machine", "latency", "--seconds", "0.2"]).contains("begin at most"));
}

/// The power fails in a weld: its position is known to a millimetre, and the weld continues only from a position given
/// by the operator.
#[test]
fn a_weld_survives_the_power() {
    let folder = tempfile::tempdir().unwrap();
    let (data, out) = (folder.path().join("data"), folder.path().join("out"));
    let [data, out] = [&data, &out].map(|path| path.display().to_string());
    // It continues 2 mm before the position up to which it is welded.
    let text = beside_home().replacen("[sequence]", "[sequence]\noverlap_mm = 2", 1);
    let job = write(folder.path(), "ellipse.toml", text);
    let mut child = start(&["run", &job, "-o", &out, "--data", &data, "--part", "P1", "--from", "1,112"]);
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(b"on\nhome\nwait ready\narm\nweld\nwait 113.5 mm\n?\n").unwrap();
    let lines = std::io::BufReader::new(child.stdout.take().unwrap()).lines().map_while(Result::ok);
    let here = lines.into_iter().find(|line| line.contains("state")).unwrap();
    // kill -9
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(here.contains("mode weld"), "{here}");

    let told = bad(2, &["run", &job, "-o", &out, "--data", &data, "--part", "P1"]);
    let place = told.split("--from 1,").nth(1).and_then(|rest| rest.split(';').next()).unwrap();
    let welded: f64 = place.parse().unwrap();
    assert!((welded - 113.5).abs() < 1.0 && told.contains("weld 1 was left"), "{told}");
    good(&["records", "recover", "--data", &data]);
    let listed = good(&["records", "list", "--data", &data]);
    assert!(listed.contains("interrupted"), "{listed}");

    // No weld is left after the position, or the pass is missing.
    assert!(bad(2, &["run", &job, "-o", &out, "--from", "1,500"]).contains("up to 118.4"));
    assert!(bad(2, &["run", &job, "-o", &out, "--from", "3,5"]).contains("passes 1 to 1"));
    assert!(bad(2, &["run", &job, "-o", &out, "--from", "somewhere"]).contains("PASS,MM"));

    let from = format!("1,{place}");
    let orders = "on\nhome\nwait ready\narm\nweld\nwait ready\n";
    let output = run_with(&["run", &job, "-o", &out, "--data", &data, "--part", "P1", "--from", &from], orders);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{text}\n{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.contains("pass 1 ends at 118.4"), "{text}");
    let listed = json(&["records", "list", "--data", &data, "--json"]);
    let results: Vec<&str> = listed.as_array().unwrap().iter().map(|w| w["result"].as_str().unwrap()).collect();
    assert!(results.contains(&"good") && results.contains(&"interrupted"), "{listed}");
    let note = |result: &str| {
        let weld = listed.as_array().unwrap().iter().find(|w| w["result"] == result).unwrap();
        let shown = good(&["records", "show", &weld["id"].to_string(), "--data", &data]);
        shown.lines().find(|line| line.trim_start().starts_with("note")).unwrap_or_default().to_owned()
    };
    let [left, ended] = ["interrupted", "good"].map(note);
    assert!(left.contains("goes on in pass 1 from 110.00 mm; recovered"), "{left}");
    assert!(ended.ends_with(&format!("goes on in pass 1 from {:.2} mm", welded - 2.0)), "{ended}");
    good(&["records", "verify", "--data", &data]);
}

/// A trace that cannot grow any more, by the system's limit of a file's size: the weld goes on, and an alarm reports
/// it. The position is still recorded, and the record ends in order, with the rows written and the number lost.
#[cfg(unix)]
#[test]
fn a_trace_that_cannot_grow_is_told_and_kept() {
    let folder = tempfile::tempdir().unwrap();
    let [data, out] = ["data", "out"].map(|name| folder.path().join(name).display().to_string());
    let job = write(folder.path(), "job.toml", beside_home());
    // Blocks of 512 bytes: some seconds of rows, and the library.
    let limited = format!(
        "trap '' XFSZ; ulimit -f 1000; exec '{}' run '{job}' -o '{out}' --data '{data}' --part P",
        env!("CARGO_BIN_EXE_seamwright")
    );
    let mut child = Command::new("sh")
        .args(["-c", &limited])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(b"on\nhome\nwait ready\narm\nweld\nwait 10 s\nstop\n").unwrap();
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(3) && said.contains("trace.raw"), "{said}");
    assert!(said.contains("record failing") && said.contains("weld -> ready"), "{said}");
    let listed = json(&["records", "list", "--data", &data, "--json"]);
    assert_eq!(listed[0]["result"], "stopped", "{listed}");
    let shown = good(&["records", "show", "1", "--data", &data, "--json"]);
    assert!(shown.contains("rows of the trace lost"), "{shown}");
    let shown: Value = serde_json::from_str(&shown).unwrap();
    let events: Vec<&str> = shown["events"].as_array().unwrap().iter().map(|e| e["text"].as_str().unwrap()).collect();
    assert!(events.contains(&"ready -> weld") && events.contains(&"stop"), "{events:?}");
    good(&["records", "verify", "--data", &data]);
}
