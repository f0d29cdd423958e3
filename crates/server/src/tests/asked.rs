//! Jobs, plans, part programs, edits.

use super::{Bench, HOST};
use crate::http::{begin_with, hears};
use crate::planner::{Planner, tests::program};
use crate::wire::Role;
use axum::http::StatusCode;
use http_body_util::BodyExt as _;
use seamwright_machine::shipped;
use serde_json::json;

#[tokio::test(flavor = "multi_thread")]
async fn jobs_are_kept_planned_posted_and_edited() {
    let (bench, owner) = Bench::with_owner().await;
    let (_, example) = bench.ask(owner.request("GET", "/api/jobs/ellipse.toml", None)).await;
    let text = example["text"].as_str().unwrap().to_owned();
    let put = owner.request("PUT", "/api/jobs/mine.toml", Some(&json!({ "text": text })));
    let (status, row) = bench.ask(put).await;
    assert_eq!((status, &row["example"]), (StatusCode::OK, &json!(false)));
    let (_, rows) = bench.ask(owner.request("GET", "/api/jobs", None)).await;
    assert_eq!(rows[0]["name"], "mine.toml");
    assert!(rows.as_array().unwrap().len() > 10);
    let (status, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": text })))).await;
    assert_eq!((status, &answer["kind"], &answer["work"]["good"]), (StatusCode::OK, &json!("planned"), &json!(true)));
    let path = answer["work"]["passes"][0]["path"].as_array().unwrap();
    assert!(path.len() > 100 && path[10]["torch"].as_array().unwrap().len() == 3);
    // Errors have a line and a key.
    let wrong = text.replace("title", "tilte");
    let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": wrong })))).await;
    assert_eq!(answer["kind"], "wrong", "{answer}");
    assert!(
        answer["at"]["line"].as_u64().is_some() && answer["message"]["text"].as_str().unwrap().contains("tilte"),
        "{answer}"
    );
    // A different text is not replaced silently: neither another job nor changes that others made to this one.
    let keep = async |over: serde_json::Value, text: &str| {
        let body = match over {
            serde_json::Value::Null => json!({ "text": text }),
            over => json!({ "text": text, "over": over }),
        };
        bench.ask(owner.request("PUT", "/api/jobs/mine.toml", Some(&body))).await
    };
    let other = format!("{text}# another\n");
    for over in [json!(""), json!(other)] {
        let (status, refused) = keep(over, &other).await;
        assert_eq!((status, &refused["key"]), (StatusCode::CONFLICT, &json!("other")), "{refused}");
    }
    for (over, to) in [(json!(text), &other), (json!(null), &text)] {
        assert_eq!(keep(over, to).await.0, StatusCode::OK);
    }
    let (_, kept) = bench.ask(owner.request("GET", "/api/jobs/mine.toml", None)).await;
    assert_eq!(kept["text"], text);
    // An invalid procedure is refused, so that jobs that name it stay valid.
    let good = seamwright_program::PROCEDURES[0].text;
    let kept = async |text: &str| {
        bench.ask(owner.request("PUT", "/api/jobs/wps.toml", Some(&json!({ "text": text, "over": "" })))).await
    };
    let line = good.lines().find(|line| line.starts_with("process = ")).unwrap();
    let (status, refused) = kept(&good.replacen(line, "process = -5", 1)).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{refused}");
    assert!(refused["text"].as_str().unwrap().contains("process"), "{refused}");
    assert_eq!(kept(good).await.0, StatusCode::OK);
    assert_eq!(bench.ask(owner.request("DELETE", "/api/jobs/wps.toml", None)).await.0, StatusCode::NO_CONTENT);
    // A job can be posted.
    let post = json!({ "text": text, "dialect": "linuxcnc" });
    let answer = bench.did(&owner, "POST", "/api/post", post).await;
    assert!(answer["text"].as_str().unwrap().contains("G93") && !answer["proof"].as_array().unwrap().is_empty());
    let post = json!({ "text": text, "dialect": "basic" });
    assert_eq!(bench.ask(owner.request("POST", "/api/post", Some(&post))).await.0, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(bench.ask(owner.request("DELETE", "/api/jobs/mine.toml", None)).await.0, StatusCode::NO_CONTENT);
    assert_eq!(bench.ask(owner.request("DELETE", "/api/jobs/mine.toml", None)).await.0, StatusCode::NOT_FOUND);
    for (query, language, verdict) in [("", "en", "In order"), ("&language=de", "de", "In Ordnung")] {
        let page = owner.request("GET", &format!("/api/report?job=ellipse.toml{query}"), None);
        let page = bench.raw(page).await.into_body().collect().await.unwrap().to_bytes();
        let page = String::from_utf8_lossy(&page);
        assert!(page.contains(&format!("<html lang=\"{language}\">")) && page.contains(verdict), "{page}");
    }
    let mut sizes = Vec::new();
    for appendix in [false, true] {
        let page = owner.request("GET", &format!("/api/report?job=ellipse.toml&appendix={appendix}"), None);
        sizes.push(bench.raw(page).await.into_body().collect().await.unwrap().to_bytes().len());
    }
    assert!(sizes[1] > sizes[0] + 50_000, "curves and the job's text: {sizes:?}");
    let wrong = owner.request("GET", "/api/report?job=ellipse.toml&language=fr", None);
    let (status, refused) = bench.ask(wrong).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(refused["text"], "there is no language `fr`; allowed: en, uk, zh, de, ru");
    let (_, audit) = bench.ask(owner.request("GET", "/api/audit", None)).await;
    let commands: Vec<&str> = audit.as_array().unwrap().iter().filter_map(|e| e["command"]["text"].as_str()).collect();
    assert!(commands.contains(&"delete job mine.toml") && commands.contains(&"log in"), "{commands:?}");
    let archive = bench.raw(owner.request("GET", "/api/backup", None)).await;
    assert_eq!(archive.headers()["content-type"], "application/x-tar");
    let bytes = archive.into_body().collect().await.unwrap().to_bytes();
    let file = bench.path().join("backup.tar");
    std::fs::write(&file, &bytes).unwrap();
    let scratch = tempfile::tempdir().unwrap();
    seamwright_record::restore(&file, &scratch.path().join("back")).unwrap();
    let (_, document) = bench.ask(owner.request("GET", "/api/openapi.json", None)).await;
    assert!(document["paths"]["/api/jobs/{name}"]["put"]["requestBody"].is_object());
    assert!(
        document["components"]["schemas"]["Status"].is_null()
            && document["components"]["schemas"]["WorkView"].is_object()
    );
}

/// A job that exceeds the memory limit of a plan is never planned in the cell's process.
#[tokio::test(flavor = "multi_thread")]
async fn a_job_is_planned_beside_the_cell_before_it_is_loaded() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir_all(folder.path().join("jobs")).unwrap();
    std::fs::write(folder.path().join("jobs/memory.toml"), "title = \"memory\"\n").unwrap();
    let planner = Planner::new(Some(program()));
    let bench = Bench::planned_by(folder, &[HOST], shipped("ellipse-xy").unwrap().text, planner);
    let refused = begin_with(&bench.panel, "memory.toml").await.unwrap_err();
    assert!(refused.to_string().contains("GiB of memory"), "{refused}");
    assert!(bench.panel.cell.hub.work().is_none() && !bench.panel.loads.any());
}

#[tokio::test(flavor = "multi_thread")]
async fn nothing_starts_while_a_job_is_planned_to_be_loaded() {
    let bench = Bench::new().await;
    bench.everybody().await;
    let (_, session) = bench.panel.sessions.begin("Operator", Role::Operator).unwrap();
    let says = |seq: u32| {
        let ask = format!("{{\"kind\":\"command\",\"seq\":{seq},\"ask\":{{\"do\":\"start_weld\",\"reweld\":false}}}}");
        hears(&bench.panel, &session, &["{\"kind\":\"take_control\",\"over\":true}".to_owned(), ask])
    };
    let announced = bench.panel.loads.announce();
    let told = says(1);
    assert!(told.iter().any(|t| t.contains("\"busy\"") && t.contains("server-load-announced")), "{told:?}");
    drop(announced);
    let told = says(2);
    assert!(!told.iter().any(|t| t.contains("server-load-announced")), "{told:?}");
}
