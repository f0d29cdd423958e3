//! Passes that start elsewhere, run back, go round more than once or lie beside the seam: against independent formulas.

use crate::jobs::{WithSeam, read};
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use seamwright_document::{DocumentError, Finite, NonNegative, Positive};
use seamwright_program::{Bead, Pass, Program, Role, SpanValue, TorchPath};
use seamwright_testkit::cases;
use seamwright_weld::{PassPath, Welding};

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");
const ELLIPSE: &str = include_str!("../../../../examples/ellipse.toml");
const LINE: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [400, 0, 0]\n\
    first_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[torch]\n\
    at = [{ s_mm = 20, travel_angle_deg = 5 }, { s_mm = 300, work_angle_deg = 10 }]\n[weld]\nspeed_mm_s = 5\n";

/// The job's program with its pass changed.
fn changed(text: &str, change: impl FnOnce(&mut Pass)) -> Result<Welding, DocumentError> {
    let mut program = read(text).program.value;
    change(&mut program.passes[0]);
    Welding::read("program.toml", &program.to_toml().unwrap())
}

fn finite(values: impl IntoIterator<Item = f64>) -> Vec<Finite> {
    values.into_iter().map(|v| Finite::new(v).unwrap()).collect()
}

/// A bead from rows of path length, across, out and work angle.
fn bead(rows: &[[f64; 4]]) -> Bead {
    let column = |k: usize| finite(rows.iter().map(|r| r[k]));
    let area_mm2 = vec![NonNegative::new(12.0).unwrap(); rows.len()];
    Bead {
        s_mm: column(0),
        across_mm: column(1),
        out_mm: column(2),
        work_angle_deg: column(3),
        weave_part: Vec::new(),
        area_mm2,
    }
}

/// Sets where a pass runs.
fn run(pass: &mut Pass, begin: f64, length: f64, reverse: bool) {
    (pass.begin_mm, pass.reverse) = (NonNegative::new(begin).unwrap(), reverse);
    pass.spans[0].to_mm = Positive::new(length).unwrap();
}

/// A cubic spline by its second derivatives at the rows, from the full system: natural or with a period.
fn spline(rows: &[(f64, f64)], period: Option<f64>, x: f64) -> f64 {
    if rows.len() == 1 {
        return rows[0].1;
    }
    let mut rows = rows.to_vec();
    let x = period.map_or(x, |p| rows[0].0 + (x - rows[0].0).rem_euclid(p));
    rows.extend(period.map(|p| (rows[0].0 + p, rows[0].1)));
    let n = rows.len();
    let h = |i: usize| rows[i + 1].0 - rows[i].0;
    let rise = |i: usize| (rows[i + 1].1 - rows[i].1) / h(i);
    let mut m = vec![vec![0.0; n + 1]; n];
    for i in 1..n - 1 {
        (m[i][i - 1], m[i][i], m[i][i + 1]) = (h(i - 1), 2.0 * (h(i - 1) + h(i)), h(i));
        m[i][n] = 6.0 * (rise(i) - rise(i - 1));
    }
    if period.is_some() {
        // The second derivative and the slope are the same at both ends.
        (m[0][0], m[0][n - 1]) = (1.0, -1.0);
        let last = n - 1;
        m[last][0] += 2.0 * h(0);
        m[last][1] += h(0);
        m[last][last - 1] += h(last - 1);
        m[last][last] += 2.0 * h(last - 1);
        m[last][n] = 6.0 * (rise(0) - rise(last - 1));
    } else {
        (m[0][0], m[n - 1][n - 1]) = (1.0, 1.0);
    }
    let second = eliminate(m);
    let i = (1..n - 1).take_while(|i| rows[*i].0 <= x).count();
    let (a, b) = ((rows[i + 1].0 - x) / h(i), (x - rows[i].0) / h(i));
    let bend = (a * a * a - a) * second[i] + (b * b * b - b) * second[i + 1];
    a * rows[i].1 + b * rows[i + 1].1 + bend * h(i) * h(i) / 6.0
}

