//! The panel as a program: it prints its address, answers, shuts down in order, and reports errors.

use crate::common::{bad, write};
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

fn serve(arguments: &[&str]) -> (Child, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .arg("serve")
        .args(["--bind", "127.0.0.1:0"])
        .args(arguments)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    (child, line.trim().to_owned())
}

fn get(address: &str, path: &str) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\nhost: {address}\r\nconnection: close\r\n\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

#[test]
fn the_panel_answers_and_ends_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let (mut child, url) = serve(&["--data", &data, "--job", "ellipse"]);
    let (address, key) = url.strip_prefix("http://").unwrap().split_once("/#key=").unwrap();
    assert_eq!(key.len(), 64);
    let page = get(address, "/");
    assert!(page.starts_with("HTTP/1.1 200") && page.contains("<!doctype html>"), "{page}");
    assert!(get(address, "/api/session").starts_with("HTTP/1.1 401"));
    assert!(get(address, "/../../etc/passwd").starts_with("HTTP/1.1 404"));
    // The port is taken.
    let told = bad(3, &["serve", "--data", &data, "--bind", address]);
    assert!(told.contains(address) && told.contains("allowed"), "{told}");
    let status = Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap();
    assert!(status.success());
    assert!(child.wait().unwrap().success());
    assert!(TcpStream::connect(address).is_err());
}

/// A login and the end reach the syslog receiver.
#[test]
fn the_audit_log_goes_to_a_syslog_receiver() {
    let receiver = std::net::UdpSocket::bind("127.0.0.1:0").unwrap();
    receiver.set_read_timeout(Some(std::time::Duration::from_secs(60))).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let to = format!("udp://{}", receiver.local_addr().unwrap());
    let (mut child, url) = serve(&["--data", &data, "--job", "ellipse", "--syslog", &to]);
    let (address, key) = url.strip_prefix("http://").unwrap().split_once("/#key=").unwrap();
    let login = format!("{{\"user\":\"\",\"password\":\"{key}\"}}");
    let answer = send(address, "POST /api/login HTTP/1.1\r\nx-seamwright: login\r\n", &login);
    assert!(answer.starts_with("HTTP/1.1 200"), "{answer}");
    let mut bytes = [0; 4096];
    let length = receiver.recv(&mut bytes).unwrap();
    let message = std::str::from_utf8(&bytes[..length]).unwrap();
    assert!(message.starts_with("<109>1 20") && message.contains(" AUDIT [audit@32473 user="), "{message}");
    assert!(message.contains("command=\"server-audit-log-in\"") && !message.contains(key), "{message}");
    child.kill().unwrap();
    child.wait().unwrap();
}

/// Every signal shuts it down in order: a closed terminal (SIGHUP) too.
#[test]
fn every_signal_ends_the_panel_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    for signal in ["-HUP", "-INT", "-QUIT"] {
        let (mut child, _) = serve(&["--data", &data, "--job", "ellipse"]);
        assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
        assert_eq!(child.wait().unwrap().code(), Some(0), "{signal}");
    }
}

