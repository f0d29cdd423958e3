//! T-, Y- and K-joints: closed forms of the local dihedral angle, positions from gaps and offsets, corners, the
//! unrolled end, the part, and mistakes.

use crate::jobs::{WithSeam, job, with_seam};
use crate::part::{NO_STL, distance};
use glam::DVec3;
use seamwright_clearance::Solid;
use seamwright_document::DocumentError;
use seamwright_testkit::{Random, cases};
use seamwright_weld::Welding;
use std::f64::consts::{PI, TAU};

fn read(seam: &str) -> Result<Welding, DocumentError> {
    Welding::read("job.toml", &job(seam))
}

/// Distance from an axis less a radius.
fn level(p: DVec3, at: DVec3, axis: DVec3, radius: f64) -> f64 {
    (p - at).cross(axis).length() - radius
}

/// AWS D1.1: the local dihedral angle between orthogonal cylinders has the cosine -(r/R) sin^2(phi), phi from the chord's
/// axis.
#[test]
fn the_dihedral_of_a_t_joint_is_the_closed_form() {
    let mut random = Random::new(81);
    for _ in 0..cases(300) {
        let chord = random.within(20.0, 800.0);
        let radius = chord * random.within(0.05, 0.97);
        let w = with_seam(&format!("[seam.branch]\nradius_mm = {radius}\nchord_radius_mm = {chord}\n"));
        for _ in 0..10 {
            let p = w.seam().at(random.within(0.0, 1.0) * w.seam().length());
            let sin = p.phi.unwrap().sin();
            let expected = (-radius / chord * sin * sin).acos();
            assert!((p.dihedral - expected).abs() < 1e-9, "{} {expected}", p.dihedral);
        }
    }
}

/// Oblique at theta: theta at the heel, 180 degrees less theta at the toe, and between them from the normals written down.
#[test]
fn the_dihedral_of_a_y_joint_is_theta_at_the_heel() {
    let mut random = Random::new(82);
    for _ in 0..cases(300) {
        let (chord, degrees) = (random.within(20.0, 800.0), random.within(10.0, 170.0));
        let theta: f64 = degrees.to_radians();
        let radius = chord * random.within(0.05, 0.9);
        let sideways = if random.within(0.0, 1.0) < 0.5 { 0.0 } else { random.within(-0.99, 0.99) * (chord - radius) };
        let w = with_seam(&format!(
            "[seam.branch]\nradius_mm = {radius}\nchord_radius_mm = {chord}\nangle_deg = {degrees}\neccentricity_mm = {sideways}\n"
        ));
        if sideways == 0.0 {
            for (phi, psi) in [(0.0, theta), (PI, PI - theta)] {
                let p = w.seam().at(w.seam().s_of_phi(phi).unwrap());
                assert!((p.dihedral - psi).abs() < 1e-9, "{} {psi}", p.dihedral);
            }
        }
        let axis = DVec3::new(theta.cos(), 0.0, theta.sin());
        for _ in 0..10 {
            let p = w.seam().at(random.within(0.0, 1.0) * w.seam().length());
            let at = sideways * DVec3::Y;
            assert!(
                level(p.point, at, axis, radius).abs() < 1e-9
                    && level(p.point, DVec3::ZERO, DVec3::X, chord).abs() < 1e-9
            );
            let (sin, cos) = p.phi.unwrap().sin_cos();
            let y = sideways + radius * sin;
            let z = ((chord - y) * (chord + y)).sqrt();
            // The branch's normal is cos (sin theta, 0, -cos theta) + sin (0, 1, 0), the chord's (0, y, z) / R.
            let psi = ((cos * theta.cos() * z - sin * y) / chord).clamp(-1.0, 1.0).acos();
            assert!((p.dihedral - psi).abs() < 1e-7, "{} {psi}", p.dihedral);
        }
    }
}

/// A K-joint by random numbers: the keys, and the other branch's position for an offset.
struct Pair {
    keys: String,
    first: (DVec3, DVec3, f64),
    other: (DVec3, DVec3, f64),
    chord: f64,
}

fn pair(random: &mut Random) -> Pair {
    let chord = random.within(80.0, 400.0);
    let mut leg = |side: f64, widest: f64| {
        let radius = chord * random.within(0.2, widest);
        let degrees = random.within(30.0, 85.0f64);
        let sideways = random.within(-0.3, 0.3) * (chord - radius);
        let axis = DVec3::new(side * degrees.to_radians().cos(), 0.0, degrees.to_radians().sin());
        (radius, degrees, sideways, axis)
    };
    let (r1, a1, y1, d1) = leg(1.0, 0.6);
    let (r2, a2, y2, d2) = leg(-1.0, 0.9);
    // From toes apart to half a branch of overlap.
    let toe = |up: f64, d: DVec3, r: f64, side: f64| (up * d.x + side * r) / d.z;
    let up = |y: f64| (chord * chord - y * y).sqrt();
    let gap = random.within(-0.8, 0.4) * r1;
    let x = toe(up(y1), d1, r1, -1.0) - gap - toe(up(y2), d2, r2, 1.0);
    let keys = format!(
        "[seam.branch]\nradius_mm = {r1}\nwall_mm = {}\nchord_radius_mm = {chord}\nangle_deg = {a1}\neccentricity_mm = {y1}\n\
         [seam.branch.other]\nradius_mm = {r2}\nangle_deg = {a2}\neccentricity_mm = {y2}\nWHERE\n",
        0.1 * r1
    );
    let at = if gap.abs() > 1e-9 { format!("gap_mm = {gap}") } else { "gap_mm = 0".to_owned() };
    Pair {
        keys: keys.replace("WHERE", &at),
        first: (y1 * DVec3::Y, d1, r1),
        other: (DVec3::new(x, y2, 0.0), d2, r2),
        chord,
    }
}

