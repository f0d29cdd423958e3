//! A weld from power-on to its record; a stop and a continuation.

use super::lived::{Page, Served};
use super::{Bench, Visitor, beside_home};
use http_body_util::BodyExt as _;
use serde_json::{Value, json};
use std::time::Duration;

async fn short_job(bench: &Bench, owner: &Visitor) {
    let example = bench.did(owner, "GET", "/api/jobs/ellipse.toml", Value::Null).await;
    let text = example["text"].as_str().unwrap();
    let line = text.lines().find(|l| l.starts_with("overlap_mm")).unwrap();
    let text = beside_home(&text.replace(line, "end_phi_deg = 60"));
    bench.did(owner, "PUT", "/api/jobs/short.toml", json!({ "text": text })).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_weld_is_recorded_held_stopped_and_gone_on_with() {
    let (served, owner) = Served::with_owner().await;
    let bench = &served.bench;
    short_job(bench, &owner).await;
    assert!(bench.load(&owner, "short.toml", Some("N-17")).await.0.is_success());
    let mut page = served.page_up(&owner).await;
    // Not armed: refused with the reason.
    assert_eq!(page.ask(json!({ "do": "start_weld" })).await["why"]["key"], "arming");
    page.weld().await;
    page.until_status("the arc", |v| v["process"]["burning"] == true).await;
    // Loading is refused during a weld.
    let (status, refused) = bench.load(&owner, "short.toml", Some("N-17")).await;
    assert_eq!((status.as_u16(), &refused["key"]), (409, &json!("busy")));
    page.until_status("travel", |v| v["s_mm"].as_f64().unwrap() > 3.0).await;
    page.order("hold").await;
    page.until_status("rest", |v| v["process"]["phase"] == "held").await;
    page.order("arm").await;
    page.order("resume").await;
    page.until_status("travel", |v| v["s_mm"].as_f64().unwrap() > 6.0 && v["process"]["on"] == true).await;
    page.order("stop").await;
    let left = page.until_status("where it was left", |v| v["left"].is_object()).await;
    let (pass, mm) = (left["left"]["pass"].as_u64().unwrap(), left["left"]["s_mm"].as_f64().unwrap());
    assert!(pass == 1 && mm > 6.0, "{left}");
    assert_eq!(
        (&left["left"]["part"], &left["part"], &left["left"]["here"]),
        (&json!("N-17"), &json!("N-17"), &json!(true))
    );
    assert!(left["left"]["record"].as_i64().is_some() && left["left"]["title"].as_str().is_some(), "{left}");
    page.until("the record", |v| v["kind"] == "event" && v["what"] == "record").await;
    // Another part of the same program, and another program, do not continue there. The same program does, with or
    // without the part number.
    for (job, part, here) in [
        ("short.toml", Some("N-18"), false),
        ("ellipse.toml", Some("N-17"), false),
        ("short.toml", None, true),
        ("short.toml", Some("N-17"), true),
    ] {
        assert!(bench.load(&owner, job, part).await.0.is_success());
        let of = part.unwrap_or_default();
        let now = page.until_status("the part", |v| v["part"] == of && v["left"]["here"] == here).await;
        assert_eq!(now["left"]["s_mm"].as_f64().unwrap().to_bits(), mm.to_bits(), "{now}");
    }
    // Continues from there to the end.
    let load = json!({ "job": "short.toml", "from": [pass, mm], "part": "N-17" });
    bench.did(&owner, "POST", "/api/load", load).await;
    page.weld().await;
    page.until("the record", |v| v["kind"] == "event" && v["what"] == "record").await;
    // The part is complete: the next weld is another part.
    page.until_status("no part", |v| v["part"] == "" && v["left"].is_null()).await;
    let (_, records) = bench.ask(owner.request("GET", "/api/records?part=N-17", None)).await;
    let results: Vec<&str> = records.as_array().unwrap().iter().map(|r| r["result"].as_str().unwrap()).collect();
    assert_eq!(results, ["good", "stopped"], "{records}");
    assert_eq!(records[0]["welder"], "owner");
    let id = records[0]["id"].as_i64().unwrap();
    let (_, record) = bench.ask(owner.request("GET", &format!("/api/records/{id}"), None)).await;
    assert!(record["rows"].as_u64().unwrap() > 1000 && record["columns"].as_array().unwrap().len() > 15);
    // Measured values: the speed of 5 mm/s, process values, the deviation of a simulated machine.
    let value = |name: &str| {
        let of = |v: &&serde_json::Value| v["name"] == name;
        record["values"].as_array().unwrap().iter().find(of).unwrap_or_else(|| panic!("{name}: {}", record["values"]))
    };
    let speed = value("tip_speed_mm_s")["greatest"].as_f64().unwrap();
    assert!((4.9..5.3).contains(&speed), "{speed}");
    assert!(value("current_a")["greatest"].as_f64().unwrap() > 80.0);
    let deviation = record["weld"]["worst_deviation_mm"][0].as_f64().unwrap();
    assert!(deviation < 0.2, "{deviation}");
    let trace = format!("/api/records/{id}/trace?columns=t_s,s_mm,arc&most=500");
    let (_, trace) = bench.ask(owner.request("GET", &trace, None)).await;
    let rows = trace["values"][0].as_array().unwrap().len();
    // Half of the rows are spaced evenly, the others are peaks.
    assert!((250..=500).contains(&rows), "{rows}");
    let (status, work) = bench.ask(owner.request("GET", &format!("/api/records/{id}/work"), None)).await;
    assert!(status.is_success() && !work["passes"].as_array().unwrap().is_empty());
    let page = bench.raw(owner.request("GET", &format!("/api/records/{id}/report"), None)).await;
    assert!(page.status().is_success());
    // The report contains the events of the weld that was held and stopped.
    let stopped = records[1]["id"].as_i64().unwrap();
    let page = bench.raw(owner.request("GET", &format!("/api/records/{stopped}/report"), None)).await;
    let report = page.into_body().collect().await.unwrap().to_bytes();
    let report = String::from_utf8_lossy(&report);
    for event in ["hold", "resume", "stop", "pass 1 was left"] {
        assert!(report.contains(event), "{event}");
    }
    // Reports in other languages translate the events; an unknown language is refused with a list of the known ones.
    let in_language =
        |code: &str| owner.request("GET", &format!("/api/records/{stopped}/report?language={code}"), None);
    let german = bench.raw(in_language("de")).await.into_body().collect().await.unwrap().to_bytes();
    let german = String::from_utf8_lossy(&german);
    assert!(german.contains("<html lang=\"de\">") && german.contains("Lage 1 wurde verlassen"), "{german}");
    for wrong in ["fr", "", "de-AT", "EN"] {
        let (status, refused) = bench.ask(in_language(wrong)).await;
        assert_eq!((status.as_u16(), &refused["key"]), (422, &json!("input")), "{wrong}");
        let said = format!("there is no language `{wrong}`; allowed: en, uk, zh, de, ru");
        assert_eq!(refused["text"], said);
    }
    // The audit log contains user and command.
    let (_, audit) = bench.ask(owner.request("GET", "/api/audit?most=100", None)).await;
    let has =
        |what: &str| audit.as_array().unwrap().iter().any(|e| e["command"]["text"] == what && e["user"] == "owner");
    let stopped = has("stop") || has("Stop");
    assert!(has("start weld") && has("arm") && stopped && has("load short.toml"), "{audit}");
    tokio::time::sleep(Duration::from_millis(10)).await;
}

/// Welds the part beyond `mm` and stops; returns the position where it was left.
async fn weld_to(page: &mut Page, part: &str, mm: f64) -> f64 {
    // It may be lost while a job was loaded.
    page.control().await;
    page.weld().await;
    page.until_status("travel", |v| v["mode"] == "weld" && v["welded_mm"].as_f64().unwrap() > mm).await;
    page.order("stop").await;
    let farther = |v: &Value| v["left"]["part"] == part && v["left"]["s_mm"].as_f64().unwrap() > mm;
    let left = page.until_status("where it was left", |v| v["left"].is_object() && farther(v)).await;
    page.until("the record", |v| v["kind"] == "event" && v["what"] == "record").await;
    left["left"]["s_mm"].as_f64().unwrap()
}

/// Loads the short job for a part and waits until the cell has it; returns the view of the weld that was left.
async fn load_part(bench: &Bench, owner: &Visitor, page: &mut Page, part: &str, from: &Value) -> Value {
    bench.did(owner, "POST", "/api/load", json!({ "job": "short.toml", "from": from, "part": part })).await;
    let there = |v: &Value| {
        v["kind"] == "status"
            && v["part"] == part
            && v["start"] == if from.is_null() { json!([1, 0.0]) } else { from.clone() }
    };
    page.until("the part", there).await["left"].clone()
}

/// Each part continues where it was left last, despite other welds and restarts. A finished weld is welded again only
/// after confirmation.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn parts_go_on_where_each_was_left_and_nothing_is_welded_twice_unasked() {
    let (served, owner) = Served::with_owner().await;
    short_job(&served.bench, &owner).await;
    let mut page = served.page_up(&owner).await;
    let none = Value::Null;
    load_part(&served.bench, &owner, &mut page, "A", &none).await;
    let at_a = weld_to(&mut page, "A", 6.0).await;
    let other = load_part(&served.bench, &owner, &mut page, "B", &none).await;
    assert!(other["here"] == false && other["part"] == "A", "{other}");
    let at_b = weld_to(&mut page, "B", 3.0).await;
    // The first part continues at its own position, not at that of the second.
    let left = load_part(&served.bench, &owner, &mut page, "A", &none).await;
    assert_eq!((&left["here"], left["s_mm"].as_f64()), (&json!(true), Some(at_a)), "{left}");
    assert_eq!((&left["finished"], &left["pass"]), (&json!(0), &json!(1)), "{left}");
    page.control().await;
    page.order("arm").await;
    let refused = page.ask(json!({ "do": "start_weld" })).await;
    assert_eq!(refused["why"]["key"], "finished_pass", "{refused}");
    let text = refused["why"]["text"].as_str().unwrap();
    assert!(text.contains("part “A”") && text.contains(&format!("pass 1, {at_a:.2} mm")), "{text}");
    // The same after a restart.
    page.down().await;
    let served = Served::on(served.bench.end()).await;
    let owner = served.bench.owner().await;
    let mut page = served.page_up(&owner).await;
    let left = load_part(&served.bench, &owner, &mut page, "B", &none).await;
    assert!((left["s_mm"].as_f64().unwrap() - at_b).abs() < 0.01 && left["here"] == true, "{left}");
    let left = load_part(&served.bench, &owner, &mut page, "A", &none).await;
    assert!((left["s_mm"].as_f64().unwrap() - at_a).abs() < 0.01 && left["here"] == true, "{left}");
    // Continued from there it is left further on: only the new position is offered.
    load_part(&served.bench, &owner, &mut page, "A", &json!([1, left["s_mm"]])).await;
    let farther = weld_to(&mut page, "A", at_a + 3.0).await;
    assert!(farther > at_a + 2.0, "{farther} {at_a}");
    let left = load_part(&served.bench, &owner, &mut page, "A", &json!([1, at_a])).await;
    assert_eq!(left["s_mm"].as_f64(), Some(farther), "{left}");
    page.control().await;
    page.order("arm").await;
    assert_eq!(page.ask(json!({ "do": "start_weld" })).await["why"]["key"], "finished_pass");
    // A requested overlap needs no confirmation.
    let overlapping =
        |mm: f64| json!({ "job": "short.toml", "from": [1, farther - 5.0], "overlap_mm": mm, "part": "A" });
    for (mm, status) in [(-1.0, 422), (101.0, 422), (5.0, 200)] {
        let load = owner.request("POST", "/api/load", Some(&overlapping(mm)));
        assert_eq!(served.bench.ask(load).await.0.as_u16(), status, "{mm}");
    }
    page.control().await;
    weld_to(&mut page, "A", farther).await;
    load_part(&served.bench, &owner, &mut page, "A", &json!([1, at_a])).await;
    page.control().await;
    page.order("arm").await;
    assert_eq!(page.ask(json!({ "do": "start_weld" })).await["why"]["key"], "finished_pass");
    // Confirmed.
    let again = page.ask(json!({ "do": "start_weld", "reweld": true })).await;
    assert_eq!(again["ok"], true, "{again}");
    page.order("stop").await;
    page.mode("ready").await;
}

