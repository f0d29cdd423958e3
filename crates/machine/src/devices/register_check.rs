//! Registers with their roles, with an address for every error.

use super::modbus::{
    BitFile, ModbusDevice, ModbusFile, NumberFile, NumberType, Place, Register, Role, Scaled, Table, Word,
};
use crate::file::MachineFile;
use seamwright_document::{Document, DocumentError, Finite, Positive};
use seamwright_message::{Message, Unit};

type File = Document<MachineFile>;

/// The last address of a table.
const LAST: u16 = u16::MAX;
/// Port of Modbus TCP.
const PORT: u16 = 502;

pub(super) fn modbus(file: &File, name: &str, device: &ModbusFile) -> Result<ModbusDevice, DocumentError> {
    let at = format!("devices.{name}.modbus");
    let within = |key: &str, value: Option<Positive>, usual: f64, (low, high): (f64, f64), unit: Unit| {
        let value = value.map_or(usual, Positive::get);
        if (low..=high).contains(&value) {
            return Ok(value);
        }
        Err(file.error_at(&format!("{at}.{key}"), Message::new("machine-out-of-range"), between(low, high, unit)))
    };
    let unit = device.unit.unwrap_or(1);
    if (248..=254).contains(&unit) {
        return Err(file.fault_at(&format!("{at}.unit"), "machine-unit-reserved", "machine-unit-allowed"));
    }
    let registers = registers(file, &at, device)?;
    if registers.is_empty() {
        let message = Message::new("machine-device-without-registers");
        return Err(file.error_at(&at, message, "inputs, outputs, set, reports, actual"));
    }
    if registers.iter().all(|r| matches!(r.role, Role::Watchdog | Role::Heartbeat)) {
        return Err(file.fault_at(&at, "machine-device-without-role", "machine-device-roles"));
    }
    overlaps(file, &at, &registers)?;
    let connections = device.connections.unwrap_or(2);
    if !(1..=2).contains(&connections) {
        let allowed = Message::new("document-whole-number").text("min", "1").text("max", "2");
        return Err(file.error_at(&format!("{at}.connections"), Message::new("machine-out-of-range"), allowed));
    }
    // A command to switch off may wait for a missing answer.
    let switches = registers.iter().any(|r| r.role == Role::On);
    let longest = if switches { 1.0 } else { 5.0 };
    let poll_hz = within("poll_hz", device.poll_hz, 100.0, (20.0, 1000.0), Unit::Hz)?;
    Ok(ModbusDevice {
        name: name.to_owned(),
        address: address(file, &at, &device.address, PORT)?,
        unit,
        poll_s: 1.0 / poll_hz,
        timeout_s: within("timeout_s", device.timeout_s, 0.2, (0.01, longest), Unit::S)?,
        connections,
        watchdog_s: within("watchdog_s", device.watchdog_s, 0.1, (0.01, 2.0), Unit::S)?,
        heartbeat_s: within("heartbeat_s", device.heartbeat_s, 0.5, (0.05, 10.0), Unit::S)?,
        registers,
    })
}

/// Host and port; the default port if none is given.
/// Returns host and port; `usual` is the port if the address has none.
pub(super) fn address(file: &File, at: &str, address: &str, usual: u16) -> Result<String, DocumentError> {
    let bad = |code| file.error_at(&format!("{at}.address"), Message::new(code), Message::new("machine-host-and-port"));
    let host_alone = !address.contains(':') || address.ends_with(']');
    let (host, port) = if host_alone { (address, "1") } else { address.rsplit_once(':').unwrap_or((address, "")) };
    let bracketed = host.starts_with('[') && host.ends_with(']');
    if host.is_empty() || host.chars().any(char::is_whitespace) || (host.contains(':') && !bracketed) {
        return Err(bad("machine-host-missing"));
    }
    match port.parse::<u16>() {
        Ok(1..) => Ok(if host_alone { format!("{host}:{usual}") } else { address.to_owned() }),
        _ => Err(bad("machine-port-missing")),
    }
}

