//! The panel as a program: it tells its address, answers, ends in order, and says what is wrong.

use crate::common::bad;
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

/// Whatever ends it does so in order: a closed terminal (SIGHUP) too.
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
    let broken = folder.path().join("broken.toml");
    std::fs::write(&broken, "schema = 1\ntitle = 5\n").unwrap();
    let told = bad(2, &["serve", "--data", &data, "--job", &broken.display().to_string()]);
    assert!(told.contains("title"), "{told}");
    let users = folder.path().join("cell/users.json");
    std::fs::write(users, "{").unwrap();
    let told = bad(2, &["serve", "--data", &data]);
    assert!(told.contains("users.json"), "{told}");
}