/// A weld without a record still runs to its end: its part is finished. A start at the old position needs confirmation.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_part_that_was_welded_without_a_record_is_finished() {
    let (served, owner) = Served::with_owner().await;
    let bench = &served.bench;
    short_job(bench, &owner).await;
    let mut page = served.page_up(&owner).await;
    load_part(bench, &owner, &mut page, "A", &Value::Null).await;
    let at = weld_to(&mut page, "A", 3.0).await;
    load_part(bench, &owner, &mut page, "A", &json!([1, at])).await;
    page.control().await;
    let (welds, away) = (bench.path().join("welds"), bench.path().join("away"));
    std::fs::rename(&welds, &away).unwrap();
    std::fs::write(&welds, "no folder").unwrap();
    page.weld().await;
    page.until_status("the end", |v| v["mode"] == "ready" && v["part"] == "" && v["left"].is_null()).await;
    assert!(page.events.iter().any(|event| event.contains("not recorded")), "{:#?}", page.events);
    std::fs::remove_file(&welds).unwrap();
    std::fs::rename(&away, &welds).unwrap();
    page.control().await;
    page.order("acknowledge").await;
    page.until_status("rest", |v| v["process"]["phase"].is_null() && v["stands"] == true).await;
    load_part(bench, &owner, &mut page, "A", &json!([1, at])).await;
    page.control().await;
    page.order("arm").await;
    let refused = page.ask(json!({ "do": "start_weld" })).await;
    assert_eq!(refused["why"]["key"], "finished_part", "{refused}");
}

