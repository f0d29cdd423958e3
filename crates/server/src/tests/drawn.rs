//! Drawings beside the plan: sections, bodies, clearance, devices, pose of the part.

use super::Bench;
use axum::http::StatusCode;
use serde_json::{Value, json};

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().filter_map(Value::as_f64).collect()
}

async fn example(bench: &Bench, owner: &super::Visitor, name: &str) -> String {
    let (_, job) = bench.ask(owner.request("GET", &format!("/api/jobs/{name}"), None)).await;
    job["text"].as_str().unwrap().to_owned()
}

/// Area of an outline, mm^2.
fn area(outline: &Value) -> f64 {
    let points: Vec<Vec<f64>> = outline.as_array().unwrap().iter().map(numbers).collect();
    let cross = |i: usize| {
        let (a, b) = (&points[i], &points[(i + 1) % points.len()]);
        a[0] * b[1] - a[1] * b[0]
    };
    (0..points.len()).map(cross).sum::<f64>().abs() / 2.0
}

/// Sections of two joints: beads fill the groove, and outlines have the reported areas.
#[tokio::test(flavor = "multi_thread")]
async fn a_draft_has_the_joint_as_it_is_written() {
    let (bench, owner) = Bench::with_owner().await;
    for name in ["thick-saddle.toml", "tube-plate.toml", "ellipse.toml"] {
        let text = example(&bench, &owner, name).await;
        let (status, draft) = bench.ask(owner.request("POST", "/api/draft", Some(&json!({ "text": text })))).await;
        assert_eq!((status, &draft["kind"]), (StatusCode::OK, &json!("drawn")), "{name}: {draft}");
        let sections = draft["sections"].as_array().unwrap();
        assert_eq!(sections.is_empty(), !text.contains("[joint"), "{name}");
        for section in sections {
            let edge = |i: usize| section["edges"][i].as_array().unwrap().clone();
            let groove: Vec<Value> = edge(0).into_iter().chain(edge(1).into_iter().rev()).collect();
            let told = section["area_mm2"].as_f64().unwrap();
            assert!((area(&Value::Array(groove)) - told).abs() < 0.02 * told + 0.05, "{name}: {told}");
            let beads = section["beads"].as_array().unwrap();
            let sum: f64 = beads.iter().map(|b| b["area_mm2"].as_f64().unwrap()).sum();
            let all = told + section["cap_mm2"].as_f64().unwrap();
            assert!(beads.is_empty() || (sum - all).abs() < 1e-6 * all, "{name}: {sum} of {all}");
        }
    }
    let wrong = json!({ "text": "title = 1" });
    let (status, draft) = bench.ask(owner.request("POST", "/api/draft", Some(&wrong))).await;
    assert_eq!((status, &draft["kind"]), (StatusCode::OK, &json!("wrong")));
    assert_eq!(draft["message"]["code"], "lines", "{draft}");
}

/// A body added to the job is in the draft at once; a plan reports the minimum distance along its passes.
#[tokio::test(flavor = "multi_thread")]
async fn clearance_is_told_along_the_passes() {
    let (bench, owner) = Bench::with_owner().await;
    let text = example(&bench, &owner, "saddle.toml").await;
    let plan = |text: String| owner.request("POST", "/api/plan", Some(&json!({ "text": text })));
    let (_, answer) = bench.ask(plan(text.clone())).await;
    let pass = &answer["work"]["passes"][0];
    let near = &pass["nearest"];
    let least = pass["path"].as_array().unwrap().iter().filter_map(|p| p["clearance_mm"].as_f64());
    let least = least.fold(f64::INFINITY, f64::min);
    assert!((near["distance_mm"].as_f64().unwrap() - least).abs() < 0.3, "{near} {least}");
    let (a, b) = (numbers(&near["at"][0]), numbers(&near["at"][1]));
    let apart = a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    assert!((apart - near["distance_mm"].as_f64().unwrap()).abs() < 0.3, "{near}");
    let ball = format!(
        "{text}\n[[fixtures]]\nname = \"ball\"\nshape.sphere = {{ radius_mm = 5 }}\nat = {{ move_mm = [0, 0, 5000] }}\n"
    );
    let (_, draft) = bench.ask(owner.request("POST", "/api/draft", Some(&json!({ "text": ball })))).await;
    assert_eq!(draft["fixtures"][0]["name"], "ball");
    assert_eq!(draft["fixtures"][0]["frame"][11], 5000.0);
}

