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

/// The tip of an arm's torch, from touches of one point in four attitudes: as far from the assumed one as it was bent.
#[tokio::test(flavor = "multi_thread")]
async fn the_tool_centre_point_of_an_arm_is_found_by_touches() {
    let (bench, owner) = Bench::with_owner().await;
    bench.did(&owner, "PUT", "/api/jobs/arm.toml", json!({ "text": JOB })).await;
    bench.did(&owner, "POST", "/api/load", json!({ "job": "arm.toml", "from": null, "part": null })).await;
    let text = seamwright_machine::shipped("ur10e").unwrap().text;
    let bent = text.replace("stick_out_mm = 15", "stick_out_mm = 15\ntip_mm = [1.5, -2.0, 3.25]");
    let bent = seamwright_machine::Machine::read("m", &bent).unwrap();
    let home = bent.home();
    let start = bent.forward(&home);
    let tilts = [[0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [-0.3, -0.3, 0.6]];
    let touches: Vec<Vec<f64>> = tilts
        .map(|[x, y, z]| {
            let turn = glam::DQuat::from_euler(glam::EulerRot::XYZ, x, y, z);
            let pose = seamwright_geometry::Pose { direction: turn * start.direction, ..start };
            let target = seamwright_machine::Target { across: Some(turn * bent.across(&home)), ..pose.into() };
            let found = bent.reach(target, &home).unwrap()[0].joints;
            bent.axes.iter().zip(found).map(|(axis, q)| axis.to_file(q)).collect()
        })
        .to_vec();
    let found = bench.did(&owner, "POST", "/api/tool", json!({ "head": 0, "touches": touches })).await;
    assert_eq!((&found["verdict"], found["unseen"].as_array().unwrap().len()), (&json!("good"), 0), "{found}");
    for (found, wanted) in found["tip_mm"].as_array().unwrap().iter().zip([1.5, -2.0, 3.25]) {
        assert!((found.as_f64().unwrap() - wanted).abs() < 1e-3, "{found}");
    }
}