/// Gauss' elimination with pivots.
fn eliminate(mut m: Vec<Vec<f64>>) -> Vec<f64> {
    let n = m.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| m[*a][k].abs().total_cmp(&m[*b][k].abs())).unwrap();
        m.swap(k, pivot);
        for i in (0..n).filter(|i| *i != k) {
            let by = m[i][k] / m[k][k];
            let row = m[k].clone();
            m[i].iter_mut().zip(row).for_each(|(x, p)| *x -= by * p);
        }
    }
    (0..n).map(|i| m[i][n] / m[i][i]).collect()
}

/// Range of a random pass on a seam, and the position of its bead.
#[derive(Debug, Clone)]
struct Case {
    seam: usize,
    begin: f64,
    length: f64,
    reverse: bool,
    rows: Vec<[f64; 4]>,
}

/// The seams: closed with overlap, closed, and in part, open.
fn seams() -> [String; 4] {
    let part = SADDLE.replace("overlap_mm = 20 ", "end_phi_deg = 250 ");
    [SADDLE.to_owned(), ELLIPSE.to_owned(), part, LINE.to_owned()]
}

fn case() -> impl Strategy<Value = Case> {
    let row = (0.2..1.0f64, -4.0..4.0f64, -1.0..6.0f64, -15.0..15.0f64);
    let place = (0.0..1.0f64, 0.0..1.0f64, any::<bool>());
    (0..4usize, place, prop::collection::vec(row, 1..9)).prop_map(|(seam, (a, b, reverse), steps)| {
        let welding = read(&seams()[seam]);
        let seam_length = welding.seam().length();
        let weld = welding.seam().weld_length();
        let (begin, length) = if welding.seam().all_round() {
            (a * weld, (0.01 + 1.98 * b) * seam_length)
        } else {
            let (low, high) = (a.min(b) * 0.98 * weld, (a.max(b) * 0.98 + 0.01) * weld);
            (if reverse { high } else { low }, high - low)
        };
        // Rows all over the weld, within a turn of a closed seam.
        let end = if welding.seam().all_round() { 0.99 * seam_length } else { weld };
        let total: f64 = steps[1..].iter().map(|s| s.0).sum();
        let mut sum = 0.0;
        let mut rows: Vec<[f64; 4]> = Vec::new();
        for (i, (step, across, out, work)) in steps.iter().enumerate() {
            sum += if i > 0 { step / total } else { 0.0 };
            rows.push([if i + 1 == steps.len() && i > 0 { end } else { sum * end }, *across, *out, *work]);
        }
        Case { seam, begin, length, reverse, rows }
    })
}

