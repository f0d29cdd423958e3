//! Connections that hang, send slowly or do not read; handlers that block their threads.

use super::*;
use crate::tests::Bench;
use axum::routing::get;
use seamwright_machine::shipped;
use std::sync::Mutex;
use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::TcpStream;
use tokio::runtime::Runtime;

/// Longer than any step takes on a busy computer.
const LONG: Duration = Duration::from_secs(60);

/// A front end on its own threads, with routes other than the panel's.
struct Fronted {
    bench: Bench,
    front: Arc<Front>,
    address: String,
    runtimes: Vec<Runtime>,
}

fn runtime() -> Runtime {
    tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap()
}

impl Fronted {
    fn new(patience: Patience, rest: impl FnOnce(&Arc<Panel>) -> Router) -> Self {
        let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        listener.set_nonblocking(true).unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let machine = shipped("ellipse-xy").unwrap().text;
        let bench = Bench::bare(tempfile::tempdir().unwrap(), &[crate::tests::HOST, &address], machine);
        let (runtime, work) = (runtime(), runtime());
        let panel = Arc::clone(&bench.panel);
        let front = Front::new(Arc::clone(&panel), rest(&panel), work.handle().clone(), patience);
        let accepts = Arc::clone(&front);
        runtime.spawn(async move { accepts.accept(TcpListener::from_std(listener).unwrap(), None).await });
        Self { bench, front, address, runtimes: vec![runtime, work] }
    }

    async fn connect(&self) -> TcpStream {
        TcpStream::connect(&self.address).await.unwrap()
    }

    async fn say(&self, what: &str) -> TcpStream {
        let mut stream = self.connect().await;
        stream.write_all(what.as_bytes()).await.unwrap();
        stream
    }

    fn head(&self, method: &str, path: &str, more: &str) -> String {
        format!("{method} {path} HTTP/1.1\r\nhost: {}\r\ncontent-type: application/json\r\n{more}\r\n", self.address)
    }

    /// Sends STOP as the login page does; returns the answer.
    async fn stop(&self) -> String {
        let text = self.head("POST", "/api/stop", "connection: close\r\ncontent-length: 2\r\n") + "{}";
        all(self.say(&text).await).await
    }
}

impl Drop for Fronted {
    fn drop(&mut self) {
        self.runtimes.drain(..).for_each(Runtime::shutdown_background);
    }
}

async fn all(mut stream: TcpStream) -> String {
    let mut said = Vec::new();
    // An error at the end is irrelevant.
    drop(tokio::time::timeout(LONG, stream.read_to_end(&mut said)).await.expect("it stays open"));
    String::from_utf8_lossy(&said).into_owned()
}

fn here(_: &Arc<Panel>) -> Router {
    Router::new().route("/", get(|| async { "here" }))
}

/// HTTP/2 is not supported, and silent clients are disconnected.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn only_the_plain_version_is_spoken_and_in_time() {
    let fronted = Fronted::new(Patience { head: Duration::from_millis(300), ..PATIENCE }, here);
    let said = all(fronted.say("GET / HTTP/1.1\r\nhost: x\r\nconnection: close\r\n\r\n").await).await;
    assert!(said.starts_with("HTTP/1.1 200") && said.ends_with("here"), "{said}");
    for strange in
        ["", "GET / HTTP/1.1\r\nhost:", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n\0\0\0\x04\0\0\0\0\0", "\x16\x03\x01"]
    {
        let said = all(fronted.say(strange).await).await;
        assert!(said.is_empty() || said.starts_with("HTTP/1.1 4"), "{said:?}");
    }
}

