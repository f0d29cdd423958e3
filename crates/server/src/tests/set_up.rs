//! Setup of tools, axes and drives in the machine file; alarms acknowledged individually, and shelved.

use super::lived::Served;
use super::{Bench, Visitor};
use axum::http::StatusCode;
use glam::DVec3;
use serde_json::{Value, json};

/// A job on the saddle machine that is planned quickly.
const JOB: &str = r#"
schema = 1
title = "Short"
machine = "saddle-4axis"

[[passes]]
name = "short"

[passes.points]
columns = ["theta", "s", "h", "beta", "current_a", "speed_mm_s"]
start = [0, 0, 60, -20, 200, 0]

[[passes.points.spans]]
along = "line"
points = [[4, 0, 60, -20, 200, 6], [12, 0, 60, -20, 200, 6]]
"#;

impl Bench {
    pub(super) async fn did(&self, who: &Visitor, method: &str, path: &str, body: Value) -> Value {
        let (status, answer) = self.ask(who.request(method, path, Some(&body))).await;
        assert!(status.is_success(), "{method} {path}: {status} {answer}");
        answer
    }

    pub(super) async fn refused(&self, who: &Visitor, method: &str, path: &str, body: Value) -> String {
        let (status, answer) = self.ask(who.request(method, path, Some(&body))).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{method} {path}: {answer}");
        answer["text"].as_str().unwrap().to_owned()
    }

    pub(super) async fn short(&self, who: &Visitor) {
        self.did(who, "PUT", "/api/jobs/short.toml", json!({ "text": JOB })).await;
        self.did(who, "POST", "/api/load", json!({ "job": "short.toml", "from": null, "part": null })).await;
    }
}

fn value(view: &Value, axis: usize, key: &str) -> Value {
    let list = view["axes"][axis]["values"].as_array().unwrap();
    list.iter().find(|v| v["key"] == key).unwrap()["value"].clone()
}

/// The torch only swings about one axis, 100 mm above the tip: the found point is on this axis, undetermined along it.
#[tokio::test(flavor = "multi_thread")]
async fn a_tool_is_found_reviewed_and_kept() {
    let (bench, owner) = Bench::with_owner().await;
    bench.short(&owner).await;
    let touches: Vec<[f64; 4]> = [-40.0, -20.0, 0.0, 20.0, 40.0].map(|beta| [0.0, 0.0, 120.0, beta]).to_vec();
    let asked = json!({ "head": 0, "touches": touches });
    let found = bench.did(&owner, "POST", "/api/tool", asked).await;
    let tip: Vec<f64> = serde_json::from_value(found["tip_mm"].clone()).unwrap();
    assert!(tip[0].abs() < 1e-3 && tip[1].abs() < 1e-3 && (tip[2] - 100.0).abs() < 1e-3, "{found}");
    assert_eq!((&found["verdict"], found["unseen"].as_array().unwrap().len()), (&json!("far"), 1), "{found}");
    assert!(found["unseen"][0][1].as_f64().unwrap().abs() > 0.999 && found["rms_mm"].as_f64().unwrap() < 1e-6);
    // Identical touches, too few, of another machine, of another head.
    let alike = json!({ "head": 0, "touches": vec![[0.0, 0.0, 120.0, 1.0]; 5] });
    assert!(bench.refused(&owner, "POST", "/api/tool", alike).await.contains("20 degrees"));
    let few = json!({ "head": 0, "touches": vec![[0.0, 0.0, 120.0, 1.0]; 2] });
    assert!(bench.refused(&owner, "POST", "/api/tool", few).await.contains("three times or more"));
    let foreign = json!({ "head": 0, "touches": vec![[0.0, 0.0]; 5] });
    assert!(bench.refused(&owner, "POST", "/api/tool", foreign).await.contains("4 positions"));
    let other = json!({ "head": 1, "touches": touches });
    assert!(bench.refused(&owner, "POST", "/api/tool", other).await.contains("no head 1"));
    // Kept in the file, but effective only with the next load.
    let path = bench.path().join("jobs/machines/saddle-4axis.toml");
    assert!(!path.exists());
    let bent = json!({ "head": 0, "tip_mm": [0.5, 0.0, -1.0] });
    let view = bench.did(&owner, "PUT", "/api/tool", bent).await;
    assert_eq!((&view["pending"], &view["file"]), (&json!(true), &json!("machines/saddle-4axis.toml")));
    assert!(std::fs::read_to_string(&path).unwrap().contains("tip_mm = [0.5, 0.0, -1.0]"));
    let tip = |bench: &Bench| bench.panel.cell.hub.machine().unwrap().heads[0].tip;
    assert_eq!(tip(&bench), DVec3::ZERO);
    bench.short(&owner).await;
    assert_eq!(tip(&bench), DVec3::new(0.5, 0.0, -1.0));
    let view = bench.did(&owner, "GET", "/api/parameters", Value::Null).await;
    assert_eq!((&view["pending"], &view["heads"][0]["tip_mm"]), (&json!(false), &json!([0.5, 0.0, -1.0])));
    // The audit log contains the user and the old value.
    bench.panel.cell.archive.flush();
    let rows = bench.did(&owner, "GET", "/api/audit?most=20", Value::Null).await;
    let row =
        rows.as_array().unwrap().iter().find(|row| row["command"]["text"].as_str().unwrap().starts_with("set tool"));
    let row = row.unwrap();
    assert_eq!((&row["old"], &row["new"]), (&json!("tip_mm [0.0, 0.0, 0.0]"), &json!("tip_mm [0.5, 0.0, -1.0]")));
}

