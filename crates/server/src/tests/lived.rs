//! The socket: permission to command, handling of messages, jogging.

use super::{Bench, Visitor};
use axum::http::StatusCode;
use futures_util::{SinkExt as _, StreamExt as _};
use serde_json::{Value, json};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tokio::net::TcpListener;
use tokio::runtime::{Handle, Runtime};
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::client::IntoClientRequest as _;

type Socket = tokio_tungstenite::WebSocketStream<tokio_tungstenite::MaybeTlsStream<tokio::net::TcpStream>>;

pub(super) struct Served {
    pub(super) bench: Bench,
    pub(super) address: String,
    _front: Threads,
}

struct Threads(Option<Runtime>);

impl Drop for Threads {
    fn drop(&mut self) {
        if let Some(runtime) = self.0.take() {
            runtime.shutdown_background();
        }
    }
}

impl Served {
    pub(super) async fn new() -> Self {
        Self::on(tempfile::tempdir().unwrap()).await
    }

    pub(super) async fn with_owner() -> (Self, Visitor) {
        let served = Self::new().await;
        let owner = served.bench.owner().await;
        (served, owner)
    }

    /// Starts on existing data.
    pub(super) async fn on(folder: TempDir) -> Self {
        let served = Self::bare(folder, super::shipped("ellipse-xy").unwrap().text).await;
        crate::http::begin_with(&served.bench.panel, "ellipse.toml").await.unwrap();
        served
    }

    /// Starts a panel of a cell with this machine, without a program.
    pub(super) async fn without_program(machine: &str) -> Self {
        Self::bare(tempfile::tempdir().unwrap(), super::shipped(machine).unwrap().text).await
    }

    /// The same with the text of a machine file.
    pub(super) async fn bare(folder: TempDir, machine: &str) -> Self {
        let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        listener.set_nonblocking(true).unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let bench = Bench::bare(folder, &[super::HOST, &address], machine);
        let (panel, work) = (Arc::clone(&bench.panel), Handle::current());
        let front = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap();
        front.spawn(async move {
            crate::front::answer(TcpListener::from_std(listener).unwrap(), None, panel, work).await;
        });
        Self { bench, address, _front: Threads(Some(front)) }
    }

    pub(super) async fn page(&self, visitor: &Visitor) -> Page {
        page(&self.address, visitor).await
    }

    pub(super) async fn page_up(&self, visitor: &Visitor) -> Page {
        let mut page = self.page(visitor).await;
        page.up().await;
        page
    }
}

pub(crate) async fn page(address: &str, visitor: &Visitor) -> Page {
    let mut request = format!("ws://{address}/api/live").into_client_request().unwrap();
    request.headers_mut().insert("cookie", visitor.cookie.parse().unwrap());
    let (socket, _) = tokio_tungstenite::connect_async(request).await.unwrap();
    let [status, taught, alarms] = std::array::from_fn(|_| Value::Null);
    Page { socket, seq: 0, jogs: 0, status, taught, alarms, events: Vec::new(), beat: Instant::now() }
}

/// A page in a user's browser.
pub(crate) struct Page {
    socket: Socket,
    seq: u32,
    jogs: u32,
    pub(super) status: Value,
    /// Received events, in words.
    pub(super) events: Vec<String>,
    /// State of teaching by camera.
    pub(super) taught: Value,
    pub(super) alarms: Value,
    beat: Instant,
}

impl Page {
    pub(super) async fn say(&mut self, message: &Value) {
        self.socket.send(Message::text(message.to_string())).await.unwrap();
    }

    /// Sends a text. Returns false if the connection is closed.
    pub(super) async fn tries_to_say(&mut self, text: &str) -> bool {
        self.socket.send(Message::text(text.to_owned())).await.is_ok()
    }

    async fn next(&mut self) -> Option<Value> {
        if self.beat.elapsed() > Duration::from_millis(200) {
            self.beat = Instant::now();
            self.say(&json!({ "kind": "beat" })).await;
        }
        match tokio::time::timeout(Duration::from_secs(20), self.socket.next()).await.expect("it is silent")? {
            Ok(Message::Text(text)) => {
                let value: Value = serde_json::from_str(&text).unwrap();
                if value["kind"] == "status" {
                    self.status = value.clone();
                }
                if value["kind"] == "event" {
                    self.events.push(format!("{} {}", value["what"], value["text"]));
                }
                if value["kind"] == "alarms" {
                    self.alarms = value["list"].clone();
                }
                if value["kind"] == "teach" {
                    self.taught = value.clone();
                }
                Some(value)
            }
            _ => None,
        }
    }

    pub(super) async fn until(&mut self, what: &str, fits: impl Fn(&Value) -> bool) -> Value {
        let begin = Instant::now();
        loop {
            let value = self.next().await.unwrap_or_else(|| panic!("closed before {what}"));
            if fits(&value) {
                return value;
            }
            let late = begin.elapsed() >= Duration::from_secs(120);
            assert!(!late, "no {what}: {:#?} {} {}", self.events, self.taught, self.status);
        }
    }

    /// Arms and starts the weld.
    pub(super) async fn weld(&mut self) {
        self.order("arm").await;
        self.order("start_weld").await;
    }

