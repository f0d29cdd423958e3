//! The processes of panel and cell: each dies, freezes or ends while the cell welds, and the device shows what was on.

use crate::common::write;
use crate::modbus_server::TestServer;
use crate::modbus_welder::{MAP, welder};
use crate::stopped::{eventually, job};
use seamwright_record::DataFolder;
use seamwright_record::library::{Query, WeldResult};
use seamwright_record::trace::Trace;
use serde_json::{Value, json};
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A panel with a cell of its own on a Modbus source, and a session of its administrator.
pub(crate) struct Panel {
    pub(crate) child: Child,
    pub(crate) address: String,
    cookie: String,
    token: String,
    pub(crate) data: String,
}

impl Drop for Panel {
    fn drop(&mut self) {
        // A cell without a panel ends by itself a minute later; the tests do not wait for it.
        drop(self.child.kill());
        drop(self.child.wait());
        drop(Command::new("pkill").args(["-KILL", "-f", &format!("cell --sockets {}", self.data)]).status());
    }
}

impl Panel {
    pub(crate) fn start(data: &Path, job: &str) -> Self {
        let data = data.display().to_string();
        let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
            .args(["serve", "--bind", "127.0.0.1:0", "--data", &data, "--job", job])
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let (address, key) = line.trim().strip_prefix("http://").unwrap().split_once("/#key=").unwrap();
        let mut panel = Self { child, address: address.to_owned(), cookie: String::new(), token: String::new(), data };
        let body = json!({ "user": "", "password": key }).to_string();
        let answer = panel.says("POST /api/login HTTP/1.1\r\nx-seamwright: login\r\n", &body);
        let (head, view) = answer.split_once("\r\n\r\n").unwrap();
        let cookie = head.lines().find_map(|l| l.strip_prefix("set-cookie: ")).unwrap();
        panel.cookie = cookie.split(';').next().unwrap().to_owned();
        let view: Value = serde_json::from_str(view).unwrap();
        panel.token = view["token"].as_str().unwrap().to_owned();
        panel
    }

    /// The first lines of a request of the session.
    pub(crate) fn head(&self, what: &str) -> String {
        let Self { cookie, token, .. } = self;
        format!("{what} HTTP/1.1\r\ncookie: {cookie}\r\nx-seamwright: {token}\r\n")
    }

    fn says(&self, head: &str, body: &str) -> String {
        Self::send(&self.address, head, body)
    }

    pub(crate) fn send(address: &str, head: &str, body: &str) -> String {
        let mut stream = TcpStream::connect(address).unwrap();
        let length = body.len();
        write!(stream, "{head}host: {address}\r\nconnection: close\r\ncontent-length: {length}\r\n").unwrap();
        write!(stream, "content-type: application/json\r\n\r\n{body}").unwrap();
        let mut answer = String::new();
        // A server that is killed meanwhile ends the connection.
        let _ = stream.read_to_string(&mut answer);
        answer
    }

    /// The number of the cell's process.
    pub(crate) fn cell(&self) -> Option<String> {
        let found = Command::new("pgrep").args(["-f", &format!("cell --sockets {}", self.data)]).output().unwrap();
        String::from_utf8(found.stdout).unwrap().lines().last().map(str::to_owned)
    }

    /// Opens a page's socket, takes control, and brings the cell to the mode `ready`.
    pub(crate) fn ready(&self) -> Page {
        let mut page = Page::open(self);
        page.send(&json!({ "kind": "take_control", "over": false }));
        page.order("switch_on");
        page.until(|status| status["powered"] == true);
        page.order("home");
        page.until(|status| status["mode"] == "ready");
        page
    }

    /// The same, and welds until the arc of `server` burns.
    pub(crate) fn weld(&self, server: &TestServer) -> Page {
        let mut page = self.ready();
        page.order("arm");
        page.start_weld();
        eventually("the arc", || {
            page.beat();
            server.bank().discrete[4]
        });
        page
    }
}