/// A stop is answered over HTTP and over a socket while a hanging disk blocks every handler.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[allow(clippy::await_holding_lock, reason = "that handlers wait for it is what is tried")]
async fn stop_is_heard_while_handlers_block_their_threads() {
    let hangs = Arc::new(Mutex::new(()));
    let disk = Arc::clone(&hangs);
    let rest = move |_: &Arc<Panel>| {
        let saves = move || {
            let disk = Arc::clone(&disk);
            async move { drop(disk.lock()) }
        };
        Router::new().route("/api/save", get(saves))
    };
    let fronted = Fronted::new(PATIENCE, rest);
    let owner = fronted.bench.owner().await;
    let held = hangs.lock().unwrap();
    let mut stuck = Vec::new();
    for _ in 0..8 {
        stuck.push(fronted.say(&fronted.head("GET", "/api/save", "")).await);
    }
    // The requests have reached the handlers, as far as threads are available.
    tokio::time::sleep(Duration::from_millis(300)).await;
    for _ in 0..3 {
        let said = fronted.stop().await;
        assert!(said.starts_with("HTTP/1.1 200") && said.contains("mode"), "{said}");
    }
    let well = all(fronted.say(&fronted.head("GET", "/healthz", "connection: close\r\n")).await).await;
    assert!(well.starts_with("HTTP/1.1 200") && well.contains("cycle_age_s"), "{well}");
    let metrics = all(fronted.say(&fronted.head("GET", "/metrics", "connection: close\r\n")).await).await;
    assert!(metrics.starts_with("HTTP/1.1 200") && metrics.contains("\nseamwright_ready "), "{metrics}");
    let mut page = crate::tests::page(&fronted.address, &owner).await;
    page.order("stop").await;
    drop((held, stuck));
}

/// Unfinished requests, more than one address may hold: a stop and a login succeed, and the requests time out.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn unfinished_requests_keep_nobody_from_stopping() {
    let fronted = Fronted::new(Patience { stranger: Duration::from_secs(8), ..PATIENCE }, app);
    let login = "x-seamwright: login\r\ncontent-length: ";
    let mut stuck = Vec::new();
    for i in 0..260 {
        let head = fronted.head("POST", "/api/login", &format!("{login}8000\r\n"));
        stuck.push(fronted.say(&(head + "{")).await);
        if i % 40 == 0 {
            let said = fronted.stop().await;
            assert!(said.starts_with("HTTP/1.1 200"), "after {i}: {said}");
        }
    }
    let body = format!("{{\"user\":\"\",\"password\":\"{}\"}}", crate::tests::KEY);
    let head = fronted.head("POST", "/api/login", &format!("connection: close\r\n{login}{}\r\n", body.len()));
    let said = all(fronted.say(&(head + &body)).await).await;
    assert!(said.starts_with("HTTP/1.1 200") && said.contains("\"admin\""), "{said}");
    assert!(fronted.front.places.count() <= crate::limits::MAX_STRANGERS);
    // The first were closed for newcomers; the last timed out.
    let last = all(stuck.pop().unwrap()).await;
    assert!(last.starts_with("HTTP/1.1 408"), "{last}");
    assert_eq!(all(stuck.swap_remove(0)).await, "");
}

/// Heads that are too long or have too many lines are refused before they have arrived whole.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn heads_that_are_too_large_are_refused() {
    use crate::limits::{MAX_HEAD_BYTES, MAX_HEADERS};
    let fronted = Fronted::new(PATIENCE, here);
    let lines = |count: usize| (0..count).map(|i| format!("x-{i}: x\r\n")).collect::<String>();
    // Those of `head`: host and content type.
    let fits = fronted.head("GET", "/", &(lines(MAX_HEADERS - 3) + "connection: close\r\n"));
    let said = all(fronted.say(&fits).await).await;
    assert!(said.starts_with("HTTP/1.1 200"), "{said}");
    // The last is refused before it has arrived whole.
    let begin = "GET / HTTP/1.1\r\nx: ";
    let unfinished = format!("{begin}{}", "x".repeat(MAX_HEAD_BYTES - begin.len()));
    for large in [fronted.head("GET", "/", &lines(MAX_HEADERS)), unfinished] {
        let said = all(fronted.say(&large).await).await;
        assert!(said.starts_with("HTTP/1.1 431"), "{said}");
        assert!(fronted.stop().await.starts_with("HTTP/1.1 200"));
    }
    // The rest of these is not read; their refusal may be lost with it.
    for larger in [
        fronted.head("GET", "/", &format!("x: {}\r\n", "x".repeat(2 * MAX_HEAD_BYTES))),
        format!("GET /{} HTTP/1.1\r\n", "x".repeat(2 * MAX_HEAD_BYTES)),
    ] {
        let said = all(fronted.say(&larger).await).await;
        assert!(said.is_empty() || said.starts_with("HTTP/1.1 4"), "{said}");
    }
}