fn welding_of(case: &Case) -> Welding {
    let change = |pass: &mut Pass| {
        run(pass, case.begin, case.length, case.reverse);
        pass.bead = Some(bead(&case.rows));
    };
    changed(&seams()[case.seam], change).unwrap_or_else(|e| panic!("{case:?}: {e}"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(250)))]

    #[test]
    fn poses_are_those_of_the_formula(case in case(), parts in prop::collection::vec(0.0..1.0f64, 8)) {
        let welding = welding_of(&case);
        let path = welding.path(0);
        let path = path.along_seam().unwrap();
        let pass = &welding.program.value.passes[0];
        let period = welding.seam().all_round().then(|| welding.seam().length());
        let row = |k: usize, s: f64| {
            let rows: Vec<_> = case.rows.iter().map(|r| (r[0], r[k])).collect();
            spline(&rows, period, s)
        };
        prop_assert!((path.length() - case.length).abs() < 1e-12);
        for s in parts.iter().map(|part| part * path.length()) {
            let there = if case.reverse { case.begin - s } else { case.begin + s };
            prop_assert!((pass.seam_s(s) - there).abs() < 1e-12);
            // On a closed seam the same position a turn on or back.
            let p = welding.seam().at(period.map_or(there, |turn| there.rem_euclid(turn)));
            let tip = p.point + row(1, there) * p.towards_first + row(2, there) * p.bisector;
            let (work, travel) = path.attitude.angles(p.s);
            let work = work + row(3, there).to_radians();
            let ahead = if case.reverse { -p.tangent } else { p.tangent };
            let leaning = DQuat::from_axis_angle(p.bisector.cross(p.towards_first).normalize(), work) * p.bisector;
            let axis = DQuat::from_axis_angle(leaning.cross(ahead).normalize(), travel) * leaning;
            let placement = welding.program.value.seam_in_work();
            let pose = path.pose(s);
            prop_assert!((pose.point - placement.transform_point3(tip)).length() < 1e-9, "{} {}", pose.point, tip);
            prop_assert!((pose.direction + placement.transform_vector3(axis)).length() < 1e-9);
            prop_assert!((path.face(s) - placement.transform_vector3(p.bisector)).length() < 1e-9);
            let (w, t) = path.angles(s);
            prop_assert!((w - work).abs() < 1e-9 && (t - travel).abs() < 1e-12);
        }
    }

    #[test]
    fn the_rate_is_that_of_the_tip(case in case(), parts in prop::collection::vec(0.01..0.99f64, 8)) {
        let welding = welding_of(&case);
        let path = welding.path(0);
        let path = path.along_seam().unwrap();
        let knots = path.knots();
        for s in parts.iter().map(|part| part * path.length()) {
            let h = 0.05f64.min(0.004 * path.length());
            if knots.iter().any(|k| (k - s).abs() < 2.0 * h) {
                continue;
            }
            // Of the fourth order, over another way than the path's own difference.
            let tip = |k: f64| path.pose(s + k * h).point;
            let rate = (8.0 * (tip(1.0) - tip(-1.0)) - (tip(2.0) - tip(-2.0))).length() / (12.0 * h);
            prop_assert!((path.rate(s) - rate).abs() < 1e-6 * (1.0 + rate), "{} {}", path.rate(s), rate);
        }
    }

    /// Back over the same stretch: the same tip, and the torch leaning the other way along the seam.
    #[test]
    fn running_back_passes_the_same_places(case in case(), parts in prop::collection::vec(0.0..1.0f64, 8)) {
        let end = if case.reverse { case.begin - case.length } else { case.begin + case.length };
        let turn = read(&seams()[case.seam]).seam().length();
        let back = Case { begin: end.rem_euclid(turn), reverse: !case.reverse, ..case.clone() };
        let (there, again) = (welding_of(&case), welding_of(&back));
        let (a, b) = (there.path(0), again.path(0));
        let (a, b) = (a.along_seam().unwrap(), b.along_seam().unwrap());
        for s in parts.iter().map(|part| part * case.length) {
            let (p, q) = (a.pose(s), b.pose(case.length - s));
            prop_assert!((p.point - q.point).length() < 1e-8);
            let along = a.line(s.clamp(0.01, case.length - 0.01)).1;
            prop_assert!((a.rate(s) - b.rate(case.length - s)).abs() < 1e-6);
            let torch = |path: &PassPath, s: f64| path.torch_at(&path.seam_point(s)).1;
            let (p, q) = (torch(a, s), torch(b, case.length - s));
            let tangent = a.seam_point(s).tangent;
            prop_assert!((p - q - 2.0 * p.dot(tangent) * tangent).length() < 1e-8, "{along}");
        }
        let mirrored: Vec<f64> = b.knots().iter().rev().map(|s| case.length - s).collect();
        prop_assert_eq!(a.knots().len(), mirrored.len());
        prop_assert!(a.knots().iter().zip(&mirrored).all(|(a, b)| (a - b).abs() < 1e-8));
        let again = Case { begin: case.begin, reverse: case.reverse, ..back };
        prop_assert_eq!(welding_of(&again).program.value, there.program.value);
    }

    /// The knots are exactly the rows and the breaks of the seam inside the pass, in every turn.
    #[test]
    fn knots_are_the_rows_and_breaks_passed(case in case()) {
        let welding = welding_of(&case);
        let path = welding.path(0);
        let path = path.along_seam().unwrap();
        let turn = welding.seam().all_round().then(|| welding.seam().length());
        let mut places: Vec<f64> = if case.rows.len() > 1 { case.rows.iter().map(|r| r[0]).collect() } else { vec![] };
        let torch = &welding.program.value.passes[0].torch;
        places.extend(torch.at.iter().map(|at| at.s_mm.get()));
        // A single angle is a knot too where it comes again every turn.
        places.extend((torch.at.is_empty()).then_some(0.0));
        places.extend(welding.seam().knots());
        let mut own: Vec<f64> = Vec::new();
        for k in -3..=3 {
            let shift = turn.map_or(0.0, |turn| f64::from(k) * turn);
            own.extend(places.iter().map(|p| (p + shift - case.begin) * if case.reverse { -1.0 } else { 1.0 }));
        }
        own.retain(|s| *s > 1e-5 && *s < case.length - 1e-5);
        own.sort_by(f64::total_cmp);
        own.dedup_by(|a, b| *a - *b < 1e-5);
        let found = path.knots();
        let near = |s: &f64, all: &[f64]| all.iter().any(|k| (k - s).abs() < 1e-5);
        prop_assert!(own.iter().all(|s| near(s, &found)), "{own:?} {found:?}");
        let inside = |s: &&f64| **s > 1e-5 && **s < case.length - 1e-5;
        prop_assert!(found.iter().filter(inside).all(|s| near(s, &own)), "{own:?} {found:?}");
        prop_assert!(found.windows(2).all(|w| w[0] < w[1]));
    }
}

