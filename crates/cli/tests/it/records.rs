//! `seamwright records`, and `simulate --data`: welds recorded, found, exported, verified, recovered; bad input.

use crate::common::{bad, example, good, has_all, json, json_file, run, table};
use seamwright_message::Message;
use seamwright_record::library::{Alarm, Place};
use seamwright_record::{DataFolder, Moment};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A folder with the data folder `data` and the ellipse welded as part P-1.
fn recorded() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data").display().to_string();
    simulate(folder.path(), &data, "P-1", "3");
    (folder, data)
}

fn simulate(folder: &Path, data: &str, part: &str, seed: &str) {
    let out = folder.join("out").display().to_string();
    let more = ["--data", data, "--part", part, "--welder", "A. Welder", "--seed", seed];
    let output = run(&[&["simulate", &example("ellipse"), "-o", &out], &more[..]].concat());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && told.contains("recorded: weld"), "{told}");
}

#[test]
fn a_weld_is_recorded_found_and_exported() {
    let (folder, data) = recorded();
    simulate(folder.path(), &data, "P-2", "4");
    let list = |more: &[&str]| json(&[&["records", "list", "--data", &data, "--json"], more].concat());
    let ids = |list: &Value| list.as_array().unwrap().iter().map(|w| w["id"].as_u64().unwrap()).collect::<Vec<_>>();
    assert_eq!(ids(&list(&[])), [2, 1]);
    assert_eq!(ids(&list(&["--part", "P-1"])), [1]);
    assert_eq!(ids(&list(&["--result", "good", "--machine", "ellipse-xy", "--text", "welder"])), [2, 1]);
    assert_eq!(ids(&list(&["--until", "2020-01-01"])), [0u64; 0]);
    assert_eq!(ids(&list(&["--since", "2020-01-01"])), [2, 1]);
    let rows = good(&["records", "list", "--data", &data]);
    assert_eq!(table(&rows).1.len(), 2);
    // The verb shows the recorded values.
    let shown = json(&["records", "show", "1", "--data", &data, "--json"]);
    assert!(shown["part"] == "P-1" && shown["result"] == "good" && shown["welder"] == "A. Welder", "{shown}");
    assert!(good(&["records", "show", "1", "--data", &data]).contains("P-1"));
    // So do the exported files; the trace is the one beside the simulation's report.
    let exported = folder.path().join("exported");
    good(&["records", "export", "2", "-o", &exported.display().to_string(), "--data", &data]);
    let same = |name: &str, other: &Path| fs::read(exported.join(name)).unwrap() == fs::read(other).unwrap();
    assert!(same("trace.parquet", &folder.path().join("out/trace.parquet")));
    let record = json_file(exported.join("record.json"));
    assert!(record["id"] == 2 && record["files"][0]["name"] == "trace.parquet", "{record}");
    let page = fs::read_to_string(exported.join("report.html")).unwrap();
    has_all(&page, &["P-2", "A. Welder", "Signature", record["files"][0]["sha256"].as_str().unwrap()]);
    // In another language only the page differs.
    let russian = folder.path().join("russian");
    good(&["records", "export", "2", "-o", &russian.display().to_string(), "--data", &data, "--language", "ru"]);
    let page = fs::read_to_string(russian.join("report.html")).unwrap();
    has_all(&page, &["<html lang=\"ru\">", "Протокол сварки 2", "P-2", "A. Welder"]);
    assert!(!page.contains("Signature"));
    for name in ["record.json", "program.toml", "trace.parquet"] {
        assert_eq!(fs::read(russian.join(name)).unwrap(), fs::read(exported.join(name)).unwrap(), "{name}");
    }
    // The program that was welded can be planned again.
    assert!(run(&["check", &exported.join("program.toml").display().to_string()]).status.success());
}

