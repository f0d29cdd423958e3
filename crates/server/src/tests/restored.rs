//! Replacement of all data from a page.

use super::lived::Served;
use super::{Bench, Visitor, cell_start};
use crate::serve::{Settings, until};
use crate::wire::Role;
use axum::body::Body;
use axum::http::{Request, StatusCode};
use http_body_util::BodyExt as _;
use seamwright_executive::realtime::{Shutdown, ShutdownCause};
use seamwright_machine::shipped;
use seamwright_record::library::AuditEntry;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::mpsc::channel;
use std::time::Duration;
use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::TcpStream;

fn archive(of: &Visitor, bytes: Vec<u8>) -> Request<Body> {
    let mut request = of.request("PUT", "/api/restore", None);
    request.headers_mut().insert("content-type", "application/x-tar".parse().unwrap());
    *request.body_mut() = Body::from(bytes);
    request
}

async fn backup(bench: &Bench, of: &Visitor) -> Vec<u8> {
    let answer = bench.raw(of.request("GET", "/api/backup", None)).await;
    answer.into_body().collect().await.unwrap().to_bytes().to_vec()
}

/// Checks before anything is replaced: permission, size and completeness.
#[tokio::test(flavor = "multi_thread")]
async fn archives_are_checked_whole_and_by_the_administrator_only() {
    let (bench, owner) = Bench::with_owner().await;
    // An archive without users keeps those of the cell.
    let without = backup(&bench, &owner).await;
    assert_eq!(bench.ask(archive(&owner, without.clone())).await.0, StatusCode::OK);
    let everybody = bench.everybody().await;
    let whole = backup(&bench, &everybody[0].1).await;
    for (role, visitor) in &everybody {
        let (status, answer) = bench.ask(archive(visitor, whole.clone())).await;
        assert_eq!(status == StatusCode::OK, *role == Role::Admin, "{role:?} {answer}");
        let begin = visitor.request("POST", "/api/restore", Some(&json!({ "own_password": "guess" })));
        assert_eq!(bench.ask(begin).await.0, StatusCode::FORBIDDEN, "{role:?}");
    }
    let admin = &everybody[0].1;
    let (_, view) = bench.ask(archive(admin, whole.clone())).await;
    assert_eq!((&view["users"], &view["jobs"], &view["newest"]), (&json!(5), &json!(0), &Value::Null), "{view}");
    let waits = || bench.path().join("restore-checked").exists();
    assert!(waits());
    let (status, view) = bench.ask(archive(admin, without)).await;
    assert_eq!((status, &view["users"]), (StatusCode::OK, &json!(5)), "{view}");
    // A user who may make backups but not change users gets no password hashes.
    let service = everybody.iter().find(|(role, _)| *role == Role::Service).unwrap();
    let hashes = |archive: &[u8]| String::from_utf8_lossy(archive).contains("argon2");
    assert!(hashes(&whole) && !hashes(&backup(&bench, &service.1).await));
    assert_eq!(bench.ask(archive(admin, whole.clone())).await.0, StatusCode::OK);
    for (bytes, key) in [
        (whole[..whole.len() / 2].to_vec(), "archive"),
        (whole[..whole.len() - 1024].to_vec(), "archive"),
        (vec![], "archive"),
        (b"\x1f\x8b\x08 compressed".repeat(500), "archive"),
    ] {
        let (status, answer) = bench.ask(archive(admin, bytes)).await;
        assert_eq!((status, &answer["key"]), (StatusCode::UNPROCESSABLE_ENTITY, &json!(key)), "{answer}");
        assert!(!waits() && !bench.path().join("restore-upload.tar").exists());
    }
    // A declared size above the limit is refused at once.
    let mut large = archive(admin, vec![0; 512]);
    large.headers_mut().insert("content-length", "99999999999999".parse().unwrap());
    assert_eq!(bench.ask(large).await.0, StatusCode::PAYLOAD_TOO_LARGE);
    // A form of a foreign page cannot send the content type of an archive.
    let mut form = archive(admin, whole.clone());
    form.headers_mut().insert("content-type", "text/plain".parse().unwrap());
    assert_eq!(bench.ask(form).await.0, StatusCode::UNSUPPORTED_MEDIA_TYPE);
    // No archive is left to restore.
    let own = json!({ "own_password": "password of Admin" });
    assert_eq!(bench.ask(admin.request("POST", "/api/restore", Some(&own))).await.0, StatusCode::NOT_FOUND);
    assert!(bench.panel.restores.borrow().is_none());
}

/// With powered drives nothing is replaced or checked.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_machine_that_is_on_keeps_its_data() {
    let (served, owner) = Served::with_owner().await;
    let bench = &served.bench;
    let whole = backup(bench, &owner).await;
    assert_eq!(bench.ask(archive(&owner, whole.clone())).await.0, StatusCode::OK);
    let mut page = served.page(&owner).await;
    page.say(&json!({ "kind": "take_control", "over": false })).await;
    page.ask(json!({ "do": "switch_on" })).await;
    page.until_status("on", |v| v["mode"] != "off").await;
    assert_eq!(bench.ask(archive(&owner, whole)).await.0, StatusCode::CONFLICT);
    let begin = owner.request("POST", "/api/restore", Some(&json!({ "own_password": null })));
    assert_eq!(bench.ask(begin).await.0, StatusCode::CONFLICT);
    assert!(bench.panel.restores.borrow().is_none());
}

