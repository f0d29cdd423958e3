//! Tables of seams: imported, planned, read, exported, removed, within their limits.

use super::{Bench, Visitor};
use crate::limits::{MAX_FRAMES, MAX_SCHEDULE_PARTS, MAX_SCHEDULES};
use axum::http::StatusCode;
use serde_json::{Value, json};
use std::time::Duration;

const TABLE: &str = "name,template,count,setup_min\nA,ellipse,2,6\nB,ellipse,,\nC,ellipse,3000,1\n";

impl Bench {
    async fn put_table(&self, who: &Visitor, name: &str, text: &str, replace: bool) -> (StatusCode, Value) {
        let body = json!({ "text": text, "replace": replace });
        self.ask(who.request("PUT", &format!("/api/schedules/{name}"), Some(&body))).await
    }

    async fn table_of(&self, who: &Visitor, name: &str) -> Value {
        self.did(who, "GET", &format!("/api/schedules/{name}"), Value::Null).await
    }

    /// Waits until no table is being planned; returns the list.
    async fn planned(&self, who: &Visitor) -> Value {
        for _ in 0..2400 {
            let list = self.did(who, "GET", "/api/schedules", Value::Null).await;
            if list.as_array().unwrap().iter().all(|row| row["run"].is_null()) {
                return list;
            }
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
        panic!("it is planned without end");
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_table_is_imported_planned_exported_and_removed() {
    let (bench, owner) = Bench::with_owner().await;
    // Faults have line and column; files outside of the jobs are not read.
    for (name, text, said) in [
        ("t.csv", "name,template\nA,nothing\n", "t.csv:2"),
        ("t.csv", "name,template\nA,../users.json\n", "t.csv:2"),
        ("t.csv", "name,template\nA,/etc/passwd\n", "t.csv:2"),
        ("t.csv", "name,template,seam.radius_cm\nA,ellipse,3\n", "radius_cm"),
        ("t.txt", TABLE, "t.txt"),
        (".t.csv", TABLE, ".t.csv"),
    ] {
        let (status, answer) = bench.put_table(&owner, name, text, false).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{name}: {answer}");
        let text = answer["text"].as_str().unwrap();
        assert!(text.contains(said) && !text.contains("root:") && !text.contains("argon2"), "{text}");
    }
    assert_eq!(bench.put_table(&owner, "t.csv", TABLE, false).await.0, StatusCode::OK);
    let (status, answer) = bench.put_table(&owner, "t.csv", TABLE, false).await;
    assert_eq!((status, &answer["key"]), (StatusCode::CONFLICT, &json!("other")));
    assert_eq!(bench.put_table(&owner, "t.csv", TABLE, true).await.0, StatusCode::OK);
    let view = bench.table_of(&owner, "t.csv").await;
    let states = |view: &Value| -> Vec<String> {
        view["rows"].as_array().unwrap().iter().map(|row| row["status"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(states(&view), ["waiting"; 3]);
    assert_eq!((&view["files"], &view["machines"]), (&json!([]), &json!([])));
    // Planned, one at a time.
    let options = |limit: f64| json!({ "post": "linuxcnc", "limit_s": limit, "language": "en" });
    assert!(bench.refused(&owner, "POST", "/api/schedules/t.csv/run", options(0.0)).await.contains("3600"));
    let run = owner.request("POST", "/api/schedules/t.csv/run", Some(&options(60.0)));
    assert_eq!(bench.ask(run).await.0, StatusCode::ACCEPTED);
    let list = bench.planned(&owner).await;
    assert_eq!((&list[0]["has_results"], &list[0]["failed"]), (&json!(true), &Value::Null), "{list}");
    let view = bench.table_of(&owner, "t.csv").await;
    assert_eq!(states(&view), ["weldable"; 3], "{view}");
    assert_eq!(view["options"]["post"], "linuxcnc");
    // More parts than a page shows.
    let parts = view["machines"][0]["parts"].as_array().unwrap();
    assert_eq!((parts.len(), view["files"].as_array().unwrap().len()), (MAX_SCHEDULE_PARTS, 4));
    let csv = bench.raw(owner.request("GET", "/api/schedules/t.csv/files/schedule.csv", None)).await;
    assert_eq!(csv.headers()["content-disposition"], "attachment; filename=\"t.csv\"");
    for wrong in ["rows.jsonl", "options.json", "..%2ft.csv", "programs"] {
        let path = format!("/api/schedules/t.csv/files/{wrong}");
        assert_eq!(bench.ask(owner.request("GET", &path, None)).await.0, StatusCode::NOT_FOUND, "{wrong}");
    }
    let job = bench.did(&owner, "GET", "/api/schedules/t.csv/job?row=B", Value::Null).await;
    assert!(job["text"].as_str().unwrap().contains("ellipse"));
    let none = bench.ask(owner.request("GET", "/api/schedules/t.csv/job?row=Z", None)).await;
    assert_eq!(none.0, StatusCode::NOT_FOUND);
    let rest = bench.ask(owner.request("DELETE", "/api/schedules/t.csv/run", None)).await;
    assert_eq!(rest.0, StatusCode::NOT_FOUND, "nothing runs");
    // Operators look, and plan nothing.
    let everybody = bench.everybody().await;
    let of = |wanted: &str| &everybody.iter().find(|(role, _)| format!("{role:?}") == wanted).unwrap().1;
    let (operator, programmer) = (of("Operator"), of("Programmer"));
    assert_eq!(states(&bench.table_of(operator, "t.csv").await), ["weldable"; 3]);
    let run = operator.request("POST", "/api/schedules/t.csv/run", Some(&options(60.0)));
    assert_eq!(bench.ask(run).await.0, StatusCode::FORBIDDEN);
    let gone = bench.ask(programmer.request("DELETE", "/api/schedules/t.csv", None)).await;
    assert_eq!(gone.0, StatusCode::NO_CONTENT);
    assert!(!bench.path().join("schedules/t.csv").exists() && !bench.path().join("jobs/schedules/t.csv").exists());
}

#[tokio::test(flavor = "multi_thread")]
async fn tables_and_user_frames_are_bounded_in_number() {
    let (bench, owner) = Bench::with_owner().await;
    let folder = bench.path().join("jobs/schedules");
    std::fs::create_dir_all(&folder).unwrap();
    (0..MAX_SCHEDULES).for_each(|i| std::fs::write(folder.join(format!("{i}.csv")), TABLE).unwrap());
    let (status, answer) = bench.put_table(&owner, "more.csv", TABLE, false).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{answer}");
    assert!(answer["text"].as_str().unwrap().contains(&MAX_SCHEDULES.to_string()));
    assert_eq!(bench.put_table(&owner, "7.csv", TABLE, true).await.0, StatusCode::OK, "a known one is replaced");
    let mut machine = seamwright_machine::shipped("ellipse-xy").unwrap().text.to_owned();
    (0..MAX_FRAMES).for_each(|i| machine += &format!("\n[frames.f{i}]\nmove_mm = [{i}, 0, 0]\n"));
    std::fs::create_dir_all(bench.path().join("jobs/machines")).unwrap();
    std::fs::write(bench.path().join("jobs/machines/ellipse-xy.toml"), machine).unwrap();
    let frame = json!([1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let more = json!({ "id": "user more", "frame": frame });
    assert!(bench.refused(&owner, "PUT", "/api/frames", more).await.contains(&MAX_FRAMES.to_string()));
    bench.did(&owner, "PUT", "/api/frames", json!({ "id": "user f3", "frame": frame })).await;
}
