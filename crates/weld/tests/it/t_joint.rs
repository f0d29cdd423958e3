//! T-joints: both fillets lie beside the web, for any middle line; mistakes have an address.

use crate::jobs::{WithSeam, changed, read, refusal};
use glam::DVec3;
use seamwright_program::TorchPath;

const TEXT: &str = include_str!("../../../../examples/t-joint.toml");

/// The middle line is the circle of radius R about (0, 0, -R); the fillets lie 1 mm beside it, in planes y = 1 and y
/// = -1.
#[test]
fn both_fillets_lie_beside_the_web() {
    let welding = read(TEXT);
    // Through (0, 0) and (600, -60.6).
    let radius = (600.0f64.powi(2) + 60.6f64.powi(2)) / (2.0 * 60.6);
    let seam = &welding.seam;
    let angle = 2.0 * (600.0 / radius).asin();
    assert!((seam.as_ref().unwrap().length() - radius * angle).abs() < 1e-6);
    let path = welding.path(0);
    for i in 0..=100 {
        let s = seam.as_ref().unwrap().length() * f64::from(i) / 100.0;
        let p = seam.as_ref().unwrap().at(s);
        let out = DVec3::new(p.point.x, 0.0, p.point.z + radius).normalize();
        assert!((p.point.y - 1.0).abs() < 1e-9);
        assert!(((p.point - DVec3::new(0.0, 1.0, -radius)).length() - radius).abs() < 1e-7);
        assert!((p.n2 - out).length() < 1e-9 && (p.n1 - DVec3::Y).length() < 1e-9);
        assert!((p.dihedral.to_degrees() - 90.0).abs() < 1e-9);
        let q = seam.as_ref().unwrap().across(&p).unwrap();
        assert!((q.point - (p.point - 2.0 * DVec3::Y)).length() < 1e-9 && (q.n1 + DVec3::Y).length() < 1e-9);
        // The two torches are each other's mirror image in the plane y = 0, 30 degrees above the skin.
        let (first, second) = (path.pose(s), path.second(s).unwrap());
        let mirrored = DVec3::new(first.direction.x, -first.direction.y, first.direction.z);
        assert!((second.direction - mirrored).length() < 1e-9);
        let across = (first.direction - first.direction.dot(p.tangent) * p.tangent).normalize();
        assert!((across.dot(-p.n2).asin().to_degrees() - 30.0).abs() < 1e-6);
    }
}

#[test]
fn one_fillet_straight_or_curved_sideways() {
    let straight =
        "start_mm = [0, 0, 0]\nend_mm = [500, 0, 0]\nskin_normal = [0, 0, 1]\nweb_mm = 4\nfillet = \"right\"\n";
    let head = TEXT.split("[seam.t_joint]").next().unwrap().to_owned();
    let rest = TEXT.split("[torch]").nth(1).unwrap().to_owned();
    let with = |seam: &str| read(&format!("{head}[seam.t_joint]\n{seam}[torch]{rest}"));
    let welding = with(straight);
    assert!(welding.path(0).second(3.0).is_none());
    let p = welding.seam().at(250.0);
    assert!((p.point - DVec3::new(250.0, -2.0, 0.0)).length() < 1e-9 && (p.n1 + DVec3::Y).length() < 1e-12);
    // Curved to the left in a flat skin: the left fillet is the inner one.
    let welding = with(
        &straight
            .replace(
                "end_mm = [500, 0, 0]",
                "end_mm = [500, 500, 0]\nvia_mm = [353.5533905932738, 146.44660940672622, 0]",
            )
            .replace("right", "left"),
    );
    assert!((welding.seam().length() - 498.0 * std::f64::consts::FRAC_PI_2).abs() < 1e-6);
    let p = welding.seam().at(100.0);
    assert!(
        ((p.point - DVec3::new(0.0, 500.0, 0.0)).length() - 498.0).abs() < 1e-9 && (p.n2 - DVec3::Z).length() < 1e-12
    );
}

#[test]
fn mistakes_have_an_address() {
    let wrong = |from: &str, to: &str| refusal(&changed(TEXT, &[(from, to)])).key;
    assert_eq!(wrong("via_mm = [0, 0, 0]", "via_mm = [0, 0, -60.6]"), "seam.t_joint.via_mm");
    assert_eq!(wrong("end_mm = [600, 0, -60.6]", "end_mm = [-600, 0, -60.6]"), "seam.t_joint.end_mm");
    assert_eq!(wrong("web_mm = 2", "web_mm = 0"), "seam.t_joint.web_mm");
    assert_eq!(wrong("fillet = \"both\"", "fillet = \"all\""), "seam.t_joint.fillet");
    assert_eq!(wrong("skin_normal = [-0.2, 0, 1]", "skin_normal = [1, 0, 0.202]"), "seam.t_joint.skin_normal");
    assert_eq!(wrong("[torch]", "[start]\nphi_deg = 3\n[torch]"), "start.phi_deg");
}
