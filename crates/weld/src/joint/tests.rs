//! Areas against the closed forms of handbooks, and against counting the points of a fine grid that are in no part.

use super::section::{NoGroove, Place, Section};
use glam::DVec2;
use proptest::prelude::*;
use seamwright_program::Joint;
use seamwright_testkit::{Random, cases};
use std::f64::consts::{FRAC_PI_2, PI};

/// The joint with the preparation `p` of a text, and its other keys.
fn joint(toml: &str) -> Joint {
    let text = toml.replacen("p.", "preparation.", 1);
    let file = seamwright_document::Document::<Joint>::read("f", &text).unwrap();
    file.value
}

fn flat(gap: f64) -> Place {
    Place { dihedral: PI, gap, mismatch: 0.0 }
}

fn section(toml: &str, place: Place) -> Section {
    Section::new(&joint(toml), place).unwrap_or_else(|e| panic!("{toml}: {e}"))
}

fn polygon(s: &Section) -> Vec<DVec2> {
    s.first.iter().chain(s.second.iter().rev()).copied().collect()
}

fn shoelace(points: &[DVec2]) -> f64 {
    0.5 * (0..points.len()).map(|i| points[i].perp_dot(points[(i + 1) % points.len()])).sum::<f64>()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn butt_areas_are_those_of_the_handbook(
        t in 2.0..60.0f64, share in 0.0..0.9f64, gap in 0.0..5.0f64, degrees in 5.0..80.0f64,
        radius in 0.5..8.0f64, land in 0.0..3.0f64,
    ) {
        let (c, a) = (share * t, degrees.to_radians());
        let h = t - c;
        let near = |s: &Section, area: f64| (s.area() - area).abs() < 1e-9 * area.max(1.0);
        let sizes = format!("thickness_mm = {t}, root_gap_mm = {gap}");
        let square = section(&format!("p.square = {{ {sizes} }}"), flat(gap.max(0.1)));
        prop_assert!(near(&square, gap.max(0.1) * t));
        let v = section(&format!("p.single_v = {{ {sizes}, root_face_mm = {c}, angle_deg = {degrees} }}"), flat(gap));
        prop_assert!(near(&v, gap * t + h * h * (0.5 * a).tan()));
        for prepared in ["first", "second"] {
            let text = format!(
                "p.bevel = {{ {sizes}, root_face_mm = {c}, angle_deg = {degrees}, prepared = \"{prepared}\" }}"
            );
            prop_assert!(near(&section(&text, flat(gap)), gap * t + 0.5 * h * h * a.tan()));
        }
        let beta = 0.4 * a;
        if radius * (1.0 - beta.sin()) < h {
            let deep = h - radius * (1.0 - beta.sin());
            let s = radius * radius * (PI / 4.0 - beta / 2.0 - (2.0 * beta).sin() / 4.0)
                + radius * beta.cos() * deep + 0.5 * deep * deep * beta.tan();
            let keys = format!(
                "{sizes}, root_face_mm = {c}, angle_deg = {}, radius_mm = {radius}, land_mm = {land}", 0.4 * degrees
            );
            let u = section(&format!("p.u = {{ {keys} }}"), flat(gap));
            let j = section(&format!("p.j = {{ {keys} }}"), flat(gap));
            // Arcs are chords here.
            let slack = 3e-5 * radius * radius;
            prop_assert!((u.area() - (gap * t + 2.0 * (land * h + s))).abs() < 2.0 * slack);
            prop_assert!((j.area() - (gap * t + land * h + s)).abs() < slack);
        }
    }

    #[test]
    fn fillets_have_their_legs_and_throat(z1 in 2.0..20.0f64, z2 in 2.0..20.0f64, degrees in 40.0..150.0f64) {
        let psi = degrees.to_radians();
        let place = Place { dihedral: psi, gap: 0.0, mismatch: 0.0 };
        let s = section(&format!("p.fillet = {{ first_leg_mm = {z1}, second_leg_mm = {z2} }}"), place);
        prop_assert!((s.area() - 0.5 * z1 * z2 * psi.sin()).abs() < 1e-9 * s.area());
        let [toe1, toe2] = s.toes();
        prop_assert!((toe1.length() - z1).abs() < 1e-12 && (toe2.length() - z2).abs() < 1e-12);
        prop_assert!(toe1.x > 0.0 && toe2.x < 0.0 && (toe1.angle_to(toe2) - psi).abs() < 1e-9);
        let throat = section(&format!("p.fillet = {{ throat_mm = {z1} }}"), place);
        // The throat is the height of the line from toe to toe over the seam.
        prop_assert!((throat.toes()[0].dot(throat.up) - z1).abs() < 1e-9);
        prop_assert!(throat.up.dot(DVec2::Y) > 1.0 - 1e-12);
    }
}

