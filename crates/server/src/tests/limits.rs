//! Limits of the server: one more than allowed is refused, and neither STOP nor an operator's page waits meanwhile.

use super::lived::{Page, Served};
use super::{Bench, Visitor};
use crate::cell::happening;
use crate::http::{Panel, Turns};
use crate::limits::{
    self, MAX_FORM_CHANGES, MAX_JOB_BYTES, MAX_JOB_NAME_BYTES, MAX_JOBS, MAX_OPERATIONS, MAX_PAGES, MAX_PART_CHARS,
    MAX_PLACE_POINTS, MAX_SEARCH_CHARS, MAX_TOUCHES, MAX_VIEWER_PAGES, MESSAGE_BURST, PAGES_KEPT_FOR_OPERATORS, Queue,
    RECENT_EVENTS,
};
use crate::wire::Role;
use axum::http::StatusCode;
use seamwright_message::Message;
use serde_json::{Value, json};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::{TcpSocket, TcpStream};

/// Longer than any step takes on a busy computer.
const LONG: Duration = Duration::from_secs(60);

/// Opens a connection that takes a few KiB before its client reads, and sends `text`.
async fn say(address: &str, text: &str) -> TcpStream {
    let socket = TcpSocket::new_v4().unwrap();
    socket.set_recv_buffer_size(4096).unwrap();
    let mut stream = socket.connect(address.parse().unwrap()).await.unwrap();
    // It may be closed meanwhile for a newcomer.
    drop(stream.write_all(text.as_bytes()).await);
    stream
}

fn head(address: &str, line: &str, more: &str) -> String {
    format!("{line} HTTP/1.1\r\nhost: {address}\r\ncontent-type: application/json\r\n{more}\r\n")
}

/// Sends STOP as the login page does: without a session.
async fn stop(address: &str) {
    let more = "connection: close\r\ncontent-length: 2\r\n";
    let mut stream = say(address, &(head(address, "POST /api/stop", more) + "{}")).await;
    let mut said = String::new();
    tokio::time::timeout(LONG, stream.read_to_string(&mut said)).await.expect("a stop waits").unwrap();
    assert!(said.starts_with("HTTP/1.1 200") && said.contains("cycle_age_s"), "{said}");
}

/// STOP is answered without a session and over a page, and an operator opens a new page that commands.
async fn operator_commands(served: &Served, operator: &Visitor, page: &mut Page) {
    stop(&served.address).await;
    page.order("stop").await;
    page.order("hold").await;
    let mut new = served.page(operator).await;
    new.take_over().await;
    new.order("stop").await;
    page.take_over().await;
}

fn of(everybody: &[(Role, Visitor)], wanted: Role) -> Visitor {
    everybody.iter().find(|(role, _)| *role == wanted).unwrap().1.clone()
}

/// Slow heads, unfinished logins, slow bodies of a user, and answers without a reader: 300 at once.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn three_hundred_slow_clients_keep_nobody_out() {
    let served = Served::new().await;
    let everybody = served.bench.everybody().await;
    let (operator, viewer) = (of(&everybody, Role::Operator), of(&everybody, Role::Viewer));
    let mut page = served.page(&operator).await;
    let address = &served.address;
    let by = format!("cookie: {}\r\nx-seamwright: {}\r\n", viewer.cookie, viewer.token);
    let login = head(address, "POST /api/login", "x-seamwright: login\r\ncontent-length: 8000\r\n") + "{";
    let slow_body = head(address, "POST /api/form", &format!("{by}content-length: 4000000\r\n")) + "{";
    let unread = head(address, "GET /api/openapi.json", &by);
    let mut slow = Vec::new();
    for i in 0..75 {
        slow.push(say(address, &format!("GET / HTTP/1.1\r\nhost: {address}\r\nx-{i}:")).await);
        slow.push(say(address, &login).await);
        slow.push(say(address, &slow_body).await);
        slow.push(say(address, &unread).await);
        if i % 25 == 24 {
            operator_commands(&served, &operator, &mut page).await;
        }
    }
    let (status, _) = served.bench.ask(operator.request("GET", "/api/jobs", None)).await;
    assert_eq!((slow.len(), status), (300, StatusCode::OK));
}