/// A WebSocket client for text messages, as small as a test needs.
pub(crate) struct Page {
    stream: TcpStream,
    buffer: std::cell::RefCell<Vec<u8>>,
    seq: u32,
}

impl Page {
    pub(crate) fn open(panel: &Panel) -> Self {
        let mut stream = TcpStream::connect(&panel.address).unwrap();
        write!(
            stream,
            "GET /api/live HTTP/1.1\r\nhost: {0}\r\norigin: http://{0}\r\ncookie: {1}\r\nupgrade: websocket\r\n\
             connection: upgrade\r\nsec-websocket-version: 13\r\nsec-websocket-key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
            panel.address, panel.cookie
        )
        .unwrap();
        let mut head = Vec::new();
        while !head.ends_with(b"\r\n\r\n") {
            let mut byte = [0];
            stream.read_exact(&mut byte).unwrap();
            head.push(byte[0]);
        }
        assert!(head.starts_with(b"HTTP/1.1 101"), "{}", String::from_utf8_lossy(&head));
        stream.set_read_timeout(Some(Duration::from_millis(20))).unwrap();
        Self { stream, buffer: std::cell::RefCell::default(), seq: 0 }
    }

    fn send(&self, message: &Value) {
        let text = message.to_string();
        let mut frame = vec![0x81];
        match u16::try_from(text.len()).unwrap() {
            length @ 0..126 => frame.push(0x80 | length as u8),
            length => frame.extend([0x80 | 126, (length >> 8) as u8, length as u8]),
        }
        frame.extend([0; 4]);
        frame.extend(text.as_bytes());
        (&self.stream).write_all(&frame).unwrap();
    }

    pub(crate) fn beat(&self) {
        self.send(&json!({ "kind": "beat" }));
        // What has come is read, so that the server does not take this page for a slow one.
        self.texts();
    }

    fn texts(&self) -> Vec<Value> {
        let mut bytes = vec![0; 1 << 16];
        if let Ok(count) = (&self.stream).read(&mut bytes) {
            self.buffer.borrow_mut().extend(&bytes[..count]);
        }
        let mut buffer = self.buffer.borrow_mut();
        let mut texts = Vec::new();
        loop {
            let (head, length) = match buffer.get(1).map(|b| b & 127) {
                Some(126) if buffer.len() >= 4 => (4, usize::from(buffer[2]) << 8 | usize::from(buffer[3])),
                Some(127) if buffer.len() >= 10 => (10, usize::from_be_bytes(buffer[2..10].try_into().unwrap())),
                Some(length @ 0..126) => (2, usize::from(length)),
                _ => break,
            };
            if buffer.len() < head + length {
                break;
            }
            texts.extend(serde_json::from_slice::<Value>(&buffer[head..head + length]).ok());
            buffer.drain(..head + length);
        }
        texts
    }

    pub(crate) fn order(&mut self, ask: &str) {
        self.seq += 1;
        self.send(&json!({ "kind": "command", "seq": self.seq, "ask": { "do": ask } }));
        let seq = self.seq;
        self.wait(ask, |text| {
            text["kind"] == "answer" && text["seq"] == seq && {
                assert_eq!(text["ok"], true, "{ask}: {text}");
                true
            }
        });
    }

    /// Starts the weld, without waiting for it.
    pub(crate) fn start_weld(&mut self) {
        self.seq += 1;
        self.send(&json!({ "kind": "command", "seq": self.seq, "ask": { "do": "start_weld", "reweld": false } }));
    }

    /// The next status.
    pub(crate) fn status(&self) -> Value {
        let next = std::cell::Cell::new(Value::Null);
        self.until(|status| {
            next.set(status.clone());
            true
        });
        next.into_inner()
    }

    pub(crate) fn until(&self, done: impl Fn(&Value) -> bool) {
        self.wait("a status", |text| text["kind"] == "status" && done(text));
    }