/// A groove of `peers/grooves.py`, which cuts the parts as solids.
#[derive(serde::Deserialize)]
struct Reference {
    preparation: String,
    dihedral_deg: f64,
    gap_mm: f64,
    mismatch_mm: f64,
    area_mm2: f64,
}

#[test]
fn areas_are_those_of_parts_cut_as_solids() {
    let all: Vec<Reference> = serde_json::from_str(include_str!("../../../../tests/data/grooves.json")).unwrap();
    assert!(all.len() >= 1000);
    let mut worst: f64 = 0.0;
    for r in &all {
        let place = Place { dihedral: r.dihedral_deg.to_radians(), gap: r.gap_mm, mismatch: r.mismatch_mm };
        let s = section(&r.preparation, place);
        let off = (s.area() / r.area_mm2 - 1.0).abs();
        assert!(off < 1e-3, "{} {place:?}: {} for {}", r.preparation, s.area(), r.area_mm2);
        assert!((shoelace(&polygon(&s)) / s.area() - 1.0).abs() < 1e-9);
        worst = worst.max(off);
    }
    println!("largest deviation of {} areas: {:.4} %", all.len(), 100.0 * worst);
}

#[test]
fn the_root_of_a_sloping_wall_lies_on_its_inside() {
    for psi in [50.0f64, 75.0, 90.0, 113.6, 140.0] {
        for kind in ["t_bevel = { angle_deg = 40,", "t_j = { angle_deg = 5, radius_mm = 2,"] {
            let text = format!("p.{kind} thickness_mm = 12, root_face_mm = 1.5, prepared = \"second\" }}");
            let (gap, dihedral) = (3.0, psi.to_radians());
            let s = section(&text, Place { dihedral, gap, mismatch: 0.0 });
            // The second part stands: its outside rises from the seam towards the left.
            let up = DVec2::new(-(0.5 * dihedral).sin(), (0.5 * dihedral).cos());
            let [root, face] = [s.second[0], s.first[0]];
            assert!(
                (up.perp_dot(root).abs() - 12.0).abs() < 1e-9 && (up.perp_dot(s.second[1]).abs() - 10.5).abs() < 1e-9
            );
            assert!((root - face - gap * up).length() < 1e-9, "{psi}");
        }
    }
}

#[test]
fn flares_have_the_area_beside_the_circle() {
    let r = 10.0;
    let corner = Place { dihedral: FRAC_PI_2, gap: 0.0, mismatch: 0.0 };
    let one = r * r * (1.0 - PI / 4.0);
    for round in ["first", "second"] {
        let s = section(&format!("p.flare_bevel = {{ radius_mm = {r}, round = \"{round}\" }}"), corner);
        assert!((s.area() - one).abs() < 2e-4 * one, "{} {one}", s.area());
    }
    let s = section(&format!("p.flare_v = {{ radius_mm = {r} }}"), flat(0.0));
    assert!((s.area() - 2.0 * one).abs() < 4e-4 * one);
    let less = section(&format!("p.flare_v = {{ radius_mm = {r}, unfilled_mm = 3 }}"), flat(0.0));
    assert!(less.area() < s.area() && less.slices.heights().0 > s.slices.heights().0);
}

