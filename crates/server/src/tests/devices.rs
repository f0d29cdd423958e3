//! A cell whose process source and inputs are on Modbus.

#[path = "../../../executive/tests/support/modbus_server.rs"]
mod modbus_server;
#[path = "../../../executive/tests/support/modbus_welder.rs"]
mod modbus_welder;

use super::lived::{Page, Served};
use super::restored::settings;
use super::{Bench, Visitor, beside_home, cell_start};
use crate::error::Error;
use crate::serve::{Settings, until};
use axum::http::StatusCode;
use modbus_server::TestServer;
use modbus_welder::{MAP, welder};
use seamwright_executive::realtime::{Shutdown, ShutdownCause};
use seamwright_machine::shipped;
use seamwright_record::DataFolder;
use seamwright_record::library::{Query, WeldResult};
use serde_json::{Value, json};
use std::sync::mpsc::channel;
use std::time::{Duration, Instant};

fn machine(address: &str) -> String {
    let machine = shipped("ellipse-xy").unwrap().text;
    format!("{machine}\n[devices.welder.modbus]\naddress = \"{address}\"\ntimeout_s = 1\n{MAP}")
}

/// Creates jobs on the devices of the cell: one complete, one without a voltage, one whose machine file names other
/// devices.
async fn jobs(bench: &Bench, owner: &Visitor, machine: &str) {
    std::fs::write(bench.path().join("jobs/cell.toml"), machine).unwrap();
    let other = machine.replace("coil = 1 }", "coil = 9 }");
    assert_ne!(other, machine);
    std::fs::write(bench.path().join("jobs/other.toml"), other).unwrap();
    let (_, example) = bench.ask(owner.request("GET", "/api/jobs/ellipse.toml", None)).await;
    let text = beside_home(example["text"].as_str().unwrap());
    let real = text.replace("machine = \"ellipse-xy\"", "machine = \"cell.toml\"");
    let plain = real.replace("voltage_v = 12", "");
    assert!(real != text && plain != real);
    let foreign = real.replace("cell.toml", "other.toml");
    for (name, text) in [("real.toml", &real), ("plain.toml", &plain), ("foreign.toml", &foreign)] {
        let path = format!("/api/jobs/{name}");
        let (status, _) = bench.ask(owner.request("PUT", &path, Some(&json!({ "text": text })))).await;
        assert!(status.is_success());
    }
}

async fn simulated(bench: &Bench, owner: &Visitor) -> bool {
    let (_, machine) = bench.ask(owner.request("GET", "/api/machine", None)).await;
    machine["simulated"].as_bool().unwrap()
}

/// Welds until the source has the requested values, then stops and switches the power off.
async fn weld(page: &mut Page, server: &TestServer, holding: [u16; 2]) {
    page.up().await;
    page.weld().await;
    page.until_status("the arc", |v| v["process"]["burning"] == true).await;
    {
        let bank = server.bank();
        assert_eq!((bank.coils[0], bank.coils[1], &bank.holding[..2]), (true, true, &holding[..]));
    }
    page.order("stop").await;
    page.mode("ready").await;
    let over = |v: &Value| v["process"]["burning"] == false && v["process"]["phase"].is_null();
    page.until_status("the end of arc and gas", |v| over(v)).await;
    page.down().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn programs_find_the_devices_they_need() {
    let mut server = TestServer::new(welder);
    let machine = machine(&server.address.to_string());
    let served = Served::bare(tempfile::tempdir().unwrap(), &machine).await;
    let bench = &served.bench;
    let owner = bench.owner().await;
    jobs(bench, &owner, &machine).await;
    // The cell has the devices of the start until a program needs none.
    assert!(!simulated(bench, &owner).await);
    assert!(bench.load(&owner, "ellipse.toml", None).await.0.is_success() && simulated(bench, &owner).await);
    // A job must not choose other devices.
    let (status, refused) = bench.load(&owner, "foreign.toml", None).await;
    assert!(status.is_client_error() && refused["text"].as_str().unwrap().contains("was started"), "{refused}");
    let (status, work) = bench.load(&owner, "real.toml", None).await;
    assert!(status.is_success() && !simulated(bench, &owner).await, "{work}");
    let mut page = served.page(&owner).await;
    weld(&mut page, &server, [900, 1200]).await;
    // Another set of values: the devices are reconnected, and values are not mixed up.
    let (status, work) = bench.load(&owner, "plain.toml", None).await;
    assert!(status.is_success() && !simulated(bench, &owner).await, "{work}");
    weld(&mut page, &server, [900, 0]).await;
    // Devices are not changed while powered.
    page.order("switch_on").await;
    page.until_status("power", |v| v["powered"] == true).await;
    let (status, refused) = bench.load(&owner, "real.toml", None).await;
    assert_eq!((status, &refused["key"]), (StatusCode::CONFLICT, &json!("busy")), "{refused}");
    page.down().await;
    // If they do not answer, no real device is left; the next ones that answer are connected.
    server.stop();
    let (status, refused) = bench.load(&owner, "real.toml", None).await;
    assert!(status.is_client_error() && refused["text"].as_str().unwrap().contains("`welder`"), "{refused}");
    assert!(simulated(bench, &owner).await);
    server.start();
    let (status, work) = bench.load(&owner, "real.toml", None).await;
    assert!(status.is_success() && !simulated(bench, &owner).await, "{work}");
    // A machine without devices releases them: the watchdog is no longer updated.
    let (status, work) = bench.load(&owner, "ellipse.toml", None).await;
    assert!(status.is_success() && simulated(bench, &owner).await, "{work}");
    let reads = server.bank().reads;
    tokio::time::sleep(Duration::from_millis(300)).await;
    assert_eq!(server.bank().reads, reads);
}

/// A signal or a panic anywhere in the program while the arc burns on a real device. The device is safe and the record
/// closed at the end of the cell, without an order from the desk.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_shutdown_in_a_weld_leaves_the_device_safe_and_the_record_closed() {
    for cause in [ShutdownCause::Signal(1), ShutdownCause::Panic] {
        let server = TestServer::new(welder);
        let machine = machine(&server.address.to_string());
        let served = Served::bare(tempfile::tempdir().unwrap(), &machine).await;
        let bench = &served.bench;
        let owner = bench.owner().await;
        jobs(bench, &owner, &machine).await;
        assert!(bench.load(&owner, "real.toml", None).await.0.is_success());
        let mut page = served.page_up(&owner).await;
        page.weld().await;
        page.until_status("travel", |v| v["s_mm"].as_f64().unwrap() > 1.0).await;
        assert!(server.bank().coils[1]);
        bench.shutdown.request(cause);
        page.until("its cause", |v| v["kind"] == "event" && v["key"] == "stopped_by").await;
        let Served { bench, .. } = served;
        let folder = bench.end();
        {
            let bank = server.bank();
            assert!(!bank.coils[0] && !bank.coils[1] && bank.holding[..2] == [0, 0], "{cause}");
        }
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        let welds = data.library().find(&Query::default()).unwrap();
        assert_eq!((welds.len(), welds[0].result), (1, WeldResult::Stopped), "{welds:?}");
        assert!(welds[0].note.to_string().contains(&cause.to_string()), "{}", welds[0].note);
    }
}

