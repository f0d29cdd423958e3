//! Modbus TCP against a server in this process: its particular behaviour.

use crate::modbus_cell::{MAP, PERIOD_S, VALUES, device, parts, welder};
use crate::modbus_server::{Bank, TestServer};
use seamwright_executive::devices::modbus::{
    ModbusInputs, ModbusParts, ModbusSource, RegisterInspector, connect, write_safe_outputs,
};
use seamwright_executive::devices::{InputBits, Inputs as _, Source as _};
use seamwright_executive::{ProcessOrders, SourceReport, Watchdog};
use std::time::{Duration, Instant};

/// A cycle over connected devices.
struct Cell {
    source: ModbusSource,
    inputs: ModbusInputs,
    orders: ProcessOrders,
    report: SourceReport,
    bits: InputBits,
    watchdog: Watchdog,
}

impl Cell {
    fn new(parts: ModbusParts) -> Self {
        Self {
            source: parts.source.unwrap(),
            inputs: parts.inputs.unwrap(),
            orders: ProcessOrders { values: [f64::NAN; 16], ..ProcessOrders::default() },
            report: SourceReport { age_s: f64::INFINITY, ..SourceReport::default() },
            bits: InputBits::default(),
            watchdog: Watchdog::default(),
        }
    }

    /// A cell with a map of its own.
    fn on(server: &TestServer, map: &str) -> Self {
        Self::new(connect(&device(&server.address.to_string(), map), &VALUES.map(str::to_owned)).unwrap())
    }

    fn cycle(&mut self) {
        self.watchdog = self.watchdog.next(self.watchdog.late);
        self.source.exchange(&self.orders, self.watchdog, &mut self.report);
        self.inputs.exchange(self.watchdog, &mut self.bits);
    }

    /// Runs so many cycles of 1 ms, each followed by `check`.
    fn cycles(&mut self, count: usize, mut check: impl FnMut()) {
        for _ in 0..count {
            self.cycle();
            std::thread::sleep(Duration::from_millis(1));
            check();
        }
    }

    /// Runs cycles of 1 ms until `done`, for up to 5 s.
    fn until(&mut self, what: &str, mut done: impl FnMut(&Self) -> bool) {
        for _ in 0..5000 {
            self.cycle();
            if done(self) {
                return;
            }
            std::thread::sleep(Duration::from_secs_f64(PERIOD_S));
        }
        panic!("not within 5 s: {what}");
    }

    fn strike(&mut self, current: f64) {
        self.until("ready", |c| c.report.ready && c.report.age_s < 0.05);
        (self.orders.on, self.orders.gas) = (true, true);
        (self.orders.values[0], self.orders.values[1]) = (current, 7.5);
        self.until("burning", |c| c.report.burning);
    }
}