/// A collision of a job for another machine than the cell's: the answer contains machine, axes and the colliding pair.
#[tokio::test(flavor = "multi_thread")]
async fn a_collision_of_a_job_for_another_machine_can_be_seen() {
    let (bench, owner) = Bench::with_owner().await;
    let text = example(&bench, &owner, "saddle.toml").await;
    let plan = async |text: &str| {
        let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": text })))).await;
        answer["work"].clone()
    };
    let place = plan(&text).await["passes"][0]["path"][200].clone();
    let (tip, torch) = (numbers(&place["tip"]), numbers(&place["torch"]));
    // Inside the torch, 60 mm above its tip.
    let at: Vec<f64> = tip.iter().zip(&torch).map(|(tip, out)| tip + 60.0 * out).collect();
    let ball = format!(
        "{text}\n[[fixtures]]\nname = \"ball\"\nshape.sphere = {{ radius_mm = 12 }}\nat = {{ move_mm = {at:?} }}\n"
    );
    let work = plan(&ball).await;
    assert_eq!(work["good"], false);
    let findings = work["findings"].as_array().unwrap();
    let hit =
        findings.iter().find(|f| f["kind"] == "clearance" && f["message"]["text"].as_str().unwrap().contains("ball"));
    let hit = hit.unwrap_or_else(|| panic!("{findings:?}"));
    let near = &hit["nearest"];
    assert!(near["between"].as_array().unwrap().contains(&json!("ball")), "{hit}");
    assert!(near["distance_mm"].as_f64().unwrap() < near["least_mm"].as_f64().unwrap(), "{hit}");
    let machine = |name: &str| owner.request("GET", &format!("/api/machine/of-job?name={name}"), None);
    let (status, machine_view) = bench.ask(machine(work["machine"].as_str().unwrap())).await;
    assert_eq!(status, StatusCode::OK, "{machine_view}");
    assert_eq!(machine_view["name"], work["machine"]);
    assert_eq!(machine_view["axes"].as_array().unwrap().len(), numbers(&hit["axes"]).len());
    let solids = machine_view["solids"].as_array().unwrap();
    let other = near["between"].as_array().unwrap().iter().find(|name| **name != "ball").unwrap();
    assert!(solids.iter().any(|solid| solid["name"] == *other), "{other}");
    assert_eq!(bench.ask(machine("nothing-like-it")).await.0, StatusCode::NOT_FOUND);
    assert_ne!(bench.ask(machine("../../secret.toml")).await.0, StatusCode::OK);
}

/// A plan has the axes of its own machine, and a value for each in every sample: the cell has another machine.
#[tokio::test(flavor = "multi_thread")]
async fn a_plan_names_the_axes_of_its_machine() {
    let (bench, owner) = Bench::with_owner().await;
    for (job, axes) in [("saddle", "theta deg s mm h mm beta deg"), ("ellipse", "x mm y mm")] {
        let text = example(&bench, &owner, &format!("{job}.toml")).await;
        let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": text })))).await;
        let work = &answer["work"];
        let view = work["axes"].as_array().unwrap();
        let said = |axis: &Value| ["name", "unit"].map(|key| axis[key].as_str().unwrap().to_owned()).join(" ");
        assert_eq!(view.iter().map(said).collect::<Vec<_>>().join(" "), axes);
        assert_eq!(work["passes"][0]["path"][0]["axes"].as_array().unwrap().len(), view.len());
    }
}

/// A plan's certificate: intervals without gaps. Utilisation in the samples stays below the certificate's maximum and
/// comes close to it.
#[tokio::test(flavor = "multi_thread")]
async fn a_plan_says_what_bounds_it() {
    let (bench, owner) = Bench::with_owner().await;
    let text = example(&bench, &owner, "ellipse.toml").await;
    let fast = text.replacen("speed_mm_s = 5", "speed_mm_s = 200\non_limit = \"slow\"", 1);
    assert_ne!(fast, text);
    let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": fast })))).await;
    let pass = &answer["work"]["passes"][0];
    let certificate = &pass["certificate"];
    let bounds = certificate["bounds"].as_array().unwrap();
    let end = |bound: &Value, key: &str| bound[key].as_f64().unwrap();
    assert!(end(&bounds[0], "from_mm").abs() < 1e-9);
    assert!(bounds.windows(2).all(|pair| pair[0]["to_mm"] == pair[1]["from_mm"]));
    assert!((end(bounds.last().unwrap(), "to_mm") - pass["length_mm"].as_f64().unwrap()).abs() < 1e-6);
    assert!(bounds.iter().any(|bound| bound["what"] == "acceleration" && bound["axis"] == "x"), "{bounds:?}");
    let path = pass["path"].as_array().unwrap();
    for (i, axis) in ["x", "y"].into_iter().enumerate() {
        let told = &certificate["uses"][i];
        assert_eq!(told["axis"], axis);
        for (k, told) in numbers(&told["percent"]).into_iter().enumerate() {
            let most = path.iter().map(|p| p["used"][i][k].as_f64().unwrap()).fold(0.0, f64::max);
            // Values are whole per cent, and samples do not hit the exact maxima.
            assert!(most <= told + 0.5 && most > 0.6 * told - 1.0, "{axis} {k}: {most} of {told}");
        }
    }
}