/// A bead round a tube in a plate is a circle of another radius: the rate is their ratio.
#[test]
fn beside_a_circle_the_rate_is_that_of_radii() {
    for joint in ["butt", "fillet"] {
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.circle]\ncentre_mm = [10, 20, 30]\nradius_mm = 60\n\
             normal = [0, 0, 1]\njoint = \"{joint}\"\n[weld]\nspeed_mm_s = 5\n"
        );
        let radius = |p: DVec3| (p - DVec3::new(10.0, 20.0, p.z)).length();
        for (across, out) in [(0.0, 0.0), (-3.0, 0.0), (0.0, 4.0), (2.0, 5.0), (-2.5, 7.0)] {
            let w = changed(&text, |pass| pass.bead = Some(bead(&[[0.0, across, out, 0.0]]))).unwrap();
            let path = w.path(0);
            let path = path.along_seam().unwrap();
            for s in [0.0, 3.0, 50.0, path.length()] {
                let tip = path.torch_at(&path.seam_point(s)).0;
                let moved = across != 0.0 || (out != 0.0 && joint == "fillet");
                assert_eq!((radius(tip) - 60.0).abs() > 1.0, moved);
                assert!((path.rate(s) - radius(tip) / 60.0).abs() < 1e-8, "{across} {out}: {}", path.rate(s));
            }
        }
    }
}

#[test]
fn old_programs_are_written_as_they_were() {
    for text in [SADDLE, ELLIPSE, LINE] {
        let written = read(text).program.value.to_toml().unwrap();
        for key in ["role", "begin_mm", "reverse", "bead"] {
            assert!(!written.contains(key), "{key}: {written}");
        }
        assert_eq!(Program::read("p.toml", &written).unwrap().value.to_toml().unwrap(), written);
        // The pass is still the whole weld.
        let (job, program) = (read(text), Welding::read("p.toml", &written).unwrap());
        let (job, program) = (job.path(0), program.path(0));
        assert_eq!(job.along_seam().unwrap().stretch, program.along_seam().unwrap().stretch);
        assert_eq!(job.knots(), program.knots());
    }
}