/// Sends a request on its own connection; returns status and answer.
async fn says(address: &str, head: &str, body: &[u8]) -> Option<(u16, String)> {
    let mut stream = TcpStream::connect(address).await.ok()?;
    let host = format!("host: {address}\r\nconnection: close\r\ncontent-length: {}\r\n\r\n", body.len());
    stream.write_all(format!("{head}\r\n{host}").as_bytes()).await.ok()?;
    stream.write_all(body).await.ok()?;
    let mut said = Vec::new();
    stream.read_to_end(&mut said).await.ok()?;
    let said = String::from_utf8_lossy(&said).into_owned();
    let status = said.split(' ').nth(1)?.parse().ok()?;
    Some((status, said))
}

pub(super) fn settings(data: &Path) -> Settings {
    Settings {
        program: None,
        monitor_token: None,
        cameras: Vec::new(),
        bind: "127.0.0.1:0".parse().unwrap(),
        names: vec![],
        tls: None,
        data: data.to_owned(),
        machine: cell_start(data, shipped("ellipse-xy").unwrap().text).machine,
        values: vec![],
        job: Some("mine.toml".to_owned()),
        syslog: None,
    }
}

/// Full sequence: the cell ends, its data are replaced, it restarts at the same address, and all users must log in
/// again.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_cell_begins_anew_with_restored_data() {
    // Data of yesterday, with user Ada and a job.
    let (bench, owner) = Bench::with_owner().await;
    let (_, example) = bench.ask(owner.request("GET", "/api/jobs/ellipse.toml", None)).await;
    let body = json!({ "text": example["text"] });
    bench.ask(owner.request("PUT", "/api/jobs/yesterday.toml", Some(&body))).await;
    bench.panel.accounts.put("ada", Role::Admin, true, Some("correct horse")).unwrap();
    let ada = bench.log_in("ada", "correct horse").await.unwrap();
    let whole = backup(&bench, &ada).await;
    // A cell of today without users, with another job.
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("jobs")).unwrap();
    std::fs::write(folder.path().join("jobs/mine.toml"), example["text"].as_str().unwrap()).unwrap();
    let (told, address) = channel::<String>();
    let end = Shutdown::default();
    let ends = end.clone();
    let of = settings(folder.path());
    let served = std::thread::spawn(move || until(&of, |url| told.send(url.to_owned()).unwrap(), &ends));
    let url = address.recv_timeout(Duration::from_secs(60)).unwrap();
    let (host, key) = url.strip_prefix("http://").unwrap().split_once("/#key=").unwrap();
    let log_in = async |user: &str, password: &str| {
        let body = json!({ "user": user, "password": password }).to_string();
        let head = "POST /api/login HTTP/1.1\r\ncontent-type: application/json\r\nx-seamwright: login";
        let (status, said) = says(host, head, body.as_bytes()).await?;
        let cookie = said.split("set-cookie: ").nth(1)?.split(';').next()?.to_owned();
        let token = said.split("\"token\":\"").nth(1)?.split('"').next()?.to_owned();
        (status == 200).then_some(format!("cookie: {cookie}\r\nx-seamwright: {token}"))
    };
    let session = log_in("", key).await.unwrap();
    let put = format!("PUT /api/restore HTTP/1.1\r\ncontent-type: application/x-tar\r\n{session}");
    let (status, said) = says(host, &put, &whole).await.unwrap();
    assert!(status == 200 && said.contains("\"users\":1") && said.contains("\"jobs\":1"), "{said}");
    let post = format!("POST /api/restore HTTP/1.1\r\ncontent-type: application/json\r\n{session}");
    let (status, said) = says(host, &post, b"{\"own_password\":null}").await.unwrap();
    assert_eq!(status, 202, "{said}");
    // New connections wait meanwhile; the old session and the key are invalid afterwards.
    let ask = async |session: &str, path: &str| says(host, &format!("GET {path} HTTP/1.1\r\n{session}"), b"").await;
    let mut tries = 0;
    while !matches!(ask(&session, "/api/session").await, Some((401, _))) {
        tries += 1;
        assert!(tries < 600, "the old session is still one");
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    assert!(log_in("", key).await.is_none());
    let ada = log_in("ada", "correct horse").await.unwrap();
    let (_, jobs) = ask(&ada, "/api/jobs").await.unwrap();
    assert!(jobs.contains("yesterday.toml") && !jobs.contains("mine.toml"), "{jobs}");
    let (_, audit) = ask(&ada, "/api/audit").await.unwrap();
    assert!(audit.contains("restored; what was there before is in before-restore-"), "{audit}");
    end.request(ShutdownCause::Asked);
    tokio::task::spawn_blocking(move || served.join().unwrap().unwrap()).await.unwrap();
    let data = seamwright_record::DataFolder::open_to_read(folder.path()).unwrap();
    assert!(data.verify().unwrap().problems.is_empty());
    let kept = std::fs::read_dir(folder.path()).unwrap().flatten().map(|e| e.path());
    let kept = kept.into_iter().find(|p| p.to_string_lossy().contains("before-restore-")).unwrap();
    assert!(kept.join("jobs/mine.toml").is_file());
    let old = seamwright_record::DataFolder::open_to_read(&kept).unwrap();
    let last = old.library().audit_entries(5).unwrap();
    let begun =
        |e: &&AuditEntry| e.user == "owner" && e.command.contains("audit-restore") && e.result.contains("audit-begun");
    assert_eq!(last.iter().filter(begun).count(), 1, "{last:?}");
}
