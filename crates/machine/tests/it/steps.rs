//! Drives by pulses: parsing, and refusal of invalid entries.

use seamwright_machine::{Machine, shipped};

fn read(devices: &str, change: (&str, &str)) -> Result<Machine, String> {
    let text = shipped("torch-5axis").unwrap().text.replacen(change.0, change.1, 1);
    Machine::read("m.toml", &format!("{text}\n{devices}")).map_err(|e| e.to_string())
}

#[test]
fn drives_by_pulses() {
    let plain = read("[devices.drives.steps]", ("", "")).unwrap().devices.steps.unwrap();
    assert_eq!((plain.stream.clone(), plain.tick_ns, plain.period), (None, 100, 10_000));
    let named = "[devices.drives.steps]\nstream = \"out/pulses.vcd\"\ntick_ns = 500";
    let named = read(named, ("", "")).unwrap().devices.steps.unwrap();
    assert_eq!((named.stream.as_deref(), named.tick_ns, named.period), (Some("out/pulses.vcd"), 500, 2000));
}

#[test]
fn what_cannot_be_is_refused() {
    let steps = "[devices.drives.steps]";
    for (lines, change, key, allowed) in [
        ("[devices.drives.steps]\ntick_ns = 3", ("", ""), "tick_ns", "10 to 100000"),
        ("[devices.drives.steps]\ntick_ns = 300", ("", ""), "tick_ns", "whole number of times"),
        ("[devices.drives.steps]\nstream = \"a.csv\"", ("", ""), "stream", ".vcd"),
        ("[devices.drives.steps]\ndepth = 5", ("", ""), "depth", "tick_ns"),
        ("[devices.a.steps]\n[devices.b.steps]", ("", ""), "devices.b.steps", "one device"),
        ("[devices.a.linuxcnc]\n[devices.b.steps]", ("", ""), "devices.b.steps", "one device"),
        ("[devices.a.steps]\n[devices.b.linuxcnc]", ("", ""), "devices.b.linuxcnc", "one device"),
        // 320 pulses per mm: 32,000 per second at 100 mm/s. With ticks of 100 ns 31,000 Hz are 323 ticks, 32,052 Hz
        // 312 ticks.
        (steps, ("max_pulse_hz = 200000", "max_pulse_hz = 31000"), "max_pulse_hz", "up to 96.749"),
        (steps, ("max_pulse_hz = 200000", "max_pulse_hz = 32052"), "", ""),
        // With ticks of 100 ns 15.64 us are 31,969 per second.
        (steps, ("min_pulse_us = 2.5", "min_pulse_us = 7.8125"), "max_pulse_hz", "up to"),
        (steps, ("resolution_mm = 0.005", "resolution_mm = 0.0001"), "resolution_mm", "at least 0.000390625 mm"),
        (steps, ("direction_setup_us = 5", "direction_setup_us = 990"), "direction_setup_us", "together"),
    ] {
        let result = read(lines, change);
        if key.is_empty() {
            assert!(result.is_ok(), "{lines} {change:?}: {result:?}");
            continue;
        }
        let error = result.unwrap_err();
        assert!(error.contains("m.toml") && error.contains(key) && error.contains(allowed), "{lines}: {error}");
    }
    let text = format!("{}\n{steps}", shipped("saddle-4axis").unwrap().text);
    let error = Machine::read("m.toml", &text).unwrap_err().to_string();
    assert!(error.contains("has no stepper") && error.contains("[drives."), "{error}");
}
