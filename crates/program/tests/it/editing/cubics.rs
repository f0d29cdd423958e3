//! Cubics with speeds of their own: where they go, and how fast, after an edit.

use glam::DVec3;
use seamwright_document::Finite;
use seamwright_program::edit::{Editor, Operation};
use seamwright_program::{Along, Points};
use seamwright_testkit::{Random, cases};
use serde_json::{Value, json};

fn apply(editor: &mut Editor, operation: Value) {
    try_apply(editor, operation).unwrap_or_else(|e| panic!("{e}"));
}

fn try_apply(editor: &mut Editor, operation: Value) -> Result<(), String> {
    let operation: Operation = serde_json::from_value(operation).unwrap();
    editor.apply(&operation).map(drop).map_err(|e| e.to_string())
}

fn points(editor: &Editor) -> Points {
    editor.program().passes[0].points.clone().unwrap()
}

fn plain(row: &[Finite]) -> Vec<f64> {
    row.iter().map(|n| n.get()).collect()
}

/// A pass of one cubic through random points, with the text `more` behind it.
fn random_cubic(random: &mut Random, count: usize, more: &str) -> String {
    let mut row = |low: f64, high: f64, n: usize| -> Vec<String> {
        (0..n).map(|_| format!("{:?}", random.within(low, high))).collect()
    };
    let speeds: Vec<String> = (0..=count).map(|_| format!("[{}]", row(-20.0, 20.0, 3).join(", "))).collect();
    let rows = (0..count).map(|_| format!("[{}, {}]", row(-50.0, 50.0, 3).join(", "), row(0.2, 4.0, 1)[0]));
    let rows: Vec<String> = rows.collect();
    format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"p\"\n[passes.points]\n\
        columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"time_s\"]\nstart = [1, 2, 3, 0]\n[[passes.points.spans]]\n\
        along = \"cubic\"\nspeeds = [{}]\npoints = [{}]\n{more}",
        speeds.join(", "),
        rows.join(", ")
    )
}

/// Position and speed of a pass of cubics after `t` seconds: Bernstein's form, not the one that edits use.
fn at(points: &Points, t: f64) -> (DVec3, DVec3) {
    let vector = |row: &[Finite]| DVec3::from_slice(&plain(row)[..3]);
    let (mut here, mut begin) = (vector(&points.start), 0.0);
    let all: usize = points.count();
    let mut done = 0;
    for span in &points.spans {
        assert_eq!(span.along, Along::Cubic);
        for (k, row) in span.points.iter().enumerate() {
            let seconds = plain(row)[row.len() - 1];
            let there = vector(row);
            done += 1;
            if t <= begin + seconds || done == all {
                let u = (t - begin) / seconds;
                let controls = [
                    here,
                    here + vector(&span.speeds[k]) * seconds / 3.0,
                    there - vector(&span.speeds[k + 1]) * seconds / 3.0,
                    there,
                ];
                let step = |c: &[DVec3]| -> Vec<DVec3> { c.windows(2).map(|p| p[0].lerp(p[1], u)).collect() };
                let lines = step(&controls);
                let ends = step(&lines);
                return (step(&ends)[0], (ends[1] - ends[0]) * 3.0 / seconds);
            }
            (here, begin) = (there, begin + seconds);
        }
    }
    unreachable!("the last cubic goes to the end")
}

fn seconds(points: &Points) -> f64 {
    points.spans.iter().flat_map(|span| &span.points).map(|row| plain(row)[3]).sum()
}

/// Positions and speeds at 50 times are those of `wanted`, given the time as a part of the whole.
fn check(points: &Points, wanted: impl Fn(f64) -> (DVec3, DVec3), what: &str) {
    for k in 0..50 {
        let part = (f64::from(k) + 0.37) / 50.0;
        let (a, b) = (at(points, part * seconds(points)), wanted(part));
        assert!((a.0 - b.0).length() < 1e-9 && (a.1 - b.1).length() < 1e-8, "{what} at {part}: {a:?} {b:?}");
    }
}

