//! A small cell on the test server: its map, and the welding source that the server simulates.

use super::modbus_server::{Bank, TestServer};
use seamwright_executive::devices::modbus::{ModbusParts, connect};
use seamwright_machine::{Machine, ModbusDevice, shipped};

/// Process values of the welded job.
pub(crate) const VALUES: [&str; 2] = ["current_a", "wire_m_min"];
/// Period of the cycle, s.
pub(crate) const PERIOD_S: f64 = 1e-3;

/// Registers of the cell, as in a machine file.
pub(crate) const MAP: &str = r#"
unit = 1
poll_hz = 200
timeout_s = 0.5
watchdog_s = 0.4
heartbeat_s = 0.2
[devices.io.modbus.inputs]
e_stop_ok = { discrete = 0 }
curtain_clear = { discrete = 3 }
gas_ok = { input = 40, bit = 9 }
[devices.io.modbus.outputs]
gas = { coil = 0, safe = true }
on = { coil = 1 }
watchdog = { holding = 20 }
[devices.io.modbus.set]
current_a = { holding = 0, scale = 0.1, safe = 5 }
wire_m_min = { holding = 2, type = "f32", words = "low_first" }
[devices.io.modbus.reports]
ready = { discrete = 8 }
burning = { discrete = 9 }
stuck = { discrete = 10 }
fault = { input = 1 }
heartbeat = { input = 0 }
[devices.io.modbus.actual]
current_a = { input = 10, type = "i16", scale = 0.1 }
"#;

pub(crate) fn device(address: &str, map: &str) -> ModbusDevice {
    let machine = shipped("ellipse-xy").unwrap().text;
    let text = format!("{machine}\n[devices.io.modbus]\naddress = \"{address}\"\n{map}");
    Machine::read("m.toml", &text).unwrap_or_else(|e| panic!("{e}")).devices.modbus.remove(0)
}

/// Connects the device of [`MAP`] on `server`.
pub(crate) fn parts(server: &TestServer) -> ModbusParts {
    connect(&device(&server.address.to_string(), MAP), &VALUES.map(str::to_owned)).unwrap()
}

/// Simulates a welding source that burns while it is on, with all inputs met and a heart-beat.
pub(crate) fn welder(bank: &mut Bank) {
    let on = bank.coils[1];
    (bank.discrete[0], bank.discrete[3], bank.discrete[8], bank.discrete[9]) = (true, true, true, on);
    bank.input[40] = 1 << 9;
    bank.input[10] = if on { bank.holding[0] } else { 0 };
    bank.input[0] = bank.input[0].wrapping_add(1);
}