#[test]
fn what_cannot_be_served_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let told = bad(2, &["serve", "--data", &data, "--bind", "0.0.0.0:8080"]);
    assert!(told.contains("--tls") && told.contains("127.0.0.1"), "{told}");
    let told = bad(2, &["serve", "--data", &data, "--bind", "0.0.0.0:8443", "--tls", "--host", "cell"]);
    assert!(told.contains("administrator"), "{told}");
    assert!(bad(2, &["serve", "--cert", "c.pem"]).contains("--key"));
    assert!(bad(2, &["serve", "--bind", "here"]).contains("--bind"));
    let told = bad(2, &["serve", "--data", &data, "--job", "unknown"]);
    assert!(told.contains("unknown") && told.contains("saddle"), "{told}");
    let told = bad(2, &["serve", "--data", &data, "--machine", "unknown"]);
    assert!(told.contains("saddle-4axis"), "{told}");
    let file = folder.path().join("file");
    std::fs::write(&file, "x").unwrap();
    let told = bad(2, &["serve", "--data", &file.display().to_string()]);
    assert!(told.contains("file"), "{told}");
    let broken = write(folder.path(), "broken.toml", "schema = 1\ntitle = 5\n");
    let told = bad(2, &["serve", "--data", &data, "--job", &broken]);
    assert!(told.contains("title"), "{told}");
    for receiver in ["log.shop.example:514", "udp://", "tcp://log:0", "tls://log:6514"] {
        let message = bad(2, &["serve", "--data", &data, "--syslog", receiver]);
        assert!(
            message.contains("--syslog") && message.contains(receiver) && message.contains("udp://HOST:PORT"),
            "{message}"
        );
    }
    let users = folder.path().join("cell/users.json");
    std::fs::write(users, "{").unwrap();
    let told = bad(2, &["serve", "--data", &data]);
    assert!(told.contains("users.json"), "{told}");
}

fn send(address: &str, head: &str, body: &str) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    let length = body.len();
    write!(stream, "{head}host: {address}\r\nconnection: close\r\ncontent-length: {length}\r\n").unwrap();
    write!(stream, "content-type: application/json\r\n\r\n{body}").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

/// Texts from the panel are drawn and planned by another process; its errors become answers.
#[test]
fn drafts_and_plans_come_from_a_process_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let (mut child, url) = serve(&["--data", &data, "--job", "ellipse"]);
    let (address, key) = url.strip_prefix("http://").unwrap().split_once("/#key=").unwrap();
    let login = format!("{{\"user\":\"\",\"password\":\"{key}\"}}");
    let login = send(address, "POST /api/login HTTP/1.1\r\nx-seamwright: login\r\n", &login);
    let cookie = login.lines().find_map(|l| l.strip_prefix("set-cookie: seamwright=")?.split(';').next()).unwrap();
    let view: serde_json::Value = serde_json::from_str(login.rsplit("\r\n\r\n").next().unwrap()).unwrap();
    let token = view["token"].as_str().unwrap();
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml")).unwrap();
    let ask = |path: &str, text: &str| {
        let head = format!("POST {path} HTTP/1.1\r\ncookie: seamwright={cookie}\r\nx-seamwright: {token}\r\n");
        let answer = send(address, &head, &serde_json::json!({ "text": text }).to_string());
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        assert!(head.starts_with("HTTP/1.1 200"), "{answer}");
        serde_json::from_str::<serde_json::Value>(body).unwrap_or_else(|e| panic!("{e}: {answer}"))
    };
    assert_eq!(ask("/api/draft", &text)["kind"], "drawn");
    let planned = ask("/api/plan", &text);
    assert_eq!((&planned["kind"], &planned["work"]["good"]), (&"planned".into(), &true.into()), "{planned}");
    let wrong = ask("/api/plan", &text.replace("title", "tilte"));
    assert!(wrong["kind"] == "wrong" && wrong["at"]["line"].as_u64().is_some(), "{wrong}");
    let well = get(address, "/healthz");
    assert!(well.starts_with("HTTP/1.1 200") && well.contains("\"ok\""), "{well}");
    child.kill().unwrap();
    child.wait().unwrap();
}