#[test]
fn a_cut_of_one_angle_opens_with_the_dihedral_angle() {
    let at = |psi: f64| Place { dihedral: psi.to_radians(), gap: 2.0, mismatch: 0.0 };
    let p = joint("p.t_bevel = { thickness_mm = 12, cut_deg = 45, root_face_mm = 1 }");
    for psi in [70.0, 90.0, 101.5, 113.6] {
        let same = joint(&format!("p.t_bevel = {{ thickness_mm = 12, angle_deg = {}, root_face_mm = 1 }}", psi - 45.0));
        let [a, b] = [&p, &same].map(|p| Section::new(p, at(psi)).unwrap());
        assert!((a.area() - b.area()).abs() < 1e-9 && a.area() > 10.0);
    }
    assert!(matches!(Section::new(&p, at(40.0)), Err(NoGroove::Inside(_))));
}

#[test]
fn impossible_grooves_say_why() {
    let at = |psi: f64, gap: f64, mismatch: f64| Place { dihedral: psi.to_radians(), gap, mismatch };
    let no = |toml: &str, place: Place| Section::new(&joint(toml), place).unwrap_err();
    let wide = "p.t_bevel = { thickness_mm = 12, angle_deg = 60 }";
    assert!(matches!(no(wide, at(55.0, 0.0, 0.0)), NoGroove::NeverOut { .. }));
    assert!(matches!(no("p.fillet = { leg_mm = 5 }", at(180.0, 0.0, 0.0)), NoGroove::NoCorner(_)));
    assert!(matches!(no("p.square = { thickness_mm = 5 }", at(90.0, 1.0, 0.0)), NoGroove::NoButt(_)));
    assert!(matches!(no("p.square = { thickness_mm = 5 }", at(180.0, 0.0, 0.0)), NoGroove::Empty));
}

#[test]
fn mismatch_moves_one_edge() {
    let p = joint("p.single_v = { thickness_mm = 10, angle_deg = 60, root_gap_mm = 2, root_face_mm = 1 }");
    let at = |mismatch: f64| Section::new(&p, Place { dihedral: PI, gap: 2.0, mismatch }).unwrap();
    let (even, out) = (at(0.0), at(1.5));
    assert!(out.first == even.first);
    for (a, b) in out.second.iter().zip(&even.second) {
        assert!((*a - *b - DVec2::new(0.0, 1.5)).length() < 1e-12);
    }
    // The line from toe to toe slants by it.
    assert!((out.up.x / out.up.y - 1.5 / (out.toes()[0].x - out.toes()[1].x)).abs() < 1e-12);
}

/// The area of a symmetric butt groove `deep` mm deep with this half width at a depth, by the midpoint rule.
fn swept_area(deep: f64, half_width: impl Fn(f64) -> f64) -> f64 {
    let steps = 20_000;
    let step = deep / f64::from(steps);
    (0..steps).map(|i| 2.0 * half_width((f64::from(i) + 0.5) * step) * step).sum()
}

#[test]
fn both_sides_of_a_double_preparation_fill_it() {
    let mut random = Random::new(46);
    for _ in 0..2000 {
        let t = random.within(12.0, 80.0);
        let (c, gap, angle, back) = (
            random.within(0.0, 0.2) * t,
            random.within(0.0, 4.0),
            random.within(10.0, 80.0),
            random.within(10.0, 80.0),
        );
        let depth = random.within(0.2, 0.8) * (t - c);
        let other = t - c - depth;
        let sizes = format!("thickness_mm = {t}, root_gap_mm = {gap}, root_face_mm = {c}, depth_mm = {depth}");
        let tan = |degrees: f64| degrees.to_radians().tan();
        let area =
            |kind: &str, side: &str| section(&format!("{kind}, {sizes} }}\nside = \"{side}\""), flat(gap)).area();
        let v = format!("p.double_v = {{ angle_deg = {angle}, back_angle_deg = {back}");
        let near =
            |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-9 * wanted, "{v} {sizes}: {found} {wanted}");
        near(area(&v, "face"), gap * (depth + c) + depth * depth * tan(0.5 * angle));
        near(area(&v, "back"), gap * other + other * other * tan(0.5 * back));
        let bevel = format!("p.double_bevel = {{ angle_deg = {angle}, back_angle_deg = {back}");
        near(area(&bevel, "face"), gap * (depth + c) + 0.5 * depth * depth * tan(angle));
        near(area(&bevel, "back"), gap * other + 0.5 * other * other * tan(back));
        let square = Place { dihedral: FRAC_PI_2, gap, mismatch: 0.0 };
        let k = format!("p.t_double_bevel = {{ angle_deg = {angle}, back_angle_deg = {back}, {sizes} }}\nside = ");
        near(section(&format!("{k}\"face\""), square).area(), gap * (depth + c) + 0.5 * depth * depth * tan(angle));
        near(section(&format!("{k}\"back\""), square).area(), gap * other + 0.5 * other * other * tan(back));
        let v = section(&format!("p.single_v = {{ thickness_mm = {t}, angle_deg = 60 }}"), flat(0.0)).area();
        let x = format!("p.double_v = {{ thickness_mm = {t}, angle_deg = 60 }}");
        near(2.0 * section(&x, flat(0.0)).area(), 0.5 * v);
    }
}