#[test]
fn overlapped_branches_have_corners_on_three_tubes() {
    let mut random = Random::new(83);
    let (mut cornered, mut refused) = (0, 0);
    for _ in 0..cases(400) {
        let k = pair(&mut random);
        let w = match read(&k.keys) {
            Ok(w) => w,
            Err(e) => {
                assert!(e.key == "seam.branch.other" && e.message.code == "geometry-beside-trimming-tube", "{e}");
                refused += 1;
                continue;
            }
        };
        let on = |p: DVec3, (at, axis, radius): (DVec3, DVec3, f64)| level(p, at, axis, radius).abs();
        let chord = (DVec3::ZERO, DVec3::X, k.chord);
        let knots = w.seam().knots();
        cornered += usize::from(!knots.is_empty());
        for s in &knots {
            let p = w.seam().at(*s).point;
            let worst = [chord, k.first, k.other].map(|rod| on(p, rod)).into_iter().fold(0.0, f64::max);
            assert!(worst < 1e-9, "{worst} mm");
        }
        for _ in 0..20 {
            let p = w.seam().at(random.within(0.0, 1.0) * w.seam().length()).point;
            assert!(on(p, k.first) < 1e-9 && on(p, chord).min(on(p, k.other)) < 1e-9);
            // Outside the other tubes.
            assert!(level(p, chord.0, chord.1, chord.2) > -1e-9 && level(p, k.other.0, k.other.1, k.other.2) > -1e-9);
        }
        // The unrolled ends, outside and inside, roll back onto the tubes and know the corners.
        let cut = w.cut.as_ref().unwrap();
        let corners = cut.outside.points.len() - 361;
        assert!(corners <= 8 && (corners > 0) != knots.is_empty() || knots.len() == 1, "{corners} {knots:?}");
        let (at, axis, radius) = k.first;
        let e1 = (DVec3::X - DVec3::X.dot(axis) * axis).normalize();
        for (side, wall) in [(&cut.outside, 0.0), (cut.inside.as_ref().unwrap(), 0.1 * radius)] {
            assert!((side.radius - (radius - wall)).abs() < 1e-12 * radius);
            for p in &side.points {
                let phi = p.around / side.radius;
                let q = at + side.radius * (phi.cos() * e1 + phi.sin() * axis.cross(e1)) + p.height * axis;
                assert!(on(q, chord).min(on(q, k.other)) < 1e-8);
            }
            let (first, last) = (side.points[0], side.points[side.points.len() - 1]);
            assert!((first.height - last.height).abs() < 1e-9 && (last.around - TAU * side.radius).abs() < 1e-9);
        }
    }
    println!("{cornered} with corners, {refused} refused");
    assert!(cornered > cases(100) && refused < cases(150), "{cornered} {refused}");
}

/// A gap is the distance between the toes as they come out; an offset that puts the other branch there is the same joint.
#[test]
fn gaps_are_between_the_toes() {
    let mut random = Random::new(84);
    let mut found = 0;
    for _ in 0..cases(200) {
        let k = pair(&mut random);
        let Some(gap) = k.keys.split("gap_mm = ").nth(1).and_then(|g| g.trim().parse::<f64>().ok()) else { panic!() };
        // Each toe is that of a branch alone, mirrored for the other one.
        let toe = |(at, axis, radius): (DVec3, DVec3, f64)| {
            let degrees = axis.x.abs().atan2(axis.z).to_degrees();
            let w = with_seam(&format!(
                "[seam.branch]\nradius_mm = {radius}\nchord_radius_mm = {}\nangle_deg = {}\neccentricity_mm = {}\n",
                k.chord,
                90.0 - degrees,
                at.y
            ));
            w.seam().at(w.seam().s_of_phi(PI).unwrap()).point.x
        };
        let apart = toe(k.first) - (k.other.0.x - toe(k.other));
        assert!((apart - gap).abs() < 1e-8, "{apart} {gap}");
        let by_offset = k.keys.replace(&format!("gap_mm = {gap}"), &format!("offset_mm = {}", -k.other.0.x));
        assert_ne!(by_offset, k.keys);
        if let (Ok(a), Ok(b)) = (read(&k.keys), read(&by_offset)) {
            found += 1;
            assert!((a.seam().length() - b.seam().length()).abs() < 1e-6);
            assert_eq!(a.seam().knots().len(), b.seam().knots().len());
            assert!(gap < 1.0 || a.seam().knots().is_empty() || (k.first.0.y - k.other.0.y).abs() > 0.0);
        }
    }
    assert!(found > cases(100), "{found}");
}

