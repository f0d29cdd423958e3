//! Areas against the closed forms of handbooks, and against counting the points of a fine grid that are in no part.

use super::section::{NoGroove, Place, Section};
use glam::DVec2;
use proptest::prelude::*;
use seamwright_program::Preparation;
use std::f64::consts::{FRAC_PI_2, PI};

fn preparation(toml: &str) -> Preparation {
    #[derive(serde::Deserialize)]
    struct File {
        p: Preparation,
    }
    let file: File = seamwright_document::Document::<serde_json::Value>::read("f", toml)
        .map(|d| serde_json::from_value(d.value).unwrap())
        .unwrap();
    file.p
}

fn flat(gap: f64) -> Place {
    Place { dihedral: PI, gap, mismatch: 0.0 }
}

fn section(toml: &str, place: Place) -> Section {
    Section::new(&preparation(toml), 0.0, place).unwrap_or_else(|e| panic!("{toml}: {e}"))
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
    let p = preparation("p.t_bevel = { thickness_mm = 12, cut_deg = 45, root_face_mm = 1 }");
    for psi in [70.0, 90.0, 101.5, 113.6] {
        let same =
            preparation(&format!("p.t_bevel = {{ thickness_mm = 12, angle_deg = {}, root_face_mm = 1 }}", psi - 45.0));
        let [a, b] = [&p, &same].map(|p| Section::new(p, 0.0, at(psi)).unwrap());
        assert!((a.area() - b.area()).abs() < 1e-9 && a.area() > 10.0);
    }
    assert!(matches!(Section::new(&p, 0.0, at(40.0)), Err(NoGroove::Inside(_))));
}

#[test]
fn impossible_grooves_say_why() {
    let at = |psi: f64, gap: f64, mismatch: f64| Place { dihedral: psi.to_radians(), gap, mismatch };
    let no = |toml: &str, place: Place| Section::new(&preparation(toml), 0.0, place).unwrap_err();
    let wide = "p.t_bevel = { thickness_mm = 12, angle_deg = 60 }";
    assert!(matches!(no(wide, at(55.0, 0.0, 0.0)), NoGroove::NeverOut { .. }));
    assert!(matches!(no("p.fillet = { leg_mm = 5 }", at(180.0, 0.0, 0.0)), NoGroove::NoCorner(_)));
    assert!(matches!(no("p.square = { thickness_mm = 5 }", at(90.0, 1.0, 0.0)), NoGroove::NoButt(_)));
    assert!(matches!(no("p.square = { thickness_mm = 5 }", at(180.0, 0.0, 0.0)), NoGroove::Empty));
}

#[test]
fn mismatch_moves_one_edge() {
    let p = preparation("p.single_v = { thickness_mm = 10, angle_deg = 60, root_gap_mm = 2, root_face_mm = 1 }");
    let at = |mismatch: f64| Section::new(&p, 0.0, Place { dihedral: PI, gap: 2.0, mismatch }).unwrap();
    let (even, out) = (at(0.0), at(1.5));
    assert!(out.first == even.first);
    for (a, b) in out.second.iter().zip(&even.second) {
        assert!((*a - *b - DVec2::new(0.0, 1.5)).length() < 1e-12);
    }
    // The line from toe to toe slants by it.
    assert!((out.up.x / out.up.y - 1.5 / (out.toes()[0].x - out.toes()[1].x)).abs() < 1e-12);
}