#[test]
fn a_gouged_back_is_the_wider_of_gouge_and_preparation() {
    let mut random = Random::new(47);
    for _ in 0..2000 {
        let (t, gap, angle) = (random.within(15.0, 60.0), random.within(0.0, 8.0), random.within(20.0, 80.0));
        let (radius, side) = (random.within(1.0, 8.0), random.within(0.0, 40.0));
        let gouge = random.within(0.1, 0.45) * t;
        let deep = 0.5 * t + gouge;
        let text = format!(
            "side = \"back\"\ngouge = {{ depth_mm = {gouge}, radius_mm = {radius}, angle_deg = {side} }}\n\
             [preparation.double_v]\nthickness_mm = {t}\nangle_deg = {angle}\nroot_gap_mm = {gap}"
        );
        let (slope, sin) = (side.to_radians().tan(), side.to_radians().sin());
        let of_gouge = |above: f64| {
            let end = radius * (1.0 - sin);
            let round = |h: f64| (h * (2.0 * radius - h)).max(0.0).sqrt();
            if above < end { round(above) } else { round(end) + (above - end) * slope }
        };
        let of_v = |above: f64| {
            let h = above - gouge;
            if h < 0.0 { 0.0 } else { 0.5 * gap + h * (0.5 * angle).to_radians().tan() }
        };
        let wanted = swept_area(deep, |above| of_gouge(above).max(of_v(above)));
        let found = section(&text, flat(gap));
        let off = (found.area() / wanted - 1.0).abs();
        assert!(off < 5e-4, "{text}: {} {wanted}", found.area());
        assert!((shoelace(&polygon(&found)) / found.area() - 1.0).abs() < 1e-9);
        assert!((found.up.dot(found.first[0]) + deep).abs() < 1e-9, "{text}");
    }
}

#[test]
fn an_outside_corner_has_the_groove_of_its_square_ends() {
    for degrees in [225.0f64, 250.0, 270.0, 300.0] {
        let place = Place { dihedral: degrees.to_radians(), gap: 0.0, mismatch: 0.0 };
        let s = section("p.corner = { thickness_mm = 8 }", place);
        // Both ends, as long as the wall is thick, meet at the inner corner.
        let wanted = 0.5 * 64.0 * (degrees.to_radians() - PI).sin();
        assert!((s.area() - wanted).abs() < 1e-9, "{degrees}: {} {wanted}", s.area());
        for edge in [&s.first, &s.second] {
            assert!((edge[0].distance(*edge.last().unwrap()) - 8.0).abs() < 1e-9);
        }
        let open = section("p.corner = { thickness_mm = 8 }", Place { gap: 2.0, ..place });
        let apart = open.first[0].distance(open.second[0]);
        assert!((apart - 2.0).abs() < 1e-9 && open.area() > s.area() + 4.0, "{degrees}: {apart} {}", open.area());
    }
    let inside = Place { dihedral: FRAC_PI_2, gap: 0.0, mismatch: 0.0 };
    assert!(matches!(Section::new(&joint("p.corner = { thickness_mm = 8 }"), inside), Err(NoGroove::NoButt(_))));
    let nearly_flat = Place { dihedral: PI, ..inside };
    let corner = joint("p.corner = { thickness_mm = 8 }");
    assert!(matches!(Section::new(&corner, nearly_flat), Err(NoGroove::NoOutsideCorner(_))));
}

