//! Load of many watching pages, and of one that never reads, on the cycle and on other pages.

use super::Visitor;
use super::lived::Served;
use futures_util::StreamExt as _;
use seamwright_executive::realtime::{Latency, Pacer, RealtimeRights};
use serde_json::Value;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tokio::io::AsyncWriteExt as _;
use tokio::net::{TcpSocket, TcpStream};

const WATCHERS: usize = 20;

/// Measures the lateness of a thread beside the cycle, with its period and priority, until ended.
struct Probe {
    ends: Arc<AtomicBool>,
    thread: std::thread::JoinHandle<Latency>,
}

impl Probe {
    fn begin(period_s: f64) -> Self {
        let ends = Arc::new(AtomicBool::new(false));
        let end = Arc::clone(&ends);
        let thread = std::thread::spawn(move || {
            RealtimeRights::ask(None);
            let mut pacer = Pacer::new(period_s);
            while !end.load(Ordering::Relaxed) {
                pacer.wait();
            }
            pacer.latency().clone()
        });
        Self { ends, thread }
    }

    fn end(self) -> Latency {
        self.ends.store(true, Ordering::Relaxed);
        self.thread.join().unwrap()
    }
}

fn print_latency(what: &str, latency: &Latency) {
    let [half, p99, p999] = [0.5, 0.99, 0.999].map(|part| latency.quantile_us(part));
    println!(
        "{what}: {} cycles, late {half:.0} us (half), {p99:.0} us (p99), {p999:.0} us (p99.9), {:.0} us (most), {} missed",
        latency.count(),
        latency.most_us(),
        latency.missed()
    );
}

/// Resident memory of this program, MB: the cell, its panel and the clients.
fn memory_mb() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap_or_default();
    line.trim().trim_end_matches(" kB").trim().parse::<f64>().unwrap_or(0.0) / 1024.0
}

/// Watches as a page: measures pauses between statuses, and checks that no event is missing.
async fn watch(address: String, visitor: Visitor, ends: Arc<AtomicBool>) -> (Latency, u64) {
    use tokio_tungstenite::tungstenite::client::IntoClientRequest as _;
    let mut request = format!("ws://{address}/api/live").into_client_request().unwrap();
    request.headers_mut().insert("cookie", visitor.cookie.parse().unwrap());
    let (mut socket, _) = tokio_tungstenite::connect_async(request).await.unwrap();
    let (mut pauses, mut last, mut event) = (Latency::default(), Instant::now(), None);
    while !ends.load(Ordering::Relaxed) {
        let message = socket.next().await.expect("a watcher is cut off").unwrap();
        let value: Value = serde_json::from_str(message.to_text().unwrap()).unwrap();
        match value["kind"].as_str().unwrap() {
            "status" => {
                pauses.add(last.elapsed().as_nanos() as u64, 0);
                last = Instant::now();
            }
            "event" => {
                let number = value["number"].as_u64().unwrap();
                assert!(event.is_none_or(|before| number == before + 1), "an event is missing: {event:?} {number}");
                event = Some(number);
            }
            _ => {}
        }
    }
    (pauses.clone(), pauses.count())
}

/// Opens the socket and never reads from it.
async fn sleeps(address: &str, visitor: &Visitor) -> TcpStream {
    let socket = TcpSocket::new_v4().unwrap();
    socket.set_recv_buffer_size(4096).unwrap();
    let mut stream = socket.connect(address.parse().unwrap()).await.unwrap();
    let request = format!(
        "GET /api/live HTTP/1.1\r\nhost: {address}\r\ncookie: {}\r\nconnection: upgrade\r\nupgrade: websocket\r\n\
         sec-websocket-version: 13\r\nsec-websocket-key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
        visitor.cookie
    );
    stream.write_all(request.as_bytes()).await.unwrap();
    stream
}

/// Duration of the load, s; `make soak` uses ten minutes.
fn seconds() -> u64 {
    let given = std::env::var("SEAMWRIGHT_LOAD_S").ok().and_then(|s| s.parse().ok());
    given.unwrap_or(if std::env::var_os("SEAMWRIGHT_SOAK").is_some() { 600 } else { 30 })
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[ignore = "takes minutes; measures"]
async fn many_watch_and_one_never_reads() {
    let served = Served::new().await;
    let hub = &served.bench.panel.cell.hub;
    let owner = served.bench.owner().await;
    let period_s = hub.machine().unwrap().servo_period_s;
    let alone = Duration::from_secs(seconds().div_ceil(5));
    let missed = || hub.latest().map_or(0, |status| status.missed);
    tokio::time::sleep(Duration::from_secs(2)).await;
    let (before, missed_before) = (Probe::begin(period_s), missed());
    tokio::time::sleep(alone).await;
    let (before, missed_alone) = (before.end(), missed());

    let ends = Arc::new(AtomicBool::new(false));
    let watchers: Vec<_> =
        (0..WATCHERS).map(|_| tokio::spawn(watch(served.address.clone(), owner.clone(), Arc::clone(&ends)))).collect();
    let slow = sleeps(&served.address, &owner).await;
    let begin = Instant::now();
    tokio::time::sleep(Duration::from_secs(seconds() / 10)).await;
    assert!(hub.clients() >= WATCHERS);
    let (first, probe) = (memory_mb(), Probe::begin(period_s));
    let mut cut_off = None;
    while begin.elapsed() < Duration::from_secs(seconds()) {
        tokio::time::sleep(Duration::from_millis(100)).await;
        if cut_off.is_none() && hub.clients() <= WATCHERS {
            cut_off = Some(begin.elapsed());
        }
    }
    let (with, missed_with, last) = (probe.end(), missed(), memory_mb());
    ends.store(true, Ordering::Relaxed);
    let mut all = Vec::new();
    for watcher in watchers {
        all.push(watcher.await.unwrap());
    }
    drop(slow);
    tokio::time::sleep(Duration::from_secs(2)).await;
    let after = Probe::begin(period_s);
    tokio::time::sleep(alone).await;
    let after = after.end();

    println!("period {:.3} ms, {WATCHERS} watch and one never reads, {} s", period_s * 1e3, seconds());
    print_latency("nobody watches, before", &before);
    print_latency("they watch            ", &with);
    print_latency("nobody watches, after ", &after);
    println!(
        "the cell itself missed {} cycles alone, {} with them",
        missed_alone - missed_before,
        missed_with - missed_alone
    );
    println!("memory {first:.1} MB after a tenth of the time, {last:.1} MB at the end");
    let worst = |part: f64| all.iter().map(|(pauses, _)| pauses.quantile_us(part) * 1e-3).fold(0.0, f64::max);
    let fewest = all.iter().map(|(_, n)| n).min().unwrap();
    println!(
        "statuses: at least {:.1} a second for each; pauses of the worst off: {:.0} ms (half), {:.0} ms (p99.9), {:.0} ms (most)",
        *fewest as f64 / seconds() as f64,
        worst(0.5),
        worst(0.999),
        worst(1.0)
    );
    println!("who never reads was cut off after {:?}", cut_off.map(|t| t.as_secs()));
    assert!(*fewest > 20 * seconds(), "{fewest}");
    assert!(last < first + 16.0, "{first} {last}");
    assert!(seconds() < 200 || cut_off.is_some());
}