    /// Switches off.
    pub(super) async fn down(&mut self) {
        self.order("switch_off").await;
        self.mode("off").await;
    }

    pub(super) async fn until_status(&mut self, what: &str, fits: impl Fn(&Value) -> bool) -> Value {
        self.until(what, |v| v["kind"] == "status" && fits(v)).await
    }

    pub(super) async fn mode(&mut self, mode: &str) {
        self.until_status(mode, |v| v["mode"] == mode).await;
    }

    pub(super) async fn ask(&mut self, what: Value) -> Value {
        self.command("command", "ask", what).await
    }

    pub(super) async fn teach(&mut self, order: Value) -> Value {
        self.command("teach", "order", order).await
    }

    async fn command(&mut self, kind: &str, name: &str, what: Value) -> Value {
        self.seq += 1;
        let seq = self.seq;
        self.say(&json!({ "kind": kind, "seq": seq, name: what })).await;
        self.until("an answer", |v| v["kind"] == "answer" && v["seq"] == seq).await
    }

    pub(crate) async fn order(&mut self, what: &str) {
        let answer = self.ask(json!({ "do": what })).await;
        assert_eq!(answer["ok"], true, "{what}: {answer}");
    }

    pub(super) async fn again(&mut self, what: Value) -> Value {
        self.seq -= 1;
        self.ask(what).await
    }

    pub(super) async fn closed(&mut self) {
        let ended = async { while let Some(Ok(_)) = self.socket.next().await {} };
        tokio::time::timeout(Duration::from_secs(20), ended).await.expect("it stays open");
    }

    pub(super) async fn jog(&mut self, speeds: [f64; 2]) {
        self.hand(json!({ "kind": "jog", "of": "joints", "speeds": speeds })).await;
    }

    pub(super) async fn hand(&mut self, mut what: Value) {
        self.jogs += 1;
        what["seq"] = json!(self.jogs);
        self.say(&what).await;
    }

    /// Takes control, also if it was lost while the test was busy.
    pub(super) async fn control(&mut self) {
        self.say(&json!({ "kind": "take_control", "over": false })).await;
        self.until("control", |v| v["kind"] == "control" && v["mine"] == true).await;
    }

    /// Takes control, also from another page.
    pub(super) async fn take_over(&mut self) {
        self.say(&json!({ "kind": "take_control", "over": true })).await;
        self.until("control", |v| v["kind"] == "control" && v["mine"] == true).await;
    }

    /// Brings the machine from off to ready, with control.
    pub(super) async fn up(&mut self) {
        self.control().await;
        self.order("switch_on").await;
        self.until_status("power", |v| v["powered"] == true).await;
        self.order("home").await;
        self.mode("ready").await;
    }

