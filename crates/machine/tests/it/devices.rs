//! `[devices]` of the machine file: parsing, and refusal of invalid entries.

use seamwright_machine::{Machine, ModbusDevice, NumberType, Role, Table, Word, WordOrder, shipped};

const MAP: &str = r#"
[devices.io.modbus]
address = "127.0.0.1:5020"
[devices.io.modbus.inputs]
e_stop_ok = { discrete = 0 }
curtain_clear = { discrete = 1 }
gas_ok = { input = 5, bit = 15 }
[devices.io.modbus.outputs]
gas = { coil = 0, safe = true }
on = { holding = 9, bit = 0 }
watchdog = { holding = 65535 }
[devices.io.modbus.set]
current_a = { holding = 0, scale = 0.1, safe = 2 }
wire_m_min = { holding = 65533, type = "f32", words = "low_first" }
[devices.io.modbus.reports]
burning = { discrete = 2 }
heartbeat = { holding = 9, bit = 1 }
fault = { input = 6 }
[devices.io.modbus.actual]
current_a = { input = 7, type = "i32", offset = -20, unit = "A" }
"#;

fn read(map: &str) -> Result<Vec<ModbusDevice>, String> {
    let text = format!("{}{map}", shipped("ellipse-xy").unwrap().text);
    Machine::read("m.toml", &text).map(|m| m.devices.modbus).map_err(|e| {
        assert!(e.line > 0 || e.key.is_empty(), "{e}");
        e.to_string()
    })
}

#[test]
fn a_map_is_read_as_it_is_written() {
    assert!(read("").unwrap().is_empty(), "without [devices] all is simulated");
    let device = read(MAP).unwrap().remove(0);
    assert_eq!((device.name.as_str(), device.address.as_str(), device.unit), ("io", "127.0.0.1:5020", 1));
    assert!((device.poll_s - 0.01).abs() < 1e-15 && (device.timeout_s - 0.2).abs() < 1e-15);
    let find = |name: &str| device.registers.iter().find(|r| r.name == name).unwrap();
    assert_eq!(find("inputs.gas_ok").role, Role::Input(2));
    assert_eq!(find("inputs.gas_ok").place.word, Word::Bit(15));
    let wire = find("set.wire_m_min");
    assert_eq!(
        (wire.place.table, wire.place.at, wire.place.cells(), wire.unit.as_str()),
        (Table::Holding, 65533, 2, "m/min")
    );
    let Word::Number(number) = wire.place.word else { panic!() };
    assert_eq!((number.kind, number.order), (NumberType::F32, WordOrder::LowFirst));
    assert!((find("set.current_a").safe - 2.0).abs() < 1e-15 && (find("outputs.gas").safe - 1.0).abs() < 1e-15);
    assert!((find("outputs.on").safe).abs() < 1e-15);
    assert_eq!((find("set.current_a").unit.as_str(), find("actual.current_a").unit.as_str()), ("a", "A"));
    assert_eq!(device.registers.len(), 12);
    for (given, is) in
        [("box", "box:502"), ("box:1502", "box:1502"), ("[fe80::1]", "[fe80::1]:502"), ("[::1]:5", "[::1]:5")]
    {
        assert_eq!(read(&MAP.replace("127.0.0.1:5020", given)).unwrap()[0].address, is);
    }
}

