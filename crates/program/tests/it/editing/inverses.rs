//! Edits and their inverses give the same program; parts outside the edit stay.

use super::random::program;
use seamwright_program::edit::{Editor, Operation};
use seamwright_program::{ArcTime, Pass, PointEvent, Points, Program};
use seamwright_testkit::{Random, cases};
use serde_json::{Value, json};

/// Whether two programs are equal to rounding, by their JSON.
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
            (a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs()))
        }
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
        }
        _ => a == b,
    }
}

fn value(program: &Program) -> Value {
    serde_json::to_value(program).unwrap()
}

fn apply(editor: &mut Editor, operation: Value) -> Result<(), String> {
    let operation: Operation = serde_json::from_value(operation).unwrap();
    editor.apply(&operation).map(drop).map_err(|e| e.to_string())
}

/// State of an output over each way; it is off until it is switched.
fn states(points: &Points, switch: &dyn Fn(&PointEvent) -> Option<bool>) -> Vec<bool> {
    let mut events: Vec<&PointEvent> = points.events.iter().collect();
    events.sort_by_key(|event| event.after);
    let at = |way: usize| events.iter().rev().find(|e| e.after <= way && switch(e).is_some()).and_then(|e| switch(e));
    (0..points.count()).map(|way| at(way) == Some(true)).collect()
}

fn all_states(pass: &Pass) -> Vec<Vec<bool>> {
    let points = pass.points.as_ref().unwrap();
    let output = |n: u16| move |e: &PointEvent| e.on.filter(|_| e.output == Some(n));
    vec![
        states(points, &|e| e.gas),
        states(points, &|e| e.wire),
        states(points, &output(1)),
        states(points, &output(2)),
    ]
}

fn without_events(program: &Program) -> Value {
    let mut program = program.clone();
    program.passes.iter_mut().filter_map(|pass| pass.points.as_mut()).for_each(|points| points.events.clear());
    value(&program)
}

#[test]
fn turned_twice_is_the_same() {
    let mut done = [0, 0];
    for seed in 0..cases(400) {
        let (text, _) = program(&mut Random::of_case(30_000 + seed));
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = editor.program().clone();
        for (i, pass) in before.passes.iter().enumerate() {
            let length = if pass.points.is_none() { json!(1600) } else { Value::Null };
            let turn = json!({"op": "reverse_pass", "pass": i + 1, "seam_length_mm": length});
            apply(&mut editor, turn.clone()).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
            let once = editor.program().passes[i].clone();
            if let (Some(old), Some(new)) = (&pass.points, &once.points) {
                check_turned(old, new);
                let mut wanted = all_states(pass);
                wanted.iter_mut().for_each(|states| states.reverse());
                assert_eq!(all_states(&once), wanted, "seed {seed}");
            } else {
                check_seam_turned(pass, &once);
            }
            apply(&mut editor, turn).unwrap();
            if pass.points.is_some() {
                assert_eq!(all_states(&editor.program().passes[i]), all_states(pass), "seed {seed}");
            }
            done[usize::from(pass.points.is_some())] += 1;
        }
        assert!(same(&without_events(editor.program()), &without_events(&before)), "seed {seed}\n{text}");
    }
    assert!(done.iter().all(|n| *n > 150), "{done:?}");
}

/// Every way the other way round: its ends, its time or speed, its number.
fn check_turned(old: &Points, new: &Points) {
    let rows =
        |points: &Points| -> Vec<Vec<f64>> { points.rows().map(|row| row.iter().map(|v| v.get()).collect()).collect() };
    let (old_rows, new_rows, n) = (rows(old), rows(new), old.count());
    for (c, name) in old.columns.iter().enumerate() {
        let of_way = old.stepped.contains(name) || ["n", "time_s", "speed_mm_s"].contains(&name.as_str());
        for (i, new_row) in new_rows.iter().enumerate() {
            let wanted = match (of_way, i) {
                (true, 0) => old_rows[0][c],
                (true, i) => old_rows[n + 1 - i][c],
                (false, i) => old_rows[n - i][c],
            };
            assert!((new_row[c] - wanted).abs() < 1e-12, "{name} {i}");
        }
    }
    assert!(new.spans.iter().rev().map(|s| (s.along, s.via_mm)).eq(old.spans.iter().map(|s| (s.along, s.via_mm))));
}

