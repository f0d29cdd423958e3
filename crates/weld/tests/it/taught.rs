//! Taught spans: joins, smoothness, residuals and faces on random saddles, bends and lines; bad input with its address.

use crate::jobs::{self, WithSeam, read, refusal, vectors};
use glam::DVec3;
use proptest::prelude::*;
use seamwright_weld::{Outside, SeamPoint, Welding, Wrong};

fn job(seam: &str, rest: &str) -> String {
    jobs::job(&format!("{seam}\n{rest}"))
}

const SADDLE: &str = "[seam.nozzle]\nradius_mm = 250\n[seam.nozzle.body.cylinder]\nradius_mm = 800\n";

fn seam(kind: u32) -> &'static str {
    match kind {
        0 => SADDLE,
        1 => "[seam.ellipse]\na_mm = 300\nb_mm = 180\n",
        2 => "[seam.helix]\nradius_mm = 150\npitch_mm = 60\nturns = 1.5\n",
        3 => {
            "[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [600, 100, 50]\nfirst_normal = [1, -6, 0]\nsecond_normal = [-1, 0, 12]\n"
        }
        _ => "[seam.girth]\nradius_mm = 200\ncut_normal = [0.3, 0, 1]\n",
    }
}

/// A span over `nominal` from `from` to `to`, its points `off` (across, up, mm) beside it in equal steps.
fn span(nominal: &Welding, (from, to): (f64, f64), off: &[(f64, f64)]) -> (String, Vec<DVec3>) {
    let place = |i: usize| from + (to - from) * (i as f64 + 1.0) / (off.len() as f64 + 1.0);
    let beside = |(i, (a, b)): (usize, &(f64, f64))| {
        let p = nominal.seam().at(place(i));
        p.point + *a * p.bisector + *b * p.tangent.cross(p.bisector)
    };
    let points: Vec<DVec3> = off.iter().enumerate().map(beside).collect();
    (format!("[[taught]]\nfrom_mm = {from:?}\nto_mm = {to:?}\npoints_mm = {}\n", vectors(&points)), points)
}

