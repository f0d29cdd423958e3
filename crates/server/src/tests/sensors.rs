//! Setup of sensors: a camera's map found from a picture of a grid, reviewed, kept; numbers changed within the loader's
//! checks.

use super::{Bench, Visitor};
use axum::body::Body;
use http_body_util::BodyExt as _;
use seamwright_frames::Overlay;
use seamwright_machine::{Machine, Sight};
use seamwright_vision::Image;
use serde_json::{Value, json};

impl Bench {
    async fn plate(&self, who: &Visitor, of: &str) -> Vec<u8> {
        let response = self.raw(who.request("GET", &format!("/api/sensor/picture?{of}"), None)).await;
        assert!(response.status().is_success(), "{of}: {}", response.status());
        response.into_body().collect().await.unwrap().to_bytes().to_vec()
    }

    async fn seen(&self, who: &Visitor, of: &str, picture: &[u8]) -> Value {
        let mut request = who.request("POST", &format!("/api/sensor?{of}"), None);
        request.headers_mut().insert("content-type", "image/png".parse().unwrap());
        *request.body_mut() = Body::from(picture.to_vec());
        let (status, answer) = self.ask(request).await;
        assert!(status.is_success(), "{of}: {answer}");
        answer
    }
}

fn png(width: usize, height: usize, pixel: impl Fn(usize, usize) -> u8) -> Vec<u8> {
    let pixels = (0..width * height).map(|i| pixel(i % width, i / width)).collect();
    Overlay::of(&Image::U8 { width, height, pixels }.frame().unwrap()).png().unwrap()
}