/// Speed and current are unchanged at every position of the seam.
fn check_seam_turned(old: &Pass, new: &Pass) {
    let length = old.length();
    assert!(new.reverse != old.reverse && (new.length() - length).abs() < 1e-9);
    for k in 0..50 {
        let s = length * (f64::from(k) + 0.513) / 50.0;
        assert!((new.speed_at(length - s) - old.speed_at(s)).abs() < 1e-6);
        let current = |pass: &Pass, s: f64| pass.process_at("current_a", s, ArcTime::TRAVEL).unwrap();
        assert!((current(new, length - s) - current(old, s)).abs() < 1e-5);
        let seam = |pass: &Pass, s: f64| pass.seam_s(s).rem_euclid(1600.0);
        let off = (seam(new, length - s) - seam(old, s)).abs();
        assert!(off.min(1600.0 - off) < 1e-6);
    }
}

#[test]
fn mirrored_twice_and_scaled_back_is_the_same() {
    let mut mirrored = 0;
    for seed in 0..cases(400) {
        let mut random = Random::of_case(40_000 + seed);
        let (text, _) = program(&mut random);
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = value(editor.program());
        for (i, pass) in editor.program().passes.clone().iter().enumerate() {
            let Some(points) = &pass.points else { continue };
            let poses = points.known_columns().pose > 0;
            let plane = json!({"op": "mirror", "pass": i + 1, "at_mm": [random.number(-50.0, 50.0), 2, 3],
                "normal": [random.number(-3.0, 3.0), 1, 0.5]});
            let axis = json!({"op": "mirror", "pass": i + 1, "axis": random.one(&["x", "z", "b"]), "about": random.number(-20.0, 20.0)});
            let mirror = if poses { plane } else { axis };
            apply(&mut editor, mirror.clone()).unwrap();
            if poses {
                check_mirrored(points, editor.program().passes[i].points.as_ref().unwrap(), &mirror);
            }
            apply(&mut editor, mirror).unwrap();
            mirrored += 1;
        }
        let factor = random.within(0.3, 3.0);
        apply(&mut editor, json!({"op": "scale_speed", "factor": factor})).unwrap();
        check_scaled(&serde_json::from_value(before.clone()).unwrap(), editor.program(), factor);
        apply(&mut editor, json!({"op": "scale_speed", "factor": 1.0 / factor})).unwrap();
        assert!(same(&value(editor.program()), &before), "seed {seed}\n{text}\n{}", editor.text());
    }
    assert!(mirrored > 250);
}

/// Halfway between a point and its image is the plane; the way between them is along the normal.
fn check_mirrored(old: &Points, new: &Points, plane: &Value) {
    let vector =
        |key: &str| -> glam::DVec3 { glam::DVec3::from_array([0, 1, 2].map(|i| plane[key][i].as_f64().unwrap())) };
    let (at, normal) = (vector("at_mm"), vector("normal").normalize());
    for (a, b) in old.rows().zip(new.rows()) {
        let place = |row: &[seamwright_document::Finite]| glam::DVec3::new(row[0].get(), row[1].get(), row[2].get());
        let (a, b) = (place(a), place(b));
        assert!(((a + b) / 2.0 - at).dot(normal).abs() < 1e-9 && (b - a).cross(normal).length() < 1e-9);
    }
}

fn check_scaled(old: &Program, new: &Program, factor: f64) {
    for (old, new) in old.passes.iter().zip(&new.passes) {
        match (&old.points, &new.points) {
            (Some(old), Some(new)) => {
                let timed = old.columns.last().unwrap() == "time_s";
                for (a, b) in old.rows().zip(new.rows()) {
                    let (a, b) = (a[a.len() - 1].get(), b[b.len() - 1].get());
                    let wanted = if timed { a / factor } else { a * factor };
                    assert!((b - wanted).abs() <= 1e-12 * wanted);
                }
            }
            _ => assert!((new.speed_at(1.0) - factor * old.speed_at(1.0)).abs() < 1e-9),
        }
    }
}

