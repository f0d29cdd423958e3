//! Jog steps, and teaching by camera on the simulated beam machine.

use super::Visitor;
use super::lived::{Page, Served};
use crate::http::Panel;
use axum::http::StatusCode;
use http_body_util::BodyExt as _;
use seamwright_frames::{FrameSource as _, TimedFrame, write_frame};
use seamwright_machine::Sight;
use seamwright_project::load::{Loaded, load_text};
use seamwright_simulation::camera_simulator::{Appearance, CameraSimulator};
use seamwright_teaching::{SeamLine, nominal};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// Sends a message every 50 ms, as a held key does.
async fn hold(page: &mut Page, what: &Value, times: u32) {
    for _ in 0..times {
        page.say(&json!({ "kind": "beat" })).await;
        page.hand(what.clone()).await;
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
}

/// Returns the set-points once the axes are at rest. Skips old messages that the page has not read yet.
async fn rest(served: &Served, page: &mut Page) -> Vec<f64> {
    let mut before = Vec::new();
    loop {
        let begun = served.bench.panel.cell.hub.latest().unwrap().t;
        page.until_status("status", |v| v["t"].as_f64().unwrap() > begun + 0.15).await;
        let set = |axis: &Value| axis["set"].as_f64().unwrap();
        let now: Vec<f64> = page.status["axes"].as_array().unwrap().iter().map(set).collect();
        if now == before {
            return now;
        }
        before = now;
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn no_place_is_recorded_while_something_moves() {
    let (served, owner) = Served::with_owner().await;
    let mut page = served.page(&owner).await;
    let position = || served.bench.ask(owner.request("GET", "/api/position", None));
    page.up().await;
    page.order("start_jog").await;
    page.mode("jog").await;
    page.until_status("rest", |v| v["stands"] == true).await;
    let (status, place) = position().await;
    assert_eq!((status, place["axes"].as_array().unwrap().len()), (StatusCode::OK, 2), "{place}");
    let jog = json!({ "kind": "jog", "of": "joints", "speeds": [0.1, 0.0] });
    hold(&mut page, &jog, 8).await;
    let (status, refused) = position().await;
    assert_eq!((status, &refused["key"]), (StatusCode::CONFLICT, &json!("busy")), "{refused}");
    assert_eq!(refused["text"], "the axes are still moving: wait a moment");
    hold(&mut page, &json!({ "kind": "jog", "of": "joints", "speeds": [0.0, 0.0] }), 1).await;
    let there = rest(&served, &mut page).await;
    page.until_status("rest", |v| v["stands"] == true).await;
    let (status, place) = position().await;
    assert_eq!(status, StatusCode::OK, "{place}");
    let off = |(at, there): (&Value, &f64)| (at.as_f64().unwrap() - there).abs();
    assert!(place["axes"].as_array().unwrap().iter().zip(&there).map(off).all(|off| off < 0.02), "{place} {there:?}");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_step_goes_so_far_and_no_farther() {
    let (served, owner) = Served::with_owner().await;
    let mut page = served.page(&owner).await;
    let let_go = json!({ "kind": "jog", "of": "joints", "speeds": [0.0, 0.0] });
    let step = |of: &str, index: u32, by: f64| json!({ "kind": "step", "of": of, "index": index, "by": by });
    page.up().await;
    page.order("start_jog").await;
    page.mode("jog").await;
    let begun = rest(&served, &mut page).await;
    let mut there = begun.clone();
    for (of, index, by) in
        [("joints", 0, 1.0), ("joints", 1, 0.1), ("joints", 0, 0.01), ("tip", 1, 1.0), ("tip", 0, -1.0)]
    {
        hold(&mut page, &step(of, index, by), 24).await;
        hold(&mut page, &let_go, 1).await;
        there[index as usize] += by;
        let now = rest(&served, &mut page).await;
        let off = now.iter().zip(&there).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-5, "{of} {index} {by}: {now:?} {there:?} {}", page.alarms);
    }
    // A key released early stops the step on its way; invalid steps do nothing.
    assert_eq!(page.ask(json!({ "do": "override", "part": 0.02 })).await["ok"], true);
    hold(&mut page, &step("joints", 0, 10.0), 3).await;
    hold(&mut page, &let_go, 1).await;
    let now = rest(&served, &mut page).await;
    assert!(now[0] > there[0] + 1e-3 && now[0] < there[0] + 9.9, "{now:?}");
    for wrong in [step("joints", 9, 1.0), step("tip", 3, 1.0), step("joints", 0, 11.0)] {
        hold(&mut page, &wrong, 4).await;
    }
    hold(&mut page, &json!({ "kind": "go", "axes": [0.0] }), 4).await;
    assert_eq!(rest(&served, &mut page).await, now);
    // Moves all axes to a position.
    assert_eq!(page.ask(json!({ "do": "override", "part": 1.0 })).await["ok"], true);
    hold(&mut page, &json!({ "kind": "go", "axes": begun }), 60).await;
    let back = rest(&served, &mut page).await;
    assert!(back.iter().zip(&begun).all(|(a, b)| (a - b).abs() < 1e-5), "{back:?}");
}

impl Page {
    async fn phase(&mut self, phase: &str) {
        if self.taught["phase"] != phase {
            self.until(phase, |v| v["kind"] == "teach" && v["phase"] == phase).await;
        }
    }

    async fn taken(&mut self, order: Value) {
        let answer = self.teach(order.clone()).await;
        assert_eq!(answer["ok"], true, "{order}: {answer}");
    }

    async fn refused(&mut self, order: Value) -> Value {
        let answer = self.teach(order.clone()).await;
        assert_eq!(answer["ok"], false, "{order}");
        answer["why"]["key"].clone()
    }
}

/// Loads 80 mm of the half ring, without its cosmetic pass.
async fn short_ring(served: &Served, owner: &super::Visitor, machine: &str) {
    let (_, example) = served.bench.ask(owner.request("GET", "/api/jobs/half-ring.toml", None)).await;
    let text = example["text"].as_str().unwrap().replace("end_phi_deg = 210", "end_phi_deg = 60");
    let text = text.split("[cosmetic]").next().unwrap().replace("ebw-7axis", machine);
    let put = owner.request("PUT", "/api/jobs/ring.toml", Some(&json!({ "text": text })));
    assert_eq!(served.bench.ask(put).await.0, StatusCode::OK);
    crate::http::begin_with(&served.bench.panel, "ring.toml").await.unwrap();
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_seam_is_taught_by_eye_paused_taken_over_lost_and_kept() {
    let served = Served::without_program("ebw-7axis").await;
    let bench = &served.bench;
    let owner = bench.owner().await;
    let mut page = served.page(&owner).await;
    let open = json!({ "do": "open", "step_mm": 12.0, "longest_tack_mm": 5.0, "seed": 7, "tack_mm": [30.0, 44.0] });
    assert_eq!(page.refused(open.clone()).await, "control");
    page.up().await;
    assert_eq!(page.refused(open.clone()).await, "work");
    short_ring(&served, &owner, "ebw-7axis").await;
    // On a busy computer loading takes longer than the heartbeat allows.
    page.control().await;
    let (_, work) = bench.ask(owner.request("GET", "/api/work", None)).await;
    let path = work["passes"][0]["path"].as_array().unwrap().clone();
    let tip = |i: usize| path[i]["tip"].clone();
    let (status, _) = bench.ask(owner.request("GET", "/api/teach/picture", None)).await;
    assert_eq!(status, StatusCode::NOT_FOUND);
    for (wrong, key) in [
        (json!({ "do": "open", "step_mm": 0.1, "longest_tack_mm": 5.0, "seed": 7, "tack_mm": null }), "value"),
        (json!({ "do": "open", "step_mm": 8.0, "longest_tack_mm": 5.0, "seed": 7, "tack_mm": [3.0, 2.0] }), "value"),
        (json!({ "do": "here", "px": null, "at": tip(0) }), "mode"),
        (json!({ "do": "resume" }), "mode"),
        (json!({ "do": "stop" }), "mode"),
    ] {
        assert_eq!(page.refused(wrong.clone()).await, key, "{wrong}");
    }
    page.control().await;
    page.order("start_teach").await;
    page.mode("teach").await;
    page.taken(open.clone()).await;
    page.phase("places").await;
    assert_eq!(page.refused(open).await, "busy");
    assert_eq!(page.refused(json!({ "do": "here", "px": null, "at": [0.0, 0.0, 0.0] })).await, "value");
    page.taken(json!({ "do": "here", "px": null, "at": tip(0) })).await;
    page.until("frames", |v| v["kind"] == "teach" && v["frames"].as_u64().unwrap() >= 2).await;
    assert!(page.taught["confidence"].as_f64().unwrap() > 0.5, "{}", page.taught);
    // Paused, the axes are at rest.
    page.taken(json!({ "do": "pause" })).await;
    page.phase("paused").await;
    assert_eq!(page.taught["key"], "operator");
    let stood = rest(&served, &mut page).await;
    assert_eq!(rest(&served, &mut page).await, stood);
    // It continues until jogging pauses it; jogged away, it returns by itself.
    page.taken(json!({ "do": "resume" })).await;
    page.phase("runs").await;
    let up = json!({ "kind": "jog", "of": "joints", "speeds": [0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0] });
    hold(&mut page, &up, 10).await;
    hold(&mut page, &json!({ "kind": "jog", "of": "joints", "speeds": [0.0] }), 1).await;
    page.phase("paused").await;
    assert_eq!(page.taught["key"], "hand");
    page.taken(json!({ "do": "resume" })).await;
    // A tack hides the joint: the operator is asked, and points beyond it.
    page.phase("asks").await;
    assert!(page.taught["why"]["text"].as_str().is_some_and(|why| !why.is_empty()), "{}", page.taught);
    let picture = bench.raw(owner.request("GET", "/api/teach/picture", None)).await;
    assert_eq!(picture.headers()["content-type"], "image/png");
    let bytes = picture.into_body().collect().await.unwrap().to_bytes();
    assert!(bytes.starts_with(b"\x89PNG"));
    // The joint is not at its nominal position, but visible in the picture.
    let beyond = path.iter().position(|p| p["s_mm"].as_f64().unwrap() > 50.0).unwrap();
    // A point 5 mm off is too far: the joint must be within 18 pixels.
    let mut beside: [f64; 3] = serde_json::from_value(tip(beyond)).unwrap();
    beside[2] += 5.0;
    page.taken(json!({ "do": "here", "px": null, "at": beside })).await;
    page.phase("runs").await;
    page.phase("asks").await;
    rest(&served, &mut page).await;
    let px = joint_in_picture(&served, &page);
    assert!((100.0..412.0).contains(&px[0]) && (100.0..412.0).contains(&px[1]), "{px:?}");
    assert_eq!(page.refused(json!({ "do": "here", "px": px, "at": tip(0) })).await, "value");
    page.taken(json!({ "do": "here", "px": px, "at": null })).await;
    page.phase("ended").await;
    assert_eq!(page.taught["key"], "joint-end", "{}", page.taught);
    assert_programs_are_stored(&served, &owner).await;
    // Loading the same job keeps the result; another job's seam discards it.
    page.order("hold").await;
    page.mode("ready").await;
    let points = async || {
        let (_, taught) = bench.ask(owner.request("GET", "/api/teach", None)).await;
        taught["points"].as_array().unwrap().len()
    };
    crate::http::begin_with(&bench.panel, "ring.toml").await.unwrap();
    assert!(points().await > 40);
    crate::http::begin_with(&bench.panel, "oblique-girth.toml").await.unwrap();
    assert_eq!(points().await, 0);
    page.phase("closed").await;
    // Orders need the role and control.
    let everybody = bench.everybody().await;
    let operator = &everybody.iter().find(|(r, _)| format!("{r:?}") == "Operator").unwrap().1;
    let mut other = served.page(operator).await;
    assert_eq!(other.refused(json!({ "do": "stop" })).await, "role");
}

/// Runs a camera that sends frames of the camera simulator at the cell's axis positions, until its receiver closes or
/// all frames are sent.
fn camera(served: &Served, listener: std::net::TcpListener, frames: u32) {
    let panel = std::sync::Arc::clone(&served.bench.panel);
    std::thread::spawn(move || {
        let (actual, loaded) = actual(&panel);
        let sensor = &loaded.machine.sensors[0];
        let mut eye = CameraSimulator::new(&loaded.machine, sensor, actual, Appearance::default(), 7).unwrap();
        let (mut stream, _) = listener.accept().unwrap();
        for k in 0..frames {
            let exposed = Instant::now();
            let status = panel.cell.hub.latest().unwrap();
            let axes: Vec<f64> = status.axes.iter().map(|axis| axis.position).collect();
            eye.expose(0.05 * f64::from(k), &loaded.machine.joints_from_file(&axes));
            let frame = eye.next().unwrap().unwrap();
            // Rendering is slow on a busy computer: frames later than the latency in the machine file are skipped.
            if exposed.elapsed() > Duration::from_millis(1400) {
                continue;
            }
            // A camera does not know the axis positions.
            if write_frame(&TimedFrame { axes: None, ..frame }, &mut stream).is_err() {
                return;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    });
}

/// A cell whose machine file names the address of a camera, with the short ring loaded.
async fn with_camera_at(address: &str) -> (Served, Visitor, Page) {
    let text = super::shipped("ebw-7axis").unwrap().text;
    let text = text.replacen("latency_ms =", &format!("frames = \"tcp://{address}\"\nlatency_ms = 1500 #"), 1);
    let served = Served::bare(tempfile::tempdir().unwrap(), &text).await;
    std::fs::write(served.bench.panel.jobs().join("m.toml"), &text).unwrap();
    let owner = served.bench.owner().await;
    let page = served.page_up(&owner).await;
    short_ring(&served, &owner, "m.toml").await;
    (served, owner, page)
}

/// A machine file among the jobs may name any address: the cell connects only to allowed ones.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_machine_file_connects_the_cell_to_no_camera_of_its_choice() {
    let (_served, _, mut page) = with_camera_at("192.0.2.1:7000").await;
    page.control().await;
    page.order("start_teach").await;
    page.mode("teach").await;
    page.taken(json!({ "do": "open", "step_mm": 12.0, "longest_tack_mm": 5.0, "seed": 1, "tack_mm": null })).await;
    page.phase("ended").await;
    assert_eq!(page.taught["key"], "failed", "{}", page.taught);
    let why = page.taught["why"]["text"].as_str().unwrap();
    assert!(why.contains("192.0.2.1:7000") && why.contains("does not connect"), "{why}");
}

/// The panel teaches by the machine's own camera if its file contains the address of the frames.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_seam_is_taught_by_the_machines_own_camera() {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let (served, owner, mut page) = with_camera_at(&listener.local_addr().unwrap().to_string()).await;
    let (_, work) = served.bench.ask(owner.request("GET", "/api/work", None)).await;
    let tip = work["passes"][0]["path"][0]["tip"].clone();
    page.control().await;
    page.order("start_teach").await;
    page.mode("teach").await;
    let open = json!({ "do": "open", "step_mm": 12.0, "longest_tack_mm": 5.0, "seed": 1, "tack_mm": null });
    let address = listener.local_addr().unwrap();
    camera(&served, listener, u32::MAX);
    page.taken(open).await;
    page.phase("places").await;
    page.taken(json!({ "do": "here", "px": null, "at": tip })).await;
    page.phase("ended").await;
    assert_eq!(page.taught["key"], "joint-end", "{}", page.taught);
    assert!(page.taught["frames"].as_u64().unwrap() >= 6, "{}", page.taught);
    // The taught points lie on the joint; the panel knows the deviation only with the camera simulator.
    let actual = actual(&served.bench.panel).0;
    let (_, taught) = served.bench.ask(owner.request("GET", "/api/teach", None)).await;
    let off = |point: &Value| {
        let at: [f64; 3] = serde_json::from_value(point["at"].clone()).unwrap();
        (actual.foot(at.into()).unwrap().at.point.distance(at.into()), point["confidence"].as_f64().unwrap())
    };
    let offs: Vec<(f64, f64)> = taught["points"].as_array().unwrap().iter().map(off).collect();
    let rms = (offs.iter().map(|(off, _)| off * off).sum::<f64>() / offs.len() as f64).sqrt();
    assert!(rms < 0.12 && offs.iter().all(|(off, _)| *off < 0.4), "{rms} {offs:?}");
    let how = json!({ "tolerance_mm": 0.1, "attitude_deg": 0.5, "method": "spline" });
    let (status, made) = served.bench.ask(owner.request("POST", "/api/teach/program", Some(&how))).await;
    assert_eq!((status, made["truth_mm"].is_null()), (StatusCode::OK, true), "{made}");
    // A camera that fails while the operator is asked for a position is reported, and the question stays.
    // The first camera ends when its receiver closes.
    let listener = loop {
        match std::net::TcpListener::bind(address) {
            Ok(listener) => break listener,
            Err(_) => tokio::time::sleep(Duration::from_millis(100)).await,
        }
    };
    camera(&served, listener, 2);
    let open = json!({ "do": "open", "step_mm": 12.0, "longest_tack_mm": 5.0, "seed": 1, "tack_mm": null });
    page.taken(open.clone()).await;
    page.phase("places").await;
    let told = |v: &Value| v["why"]["text"].as_str().is_some_and(|why| why.contains("127.0.0.1"));
    page.until("why", |v| v["kind"] == "teach" && told(v)).await;
    assert_eq!(page.taught["phase"], "places", "{}", page.taught);
    page.taken(json!({ "do": "stop" })).await;
    page.phase("ended").await;
    // Without a camera the failure is reported, and nothing moves.
    let open = json!({ "do": "open", "step_mm": 12.0, "longest_tack_mm": 5.0, "seed": 1, "tack_mm": null });
    page.taken(open).await;
    page.phase("ended").await;
    assert_eq!(page.taught["key"], "failed", "{}", page.taught);
    assert!(page.taught["why"]["text"].as_str().unwrap().contains("127.0.0.1"), "{}", page.taught);
}

/// Returns the true joint of the loaded job in the camera simulator, and that job.
fn actual(panel: &Panel) -> (SeamLine, Loaded) {
    let text = std::fs::read_to_string(panel.jobs().join("ring.toml")).unwrap();
    let loaded = load_text("ring.toml", &text, &panel.jobs()).unwrap();
    (crate::teaching::DISTORTION.of(&nominal(&loaded.welding.program.value, loaded.seam().unwrap()), 7), loaded)
}

/// Returns the pixel of the true joint at 50 mm of the nominal one.
fn joint_in_picture(served: &Served, page: &Page) -> [f64; 2] {
    let (actual, loaded) = actual(&served.bench.panel);
    let position = |axis: &Value| axis["position"].as_f64().unwrap();
    let axes: Vec<f64> = page.status["axes"].as_array().unwrap().iter().map(position).collect();
    let sensor = &loaded.machine.sensors[0];
    let camera = loaded.machine.camera_frame(sensor, &loaded.machine.joints_from_file(&axes));
    let Sight::Camera(sight) = &sensor.sight else { panic!("no camera") };
    sight.table.to_px(camera.inverse().transform_point3(actual.at(50.0).0.point)).unwrap().to_array()
}

/// Checks that taught points are reported, become a program, are kept, and can be planned.
async fn assert_programs_are_stored(served: &Served, owner: &super::Visitor) {
    let bench = &served.bench;
    let (_, taught) = bench.ask(owner.request("GET", "/api/teach", None)).await;
    let points = taught["points"].as_array().unwrap();
    assert!(points.len() > 40 && taught["looks"].as_array().unwrap().len() > 4, "{}", points.len());
    let wrong = json!({ "tolerance_mm": 0.0, "attitude_deg": 0.5, "method": "greedy" });
    let (status, _) = bench.ask(owner.request("POST", "/api/teach/program", Some(&wrong))).await;
    assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY);
    for method in ["spline", "greedy"] {
        let how = json!({ "tolerance_mm": 0.1, "attitude_deg": 0.5, "method": method });
        let made = bench.did(owner, "POST", "/api/teach/program", how).await;
        let truth = made["truth_mm"][0].as_f64().unwrap();
        assert!(made["error_mm"].as_f64().unwrap() <= 0.1 && truth < 0.2, "{}", made["truth_mm"]);
        // The part is some millimetres off its nominal position.
        let off = made["from_nominal_mm"][0].as_f64().unwrap();
        assert!(off > 0.05 && off < 5.0, "{off}");
        let put = owner.request("PUT", "/api/jobs/taught.toml", Some(&json!({ "text": made["text"] })));
        assert_eq!(bench.ask(put).await.0, StatusCode::OK);
        let plan = owner.request("POST", "/api/plan", Some(&json!({ "text": made["text"] })));
        let (_, answer) = bench.ask(plan).await;
        assert_eq!(answer["kind"], "planned", "{answer}");
    }
}

/// If the commanding page goes, the axes stop and nothing continues by itself.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn without_its_page_teaching_stands() {
    let served = Served::without_program("ebw-7axis").await;
    let owner = served.bench.owner().await;
    let mut page = served.page_up(&owner).await;
    short_ring(&served, &owner, "ebw-7axis").await;
    let (_, work) = served.bench.ask(owner.request("GET", "/api/work", None)).await;
    page.control().await;
    page.order("start_teach").await;
    page.mode("teach").await;
    let open = json!({ "do": "open", "step_mm": 8.0, "longest_tack_mm": 10.0, "seed": 1, "tack_mm": null });
    page.taken(open).await;
    page.phase("places").await;
    let begun = rest(&served, &mut page).await;
    page.taken(json!({ "do": "here", "px": null, "at": work["passes"][0]["path"][0]["tip"] })).await;
    page.until_status("motion", |v| (v["axes"][0]["set"].as_f64().unwrap() - begun[0]).abs() > 1.0).await;
    drop(page);
    let mut other = served.page(&owner).await;
    other.until("a pause", |v| v["kind"] == "teach" && v["phase"] == "paused" && v["key"] == "control").await;
    let stood = rest(&served, &mut other).await;
    tokio::time::sleep(Duration::from_millis(500)).await;
    assert_eq!(rest(&served, &mut other).await, stood);
    // The next holder of the control token can resume.
    other.take_over().await;
    other.taken(json!({ "do": "resume" })).await;
    other.until("a frame", |v| v["kind"] == "teach" && v["frames"].as_u64().unwrap() >= 1).await;
    other.taken(json!({ "do": "stop" })).await;
    other.phase("ended").await;
    assert_eq!(other.taught["key"], "stopped");
}
