//! Drives by LinuxCNC: parsing, and refusal of invalid entries.

use seamwright_machine::{Machine, shipped};

fn read(devices: &str) -> Result<Machine, String> {
    let text = format!("{}\n{devices}", shipped("ellipse-xy").unwrap().text);
    Machine::read("m.toml", &text).map_err(|e| e.to_string())
}

#[test]
fn drives_by_linuxcnc() {
    let simulated = read("[devices.drives.linuxcnc]").unwrap().devices.linuxcnc.unwrap();
    assert_eq!((simulated.hal, simulated.store, simulated.base_period_us), (None, 10, None));
    let real = "[devices.drives.linuxcnc]\nhal = \"mesa.hal\"\nstore = 4\nbase_period_us = 50";
    let real = read(real).unwrap().devices.linuxcnc.unwrap();
    assert_eq!((real.hal.as_deref(), real.store, real.base_period_us), (Some("mesa.hal"), 4, Some(50)));
}

#[test]
fn what_cannot_be_is_refused() {
    for (lines, key, allowed) in [
        ("[devices.drives.linuxcnc]\nstore = 1", "store", "2 to 200"),
        ("[devices.drives.linuxcnc]\nstore = 500", "store", "2 to 200"),
        ("[devices.drives.linuxcnc]\nhal = \"mesa.tcl\"", "hal", ".hal"),
        ("[devices.drives.linuxcnc]\nbase_period_us = 30", "base_period_us", "whole number of times"),
        ("[devices.drives.linuxcnc]\nbase_period_us = 1000", "base_period_us", "at least twice"),
        ("[devices.drives.linuxcnc]\ndepth = 5", "depth", "store"),
        ("[devices.a.linuxcnc]\n[devices.b.linuxcnc]", "devices.b.linuxcnc", "one device"),
    ] {
        let error = read(lines).unwrap_err();
        assert!(error.contains("m.toml") && error.contains(key) && error.contains(allowed), "{lines}: {error}");
    }
}