#[test]
fn split_and_joined_is_the_same() {
    let mut done = [0, 0];
    for seed in 0..cases(700) {
        let mut random = Random::of_case(50_000 + seed);
        let (text, _) = program(&mut random);
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = editor.program().clone();
        let i = random.below(before.passes.len());
        let pass = &before.passes[i];
        let split = match &pass.points {
            Some(points) => json!({"op": "split_span", "pass": i + 1, "point": random.below(points.count() + 1)}),
            None => json!({"op": "split_span", "pass": i + 1, "s_mm": random.within(0.0, pass.length())}),
        };
        if apply(&mut editor, split).is_err() {
            continue;
        }
        let now = editor.program().passes[i].clone();
        // The values are the same all along.
        for k in 0..40 {
            let s = pass.length() * f64::from(k) / 40.0;
            assert!(pass.points.is_some() || (now.speed_at(s) - pass.speed_at(s)).abs() < 1e-9);
        }
        let spans = |pass: &Pass| pass.points.as_ref().map_or(pass.spans.len(), |points| points.spans.len());
        assert_eq!(spans(&now), spans(pass) + 1);
        let differs = (0..spans(pass)).find(|k| match (&now.points, &pass.points) {
            (Some(now), Some(old)) => now.spans[*k] != old.spans[*k],
            _ => now.spans[*k] != pass.spans[*k],
        });
        let span = differs.unwrap() + 1;
        apply(&mut editor, json!({"op": "join_spans", "pass": i + 1, "span": span})).unwrap_or_else(|e| panic!("{e}"));
        assert!(same(&value(editor.program()), &value(&before)), "seed {seed}\n{text}\n{}", editor.text());
        done[usize::from(pass.points.is_some())] += 1;
    }
    assert!(done.iter().all(|n| *n > 40), "{done:?}");
}

#[test]
fn a_process_value_changes_only_in_its_range() {
    let mut done = [0, 0];
    for seed in 0..cases(400) {
        let mut random = Random::of_case(60_000 + seed);
        let (text, _) = program(&mut random);
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = editor.program().clone();
        let i = random.below(before.passes.len());
        let old = &before.passes[i];
        let (low, high) = (random.number(10.0, 90.0), random.number(10.0, 90.0));
        let ramp = json!({"from": low, "to": high});
        if let Some(points) = &old.points {
            let (a, b) = (random.below(points.count() + 1), random.below(points.count() + 1));
            let (a, b) = (a.min(b), a.max(b));
            let set = json!({"op": "set_process", "pass": i + 1, "points": [a, b], "name": "current_a", "value": ramp});
            apply(&mut editor, set).unwrap();
            let column = points.columns.iter().position(|c| c == "current_a").unwrap();
            let new = editor.program().passes[i].points.as_ref().unwrap();
            for (k, (x, y)) in points.rows().zip(new.rows()).enumerate() {
                for c in 0..points.columns.len() {
                    let inside = (a..=b).contains(&k) && c == column;
                    assert!(inside || x[c] == y[c], "seed {seed}");
                    assert!(
                        !inside
                            || (low.min(high)..=low.max(high)).contains(&y[c].get())
                            || (y[c].get() - high).abs() < 1e-9
                    );
                }
                assert!(k != a || (y[column].get() - low).abs() < 1e-9);
                assert!(k != b || a == b || (y[column].get() - high).abs() < 1e-9);
            }
        } else {
            let (a, b) = (random.within(0.0, old.length()), random.within(0.0, old.length()));
            let (a, b) = (a.min(b), a.max(b));
            let set = json!({"op": "set_process", "pass": i + 1, "s_mm": [a, b], "name": "current_a", "value": ramp});
            apply(&mut editor, set).unwrap();
            let new = &editor.program().passes[i];
            for k in 0..60 {
                let s = old.length() * (f64::from(k) + 0.31) / 60.0;
                let current = |pass: &Pass| pass.process_at("current_a", s, ArcTime::TRAVEL).unwrap();
                let inside = a < s && s < b;
                let wanted = if inside { low + (high - low) * (s - a) / (b - a) } else { current(old) };
                assert!((current(new) - wanted).abs() < 1e-6, "seed {seed} {s}");
                assert!((new.speed_at(s) - old.speed_at(s)).abs() < 1e-9);
            }
        }
        done[usize::from(old.points.is_some())] += 1;
    }
    assert!(done.iter().all(|n| *n > 80), "{done:?}");
}

