use crate::wire::{DeviceView, SignalView, Status, TrafficView};
use seamwright_executive::devices::Traffic;
use seamwright_machine::{Machine, ModbusDevice, Register, Role, Word};

/// Returns the devices with the last known values of their signals; `values` are the names of the program's process
/// values.
pub(crate) fn device_views(
    machine: &Machine,
    lines: &[(String, Traffic)],
    values: &[String],
    status: Option<&Status>,
) -> Vec<DeviceView> {
    let views = machine.devices.modbus.iter().map(|device| {
        let line = lines.iter().find(|(name, _)| *name == device.name);
        device_view(machine, device, line.map(|(_, line)| traffic(line)), values, status)
    });
    views.collect()
}

fn device_view(
    machine: &Machine,
    device: &ModbusDevice,
    traffic: Option<TrafficView>,
    values: &[String],
    status: Option<&Status>,
) -> DeviceView {
    let signal = |register: &Register| {
        let condition = match register.role {
            Role::Input(i) => machine.interlocks.get(i),
            _ => None,
        };
        SignalView {
            name: register.name.clone(),
            kind: kind(&register.role).to_owned(),
            place: register.place.to_string(),
            bit: !matches!(register.place.word, Word::Number(_)),
            unit: register.unit.clone(),
            value: status.and_then(|status| value(&register.role, values, status)),
            safe: register.role.is_output().then_some(register.safe),
            wanted: condition.map(|c| c.is),
            condition: condition.map(|c| c.name.clone()),
        }
    };
    DeviceView {
        name: device.name.clone(),
        address: device.address.clone(),
        unit: device.unit,
        poll_s: device.poll_s,
        watchdog_s: device.watchdog_s,
        signals: device.registers.iter().map(signal).collect(),
        traffic,
    }
}

pub(crate) fn simulated_view(machine: &Machine, values: &[String], status: Option<&Status>) -> DeviceView {
    let has = |wanted: fn(&Role) -> bool| {
        machine.devices.modbus.iter().flat_map(|d| &d.registers).any(|register| wanted(&register.role))
    };
    let signal = |role: Role, name: String, unit: &str| SignalView {
        name,
        kind: kind(&role).to_owned(),
        place: String::new(),
        bit: !matches!(role, Role::Set(_) | Role::Actual(_) | Role::Fault),
        unit: unit.to_owned(),
        value: status.and_then(|status| value(&role, values, status)),
        safe: role.is_output().then_some(0.0),
        wanted: None,
        condition: None,
    };
    let mut signals = Vec::new();
    if !has(|role| matches!(role, Role::Input(_))) {
        signals.extend(machine.interlocks.iter().enumerate().map(|(i, condition)| SignalView {
            wanted: Some(condition.is),
            condition: Some(condition.name.clone()),
            ..signal(Role::Input(i), format!("inputs.{}", condition.input), "")
        }));
    }
    if !has(Role::is_source) {
        signals.push(signal(Role::Gas, "outputs.gas".to_owned(), ""));
        signals.push(signal(Role::On, "outputs.on".to_owned(), ""));
        signals.extend(values.iter().map(|name| signal(Role::Set(name.clone()), format!("set.{name}"), "")));
        signals.push(signal(Role::Ready, "reports.ready".to_owned(), ""));
        signals.push(signal(Role::Burning, "reports.burning".to_owned(), ""));
        signals.push(signal(Role::Stuck, "reports.stuck".to_owned(), ""));
        signals.push(signal(Role::Fault, "reports.fault".to_owned(), ""));
        signals.extend(values.iter().map(|name| signal(Role::Actual(name.clone()), format!("actual.{name}"), "")));
    }
    DeviceView { poll_s: machine.servo_period_s, signals, ..DeviceView::default() }
}

fn kind(role: &Role) -> &'static str {
    match role {
        Role::Input(_) => "input",
        Role::Gas | Role::On | Role::Watchdog => "output",
        Role::Set(_) => "set",
        Role::Ready | Role::Burning | Role::Stuck | Role::Fault | Role::Heartbeat => "report",
        Role::Actual(_) => "actual",
    }
}

/// Returns the last ordered or reported value of a signal.
fn value(role: &Role, values: &[String], status: &Status) -> Option<f64> {
    let process = &status.process;
    let of = |name: &String, list: &[Option<f64>]| {
        values.iter().position(|v| v == name).and_then(|i| list.get(i).copied().flatten())
    };
    let bit = |on: bool| Some(f64::from(u8::from(on)));
    match role {
        Role::Input(i) => status.inputs.get(*i).copied().and_then(bit),
        Role::Gas => bit(process.gas),
        Role::On => bit(process.on),
        Role::Ready => bit(process.ready),
        Role::Burning => bit(process.burning),
        Role::Stuck => bit(process.stuck),
        Role::Fault => Some(f64::from(process.fault)),
        Role::Set(name) => of(name, &process.set),
        Role::Actual(name) => of(name, &process.measured),
        // They change with every poll.
        Role::Watchdog | Role::Heartbeat => None,
    }
}

fn traffic(traffic: &Traffic) -> TrafficView {
    let round = &traffic.round;
    TrafficView {
        polls: traffic.polls,
        missed: traffic.missed,
        failed: traffic.failed,
        connections: traffic.connections,
        away_s: traffic.away_s,
        round_us: [round.quantile_us(0.5), round.quantile_us(0.999), round.most_us()],
        trouble: traffic.trouble.as_ref().map(ToString::to_string),
    }
}