/// Waits until the server's tables meet `done`.
fn eventually(server: &TestServer, what: &str, done: impl Fn(&Bank) -> bool) {
    for _ in 0..2500 {
        if done(&server.bank()) {
            return;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("not within 5 s: {what}");
}

/// The safe states of the map: gas open, arc off, 5 A (50 tenths), wire at 0.
fn is_safe(bank: &Bank) -> bool {
    bank.coils[0] && !bank.coils[1] && bank.holding[0] == 50 && bank.holding[2..4] == [0, 0]
}

#[test]
fn orders_are_coded_as_the_map_says() {
    let server = TestServer::new(welder);
    let mut cell = Cell::new(parts(&server));
    assert!(is_safe(&server.bank()), "safe before the first cycle");
    cell.strike(123.4);
    cell.until("actual current", |c| (c.report.values[0] - 123.4).abs() < 1e-9);
    assert!(cell.report.values[1].is_nan(), "nothing measures the wire");
    {
        let bank = server.bank();
        // 7.5 is 0x40F00000, the low word first.
        assert_eq!((bank.holding[0], &bank.holding[2..4]), (1234, &[0, 0x40f0][..]));
        assert!(bank.coils[0] && bank.coils[1]);
    }
    // Values no longer requested go to their safe value.
    (cell.orders.values[0], cell.orders.on) = (f64::NAN, false);
    cell.until("off", |c| !c.report.burning);
    eventually(&server, "safe current", |b| b.holding[0] == 50);
    assert_eq!(cell.bits.bits, 0b111);
    server.bank().works = |_| {};
    {
        let mut bank = server.bank();
        (bank.discrete[3], bank.discrete[10], bank.input[1]) = (false, true, 17);
    }
    server.bank().works = |b| b.input[0] += 1;
    cell.until("changed reports", |c| c.bits.bits == 0b101 && c.report.stuck && c.report.fault == 17);
}

#[test]
fn outputs_are_safe_without_a_cycle() {
    // The cycle stands still, and continues as if uninterrupted: the arc does not.
    let server = TestServer::new(welder);
    let mut cell = Cell::new(parts(&server));
    cell.strike(100.0);
    eventually(&server, "safe states", is_safe);
    let count = server.bank().holding[20];
    std::thread::sleep(Duration::from_millis(50));
    assert_eq!(server.bank().holding[20], count, "the watchdog still changes");
    cell.cycles(200, || assert!(!server.bank().coils[1], "the arc came back by itself"));
    assert!(server.bank().holding[20] != count && server.bank().holding[0] == 1000);
    cell.orders.on = false;
    cell.cycle();
    cell.strike(100.0);
    // The cell is dropped.
    drop(cell);
    assert!(is_safe(&server.bank()));

    // The thread of the cycle panics.
    let mut cell = Cell::new(parts(&server));
    cell.strike(100.0);
    assert!(server.bank().coils[1]);
    let panicked = std::thread::spawn(move || {
        cell.cycle();
        panic!("as it should");
    });
    assert!(panicked.join().is_err());
    assert!(is_safe(&server.bank()));
}

/// The connection is lost and made again while the arc is ordered. The arc is off, and stays off until it was ordered
/// off.
#[test]
fn a_new_connection_begins_without_arc() {
    let mut server = TestServer::new(welder);
    let mut cell = Cell::new(parts(&server));
    for round in 2..5 {
        cell.strike(100.0);
        // Too short for the ages to show: the count of starts does.
        server.stop();
        server.start();
        cell.until("a new start", |c| c.report.starts == round && c.bits.starts == round);
        cell.cycles(100, || assert!(!server.bank().coils[1], "the arc came back by itself"));
        assert_eq!(server.bank().holding[0], 1000);
        cell.orders.on = false;
        cell.cycle();
    }
}

#[test]
fn the_watchdog_counts_and_a_bit_toggles() {
    for (map, toggles) in [(MAP.to_owned(), false), (MAP.replace("{ holding = 20 }", "{ coil = 7 }"), true)] {
        let server = TestServer::new(welder);
        let mut cell = Cell::on(&server, &map);
        let mut seen = Vec::new();
        cell.cycles(200, || {
            let bank = server.bank();
            seen.push(if toggles { u16::from(bank.coils[7]) } else { bank.holding[20] });
        });
        seen.dedup();
        assert!(seen.len() > 5, "{seen:?}");
        assert!(toggles || seen.windows(2).all(|w| w[1] > w[0]), "{seen:?}");
    }
}

/// Without a watchdog nothing is written while nothing changes. A poll is two requests: discrete inputs, and input
/// registers that lie near each other.
#[test]
fn only_what_changes_is_written() {
    let server = TestServer::new(welder);
    let map = MAP.replace("watchdog = { holding = 20 }", "");
    let device = device(&server.address.to_string(), &map);
    let parts = connect(&device, &VALUES.map(str::to_owned)).unwrap();
    let traffic = parts.traffic.clone();
    let mut cell = Cell::new(parts);
    cell.strike(100.0);
    cell.until("written", |_| server.bank().holding[0] == 1000);
    let counts = || {
        let bank = server.bank();
        (bank.writes, bank.reads)
    };
    let ((writes, reads), polls) = (counts(), traffic.get().polls);
    cell.cycles(200, || ());
    let polled = (traffic.get().polls - polls) as usize;
    assert_eq!(counts().0, writes);
    // One more may be in transit.
    let read = counts().1 - reads;
    assert!(polled > 10 && read.abs_diff(2 * polled) <= 2, "{read} requests in {polled} polls");
    cell.orders.values[1] = 8.0;
    cell.until("one more", |_| counts().0 == writes + 1);
    assert_eq!(traffic.get().connections, 1);
}

/// A device with missing registers between two others gets a request for each alone.
#[test]
fn gaps_that_are_not_there() {
    let server = TestServer::new(welder);
    server.bank().holes = (2..10).chain(11..40).collect();
    let map = MAP
        .replace("wire_m_min = { holding = 2,", "wire_m_min = { holding = 50,")
        .replace("{ holding = 20 }", "{ holding = 52 }");
    let mut cell = Cell::on(&server, &map);
    cell.strike(100.0);
    assert_eq!(cell.bits.bits, 0b111);
}

/// A constant heart-beat counts as silence; the connection stays.
#[test]
fn a_heartbeat_that_stops() {
    let server = TestServer::new(welder);
    let mut cell = Cell::new(parts(&server));
    cell.until("fresh", |c| c.report.age_s < 0.01);
    server.bank().works = |_| {};
    cell.until("old", |c| c.report.age_s > 0.3);
    assert_eq!(cell.report.starts, 1);
    server.bank().works = welder;
    cell.until("fresh again", |c| c.report.age_s < 0.01);
    assert_eq!(cell.report.starts, 1);
}

/// A refused write is reported as silence, because the device does not execute its orders.
#[test]
fn a_device_that_takes_no_orders() {
    let server = TestServer::new(welder);
    let parts = parts(&server);
    let traffic = parts.traffic.clone();
    let mut cell = Cell::new(parts);
    cell.strike(100.0);
    server.bank().holes.insert(0);
    server.bank().works = |b| b.input[0] = b.input[0].wrapping_add(1);
    cell.orders.values[0] = 90.0;
    cell.until("old", |c| c.report.age_s > 0.3);
    let told = traffic.get().trouble.unwrap().to_string();
    assert!(told.contains("holding 0") || told.contains("input 0"), "{told}");
    server.bank().holes.clear();
    cell.until("fresh again", |c| c.report.age_s < 0.01);
    eventually(&server, "written in the end", |b| b.holding[0] == 900);
}

/// While the device refuses another output, off does not wait for the next poll: the median time is far shorter than
/// a poll.
#[test]
fn off_does_not_wait_for_the_poll_while_another_output_is_refused() {
    let server = TestServer::new(welder);
    let map = MAP.replace("poll_hz = 200", "poll_hz = 20");
    let mut cell = Cell::on(&server, &map);
    let mut took_s = Vec::new();
    for _ in 0..15 {
        cell.strike(100.0);
        server.bank().holes.insert(0);
        cell.orders.values[0] = 90.0;
        // The write is refused.
        cell.cycles(20, || ());
        assert!(server.bank().coils[1]);
        cell.orders.on = false;
        let ordered = Instant::now();
        cell.until("off", |_| !server.bank().coils[1]);
        took_s.push(ordered.elapsed().as_secs_f64());
        server.bank().holes.clear();
        cell.until("out", |c| c.report.ready && !c.report.burning);
    }
    took_s.sort_by(f64::total_cmp);
    assert!(took_s[7] < 0.01, "off after {took_s:?} s");
}

#[test]
fn what_cannot_be_connected() {
    let server = TestServer::new(welder);
    let values = VALUES.map(str::to_owned);
    let told = |map: &str, values: &[String]| {
        connect(&device(&server.address.to_string(), map), values).unwrap_err().to_string()
    };
    let error = told(MAP, &["voltage_v".to_owned()]);
    assert!(error.contains("`io`") && error.contains("voltage_v"), "{error}");
    server.bank().holes.insert(40);
    let error = told(MAP, &values);
    assert!(error.contains("input 40") && error.contains("inputs.gas_ok"), "{error}");
    server.bank().holes.clear();
    server.silence(true);
    let error = told(MAP, &values);
    assert!(error.contains("no answer within 0.5 s"), "{error}");
    let address = server.address.to_string();
    drop(server);
    let error = connect(&device(&address, MAP), &values).unwrap_err().to_string();
    assert!(error.contains(&address) && error.contains("refused"), "{error}");
}

/// A look reads all registers and writes none; missing registers are reported by name.
#[test]
fn looking_changes_nothing() {
    let server = TestServer::new(welder);
    {
        let mut bank = server.bank();
        bank.holes.insert(10);
        (bank.holding[0], bank.coils[0]) = (777, true);
    }
    let mut inspector = RegisterInspector::new(&device(&server.address.to_string(), MAP));
    inspector.look().unwrap();
    assert_eq!(server.bank().writes, 0);
    let row = |name: &str| inspector.rows().find(|row| row.register.name == name).unwrap();
    let current = row("set.current_a");
    assert_eq!(current.raw.map(f64::to_bits), Some(777f64.to_bits()));
    assert!((current.value.unwrap() - 77.7).abs() < 1e-12 && current.age_s < 5.0 && current.register.unit == "a");
    assert_eq!(row("outputs.gas").value.map(f64::to_bits), Some(1f64.to_bits()));
    let actual = row("actual.current_a");
    assert!(
        actual.raw.is_none() && actual.age_s.is_infinite() && actual.trouble.unwrap().to_string().contains("input 10")
    );
    assert!(row("reports.fault").raw.is_some(), "its neighbours are read all the same");
}

/// An order to switch off does not wait for the answer to a read request. Requests stay unanswered, and off arrives
/// long before their time-out.
#[test]
fn off_waits_for_no_answer_to_a_question() {
    let server = TestServer::new(welder);
    let map = MAP.replace("timeout_s = 0.5", "timeout_s = 1").replace("watchdog_s = 0.4", "watchdog_s = 2");
    let mut cell = Cell::on(&server, &map);
    for _ in 0..3 {
        cell.strike(100.0);
        let reads = server.bank().reads;
        server.mute(true);
        // A read request is in transit.
        cell.until("silence", |c| c.report.age_s > 0.05);
        cell.orders.on = false;
        let ordered = Instant::now();
        cell.until("off", |_| !server.bank().coils[1]);
        let took = ordered.elapsed().as_secs_f64();
        assert!(took < 0.7, "off after {took} s");
        assert!(server.bank().reads <= reads + 4, "questions were answered");
        server.mute(false);
    }
}

/// A device that accepts only one connection is reported at the start, with the cure; with `connections = 1` it
/// works.
#[test]
fn a_device_that_takes_one_connection() {
    let server = TestServer::single(welder);
    let values = VALUES.map(str::to_owned);
    let two = device(&server.address.to_string(), MAP);
    let error = connect(&two, &values).unwrap_err().to_string();
    assert!(error.contains("connections = 1"), "{error}");
    // Another server: this one may not have noticed yet that it is free.
    let server = TestServer::single(welder);
    let map = MAP.replace("unit = 1", "unit = 1\nconnections = 1");
    let parts = connect(&device(&server.address.to_string(), &map), &values).unwrap();
    let traffic = parts.traffic.clone();
    let mut cell = Cell::new(parts);
    cell.strike(100.0);
    cell.orders.on = false;
    cell.until("off", |_| !server.bank().coils[1]);
    cell.strike(100.0);
    // It answers slowly: a report's answer is in transit when the cell ends.
    server.bank().works = |bank| {
        std::thread::sleep(Duration::from_millis(10));
        welder(bank);
    };
    let reads = server.bank().reads;
    cell.until("a slow answer", |_| server.bank().reads > reads);
    drop(cell);
    assert!(is_safe(&server.bank()));
    assert_eq!((traffic.get().connections, traffic.get().safe), (1, Some(Ok(()))));
}

/// Ages follow the clock: after a standstill the reports are old, although no cycle was counted.
#[test]
fn reports_grow_old_while_no_cycle_comes() {
    let server = TestServer::new(welder);
    let mut cell = Cell::new(parts(&server));
    cell.until("fresh", |c| c.report.age_s < 0.05 && c.bits.age_s < 0.05);
    server.silence(true);
    std::thread::sleep(Duration::from_millis(400));
    cell.cycle();
    assert!(cell.report.age_s > 0.3 && cell.bits.age_s > 0.3, "{} {}", cell.report.age_s, cell.bits.age_s);
}

/// A failure to reach the safe state is reported.
#[test]
fn a_device_that_has_gone_is_not_said_to_be_safe() {
    let mut server = TestServer::new(welder);
    let parts = parts(&server);
    let traffic = parts.traffic.clone();
    let mut cell = Cell::new(parts);
    cell.strike(100.0);
    server.stop();
    drop(cell);
    let safe = traffic.get().safe.unwrap();
    assert!(safe.is_err(), "{safe:?}");
}

/// Another process, or the supervisor, writes the safe outputs: also while the connections of the cell are stuck. The
/// watchdog register stays as it is; a refused output does not keep the others from their safe states.
#[test]
fn safe_outputs_over_a_connection_of_their_own() {
    let mut server = TestServer::new(welder);
    let device = device(&server.address.to_string(), MAP);
    let mut cell = Cell::new(parts(&server));
    cell.strike(100.0);
    server.silence_present();
    let count = server.bank().holding[20];
    assert!(count > 0);
    write_safe_outputs(&device).unwrap();
    assert!(is_safe(&server.bank()));
    assert_eq!(server.bank().holding[20], count);

    {
        let mut bank = server.bank();
        (bank.coils[0], bank.coils[1]) = (false, true);
        bank.holes.insert(0);
    }
    let refused = write_safe_outputs(&device).unwrap_err().to_string();
    assert!(refused.contains("holding 0"), "{refused}");
    assert_eq!(server.bank().coils[..2], [true, false]);
    server.stop();
    assert!(write_safe_outputs(&device).is_err());
}