/// All registers, in the order inputs, outputs, set, reports, actual.
fn registers(file: &File, at: &str, device: &ModbusFile) -> Result<Vec<Register>, DocumentError> {
    let mut registers = Vec::new();
    let conditions = &file.value.interlocks;
    for (name, bit) in &device.inputs {
        let Some(condition) = conditions.iter().position(|c| &c.input == name) else {
            let known: Vec<&str> = conditions.iter().map(|c| c.input.as_str()).collect();
            return Err(file.unknown_name(&format!("{at}.inputs.{name}"), name, &known));
        };
        registers.push(bit_register(file, at, format!("inputs.{name}"), Role::Input(condition), bit)?);
    }
    let (outputs, reports) = (&device.outputs, &device.reports);
    for (key, role, bit) in [
        ("outputs.gas", Role::Gas, &outputs.gas),
        ("outputs.on", Role::On, &outputs.on),
        ("outputs.watchdog", Role::Watchdog, &outputs.watchdog),
        ("reports.ready", Role::Ready, &reports.ready),
        ("reports.burning", Role::Burning, &reports.burning),
        ("reports.stuck", Role::Stuck, &reports.stuck),
        ("reports.heartbeat", Role::Heartbeat, &reports.heartbeat),
    ] {
        if let Some(bit) = bit {
            registers.push(bit_register(file, at, key.to_owned(), role, bit)?);
        }
    }
    for (name, number) in &device.set {
        registers.push(number_register(file, at, format!("set.{name}"), Role::Set(name.clone()), number)?);
    }
    if let Some(fault) = &reports.fault {
        let register = number_register(file, at, "reports.fault".to_owned(), Role::Fault, fault)?;
        let plain = |s: Scaled| s.kind == NumberType::U16 && fault.scale.is_none() && fault.offset.get().abs() <= 0.0;
        if !matches!(register.place.word, Word::Number(s) if plain(s)) {
            let message = Message::new("machine-fault-code-type");
            return Err(file.error_at(&format!("{at}.reports.fault"), message, "type = \"u16\""));
        }
        registers.push(register);
    }
    for (name, number) in &device.actual {
        registers.push(number_register(file, at, format!("actual.{name}"), Role::Actual(name.clone()), number)?);
    }
    Ok(registers)
}

/// The single given table, and the address in it.
fn table(file: &File, path: &str, given: &[(Table, Option<u16>)], role: &Role) -> Result<(Table, u16), DocumentError> {
    let writes = role.is_output();
    let allowed: Vec<&str> = given.iter().map(|g| g.0).filter(|t| !writes || may_write(*t)).map(Table::name).collect();
    let allowed = Message::new("machine-exactly-one-of").text("names", allowed.join(", "));
    let mut named = given.iter().filter_map(|(table, at)| at.map(|at| (*table, at)));
    let (Some((table, at)), None) = (named.next(), named.next()) else {
        return Err(file.error_at(path, Message::new("machine-register-tables"), allowed));
    };
    if writes && !may_write(table) {
        let message = Message::new("machine-register-read-only").key("table", table.name());
        return Err(file.error_at(&format!("{path}.{}", table.name()), message, allowed));
    }
    Ok((table, at))
}

fn may_write(table: Table) -> bool {
    matches!(table, Table::Coil | Table::Holding)
}

/// Allowed: values from `low` to `high`.
fn between(low: f64, high: f64, unit: Unit) -> Message {
    Message::new("document-between").value("min", low, unit).value("max", high, unit)
}

fn bit_register(file: &File, at: &str, name: String, role: Role, bit: &BitFile) -> Result<Register, DocumentError> {
    let path = format!("{at}.{name}");
    let given = [
        (Table::Coil, bit.coil),
        (Table::Discrete, bit.discrete),
        (Table::Holding, bit.holding),
        (Table::Input, bit.input),
    ];
    let (table, cell) = table(file, &path, &given, &role)?;
    let key = |key: &str| format!("{path}.{key}");
    let whole = matches!(role, Role::Watchdog | Role::Heartbeat);
    let word = match (table.has_bits(), bit.bit) {
        (true, None) => Word::Single,
        (true, Some(_)) => {
            let message = Message::new("machine-register-single-bit").key("table", table.name());
            return Err(file.error_at(&key("bit"), message, Message::new("machine-bit-with-register")));
        }
        (false, Some(bit @ 0..=15)) => Word::Bit(bit),
        (false, Some(_)) => {
            return Err(file.fault_at(&key("bit"), "machine-register-bits", "machine-bit-allowed"));
        }
        (false, None) if whole => Word::Number(COUNT),
        (false, None) => {
            let message = Message::new("document-missing-key").key("key", "bit");
            return Err(file.error_at(&path, message, Message::new("machine-bit-form")));
        }
    };
    if bit.safe.is_some() && !(role.is_output() && role != Role::Watchdog) {
        return Err(file.fault_at(&key("safe"), "machine-safe-of-input", "machine-safe-with-outputs"));
    }
    if role == Role::On && bit.safe == Some(true) {
        return Err(file.error_at(&key("safe"), Message::new("machine-safe-state-on"), "false"));
    }
    let safe = if bit.safe == Some(true) { 1.0 } else { 0.0 };
    Ok(Register { name, role, place: Place { table, at: cell, word }, safe, unit: String::new() })
}

/// Coding of a register that counts or changes in any way.
const COUNT: Scaled = Scaled { kind: NumberType::U16, order: super::WordOrder::HighFirst, scale: 1.0, offset: 0.0 };