/// Vectors that an axis follows: the point and both normals.
fn frame(p: &SeamPoint) -> [DVec3; 3] {
    [p.point, p.n1, p.bisector]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn spans_join_smoothly(
        kind in 0u32..5, clockwise in any::<bool>(), phi in -180.0..180.0f64, start in 0.0..1.0f64, long in 0.12..0.35f64,
        off in prop::collection::vec((-3.0..3.0f64, -3.0..3.0f64), 1..7),
    ) {
        let closed = ![2, 3].contains(&kind);
        let direction = if clockwise { "clockwise" } else { "counter-clockwise" };
        let start_keys = format!("[start]\nphi_deg = {phi:?}\ndirection = \"{direction}\"\noverlap_mm = 100\n");
        let keys = if closed { start_keys.as_str() } else { "" };
        let nominal = read(&job(seam(kind), keys));
        let length = nominal.seam().length();
        // From the very start to the very end too.
        let from = if start < 0.05 { 0.0 } else { length * start * (1.0 - long) };
        let to = if start > 0.95 { length } else { from + length * long };
        let (text, points) = span(&nominal, (from, to), &off);
        let w = read(&job(seam(kind), &format!("{keys}{text}")));
        let taught = &w.seam().taught()[0];
        let added = w.seam().length() - length;
        prop_assert!(((taught.seam.0 - from).abs()) < 1e-9 && (taught.seam.1 - to - added).abs() < 1e-8);
        prop_assert!(taught.nominal == (from, to));

        // Position, direction, curvature and faces are the nominal seam's at the joins; outside it is that seam.
        for (s, t) in [(taught.seam.0, from), (taught.seam.1, to)] {
            let (here, there) = (w.seam().at(s), nominal.seam().at(t));
            prop_assert!(here.point.distance(there.point) < 1e-9, "{}", here.point.distance(there.point));
            prop_assert!(here.tangent.distance(there.tangent) < 1e-9 && here.along.distance(there.along) < 1e-9);
            prop_assert!(here.n1.distance(there.n1) < 1e-9 && here.n2.distance(there.n2) < 1e-9);
            // From inside the span too.
            let inside = s + if t.to_bits() == from.to_bits() { 1e-6 } else { -1e-6 };
            let bend = w.seam().curvature(inside).distance(nominal.seam().curvature(t));
            prop_assert!(bend < 1e-7, "{bend}");
        }
        for part in [0.0, 0.3, 0.99] {
            let (a, b) = (part * from, to + part * (length - to));
            prop_assert!(w.seam().at(a).point.distance(nominal.seam().at(a).point) < 1e-8);
            prop_assert!(w.seam().at(b + added).point.distance(nominal.seam().at(b).point) < 1e-8);
        }
        if closed {
            prop_assert!(w.seam().at(w.seam().length() + 50.0).point.distance(w.seam().at(50.0).point) < 1e-8);
        }
        // Through the points.
        for (s, p) in taught.points.iter().zip(&points) {
            prop_assert!(w.seam().at(*s).point.distance(*p) < 1e-9, "{}", w.seam().at(*s).point.distance(*p));
            let p = w.seam().at(*s);
            prop_assert!(p.tangent.distance(p.along) < 1e-9);
        }
        // Path length is path length, faces are square to `along`, which is near the tangent.
        for i in 0..=60 {
            let s = taught.seam.0 + (taught.seam.1 - taught.seam.0) * f64::from(i) / 60.0;
            let p = w.seam().at(s);
            prop_assert!(p.n1.dot(p.along).abs() < 1e-9 && p.n2.dot(p.along).abs() < 1e-9);
            prop_assert!((p.n1.length() - 1.0).abs() < 1e-12 && p.tangent.dot(p.along) > 0.999, "{}", p.tangent.dot(p.along));
            if s > 1.0 && s + 1.0 < w.seam().weld_length() {
                let h = 1e-4;
                let slope = (w.seam().at(s + h).point - w.seam().at(s - h).point) / (2.0 * h);
                prop_assert!(slope.distance(p.tangent) < 1e-6, "{} {}", slope, p.tangent);
            }
        }
        // The second derivatives of point and faces are continuous at knots: one-sided differences meet as the step
        // shrinks.
        for s in w.seam().knots() {
            let jump = |h: f64| {
                let at = |k: f64| frame(&w.seam().at(s + k * h));
                let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(at);
                let second = |x: DVec3, y: DVec3, z: DVec3| (x - 2.0 * y + z) / (h * h);
                (0..3).map(|i| second(a[i], b[i], c[i]).distance(second(c[i], d[i], e[i]))).fold(0.0, f64::max)
            };
            if s < 3.0 || s + 3.0 > w.seam().weld_length() {
                continue;
            }
            let (wide, narrow) = (jump(0.5), jump(0.05));
            prop_assert!(narrow < 0.2 * wide + 2e-6, "{s}: {wide} {narrow}");
        }
        // The program repeats it.
        let again = read(&w.program.value.to_toml().unwrap());
        prop_assert!(again.seam().at(taught.seam.0 + 20.0) == w.seam().at(taught.seam.0 + 20.0));
    }
}

/// Points on the nominal line leave it as it is.
#[test]
fn points_on_a_straight_seam_change_nothing() {
    let nominal = read(&job(seam(3), ""));
    let (text, _) = span(&nominal, (100.0, 300.0), &[(0.0, 0.0); 4]);
    let w = read(&job(seam(3), &text));
    assert!((w.seam().length() - nominal.seam().length()).abs() < 1e-10);
    for i in 0..=600 {
        let s = w.seam().length() * f64::from(i) / 600.0;
        let (a, b) = (w.seam().at(s), nominal.seam().at(s));
        assert!(a.point.distance(b.point) < 1e-10 && a.n1.distance(b.n1) < 1e-12 && a.n2.distance(b.n2) < 1e-12);
    }
}

fn refused(spans: &str, key: &str, words: &str) {
    let e = refusal(&job(SADDLE, spans));
    assert_eq!(e.key, key);
    assert!(e.to_string().contains(words), "{words} in {e}");
}

