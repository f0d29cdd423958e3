//! Peak memory and time of `seamwright motion` streaming one and ten million set-points. Aim: 50 MB, cost linear.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Travel and dwell time of the example, s, that the periods below divide.
const TOTAL_S: f64 = 30.189;

fn main() {
    let job = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml");
    let mut each = Vec::new();
    for millions in [1.0, 10.0] {
        let (megabytes, time) = stream(job, TOTAL_S / millions * 1e-3);
        let ns = time.as_secs_f64() * 1e9 / (millions * 1e6);
        println!("motion, {millions} million set-points as CSV: peak memory {megabytes:.1} MB, {ns:.0} ns a set-point");
        each.push(ns);
    }
    println!("motion, cost of a set-point in ten million over one million: {:.2}", each[1] / each[0]);
}

/// Peak resident memory (MB) and time of one run with set-points every `period_ms`.
fn stream(job: &str, period_ms: f64) -> (f64, Duration) {
    let start = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .args(["motion", job, "--period-ms", &period_ms.to_string()])
        .stdout(Stdio::null())
        .spawn()
        .expect("the binary under test has just been built");
    let mut peak = 0.0f64;
    loop {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
        let kilobytes: Option<f64> = line.and_then(|l| l.trim().trim_end_matches(" kB").parse().ok());
        peak = peak.max(kilobytes.unwrap_or(0.0) / 1000.0);
        if child.try_wait().is_ok_and(|s| s.is_some()) {
            return (peak, start.elapsed());
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}