#[test]
fn new_keys_come_back_as_they_were() {
    let change = |pass: &mut Pass| {
        run(pass, 100.0, 250.5, true);
        pass.role = Some(Role::Fill);
        pass.bead = Some(bead(&[[0.0, 1.0, 2.0, 3.0], [200.0, -1.5, 2.5, -3.0]]));
        let (from, to) = (Positive::new(4.0).unwrap(), Positive::new(6.5).unwrap());
        pass.spans[0].speed_mm_s = SpanValue::Ramp(seamwright_program::Ramp { from, to });
    };
    let welding = changed(SADDLE, change).unwrap();
    let text = welding.program.value.to_toml().unwrap();
    println!("{text}");
    assert!(text.contains("role = \"fill\"") && text.contains("begin_mm = 100\n") && text.contains("reverse = true"));
    let pass = &welding.program.value.passes[0];
    assert_eq!(Program::read("p.toml", &text).unwrap().value, welding.program.value);
    for (s, v) in [(0.0, 4.0), (125.25, 5.25), (250.5, 6.5), (300.0, 6.5)] {
        assert!((pass.speed_at(s) - v).abs() < 1e-12);
    }
    assert!((pass.speeds().0 - 4.0).abs() < 1e-15 && (pass.speeds().1 - 6.5).abs() < 1e-15);
}

/// Error after a change of the written program: key, message, allowed.
fn wrong(text: &str, change: impl FnOnce(&mut Pass), edit: impl FnOnce(String) -> String) -> (String, String, String) {
    let mut program = read(text).program.value;
    change(&mut program.passes[0]);
    let e = Welding::read("program.toml", &edit(program.to_toml().unwrap())).unwrap_err();
    println!("{e}");
    assert!(e.line > 0);
    (e.key, e.message.to_string(), e.allowed.unwrap_or_default().to_string())
}

#[test]
fn mistakes_in_beads_have_an_address() {
    let rows = [[0.0, 1.0, 2.0, 3.0], [200.0, -1.5, 2.5, -3.0], [400.0, 0.0, 0.0, 0.0]];
    let edited = |from: &str, to: &str| {
        let edit = |text: String| {
            let (head, tail) = text.split_at(text.find("[passes.bead]").unwrap());
            assert!(tail.contains(from), "{tail}");
            head.to_owned() + &tail.replacen(from, to, 1)
        };
        wrong(LINE, |pass| pass.bead = Some(bead(&rows)), edit)
    };
    let (key, message, allowed) = edited("out_mm = [2, 2.5, 0]", "out_mm = [2, 2.5]");
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].bead.out_mm", "3 numbers"));
    assert!(message.contains("2 rows") && message.contains("s_mm has 3"));
    assert_eq!(edited("area_mm2 = [12, 12, 12]", "area_mm2 = [12, 12]").0, "passes[0].bead.area_mm2");
    let (key, _, allowed) = edited("s_mm = [0, 200, 400]", "s_mm = [0, 400, 400]");
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].bead.s_mm[2]", "more than 400 mm"));
    let (key, message, _) = edited("area_mm2 = [12, 12, 12]", "area_mm2 = [12, -1, 12]");
    assert!(key.starts_with("passes[0].bead.area_mm2") && message.contains("-1"), "{key} {message}");
    assert!(edited("across_mm = [1, -1.5, 0]", "across_mm = [1, inf, 0]").0.starts_with("passes[0].bead.across_mm"));
    let (key, message, _) = edited("work_angle_deg = [3, -3, 0]", "work_angle_deg = [3, -90, 0]");
    assert!(key == "passes[0].bead.work_angle_deg[1]" && message.contains("behind a face"));
    assert_eq!(edited("s_mm = [0, 200, 400]", "s_mm = [-1, 200, 400]").0, "passes[0].bead.s_mm[0]");
    let (key, _, allowed) = edited("s_mm = [0, 200, 400]", "s_mm = [0, 200, 401]");
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].bead.s_mm[2]", "0 mm to 400 mm"));
    let (key, message, allowed) = edited("s_mm = [0, 200, 400]", "s_mm = [1, 200, 400]");
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].bead.s_mm[0]", "up to 0 mm"));
    assert!(message.contains("reach over"));
    assert_eq!(edited("s_mm = [0, 200, 400]", "s_mm = [0, 200, 399]").0, "passes[0].bead.s_mm[2]");
    let (key, message, _) = wrong(LINE, |pass| pass.bead = Some(bead(&[])), |text| text);
    assert!(key == "passes[0].bead.s_mm" && message.contains("no rows"), "{key} {message}");
    assert!(edited("s_mm = [0, 200, 400]", "x_mm = [0, 200, 400]").0.contains("bead"));
    // Within a turn of a closed seam.
    let late = [[0.0, 1.0, 2.0, 3.0], [read(SADDLE).seam().length(), -1.5, 2.5, -3.0]];
    let (key, message, allowed) = wrong(SADDLE, |pass| pass.bead = Some(bead(&late)), |text| text);
    assert!(key == "passes[0].bead.s_mm[1]" && message.contains("not on the weld"), "{key} {message}");
    assert!(allowed.starts_with("0 mm or more, less than"), "{allowed}");
}