    pub(super) fn position(&self) -> f64 {
        self.status["axes"][0]["set"].as_f64().unwrap()
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn one_page_commands_and_the_others_watch() {
    let served = Served::new().await;
    let everybody = served.bench.everybody().await;
    let of = |role: &str| everybody.iter().find(|(r, _)| format!("{r:?}") == role).unwrap().1.clone();
    let mut first = served.page(&of("Operator")).await;
    let hello = first.until("hello", |v| v["kind"] == "hello").await;
    assert!(hello["station"].as_u64().unwrap() > 0);
    first.until("the work", |v| v["kind"] == "work" && v["work"]["job"] == "ellipse.toml").await;
    // Without control only stop and hold are allowed.
    assert_eq!(first.ask(json!({ "do": "switch_on" })).await["why"]["key"], "control");
    first.order("stop").await;
    first.up().await;
    // Missing conditions of a weld.
    first.say(&json!({ "kind": "why", "ask": "start_weld" })).await;
    let why = first.until("why", |v| v["kind"] == "why").await;
    assert_eq!(why["lacks"].as_array().unwrap().len(), 1, "{why}");
    assert_eq!(why["lacks"][0]["key"], "arming");
    // A replayed command is refused.
    let seq = first.seq;
    first.say(&json!({ "kind": "command", "seq": seq, "ask": { "do": "home" } })).await;
    let again = first.until("a refusal", |v| v["kind"] == "answer" && v["ok"] == false).await;
    assert_eq!(again["why"]["key"], "replayed");
    // Another page may not command, but sees the holder and takes control over.
    let mut second = served.page(&of("Service")).await;
    let control = second.until("control", |v| v["kind"] == "control").await;
    assert_eq!((&control["mine"], &control["user"]), (&json!(false), &json!("Operator")));
    assert_eq!(second.ask(json!({ "do": "home" })).await["why"]["key"], "control");
    second.say(&json!({ "kind": "take_control", "over": false })).await;
    let held = second.until("a refusal", |v| v["kind"] == "answer" && v["ok"] == false).await;
    assert_eq!(
        (&held["why"]["key"], &held["why"]["arguments"][0][1]["value"]),
        (&json!("control"), &json!("Operator"))
    );
    // Nor may its user replace the program.
    let (status, refused) = served.bench.load(&of("Service"), "half-ring.toml", None).await;
    assert_eq!((status, refused["key"].as_str()), (StatusCode::CONFLICT, Some("control")), "{refused}");
    second.say(&json!({ "kind": "take_control", "over": true })).await;
    first.until("the loss", |v| v["kind"] == "control" && v["mine"] == false).await;
    assert_eq!(first.ask(json!({ "do": "home" })).await["why"]["key"], "control");
    // A viewer may only stop.
    let mut viewer = served.page(&of("Viewer")).await;
    for what in ["switch_on", "hold", "arm", "start_weld", "reset", "acknowledge"] {
        assert_eq!(viewer.ask(json!({ "do": what })).await["why"]["key"], "role", "{what}");
    }
    viewer.order("stop").await;
    // Invalid messages are answered; a page with too many messages is disconnected.
    for bad in ["", "{", "{\"kind\":\"command\"}", "{\"kind\":\"beat\",\"more\":1}", "[1]"] {
        viewer.socket.send(Message::text(bad)).await.unwrap();
        let answer = viewer.until("a refusal", |v| v["kind"] == "answer").await;
        assert_eq!(answer["ok"], false, "{bad}");
    }
    for _ in 0..400 {
        if viewer.socket.send(Message::text("{\"kind\":\"beat\"}")).await.is_err() {
            break;
        }
    }
    while viewer.next().await.is_some() {}
    // Control is lost with the heartbeat.
    let told = served.bench.panel.cell.hub.holder();
    assert_eq!(told.as_deref(), Some("Service"));
    tokio::time::sleep(Duration::from_millis(1300)).await;
    assert_eq!(served.bench.panel.cell.hub.holder(), None);
}

/// The axis stops within 250 ms of the last message, however the jog ends. A lost connection resumes nothing.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_hand_that_goes_stops_the_axes() {
    let (served, owner) = Served::with_owner().await;
    for way in ["silent", "rest", "closed"] {
        let mut page = served.page(&owner).await;
        if way == "silent" {
            page.up().await;
        } else {
            page.take_over().await;
        }
        page.order("start_jog").await;
        page.mode("jog").await;
        let before = page.position();
        let side = if way == "rest" { -1.0 } else { 1.0 };
        for _ in 0..12 {
            page.jog([0.2 * side, 0.0]).await;
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
        let last = Instant::now();
        match way {
            "rest" => page.jog([0.0, 0.0]).await,
            "closed" => page.socket.close(None).await.unwrap(),
            _ => {}
        }
        let mut watcher = served.page(&owner).await;
        let mut moving = Duration::ZERO;
        let mut place = f64::NAN;
        while last.elapsed() < Duration::from_millis(900) {
            watcher.until_status("status", |_| true).await;
            if (watcher.position() - place).abs() > 1e-9 {
                moving = last.elapsed();
            }
            place = watcher.position();
        }
        // Silence is detected after 200 ms, then the axis decelerates; the computer may be busy.
        assert!(moving < Duration::from_millis(850), "{way}: {moving:?}");
        assert!((place - before).abs() > 0.5, "{way}: {before} {place}");
        watcher.take_over().await;
        watcher.order("hold").await;
        watcher.mode("ready").await;
        if way == "silent" {
            let alarm = watcher.ask(json!({ "do": "acknowledge" })).await;
            assert_eq!(alarm["ok"], true);
        }
    }
}

/// Jog keys and displayed values need the axis names of the moving machine.
#[tokio::test]
async fn another_machine_is_told_to_every_page() {
    let (served, owner) = Served::with_owner().await;
    let mut pages = [served.page(&owner).await, served.page(&owner).await];
    for page in &mut pages {
        page.until("the machine", |v| v["kind"] == "machine").await;
    }
    let (status, told) = served.bench.load(&owner, "half-ring.toml", None).await;
    assert!(status.is_success(), "{told}");
    for page in &mut pages {
        page.until("another machine", |v| v["kind"] == "machine").await;
        // Requests after this message get the new machine.
        let (_, machine) = served.bench.ask(owner.request("GET", "/api/machine", None)).await;
        assert_eq!((machine["name"].as_str(), machine["beam"].as_bool()), (Some("ebw-7axis"), Some(true)));
        page.until_status("its axes", |v| v["axes"].as_array().is_some_and(|a| a.len() == 7)).await;
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_jog_that_moves_nothing_does_not_hold_control() {
    let (served, owner) = Served::with_owner().await;
    let (mut first, mut second) = (served.page(&owner).await, served.page(&owner).await);
    first.up().await;
    first.order("start_jog").await;
    for speeds in [[1e-12, 0.0], [0.0, -1e-300], [5e-4, f64::MIN_POSITIVE]] {
        first.jog(speeds).await;
    }
    // The jog was handled, since the next command is.
    let answer = first.ask(json!({ "do": "override", "part": 1.0 })).await;
    assert_eq!(answer["ok"], true, "{answer}");
    second.say(&json!({ "kind": "take_control", "over": true })).await;
    let fits = |v: &Value| v["kind"] == "answer" || (v["kind"] == "control" && v["mine"] == true);
    let got = second.until("control", fits).await;
    assert_eq!(got["kind"], "control", "{got}");
}