#[tokio::test(flavor = "multi_thread")]
async fn drives_are_set_as_the_loader_allows() {
    let (bench, owner) = Bench::with_owner().await;
    bench.short(&owner).await;
    let change = |values: Value, notches: Value| json!({ "axis": "s", "values": values, "notches": notches });
    let asked =
        change(json!([["kp_per_s", 25.0], ["kvff", 1.0], ["max_speed_mm_s", 40.0]]), json!([[80.0, 0.1, 30.0]]));
    let view = bench.did(&owner, "PUT", "/api/parameters", asked).await;
    assert_eq!((value(&view, 1, "kp_per_s"), value(&view, 1, "max_speed_mm_s")), (json!(25.0), json!(40.0)));
    assert_eq!((&view["axes"][1]["notches"], &view["pending"]), (&json!([[80.0, 0.1, 30.0]]), &json!(true)));
    // One value removed; the others stay.
    let view = bench.did(&owner, "PUT", "/api/parameters", change(json!([["kvff", null]]), Value::Null)).await;
    assert_eq!((value(&view, 1, "kvff"), value(&view, 1, "kp_per_s")), (Value::Null, json!(25.0)));
    let kept = std::fs::read_to_string(bench.path().join("jobs/machines/saddle-4axis.toml")).unwrap();
    for (values, said) in [
        (json!([["kp_per_s", -1.0]]), "kp_per_s"),
        (json!([["force_limit_n", 1.0]]), "force_limit_n"),
        (json!([["max_speed_mm_s", 0.0]]), "max_speed_mm_s"),
        (json!([["inertia_kg_m2", 1.0]]), "another kind"),
        (json!([["name", 1.0]]), "no parameter"),
        (json!([["velocity_bandwidth_hz", null]]), "velocity_bandwidth_hz"),
    ] {
        let text = bench.refused(&owner, "PUT", "/api/parameters", change(values, Value::Null)).await;
        assert!(text.contains(said), "{said}: {text}");
    }
    let nobody = json!({ "axis": "x", "values": [], "notches": null });
    assert!(bench.refused(&owner, "PUT", "/api/parameters", nobody).await.contains("theta, s, h, beta"));
    assert_eq!(std::fs::read_to_string(bench.path().join("jobs/machines/saddle-4axis.toml")).unwrap(), kept);
    bench.short(&owner).await;
    let machine = bench.panel.cell.hub.machine().unwrap();
    assert_eq!(machine.axes[1].drive.as_ref().unwrap().notches.len(), 1);
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn alarms_are_acknowledged_one_by_one_and_put_aside() {
    let (served, owner) = Served::with_owner().await;
    let mut page = served.page_up(&owner).await;
    page.order("start_jog").await;
    page.mode("jog").await;
    page.jog([0.1, 0.0]).await;
    let there = |v: &Value| v["kind"] == "alarms" && v["list"][0]["name"] == "panel silent";
    let list = page.until("the alarm", there).await;
    let alarm = list["list"][0].clone();
    assert!(alarm["at"].as_str().unwrap().ends_with('Z') && alarm["tells"] == json!(true), "{alarm}");
    let put = |minutes: u32| json!({ "number": alarm["number"], "detail": alarm["detail"], "minutes": minutes });
    served.bench.did(&owner, "POST", "/api/alarms/shelve", put(30)).await;
    page.until("the shelf", |v| there(v) && v["list"][0]["shelved"]["by"].is_string()).await;
    served.bench.did(&owner, "POST", "/api/alarms/shelve", put(0)).await;
    page.until("no shelf", |v| there(v) && v["list"][0]["shelved"].is_null()).await;
    assert!(served.bench.refused(&owner, "POST", "/api/alarms/shelve", put(481)).await.contains("480"));
    let one = json!([alarm["number"], alarm["detail"]]);
    page.say(&json!({ "kind": "command", "seq": 1000, "ask": { "do": "acknowledge", "one": [99, 0] } })).await;
    page.until("no such alarm", |v| v["kind"] == "answer" && v["seq"] == 1000 && v["ok"] == json!(false)).await;
    page.say(&json!({ "kind": "command", "seq": 1001, "ask": { "do": "acknowledge", "one": one } })).await;
    page.until("its end", |v| {
        let known = |alarm: &Value| alarm["name"] != "panel silent" || alarm["state"] == "acknowledged";
        v["kind"] == "alarms" && v["list"].as_array().unwrap().iter().all(known)
    })
    .await;
}
