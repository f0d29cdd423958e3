//! Free seams: points, tangents, normals, closed ones, tables; bad input with its address.

use crate::jobs::{WithSeam, job, read, refusal, vectors, with_seam};
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use seamwright_weld::{Outside, Welding, Wrong};

/// A table whose rows are points, or points with normals.
struct Table(Vec<Vec<f64>>);

impl Outside for Table {
    fn bytes(&self, _file: &str) -> std::io::Result<Vec<u8>> {
        Err(std::io::ErrorKind::NotFound.into())
    }

    fn table(&self, file: &str) -> Result<Vec<Vec<f64>>, Wrong> {
        match file {
            "joint.csv" => Ok(self.0.clone()),
            _ => Err(Wrong { message: format!("{file}: not there").into(), allowed: "joint.csv".into() }),
        }
    }
    fn tip(&self, _machine: &str, _axes: &[f64]) -> Result<DVec3, Wrong> {
        unreachable!("nothing is recorded")
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn pass_through_points_with_smooth_faces(
        turns in prop::collection::vec((-0.5..0.5f64, -0.3..0.3f64, 8.0..30.0f64), 3..12), joint in 0..4,
        tangents in any::<bool>(), spread in 0.0..0.6f64,
    ) {
        let (mut at, mut turn) = (DVec3::new(100.0, -50.0, 20.0), DQuat::IDENTITY);
        let mut points = vec![at];
        let mut normals = (Vec::new(), Vec::new());
        for (yaw, climb, step) in &turns {
            turn = DQuat::from_rotation_z(*yaw) * turn;
            at += *step * (turn * DVec3::new(1.0, 0.0, *climb)).normalize();
            points.push(at);
        }
        for i in 0..points.len() {
            let lean = DQuat::from_rotation_y(spread * (i as f64).sin());
            normals.0.push(lean * DVec3::Z);
            normals.1.push(lean * DVec3::new(0.2, 0.5, 1.0));
        }
        let ends = if tangents { "start_tangent = [1, 0.1, 0]\n" } else { "" };
        let faces = match joint {
            0 => "joint = \"butt\"\nnormal = [0, 0.1, 1]".to_owned(),
            1 => "wall_faces = \"left\"".to_owned(),
            2 => format!("first_normals = {}", vectors(&normals.0)),
            _ => format!("first_normals = {}\nsecond_normals = {}", vectors(&normals.0), vectors(&normals.1)),
        };
        // Points that go back behind the first tangent, or turn sharply, are refused; that is another test.
        let text = job(&format!("[seam.spline]\npoints_mm = {}\n{ends}{faces}\n", vectors(&points)));
        let Ok(w) = Welding::read("j.toml", &text) else { return Ok(()) };
        let (length, knots) = (w.seam().length(), w.seam().knots());
        let away = |p: DVec3| {
            let mut best = (f64::INFINITY, 0.0);
            for i in 0..=2000 {
                let s = length * f64::from(i) / 2000.0;
                let d = w.seam().at(s).point.distance(p);
                if d < best.0 { best = (d, s); }
            }
            let mut s = best.1;
            for _ in 0..20 {
                let here = w.seam().at(s);
                s = (s + (p - here.point).dot(here.tangent)).clamp(0.0, length);
            }
            w.seam().at(s).point.distance(p)
        };
        for p in points.iter().step_by(3) {
            prop_assert!(away(*p) < 1e-9, "{}", away(*p));
        }
        prop_assert!(!w.seam().all_round() && w.seam().at(0.0).phi.is_none());
        for i in 0..=40 {
            let p = w.seam().at(length * f64::from(i) / 40.0);
            prop_assert!(p.n1.dot(p.along).abs() < 1e-9 && p.n2.dot(p.along).abs() < 1e-9);
            prop_assert!((p.n1.length() - 1.0).abs() < 1e-12 && p.tangent.dot(p.along) > 0.995, "{}", p.tangent.dot(p.along));
            let dihedral = if joint == 0 { std::f64::consts::PI } else { 0.5 * std::f64::consts::PI };
            prop_assert!(joint == 3 || (p.dihedral - dihedral).abs() < 1e-9);
            if joint == 1 {
                prop_assert!(p.n1.distance(p.n2.cross(p.along)) < 1e-9);
            }
        }
        // The second derivatives of point and faces are continuous.
        for s in knots.into_iter().filter(|s| *s > 2.0 && *s < length - 2.0) {
            let jump = |h: f64| {
                let at = |k: f64| { let p = w.seam().at(s + k * h); [p.point, p.bisector, p.towards_first] };
                let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(at);
                let second = |x: DVec3, y: DVec3, z: DVec3| (x - 2.0 * y + z) / (h * h);
                (0..3).map(|i| second(a[i], b[i], c[i]).distance(second(c[i], d[i], e[i]))).fold(0.0, f64::max)
            };
            let (wide, narrow) = (jump(0.4), jump(0.04));
            prop_assert!(narrow < 0.25 * wide + 2e-6, "{s}: {wide} {narrow}");
        }
    }
}

#[test]
fn closed_ones_come_round_and_tables_are_taken_along() {
    let n = 24;
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
    let points: Vec<DVec3> = (0..n).map(|i| DVec3::new(80.0 * angle(i).cos(), 80.0 * angle(i).sin(), 5.0)).collect();
    let w =
        with_seam(&format!("[seam.spline]\npoints_mm = {}\nclosed = true\n[start]\noverlap_mm = 10", vectors(&points)));
    assert!(w.seam().all_round() && (w.seam().length() - 160.0 * std::f64::consts::PI).abs() < 0.01);
    assert!(w.seam().at(w.seam().length() + 4.0).point.distance(w.seam().at(4.0).point) < 1e-9);
    for i in 0..100 {
        let p = w.seam().at(5.0 * f64::from(i));
        let out = DVec3::new(p.point.x, p.point.y, 0.0).normalize();
        assert!((p.point.truncate().length() - 80.0).abs() < 0.005 && p.n1.distance(out) < 1e-3);
    }
    // The same from a table, with the normals in it, near the points: the program needs no table.
    let row = |p: &DVec3| vec![p.x, p.y, p.z, p.x, p.y, 0.0, 0.0, 0.0, 2.0];
    let table = Table(points.iter().map(row).collect());
    let text = job("[seam.spline]\nfile = \"joint.csv\"\nclosed = true\ntolerance_mm = 0.05");
    let from_table = Welding::read_with("j.toml", &text, &table).unwrap_or_else(|e| panic!("{e}"));
    assert!(from_table.seam().knots().len() > 4 && from_table.seam().at(30.0).n2.distance(DVec3::Z) < 1e-9);
    let program = from_table.program.value.to_toml().unwrap();
    assert!(program.contains("points_mm") && !program.contains("joint.csv"));
    assert_eq!(read(&program).seam().at(100.0), from_table.seam().at(100.0));
}

#[test]
fn mistakes_have_an_address() {
    let key = |seam: &str, words: &str| {
        let e = refusal(&job(&format!("[seam.spline]\n{seam}")));
        assert!(e.to_string().contains(words), "{words} in {e}");
        e.key
    };
    let good = "points_mm = [[0, 0, 0], [10, 2, 0], [20, 0, 1]]\n";
    with_seam(&format!("[seam.spline]\n{good}"));
    assert_eq!(key("points_mm = [[0, 0, 0]]", "2 to 20000"), "seam.spline.points_mm");
    assert_eq!(key("", "the seam has 0 points"), "seam.spline.points_mm");
    assert_eq!(key("points_mm = [[0, 0, 0], [1, 0, 0]]\nclosed = true", "3 to"), "seam.spline.points_mm");
    assert_eq!(
        key("points_mm = [[0, 0, 0], [1, 0, 0], [1, 0, 0]]", "coincides with the one before"),
        "seam.spline.points_mm[2]"
    );
    let round = "points_mm = [[0, 0, 0], [9, 0, 0], [5, 5, 0], [0, 0, 0]]\nclosed = true";
    assert_eq!(key(round, "leave this point out"), "seam.spline.points_mm[3]");
    assert_eq!(key(&format!("{good}start_tangent = [-1, 0, 0]"), "points back"), "seam.spline.start_tangent");
    assert_eq!(key(&format!("{good}closed = true\nend_tangent = [1, 0, 0]"), "no ends"), "seam.spline.end_tangent");
    assert_eq!(key(&format!("{good}normal = [1, 0, 0]"), "along the seam"), "seam.spline.normal");
    assert_eq!(
        key(&format!("{good}first_normals = [[0, 0, 1]]"), "1 normal for 3 points"),
        "seam.spline.first_normals"
    );
    let second = format!("{good}second_normals = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]");
    assert_eq!(key(&second, "first_normals"), "seam.spline.second_normals");
    let both = format!("{}\nnormal = [0, 0, 1]", second.replace("second", "first"));
    assert_eq!(key(&both, "one for each point"), "seam.spline.normal");
    let turned = second.replace("second", "first").replace("[0, 0, 1]]", "[0, 0, -1]]");
    assert_eq!(key(&turned, "less than 90"), "seam.spline.first_normals");
    assert_eq!(key("file = \"joint.csv\"", "no files"), "seam.spline.file");
    assert_eq!(key(&format!("{good}file = \"joint.csv\""), "both a file"), "seam.spline.file");
    assert_eq!(key(&format!("{good}tolerance_mm = -1"), "0 or"), "seam.spline.tolerance_mm");
    let back = "points_mm = [[0, 0, 0], [10, 0, 0], [0.5, 0.1, 0], [10, 0.2, 0]]";
    assert_eq!(key(back, "turns by 90°"), "seam.spline.points_mm");
    assert_eq!(key(&format!("{good}[start]\nphi_deg = 20"), "does not close"), "start.phi_deg");
}
