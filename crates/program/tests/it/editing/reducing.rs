//! Points reduced to lines and arcs: ends exact, every point near its replacement, by brute force.

use glam::DVec3;
use seamwright_program::edit::{Editor, Operation};
use seamwright_program::{Along, Points};
use seamwright_testkit::{Random, cases};
use serde_json::json;
use std::fmt::Write;

/// Lines and arcs through taught-like points with noise.
fn text(random: &mut Random, timed: bool, noise: f64) -> String {
    let mut rows: Vec<[f64; 5]> = vec![[0.0; 5]];
    let (mut place, mut heading) = (DVec3::ZERO, 0.0f64);
    for _ in 0..1 + random.below(4) {
        let bend = if random.yes() { 0.0 } else { random.within(-0.2, 0.2) };
        for _ in 0..2 + random.below(12) {
            heading += bend;
            place += random.within(0.5, 2.0) * DVec3::new(heading.cos(), heading.sin(), 0.1);
            let n =
                DVec3::new(random.within(-noise, noise), random.within(-noise, noise), random.within(-noise, noise));
            let p = place + n;
            rows.push([p.x, p.y, p.z, 100.0 + place.x, random.within(0.2, 1.0)]);
        }
        heading += random.within(-1.5, 1.5);
    }
    let last = if timed { "time_s" } else { "speed_mm_s" };
    let mut out = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"p\"\n[passes.points]\ncolumns = [\"x_mm\", \"y_mm\", \
        \"z_mm\", \"current_a\", \"gas_l_min\", \"{last}\"]\nstepped = [\"gas_l_min\"]\nstart = [0, 0, 0, 100, 5, 0]\n\
        events = [{{ after = {}, gas = true }}]\n[[passes.points.spans]]\nalong = \"line\"\npoints = [\n",
        random.below(rows.len())
    );
    let step = random.below(rows.len());
    for (i, [x, y, z, c, t]) in rows.iter().enumerate().skip(1) {
        writeln!(out, "[{x:?}, {y:?}, {z:?}, {:?}, {}, {t:?}],", c.max(0.0), if i < step { 5 } else { 9 }).unwrap();
    }
    out + "]\n"
}

fn rows(points: &Points) -> Vec<Vec<f64>> {
    points.rows().map(|row| row.iter().map(|v| v.get()).collect()).collect()
}

/// Many points on the lines and arcs of a pass, by the way to each point.
fn traced(points: &Points) -> Vec<Vec<DVec3>> {
    let mut here = DVec3::from_slice(&rows(points)[0]);
    let mut out = Vec::new();
    for span in &points.spans {
        for row in &span.points {
            let there = DVec3::new(row[0].get(), row[1].get(), row[2].get());
            let places = (0..=2000).map(|k| f64::from(k) / 2000.0);
            out.push(match span.along {
                Along::Arc => circle(here, span.via_mm.unwrap().get(), there, places),
                _ => places.map(|f| here.lerp(there, f)).collect(),
            });
            here = there;
        }
    }
    out
}

/// Points on the circle through three points, by its centre as the intersection of bisecting planes.
fn circle(a: DVec3, via: DVec3, b: DVec3, places: impl Iterator<Item = f64>) -> Vec<DVec3> {
    let normal = (via - a).cross(b - a).normalize();
    let planes = glam::DMat3::from_cols(via - a, b - a, normal).transpose();
    let right = DVec3::new((via - a).dot((via + a) / 2.0), (b - a).dot((b + a) / 2.0), normal.dot(a));
    let centre = planes.inverse() * right;
    let (x, y) = ((a - centre).normalize(), normal.cross((a - centre).normalize()));
    let radius = (a - centre).length();
    let angle = |p: DVec3| (p - centre).dot(y).atan2((p - centre).dot(x)).rem_euclid(std::f64::consts::TAU);
    let sweep = angle(b);
    assert!(angle(via) < sweep);
    places.map(|f| centre + radius * ((f * sweep).cos() * x + (f * sweep).sin() * y)).collect()
}

#[test]
fn every_point_is_within_the_tolerance() {
    let (mut fewer, mut arcs) = (0, 0);
    for seed in 0..cases(400) {
        let mut random = Random::of_case(80_000 + seed);
        let (timed, tolerance) = (random.yes(), random.within(0.02, 0.3));
        let noise = random.within(0.0, tolerance);
        let text = text(&mut random, timed, noise);
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let old = editor.program().passes[0].points.clone().unwrap();
        let reduce = json!({"op": "reduce", "pass": 1, "tolerance_mm": tolerance, "axis_tolerance": 2.0});
        editor.apply(&serde_json::from_value::<Operation>(reduce).unwrap()).unwrap();
        let new = editor.program().passes[0].points.clone().unwrap();
        let (a, b) = (rows(&old), rows(&new));
        assert!(a[0] == b[0] && a[a.len() - 1][..5] == b[b.len() - 1][..5], "seed {seed}: ends");
        fewer += old.count() - new.count();
        arcs += new.spans.iter().filter(|span| span.along == Along::Arc).count();
        // Every remaining point is an original one; those between are near the way.
        let kept: Vec<usize> = b
            .iter()
            .scan(0, |from, row| {
                *from += a[*from..].iter().position(|old| old[..5] == row[..5]).expect("a point that was");
                Some(*from)
            })
            .collect();
        let ways = traced(&new);
        for (k, pair) in kept.windows(2).enumerate() {
            for old in &a[pair[0]..=pair[1]] {
                let p = DVec3::from_slice(old);
                let gap = (ways[k][1] - ways[k][0]).length();
                let near = ways[k].iter().map(|q| (*q - p).length()).fold(f64::INFINITY, f64::min);
                assert!(near <= tolerance + gap, "seed {seed}: {near} > {tolerance}");
            }
            let gas: Vec<f64> = a[pair[0] + 1..=pair[1]].iter().map(|row| row[4]).collect();
            assert!(gas.iter().all(|g| (*g - gas[0]).abs() < 1e-12), "seed {seed}: a step within a way");
            let way: f64 = ways[k].windows(2).map(|q| (q[1] - q[0]).length()).sum();
            let chord = |i: usize| (DVec3::from_slice(&a[i]) - DVec3::from_slice(&a[i - 1])).length();
            let seconds: f64 = (pair[0] + 1..=pair[1]).map(|i| if timed { a[i][5] } else { chord(i) / a[i][5] }).sum();
            let got = if timed { b[k + 1][5] } else { way / b[k + 1][5] };
            assert!((got - seconds).abs() < 1e-5 * seconds, "seed {seed}: {got} {seconds}");
        }
        assert_eq!(kept[new.events[0].after], old.events[0].after, "seed {seed}");
    }
    println!("{fewer} points fewer, {arcs} arcs");
    assert!(fewer > 3000 && arcs > 100);
}