#[test]
fn what_cannot_be_is_refused_with_its_address() {
    let io = "devices.io.modbus.";
    for (from, to, key, words) in [
        // Addresses.
        (
            "{ discrete = 1 }",
            "{ discrete = 0 }",
            "inputs.e_stop_ok.discrete",
            "`inputs.curtain_clear` is at discrete 0 already",
        ),
        ("holding = 0,", "holding = 65532, type = \"u32\",", "set.wire_m_min.holding", "already"),
        ("holding = 0,", "holding = 9,", "set.current_a.holding", "`outputs.on` is at holding 9 bit 0 already"),
        ("holding = 9, bit = 1", "holding = 9, bit = 0", "reports.heartbeat.holding", "already"),
        ("holding = 65533", "holding = 65535", "set.wire_m_min.holding", "up to 65534"),
        ("discrete = 1 ", "discrete = 65536 ", "inputs.curtain_clear", "0 to 65535"),
        ("discrete = 1 ", "discrete = -1 ", "inputs.curtain_clear", "0 to 65535"),
        ("{ discrete = 1 }", "{ discrete = 1, coil = 1 }", "inputs.curtain_clear", "exactly one of coil, discrete"),
        ("{ discrete = 1 }", "{}", "inputs.curtain_clear", "exactly one of"),
        ("input = 5, bit = 15", "input = 5, bit = 16", "inputs.gas_ok.bit", "0 (lowest) to 15"),
        ("input = 5, bit = 15", "input = 5", "inputs.gas_ok", "`bit` is missing"),
        ("{ discrete = 1 }", "{ discrete = 1, bit = 0 }", "inputs.curtain_clear.bit", "single bit"),
        // Written registers, and safe states.
        ("coil = 0, safe", "discrete = 9, safe", "outputs.gas.discrete", "exactly one of coil, holding"),
        ("holding = 0, scale", "input = 0, scale", "set.current_a.input", "can only be read"),
        ("{ discrete = 1 }", "{ discrete = 1, safe = true }", "inputs.curtain_clear.safe", "only outputs"),
        ("holding = 9, bit = 0 }", "holding = 9, bit = 0, safe = true }", "outputs.on.safe", "allowed: false"),
        ("safe = 2", "safe = 7000", "set.current_a.safe", "0 to 6553.5"),
        ("holding = 65535 }", "holding = 65535, safe = true }", "outputs.watchdog.safe", "only outputs"),
        // Numbers.
        ("type = \"f32\"", "type = \"f64\"", "set.wire_m_min.type", "u16, i16, u32, i32, f32"),
        ("type = \"f32\", ", "", "set.wire_m_min.words", "u32, i32 and f32"),
        ("scale = 0.1", "scale = 0", "set.current_a.scale", "any number but 0"),
        ("fault = { input = 6 }", "fault = { input = 10, type = \"f32\" }", "reports.fault", "u16"),
        ("unit = \"A\"", "units = \"A\"", "actual.current_a", "did you mean `unit`"),
        // Roles.
        ("curtain_clear = ", "curtain_cler = ", "inputs.curtain_cler", "did you mean `curtain_clear`"),
        ("curtain_clear = { discrete = 1 }", "", "inputs", "`light curtain` has no register"),
        ("burning = { discrete = 2 }", "", "devices.io.modbus", "reports.burning"),
        ("on = { holding = 9, bit = 0 }", "", "devices.io.modbus", "outputs.on"),
        // The device.
        ("127.0.0.1:5020", "127.0.0.1:70000", "address", "port from 1 to 65535"),
        ("127.0.0.1:5020", "fe80::1:502", "address", "[fe80::1]:502"),
        ("127.0.0.1:5020", "", "address", "host:port"),
        ("address = ", "unit = 250\naddress = ", "unit", "0 to 247, or 255"),
        ("address = ", "unit = 300\naddress = ", "unit", "0 to 255"),
        ("address = ", "poll_hz = 5\naddress = ", "poll_hz", "20 Hz to 1000 Hz"),
        ("address = ", "poll_hz = 20000\naddress = ", "poll_hz", "20 Hz to 1000 Hz"),
        ("address = ", "timeout_s = 1.5\naddress = ", "timeout_s", "0.01 s to 1 s"),
        ("address = ", "connections = 3\naddress = ", "connections", "from 1 to 2"),
        ("address = ", "watchdog_s = 0.001\naddress = ", "watchdog_s", "0.01 s to 2 s"),
        ("address = ", "heartbeat_s = 0\naddress = ", "heartbeat_s", "greater than 0"),
        ("address = \"127.0.0.1:5020\"", "", "address", "missing"),
        ("address = ", "slave = 2\naddress = ", "devices.io.modbus", "no key `slave`"),
    ] {
        assert!(MAP.contains(from), "{from}");
        let error = read(&MAP.replacen(from, to, 1)).unwrap_err();
        let full = if key.starts_with("devices") { key.to_owned() } else { format!("{io}{key}") };
        assert!(error.contains(&full) && error.contains("m.toml:"), "{from} -> {to}: {full} in\n{error}");
        assert!(error.contains(words), "{from} -> {to}: {words} in\n{error}");
    }
}

#[test]
fn roles_are_there_once_over_all_devices() {
    let second = MAP.replace("devices.io", "devices.more");
    let error = read(&format!("{MAP}{second}")).unwrap_err();
    assert!(error.contains("devices.more.modbus") && error.contains("one process source"), "{error}");
    let only_inputs = |text: &str| {
        let (head, tail) = text.split_at(text.find("[devices.more.modbus.outputs]").unwrap());
        assert!(!tail.is_empty());
        head.to_owned()
    };
    let error = read(&format!("{MAP}{}", only_inputs(&second))).unwrap_err();
    assert!(error.contains("all inputs on one device"), "{error}");
    // Inputs on one, the source on the other.
    let source = MAP.split_once("[devices.io.modbus.outputs]").unwrap().1;
    let source = format!("[devices.io.modbus]\naddress = \"a:1\"\n[devices.io.modbus.outputs]{source}");
    assert_eq!(read(&format!("{source}{}", only_inputs(&second))).unwrap().len(), 2);
    let error = read("\n[devices.io.modbus]\naddress = \"a:1\"\noutputs.watchdog = { coil = 1 }\n").unwrap_err();
    assert!(error.contains("neither process source nor has inputs"), "{error}");
    let error = read("\n[devices.io]\n").unwrap_err();
    assert!(error.contains("devices.io") && error.contains("none is given"), "{error}");
}

#[test]
fn the_documented_map_is_read() {
    let page = include_str!("../../../../docs/reference/machine.md");
    let map = page.split("```toml").find(|block| block.trim_start().starts_with("[devices.")).unwrap();
    let map = map.split("```").next().unwrap();
    let device = read(&format!("\n{map}")).unwrap().remove(0);
    assert_eq!((device.name.as_str(), device.registers.len()), ("welder", 14));
}