/// All places of pages but the reserved ones are taken: the next page of a viewer is refused, those of operators are not.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn an_operator_gets_a_page_while_all_others_are_taken() {
    let served = Served::new().await;
    let everybody = served.bench.everybody().await;
    let operator = of(&everybody, Role::Operator);
    let mut page = served.page(&operator).await;
    let hub = &served.bench.panel.cell.hub;
    let open = |user: String, role| std::iter::from_fn(move || hub.connect(&user, role));
    let viewers: Vec<_> = (0..4).flat_map(|i| open(format!("viewer {i}"), Role::Viewer).take(MAX_PAGES)).collect();
    let others: Vec<_> = (0..4).flat_map(|i| open(format!("service {i}"), Role::Service).take(MAX_PAGES)).collect();
    assert_eq!(viewers.len(), MAX_VIEWER_PAGES);
    // The last one of each user counts among the reserved places if he has no other.
    assert!(1 + viewers.len() + others.len() >= MAX_PAGES - PAGES_KEPT_FOR_OPERATORS);
    let upgrade = "connection: upgrade\r\nupgrade: websocket\r\nsec-websocket-version: 13\r\n\
                   sec-websocket-key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    let by = format!("cookie: {}\r\n{upgrade}", of(&everybody, Role::Viewer).cookie);
    let mut refused = say(&served.address, &head(&served.address, "GET /api/live", &by)).await;
    let mut said = [0; 12];
    tokio::time::timeout(LONG, refused.read_exact(&mut said)).await.unwrap().unwrap();
    assert_eq!(&said, b"HTTP/1.1 503");
    stop(&served.address).await;
    page.order("stop").await;
    let mut first = served.page(&of(&everybody, Role::Admin)).await;
    first.order("stop").await;
}

/// A page that does not read is disconnected once its queue is full. Others miss nothing.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_page_that_never_reads_is_disconnected() {
    let (served, owner) = Served::with_owner().await;
    let hub = &served.bench.panel.cell.hub;
    let mut page = served.page(&owner).await;
    let upgrade = "connection: upgrade\r\nupgrade: websocket\r\nsec-websocket-version: 13\r\n\
                   sec-websocket-key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    let by = format!("cookie: {}\r\n{upgrade}", owner.cookie);
    let asleep = say(&served.address, &head(&served.address, "GET /api/live", &by)).await;
    while hub.clients() < 2 {
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    let long = "x".repeat(10_000);
    let event = |marked: &str| Message::new("server-event-restored").text("folder", format!("{marked} {long}"));
    let mut rounds = 0;
    while hub.clients() > 1 {
        (0..200).for_each(|i| hub.event(0.0, happening(event(&format!("{rounds}-{i}")))));
        let last = format!("{rounds}-199 ");
        page.until("the last event", |v| v["text"].as_str().is_some_and(|text| text.contains(&last))).await;
        rounds += 1;
        assert!(rounds < 200, "it is still connected");
    }
    stop(&served.address).await;
    page.order("stop").await;
    drop(asleep);
    // A new page gets the recent events only.
    let mut new = served.page(&owner).await;
    new.order("stop").await;
    let events = new.events.iter().filter(|event| event.contains(&long)).count();
    assert!((RECENT_EVENTS - 10..=RECENT_EVENTS).contains(&events), "{events}");
}

/// A page that sends more than its rate is closed.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_page_that_floods_is_closed() {
    let (served, owner) = Served::with_owner().await;
    let mut page = served.page(&owner).await;
    let mut flooding = served.page(&owner).await;
    for _ in 0..10 * MESSAGE_BURST as usize {
        if !flooding.tries_to_say("{}").await {
            break;
        }
    }
    flooding.closed().await;
    stop(&served.address).await;
    page.order("stop").await;
}

