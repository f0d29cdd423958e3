//! `run` ended by a signal while it welds on a real device: arc, gas and values are off, the record is closed, the exit
//! code reports it.

use crate::common::{beside_home, good, json, json_file, start, write};
use crate::modbus_server::TestServer;
use crate::modbus_welder::{MAP, welder};
use seamwright_record::trace::Trace;
use serde_json::Value;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The ellipse beside home on a machine whose process source is at `address`, with `map`.
pub(crate) fn job(folder: &Path, address: &str, map: &str) -> String {
    let machine = good(&["machine", "show", "ellipse-xy"]);
    let machine = format!("{machine}\n[devices.welder.modbus]\naddress = \"{address}\"\n{map}");
    std::fs::write(folder.join("cell.toml"), machine).unwrap();
    write(folder, "job.toml", beside_home().replace("machine = \"ellipse-xy\"", "machine = \"cell.toml\""))
}

pub(crate) fn eventually(what: &str, done: impl Fn() -> bool) {
    let begun = Instant::now();
    while !done() {
        assert!(begun.elapsed() < Duration::from_secs(60), "not within 60 s: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A weld whose arc burns on the device of `server`.
pub(crate) struct Welding {
    pub(crate) child: Child,
    pub(crate) out: PathBuf,
    pub(crate) data: PathBuf,
}

impl Welding {
    pub(crate) fn begin(folder: &Path, server: &TestServer) -> Self {
        let job = job(folder, &server.address.to_string(), &format!("timeout_s = 1\n{MAP}"));
        let [out, data] = ["out", "data"].map(|name| folder.join(name));
        let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
            .args(["run", &job, "--part", "N-1", "-o"])
            .arg(&out)
            .arg("--data")
            .arg(&data)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let orders = child.stdin.as_mut().unwrap();
        orders.write_all(b"on\nhome\nwait ready\narm\nweld\nwait 100000 s\n").unwrap();
        eventually("the arc", || server.bank().discrete[4]);
        Self { child, out, data }
    }

    pub(crate) fn signal(&self, name: &str) {
        let status = Command::new("kill").args([&format!("-{name}"), &self.child.id().to_string()]).status();
        assert!(status.unwrap().success());
    }

    /// Its exit code, and its text on standard error.
    pub(crate) fn ends(self) -> (Option<i32>, String) {
        let output = self.child.wait_with_output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    }
}

#[test]
fn a_signal_takes_the_process_away_and_closes_the_record() {
    for name in ["TERM", "INT", "HUP", "QUIT", "TSTP"] {
        let server = TestServer::new(welder);
        let folder = tempfile::tempdir().unwrap();
        let welding = Welding::begin(folder.path(), &server);
        assert!(server.bank().holding[0] > 0);
        welding.signal(name);
        let (out, data) = (welding.out.clone(), welding.data.display().to_string());
        let (code, told) = welding.ends();
        assert_eq!(code, Some(3), "SIG{name}: {told}");
        assert!(told.contains(&format!("SIG{name}")), "{told}");
        {
            let bank = server.bank();
            assert!(!bank.coils[0] && !bank.coils[1] && bank.holding[..2] == [0, 0], "SIG{name}");
        }
        let weld = json(&["records", "show", "1", "--data", &data, "--json"]);
        assert_eq!((&weld["result"], &weld["part"]), (&"stopped".into(), &"N-1".into()), "{weld}");
        assert!(weld["note"].as_str().unwrap().contains(&format!("signal SIG{name}")), "{weld}");
        assert!(weld["ended"].is_string(), "{weld}");
        good(&["records", "verify", "--data", &data]);
        let run = json_file(out.join("run.json"));
        assert_eq!(run["ended_by"], format!("signal SIG{name}"), "{run}");
        assert_eq!(run["mode"], "off", "it came to rest before its power went: {run}");
    }
}

/// A process that was frozen while it welds on simulated devices: on waking the process is off, the alarm has the
/// reason, and the record has it.
#[test]
fn a_frozen_weld_is_stopped_and_told() {
    for frozen in [Duration::from_millis(500), Duration::from_millis(1500)] {
        let folder = tempfile::tempdir().unwrap();
        let [out, data] = ["out", "data"].map(|name| folder.path().join(name).display().to_string());
        let job = write(folder.path(), "job.toml", beside_home());
        let mut child = start(&["run", &job, "-o", &out, "--data", &data, "--json"]);
        let mut orders = child.stdin.take().unwrap();
        orders.write_all(b"on\nhome\nwait ready\narm\nweld\nwait 2 mm\n?\nwait fault\n").unwrap();
        let mut events = BufReader::new(child.stdout.take().unwrap()).lines().map(|line| line.unwrap());
        let event = |line: &str| serde_json::from_str::<Value>(line).unwrap();
        let travels = events.by_ref().map(|line| event(&line)).find(|event| event["event"] == "state").unwrap();
        assert_eq!(travels["mode"], "weld", "{travels}");
        let pid = child.id().to_string();
        let signal = |name: &str| assert!(Command::new("kill").args([name, &pid]).status().unwrap().success());
        signal("-STOP");
        std::thread::sleep(frozen);
        signal("-CONT");
        let alarm = events.by_ref().map(|line| event(&line)).find(|event| event["event"] == "alarm").unwrap();
        assert_eq!((&alarm["alarm"], &alarm["first_out"]), (&"cycles missed".into(), &true.into()), "{alarm}");
        let gap_ms = alarm["gap_ms"].as_f64().unwrap();
        assert!(gap_ms > 0.9 * frozen.as_secs_f64() * 1e3, "{alarm}");
        drop(orders);
        let rest: Vec<Value> = events.map(|line| event(&line)).collect();
        assert!(rest.iter().any(|event| event["to"] == "fault"), "{rest:?}");
        assert_eq!(child.wait().unwrap().code(), Some(3));
        let told = std::fs::read_to_string(Path::new(&out).join("events.jsonl")).unwrap();
        let missed = told.lines().map(event).filter(|event| event["event"] == "missed");
        let longest = missed.map(|event| event["longest_ms"].as_f64().unwrap()).fold(0.0, f64::max);
        assert!(longest > 0.9 * frozen.as_secs_f64() * 1e3, "{longest} ms: {told}");
        let shown = json(&["records", "show", "1", "--data", &data, "--json"]);
        assert!(shown["alarms"][0]["name"] == "cycles missed" && shown["result"] == "stopped", "{shown}");
        let noted = |e: &Value| e["text"].as_str().unwrap().contains("missed, up to");
        assert!(shown["events"].as_array().unwrap().iter().any(noted), "{shown}");
        // The process was ordered off with the first exchange after the gap.
        let trace = Trace::open(&Path::new(&data).join("welds/000001/trace.parquet")).unwrap();
        let (mut gap, mut on) = (false, 0);
        trace
            .read(&["missed", "arc"], |row| {
                on += u32::from(gap && row[1] > 0.5);
                gap |= row[0] > 200.0;
            })
            .unwrap();
        assert!(gap && on == 0, "{gap} {on}");
    }
}

/// The watchdog of a process source: without a change of coil 2 for 0.1 s its arc goes out by itself, and the order to
/// burn is forgotten. Returns when `done` is true.
fn with_own_watchdog(server: &TestServer, done: impl Fn() -> bool) {
    let (mut last, mut since) = (server.bank().coils[2], Instant::now());
    while !done() {
        let mut bank = server.bank();
        if bank.coils[2] != last {
            (last, since) = (bank.coils[2], Instant::now());
        }
        if since.elapsed() > Duration::from_millis(100) {
            bank.coils[1] = false;
        }
        drop(bank);
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// A process that is frozen while it welds on a source on Modbus. During the freeze only the source's own watchdog can
/// switch it off, if it has one. After it the arc is off at once and stays off, the watchdog output stands still, and
/// the alarm has the length of the gap.
#[test]
fn a_frozen_weld_on_a_real_source_goes_off_and_stays_off() {
    for (ms, has_watchdog) in [(300, true), (2000, false)] {
        let frozen = Duration::from_millis(ms);
        let server = TestServer::new(welder);
        let folder = tempfile::tempdir().unwrap();
        let welding = Welding::begin(folder.path(), &server);
        welding.signal("STOP");
        let begun = Instant::now();
        if has_watchdog {
            with_own_watchdog(&server, || begun.elapsed() > frozen);
            assert!(!server.bank().coils[1], "the source's own watchdog");
        } else {
            std::thread::sleep(frozen);
            assert!(server.bank().coils[1], "nobody else switches it off");
        }
        welding.signal("CONT");
        let begun = Instant::now();
        eventually("arc off", || !server.bank().coils[1]);
        // Some milliseconds as a rule; the computer may be loaded.
        assert!(begun.elapsed() < Duration::from_secs(2), "off after {:?}", begun.elapsed());
        // The cell comes to rest and waits in its fault: neither arc nor watchdog comes back.
        std::thread::sleep(Duration::from_millis(300));
        let watchdog = server.bank().coils[2];
        for _ in 0..100 {
            let bank = server.bank();
            assert!(!bank.coils[1], "the arc came back by itself");
            assert_eq!(bank.coils[2], watchdog, "the watchdog output goes on");
            drop(bank);
            std::thread::sleep(Duration::from_millis(5));
        }
        let (out, data) = (welding.out.clone(), welding.data.display().to_string());
        welding.signal("TERM");
        let (code, told) = welding.ends();
        assert_eq!(code, Some(3), "{told}");
        let weld = json(&["records", "show", "1", "--data", &data, "--json"]);
        assert_eq!(
            (&weld["alarms"][0]["name"], &weld["result"]),
            (&"cycles missed".into(), &"stopped".into()),
            "{weld}"
        );
        assert!(weld["alarms"][0]["cause"].as_str().unwrap().contains("no cycle for"), "{weld}");
        let events = std::fs::read_to_string(out.join("events.jsonl")).unwrap();
        let mut events = events.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
        let alarm = events.find(|event| event["event"] == "alarm").unwrap();
        let gap_ms = alarm["gap_ms"].as_f64().unwrap();
        assert!(gap_ms > 0.9 * ms as f64 && gap_ms < ms as f64 + 5000.0, "{alarm}");
        assert!(alarm["of"].as_str().unwrap().ends_with("ms"), "{alarm}");
        let run = json_file(out.join("run.json"));
        assert_eq!(run["ended_by"], "signal SIGTERM", "the supervisor has not ended a process that was frozen: {run}");
    }
}

/// The data folder is removed while a weld is recorded in it: an alarm, and no exit as if all were well.
#[test]
fn a_record_that_is_removed_is_an_alarm() {
    let folder = tempfile::tempdir().unwrap();
    let [out, data] = ["out", "data"].map(|name| folder.path().join(name).display().to_string());
    let job = write(folder.path(), "job.toml", beside_home());
    let mut child = start(&["run", &job, "--json", "-o", &out, "--data", &data]);
    let mut orders = child.stdin.take().unwrap();
    orders.write_all(b"on\nhome\nwait ready\narm\nweld\nwait 1 mm\n?\n").unwrap();
    let mut events = BufReader::new(child.stdout.take().unwrap()).lines().map(|line| line.unwrap());
    let event = |line: String| serde_json::from_str::<Value>(&line).unwrap();
    events.by_ref().map(event).find(|event| event["event"] == "state").unwrap();
    std::fs::remove_dir_all(&data).unwrap();
    let alarm = events.by_ref().map(event).find(|event| event["event"] == "alarm").unwrap();
    assert_eq!(alarm["alarm"], "record failing", "{alarm}");
    orders.write_all(b"stop\n").unwrap();
    drop(orders);
    drop(events);
    let output = child.wait_with_output().unwrap();
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(3) && told.contains("removed"), "{:?} {told}", output.status);
}