    fn wait(&self, what: &str, done: impl Fn(&Value) -> bool) {
        let begun = Instant::now();
        loop {
            self.send(&json!({ "kind": "beat" }));
            if self.texts().iter().any(&done) {
                return;
            }
            assert!(begun.elapsed() < Duration::from_secs(60), "not within 60 s: {what}");
        }
    }
}

pub(crate) fn signal(name: &str, process: &str) {
    assert!(Command::new("kill").args([name, process]).status().unwrap().success());
}

pub(crate) fn started(folder: &Path, server: &TestServer, on_panel_lost: &str) -> Panel {
    started_in(folder, &folder.join("data"), server, on_panel_lost)
}

/// The same with the data in another folder.
pub(crate) fn started_in(folder: &Path, data: &Path, server: &TestServer, on_panel_lost: &str) -> Panel {
    let map = format!("timeout_s = 1\n{MAP}");
    let job = job(folder, &server.address.to_string(), &map);
    let machine = folder.join("cell.toml");
    let text = std::fs::read_to_string(&machine).unwrap();
    std::fs::write(&machine, format!("{on_panel_lost}{text}")).unwrap();
    let jobs = data.join("jobs");
    std::fs::create_dir_all(&jobs).unwrap();
    std::fs::copy(&machine, jobs.join("cell.toml")).unwrap();
    Panel::start(data, &job)
}

pub(crate) fn is_off(server: &TestServer) -> bool {
    let bank = server.bank();
    !bank.coils[0] && !bank.coils[1] && bank.holding[..2] == [0, 0]
}

/// The cell is killed while it welds: a new one connects to the device, whose outputs become safe; nothing starts again by
/// itself.
#[test]
fn a_cell_that_is_killed_leaves_nothing_on() {
    for how in ["-KILL", "-ABRT", "-STOP"] {
        let server = TestServer::new(welder);
        let folder = tempfile::tempdir().unwrap();
        let panel = started(folder.path(), &server, "");
        let page = panel.weld(&server);
        let old = panel.cell().unwrap();
        signal(how, &old);
        eventually("a new cell", || {
            page.beat();
            panel.cell().is_some_and(|new| new != old)
        });
        eventually("safe outputs", || {
            page.beat();
            is_off(&server)
        });
        page.until(|status| status["mode"] == "off");
        std::thread::sleep(Duration::from_millis(500));
        assert!(is_off(&server), "{how}: it burns again");
        let work = panel.says(&format!("GET /api/work HTTP/1.1\r\ncookie: {}\r\n", panel.cookie), "");
        assert!(work.ends_with("null"), "{how}: {work}");
    }
}

/// The panel dies while the cell welds: the weld is held, as the machine file says by default; the next panel finds the
/// cell with its program.
#[test]
fn a_weld_whose_panel_is_killed_is_held_and_found_again() {
    let server = TestServer::new(welder);
    let folder = tempfile::tempdir().unwrap();
    let mut panel = started(folder.path(), &server, "");
    drop(panel.weld(&server));
    let cell = panel.cell().unwrap();
    panel.child.kill().unwrap();
    panel.child.wait().unwrap();
    eventually("the arc to go off", || !server.bank().coils[0]);
    assert_eq!(panel.cell().as_ref(), Some(&cell), "the cell lives");
    let next = Panel::start(Path::new(&panel.data), "job.toml");
    assert_eq!(next.cell().as_ref(), Some(&cell), "it is the same");
    let mut page = Page::open(&next);
    page.until(|status| status["mode"] == "hold");
    let work = next.says(&format!("GET /api/work HTTP/1.1\r\ncookie: {}\r\n", next.cookie), "");
    assert!(work.contains("\"job.toml\""), "{work}");
    assert!(!server.bank().coils[0]);
    // It goes on in its record.
    page.send(&json!({ "kind": "take_control", "over": false }));
    page.order("arm");
    page.order("resume");
    page.until(|status| status["mode"] == "weld" && status["recording"] == 1);
    // The end of the second panel ends the cell in order.
    signal("-TERM", &next.child.id().to_string());
    eventually("the end of the cell", || !Path::new("/proc").join(&cell).exists());
    assert!(is_off(&server));
}