#[test]
fn halfway_turned_mirrored_and_scaled_cubics_go_where_they_went() {
    for seed in 0..cases(300) {
        let mut random = Random::of_case(80_000 + seed);
        let count = 1 + random.below(6);
        let text = random_cubic(&mut random, count, "");
        let before = points(&Editor::new("p.toml", &text).unwrap());
        let all = seconds(&before);
        let edited = |operations: &[Value]| {
            let mut editor = Editor::new("p.toml", &text).unwrap();
            operations.iter().for_each(|operation| apply(&mut editor, operation.clone()));
            points(&editor)
        };
        let same = |part: f64| at(&before, part * all);
        let after = random.below(count);
        let halved = edited(&[json!({"op": "insert_point", "pass": 1, "after": after})]);
        assert_eq!(halved.count(), count + 1);
        check(&halved, same, "halfway");
        let turned = edited(&[json!({"op": "reverse_pass", "pass": 1})]);
        check(&turned, |part| (same(1.0 - part).0, -same(1.0 - part).1), "turned");
        let plane = json!({"op": "mirror", "pass": 1, "at_mm": [1, 2, 3], "normal": [0.6, 0, 0.8]});
        let normal = DVec3::new(0.6, 0.0, 0.8);
        let (from, turn) = (DVec3::new(1.0, 2.0, 3.0), |v: DVec3| v - 2.0 * v.dot(normal) * normal);
        let mirrored = edited(&[plane]);
        check(&mirrored, |part| (from + turn(same(part).0 - from), turn(same(part).1)), "mirrored");
        let fast = edited(&[json!({"op": "scale_speed", "pass": 1, "factor": 2.5})]);
        assert!((seconds(&fast) - all / 2.5).abs() < 1e-9);
        check(&fast, |part| (same(part).0, 2.5 * same(part).1), "scaled");
        if count > 1 {
            let split = edited(&[
                json!({"op": "split_span", "pass": 1, "point": 1}),
                json!({"op": "delete_points", "pass": 1, "from": 1}),
            ]);
            assert_eq!(split.spans.len(), 1);
            assert_eq!(split.spans[0].speeds, before.spans[0].speeds[1..]);
        }
    }
}

#[test]
fn a_part_that_is_faster_keeps_its_way() {
    for seed in 0..cases(200) {
        let mut random = Random::of_case(81_000 + seed);
        let text = random_cubic(&mut random, 5, "");
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = points(&editor);
        let (a, b) = (1 + random.below(5), 1 + random.below(5));
        let range = [a.min(b), a.max(b)];
        apply(&mut editor, json!({"op": "scale_speed", "pass": 1, "points": range, "factor": 3}));
        let after = points(&editor);
        let times = |points: &Points| -> Vec<f64> {
            let each = points.spans.iter().flat_map(|span| &span.points).map(|row| plain(row)[3]);
            std::iter::once(0.0)
                .chain(each.scan(0.0, |t, dt| {
                    *t += dt;
                    Some(*t)
                }))
                .collect()
        };
        let (old, new) = (times(&before), times(&after));
        for way in 1..=5 {
            let factor = if (range[0]..=range[1]).contains(&way) { 3.0 } else { 1.0 };
            for u in [0.13, 0.5, 0.91] {
                let time = |at: &[f64]| at[way - 1] + u * (at[way] - at[way - 1]);
                let (p, q) = (at(&before, time(&old)), at(&after, time(&new)));
                assert!((p.0 - q.0).length() < 1e-9 && (p.1 * factor - q.1).length() < 1e-8, "seed {seed} way {way}");
            }
        }
        // Slower again, the parts go on into each other, and are one.
        apply(&mut editor, json!({"op": "scale_speed", "pass": 1, "points": range, "factor": 1.0 / 3.0}));
        while points(&editor).spans.len() > 1 {
            apply(&mut editor, json!({"op": "join_spans", "pass": 1, "span": 1}));
        }
        check(&points(&editor), |part| at(&before, part * old[5]), "back");
    }
}

#[test]
fn parts_with_other_speeds_are_not_joined() {
    let mut editor = Editor::new("p.toml", &random_cubic(&mut Random::new(5), 4, "")).unwrap();
    apply(&mut editor, json!({"op": "scale_speed", "pass": 1, "points": [3, 4], "factor": 2}));
    let told = try_apply(&mut editor, json!({"op": "join_spans", "pass": 1, "span": 1})).unwrap_err();
    assert!(told.contains("cubics with the same speeds"), "{told}");
    // Speeds that are set at the point between are those of both.
    apply(&mut editor, json!({"op": "set_point", "pass": 1, "point": 2, "speeds": {"x_mm": 1, "y_mm": 2, "z_mm": 3}}));
    apply(&mut editor, json!({"op": "join_spans", "pass": 1, "span": 1}));
    assert_eq!(plain(&points(&editor).spans[0].speeds[2]), [1.0, 2.0, 3.0]);
}

/// A circle of 60 mm at 20 mm/s, 40 points, as cubics with its own speeds.
fn circle() -> (String, f64) {
    let (radius, speed, n) = (60.0, 20.0, 40);
    let seconds = std::f64::consts::TAU * radius / speed / f64::from(n);
    let angle = |k: i32| f64::from(k) * std::f64::consts::TAU / f64::from(n);
    let place = |k: i32| format!("{:?}, {:?}, 0", radius * angle(k).cos(), radius * angle(k).sin());
    let speeds = |k: i32| format!("[{:?}, {:?}, 0]", -speed * angle(k).sin(), speed * angle(k).cos());
    let rows: Vec<String> = (1..=n).map(|k| format!("[{}, {seconds:?}]", place(k))).collect();
    let all: Vec<String> = (0..=n).map(speeds).collect();
    let text = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"p\"\n[passes.points]\n\
        columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"time_s\"]\nstart = [{}, 0]\n[[passes.points.spans]]\n\
        along = \"cubic\"\nspeeds = [{}]\npoints = [{}]\n",
        place(0),
        all.join(", "),
        rows.join(", ")
    );
    (text, seconds * f64::from(n))
}