#[test]
fn mistakes_in_where_a_pass_runs_have_an_address() {
    let same = |text: String| text;
    let on = |text: &str, begin: f64, length: f64, reverse: bool| {
        let (key, message, allowed) = wrong(text, |pass| run(pass, begin, length, reverse), same);
        (key, allowed, message)
    };
    let (key, allowed, _) = on(LINE, 100.0, 301.0, false);
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].spans[0].to_mm", "up to 300 mm"));
    let (key, allowed, message) = on(LINE, 100.0, 101.0, true);
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].spans[0].to_mm", "up to 100 mm"));
    assert!(message.contains("runs back"));
    let (key, allowed, _) = on(LINE, 401.0, 1.0, true);
    assert_eq!((key.as_str(), allowed.as_str()), ("passes[0].begin_mm", "0 mm to 400 mm"));
    let length = read(SADDLE).seam().length();
    let (key, _, message) = on(SADDLE, 10.0, 2.0 * length + 1.0, true);
    assert!(key == "passes[0].spans[0].to_mm" && message.contains("more than twice"));
    for (begin, length, reverse) in [(0.0, 400.0, false), (400.0, 400.0, true), (399.0, 1.0, false)] {
        assert!(changed(LINE, |pass| run(pass, begin, length, reverse)).is_ok());
    }
    assert!(changed(SADDLE, |pass| run(pass, 5.0, 2.0 * length, true)).is_ok());
    let negative = |text: String| text.replace("name = \"pass 1\"", "name = \"pass 1\"\nbegin_mm = -1");
    assert_eq!(wrong(LINE, |_| (), negative).0, "passes[0].begin_mm");
    let role = |text: String| text.replace("name = \"pass 1\"", "name = \"pass 1\"\nrole = \"first\"");
    let (key, _, allowed) = wrong(LINE, |_| (), role);
    assert!(key == "passes[0].role" && allowed.contains("root"), "{key} {allowed}");
    let speed = |to: &'static str| {
        let (key, ..) = wrong(LINE, |_| (), |text| text.replace("speed_mm_s = 5", &format!("speed_mm_s = {to}")));
        key
    };
    assert_eq!(speed("{ from = 5, to = 0 }"), "passes[0].spans[0].speed_mm_s.to");
    assert_eq!(speed("{ from = -5, to = 3 }"), "passes[0].spans[0].speed_mm_s.from");
    assert!(speed("{ from = 5 }").starts_with("passes[0].spans[0].speed_mm_s"));
    assert!(speed("\"5\"").starts_with("passes[0].spans[0].speed_mm_s"));
    assert!(speed("0").starts_with("passes[0].spans[0].speed_mm_s"));
    let least = |text: String| {
        let ramp = text.replace("speed_mm_s = 5", "speed_mm_s = { from = 5, to = 3 }");
        ramp.replace("name = \"pass 1\"", "name = \"pass 1\"\nleast_speed_mm_s = 3.5")
    };
    let (key, _, allowed) = wrong(LINE, |_| (), least);
    assert!(key == "passes[0].least_speed_mm_s" && allowed.contains("= 3 "), "{key} {allowed}");
}