/// Welds without a panel for some seconds. Returns false if the computer gave the cell too little time, so that it stopped
/// the weld by itself.
fn welds_without_panel() -> bool {
    let server = TestServer::new(welder);
    let folder = tempfile::tempdir().unwrap();
    let mut panel = started(folder.path(), &server, "on_panel_lost = \"continue\"\n");
    drop(panel.weld(&server));
    panel.child.kill().unwrap();
    panel.child.wait().unwrap();
    std::thread::sleep(Duration::from_millis(2500));
    let burns = server.bank().discrete[4];
    let next = Panel::start(Path::new(&panel.data), "job.toml");
    let page = Page::open(&next);
    // Not held: that would be the answer to the loss of the panel.
    page.until(|status| {
        assert_ne!(status["mode"], "hold");
        true
    });
    if burns {
        // STOP needs neither login nor panel.
        let stop = Command::new(env!("CARGO_BIN_EXE_seamwright")).args(["stop", "--data", &panel.data]).output();
        let stop = stop.unwrap();
        let said = String::from_utf8(stop.stdout).unwrap();
        assert!(stop.status.success() && said.starts_with("stopped in cycle "), "{said}");
    }
    eventually("the arc to go off", || !server.bank().coils[0]);
    if burns {
        signal("-TERM", &next.child.id().to_string());
        let mut next = next;
        assert_eq!(next.child.wait().unwrap().code(), Some(0));
        one_whole_record(Path::new(&panel.data));
    }
    burns
}

/// One record has all rows of the weld, also those of the time without a panel.
fn one_whole_record(data: &Path) {
    let data = DataFolder::open_to_read(data).unwrap();
    let welds = data.library().find(&Query::default()).unwrap();
    assert!(welds.len() == 1 && welds[0].result == WeldResult::Stopped, "{welds:?}");
    let detail = data.library().detail(welds[0].id).unwrap();
    assert!(detail.events.iter().any(|event| event.text.code == "cell-event-pass-left"), "{:?}", detail.events);
    let trace = Trace::open(&data.weld_folder(welds[0].id).join("trace.parquet")).unwrap();
    let (mut times, mut missed) = (Vec::new(), 0.0);
    trace
        .read(&["t_s", "missed"], |row| {
            times.push(row[0]);
            missed += row[1];
        })
        .unwrap();
    let lasted = times[times.len() - 1] - times[0];
    assert!(lasted > 2.5, "{lasted} s");
    let cycles = lasted / period(&times);
    assert!(
        (times.len() as f64 + missed - cycles - 1.0).abs() <= 1.5,
        "{} rows of {cycles}, {missed} missed",
        times.len()
    );
}

/// Median time between two rows, s.
fn period(times: &[f64]) -> f64 {
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    steps[steps.len() / 2]
}

/// With `on_panel_lost = "continue"` the weld goes on while there is no panel.
#[test]
fn a_weld_goes_on_without_its_panel_if_the_machine_file_says_so() {
    assert!((0..5).any(|_| welds_without_panel()), "it stopped five times");
}

#[test]
fn mistakes_of_stop_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().display().to_string();
    let told = crate::common::bad(2, &["stop", "--data", &data]);
    assert!(told.contains("no cell runs there") && told.contains("allowed"), "{told}");
    assert!(crate::common::bad(2, &["stop", "now"]).contains("now"));
    let file = write(folder.path(), "file", "x");
    assert!(crate::common::bad(2, &["stop", "--data", &file]).contains("--data"));
}
