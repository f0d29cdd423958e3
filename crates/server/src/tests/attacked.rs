//! Thousands of malformed requests and messages, path traversal, expired sessions, guessed passwords.

use super::lived::Served;
use super::{Bench, KEY, Visitor, login};
use crate::cell::Change;
use crate::http::{all_routes, hears};
use crate::users::{least, may};
use crate::wire::{AskView, Role};
use axum::body::Body;
use axum::http::StatusCode;
use futures_util::StreamExt as _;
use seamwright_testkit::Random;
use serde_json::{Value, json};
use std::time::{Duration, Instant};
use tokio_tungstenite::tungstenite::client::IntoClientRequest as _;

fn random_bytes(random: &mut Random, most: usize) -> Vec<u8> {
    (0..random.below(most + 1)).map(|_| random.bits() as u8).collect()
}

/// Returns nearly valid bytes: some changed, cut or doubled.
fn mutated(random: &mut Random, text: &str) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len().max(1)).min(bytes.len());
        match random.below(4) {
            0 => bytes.truncate(at),
            1 => bytes.insert(at, *random.one(b"\"{}[]\\\0,:-9e.tn\xff")),
            2 if at < bytes.len() => bytes[at] = random.bits() as u8,
            _ => bytes.extend_from_within(at..),
        }
    }
    bytes
}

/// Bodies that one route or another accepts.
const BODIES: [&str; 8] = [
    r#"{"text":"title = \"x\"\nmachine = \"saddle-4axis\"\n"}"#,
    r#"{"text":"schema = 1","dialect":"pmac"}"#,
    r#"{"text":"schema = 1","operations":[{"delete":{"pass":1}}]}"#,
    r#"{"job":"ellipse.toml","from":[1,2.5],"part":"N-17"}"#,
    r#"{"user":"ada","password":"guess"}"#,
    r#"{"role":"emperor","password":"0123456789","enabled":true,"own_password":null}"#,
    r#"{"own_password":1e400}"#,
    "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
];

/// Query of a picture of a grid.
const PLATE: &str = "?name=camera&pitch_mm=3&z_mm=0";

fn takes(method: &str, route: &str) -> &'static str {
    match (method, route) {
        ("put", "/api/restore") => "application/x-tar",
        ("post", "/api/sensor") => "image/png",
        _ => "application/json",
    }
}