fn number_register(
    file: &File,
    at: &str,
    name: String,
    role: Role,
    number: &NumberFile,
) -> Result<Register, DocumentError> {
    let path = format!("{at}.{name}");
    let given = [(Table::Holding, number.holding), (Table::Input, number.input)];
    let (table, cell) = table(file, &path, &given, &role)?;
    let key = |key: &str| format!("{path}.{key}");
    if number.words.is_some() && number.kind.registers() == 1 {
        return Err(file.fault_at(&key("words"), "machine-words-of-16-bits", "machine-words-with-32-bits"));
    }
    if cell > LAST - (number.kind.registers() - 1) {
        let message = Message::new("machine-register-last");
        let allowed = Message::new("document-at-most").value("max", f64::from(LAST - 1), Unit::One);
        return Err(file.error_at(&key(table.name()), message, allowed));
    }
    let scale = number.scale.map_or(1.0, Finite::get);
    if scale.abs() < f64::MIN_POSITIVE {
        return Err(file.fault_at(&key("scale"), "machine-scale-zero", "machine-not-zero"));
    }
    if number.safe.is_some() && !role.is_output() {
        return Err(file.fault_at(&key("safe"), "machine-safe-of-input", "machine-safe-with-outputs"));
    }
    let scaled =
        Scaled { kind: number.kind, order: number.words.unwrap_or_default(), scale, offset: number.offset.get() };
    let safe = number.safe.map_or(scaled.offset, Finite::get);
    let (low, high) = scaled.range();
    if !(low..=high).contains(&safe) {
        let message = Message::new("machine-safe-out-of-range");
        return Err(file.error_at(&key("safe"), message, between(low, high, Unit::One)));
    }
    let unit = number.unit.clone().unwrap_or_else(|| unit_of(&name));
    Ok(Register { name, role, place: Place { table, at: cell, word: Word::Number(scaled) }, safe, unit })
}

/// Unit from the suffix of a process value's name: `current_a` is in a, `wire_m_min` in m/min.
fn unit_of(name: &str) -> String {
    let tail = name.split_once('_').map_or("", |(_, tail)| tail);
    tail.replace('_', "/")
}

/// Checks that no bit is shared by two registers.
fn overlaps(file: &File, at: &str, registers: &[Register]) -> Result<(), DocumentError> {
    for (i, one) in registers.iter().enumerate() {
        if let Some(other) = registers[..i].iter().find(|other| meet(&one.place, &other.place)) {
            let message = Message::new("machine-register-taken")
                .key("register", &other.name)
                .text("address", other.place.to_string());
            let path = format!("{at}.{}.{}", one.name, one.place.table.name());
            return Err(file.error_at(&path, message, Message::new("machine-own-address")));
        }
    }
    Ok(())
}

/// True if two places share a bit.
fn meet(a: &Place, b: &Place) -> bool {
    let (a_first, b_first) = (u32::from(a.at), u32::from(b.at));
    let apart = a_first + u32::from(a.cells()) <= b_first || b_first + u32::from(b.cells()) <= a_first;
    let bits_apart = matches!((a.word, b.word), (Word::Bit(x), Word::Bit(y)) if x != y);
    a.table == b.table && !apart && !bits_apart
}

/// Checks the roles over all devices: one process source, with supervision; all inputs on one device, each with a
/// register.
pub(super) fn together(file: &File, devices: &[ModbusDevice]) -> Result<(), DocumentError> {
    let at = |device: &ModbusDevice, key: &str| format!("devices.{}.modbus.{key}", device.name);
    let mut with_source = devices.iter().filter(|d| d.registers.iter().any(|r| r.role.is_source()));
    if let (Some(first), Some(second)) = (with_source.next(), with_source.next()) {
        let register = second.registers.iter().find(|r| r.role.is_source()).map_or("", |r| r.name.as_str());
        let message = Message::new("machine-source-taken").text("device", &first.name);
        return Err(file.error_at(&at(second, register), message, Message::new("machine-one-source")));
    }
    for device in devices {
        let has = |role: &Role| device.registers.iter().any(|r| r.role == *role);
        if device.registers.iter().any(|r| r.role.is_source()) {
            for (role, key) in [(Role::On, "outputs.on"), (Role::Burning, "reports.burning")] {
                if !has(&role) {
                    let message = Message::new("machine-source-without-register").key("key", key);
                    return Err(file.error_at(&format!("devices.{}.modbus", device.name), message, key));
                }
            }
        }
    }
    let mut with_inputs = devices.iter().filter(|d| d.registers.iter().any(|r| matches!(r.role, Role::Input(_))));
    let (Some(first), second) = (with_inputs.next(), with_inputs.next()) else { return Ok(()) };
    if let Some(second) = second {
        let message = Message::new("machine-inputs-taken").text("device", &first.name);
        return Err(file.error_at(&at(second, "inputs"), message, Message::new("machine-inputs-on-one-device")));
    }
    for (i, condition) in file.value.interlocks.iter().enumerate() {
        if !first.registers.iter().any(|r| r.role == Role::Input(i)) {
            let message = Message::new("machine-input-without-register")
                .text("input", &condition.input)
                .text("interlock", &condition.name);
            return Err(file.error_at(&at(first, "inputs"), message, Message::new("machine-register-for-every-input")));
        }
    }
    Ok(())
}
