//! Peak memory and time of streaming: `seamwright tools motion` with one and ten million set-points, `seamwright tools follow`
//! along as many points. Aim: 50 MB, cost linear.

use std::f64::consts::TAU;
use std::io::{BufWriter, Write};
use std::process::{Child, Command, Stdio};
use std::time::Instant;

/// Travel and dwell time of the example, s, that the periods below divide.
const TOTAL_S: f64 = 30.189;

fn main() {
    let job = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml");
    report("motion", "set-point", |millions| {
        start(&["tools", "motion", job, "--period-ms", &(TOTAL_S / millions * 1e-3).to_string()])
    });
    report("follow", "point 0.02 mm from the one before", |millions| {
        let mut child = start(&[
            "tools",
            "follow",
            "-",
            "--machine",
            "table-tilting-xyzac",
            "--speed-mm-s",
            "20",
            "--period-ms",
            "10",
        ]);
        let input = child.stdin.take().expect("it is piped");
        std::thread::spawn(move || turns(BufWriter::new(input), (millions * 1e6) as u32));
        child
    });
}

/// Prints figures of runs with one and with ten million items.
fn report(verb: &str, what: &str, run: impl Fn(f64) -> Child) {
    let mut each = Vec::new();
    for millions in [1.0, 10.0] {
        let begin = Instant::now();
        let megabytes = peak_memory(run(millions));
        let ns = begin.elapsed().as_secs_f64() * 1e9 / (millions * 1e6);
        println!("{verb}, {millions} million: peak memory {megabytes:.1} MB, {ns:.0} ns for each {what}");
        each.push(ns);
    }
    println!("{verb}, cost of each in ten million over one million: {:.2}", each[1] / each[0]);
}

fn start(arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .expect("the binary under test has just been built")
}

/// Writes turns around a nozzle of radius 25 mm on a shell of radius 60 mm, tilted up to 20 degrees, as axis positions.
fn turns(mut out: impl Write, points: u32) {
    let mut write = || -> std::io::Result<()> {
        writeln!(out, "x,y,z,a,c")?;
        for i in 0..points {
            let c = TAU * f64::from(i) / 8000.0;
            let z = (3600.0 - (25.0 * c.sin()).powi(2)).sqrt();
            let a = 20f64.to_radians() * c.sin();
            let (a_deg, c_deg) = (a.to_degrees(), c.to_degrees());
            writeln!(out, "25,{:.7},{:.7},{a_deg:.7},{c_deg:.7}", -z * a.sin(), z * a.cos())?;
        }
        out.flush()
    };
    write().expect("the reader reads to the end");
}

/// Peak resident memory of a process until it ends, MB.
fn peak_memory(mut child: Child) -> f64 {
    let mut peak = 0.0f64;
    loop {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
        let kilobytes: Option<f64> = line.and_then(|l| l.trim().trim_end_matches(" kB").parse().ok());
        peak = peak.max(kilobytes.unwrap_or(0.0) / 1000.0);
        match child.try_wait() {
            Ok(Some(status)) if status.success() => return peak,
            Ok(None) => std::thread::sleep(std::time::Duration::from_millis(2)),
            failed => panic!("the run failed: {failed:?}"),
        }
    }
}