#[test]
fn speeds_follow_points_that_an_offset_moves() {
    let (text, all) = circle();
    let mut editor = Editor::new("p.toml", &text).unwrap();
    // Counter-clockwise with the torch pointing down: across is out of the circle.
    apply(&mut editor, json!({"op": "offset", "pass": 1, "dy_mm": 6, "dz_mm": -2}));
    let moved = points(&editor);
    for k in 0..400 {
        let (place, speed) = at(&moved, all * f64::from(k) / 400.0);
        // With the old speeds it would stray by 2e-2 mm and 2 mm/s.
        assert!((place.truncate().length() - 66.0).abs() < 2e-3 && (place.z - 2.0).abs() < 1e-9, "{k}: {place}");
        assert!((speed.length() - 22.0).abs() < 0.1, "{k}: {speed}");
    }
}

#[test]
fn a_point_on_the_way_leaves_a_circle_round() {
    let (text, all) = circle();
    let mut editor = Editor::new("p.toml", &text).unwrap();
    let angle = 10.5 * std::f64::consts::TAU / 40.0;
    let half = all / 80.0;
    apply(&mut editor, json!({"op": "set_point", "pass": 1, "point": 11, "set": {"time_s": half}}));
    let place = [60.0 * f64::cos(angle), 60.0 * f64::sin(angle), 0.0];
    let numbers = [place[0], place[1], place[2], half];
    apply(&mut editor, json!({"op": "insert_point", "pass": 1, "after": 10, "numbers": numbers}));
    for k in 0..400 {
        let (place, speed) = at(&points(&editor), all * f64::from(k) / 400.0);
        assert!((place.length() - 60.0).abs() < 2e-3 && (speed.length() - 20.0).abs() < 0.1, "{k}: {place} {speed}");
    }
}

#[test]
fn a_spline_that_becomes_a_cubic_goes_the_same_way() {
    for seed in 0..cases(100) {
        let mut random = Random::of_case(82_000 + seed);
        let count = 2 + random.below(8);
        let text = random_cubic(&mut random, count, "");
        let mut editor = Editor::new("p.toml", &text).unwrap();
        apply(&mut editor, json!({"op": "interpolate", "pass": 1, "span": 1, "along": "spline"}));
        assert!(points(&editor).spans[0].speeds.is_empty());
        apply(&mut editor, json!({"op": "interpolate", "pass": 1, "span": 1, "along": "cubic"}));
        let cubic = points(&editor);
        // The natural spline by time: acceleration is continuous at all points, and zero at the ends.
        let mut t = 0.0;
        for row in cubic.spans[0].points.iter().take(count - 1) {
            t += plain(row)[3];
            let h = 1e-5;
            let second = |t: f64| (at(&cubic, t + h).1 - at(&cubic, t - h).1) / (2.0 * h);
            let (a, b) = (second(t - 2.0 * h), second(t + 2.0 * h));
            assert!((a - b).length() < 0.05 * (1.0 + a.length()), "seed {seed}: {a} {b}");
        }
        let start = (at(&cubic, 1e-4).1 - at(&cubic, 0.0).1) / 1e-4;
        assert!(start.length() < 0.2, "seed {seed}: {start}");
    }
    // At a stop all speeds are 0.
    let text =
        random_cubic(&mut Random::new(3), 4, "").replace("along = \"cubic\"\n", "along = \"cubic\"\nstops = true\n");
    let mut editor = Editor::new("p.toml", &text).unwrap();
    apply(&mut editor, json!({"op": "interpolate", "pass": 1, "span": 1, "along": "cubic"}));
    assert!(points(&editor).spans[0].speeds.iter().flatten().all(|speed| speed.get() == 0.0));
}

#[test]
fn speeds_keep_their_lines_and_what_is_said_of_them() {
    let text = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[variables]\nv = 4\n[[passes]]\nname = \"p\"\n[passes.points]\n\
        columns = [\"x\", \"b\", \"time_s\"]\nstart = [0, 0, 0]\n[[passes.points.spans]]\nalong = \"cubic\"\n\
        speeds = [\n    [0, 0], # from rest\n    [\"= v\", 1],\n    [0, 0], # to rest\n]\n\
        points = [\n    [2, 1, 1],\n    [4, 2, 1],\n]\n";
    let mut editor = Editor::new("p.toml", text).unwrap();
    apply(&mut editor, json!({"op": "insert_point", "pass": 1, "after": 1}));
    let wanted = text
        .replace("    [\"= v\", 1],\n", "    [\"= v\", 1],\n    [2, 1.25],\n")
        .replace("    [4, 2, 1],\n", "    [3.5, 1.625, 0.5],\n    [4, 2, 0.5],\n");
    assert_eq!(editor.text(), wanted);
    apply(&mut editor, json!({"op": "set_point", "pass": 1, "point": 3, "speeds": {"b": 0.5}}));
    assert!(editor.text().contains("    [0, 0.5], # to rest\n"), "{}", editor.text());
    apply(&mut editor, json!({"op": "interpolate", "pass": 1, "span": 1, "along": "line"}));
    assert!(!editor.text().contains("speeds"), "{}", editor.text());
}
