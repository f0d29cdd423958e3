//! The part made from its seam: the seam lies on it, the air before the joint is free, the metal behind it is not.

use crate::jobs::{WithSeam, read};
use glam::{DAffine3, DVec3};
use proptest::prelude::*;
use seamwright_clearance::{Shape, Solid, nearest};
use seamwright_document::DocumentError;
use seamwright_program::TorchPath;
use seamwright_weld::Welding;

pub(crate) const NO_STL: &dyn Fn(&str) -> std::io::Result<Vec<u8>> = &|_| Err(std::io::ErrorKind::NotFound.into());

const EXAMPLES: [&str; 8] = [
    include_str!("../../../../examples/saddle.toml"),
    include_str!("../../../../examples/head-nozzle.toml"),
    include_str!("../../../../examples/ellipse.toml"),
    include_str!("../../../../examples/trunnion-saddle.toml"),
    include_str!("../../../../examples/oblique-girth.toml"),
    include_str!("../../../../examples/t-joint.toml"),
    include_str!("../../../../examples/knuckle-nozzle.toml"),
    include_str!("../../../../examples/tube-plate.toml"),
];

/// Distance of a point from the part, by a tiny ball.
pub(crate) fn distance(part: &[Solid], at: DVec3) -> f64 {
    let ball = Solid::new("ball", Shape::Sphere { radius: 1e-3 }, DAffine3::from_translation(at)).unwrap();
    let one = |s: &Solid| nearest(&ball, &DAffine3::IDENTITY, s, &DAffine3::IDENTITY, 1e4).map_or(1e4, |n| n.distance);
    part.iter().map(one).fold(f64::INFINITY, f64::min) + 1e-3
}

/// Checks the part along the seam. `within` is the maximum error of its meshes, mm.
fn check(welding: &Welding, within: f64) {
    let clamped = welding.clamped(NO_STL).unwrap();
    let placement = welding.path(0).along_seam().unwrap().placement;
    for i in 0..24 {
        // Except at the very ends of an open seam, where the part ends too.
        let p = welding.seam().at(welding.seam().weld_length() * (0.02 + 0.04 * f64::from(i)));
        let (at, out) = (placement.transform_point3(p.point), placement.transform_vector3(p.bisector));
        assert!((at - welding.path(0).pose(p.s).point).length() < 1e-9);
        let touched = distance(&clamped.part, at);
        assert!(touched <= 2e-3 + within, "{touched} at s = {}", p.s);
        for d in [1.0, 3.0] {
            let free = distance(&clamped.part, at + d * out);
            let expected = d * (0.5 * p.dihedral).sin();
            assert!((free - expected).abs() < within + 0.02 * d * d, "{free} for {expected} at s = {}", p.s);
            assert!(distance(&clamped.part, at - d * out) <= 1.1e-3, "solid behind the joint at s = {}", p.s);
        }
    }
}