#[test]
fn the_part_has_all_its_tubes() {
    let keys = "[seam.branch]\nradius_mm = 40\nchord_radius_mm = 100\nangle_deg = 50\n";
    let other = "[seam.branch.other]\nradius_mm = 45\nangle_deg = 60\ngap_mm = -25\n";
    for (text, names) in [
        (keys.to_owned(), vec!["branch", "chord"]),
        (format!("{keys}{other}"), vec!["branch", "other branch", "chord"]),
    ] {
        let w = with_seam(&text);
        let part = w.clamped(NO_STL).unwrap().part;
        assert_eq!(part.iter().map(Solid::name).collect::<Vec<_>>(), names);
        assert_eq!(w.seam().knots().len(), if names.len() == 3 { 2 } else { 0 });
        for i in 0..60 {
            let p = w.seam().at(w.seam().length() * (f64::from(i) + 0.5) / 60.0);
            assert!(distance(&part, p.point) < 1e-2);
            let near_corner = w.seam().knots().iter().any(|k| (k - p.s).abs() < 15.0);
            let (free, wide) = (distance(&part, p.point + 2.0 * p.bisector), 2.0 * (0.5 * p.dihedral).sin());
            assert!(near_corner || (free - wide).abs() < 0.1, "{free} for {wide} at {}", p.s);
            assert!(distance(&part, p.point - 1.0 * p.bisector) < 2e-3);
        }
    }
}

#[test]
fn mistakes_have_an_address_and_a_cure() {
    let keys = "[seam.branch]\nradius_mm = 40\nchord_radius_mm = 100\n";
    let check = |text: &str, key: &str, value: &str, allowed: &str| {
        let e = read(text).unwrap_err();
        assert_eq!((e.key.as_str(), e.value.as_str()), (key, value), "{e}");
        assert!(e.line > 0 && e.allowed.as_ref().is_some_and(|a| a.to_string().contains(allowed)), "{e}");
    };
    for radius in ["100", "120.5"] {
        let text = keys.replace("= 40", &format!("= {radius}"));
        check(&text, "seam.branch.radius_mm", radius, "less than chord_radius_mm = 100");
    }
    for angle in ["9.9", "171", "180"] {
        check(&format!("{keys}angle_deg = {angle}\n"), "seam.branch.angle_deg", angle, "10° to 170°");
    }
    for sideways in ["60", "-60", "150"] {
        let text = format!("{keys}eccentricity_mm = {sideways}\n");
        check(&text, "seam.branch.eccentricity_mm", sideways, "less than 60 mm");
    }
    for wall in ["40", "41"] {
        check(&format!("{keys}wall_mm = {wall}\n"), "seam.branch.wall_mm", wall, "less than radius_mm = 40");
    }
    let missing = read("[seam.branch]\nradius_mm = 40\n").unwrap_err();
    assert!(missing.to_string().contains("allowed: `chord_radius_mm = ...`, in mm"), "{missing}");
    let other = |more: &str| format!("{keys}angle_deg = 80\n[seam.branch.other]\n{more}");
    check(&other("radius_mm = 30\n"), "seam.branch.other", "", "exactly one of `gap_mm`");
    let both = other("radius_mm = 30\ngap_mm = 5\noffset_mm = 100\n");
    check(&both, "seam.branch.other.offset_mm", "100", "exactly one of `gap_mm`");
    check(&other("radius_mm = 130\ngap_mm = 5\n"), "seam.branch.other.radius_mm", "130", "chord_radius_mm = 100");
    check(&other("radius_mm = 30\ngap_mm = 5\nangle_deg = 5\n"), "seam.branch.other.angle_deg", "5", "10° to 170°");
    // Nearer to each other with height.
    check(
        &other("radius_mm = 30\ngap_mm = -5\nangle_deg = 120\n"),
        "seam.branch.other.angle_deg",
        "120",
        "less than 100° with the first branch at 80°",
    );
    check(
        &other("radius_mm = 30\ngap_mm = 5\neccentricity_mm = 70\n"),
        "seam.branch.other.eccentricity_mm",
        "70",
        "less than 70 mm",
    );
    // A branch wider than the one it overlaps by half would have to go round it.
    let astride = "[seam.branch]\nradius_mm = 70\nchord_radius_mm = 100\nangle_deg = 60\n[seam.branch.other]\nradius_mm = 20\nangle_deg = 60\ngap_mm = -60\n";
    check(astride, "seam.branch.other", "", "less overlap");
}