#[test]
fn a_lap_is_a_fillet_along_the_edge() {
    let place = Place { dihedral: FRAC_PI_2, gap: 1.0, mismatch: 0.0 };
    let s = section("p.lap = { thickness_mm = 6, leg_mm = 5, root_gap_mm = 1 }", place);
    assert!((s.area() - 0.5 * 5.0 * 6.0).abs() < 1e-9);
}

/// The directions in which a ray from `at` leaves the groove past everything `beyond`, by trying them.
fn free_by_rays(section: &Section, at: DVec2, beyond: f64) -> Option<[f64; 2]> {
    let half = 0.5 * section.dihedral;
    let face = |sense: f64| DVec2::new(sense * half.sin(), half.cos());
    let mut lines: Vec<[DVec2; 2]> = Vec::new();
    for (edge, sense) in [(&section.first, 1.0), (&section.second, -1.0)] {
        lines.extend(edge.windows(2).map(|pair| [pair[0], pair[1]]));
        let toe = edge[edge.len() - 1];
        lines.push([toe, toe + 1e5 * face(sense)]);
    }
    let is_free = |angle: f64| {
        let unit = DVec2::new(angle.sin(), angle.cos());
        let (at, way) = (at + beyond * unit, 1e5 * unit);
        lines.iter().all(|[a, b]| {
            let (side, other) = ((*b - *a).perp_dot(at - *a), (*b - *a).perp_dot(at + way - *a));
            let (from, to) = (way.perp_dot(*a - at), way.perp_dot(*b - at));
            side * other > 0.0 || from * to > 0.0
        })
    };
    let angles: Vec<f64> = (-1500..=1500).map(|k| f64::from(k) * 1e-3).filter(|a| is_free(*a)).collect();
    // One stretch of angles, or the comparison says nothing.
    let is_one = angles.windows(2).all(|pair| pair[1] - pair[0] < 1.5e-3);
    Some([*angles.first()?, *angles.last()?]).filter(|_| is_one)
}

#[test]
fn free_angles_are_those_of_rays_out_of_the_groove() {
    let mut random = Random::new(8);
    let mut tried = 0;
    for _ in 0..cases(4000) {
        let thickness = random.within(6.0, 60.0);
        let (angle, radius) = (random.within(2.0, 20.0), random.within(3.0, 5.5));
        let (face, leg) = (random.within(0.5, 2.0), random.within(0.0, 10.0));
        let part = if random.yes() { "first" } else { "second" };
        let joint = joint(&format!(
            "p.t_j = {{ thickness_mm = {thickness}, angle_deg = {angle}, radius_mm = {radius}, root_gap_mm = 2, \
             root_face_mm = {face}, leg_mm = {leg}, prepared = \"{part}\" }}\ncap_mm = 1"
        ));
        let place = Place { dihedral: random.within(60.0, 130.0f64).to_radians(), gap: 2.0, mismatch: 0.0 };
        let Ok(section) = Section::new(&joint, place) else { continue };
        let (low, high) = section.slices.heights();
        let height = random.within(low + 0.02 * (high - low), high - 0.02 * (high - low));
        let (left, right) = section.slices.edges(height);
        let at = section.place(left + random.within(0.1, 0.9) * (right - left), height);
        let beyond = random.within(0.0, 20.0);
        let Some(by_rays) = free_by_rays(&section, at, beyond) else { continue };
        tried += 1;
        for (found, by_rays) in section.free_angles(at, beyond).into_iter().zip(by_rays) {
            assert!((found - by_rays).abs() < 2e-3, "{found} for {by_rays} at {at}, beyond {beyond}: {section:?}");
        }
    }
    assert!(tried > 500, "{tried}");
}
