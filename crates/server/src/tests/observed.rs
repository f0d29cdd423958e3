//! Health, readiness, metrics and diagnostics of a running cell.

use super::lived::Served;
use super::{Bench, HOST, MONITOR_TOKEN, Visitor};
use crate::diagnostics::{Family, parse};
use axum::body::Body;
use axum::extract::ConnectInfo;
use axum::http::{Request, StatusCode};
use http_body_util::BodyExt as _;
use serde_json::Value;
use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::TcpStream;

/// Longer than any step takes on a busy computer.
const LONG: Duration = Duration::from_secs(60);

/// Asks as a monitoring tool on this computer does.
async fn get(address: &str, path: &str) -> (u16, String) {
    let mut stream = TcpStream::connect(address).await.unwrap();
    let head = format!("GET {path} HTTP/1.1\r\nhost: {address}\r\nconnection: close\r\n\r\n");
    stream.write_all(head.as_bytes()).await.unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).await.unwrap();
    let status = answer.split(' ').nth(1).unwrap().parse().unwrap();
    (status, answer)
}

struct Scrape(BTreeMap<String, Family>);

impl Scrape {
    async fn of(served: &Served) -> Self {
        let (status, answer) = get(&served.address, "/metrics").await;
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        assert!(status == 200 && head.contains("content-type: text/plain; version=0.0.4"), "{head}");
        Self(parse(body))
    }

    /// Value of a sample, like `name{label="value"}`.
    fn value(&self, sample: &str) -> f64 {
        let families = self.0.values();
        let found = families.filter_map(|family| family.samples.get(sample)).next();
        *found.unwrap_or_else(|| panic!("no {sample}"))
    }

