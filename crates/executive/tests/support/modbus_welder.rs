//! A welding source with inputs on the test server, for the machine of the example ellipse.

use super::modbus_server::Bank;

/// Registers of the source, as in a machine file.
pub(crate) const MAP: &str = r#"
[devices.welder.modbus.inputs]
e_stop_ok = { discrete = 0 }
curtain_clear = { discrete = 1 }
gas_ok = { discrete = 2 }
[devices.welder.modbus.outputs]
gas = { coil = 0 }
on = { coil = 1 }
watchdog = { coil = 2 }
[devices.welder.modbus.set]
current_a = { holding = 0, scale = 0.1 }
voltage_v = { holding = 1, scale = 0.01 }
[devices.welder.modbus.reports]
burning = { discrete = 4 }
"#;

/// Behaviour of the source itself.
pub(crate) fn welder(bank: &mut Bank) {
    bank.discrete[..3].fill(true);
    bank.discrete[4] = bank.coils[1];
}