/// Without a motion, passes are drawn as the job requests them, at the same positions as with a motion.
#[tokio::test(flavor = "multi_thread")]
async fn what_cannot_be_welded_is_drawn() {
    let (bench, owner) = Bench::with_owner().await;
    for name in ["first-weld.toml", "points.toml", "radiator.toml", "spline.toml"] {
        let text = example(&bench, &owner, name).await;
        let speed = text.lines().find(|line| line.starts_with("speed_mm_s = "));
        // In a table of points the speed is the last number.
        let fast =
            speed.map_or_else(|| text.replace(", 8]", ", 4000]"), |line| text.replace(line, "speed_mm_s = 4000"));
        let mut works = Vec::new();
        for text in [text, fast] {
            let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": text })))).await;
            assert_eq!(answer["kind"], "planned", "{name}: {answer}");
            works.push(answer["work"].clone());
        }
        let [good, fast] = &works[..] else { panic!("two") };
        assert_eq!((&good["good"], &fast["good"]), (&json!(true), &json!(false)), "{name}");
        assert!(!fast["findings"].as_array().unwrap().is_empty() && fast["time_s"] == 0.0);
        let passes = [good, fast].map(|work| work["passes"].as_array().unwrap().clone());
        assert_eq!(passes[0].len(), passes[1].len());
        for (planned, asked) in passes[0].iter().zip(&passes[1]) {
            assert!(asked["certificate"].is_null() && planned["certificate"].is_object());
            for key in ["name", "role", "closed"] {
                assert_eq!(planned[key], asked[key], "{name}: {key}");
            }
            let ends = |pass: &Value| pass["spans"].as_array().unwrap().iter().flat_map(numbers).collect::<Vec<_>>();
            for [a, b] in [[ends(planned), ends(asked)], [numbers(&planned["points_mm"]), numbers(&asked["points_mm"])]]
            {
                assert!(
                    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-9),
                    "{name}: {a:?} {b:?}"
                );
            }
            let paths = [planned, asked].map(|pass| pass["path"].as_array().unwrap().clone());
            assert_eq!(paths[0].len(), paths[1].len());
            for (a, b) in paths[0].iter().zip(&paths[1]) {
                assert!(b["axes"].as_array().unwrap().is_empty() && b["used"].as_array().unwrap().is_empty());
                let far = numbers(&a["tip"]).into_iter().zip(numbers(&b["tip"])).map(|(a, b)| (a - b).abs());
                let far = far.fold(0.0, f64::max);
                assert!(far < 0.01, "{name}: {far} mm at {}", a["s_mm"]);
                assert!((b["speed_mm_s"].as_f64().unwrap() - 4000.0).abs() < 0.01, "{name}: {b}");
                let values = [a, b].map(|point| numbers(&point["values"]));
                assert!(values[0].iter().zip(&values[1]).all(|(a, b)| (a - b).abs() < 1e-3), "{name}: {values:?}");
            }
        }
    }
}