#[test]
fn findings_look_at_the_pass_as_it_is() {
    let kinds = |w: &Welding| w.findings().iter().map(|f| f.kind.clone()).collect::<Vec<_>>();
    let square = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.polyline]\n\
        points_mm = [[0, 0, 0], [100, 0, 0], [100, 100, 0]]\nclosed = false\nnormal = [0, 0, 1]\njoint = \"butt\"\n[weld]\nspeed_mm_s = 5\n";
    assert!(kinds(&read(square)).is_empty());
    let beside = changed(square, |pass| pass.bead = Some(bead(&[[0.0, 2.0, 1.0, 0.0]]))).unwrap();
    let findings = beside.findings();
    assert_eq!(kinds(&beside), ["turn"], "{findings:?}");
    // At a right angle 2 mm aside: the corner of a square.
    assert!(
        findings[0].message.to_string().contains(&format!("tip would jump by {:.3} mm", 8f64.sqrt())),
        "{findings:?}"
    );
    let above = changed(square, |pass| pass.bead = Some(bead(&[[0.0, 0.0, 1.0, 0.0]]))).unwrap();
    assert!(kinds(&above).is_empty());
    // The part before the corner has no finding; its position counts along the pass.
    let part = |begin: f64, length: f64, reverse: bool| {
        let change = |pass: &mut Pass| {
            run(pass, begin, length, reverse);
            pass.bead = Some(bead(&[[0.0, 2.0, 1.0, 0.0]]));
        };
        changed(square, change).unwrap().findings()
    };
    assert!(part(0.0, 99.0, false).is_empty() && part(200.0, 99.0, true).is_empty());
    assert!((part(150.0, 120.0, true)[0].from_mm - 50.0).abs() < 1e-6);
    // The bead's own work angle lays the torch in a wall.
    let leaning = changed(LINE, |pass| {
        pass.bead = Some(bead(&[[0.0, 0.0, 0.0, 0.0], [200.0, 0.0, 0.0, 50.0], [400.0, 0.0, 0.0, 0.0]]));
    });
    let findings = leaning.unwrap().findings();
    assert!(findings.len() == 1 && findings[0].kind == "access" && findings[0].from_mm > 50.0, "{findings:?}");
    // A row that turns back.
    let back = changed(LINE, |pass| {
        let rows = [[0.0, 0.0, 0.0, 0.0], [200.0, 0.0, 0.0, 0.0], [200.5, 3.0, 0.0, 0.0], [400.0, 0.0, 0.0, 0.0]];
        pass.bead = Some(bead(&rows));
    });
    assert!(kinds(&back.unwrap()).is_empty(), "sideways it may go");
    // Inside a bend of 20 mm a bead 25 mm inward runs backwards.
    let circle = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.circle]\ncentre_mm = [0, 0, 0]\nradius_mm = 20\n\
        normal = [0, 0, 1]\njoint = \"butt\"\n[weld]\nspeed_mm_s = 5\n";
    let at = |across: f64| kinds(&changed(circle, |pass| pass.bead = Some(bead(&[[0.0, across, 0.0, 0.0]]))).unwrap());
    let one_way = [at(25.0), at(-25.0)];
    assert!(one_way.contains(&vec![std::borrow::Cow::Borrowed("turn")]) && one_way.contains(&vec![]), "{one_way:?}");
    assert!(at(15.0).is_empty() && at(-15.0).is_empty());
}
