//! Frames of the machine file, over HTTP.

use super::Bench;
use serde_json::{Value, json};

/// A weld of an arm at its home position.
const JOB: &str = r#"
schema = 1
title = "Arm"
machine = "ur10e"
[[passes]]
name = "short"
[passes.points]
columns = ["j1", "j2", "j3", "j4", "j5", "j6", "current_a", "speed_mm_s"]
start = [0, -90, -90, -90, 90, 0, 200, 0]
[[passes.points.spans]]
along = "line"
points = [[1, -90, -90, -90, 90, 0, 200, 6]]
"#;

fn entry<'a>(view: &'a Value, id: &str) -> &'a Value {
    view["frames"].as_array().unwrap().iter().find(|of| of["id"] == id).unwrap_or(&Value::Null)
}

#[tokio::test(flavor = "multi_thread")]
async fn frames_are_changed_with_what_they_were_before() {
    let (bench, owner) = Bench::with_owner().await;
    bench.did(&owner, "PUT", "/api/jobs/arm.toml", json!({ "text": JOB })).await;
    bench.did(&owner, "POST", "/api/load", json!({ "job": "arm.toml", "from": null, "part": null })).await;
    let view = bench.did(&owner, "GET", "/api/frames", Value::Null).await;
    let tool = entry(&view, "tool 7");
    assert_eq!((&tool["kind"], &tool["within"], &tool["before"]), (&json!("tool"), &json!("flange"), &Value::Null));
    // The torch 70 mm longer.
    let mut longer = tool["frame"].clone();
    longer[11] = json!(400.0);
    let change = json!({ "id": "tool 7", "frame": longer });
    let view = bench.did(&owner, "PUT", "/api/frames", change).await;
    assert_eq!(view["pending"], true, "the cell still has the old tool");
    assert_eq!(
        (&entry(&view, "tool 7")["frame"][11], &entry(&view, "tool 7")["before"][11]),
        (&json!(400.0), &json!(330.0))
    );
    let text = std::fs::read_to_string(bench.path().join("jobs/machines/ur10e.toml")).unwrap();
    assert!(
        text.contains("fixed = { move_mm = [90.0, 0.0, 400.0], turn = [0.0, 1.0, 0.0], angle_deg = 35.0 }"),
        "{text}"
    );
    // A user frame is in force at once, without loading anything.
    let frame = json!([0.0, -1.0, 0.0, 100.0, 1.0, 0.0, 0.0, 200.0, 0.0, 0.0, 1.0, 0.0]);
    let view = bench.did(&owner, "PUT", "/api/frames", json!({ "id": "user table 1", "frame": frame })).await;
    assert_eq!(entry(&view, "user table 1")["name"], "table 1");
    let machine = || bench.panel.cell.hub.machine().unwrap();
    assert_eq!(machine().user_frames[0].name, "table 1");
    assert!((machine().user_frames[0].in_base.translation - glam::DVec3::new(100.0, 200.0, 0.0)).length() < 1e-9);
    let view = bench.did(&owner, "PUT", "/api/frames", json!({ "id": "user table 1", "frame": null })).await;
    assert!(entry(&view, "user table 1").is_null() && machine().user_frames.is_empty());
    // Nonsense is refused, and nothing is written.
    let kept = std::fs::read_to_string(bench.path().join("jobs/machines/ur10e.toml")).unwrap();
    let skewed = json!([1.0, 0.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    for wrong in [
        json!({ "id": "tool 7", "frame": skewed }),
        json!({ "id": "tool 7", "frame": null }),
        json!({ "id": "tool 0", "frame": frame }),
        json!({ "id": "base", "frame": frame }),
        json!({ "id": "user tool", "frame": frame }),
    ] {
        bench.refused(&owner, "PUT", "/api/frames", wrong).await;
    }
    assert_eq!(std::fs::read_to_string(bench.path().join("jobs/machines/ur10e.toml")).unwrap(), kept);
    // The audit log has what it was.
    bench.panel.cell.archive.flush();
    let rows = bench.did(&owner, "GET", "/api/audit?most=20&text=set%20frame", Value::Null).await;
    let row = rows.as_array().unwrap().iter().find(|row| row["command"]["text"].as_str().unwrap().contains("tool 7"));
    let row = row.unwrap();
    assert!(
        row["old"].as_str().unwrap().contains("330.000") && row["new"].as_str().unwrap().contains("400.000"),
        "{row}"
    );
}
