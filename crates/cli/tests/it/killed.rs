//! `run` killed with -9 at any moment of a weld: the library is whole, the trace can be read. The next run reports the
//! position, and goes on there with the overlap that the job asks.

use crate::common::{bad, free_example, good, json, run, run_with, start, write};
use seamwright_record::trace::Trace;
use seamwright_testkit::Random;
use std::io::{Read as _, Write as _};
use std::path::Path;
use std::time::Duration;

/// Overlap of a restart, mm.
const OVERLAP: f64 = 3.0;
/// Maximum error of the position that the next run reports, mm.
const OFF: f64 = 1.0;
/// Weld of the last second, which the trace may lack, mm.
const LAST_SECOND: f64 = 5.0;
/// Before the weld, and in it: the position is asked every 50 ms.
const BEGIN: &str = "on\nhome\nwait ready\narm\nweld\n";

fn job(folder: &Path) -> String {
    let text = free_example("ellipse")
        .replace("[sequence]", &format!("[sequence]\noverlap_mm = {OVERLAP}"))
        .replace("preflow_s = 0.5", "preflow_s = 0.1")
        .replace("travel_delay_s = 0.5", "travel_delay_s = 0.2")
        .replace("postflow_s = 5", "postflow_s = 0.1");
    write(folder, "job.toml", text)
}

/// The last position that a run reported before it was killed: whether in the pass, mm.
fn last_place(text: &str) -> Option<(bool, f64)> {
    let line = text.lines().rfind(|line| line.contains("state") && line.contains("inputs"))?;
    let s = line.split(", s ").nth(1)?.split(' ').next()?.parse().ok()?;
    Some((line.contains("pass 1"), s))
}

/// Rows of a trace while the arc is on: mm along the pass.
fn welded(trace: &Path) -> Vec<f64> {
    let mut rows = Vec::new();
    let keep = |v: &[f64]| rows.extend((v[0] > 0.0).then_some(v[1]));
    Trace::open(trace).unwrap().read(&["arc", "s_mm"], keep).unwrap();
    rows
}

/// Welds from `from`, mm, and is killed after `after`. Returns the end of the bead in the last report of the killed
/// run.
fn killed_weld(arguments: &[&str], from: f64, after: Duration) -> f64 {
    let mut child = start(&[arguments, &["--from", &format!("1,{from}")]].concat());
    let asks = "?\nwait 0.05 s\n".repeat(400);
    child.stdin.take().unwrap().write_all(format!("{BEGIN}{asks}").as_bytes()).unwrap();
    let mut stdout = child.stdout.take().unwrap();
    let reader = std::thread::spawn(move || {
        let mut text = String::new();
        stdout.read_to_string(&mut text).unwrap();
        text
    });
    std::thread::sleep(after);
    child.kill().unwrap();
    child.wait().unwrap();
    match last_place(&reader.join().unwrap()) {
        Some((true, s)) => s.max(from),
        _ => from,
    }
}

/// Kills a weld at a moment, and continues it; true if there was a bead.
fn at_moment(moment: u64) -> bool {
    let mut random = Random::of_case(moment as u32);
    let from = (random.within(6.0, 90.0) * 10.0).round() / 10.0;
    let after = Duration::from_secs_f64(random.within(2.0, 12.0));
    let folder = tempfile::tempdir().unwrap();
    let [data, out] = ["data", "out"].map(|name| folder.path().join(name).display().to_string());
    let job = job(folder.path());
    let arguments = ["run", &job, "-o", &out, "--data", &data, "--part", "P"];
    let truth = killed_weld(&arguments, from, after);
    let about = format!("moment {moment}: from {from} mm, killed after {after:?}, last told at {truth} mm");

    if !Path::new(&data).join("library.sqlite").exists() {
        assert!((truth - from).abs() < 1e-9, "{about}: nobody tells of the bead");
        return false;
    }
    // The record is whole, up to the last rows.
    good(&["records", "recover", "--data", &data]);
    good(&["records", "verify", "--data", &data]);
    let listed = json(&["records", "list", "--data", &data, "--json"]);
    let begun = !listed.as_array().unwrap().is_empty();
    if !begun || run(&arguments).status.success() {
        assert!((truth - from).abs() < 1e-9, "{about}: nobody tells of the bead");
        return false;
    }
    let told = bad(2, &arguments);
    let place = told.split("--from 1,").nth(1).and_then(|rest| rest.split(';').next());
    let place: f64 = place.unwrap_or_else(|| panic!("{about}: {told}")).parse().unwrap();
    assert!((place - truth).abs() <= OFF, "{about}: {told}");
    let before = welded(&Path::new(&data).join("welds/000001/trace.parquet"));
    let last = before.last().map_or(from, |s| s.max(from));
    assert!((-OFF..=LAST_SECOND).contains(&(place - last)), "{about}: the trace ends at {last}, {told}");

    let orders = format!("{BEGIN}wait {} mm\nstop\n", place + 1.0);
    let output = run_with(&[&arguments[..], &["--from", &format!("1,{place}")]].concat(), &orders);
    assert!(output.status.success(), "{about}: {}", String::from_utf8_lossy(&output.stdout));
    let again = welded(&Path::new(&data).join("welds/000002/trace.parquet"));
    assert!((again[0] - (place - OVERLAP).max(0.0)).abs() < 0.01, "{about}: begins at {}", again[0]);
    // Cycles that the computer misses leave no rows.
    let steps = again.windows(2).map(|w| w[1] - w[0]).fold([0.0_f64; 2], |[low, high], d| [low.min(d), high.max(d)]);
    assert!(steps[0] >= 0.0 && steps[1] < OFF, "{about}: not one bead: {steps:?} mm from row to row");
    good(&["records", "verify", "--data", &data]);
    !before.is_empty()
}

#[test]
#[ignore = "200 moments in real time; make soak"]
fn a_weld_killed_at_200_moments() {
    let lanes: Vec<u64> = (0..8).collect();
    let welded: usize = std::thread::scope(|scope| {
        let run = |lane: &u64| {
            let lane = *lane;
            scope.spawn(move || (0..25).filter(|i| at_moment(8 * i + lane)).count())
        };
        let lanes: Vec<_> = lanes.iter().map(run).collect();
        lanes.into_iter().map(|lane| lane.join().unwrap()).sum()
    });
    println!("200 moments, {welded} of them with the arc on or after it");
    assert!(welded >= 20, "the moments are no moments of a weld: {welded}");
}