#[test]
fn a_closed_run_goes_through_the_same_places_from_another_point() {
    let mut done = 0;
    for seed in 0..cases(400) {
        let mut random = Random::of_case(70_000 + seed);
        let (text, _) = program(&mut random);
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = editor.program().clone();
        let i = random.below(before.passes.len());
        let Some(old) = &before.passes[i].points else { continue };
        let k = random.below(old.count() + 1);
        if apply(&mut editor, json!({"op": "shift_start", "pass": i + 1, "point": k})).is_err() {
            continue;
        }
        let new = editor.program().passes[i].points.clone().unwrap();
        let (a, b): (Vec<_>, Vec<_>) = (old.rows().collect(), new.rows().collect());
        let n = old.count();
        for j in 0..n {
            assert_eq!(b[j + 1], a[(j + k) % n + 1], "seed {seed}");
        }
        let mut wanted = all_states(&before.passes[i]);
        wanted.iter_mut().for_each(|states| states.rotate_left(k % n));
        assert_eq!(all_states(&editor.program().passes[i]), wanted, "seed {seed}");
        done += 1;
    }
    assert!(done > 25, "{done}");
}

#[test]
fn halfway_on_an_arc_and_offsets_by_its_frame() {
    let text = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"p\"\n[passes.points]\n\
        columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"time_s\"]\nstart = [10, 0, 0, 0]\n[[passes.points.spans]]\n\
        along = \"arc\"\nvia_mm = [0, 10, 0]\npoints = [[-10, 0, 0, 4]]\n";
    let mut editor = Editor::new("p.toml", text).unwrap();
    apply(&mut editor, json!({"op": "insert_point", "pass": 1, "after": 0})).unwrap();
    let points = editor.program().passes[0].points.clone().unwrap();
    let near = |p: glam::DVec3, q: [f64; 3]| (p - glam::DVec3::from_array(q)).length() < 1e-12;
    let h = 50f64.sqrt();
    assert!(near(points.spans[0].via_mm.unwrap().get(), [h, h, 0.0]));
    assert!(near(points.spans[1].via_mm.unwrap().get(), [-h, h, 0.0]));
    let rows: Vec<Vec<f64>> = points.rows().map(|r| r.iter().map(|v| v.get()).collect()).collect();
    assert!(
        near(glam::DVec3::from_slice(&rows[1]), [0.0, 10.0, 0.0])
            && (rows[1][3] - 2.0).abs() < 1e-12
            && (rows[2][3] - 2.0).abs() < 1e-12
    );
    // Counter-clockwise with the torch pointing down: across is direction x travel, here out of the circle.
    apply(&mut editor, json!({"op": "offset", "pass": 1, "dy_mm": 1, "dz_mm": -2})).unwrap();
    let points = editor.program().passes[0].points.clone().unwrap();
    for place in points.rows().map(|r| [r[0].get(), r[1].get(), r[2].get()]) {
        assert!((place[0].hypot(place[1]) - 11.0).abs() < 1e-9 && (place[2] - 2.0).abs() < 1e-12, "{place:?}");
    }
    for span in &points.spans {
        let via = span.via_mm.unwrap().get();
        assert!((via.truncate().length() - 11.0).abs() < 1e-9 && (via.z - 2.0).abs() < 1e-12, "{via}");
    }
}