/// Every request is answered without a server error, and nothing has changed afterwards.
#[tokio::test(flavor = "multi_thread")]
async fn thousands_of_malformed_requests_are_refused() {
    let (bench, owner) = Bench::with_owner().await;
    let mut random = Random::new(10);
    let mut asked = 0;
    for (method, route, _) in all_routes() {
        if route == "/api/logout" || route == "/api/backup" {
            continue;
        }
        for _ in 0..120 {
            let odd = ["..", "%2e%2e%2f", "%00", "9999999999999999999", "-1", "a%0ab.toml", "%ff", "'"];
            let path = route.replace("{name}", random.one::<&str>(&odd)).replace("{id}", random.one::<&str>(&odd));
            let query =
                [PLATE, "", "?", "?most=-1", "?columns=,,,&most=3", "?job=%00", "?from=x&to=%ff", "?text=%25%27"];
            let path = format!("{path}{}", *random.one(&query));
            let body = if random.below(2) == 0 {
                random_bytes(&mut random, 200)
            } else {
                let body = *random.one(&BODIES);
                mutated(&mut random, body)
            };
            let mut request = owner.request(&method.to_uppercase(), &path, None);
            if route == "/api/login" {
                request.headers_mut().insert("x-seamwright", "login".parse().unwrap());
            }
            request.headers_mut().insert("content-type", takes(method, route).parse().unwrap());
            *request.body_mut() = Body::from(body.clone());
            let (status, answer) = bench.ask(request).await;
            let text = String::from_utf8_lossy(&body);
            assert!(!status.is_server_error(), "{method} {path} {text}: {status} {answer}");
            asked += 1;
        }
        // An archive is much larger and has its own limit.
        if method != "get" && (method, route) != ("put", "/api/restore") {
            let most = if route == "/api/login" { 9 << 10 } else { 5 << 20 };
            let large = json!({ "text": "x".repeat(most), "user": "", "password": "" });
            let path = format!("{}{PLATE}", route.replace("{name}", "x.toml"));
            let mut request = owner.request(&method.to_uppercase(), &path, Some(&large));
            request.headers_mut().insert("content-type", takes(method, route).parse().unwrap());
            if route == "/api/login" {
                request.headers_mut().insert("x-seamwright", "login".parse().unwrap());
            }
            let status = bench.ask(request).await.0;
            // Routes that read no body ignore its size.
            let removes = ["/api/jobs/{name}", "/api/schedules/{name}", "/api/schedules/{name}/run"];
            let unread =
                (method == "delete" && removes.contains(&route)) || ["/api/stop", "/api/planning"].contains(&route);
            assert!(status == StatusCode::PAYLOAD_TOO_LARGE || unread, "{method} {route}: {status}");
        }
    }
    assert!(asked > 2500, "{asked}");
    assert!(bench.panel.accounts.list().is_empty() && bench.panel.cell.hub.holder().is_none());
    assert_eq!(std::fs::read_dir(bench.path().join("jobs")).unwrap().count(), 0);
    bench.panel.cell.archive.audit("test", "test", "end", Change::default(), "");
    let data = seamwright_record::DataFolder::open_to_read(bench.path()).unwrap();
    while data.library().audit_entries(1).unwrap()[0].command != "end" {
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
    assert!(data.library().verify_audit().unwrap().broken.is_none());
    // Audit entries are single lines, whatever their source.
    let entries = data.library().audit_entries(10_000).unwrap();
    assert!(entries.iter().all(|e| ![&e.user, &e.command, &e.result].iter().any(|f| f.contains(char::is_control))));
}

fn commands() -> Vec<Value> {
    let schema = schemars::schema_for!(AskView).to_value();
    let kinds = schema["oneOf"].as_array().unwrap();
    let all: Vec<Value> = kinds
        .iter()
        .map(|kind| {
            let mut ask = json!({ "do": kind["properties"]["do"]["const"] });
            if !kind["properties"]["part"].is_null() {
                ask["part"] = json!(0.5);
            }
            ask
        })
        .collect();
    assert!(all.len() >= 15, "{schema}");
    all
}

/// Every command by every role is refused for the role or for missing control; a repeated number is refused too.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn every_command_wants_a_role_control_and_a_new_number() {
    let served = Served::new().await;
    for (role, visitor) in served.bench.everybody().await {
        let mut page = served.page(&visitor).await;
        for ask in commands() {
            let name = ask["do"].as_str().unwrap().to_owned();
            assert!(least(&name).is_some(), "{name} is not in the table of permissions");
            let answer = page.ask(ask.clone()).await;
            let expected = match name.as_str() {
                "stop" => Value::Null,
                _ if !may(role, &name) => json!("role"),
                "hold" => Value::Null,
                _ => json!("control"),
            };
            assert_eq!(answer["why"]["key"], expected, "{role:?} {name}");
            if name == "stop" || !may(role, &name) {
                continue;
            }
            let again = page.again(ask).await;
            assert_eq!(again["why"]["key"], "replayed", "{role:?} {name}");
        }
        let jog = json!({ "kind": "jog", "seq": 1, "of": "joints", "speeds": [1.0, 1.0] });
        page.say(&jog).await;
        page.say(&json!({ "kind": "take_control", "over": true })).await;
        let took = page
            .until("control or not", |v| v["why"]["key"] == "role" || (v["kind"] == "control" && v["mine"] == true));
        assert_eq!(took.await["kind"] == "control", may(role, "take_control"), "{role:?}");
        page.say(&json!({ "kind": "give_control" })).await;
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn sockets_want_a_session_and_a_page_of_ours() {
    let (served, owner) = Served::with_owner().await;
    let open = |name: &'static str, value: String| {
        let mut request = format!("ws://{}/api/live", served.address).into_client_request().unwrap();
        request.headers_mut().insert("cookie", owner.cookie.parse().unwrap());
        request.headers_mut().insert(name, value.parse().unwrap());
        async { tokio_tungstenite::connect_async(request).await.map(|(socket, _)| socket).map_err(|e| e.to_string()) }
    };
    assert!(open("origin", format!("http://{}", served.address)).await.is_ok());
    for (name, value) in [
        ("cookie", "seamwright=guess"),
        ("cookie", "other=1"),
        ("origin", "http://evil.example"),
        ("origin", "http://localhost:3000"),
        ("origin", "null"),
        ("origin", ""),
        ("host", "evil.example"),
        ("sec-fetch-site", "same-site"),
    ] {
        let refused = open(name, value.to_owned()).await.unwrap_err();
        assert!(refused.contains("401") || refused.contains("403"), "{name} {value}: {refused}");
    }
    // Too long or not text: the connection is closed.
    for message in [
        tokio_tungstenite::tungstenite::Message::text("x".repeat(17 << 10)),
        tokio_tungstenite::tungstenite::Message::binary(vec![0u8; 16]),
    ] {
        let mut socket = open("accept", "*/*".to_owned()).await.unwrap();
        futures_util::SinkExt::send(&mut socket, message).await.unwrap();
        let ended = async { while let Some(Ok(_)) = socket.next().await {} };
        tokio::time::timeout(Duration::from_secs(10), ended).await.unwrap();
    }
    // The number of sockets of a user is limited.
    let mut open_ones = Vec::new();
    let refused = loop {
        match open("accept", "*/*".to_owned()).await {
            Ok(socket) => open_ones.push(socket),
            Err(refused) => break refused,
        }
        assert!(open_ones.len() <= 64);
    };
    assert!(refused.contains("503"), "{refused}");
    drop(open_ones);
    let begin = Instant::now();
    while open("accept", "*/*".to_owned()).await.is_err() {
        assert!(begin.elapsed() < Duration::from_secs(20), "their places stay taken");
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
}

/// Random mutations of all messages, from a viewer: no motion, no control.
#[tokio::test(flavor = "multi_thread")]
async fn thousands_of_malformed_messages_move_nothing() {
    let bench = Bench::new().await;
    let mut all: Vec<String> =
        commands().into_iter().map(|ask| json!({ "kind": "command", "seq": 1, "ask": ask }).to_string()).collect();
    all.push(json!({ "kind": "jog", "seq": 1, "of": "tip", "speeds": [1.0, -1.0, 0.0] }).to_string());
    all.extend([json!({ "kind": "beat" }), json!({ "kind": "take_control", "over": true })].map(|m| m.to_string()));
    all.push(json!({ "kind": "why", "ask": "start_weld" }).to_string());
    let mut random = Random::new(20);
    let texts: Vec<String> = (0..5000)
        .map(|_| {
            let bytes = match random.below(3) {
                0 => random_bytes(&mut random, 300),
                _ => {
                    let text = random.one(&all).clone();
                    mutated(&mut random, &text)
                }
            };
            String::from_utf8_lossy(&bytes).into_owned()
        })
        .collect();
    bench.everybody().await;
    let (_, session) = bench.panel.sessions.begin("Viewer", Role::Viewer).unwrap();
    drop(hears(&bench.panel, &session, &texts));
    tokio::time::sleep(Duration::from_millis(300)).await;
    let status = bench.panel.cell.hub.latest().unwrap();
    assert!(status.mode == "off" && !status.powered && !status.armed, "{status:?}");
    assert!(bench.panel.cell.hub.holder().is_none());
    // Invalid command numbers are refused.
    for bad in ["1e999", "-1", "1.5", "4294967296", "null", "\"1\""] {
        let text = format!(r#"{{"kind":"command","seq":{bad},"ask":{{"do":"arm"}}}}"#);
        assert!(serde_json::from_str::<crate::wire::ToCell>(&text).is_err(), "{bad}");
    }
}

/// Texts from the panel read only files in the folder of jobs, and reveal nothing of others.
#[tokio::test(flavor = "multi_thread")]
async fn jobs_lead_to_no_other_files() {
    let bench = Bench::new().await;
    bench.everybody().await;
    let outside = bench.path().join("users.json");
    let outside = outside.to_str().unwrap();
    let visitor = bench.log_in("Programmer", "password of Programmer").await.unwrap();
    let (_, example) = bench.ask(visitor.request("GET", "/api/jobs/ellipse.toml", None)).await;
    let text = example["text"].as_str().unwrap();
    let machine = text.lines().find(|l| l.starts_with("machine")).unwrap();
    let (head, rest) = text.split_once("[seam.ellipse]").unwrap();
    let (_, tail) = rest.split_once("[start]").unwrap();
    for name in ["../users.json", outside, "/etc/passwd", "/dev/zero", "../library.sqlite", "../tls/ca.key", ".."] {
        let fixture = format!("{text}\n[[fixtures]]\nname = \"f\"\nshape.stl = {{ file = \"{name}\" }}\n");
        let table = format!("{head}[seam.spline]\nfile = \"{name}\"\n[start]{tail}");
        let procedure = text.replace(machine, &format!("{machine}\nprocedure = \"{name}\""));
        for job in [text.replace(machine, &format!("machine = \"{name}\"")), fixture, table, procedure] {
            for path in ["/api/plan", "/api/post"] {
                let body = json!({ "text": job, "dialect": "pmac" });
                let body = if path == "/api/plan" { json!({ "text": job }) } else { body };
                let (status, answer) = bench.ask(visitor.request("POST", path, Some(&body))).await;
                let told = answer.to_string();
                assert!(!status.is_server_error() && answer["kind"] != "planned", "{name}: {told}");
                assert!(told.contains("outside of the folder of the jobs"), "{job}: {told}");
                for secret in ["argon2", "root:", "PRIVATE", "SQLite"] {
                    assert!(!told.contains(secret), "{name}: {told}");
                }
            }
        }
    }
}

/// Permissions that are withdrawn end at once, over HTTP and over an open socket.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_session_ends_with_what_it_was_given_for() {
    let served = Served::new().await;
    let bench = &served.bench;
    let everybody = bench.everybody().await;
    let of = |wanted: Role| everybody.iter().find(|(role, _)| *role == wanted).unwrap().1.clone();
    let (admin, operator) = (of(Role::Admin), of(Role::Operator));
    let mut page = served.page(&operator).await;
    page.until("hello", |v| v["kind"] == "hello").await;
    let (_, before) = bench.panel.sessions.begin("Operator", Role::Operator).unwrap();
    let says =
        ["{\"kind\":\"take_control\",\"over\":true}", "{\"kind\":\"command\",\"seq\":1,\"ask\":{\"do\":\"stop\"}}"];
    let says = says.map(str::to_owned);
    let told = hears(&bench.panel, &before, &says);
    assert!(told.iter().any(|t| t.contains("\"mine\":true")) && !told.iter().any(|t| t.contains("\"login\"")));
    let change = json!({ "role": "operator", "enabled": false, "password": null, "own_password": "password of Admin" });
    let (status, _) = bench.ask(admin.request("PUT", "/api/users/Operator", Some(&change))).await;
    assert_eq!(status, StatusCode::OK);
    // The user's commands are refused except for a stop, and the page is closed.
    let told = hears(&bench.panel, &before, &says);
    assert!(told.iter().any(|t| t.contains("\"login\"")) && !told.iter().any(|t| t.contains("\"mine\":true")));
    assert!(told.iter().any(|t| t.contains("\"seq\":1,\"ok\":true")), "{told:?}");
    page.closed().await;
    assert_eq!(bench.ask(operator.request("GET", "/api/session", None)).await.0, StatusCode::UNAUTHORIZED);
    // A session that started during the change ends too.
    let (cookie, session) = bench.panel.sessions.begin("Operator", Role::Operator).unwrap();
    let late = Visitor { cookie: format!("seamwright={cookie}"), token: session.token };
    assert_eq!(bench.ask(late.request("GET", "/api/session", None)).await.0, StatusCode::UNAUTHORIZED);
    // Another login ends the previous session, and a cookie set beforehand is not accepted.
    let login = |cookie: &str| {
        let mut request = login("Viewer", "password of Viewer");
        request.headers_mut().insert("cookie", cookie.parse().unwrap());
        request
    };
    let viewer = of(Role::Viewer);
    let answer = bench.raw(login(&viewer.cookie)).await;
    let set = answer.headers()["set-cookie"].to_str().unwrap().to_owned();
    assert!(set.contains("HttpOnly") && set.contains("SameSite=Strict") && !set.contains(&viewer.cookie), "{set}");
    assert_eq!(bench.ask(viewer.request("GET", "/api/session", None)).await.0, StatusCode::UNAUTHORIZED);
    let fixed = "0".repeat(64);
    let answer = bench.raw(login(&format!("seamwright={fixed}"))).await;
    assert!(!answer.headers()["set-cookie"].to_str().unwrap().contains(&fixed));
}

/// Simultaneous guesses are counted individually; long names take no room; log entries are single lines.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn guesses_at_once_count_one_by_one() {
    let bench = Bench::new().await;
    bench.everybody().await;
    let guess = |user: &str, password: &str| bench.ask(login(user, password));
    let all = futures_util::future::join_all((0..60).map(|i| guess("Admin", &format!("guess {i}")))).await;
    let checked = all.iter().filter(|(status, _)| *status == StatusCode::UNAUTHORIZED).count();
    assert_eq!(checked, 5);
    assert!(all.iter().all(|(status, _)| *status != StatusCode::OK));
    // The right password must wait too, and reveals nothing by that.
    assert_eq!(guess("Admin", "password of Admin").await.0, StatusCode::TOO_MANY_REQUESTS);
    assert!(guess(&"n".repeat(600), "x").await.0.is_client_error());
    assert_eq!(guess("eve\nAdmin  log in  logged in", "x").await.0, StatusCode::UNAUTHORIZED);
    assert!(guess("", KEY).await.0.is_client_error());
    // Existing and unknown users get the same answer.
    let (known, unknown) = (guess("Viewer", "wrong").await, guess("nobody", "wrong").await);
    assert_eq!(known, unknown);
}

/// Small requests cannot ask for large answers.
#[tokio::test(flavor = "multi_thread")]
async fn what_is_asked_for_is_bounded() {
    let (bench, owner) = Bench::with_owner().await;
    for query in
        [format!("columns={}", vec!["t_s"; 100].join(",")), format!("columns={}&most=20000", "t_s,".repeat(30))]
    {
        let (status, answer) = bench.ask(owner.request("GET", &format!("/api/records/1/trace?{query}"), None)).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{answer}");
        assert!(answer["text"].as_str().unwrap().contains("columns"), "{answer}");
    }
    for (job, part) in [("x\nada  load", ""), ("ellipse.toml", "a\nb"), ("ellipse.toml", "\u{202e}17-N")] {
        let (status, _) = bench.load(&owner, job, Some(part)).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{job:?} {part:?}");
    }
    let (status, _) = bench.load(&owner, "ellipse.toml", Some(&"x".repeat(121))).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY);
}
