//! Jogging of an arm in its frames and about its tip, typed targets, and the search for a placement.

use super::lived::{Page, Served};
use super::{Bench, Visitor};
use axum::http::StatusCode;
use glam::{DMat3, DVec3};
use seamwright_machine::shipped;
use serde_json::{Value, json};
use std::time::Duration;

/// A weld of the arm beside its home position, with a wall 500 mm behind it on the work.
fn job() -> String {
    let machine = seamwright_machine::Machine::read("m", shipped("ur10e").unwrap().text).unwrap();
    let tip = machine.forward(&machine.home()).point;
    format!(
        r#"
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
points = [[1, -90, -90, -90, 90, 0, 200, 6], [2, -90, -90, -90, 90, 0, 200, 6]]
[[fixtures]]
name = "wall"
shape.box = {{ size_mm = [600, 20, 600] }}
at = {{ move_mm = [{}, {}, {}] }}
"#,
        tip.x,
        tip.y - 500.0,
        tip.z,
    )
}

/// A machine file with a user frame: turned by 30 degrees about z, away from the base.
fn framed() -> String {
    format!("{}\n[frames.table]\nmove_mm = [100, 200, 0]\nangle_deg = 30\n", shipped("ur10e").unwrap().text)
}

async fn arm() -> (Served, Visitor, Page) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir_all(folder.path().join("jobs/machines")).unwrap();
    std::fs::write(folder.path().join("jobs/machines/ur10e.toml"), framed()).unwrap();
    std::fs::write(folder.path().join("jobs/arm.toml"), job()).unwrap();
    let served = Served::bare(folder, &framed()).await;
    crate::http::begin_with(&served.bench.panel, "arm.toml").await.unwrap();
    let owner = served.bench.owner().await;
    let mut page = served.page_up(&owner).await;
    page.order("start_jog").await;
    page.mode("jog").await;
    (served, owner, page)
}

