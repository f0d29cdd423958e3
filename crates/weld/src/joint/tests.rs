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
            let slack = 1e-3 * radius * radius;
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

    /// Points of a grid that are in neither part and inside the line from toe to toe, found by angles only.
    #[test]
    fn t_bevels_agree_with_a_grid(
        t in 5.0..30.0f64, share in 0.0..0.5f64, gap in 0.0..4.0f64, degrees in 30.0..60.0f64,
        psi_deg in 65.0..150.0f64, leg in 0.0..10.0f64, second in any::<bool>(),
    ) {
        let (c, psi, phi) = (share * t, psi_deg.to_radians(), degrees.to_radians());
        let text = format!(
            "p.t_bevel = {{ thickness_mm = {t}, root_face_mm = {c}, root_gap_mm = {gap}, angle_deg = {degrees}, \
             leg_mm = {leg}, prepared = \"{}\" }}",
            if second { "second" } else { "first" }
        );
        let s = section(&text, Place { dihedral: psi, gap, mismatch: 0.0 });
        // Mirrored so that the prepared part is the first; then turned so that the other part's face is x < 0, the
        // torch above it: depth is x.
        let turn = DVec2::from_angle(-(0.5 * psi + FRAC_PI_2));
        let flip = |p: DVec2| if second { DVec2::new(-p.x, p.y) } else { p };
        let place = |p: DVec2| { let q = turn.rotate(flip(p)); DVec2::new(-q.x, -q.y) };
        let all: Vec<DVec2> = polygon(&s).into_iter().map(place).collect();
        prop_assert!((shoelace(&all).abs() - s.area()).abs() < 1e-9 * s.area());
        let low = all.iter().copied().reduce(DVec2::min).unwrap();
        let high = all.iter().copied().reduce(DVec2::max).unwrap();
        let toes = s.toes().map(place);
        let (depth, edge) = (t / psi.sin(), (t - c) / psi.sin());
        let n = 150;
        let (mut inside, step) = (0, (high - low) / f64::from(n));
        for i in 0..n {
            for k in 0..n {
                let p = low + DVec2::new(f64::from(i) + 0.5, f64::from(k) + 0.5) * step;
                let over_face = p.y > 0.0;
                // The standing part's outer surface goes up from the seam at the dihedral angle from the face.
                let behind_surface = p.y.atan2(-p.x) > psi;
                let cut = if p.x > edge { p.y < gap } else { (p.y - gap).max(0.0).atan2(edge - p.x) < phi || p.y < gap };
                let below = (toes[1] - toes[0]).perp_dot(p - toes[0]) * (toes[1] - toes[0]).perp_dot(DVec2::new(depth, 0.0) - toes[0]) > 0.0;
                inside += i32::from(over_face && (cut || !behind_surface) && below && p.x < depth);
            }
        }
        let grid = f64::from(inside) * step.x * step.y;
        prop_assert!((grid - s.area()).abs() < 0.03 * s.area() + 0.03, "{grid} {}", s.area());
    }
}

#[test]
fn flares_have_the_area_beside_the_circle() {
    let r = 10.0;
    let corner = Place { dihedral: FRAC_PI_2, gap: 0.0, mismatch: 0.0 };
    let one = r * r * (1.0 - PI / 4.0);
    for round in ["first", "second"] {
        let s = section(&format!("p.flare_bevel = {{ radius_mm = {r}, round = \"{round}\" }}"), corner);
        assert!((s.area() - one).abs() < 0.005 * one, "{} {one}", s.area());
    }
    let s = section(&format!("p.flare_v = {{ radius_mm = {r} }}"), flat(0.0));
    assert!((s.area() - 2.0 * one).abs() < 0.01 * one);
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