/// The body of a user has a time limit too.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn who_sends_a_body_too_slowly_is_cut_off() {
    let fronted = Fronted::new(Patience { body: Duration::from_millis(300), ..PATIENCE }, app);
    let owner = fronted.bench.owner().await;
    let by = format!("cookie: {}\r\nx-seamwright: {}\r\n", owner.cookie, owner.token);
    for length in [100, 4_000_000] {
        let head = fronted.head("POST", "/api/plan", &format!("{by}content-length: {length}\r\n"));
        let said = all(fronted.say(&(head + "{")).await).await;
        assert!(said.starts_with("HTTP/1.1 408"), "{said}");
    }
}

/// A client that requests much and reads nothing is disconnected.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn who_does_not_read_is_cut_off() {
    let rest = |_: &Arc<Panel>| Router::new().route("/much", get(|| async { vec![b'x'; 64 << 20] }));
    let fronted = Fronted::new(Patience { read: Duration::from_millis(300), ..PATIENCE }, rest);
    let stream = fronted.say(&fronted.head("GET", "/much", "")).await;
    let begin = Instant::now();
    while fronted.front.places.count() == 0 {
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    while fronted.front.places.count() > 0 {
        assert!(begin.elapsed() < LONG, "its place stays taken");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
    drop(stream);
}

/// A client that reads a large answer byte by byte is disconnected too, and its room is freed.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn who_reads_an_answer_too_slowly_is_cut_off() {
    let rest = |_: &Arc<Panel>| Router::new().route("/much", get(|| async { vec![b'x'; 64 << 20] }));
    let patience = Patience { read: Duration::from_secs(2), rate: 256 << 20, ..PATIENCE };
    let fronted = Fronted::new(patience, rest);
    let mut stream = fronted.say(&fronted.head("GET", "/much", "")).await;
    let (begin, mut some) = (Instant::now(), [0; 64 << 10]);
    // Each piece is read in time, the whole answer is not.
    while stream.read(&mut some).await.is_ok_and(|n| n > 0) {
        assert!(begin.elapsed() < LONG, "it is still read");
        // What was sent before the cut is read at once.
        if fronted.front.places.count() > 0 {
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
    }
    assert!(begin.elapsed() > Duration::from_secs(1));
}

/// Large unread answers take bounded memory, at most a share per user, and free it.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn answers_that_nobody_reads_take_bounded_memory() {
    let rest = |_: &Arc<Panel>| {
        let much = || async { vec![b'x'; 40 << 20] };
        Router::new().route("/api/much", get(much)).route("/panel.js", get(much))
    };
    let fronted = Fronted::new(PATIENCE, rest);
    let users = fronted.bench.everybody().await;
    let ask = async |user: usize, path: &str| {
        let cookie = format!("cookie: {}\r\n", users[user].1.cookie);
        let mut stream = fronted.say(&fronted.head("GET", path, &cookie)).await;
        let mut said = [0; 12];
        tokio::time::timeout(LONG, stream.read_exact(&mut said)).await.unwrap().unwrap();
        (String::from_utf8_lossy(&said).into_owned(), stream)
    };
    let mut held = Vec::new();
    let mut taken = async |user: usize, path: &str| {
        let (said, stream) = ask(user, path).await;
        held.push(stream);
        said == "HTTP/1.1 200"
    };
    for (user, fits) in [(1, true), (1, true), (1, true), (1, false), (2, true), (2, true), (2, true), (3, false)] {
        assert_eq!(taken(user, "/api/much").await, fits, "{user}");
    }
    assert!(fronted.stop().await.starts_with("HTTP/1.1 200"));
    crate::tests::page(&fronted.address, &users[2].1).await.order("stop").await;
    // The panel's files are still served.
    assert!(taken(3, "/panel.js").await);
    held.clear();
    let begin = Instant::now();
    while ask(3, "/api/much").await.0 != "HTTP/1.1 200" {
        assert!(begin.elapsed() < LONG, "its room stays taken");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
}

/// A user whose large requests arrive slowly does not block others.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn large_requests_that_trickle_hold_up_no_other_user() {
    let fronted = Fronted::new(PATIENCE, app);
    let users = fronted.bench.everybody().await;
    let by = |user: usize| format!("cookie: {}\r\nx-seamwright: {}\r\n", users[user].1.cookie, users[user].1.token);
    let mut stuck = Vec::new();
    for _ in 0..20 {
        let head = fronted.head("POST", "/api/plan", &format!("{}content-length: 4000000\r\n", by(2)));
        stuck.push(fronted.say(&(head + "{")).await);
    }
    tokio::time::sleep(Duration::from_millis(200)).await;
    let text = format!("{{\"text\":\"#{}\"}}", "x".repeat(100_000));
    let more = format!("{}connection: close\r\ncontent-length: {}\r\n", by(3), text.len());
    let said = all(fronted.say(&(fronted.head("POST", "/api/draft", &more) + &text)).await).await;
    assert!(said.starts_with("HTTP/1.1 200"), "{said}");
    drop(stuck);
}