/// A stopped weld continues after a restart, with the same program and the recorded part number.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn what_was_stopped_is_known_after_a_restart() {
    let (served, owner) = Served::with_owner().await;
    short_job(&served.bench, &owner).await;
    served.bench.load(&owner, "short.toml", Some("N-3")).await;
    let mut page = served.page_up(&owner).await;
    // It may be lost while a job was loaded.
    page.control().await;
    page.weld().await;
    page.until_status("travel", |v| v["s_mm"].as_f64().unwrap() > 3.0).await;
    page.order("stop").await;
    let before = page.until_status("where it was left", |v| v["left"].is_object()).await;
    page.until("the record", |v| v["kind"] == "event" && v["what"] == "record").await;
    let served = Served::on(served.bench.end()).await;
    let owner = served.bench.owner().await;
    assert!(served.bench.load(&owner, "short.toml", None).await.0.is_success());
    let mut page = served.page(&owner).await;
    let after = page.until_status("where it was left", |v| v["left"]["here"] == true).await;
    assert_eq!(after["left"], before["left"]);
    assert_eq!((&after["left"]["part"], &after["part"]), (&json!("N-3"), &json!("")));
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn whoever_is_not_logged_in_stops() {
    let (served, owner) = Served::with_owner().await;
    let bench = &served.bench;
    let mut page = served.page_up(&owner).await;
    page.order("start_dry_run").await;
    page.until_status("travel", |v| v["mode"] == "dry_run").await;
    let stranger = super::Visitor { cookie: String::new(), token: String::new() };
    let foreign = stranger.request("POST", "/api/stop", Some(&json!({})));
    let (mut parts, body) = foreign.into_parts();
    parts.headers.insert("origin", "http://elsewhere".parse().unwrap());
    let refused = bench.ask(axum::http::Request::from_parts(parts, body)).await;
    assert_eq!(refused.0.as_u16(), 403);
    let (status, stopped) = bench.ask(stranger.request("POST", "/api/stop", Some(&json!({})))).await;
    assert_eq!((status.as_u16(), &stopped["mode"]), (200, &json!("dry_run")));
    assert!(stopped["cycle_age_s"].as_f64().unwrap() < 2.0, "{stopped}");
    page.mode("ready").await;
    let (_, audit) = bench.ask(owner.request("GET", "/api/audit", None)).await;
    assert!(
        audit.as_array().unwrap().iter().any(|e| e["command"]["code"] == "panel-do-stop" && e["user"] == ""),
        "{audit}"
    );
}

/// The server answers a STOP for a cycle that has ended, and does not report it as taken.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_stop_that_no_cycle_takes_is_not_answered_as_taken() {
    let (served, owner) = Served::with_owner().await;
    let bench = &served.bench;
    let mut page = served.page(&owner).await;
    page.until_status("a status", |_| true).await;
    page.order("stop").await;
    let panel = std::sync::Arc::clone(&bench.panel);
    tokio::task::spawn_blocking(move || panel.cell.end()).await.unwrap();
    tokio::time::sleep(Duration::from_millis(600)).await;
    let answer = page.ask(json!({ "do": "stop" })).await;
    assert_eq!((&answer["ok"], &answer["why"]["key"]), (&json!(false), &json!("silent_cycle")), "{answer}");
    let (_, stopped) = bench.ask(owner.request("POST", "/api/stop", Some(&json!({})))).await;
    assert!(stopped["cycle_age_s"].as_f64().unwrap() > 0.5, "{stopped}");
}