/// A device is released for another machine's program and does not answer. The desk continues meanwhile, all pages get
/// a report, and so does the caller of the end.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_device_let_go_without_an_answer_is_reported_and_holds_nobody_up() {
    let server = TestServer::new(welder);
    let machine = machine(&server.address.to_string());
    let served = Served::bare(tempfile::tempdir().unwrap(), &machine).await;
    let bench = &served.bench;
    let owner = bench.owner().await;
    let mut page = served.page(&owner).await;
    page.until_status("a status", |_| true).await;
    server.silence(true);
    let watches = async {
        let (mut last, mut longest) = (Instant::now(), Duration::ZERO);
        loop {
            let told = page
                .until("a status or the report", |v| {
                    v["kind"] == "status" || v["kind"] == "event" && v["key"] == "safe_unconfirmed"
                })
                .await;
            if told["kind"] == "event" {
                assert_eq!(told["arguments"][0][1]["value"], "welder", "{told}");
                return longest;
            }
            longest = longest.max(last.elapsed());
            last = Instant::now();
        }
    };
    let ((status, work), longest) = tokio::join!(bench.load(&owner, "ellipse.toml", None), watches);
    assert!(status.is_success() && simulated(bench, &owner).await, "{work}");
    assert!(longest < Duration::from_secs(2), "the desk stood still for {longest:?}");
    let panel = std::sync::Arc::clone(&bench.panel);
    let unconfirmed = tokio::task::spawn_blocking(move || panel.cell.end()).await.unwrap();
    assert!(unconfirmed.len() == 1 && unconfirmed[0].contains("`welder`"), "{unconfirmed:?}");
}

#[test]
fn the_panel_ends_with_an_error_if_a_device_does_not_confirm_its_safe_outputs() {
    for silent in [false, true] {
        let server = TestServer::new(welder);
        let folder = tempfile::tempdir().unwrap();
        let machine = cell_start(folder.path(), &machine(&server.address.to_string())).machine;
        let of = Settings { machine, job: None, ..settings(folder.path()) };
        let (ready, is_ready) = channel();
        let shutdown = Shutdown::default();
        let ends = shutdown.clone();
        let served = std::thread::spawn(move || until(&of, |_| ready.send(()).unwrap(), &ends));
        is_ready.recv_timeout(Duration::from_secs(60)).unwrap();
        server.silence(silent);
        shutdown.request(ShutdownCause::Signal(15));
        let ended = served.join().unwrap();
        if silent {
            let Err(Error::System(message)) = ended else { panic!("{ended:?}") };
            let text = message.to_string();
            assert!(text.contains("device `welder`: its outputs are not confirmed to be safe"), "{text}");
        } else {
            ended.unwrap();
        }
    }
}
