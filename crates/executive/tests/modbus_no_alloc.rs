//! A cycle that exchanges with a Modbus device allocates nothing, whether the device answers, is silent or returns.

#[path = "support/modbus_cell.rs"]
mod modbus_cell;
#[path = "support/modbus_server.rs"]
mod modbus_server;

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use modbus_cell::{PERIOD_S, parts, welder};
use modbus_server::TestServer;
use seamwright_executive::devices::{InputBits, Inputs as _, Source as _};
use seamwright_executive::{ProcessOrders, SourceReport, Watchdog};
use std::time::Duration;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

#[test]
fn an_exchange_costs_no_allocation() {
    let mut server = TestServer::new(welder);
    let parts = parts(&server);
    let (mut source, mut inputs) = (parts.source.unwrap(), parts.inputs.unwrap());
    let (mut report, mut bits) = (SourceReport::default(), InputBits::default());
    let (mut fresh, mut old) = (0, 0);
    for k in 0..600u32 {
        match k {
            200 => server.stop(),
            300 => server.start(),
            _ => {}
        }
        let mut orders = ProcessOrders { gas: true, on: k % 50 > 10, ..ProcessOrders::default() };
        orders.values[0] = f64::from(k % 70);
        let watchdog = Watchdog { toggle: k % 2 == 0, late: k % 100 > 80 };
        assert_no_alloc(|| {
            source.exchange(&orders, watchdog, &mut report);
            inputs.exchange(watchdog, &mut bits);
            if bits.age_s < 0.05 { fresh += 1 } else { old += 1 }
        });
        std::thread::sleep(Duration::from_secs_f64(PERIOD_S));
    }
    assert_eq!(violation_count(), 0);
    assert!(fresh > 20 && old > 20 && report.starts > 1, "{fresh} {old} {report:?}");
}