async fn held(page: &mut Page, what: &Value, times: u32) {
    for _ in 0..times {
        page.say(&json!({ "kind": "beat" })).await;
        page.hand(what.clone()).await;
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    page.hand(json!({ "kind": "jog", "of": "joints", "speeds": [0.0] })).await;
    let begun = page.status["t"].as_f64().unwrap();
    page.until_status("rest", |v| v["stands"] == true && v["t"].as_f64().unwrap() > begun + 0.4).await;
}

/// The tool frame in the work frame: its axes and its origin.
fn tool(page: &Page) -> (DMat3, DVec3) {
    let rows: Vec<f64> = serde_json::from_value(page.status["tool"].clone()).unwrap();
    let row = |i: usize| DVec3::new(rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]);
    let matrix = DMat3::from_cols(row(0), row(1), row(2)).transpose();
    (matrix, DVec3::new(rows[3], rows[7], rows[11]))
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_tip_is_jogged_in_every_frame_and_turned_about_itself() {
    let (served, owner, mut page) = arm().await;
    let view = served.bench.did(&owner, "GET", "/api/machine", Value::Null).await;
    assert_eq!((&view["turns"], &view["user_frames"][0]["name"]), (&json!([true, true, true]), &json!("table")));
    page.until_status("rest", |v| v["stands"] == true).await;
    let arm = &page.status["arm"];
    assert_eq!((&arm["shoulder"], &arm["turns"]), (&json!("back"), &json!([0, 0, 0, 0, 0, 0])), "{arm}");
    // 30 degrees about z of a base that is not turned against the work.
    let turned = DVec3::new(30f64.to_radians().cos(), 30f64.to_radians().sin(), 0.0);
    for (frame, wanted) in [("work", Some(DVec3::X)), ("base", Some(DVec3::X)), ("table", Some(turned)), ("tool", None)]
    {
        let (axes, from) = tool(&page);
        held(&mut page, &json!({ "kind": "jog", "of": "tip", "frame": frame, "speeds": [0.2, 0.0, 0.0] }), 8).await;
        let (after, to) = tool(&page);
        let by = to - from;
        assert!(by.length() > 5.0, "{frame}: {by}");
        assert!(by.reject_from(wanted.unwrap_or(axes.x_axis)).length() < 1.0, "{frame}: {by}");
        assert!((after.x_axis - axes.x_axis).length() < 0.01, "{frame}");
    }
    // A step along y of the user frame, and one about z of the tool.
    let (_, from) = tool(&page);
    held(&mut page, &json!({ "kind": "step", "of": "tip", "frame": "table", "index": 1, "by": 5.0 }), 30).await;
    let (axes, to) = tool(&page);
    let wanted = 5.0 * DVec3::new(-turned.y, turned.x, 0.0);
    assert!((to - from - wanted).length() < 0.05, "{}", to - from);
    held(&mut page, &json!({ "kind": "step", "of": "turn", "frame": "tool", "index": 2, "by": 1.0 }), 30).await;
    let (after, still) = tool(&page);
    assert!((still - to).length() < 0.05, "{}", still - to);
    assert!((after.x_axis.angle_between(axes.x_axis).to_degrees() - 1.0).abs() < 0.02);
    // Continuous turn about the tip.
    held(&mut page, &json!({ "kind": "jog", "of": "turn", "frame": "tool", "speeds": [0.3, 0.0, 0.0] }), 10).await;
    let (end, there) = tool(&page);
    // Released, every axis stops by itself.
    assert!((there - to).length() < 0.5 && end.x_axis.angle_between(after.x_axis) < 0.01, "{}", there - to);
    assert!(end.z_axis.angle_between(after.z_axis).to_degrees() > 1.0);
    // Steps that are too large, and unknown frames, do nothing.
    let before = tool(&page);
    for wrong in [
        json!({ "kind": "step", "of": "turn", "frame": "tool", "index": 2, "by": 5.0 }),
        json!({ "kind": "step", "of": "tip", "frame": "nowhere", "index": 2, "by": 5.0 }),
        json!({ "kind": "jog", "of": "tip", "frame": "nowhere", "speeds": [0.3, 0.0, 0.0] }),
    ] {
        held(&mut page, &wrong, 4).await;
    }
    assert!((tool(&page).1 - before.1).length() < 0.01);
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_target_is_checked_before_anything_moves() {
    let (served, owner, mut page) = arm().await;
    page.until_status("rest", |v| v["stands"] == true).await;
    let (_, home) = tool(&page);
    let target = |body: Value| served.bench.did(&owner, "POST", "/api/target", body);
    let point = |by: [f64; 3]| json!([home.x + by[0], home.y + by[1], home.z + by[2]]);
    let tip = |frame: &str, point: Value, turn: Value| json!({ "axes": null, "tip": { "frame": frame, "point": point, "turn": turn } });
    // 50 mm up, in the work frame and relative to the tool, whose z points to the work.
    let up = target(tip("work", point([0.0, 0.0, 50.0]), Value::Null)).await;
    assert_eq!(up["refused"], Value::Null, "{up}");
    let tips: Vec<[f64; 3]> = serde_json::from_value(up["tips"].clone()).unwrap();
    let end = DVec3::from_array(tips[tips.len() - 1]);
    assert!((end - home - DVec3::new(0.0, 0.0, 50.0)).length() < 1e-2, "{end}");
    assert!(up["time_s"].as_f64().unwrap() > 0.2 && up["arm"]["shoulder"] == "back", "{up}");
    let (axes, _) = tool(&page);
    let back = target(tip("tool", json!([0.0, 0.0, -20.0]), Value::Null)).await;
    let tips: Vec<[f64; 3]> = serde_json::from_value(back["tips"].clone()).unwrap();
    assert!((DVec3::from_array(tips[tips.len() - 1]) - home + 20.0 * axes.z_axis).length() < 1e-2);
    // With an orientation: turned about the tool's own z by 20 degrees, the tip rests.
    let (sin, cos) = 10f64.to_radians().sin_cos();
    let turned = target(tip("tool", json!([0.0, 0.0, 0.0]), json!([cos, 0.0, 0.0, sin]))).await;
    let positions: Vec<f64> = serde_json::from_value(turned["axes"].clone()).unwrap();
    let machine = served.bench.panel.cell.hub.machine().unwrap();
    let frame = machine.tool_frame(&machine.joints_from_file(&positions));
    assert!((frame.matrix3.x_axis.angle_between(axes.x_axis).to_degrees() - 20.0).abs() < 1e-6, "{turned}");
    assert!(frame.translation.distance(home) < 1e-6);
    // Through the wall, out of reach, out of range.
    let through = target(tip("work", point([0.0, -500.0, 0.0]), Value::Null)).await;
    assert_eq!(through["refused"]["code"], "server-target-near", "{through}");
    assert!(through["nearest"]["between"].to_string().contains("wall"), "{through}");
    assert!(through["stops"].as_array().unwrap().len() == 6);
    let far = target(tip("work", point([0.0, 0.0, 5000.0]), Value::Null)).await;
    assert!(far["refused"].is_object() && far["axes"] == json!([]), "{far}");
    let beyond = target(json!({ "axes": [0.0, -90.0, -90.0, -90.0, 90.0, 400.0], "tip": null })).await;
    assert_eq!(beyond["refused"]["code"], "motion-jog-range", "{beyond}");
    // Nothing has moved; the checked target is reached by `go`.
    assert!((tool(&page).1 - home).length() < 0.05);
    page.control().await;
    let go = json!({ "kind": "go", "axes": up["axes"] });
    held(&mut page, &go, 90).await;
    assert!((tool(&page).1 - end).length() < 0.05, "{}", tool(&page).1 - end);
    // Nonsense is refused.
    for body in [
        json!({ "axes": [1.0], "tip": null }),
        json!({ "axes": null, "tip": null }),
        tip("nowhere", json!([0.0, 0.0, 0.0]), Value::Null),
        tip("work", json!([0.0, 0.0, 1e9]), Value::Null),
        tip("work", json!([0.0, 0.0, 0.0]), json!([1.0, 1.0, 0.0, 0.0])),
    ] {
        served.bench.refused(&owner, "POST", "/api/target", body).await;
    }
}

/// The best placement of a job at the edge of the table, found as the command line finds it, in the text of the job.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_best_placement_is_found_and_written() {
    let (bench, owner) = Bench::with_owner().await;
    let ellipse = include_str!("../../../../examples/ellipse.toml");
    let asked = |ranges: Value, cells: Value| json!({ "text": ellipse, "moved": "work", "ranges": ranges, "cells": cells, "budget_s": 60.0 });
    let ranges = json!([[-300.0, 300.0], [-100.0, 100.0], [0.0, 0.0], [0.0, 0.0]]);
    let found = bench.did(&owner, "POST", "/api/reach", asked(ranges, json!([3, 2, 1, 1]))).await;
    assert_eq!(found["grid"], json!([[-300.0, 0.0, 300.0], [-100.0, 100.0], [0.0], [0.0]]));
    let places = found["places"].as_array().unwrap();
    let cells = places.iter().filter(|place| place["cell"].is_array()).count();
    assert!(cells >= 6 && places[0]["at"] == json!([0.0, 0.0, 0.0, 0.0]), "{cells} {}", places[0]);
    let best = &found["best"];
    let margin = |place: &Value| place["margin"].as_f64();
    let most = places.iter().filter_map(margin).fold(0.0, f64::max);
    assert!(margin(&best["place"]).unwrap() > most - 0.01, "{best}");
    let text = best["text"].as_str().unwrap();
    assert!(text.contains("move_mm") && text != ellipse);
    // What is written is planned, with the same margin or more.
    let plan = bench.did(&owner, "POST", "/api/plan", json!({ "text": text })).await;
    assert_eq!(plan["work"]["good"], true, "{plan}");
    let wrong = asked(json!([[300.0, -300.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]), json!([3, 1, 1, 1]));
    assert!(bench.refused(&owner, "POST", "/api/reach", wrong).await.contains("range"));
    let many = asked(json!([[-1.0, 1.0], [-1.0, 1.0], [0.0, 0.0], [0.0, 0.0]]), json!([100, 100, 1, 1]));
    assert!(bench.refused(&owner, "POST", "/api/reach", many).await.contains("2000"));
    // A viewer may not plan.
    let everybody = bench.everybody().await;
    let (_, viewer) = everybody.iter().find(|(role, _)| format!("{role:?}") == "Viewer").unwrap();
    let ranges = json!([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]);
    let (status, _) = bench.ask(viewer.request("POST", "/api/reach", Some(&asked(ranges, json!([1, 1, 1, 1]))))).await;
    assert_eq!(status, StatusCode::FORBIDDEN);
}