/// A job can name shipped machines and procedures, and own files, which are then not listed as jobs.
#[tokio::test(flavor = "multi_thread")]
async fn a_job_can_name_what_ships_and_what_is_kept() {
    let (bench, owner) = Bench::with_owner().await;
    let (_, choices) = bench.ask(owner.request("GET", "/api/choices", None)).await;
    let of = |choices: &Value, kind: &str| choices[kind].as_array().unwrap().clone();
    assert!(of(&choices, "machines").iter().any(|m| m["name"] == "saddle-4axis" && m["own"] == false));
    let procedure = of(&choices, "procedures")[0].clone();
    let text = procedure["text"].as_str().unwrap().replacen("title = \"", "title = \"My ", 1);
    let put = owner.request("PUT", "/api/jobs/wps.toml", Some(&json!({ "text": text })));
    assert_eq!(bench.ask(put).await.0, StatusCode::OK);
    let (_, choices) = bench.ask(owner.request("GET", "/api/choices", None)).await;
    let own = of(&choices, "procedures").into_iter().find(|p| p["own"] == true).unwrap();
    assert_eq!((&own["name"], &own["text"]), (&json!("wps.toml"), &json!(text)));
    assert!(own["title"].as_str().unwrap().starts_with("My "));
    let (_, jobs) = bench.ask(owner.request("GET", "/api/jobs", None)).await;
    assert!(jobs.as_array().unwrap().iter().all(|job| job["name"] != "wps.toml"));
    // A job that names it is planned with it.
    let job = example(&bench, &owner, "first-weld.toml").await.replace("\"135-saddle\"", "\"wps.toml\"");
    let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": job })))).await;
    assert_eq!(answer["work"]["good"], true, "{answer}");
}

