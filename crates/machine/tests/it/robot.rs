//! Drives by robot controls: parsing, and refusal of invalid entries.

use seamwright_machine::{Machine, RobotProtocolKind, shipped};

fn read(devices: &str) -> Result<Machine, String> {
    on("ur10e", devices)
}

fn on(machine: &str, devices: &str) -> Result<Machine, String> {
    Machine::read("m.toml", &format!("{}\n{devices}", shipped(machine).unwrap().text)).map_err(|e| e.to_string())
}

#[test]
fn drives_by_robots() {
    let rtde = read("[devices.arm.rtde]\naddress = \"192.168.1.10\"").unwrap().devices.robot.unwrap();
    assert_eq!(rtde.protocol, RobotProtocolKind::Rtde { address: "192.168.1.10:30004".to_owned() });
    assert_eq!((rtde.axes, rtde.arm_joints, rtde.store), (vec![0, 1, 2, 3, 4, 5], 6, 3));
    assert!((rtde.period_s - 0.002).abs() < 1e-12 && (rtde.latency_s - 0.034).abs() < 1e-12);
    let turned = "[devices.arm.egm]\nlisten = \"0.0.0.0:6510\"\nfrom = \"192.168.125.1\"\nlatency_ms = 15\n\
                  axes = [\"j6\", \"j5\", \"j4\", \"j3\", \"j2\", \"j1\"]\nstore = 8";
    let egm = read(turned).unwrap().devices.robot.unwrap();
    assert_eq!((egm.axes, egm.store, egm.protocol.key()), (vec![5, 4, 3, 2, 1, 0], 8, "egm"));
    assert!(matches!(egm.protocol, RobotProtocolKind::Egm(on) if on.from.is_some() && on.on.port() == 6510));
    assert!((egm.latency_s - 0.015).abs() < 1e-12);
    // External joints follow those of the arm.
    let rsi = on("kr-16-positioner", "[devices.arm.rsi]\nlisten = \"[::]:49152\"\ncycle_ms = 12").unwrap();
    let device = rsi.devices.robot.unwrap();
    assert_eq!(device.axes.len(), rsi.axes.len());
    assert!((device.period_s - 0.012).abs() < 1e-12);
}

#[test]
fn what_cannot_be_is_refused() {
    let rtde = "[devices.arm.rtde]\naddress = \"a\"\n";
    let egm = "[devices.arm.egm]\nlisten = \"0.0.0.0:6510\"\n";
    for (lines, key, allowed) in [
        (format!("{rtde}axes = [\"j1\", \"j2\"]"), "devices.arm.rtde.axes", "`j3`"),
        (format!("{rtde}axes = [\"j1\", \"j1\"]"), "devices.arm.rtde.axes", "twice"),
        (format!("{rtde}axes = [\"j1\", \"a2\"]"), "devices.arm.rtde.axes", "j2"),
        (format!("{rtde}rate_hz = 250"), "rate_hz", "125, 500"),
        (format!("{rtde}store = 1"), "store", "2 to 200"),
        (format!("{rtde}latency_ms = 300"), "latency_ms", "200 ms"),
        (format!("{rtde}listen = \"x\""), "listen", "address"),
        ("[devices.arm.rtde]\naddress = \"a:b\"".to_owned(), "address", "port"),
        ("[devices.arm.egm]\nlisten = \"6510\"".to_owned(), "listen", "0.0.0.0:6510"),
        (format!("{egm}from = \"robot\""), "from", "IP address"),
        (format!("{egm}joints = 5"), "joints", "6 to 7"),
        ("[devices.arm.rsi]\nlisten = \"0.0.0.0:1\"\ncycle_ms = 8".to_owned(), "cycle_ms", "4, 12"),
        (format!("{rtde}[devices.b.steps]"), "devices.b.steps", "one device"),
    ] {
        let error = read(&lines).unwrap_err();
        assert!(error.contains("m.toml") && error.contains(key) && error.contains(allowed), "{lines}: {error}");
    }
    // Two axes more than the arm has; axes that do not turn.
    let error = on("ur10e-positioner", rtde).unwrap_err();
    assert!(error.contains("8 axes") && error.contains("devices.arm.rtde"), "{error}");
    let error = on("dual-laser-10axis", egm).unwrap_err();
    assert!(error.contains("linear"), "{error}");
}