/// A session with too many requests is refused for a while; other sessions and its stops are not.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn who_asks_without_end_is_slowed_down() {
    let fronted = Fronted::new(PATIENCE, here);
    let users = fronted.bench.everybody().await;
    let mut stream = fronted.connect().await;
    let mut ask = async |cookie: &str, method: &str, path: &str| {
        let body = if method == "POST" { "content-length: 2\r\n" } else { "" };
        let mut text = fronted.head(method, path, &format!("cookie: {cookie}\r\n{body}"));
        text += if method == "POST" { "{}" } else { "" };
        stream.write_all(text.as_bytes()).await.unwrap();
        let mut said = vec![0; 4096];
        let n = tokio::time::timeout(LONG, stream.read(&mut said)).await.unwrap().unwrap();
        let said = String::from_utf8_lossy(&said[..n]).into_owned();
        if said.contains("connection: close") {
            stream = fronted.connect().await;
        }
        said
    };
    let begin = Instant::now();
    let mut refused = None;
    // The loop must exceed 50 requests per second for the test to be meaningful.
    for _ in 0..4000 {
        let said = ask(&users[0].1.cookie, "GET", "/").await;
        if said.starts_with("HTTP/1.1 429") {
            refused = Some(said);
            break;
        }
        assert!(said.starts_with("HTTP/1.1 200"), "{said}");
    }
    assert!(refused.is_some() || begin.elapsed() > Duration::from_secs(40));
    assert!(ask(&users[0].1.cookie, "POST", "/api/stop").await.starts_with("HTTP/1.1 200"));
    assert!(ask(&users[1].1.cookie, "GET", "/").await.starts_with("HTTP/1.1 200"));
}

/// Large slow requests take room from other large ones only. A stop does not wait for its body.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn large_requests_that_trickle_hold_up_nothing_small() {
    let fronted = Fronted::new(PATIENCE, app);
    let users = fronted.bench.everybody().await;
    let by = |user: usize| format!("cookie: {}\r\nx-seamwright: {}\r\n", users[user].1.cookie, users[user].1.token);
    let mut stuck = Vec::new();
    for _ in 0..20 {
        let head = fronted.head("POST", "/api/plan", &format!("{}content-length: 4000000\r\n", by(2)));
        stuck.push(fronted.say(&(head + "{")).await);
    }
    let draft = fronted.head("POST", "/api/draft", &format!("{}connection: close\r\ncontent-length: 11\r\n", by(3)));
    let said = all(fronted.say(&(draft + "{\"text\":\"\"}")).await).await;
    assert!(said.starts_with("HTTP/1.1 200"), "{said}");
    let stop = fronted.head("POST", "/api/stop", &format!("{}connection: close\r\ncontent-length: 2000\r\n", by(2)));
    let said = all(fronted.say(&stop).await).await;
    assert!(said.starts_with("HTTP/1.1 200") && said.contains("mode"), "{said}");
    drop(stuck);
}
