//! `run` and `io` with a machine file whose process source and inputs are on Modbus.

use crate::common::{bad, good, json, json_file, start};
use crate::modbus_server::TestServer;
use crate::modbus_welder::{MAP, welder};
use crate::stopped::{eventually, job};
use serde_json::Value;
use std::io::Write as _;

/// The arc burns by the device; stopped, it is off; at the end outputs are safe and the traffic is reported.
#[test]
fn a_weld_by_a_device_on_modbus() {
    let server = TestServer::new(welder);
    let folder = tempfile::tempdir().unwrap();
    let job = job(folder.path(), &server.address.to_string(), MAP);
    let out = folder.path().join("out");
    let mut child = start(&["run", &job, "-o", &out.display().to_string()]);
    let mut orders = child.stdin.take().unwrap();
    orders.write_all(b"on\nhome\nwait ready\narm\nweld\n").unwrap();
    eventually("arc", || server.bank().coils[1]);
    {
        let bank = server.bank();
        assert_eq!((bank.coils[0], &bank.holding[..2]), (true, &[900, 1200][..]));
    }
    orders.write_all(b"stop\n").unwrap();
    drop(orders);
    let output = child.wait_with_output().unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{told}");
    assert!(told.contains("simulated: drives"), "{told}");
    let bank = server.bank();
    assert!(!bank.coils[0] && !bank.coils[1] && bank.holding[..2] == [0, 0]);
    let run = json_file(out.join("run.json"));
    let device = &run["devices"][0];
    assert!(
        device["device"] == "welder" && device["connections"] == 1 && device["polls"].as_u64().unwrap() > 50,
        "{run}"
    );
}

#[test]
fn what_cannot_be_connected_is_told_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let out_text = out.display().to_string();
    // The device is unreachable.
    let address = TestServer::new(welder).address.to_string();
    let job_path = job(folder.path(), &address, MAP);
    let message = bad(3, &["run", &job_path, "-o", &out_text]);
    assert!(
        message.contains("`welder`") && message.contains(&address) && message.contains("seamwright machine io"),
        "{message}"
    );
    let machine = folder.path().join("cell.toml").display().to_string();
    assert!(bad(3, &["machine", "io", &machine]).contains(&address));
    // A value that is never set.
    let server = TestServer::new(welder);
    let job_path = job(folder.path(), &server.address.to_string(), &MAP.replace("voltage_v", "volts_v"));
    let message = bad(2, &["run", &job_path, "-o", &out_text]);
    assert!(message.contains("voltage_v") && message.contains("[devices.welder.modbus.set]"), "{message}");
    assert!(!out.exists());
    assert!(bad(2, &["machine", "io", "ellipse-xy"]).contains("[devices.NAME.modbus]"));
    assert!(bad(2, &["machine", "io", &machine, "--every-s", "0"]).contains("--every-s"));
}

#[test]
fn registers_by_name() {
    let server = TestServer::new(welder);
    server.bank().holding[0] = 905;
    let folder = tempfile::tempdir().unwrap();
    job(folder.path(), &server.address.to_string(), MAP);
    let machine = folder.path().join("cell.toml").display().to_string();
    let text = good(&["machine", "io", &machine]);
    assert!(text.starts_with("t_s,device,register,place,raw,value,unit,age_s,trouble\n"), "{text}");
    assert!(text.contains(",welder,set.current_a,holding 0 u16,905,90.5,a,"), "{text}");
    assert!(text.contains(",welder,inputs.gas_ok,discrete 2,1,1,,"), "{text}");
    assert_eq!(text.lines().count(), 10);
    let rows: Value = json(&["machine", "io", &machine, "--json", "--every-s", "0.05", "--times", "3"]);
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 27);
    assert!(rows[26]["t_s"].as_f64().unwrap() >= 0.1 && rows[26]["age_s"].as_f64().unwrap() < 5.0);
    assert_eq!(server.bank().writes, 0);
}

/// A value beyond its register is refused with its address, before anything is connected; one at its end is accepted.
#[test]
fn values_that_registers_cannot_hold() {
    let folder = tempfile::tempdir().unwrap();
    let narrow = MAP.replace("scale = 0.1 }", "type = \"i16\", scale = 0.001 }");
    assert_ne!(narrow, MAP);
    let path = job(folder.path(), "127.0.0.1:9", &narrow);
    for verb in [&["check", &path][..], &["run", &path, "-o", "never"]] {
        let message = bad(2, verb);
        for part in ["job.toml", "current_a", "holding 0 i16", "-32.768 to 32.767", "`welder`"] {
            assert!(message.contains(part), "{part}: {message}");
        }
    }
    let path = job(folder.path(), "127.0.0.1:9", MAP);
    good(&["check", &path]);
}