    /// Scrapes until a sample fits.
    async fn until(served: &Served, sample: &str, fits: impl Fn(f64) -> bool) -> Self {
        let begun = Instant::now();
        loop {
            let scrape = Self::of(served).await;
            if fits(scrape.value(sample)) {
                return scrape;
            }
            assert!(begun.elapsed() < LONG, "{sample} stays {}", scrape.value(sample));
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn metrics_follow_the_cell() {
    let served = Served::new().await;
    let cycles = "seamwright_cycle_lateness_seconds_count";
    let first = Scrape::until(&served, cycles, |n| n > 100.0).await;
    let second = Scrape::until(&served, cycles, |n| n > first.value(cycles)).await;
    assert!(second.value("seamwright_uptime_seconds") >= first.value("seamwright_uptime_seconds"));
    assert_eq!(second.value("seamwright_cell_mode{mode=\"off\"}").to_bits(), 1f64.to_bits());
    assert!(second.value("seamwright_cycle_period_seconds") > 0.0);
    assert!(second.value("seamwright_queue_capacity{queue=\"cycles\"}") > 1000.0);
    assert!(second.value("seamwright_report_age_seconds{device=\"drives\"}") < 1.0);
    assert!(second.value("seamwright_pages") < 0.5 && second.value("seamwright_sessions") < 0.5);
    #[cfg(target_os = "linux")]
    assert!(second.value("process_resident_memory_bytes") > 1e6);
    // A user comes, and a client without a session is refused.
    let owner = served.bench.owner().await;
    let mut page = served.page_up(&owner).await;
    assert_eq!(get(&served.address, "/api/session").await.0, 401);
    let up = Scrape::until(&served, "seamwright_cell_mode{mode=\"ready\"}", |is| is > 0.5).await;
    assert!(up.value("seamwright_cell_mode{mode=\"off\"}") < 0.5);
    assert!(up.value("seamwright_pages") > 0.5 && up.value("seamwright_sessions") > 0.5);
    assert!(up.value("seamwright_logins_total{result=\"accepted\"}") > 0.5);
    assert!(up.value("seamwright_connections") > 0.5);
    assert!(up.value("seamwright_http_answers_total{status=\"401\"}") > 0.5);
    // A weld that is stopped, and the alarm of a page that goes silent while it jogs.
    page.weld().await;
    page.mode("weld").await;
    page.order("stop").await;
    page.until("the record", |v| v["kind"] == "event" && v["key"] == "recorded").await;
    let welded = Scrape::until(&served, "seamwright_welds_total{result=\"stopped\"}", |n| n > 0.5).await;
    assert!(welded.value("seamwright_welds_total{result=\"good\"}") < 0.5);
    assert!(welded.value("seamwright_alarms_unacknowledged{priority=\"low\"}") < 0.5);
    page.mode("ready").await;
    page.order("start_jog").await;
    page.mode("jog").await;
    page.jog([0.1, 0.0]).await;
    let silent = "seamwright_alarms_unacknowledged{priority=\"low\"}";
    page.until("the alarm", |v| v["kind"] == "alarms" && v["list"].as_array().is_some_and(|l| !l.is_empty())).await;
    Scrape::until(&served, silent, |n| n > 0.5).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_cell_that_has_ended_is_not_ready_and_the_server_lives() {
    let served = Served::without_program("ellipse-xy").await;
    let ready = async |wanted: u16| {
        let begun = Instant::now();
        loop {
            let (status, answer) = get(&served.address, "/readyz").await;
            if status == wanted {
                return serde_json::from_str::<Value>(answer.split_once("\r\n\r\n").unwrap().1).unwrap();
            }
            assert!(begun.elapsed() < LONG, "{answer}");
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
    };
    assert_eq!(ready(200).await["ready"], true);
    Scrape::until(&served, "seamwright_ready", |is| is > 0.5).await;
    let panel = std::sync::Arc::clone(&served.bench.panel);
    tokio::task::spawn_blocking(move || panel.cell.end()).await.unwrap();
    let reasons = ready(503).await;
    assert_eq!(reasons["reasons"][0]["code"], "server-not-ready-cell", "{reasons}");
    Scrape::until(&served, "seamwright_ready", |is| is < 0.5).await;
    let (status, well) = get(&served.address, "/healthz").await;
    assert!(status == 200 && well.contains("\"ok\"") && well.contains("uptime_s"), "{well}");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_library_that_cannot_be_written_is_a_reason() {
    let bench = Bench::new().await;
    // No database can be opened there.
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("library.sqlite")).unwrap();
    bench.panel.diagnostics.watch_disk(folder.path());
    let begun = Instant::now();
    loop {
        let (status, answer) = bench.ask(request("/readyz", None, &[])).await;
        let codes: Vec<&str> =
            answer["reasons"].as_array().unwrap().iter().filter_map(|reason| reason["code"].as_str()).collect();
        if codes == ["server-not-ready-library"] {
            assert_eq!(status, StatusCode::SERVICE_UNAVAILABLE);
            break;
        }
        assert!(begun.elapsed() < LONG, "{answer}");
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    assert!(bench.panel.diagnostics.close());
}

/// A request from `address`, or from this computer.
fn request(path: &str, address: Option<&str>, headers: &[(&str, &str)]) -> Request<Body> {
    let mut request = Request::get(path).header("host", HOST);
    for (name, value) in headers {
        request = request.header(*name, *value);
    }
    let mut request = request.body(Body::empty()).unwrap();
    if let Some(address) = address {
        let address: SocketAddr = address.parse().unwrap();
        request.extensions_mut().insert(ConnectInfo(address));
    }
    request
}

#[tokio::test(flavor = "multi_thread")]
async fn monitoring_from_elsewhere_needs_a_token_or_a_role() {
    let bench = Bench::new().await;
    let elsewhere = Some("10.0.0.7:50000");
    let status = async |request: Request<Body>| bench.raw(request).await.status();
    let by_cookie = |visitor: &Visitor| visitor.cookie.clone();
    let everybody = bench.everybody().await;
    for path in ["/metrics", "/readyz"] {
        let here = status(request(path, Some("127.0.0.1:50000"), &[])).await;
        assert!(here == StatusCode::OK || here == StatusCode::SERVICE_UNAVAILABLE, "{path}: {here}");
        assert_ne!(status(request(path, Some("[::ffff:127.0.0.1]:50000"), &[])).await, StatusCode::UNAUTHORIZED);
        assert_eq!(status(request(path, elsewhere, &[])).await, StatusCode::UNAUTHORIZED, "{path}");
        // A proxy on this computer passes on requests of others.
        let proxied = [("x-forwarded-for", "10.0.0.7")];
        assert_eq!(status(request(path, None, &proxied)).await, StatusCode::UNAUTHORIZED, "{path}");
        let mut foreign = request(path, None, &[]);
        foreign.headers_mut().insert("host", "evil.example".parse().unwrap());
        assert_eq!(status(foreign).await, StatusCode::FORBIDDEN);
        for (token, good) in [(MONITOR_TOKEN, true), ("fedcba987654321", false), ("", false)] {
            let header = format!("Bearer {token}");
            let answer = status(request(path, elsewhere, &[("authorization", &header)])).await;
            assert_eq!(answer != StatusCode::UNAUTHORIZED, good, "{path} {token}: {answer}");
        }
        for (role, visitor) in &everybody {
            let answer = status(request(path, elsewhere, &[("cookie", &by_cookie(visitor))])).await;
            assert_eq!(answer == StatusCode::FORBIDDEN, !crate::users::may(*role, "diagnose"), "{role:?} {path}");
        }
    }
}

/// The page shows what the metrics print; a viewer sees neither.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn diagnostics_are_those_of_the_metrics() {
    let served = Served::new().await;
    let everybody = served.bench.everybody().await;
    Scrape::until(&served, "seamwright_cycle_lateness_seconds_count", |n| n > 10.0).await;
    for (role, visitor) in &everybody {
        let (status, view) = served.bench.ask(visitor.request("GET", "/api/diagnostics", None)).await;
        assert_eq!(status == StatusCode::OK, crate::users::may(*role, "diagnose"), "{role:?}");
        if status != StatusCode::OK {
            assert_eq!((status, &view["key"]), (StatusCode::FORBIDDEN, &"role".into()));
            continue;
        }
        let latency = &view["cycle"]["latency"];
        let counts = latency["counts"].as_array().unwrap();
        assert_eq!(counts.len(), latency["limits_us"].as_array().unwrap().len() + 1);
        assert!(counts.iter().filter_map(Value::as_u64).sum::<u64>() > 10);
        let names = |key: &str, name: &str| -> Vec<String> {
            let rows = view[key].as_array().unwrap().iter();
            rows.map(|row| row[name].as_str().unwrap().to_owned()).collect()
        };
        assert_eq!(names("queues", "name"), ["cycles", "notes", "commands", "audit"]);
        assert_eq!(names("reports", "device"), ["drives", "source", "inputs"]);
        assert_eq!(names("alarms", "priority"), ["critical", "high", "medium", "low"]);
        assert_eq!(view["version"], env!("CARGO_PKG_VERSION"));
    }
    let answer = served.bench.raw(request("/metrics", None, &[])).await;
    let bytes = answer.into_body().collect().await.unwrap().to_bytes();
    let families = parse(std::str::from_utf8(&bytes).unwrap());
    // Those of real devices and of passed events have no samples here.
    let empty: Vec<&String> = families.iter().filter(|(_, f)| f.samples.is_empty()).map(|(name, _)| name).collect();
    assert!(families.len() > 30 && empty.len() < 16, "{} {empty:?}", families.len());
}