/// The process that plans has bounds of memory and time, and a lower priority than the cell, before it reads its
/// request.
#[cfg(target_os = "linux")]
#[test]
fn the_process_that_plans_is_bounded() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .args(["answer-one-question", "--jobs"])
        .arg(folder.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let proc = std::path::PathBuf::from(format!("/proc/{}", child.id()));
    let limit = |name: &str| {
        let limits = std::fs::read_to_string(proc.join("limits")).unwrap();
        let line = limits.lines().find_map(|line| line.strip_prefix(name)).unwrap().to_owned();
        line.split_whitespace().next().unwrap().parse::<u64>().ok()
    };
    // It waits for its question, once it is bounded.
    let begin = std::time::Instant::now();
    let bounds = || (limit("Max address space"), limit("Max cpu time"));
    while bounds() != (Some(2 << 30), Some(600)) {
        assert!(begin.elapsed() < std::time::Duration::from_secs(60), "{:?}", bounds());
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    child.stdin.take().unwrap().write_all(br#"{"kind":"draft","text":"title = 5"}"#).unwrap();
    let answer = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&answer.stdout).into_owned();
    assert!(answer.status.success() && said.starts_with("{\"answer\":") && said.contains("\"wrong\""), "{said}");
}

#[test]
fn what_serve_takes_is_taken_without_a_verb() {
    // As with the verb: the folder is created, then the address refused.
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let told = bad(2, &["--data", &data, "--bind", "0.0.0.0:8080"]);
    assert!(told.contains("--tls") && told.contains("127.0.0.1"), "{told}");
    let told = bad(2, &["--data", &data, "--job", "unknown"]);
    assert!(told.contains("unknown") && told.contains("saddle"), "{told}");
    // Before a verb they would be of no use.
    assert!(bad(2, &["--data", &data, "check", "ellipse"]).contains("cannot be used with"));
}

/// Starts and ends the panel with these options and this environment; returns its log.
fn log_of(arguments: &[&str], environment: &[(&str, &str)]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let mut child = Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .args(["serve", "--bind", "127.0.0.1:0", "--job", "ellipse", "--data", &data])
        .args(arguments)
        .envs(environment.iter().copied())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    assert!(Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stderr).unwrap()
}

/// The last line is there too: nothing waits in the queue at the end.
#[test]
fn log_lines_have_codes_and_arguments() {
    let log = log_of(&["--log-format", "json"], &[("SEAMWRIGHT_LOG_LEVEL", "info")]);
    let lines: Vec<serde_json::Value> =
        log.lines().map(|line| serde_json::from_str(line).unwrap_or_else(|e| panic!("{e}: {line}"))).collect();
    let of = |code: &str| lines.iter().find(|line| line["code"] == code).unwrap_or_else(|| panic!("no {code}: {log}"));
    let starts = of("server-log-starts");
    assert_eq!(
        (&starts["level"], &starts["arguments"]["version"]),
        (&"info".into(), &env!("CARGO_PKG_VERSION").into())
    );
    assert!(starts["arguments"]["address"].as_str().unwrap().starts_with("http://127.0.0.1:"), "{starts}");
    let loaded = of("server-event-loaded");
    assert!(loaded["text"].as_str().unwrap().contains(loaded["arguments"]["job"].as_str().unwrap()), "{loaded}");
    assert_eq!(of("server-event-stopped-by")["level"], "warn");
    of("server-log-ends");
    let quiet = log_of(&["--log-level", "error"], &[("SEAMWRIGHT_LOG_LEVEL", "debug")]);
    assert!(!quiet.contains("server-log-starts"), "{quiet}");
    let text = log_of(&[], &[("SEAMWRIGHT_LOG_FORMAT", "text"), ("JOURNAL_STREAM", "1:1")]);
    assert!(text.contains(" INFO  Seamwright ") && text.contains(" code=server-log-starts "), "{text}");
}

#[test]
fn what_the_log_and_the_token_cannot_be_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("cell").display().to_string();
    let output = Command::new(env!("CARGO_BIN_EXE_seamwright"))
        .args(["serve", "--data", &data])
        .env("SEAMWRIGHT_LOG_LEVEL", "loud")
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert!(told.contains("SEAMWRIGHT_LOG_LEVEL") && told.contains("loud") && told.contains("warn"), "{told}");
    for token in ["", "short", "two words of many letters"] {
        let file = write(folder.path(), "token", token);
        let told = bad(2, &["serve", "--data", &data, "--monitor-token", &file]);
        assert!(told.contains("--monitor-token") && told.contains("16"), "{told}");
    }
}