fn heights(machine: &Machine) -> Vec<(f64, f64, f64)> {
    let Some(Sight::Camera(camera)) = machine.sensors.iter().find(|s| s.name == "camera").map(|s| &s.sight) else {
        panic!("no camera");
    };
    let row = |(height, map): &(f64, seamwright_geometry::PlaneMap)| {
        (-height, map.parameters().mm_per_px.x, map.parameters().rotation.to_degrees())
    };
    camera.table.rows().iter().rev().map(row).collect()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_camera_is_found_from_a_grid_and_kept() {
    let (bench, owner) = Bench::with_owner().await;
    bench.short(&owner).await;
    let of = "name=camera&pitch_mm=3&z_mm=20&seed=3";
    let picture = bench.plate(&owner, of).await;
    let found = bench.seen(&owner, of, &picture).await;
    assert_eq!(found["verdict"], "good", "{found}");
    let number = |v: &Value| v.as_f64().unwrap();
    let (was, is) = (&found["was"], &found["found"]);
    assert_eq!((number(&was["z_mm"]), &was["mm_per_px"]), (20.0, &json!([0.09, 0.09])));
    let change = number(&is["mm_per_px"][0]) / 0.09 - 1.0;
    assert!(change.abs() > 1e-4 && change.abs() < 0.021, "{is}");
    assert!(number(&found["rms_px"]) < 0.15 && number(&found["max_px"]) < 0.6, "{found}");
    let dots = found["dots"].as_array().unwrap();
    let greatest = dots.iter().map(|d| number(&d[2]).hypot(number(&d[3]))).fold(0.0, f64::max);
    assert!(dots.len() > 100 && (greatest - number(&found["max_px"])).abs() < 1e-9, "{}", dots.len());
    // Replaces the plane at that height and keeps the comment beside it; takes effect with the next load.
    let view = bench.did(&owner, "GET", "/api/sensors", Value::Null).await;
    let camera = view["sensors"].as_array().unwrap().iter().find(|s| s["name"] == "camera").unwrap();
    let mut rows = camera["heights"].as_array().unwrap().clone();
    assert_eq!((rows.len(), number(&rows[0]["z_mm"]), number(&rows[1]["z_mm"])), (2, -20.0, 20.0));
    rows[1] = is.clone();
    let change = json!({ "name": "camera", "values": [], "heights": rows });
    let view = bench.did(&owner, "PUT", "/api/sensor", change).await;
    assert_eq!((&view["pending"], &view["simulated"]), (&json!(true), &json!(true)));
    let path = bench.path().join("jobs/machines/saddle-4axis.toml");
    let kept = std::fs::read_to_string(&path).unwrap();
    assert!(kept.contains("# towards the camera, 200 mm away"), "{kept}");
    let machine = |bench: &Bench| bench.panel.cell.hub.machine().unwrap();
    assert!((heights(&machine(&bench))[1].1 - 0.09).abs() < 1e-12);
    bench.short(&owner).await;
    let now = heights(&machine(&bench));
    assert_eq!((now[0].1, now[1].1), (0.11, number(&is["mm_per_px"][0])));
    assert!((now[1].2 - number(&is["rotation_deg"])).abs() < 1e-9);
    // Adds a plane between them, then one at an existing height.
    rows.insert(1, json!({ "z_mm": 0.0, "mm_per_px": [0.1, 0.1], "centre_px": [320.0, 240.0], "rotation_deg": 0.0, "shear": 0.0, "barrel": 0.0 }));
    let change = json!({ "name": "camera", "values": [], "heights": rows });
    bench.did(&owner, "PUT", "/api/sensor", change).await;
    bench.short(&owner).await;
    assert_eq!(heights(&machine(&bench)).iter().map(|row| row.0).collect::<Vec<_>>(), [-20.0, 0.0, 20.0]);
    let kept = std::fs::read_to_string(&path).unwrap();
    rows[1]["z_mm"] = json!(20.0);
    let change = json!({ "name": "camera", "values": [], "heights": rows });
    assert!(bench.refused(&owner, "PUT", "/api/sensor", change).await.contains("increase"));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), kept);
    bench.panel.cell.archive.flush();
    let log = bench.did(&owner, "GET", "/api/audit?most=20", Value::Null).await;
    let row = log
        .as_array()
        .unwrap()
        .iter()
        .find(|row| row["command"]["text"].as_str().unwrap().contains("set sensor camera"));
    assert!(row.unwrap()["old"].as_str().unwrap().contains("0.09"), "{row:?}");
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_no_picture_of_the_grid_is_refused_with_its_reason() {
    let (bench, owner) = Bench::with_owner().await;
    bench.short(&owner).await;
    let of = "name=camera&pitch_mm=3&z_mm=20&seed=1";
    let verdict = async |of: &str, picture: &[u8]| {
        let answer = bench.seen(&owner, of, picture).await;
        assert!(answer["found"].is_null() == (answer["verdict"] != "far"), "{answer}");
        assert!(!answer["text"].as_str().unwrap().is_empty());
        answer["verdict"].as_str().unwrap().to_owned()
    };
    assert_eq!(verdict(of, b"GIF89a").await, "picture");
    assert_eq!(verdict(of, &png(640, 400, |_, _| 200)).await, "size");
    assert_eq!(verdict(of, &png(640, 480, |_, _| 128)).await, "plain");
    assert_eq!(verdict(of, &png(640, 480, |x, y| if x / 40 == y / 40 { 40 } else { 200 })).await, "few");
    let corner = |x: usize, y: usize| if x < 250 && x % 30 < 10 && y % 30 < 10 { 40 } else { 200 };
    assert_eq!(verdict(of, &png(640, 480, corner)).await, "corner");
    let bent = |x: usize, y: usize| {
        let y = (y as f64 + 5.0 * (x as f64 / 80.0).sin()) as usize;
        if x % 30 < 10 && y % 30 < 10 { 40 } else { 200 }
    };
    assert_eq!(verdict(of, &png(640, 480, bent)).await, "residual");
    // The same plate with a wrong pitch.
    let picture = bench.plate(&owner, of).await;
    assert_eq!(verdict("name=camera&pitch_mm=4&z_mm=20", &picture).await, "far");
    for (of, said) in [
        ("name=stripe&pitch_mm=3&z_mm=0", "not a camera"),
        ("name=nose&pitch_mm=3&z_mm=0", "no sensor `nose`"),
        ("name=camera&pitch_mm=0&z_mm=0", "pitch"),
    ] {
        let mut request = owner.request("POST", &format!("/api/sensor?{of}"), None);
        request.headers_mut().insert("content-type", "image/png".parse().unwrap());
        let (status, answer) = bench.ask(request).await;
        assert!(status == 422 && answer["text"].as_str().unwrap().contains(said), "{of}: {answer}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stripe_sensors_numbers_are_changed_as_the_loader_allows() {
    let (bench, owner) = Bench::with_owner().await;
    bench.short(&owner).await;
    let change = |values: Value| json!({ "name": "stripe", "values": values, "heights": null });
    let asked = change(json!([["at.move_mm", [0, 27.5, 0]], ["map.camera.focal_px", [3600]], ["latency_ms", [12]]]));
    let view = bench.did(&owner, "PUT", "/api/sensor", asked).await;
    let stripe = view["sensors"].as_array().unwrap().iter().find(|s| s["name"] == "stripe").unwrap();
    let value = |key: &str| stripe["values"].as_array().unwrap().iter().find(|v| v["key"] == key).cloned();
    assert_eq!(value("at.move_mm").unwrap()["numbers"], json!([0.0, 27.5, 0.0]));
    assert_eq!(value("map.camera.focal_px").unwrap()["numbers"], json!([3600.0]));
    // Its map is a camera's, so keys of the other kinds are not offered.
    assert!(value("map.homography").is_none() && value("map.camera.centre_px").is_some(), "{stripe}");
    let kept = std::fs::read_to_string(bench.path().join("jobs/machines/saddle-4axis.toml")).unwrap();
    for (values, said) in [
        (json!([["map.camera.angle_deg", [95]]]), "angle_deg"),
        (json!([["map.camera.focal_px", []]]), "focal_px"),
        (json!([["period_ms", [-1]]]), "period_ms"),
        (json!([["at.turn", [0, 0, 0]]]), "turn"),
        (json!([["at.move_mm", [1, 2]]]), "allowed: 3"),
        (json!([["kind", [1]]]), "no `kind`"),
        (json!([["map.homography", [1, 0, 0, 0, 1, 0, 0, 0]]]), "map"),
    ] {
        let text = bench.refused(&owner, "PUT", "/api/sensor", change(values)).await;
        assert!(text.contains(said), "{said}: {text}");
    }
    assert_eq!(std::fs::read_to_string(bench.path().join("jobs/machines/saddle-4axis.toml")).unwrap(), kept);
    bench.short(&owner).await;
    let machine = bench.panel.cell.hub.machine().unwrap();
    let stripe = machine.sensors.iter().find(|s| s.name == "stripe").unwrap();
    assert!((stripe.latency_s - 0.012).abs() < 1e-12);
}