#[test]
fn the_examples_seams_lie_on_their_parts() {
    for text in EXAMPLES {
        let welding = read(text);
        // The head is a mesh that lies up to 0.1 mm outside.
        check(&welding, if text.contains("ellipsoid") || text.contains("_head") { 0.15 } else { 0.03 });
        if text.contains("joint = \"butt\"") {
            check(&read(&text.replace("\"butt\"", "\"fillet\"")), 0.03);
        }
        let unwatched = if text.contains("[part]") {
            text.replace("[part]", "[part]\nwatched = false")
        } else {
            text.to_owned() + "[part]\nwatched = false\n"
        };
        assert!(read(&unwatched).clamped(NO_STL).unwrap().part.is_empty());
    }
    let seam = |seam: &str| format!("schema = 1\ntitle = \"t\"\nmachine = \"m\"\n{seam}[weld]\nspeed_mm_s = 5\n");
    for text in [
        "[seam.circle]\nradius_mm = 30\nnormal = [0, 1, 2]\n",
        "[seam.circle]\nradius_mm = 30\ncentre_mm = [5, 6, 7]\njoint = \"butt\"\n",
        "[seam.arc]\nstart_mm = [80, 0, 5]\nvia_mm = [0, 80, 5]\nend_mm = [-80, 0, 5]\n",
        "[seam.arc]\nstart_mm = [80, 0, 5]\nvia_mm = [0, 80, 5]\nend_mm = [-80, 0, 5]\nwall_faces = \"left\"\n",
        "[seam.arc]\nstart_mm = [80, 0, 5]\nvia_mm = [0, 80, 5]\nend_mm = [-80, 0, 5]\njoint = \"butt\"\n",
        "[seam.rounded_rectangle]\nwidth_mm = 200\nheight_mm = 90\ncorner_mm = 45\nnormal = [1, 1, 1]\n",
        "[seam.polyline]\npoints_mm = [[0, 0, 9], [70, 0, 9], [70, 90, 9]]\njoint = \"butt\"\n",
    ] {
        check(&read(&seam(text)), 0.03);
    }
    let line = |normals: &str| {
        format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [1, 2, 3]\nend_mm = [201, 2, 3]\n{normals}[weld]\nspeed_mm_s = 5\n"
        )
    };
    for normals in [
        "first_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n",
        "first_normal = [0, 1, 1]\nsecond_normal = [0, -1, 3]\n",
        "first_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n",
    ] {
        check(&read(&line(normals)), 0.01);
    }
    let (cone, plane, sphere) = (
        "[seam.nozzle.body.cone]\nhalf_angle_deg = 30\naxis = [0, 0, -1]\napex_mm = [0, 0, 400]\n",
        "[seam.nozzle.body.plane]\nnormal = [0, 0.2, 1]\n",
        "[seam.nozzle.body.sphere]\nradius_mm = 300\n",
    );
    for body in [cone, plane, sphere] {
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 60\norigin_mm = [0, 100, 0]\n{body}[weld]\nspeed_mm_s = 5\n"
        );
        check(&read(&text), 0.01);
    }
    for (direction, origin) in [("[1, 0, 0]", "[0, 0, 0]"), ("[0.3, 0.2, 1]", "[330, 0, 0]")] {
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 40\norigin_mm = {origin}\n\
             direction = {direction}\nzero_direction = [0, 1, 0]\n[seam.nozzle.body.torus]\nbend_radius_mm = 300\n\
             radius_mm = 100\n[weld]\nspeed_mm_s = 5\n"
        );
        check(&read(&text), 0.15);
    }
    for head in [
        "[seam.nozzle.body.flat_head]\nthickness_mm = 10\nknuckle_radius_mm = 40\n",
        "[seam.nozzle.body.conical_head]\nthickness_mm = 10\nknuckle_radius_mm = 60\nhalf_angle_deg = 60\n",
        "[seam.nozzle.body.hemispherical_head]\n",
        "[seam.nozzle.body.ellipsoidal_head]\n",
        "[seam.nozzle.body.torispherical_head]\nthickness_mm = 6\nstandard = \"din_28013\"\n",
    ] {
        for (lean, across) in [(0.0, 100.0), (0.8, 160.0), (1.2, 200.0)] {
            let text = format!(
                "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 40\norigin_mm = [{across}, 0, 0]\n\
                 direction = [{lean}, 0, 1]\n{head}outer_diameter_mm = 500\nflange_mm = 100\n[weld]\nspeed_mm_s = 5\n"
            );
            check(&read(&text), 0.15);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Random nozzles on shells, tilted, offset and placed anywhere.
    #[test]
    fn random_nozzles_lie_on_their_parts(
        radius in 10.0..150.0f64, shell in 200.0..900.0f64, offset in -100.0..100.0f64, lean in -0.5..0.5f64,
        shift in prop::array::uniform3(-500.0..500.0f64), turn in prop::array::uniform3(-1.0..1.0f64), angle in -180.0..180.0f64,
    ) {
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[placement]\nmove_mm = {shift:?}\nturn = {turn:?}\nangle_deg = {angle}\n\
             [seam.nozzle]\nradius_mm = {radius}\norigin_mm = [0, {offset}, 0]\ndirection = [{lean}, 0, 1]\n\
             [seam.nozzle.body.cylinder]\nradius_mm = {shell}\n[weld]\nspeed_mm_s = 5\n"
        );
        // The whole wall must meet the shell, and not at a glancing angle, where flat faces are too coarse for the
        // curvature.
        prop_assume!(offset.abs() + radius < 0.8 * shell);
        check(&read(&text), 0.03);
    }
}