/// Fills a queue with work that ends once `block` is free.
async fn fill(panel: &Arc<Panel>, turns: fn(&Panel) -> &Turns, queue: Queue, block: &Arc<Mutex<()>>) {
    for _ in 0..queue.at_once + queue.waiting {
        let (panel, block) = (Arc::clone(panel), Arc::clone(block));
        tokio::spawn(async move {
            let work = move || {
                drop(block.lock());
                Ok(())
            };
            drop(turns(&panel).run(work).await);
        });
    }
    while !turns(panel).is_full() {
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
}

/// Every queue of handlers is full: one more request is refused at once, and stops and pages go on.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[allow(clippy::await_holding_lock, reason = "that handlers wait for it is what is tried")]
async fn queues_that_are_full_refuse_and_hold_up_no_stop() {
    let served = Served::new().await;
    let everybody = served.bench.everybody().await;
    let (operator, admin) = (of(&everybody, Role::Operator), of(&everybody, Role::Admin));
    let mut page = served.page(&operator).await;
    let panel = &served.bench.panel;
    let (block, body) = (Arc::new(Mutex::new(())), json!({ "text": "" }));
    let held = block.lock().unwrap();
    fill(panel, |panel| &panel.reading, limits::READING, &block).await;
    fill(panel, |panel| &panel.drawing, limits::DRAWING, &block).await;
    fill(panel, |panel| &panel.saving, limits::SAVING, &block).await;
    fill(panel, |panel| &panel.planning, limits::LOADING, &block).await;
    fill(panel, |panel| &panel.backing_up, limits::BACKING_UP, &block).await;
    fill(panel, |panel| &panel.checking, limits::CHECKING, &block).await;
    fill(panel, |panel| panel.planner.turns()[0], limits::PLANNING, &block).await;
    fill(panel, |panel| panel.planner.turns()[1], limits::PLANNING, &block).await;
    for (method, path, body) in [
        ("GET", "/api/jobs", None),
        ("GET", "/api/records", None),
        ("GET", "/api/audit", None),
        ("GET", "/api/parameters", None),
        ("PUT", "/api/jobs/x.toml", Some(&body)),
        ("GET", "/api/tuning?axis=x", None),
        ("GET", "/api/backup", None),
        ("POST", "/api/plan", Some(&body)),
        ("POST", "/api/draft", Some(&body)),
    ] {
        let (status, answer) = served.bench.ask(admin.request(method, path, body)).await;
        assert_eq!(status, StatusCode::SERVICE_UNAVAILABLE, "{method} {path}: {answer}");
    }
    let (status, _) = served.bench.ask(super::login("Viewer", "password of Viewer")).await;
    assert_eq!(status, StatusCode::SERVICE_UNAVAILABLE);
    operator_commands(&served, &operator, &mut page).await;
    drop(held);
}

/// Requests with one more than allowed of anything that is counted.
#[tokio::test(flavor = "multi_thread")]
async fn one_more_than_allowed_is_refused() {
    let (bench, owner) = Bench::with_owner().await;
    let refused = async |method: &str, path: &str, body: Value| {
        let body = Some(&body).filter(|body| !body.is_null());
        let (status, answer) = bench.ask(owner.request(method, path, body)).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{method} {path}: {answer}");
        answer["code"].as_str().unwrap().to_owned()
    };
    let long = |chars: usize| "x".repeat(chars);
    let many = |count: usize, of: Value| Value::Array(vec![of; count]);
    let job = json!({ "text": "title = \"x\"\nmachine = \"m\"\n" });
    let name = format!("/api/jobs/{}.toml", long(MAX_JOB_NAME_BYTES - 4));
    assert_eq!(refused("PUT", &name, job.clone()).await, "server-job-name");
    let operations = many(MAX_OPERATIONS + 1, json!({ "op": "delete_points", "pass": 1, "from": 2 }));
    let edit = json!({ "text": "", "operations": operations });
    assert_eq!(refused("POST", "/api/edit", edit).await, "server-too-many-operations");
    let changes = many(MAX_FORM_CHANGES + 1, json!({ "op": "remove", "path": "a" }));
    let form = json!({ "text": "", "changes": changes });
    assert_eq!(refused("POST", "/api/form", form).await, "server-too-many-operations");
    let load = json!({ "job": "ellipse.toml", "from": null, "part": long(MAX_PART_CHARS + 1) });
    assert_eq!(refused("POST", "/api/load", load).await, "server-part-number");
    let points = many(MAX_PLACE_POINTS + 1, json!({ "feature": "face", "tip": [0, 0, 0] }));
    let place = json!({ "text": "", "method": "chuck", "probe_radius_mm": 0, "points": points });
    assert_eq!(refused("POST", "/api/place", place).await, "server-too-many-points");
    let touches = json!({ "head": 0, "touches": many(MAX_TOUCHES + 1, json!([0, 0])) });
    assert_eq!(refused("POST", "/api/tool", touches).await, "server-too-many-touches");
    for path in ["/api/records", "/api/audit"] {
        let path = format!("{path}?text={}", long(MAX_SEARCH_CHARS + 1));
        assert_eq!(refused("GET", &path, Value::Null).await, "server-search-too-long");
    }
    let (status, _) = bench.ask(owner.request("GET", "/api/audit?most=4000000000", None)).await;
    assert_eq!(status, StatusCode::OK);
    // Texts that end a thread by their depth if they are parsed.
    let deep = format!("a = {}1{}", "{ a.a.a.a.a.a.a.a.a.a = ".repeat(79), " }".repeat(79));
    let (status, answer) =
        bench.ask(owner.request("POST", "/api/form", Some(&json!({ "text": deep, "changes": [] })))).await;
    assert!(status == StatusCode::OK && answer["wrong"].to_string().contains("nested"), "{answer}");
    let edit = json!({ "text": deep, "operations": [] });
    let (status, answer) = bench.ask(owner.request("POST", "/api/edit", Some(&edit))).await;
    assert!(status == StatusCode::UNPROCESSABLE_ENTITY && answer.to_string().contains("nested"), "{answer}");
}

/// A job file that is larger than any request is not read; it can be removed. One more job than allowed is not saved.
#[tokio::test(flavor = "multi_thread")]
async fn jobs_are_bounded_in_size_and_number() {
    let (bench, owner) = Bench::with_owner().await;
    let jobs = bench.path().join("jobs");
    std::fs::File::create(jobs.join("large.toml")).unwrap().set_len(MAX_JOB_BYTES + 1).unwrap();
    let ask =
        async |method: &str, body: Option<&Value>| bench.ask(owner.request(method, "/api/jobs/large.toml", body)).await;
    let (status, answer) = ask("GET", None).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{answer}");
    assert!(answer["text"].as_str().unwrap().contains("larger than 4 MiB"), "{answer}");
    let body = json!({ "text": "", "over": "" });
    assert_eq!(ask("PUT", Some(&body)).await.0, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(bench.load(&owner, "large.toml", None).await.0, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(bench.ask(owner.request("GET", "/api/jobs", None)).await.0, StatusCode::OK);
    assert_eq!(ask("DELETE", None).await.0, StatusCode::NO_CONTENT);
    (0..MAX_JOBS - 1).for_each(|i| std::fs::write(jobs.join(format!("{i}.toml")), "").unwrap());
    let text = json!({ "text": "title = \"x\"\nmachine = \"m\"\n" });
    let put = async |name: &str| bench.ask(owner.request("PUT", &format!("/api/jobs/{name}.toml"), Some(&text))).await;
    assert_eq!(put("last").await.0, StatusCode::OK);
    let (status, answer) = put("one-more").await;
    assert_eq!((status, &answer["code"]), (StatusCode::UNPROCESSABLE_ENTITY, &json!("server-too-many-jobs")));
    // One that is there is still saved.
    assert_eq!(put("7").await.0, StatusCode::OK);
}
