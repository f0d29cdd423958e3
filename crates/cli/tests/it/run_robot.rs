//! `run` on a robot control, and the programs for controls.

use crate::common::{bad, good, json_file, start, write};
use seamwright_simulation::robot::{ControlServer, MAX_JOINTS, RtdeControl, Servo};
use std::io::Write as _;
use std::path::Path;

/// Writes a job on an arm with this device; returns its path.
fn job(folder: &Path, device: &str) -> String {
    let machine = good(&["machine", "show", "ur10e"]);
    let period = "servo_period_ms = 4\n";
    let order = "home_order = [\"j1\", \"j2\", \"j3\", \"j4\", \"j5\", \"j6\"]\n";
    let machine = machine.replace(period, &format!("{period}{order}"));
    std::fs::write(folder.join("cell.toml"), format!("{machine}\n{device}")).unwrap();
    let job = "schema = 1\ntitle = \"t\"\nmachine = \"cell.toml\"\n[placement]\nmove_mm = [0, 0, 200]\n\
               [seam.polyline]\npoints_mm = [[-30, 0, 0], [30, 0, 0]]\njoint = \"butt\"\n\
               [weld]\nspeed_mm_s = 8\n[weld.process]\ncurrent_a = 190\n";
    write(folder, "job.toml", job)
}

/// The arm stands 30 degrees off home: homing brings it there, and the way is enough to measure the latency.
#[test]
fn a_robot_goes_home() {
    let mut positions = [0.0; MAX_JOINTS];
    for (joint, degrees) in positions.iter_mut().zip([30.0, -75.0, -75.0, -110.0, 75.0, 30.0f64]) {
        *joint = degrees.to_radians();
    }
    let control = RtdeControl::new(500.0, Servo::UNIVERSAL_ROBOTS, positions).patient(0.5);
    let server = ControlServer::tcp(control, "127.0.0.1:0").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let device = format!("[devices.arm.rtde]\naddress = \"{}\"\nstore = 10\n", server.address());
    let (job, out) = (job(folder.path(), &device), folder.path().join("out"));
    let mut child = start(&["run", &job, "-o", &out.display().to_string()]);
    child.stdin.take().unwrap().write_all(b"on\nhome\nwait ready\noff\n").unwrap();
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    let run = json_file(out.join("run.json"));
    let device = &run["devices"][0];
    let latency = device["latency_ms"]["mean"].as_f64().unwrap();
    assert!(device["device"] == "arm" && (25.0..45.0).contains(&latency), "{run}");
    let home = [0.0, -90.0, -90.0, -90.0, 90.0, 0.0f64];
    let positions = server.positions();
    // Power goes off with the last set-points in store.
    assert!(positions.iter().zip(home).all(|(q, home)| (q.to_degrees() - home).abs() < 1.0), "{positions:?}");
    assert!(!server.follows());
}

#[test]
fn a_control_that_is_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let job = job(folder.path(), "[devices.arm.rtde]\naddress = \"127.0.0.1:9\"\n");
    let out = folder.path().join("out").display().to_string();
    let message = bad(3, &["run", &job, "-o", &out]);
    assert!(message.contains("`arm` (rtde) at 127.0.0.1:9") && message.contains("robot-program rtde"), "{message}");
}

/// The programs name the registers, elements and time-outs that the guide describes.
#[test]
fn programs_for_controls() {
    for (protocol, parts) in [
        ("rtde", &["servoj(", "rtde_set_watchdog", "read_input_float_register(29)"][..]),
        ("egm", &["EGMRunJoint", "CommTimeout", "EGM_STOP_HOLD"]),
        ("rsi", &["RSI_ON(#ABSOLUTE", "DEF_AIPos", "AK.A6"]),
    ] {
        let text = good(&["machine", "robot-program", protocol]);
        assert!(parts.iter().all(|part| text.contains(part)), "{protocol}: {text}");
    }
    bad(2, &["machine", "robot-program", "karel"]);
}
