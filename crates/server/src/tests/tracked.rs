//! Weld of a displaced simulated part.

use super::lived::Served;
use serde_json::{Value, json};

/// Lateral displacement of 0.6 mm.
const SHIFT: &str = "schema = 1\n[[displacement]]\nshift = { lateral_mm = 0.6 }\n";
const SHORT: &str = "end_phi_deg = 32";

async fn trace(served: &Served, owner: &super::Visitor, id: i64, columns: &str) -> Vec<Vec<f64>> {
    let path = format!("/api/records/{id}/trace?columns={columns}&most=4000");
    let (_, trace) = served.bench.ask(owner.request("GET", &path, None)).await;
    let numbers = |column: &Value| column.as_array().unwrap().iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect();
    trace["values"].as_array().unwrap_or_else(|| panic!("{trace}")).iter().map(numbers).collect()
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_part_that_lies_elsewhere_is_tracked_and_its_corrections_recorded() {
    let (served, owner) = Served::with_owner().await;
    let bench = &served.bench;
    let (_, example) = bench.ask(owner.request("GET", "/api/jobs/saddle.toml", None)).await;
    let text = example["text"].as_str().unwrap().replace("overlap_mm = 20", SHORT);
    assert!(text.contains(SHORT));
    bench.ask(owner.request("PUT", "/api/jobs/short.toml", Some(&json!({ "text": text })))).await;
    // A distortion that is invalid or unsuitable for tracking on this machine is refused before anything changes.
    let load = |job: &str, text: &str| json!({ "job": job, "from": null, "part": "T-1", "distortion": text });
    let (status, refused) =
        bench.ask(owner.request("POST", "/api/load", Some(&load("short.toml", "schema = 2")))).await;
    assert_eq!((status.as_u16(), refused["text"].as_str().unwrap().contains("schema")), (422, true), "{refused}");
    let (status, refused) = bench.ask(owner.request("POST", "/api/load", Some(&load("ellipse.toml", SHIFT)))).await;
    assert!(status.is_client_error(), "{refused}");
    let (status, work) = bench.ask(owner.request("POST", "/api/load", Some(&load("short.toml", SHIFT)))).await;
    assert!(status.is_success(), "{work}");
    assert_eq!((&work["tracked"], &work["distortion"]), (&json!(1), &json!(SHIFT)));
    let mut page = served.page_up(&owner).await;
    page.weld().await;
    page.until("the record", |v| v["kind"] == "event" && v["what"] == "record").await;
    let (_, records) = bench.ask(owner.request("GET", "/api/records?part=T-1", None)).await;
    assert_eq!(records[0]["result"], "good", "{records}");
    let id = records[0]["id"].as_i64().unwrap();
    let columns = trace(&served, &owner, id, "arc,correction_lateral_mm,confidence").await;
    let welded = |column: &[f64]| -> Vec<f64> {
        columns[0].iter().zip(column).filter(|(arc, v)| **arc > 0.5 && v.is_finite()).map(|(_, v)| *v).collect()
    };
    let mut corrections = welded(&columns[1]);
    assert!(corrections.len() > 100, "{}", corrections.len());
    // Encoders and sensor agree on the position of the joint.
    corrections.sort_by(f64::total_cmp);
    let (least, most) = (corrections[0], corrections[corrections.len() - 1]);
    assert!((0.5..=0.7).contains(&least) && (0.5..=0.7).contains(&most), "{least} .. {most}");
    // The next program is welded as planned, without the guide.
    let (status, work) = bench.load(&owner, "short.toml", Some("T-2")).await;
    assert!(status.is_success() && work["tracked"] == 0, "{work}");
    page.order("start_dry_run").await;
    let seen = page.until_status("travel", |v| v["s_mm"].as_f64().unwrap_or(0.0) > 1.0).await;
    assert_eq!(seen["mode"], "dry_run", "{seen}");
    page.order("stop").await;
}