/// Audit log and alarms leave the library as JSON lines, one entry a line.
#[test]
fn audit_log_and_alarms_are_lines_of_json() {
    let (folder, data) = recorded();
    simulate(folder.path(), &data, "P-2 \"quoted\"\n]", "4");
    let lines = |verb: &str, more: &[&str]| -> Vec<Value> {
        let text = good(&[&["records", verb, "--data", &data], more].concat());
        text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    };
    let all = lines("audit", &[]);
    assert_eq!(all.iter().map(|entry| entry["id"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 2]);
    let entry = &all[1];
    assert!(entry["kind"] == "audit" && entry["hash"].as_str().unwrap().len() == 64, "{entry}");
    assert!(entry["command"]["text"].as_str().unwrap().contains("P-2"), "{entry}");
    let at = entry["at"].as_str().unwrap();
    assert!(at.len() == 24 && at.ends_with('Z') && at.as_bytes()[10] == b'T', "{at}");
    assert_eq!(lines("audit", &["--after", "1"]), all[1..]);
    assert_eq!(lines("audit", &["--since", "2020-01-01"]), all);
    assert!(lines("audit", &["--until", "2020-01-01"]).is_empty());
    let (name, cause) = (Message::new("alarm-15-title"), Message::verbatim("the wire slips"));
    let (place, raised, priority) = (Place::default(), Moment(1_795_269_909_007), "low".to_owned());
    let alarm = Alarm { name, cause, priority, place, raised, first_out: true, acknowledged: None };
    DataFolder::open(Path::new(&data)).unwrap().library().add_alarm(Some(1), &alarm).unwrap();
    let alarms = lines("alarms", &[]);
    let alarm = &alarms[0];
    assert!(alarms.len() == 1 && alarm["weld"] == 1 && alarm["priority"] == "low", "{alarm}");
    assert_eq!(
        (&alarm["alarm"]["code"], &alarm["alarm"]["text"]),
        (&"alarm-15-title".into(), &"arc or beam lost".into())
    );
    assert_eq!(alarm["at"], "2026-11-21T14:05:09.007Z");
    for (option, wrong) in [("--after", "-1"), ("--after", "last"), ("--after", "9223372036854775808")] {
        assert!(bad(2, &["records", "audit", "--data", &data, &format!("{option}={wrong}")]).contains(option));
    }
    for option in ["--since", "--until"] {
        for wrong in ["yesterday", "2026-13-01", "2026-11-21 25:00"] {
            assert!(bad(2, &["records", "alarms", "--data", &data, option, wrong]).contains("2026-11-21"));
        }
    }
    bad(2, &["records", "audit", "--data", &folder.path().join("nowhere").display().to_string()]);
}

#[test]
fn the_trace_is_compact_and_typed() {
    let (folder, _) = recorded();
    let file = fs::File::open(folder.path().join("out/trace.parquet")).unwrap();
    let reader = parquet::file::reader::SerializedFileReader::new(file).unwrap();
    let metadata = parquet::file::reader::FileReader::metadata(&reader).file_metadata().clone();
    let kind = |name: &str| {
        let columns = metadata.schema_descr().columns();
        columns.iter().find(|c| c.name() == name).unwrap().physical_type().to_string()
    };
    assert_eq!(["t_s", "x_set_mm", "x_true_mm", "s_mm"].map(kind), ["DOUBLE"; 4]);
    assert_eq!(["path_error_mm", "speed_set_mm_s", "x_following_error_mm"].map(kind), ["FLOAT"; 3]);
    assert_eq!(["arc", "pass"].map(kind), ["INT32"; 2]);
}

#[test]
fn what_was_changed_is_found() {
    let (_folder, data) = recorded();
    assert!(good(&["records", "verify", "--data", &data]).contains("in order"));
    let trace = Path::new(&data).join("welds/000001/trace.parquet");
    let mut bytes = fs::read(&trace).unwrap();
    bytes[500] ^= 1;
    fs::write(&trace, bytes).unwrap();
    let output = run(&["records", "verify", "--data", &data, "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(found["problems"][0].as_str().unwrap().contains("trace.parquet"), "{found}");
}

#[test]
fn a_killed_simulation_is_recovered() {
    let folder = tempfile::tempdir().unwrap();
    let (out, data) = (folder.path().join("out"), folder.path().join("data"));
    let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .args(["simulate", &example("saddle"), "-o"])
        .arg(&out)
        .arg("--data")
        .arg(&data)
        .stderr(std::process::Stdio::null())
        .stdout(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let raw = data.join("welds/000001/trace.raw");
    while !fs::metadata(&raw).is_ok_and(|m| m.len() > 300_000) {
        assert!(child.try_wait().unwrap().is_none(), "it has ended too soon");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let data = data.display().to_string();
    assert_eq!(run(&["records", "verify", "--data", &data]).status.code(), Some(1));
    let recovered = json(&["records", "recover", "--data", &data, "--json"]);
    assert!(recovered[0]["id"] == 1 && recovered[0]["result"] == "interrupted", "{recovered}");
    assert!(recovered[0]["rows"].as_u64().unwrap() > 1000, "{recovered}");
    assert!(good(&["records", "verify", "--data", &data]).contains("in order"));
    assert!(good(&["records", "recover", "--data", &data]).contains("nothing to recover"));
    let exported = folder.path().join("exported").display().to_string();
    good(&["records", "export", "1", "-o", &exported, "--data", &data]);
}

/// Each command refuses with a message that lists the allowed values, and writes no file.
#[test]
fn bad_input() {
    let (folder, data) = recorded();
    let out = folder.path().join("never").display().to_string();
    let nowhere = folder.path().join("nowhere").display().to_string();
    let foreign = folder.path().join("foreign");
    fs::create_dir(&foreign).unwrap();
    fs::write(foreign.join("library.sqlite"), "no database. ".repeat(100)).unwrap();
    let foreign = foreign.display().to_string();
    let ended = |code: i32, arguments: &[&str], words: &[&str]| {
        let told = bad(code, arguments);
        words.iter().for_each(|word| assert!(told.contains(word), "{word} in {told}"));
        assert!(!Path::new(&out).exists() && !Path::new(&nowhere).exists(), "{arguments:?}");
    };
    ended(2, &["records", "list", "--data", &data, "--since", "yesterday"], &["yesterday", "2026-11-21"]);
    ended(2, &["records", "list", "--data", &data, "--until", "2026-02-30"], &["2026-02-30", "invalid date"]);
    ended(2, &["records", "list", "--data", &data, "--result", "bad"], &["good, deviating, stopped"]);
    for verb in ["show", "export"] {
        let more: &[&str] = if verb == "export" { &["-o", &out] } else { &[] };
        let with = |id: &str, data: &str, code: i32, words: &[&str]| {
            ended(code, &[&["records", verb, id, "--data", data], more].concat(), words);
        };
        with("7", &data, 2, &["weld 7 does not exist", "allowed: 1 to 1"]);
        with("first", &data, 2, &["first"]);
        with("1", &nowhere, 2, &["the library is missing", "--data"]);
        with("1", &foreign, 3, &["library.sqlite", "damaged", "move it away"]);
    }
    for verb in ["list", "verify", "recover"] {
        ended(2, &["records", verb, "--data", &nowhere], &["the library is missing", "allowed: "]);
        ended(3, &["records", verb, "--data", &foreign], &["damaged"]);
        ended(2, &["records", verb, "--dta", &data], &["--data"]);
    }
    // A file instead of the folder; a part without a library; a library of a later version.
    let job = example("ellipse");
    let simulate = ["simulate", &job, "-o", &out];
    let file = Path::new(&data).join("library.sqlite").display().to_string();
    let written = |more: &[&str], words: &[&str]| {
        let told = bad(2, &[&simulate[..], more].concat());
        words.iter().for_each(|word| assert!(told.contains(word), "{word} in {told}"));
        assert!(!Path::new(&out).join("trace.parquet").exists());
    };
    written(&["--data", &file], &["library.sqlite"]);
    written(&["--part", "P-3"], &["--data"]);
    bad(3, &[&simulate[..], &["--data", &foreign]].concat());
}

#[test]
fn the_usual_folder() {
    let (folder, data) = recorded();
    let list = |name: &str, value: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_seamwright"));
        command.args(["records", "list"]).env_remove("SEAMWRIGHT_DATA").env_remove("XDG_DATA_HOME").env("HOME", "/");
        command.env(name, value).output().unwrap()
    };
    assert!(String::from_utf8(list("SEAMWRIGHT_DATA", &data).stdout).unwrap().contains("P-1"));
    fs::rename(&data, folder.path().join("seamwright")).unwrap();
    let xdg = list("XDG_DATA_HOME", &folder.path().display().to_string());
    assert!(String::from_utf8(xdg.stdout).unwrap().contains("P-1"));
    let output = list("SEAMWRIGHT_DATA", "");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains(".local/share/seamwright"));
}

#[test]
fn names_that_look_like_formulas_are_texts_in_tables() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data").display().to_string();
    simulate(folder.path(), &data, "=HYPERLINK(\"http://x\";\"P\")", "3");
    let rows = good(&["records", "list", "--data", &data]);
    assert!(rows.contains("'=HYPERLINK(") && !rows.contains(",=") && !rows.contains(",\"="), "{rows}");
    // JSON has the text unchanged.
    let listed = json(&["records", "list", "--data", &data, "--json"]);
    assert_eq!(listed[0]["part"], "=HYPERLINK(\"http://x\";\"P\")");
}