#[test]
fn mistakes_have_an_address() {
    let nominal = read(&job(SADDLE, ""));
    let flat = [(1.0, 0.0); 4];
    let (good, points) = span(&nominal, (300.0, 500.0), &flat);
    let with = |points: &[DVec3]| format!("[[taught]]\nfrom_mm = 300\nto_mm = 500\npoints_mm = {}\n", vectors(points));
    read(&job(SADDLE, &good));
    let [a, b, c, d] = points[..] else { unreachable!() };
    refused(&with(&[a, c, b, d]), "taught[0].points_mm[2]", "after the point before");
    refused(&with(&[a, b, b, d]), "taught[0].points_mm[2]", "after the point before");
    refused(&with(&[nominal.seam().at(295.0).point, b]), "taught[0].points_mm[0]", "after the first join");
    refused(&with(&[b, nominal.seam().at(515.0).point]), "taught[0].points_mm[1]", "from the nominal seam");
    refused(&with(&[b, nominal.seam().at(500.0).point]), "taught[0].points_mm[1]", "before the second join");
    let far = a + 10.5 * nominal.seam().at(340.0).bisector;
    refused(&with(&[far, b]), "taught[0].points_mm[0]", "11.500 mm from the nominal seam");
    read(&job(SADDLE, &with(&[far, b]).replace("to_mm", "within_mm = 12\nto_mm")));
    for (step, high, words) in [(2.0, 6.0, "turns by 90°"), (6.0, 4.0, "off the seam")] {
        let beside = |i: u32| {
            let p = nominal.seam().at(400.0 + step * f64::from(i));
            p.point + if i.is_multiple_of(2) { high } else { -high } * p.bisector
        };
        let zigzag: Vec<DVec3> = (0..8).map(beside).collect();
        let e = refusal(&job(SADDLE, &with(&zigzag)));
        assert!(e.key.starts_with("taught[0]") && e.to_string().contains(words), "{words} in {e}");
    }
    refused("[[taught]]\nfrom_mm = 300\nto_mm = 500\n", "taught[0]", "no points");
    refused(&good.replace("to_mm = 500.0", "to_mm = 300.0"), "taught[0].to_mm", "no length");
    refused(&good.replace("to_mm = 500.0", "to_mm = 5000.0"), "taught[0].to_mm", "beyond the nominal seam");
    refused(
        &format!("{good}{}", good.replace("from_mm = 300.0", "from_mm = 499.0")),
        "taught[1].from_mm",
        "before the one before",
    );
    refused(&good.replace("from_mm = 300.0", "from_mm = -1"), "taught[0].from_mm", "");
    refused(&good.replace("to_mm", "axes = [[1, 2]]\nto_mm"), "taught[0].axes", "given twice");
    refused(
        "[[taught]]\nfrom_mm = 300\nto_mm = 500\naxes = [[1, 2]]\n",
        "taught[0].axes[0]",
        "no machine is available",
    );
}

/// A machine whose three axes are x, y and z of the work frame.
struct Linear;

impl Outside for Linear {
    fn bytes(&self, _file: &str) -> std::io::Result<Vec<u8>> {
        Err(std::io::ErrorKind::NotFound.into())
    }

    fn table(&self, _file: &str) -> Result<Vec<Vec<f64>>, Wrong> {
        unreachable!("no table is named")
    }
    fn tip(&self, machine: &str, axes: &[f64]) -> Result<DVec3, Wrong> {
        assert_eq!(machine, "m");
        Ok(DVec3::from_slice(axes))
    }
}

#[test]
fn recorded_positions_go_through_offset_and_placement() {
    let nominal = read(&job(SADDLE, ""));
    let (good, points) = span(&nominal, (300.0, 500.0), &[(1.0, 0.5), (2.0, 0.0), (1.0, -0.5)]);
    let places = "[placement]\nmove_mm = [10, 20, -30]\nturn = [1, 2, 3]\nangle_deg = 40\n\
                  [offsets.table]\nmove_mm = [1, 2, 3]\nangle_deg = -70\n";
    let by_points = read(&job(SADDLE, &format!("{places}{good}")).replace("machine", "offset = \"table\"\nmachine"));
    let to_work = by_points.program.value.seam_in_work();
    let rows: Vec<DVec3> = points.iter().map(|p| to_work.transform_point3(*p)).collect();
    let recorded = format!("[[taught]]\nfrom_mm = 300\nto_mm = 500\naxes = {}\n", vectors(&rows));
    let text = job(SADDLE, &format!("{places}{recorded}")).replace("machine", "offset = \"table\"\nmachine");
    let by_axes = Welding::read_with("j.toml", &text, &Linear).unwrap_or_else(|e| panic!("{e}"));
    for i in 0..200 {
        let s = 290.0 + 1.1 * f64::from(i);
        assert!(by_axes.seam().at(s).point.distance(by_points.seam().at(s).point) < 1e-9);
    }
    // The program holds points, and needs no machine.
    let program = by_axes.program.value.to_toml().unwrap();
    assert!(program.contains("points_mm") && !program.contains("axes = ["));
    assert!(read(&program).seam().at(400.0).point.distance(by_points.seam().at(400.0).point) < 1e-9);
}