/// Spans match the file: one along a seam, one for each run of points, without gaps.
#[tokio::test(flavor = "multi_thread")]
async fn a_plan_has_its_spans() {
    let (bench, owner) = Bench::with_owner().await;
    for (job, count) in [("points", 3), ("first-weld", 1)] {
        let text = example(&bench, &owner, &format!("{job}.toml")).await;
        let (_, answer) = bench.ask(owner.request("POST", "/api/plan", Some(&json!({ "text": text })))).await;
        let pass = &answer["work"]["passes"][0];
        let spans: Vec<Vec<f64>> = pass["spans"].as_array().unwrap().iter().map(numbers).collect();
        assert_eq!((spans.len(), spans[0][0]), (count, 0.0), "{job}");
        assert!(spans.windows(2).all(|pair| (pair[0][1] - pair[1][0]).abs() < 1e-9), "{spans:?}");
        assert!((spans[count - 1][1] - pass["length_mm"].as_f64().unwrap()).abs() < 1e-6, "{spans:?}");
        if job == "points" {
            let points = numbers(&pass["points_mm"]);
            assert_eq!(points.len(), 8);
            assert!(points.windows(2).all(|pair| pair[0] < pair[1]) && (points[1] - 40.0).abs() < 0.1, "{points:?}");
            // Two lines of 40 mm (corner blends shorten them slightly), a quarter of a circle of 30 mm radius.
            assert!((spans[0][1] - 80.0).abs() < 0.1, "{spans:?}");
            assert!((spans[1][1] - spans[0][1] - 15.0 * std::f64::consts::PI).abs() < 0.1, "{spans:?}");
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn simulated_inputs_and_outputs_have_names_and_values() {
    let (bench, owner) = Bench::with_owner().await;
    while bench.panel.cell.hub.latest().is_none() {
        tokio::time::sleep(std::time::Duration::from_millis(10)).await;
    }
    let (status, devices) = bench.ask(owner.request("GET", "/api/devices", None)).await;
    assert_eq!(status, StatusCode::OK);
    let signals = devices[0]["signals"].as_array().unwrap();
    let of = |name: &str| signals.iter().find(|s| s["name"] == name).unwrap_or_else(|| panic!("{name}: {devices}"));
    assert_eq!((&of("outputs.on")["value"], &of("outputs.on")["safe"]), (&json!(0.0), &json!(0.0)));
    for input in signals.iter().filter(|s| s["kind"] == "input") {
        let on = input["value"].as_f64().unwrap() > 0.5;
        assert_eq!(json!(on), input["wanted"], "{input}");
    }
}

/// Points of the example, touched on a part moved by a known offset.
#[tokio::test(flavor = "multi_thread")]
async fn touched_points_tell_where_the_part_stands() {
    let (bench, owner) = Bench::with_owner().await;
    let text = example(&bench, &owner, "saddle.toml").await;
    let table = include_str!("../../../../examples/saddle-touched.csv");
    let header: Vec<&str> = table.lines().next().unwrap().split(',').map(str::trim).collect();
    let column = |name: &str| header.iter().position(|h| *h == name).unwrap();
    let points: Vec<Value> = (table.lines().skip(1))
        .map(|line| {
            let fields: Vec<&str> = line.split(',').map(str::trim).collect();
            let tip: Vec<f64> = ["x_mm", "y_mm", "z_mm"].map(|c| fields[column(c)].parse().unwrap()).to_vec();
            json!({ "feature": fields[column("feature")], "tip": tip })
        })
        .collect();
    let ask = |points: &[Value]| {
        let body = json!({ "text": text, "method": "best_fit", "probe_radius_mm": 0, "points": points });
        owner.request("POST", "/api/place", Some(&body))
    };
    let (status, answer) = bench.ask(ask(&points)).await;
    assert_eq!(status, StatusCode::OK, "{answer}");
    // Values from docs/reference/job.md for these points.
    for (found, moved) in numbers(&answer["move_mm"]).iter().zip([1.5, -0.8, 0.6]) {
        assert!((found - moved).abs() < 0.2, "{answer}");
    }
    assert!((answer["angle_deg"].as_f64().unwrap().abs() - 0.4).abs() < 0.05, "{answer}");
    assert!(answer["rms_mm"].as_f64().unwrap() < 0.05 && answer["residuals_mm"].as_array().unwrap().len() == 24);
    assert!(answer["text"].as_str().unwrap().contains("offset = \"touched\""));
    for wrong in
        [json!([]), json!([{ "feature": "lid", "tip": [0, 0, 0] }]), json!([{ "feature": "body", "tip": [1e9, 0, 0] }])]
    {
        let (status, answer) = bench.ask(ask(wrong.as_array().unwrap())).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{answer}");
        let text = answer["text"].as_str().unwrap();
        assert!(text.contains("allowed") || text.contains("use more points"), "{answer}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn marks_and_a_chuck_tell_where_the_part_stands() {
    let (bench, owner) = Bench::with_owner().await;
    let text = example(&bench, &owner, "saddle.toml").await;
    let touched = |list: &[(&str, [f64; 3])]| {
        list.iter().map(|(feature, tip)| json!({ "feature": feature, "tip": tip })).collect::<Vec<_>>()
    };
    let ask = |method: &str, points: Vec<Value>| {
        let body = json!({ "text": text, "method": method, "probe_radius_mm": 1.0, "points": points });
        owner.request("POST", "/api/place", Some(&body))
    };
    // A plane at z = 20 under a ball of 1 mm; x along the work's y.
    let plane = [("plane", [0.0, 0.0, 21.0]), ("plane", [100.0, 0.0, 21.0]), ("plane", [0.0, 100.0, 21.0])];
    let marks = [&plane[..], &[("origin", [10.0, 5.0, 21.5]), ("direction", [10.0, 80.0, 21.0])]].concat();
    let (status, answer) = bench.ask(ask("three_points", touched(&marks))).await;
    assert_eq!(status, StatusCode::OK, "{answer}");
    for (found, moved) in numbers(&answer["move_mm"]).iter().zip([10.0, 5.0, 20.0]) {
        assert!((found - moved).abs() < 1e-6, "{answer}");
    }
    assert!((answer["angle_deg"].as_f64().unwrap().abs() - 90.0).abs() < 1e-6, "{answer}");
    // The residual reveals the mark that was touched too high.
    assert!((numbers(&answer["residuals_mm"])[3] - 0.5).abs() < 1e-9, "{answer}");
    let round = [("round", [57.0, -3.0, 4.0]), ("round", [6.0, 48.0, 5.0]), ("round", [-45.0, -3.0, 6.0])];
    let face = plane.map(|(_, tip)| ("face", tip));
    let (status, answer) = bench.ask(ask("chuck", touched(&[&face[..], &round[..]].concat()))).await;
    assert_eq!(status, StatusCode::OK, "{answer}");
    for (found, moved) in numbers(&answer["move_mm"]).iter().zip([6.0, -3.0, 20.0]) {
        assert!((found - moved).abs() < 1e-6, "{answer}");
    }
    assert!(answer["notes"].to_string().contains("100.000 mm"), "{answer}");
    for (method, points) in [
        ("three_points", touched(&marks[..4])),
        ("chuck", touched(&face)),
        ("chuck", touched(&[&face[..], &[round[0], round[0], round[0]]].concat())),
        ("chuck", touched(&marks)),
    ] {
        let (status, answer) = bench.ask(ask(method, points)).await;
        assert_eq!(status, StatusCode::UNPROCESSABLE_ENTITY, "{answer}");
        let text = answer["text"].as_str().unwrap();
        assert!(text.contains("allowed") || text.contains("use more points"), "{answer}");
    }
}