/// One added box must never make the collision check forget nozzle and shell.
#[test]
fn a_body_that_is_added_does_not_take_the_place_of_the_part() {
    let part = |more: &str| read(&(EXAMPLES[0].to_owned() + more)).clamped(NO_STL);
    let names = |more: &str| -> Vec<String> { part(more).unwrap().part.iter().map(|s| s.name().to_owned()).collect() };
    let solids = "[[part.solids]]\nname = \"lug\"\nshape.box = { size_mm = [40, 40, 40] }\n";
    let mut made = names("");
    assert!(made.len() >= 2, "{made:?}");
    made.insert(0, "lug".to_owned());
    assert_eq!(names(solids), made);
    assert_eq!(names(&format!("[part]\nreplace = true\n{solids}")), ["lug"]);
    assert!(names(&format!("[part]\nwatched = false\n{solids}")).is_empty());
    assert_eq!(part("[part]\nreplace = true\n").unwrap_err().key, "part.replace");
}

#[test]
fn a_part_that_is_left_out_needs_no_files() {
    let solids = "[[part.solids]]\nshape.stl = { file = \"gone.stl\" }\n";
    let job = format!("{}[part]\nwatched = false\n{solids}", EXAMPLES[0]);
    assert!(read(&job).clamped(NO_STL).unwrap().part.is_empty());
}

#[test]
fn solids_are_given_or_refused_with_their_address() {
    let with = |more: &str, load: &dyn Fn(&str) -> std::io::Result<Vec<u8>>| {
        Welding::read("job.toml", &(EXAMPLES[0].to_owned() + more)).and_then(|w| w.clamped(load))
    };
    let error = |more: &str| -> DocumentError {
        let e = with(more, NO_STL).unwrap_err();
        println!("{e}");
        e
    };
    let clamped = with("[[part.solids]]\nshape.box = { size_mm = [1, 2, 3] }\n[[fixtures]]\nname = \"clamp\"\nshape.sphere = { radius_mm = 4 }\nat = { move_mm = [1, 2, 3] }\n[clearance]\nleast_mm = 2\n", NO_STL).unwrap();
    assert!(clamped.part.len() == 3 && clamped.fixtures.len() == 1 && (clamped.least_mm - 2.0).abs() < 1e-15);
    // The part moves with the placement, fixtures are in the work frame.
    assert!((clamped.part[0].pose().translation - DVec3::new(0.0, 0.0, -800.0)).length() < 1e-12);
    assert!((clamped.fixtures[0].pose().translation - DVec3::new(1.0, 2.0, 3.0)).length() < 1e-12);
    assert_eq!(error("[[part.solids]]\nshape.stl = { file = \"gone.stl\" }\n").key, "part.solids[0].shape.stl.file");
    assert_eq!(
        error("[[fixtures]]\nshape.cylinder = { radius_mm = -1, length_mm = 3 }\n").key,
        "fixtures[0].shape.cylinder.radius_mm"
    );
    assert_eq!(error("[part]\nnozzle_length_mm = 0\n").key, "part.nozzle_length_mm");
    assert_eq!(error("[clearance]\nleast_mm = 0\n").key, "clearance.least_mm");
    assert_eq!(error("[part]\nnozzle_lenght_mm = 5\n").key, "part.nozzle_lenght_mm");
    let open = with("[[part.solids]]\nshape.stl = { file = \"open.stl\" }\n", &|_| {
        Ok(b"solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n".to_vec())
    });
    assert!(open.unwrap_err().to_string().contains("not closed"));
}
