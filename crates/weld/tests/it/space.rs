//! Helices against closed forms of our own, about axes that lie anyhow.

use crate::jobs::{WithSeam, refused_key, vector, with_seam};
use glam::{DMat3, DVec3};
use proptest::prelude::*;
use std::f64::consts::TAU;

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn helices(
        radius in 5.0..800.0f64, pitch in 1.0..300.0f64, left_handed in any::<bool>(), turns in 0.05..6.0f64,
        origin in prop::array::uniform3(-500.0..500.0f64), turn in prop::array::uniform3(-1.0..1.0f64), joint in 0..3,
    ) {
        prop_assume!(DVec3::from(turn).length() > 0.1);
        let axes = DMat3::from_axis_angle(DVec3::from(turn).normalize(), 3.0 * turn[0]);
        let pitch = if left_handed { -pitch } else { pitch };
        let words = ["joint = \"butt\"", "joint = \"fillet\"", "wall_faces = \"left\""][joint as usize];
        let w = with_seam(&format!(
            "[seam.helix]\nradius_mm = {radius:?}\npitch_mm = {pitch:?}\nturns = {turns:?}\norigin_mm = {}\ndirection = {}\n\
             zero_direction = {}\n{words}",
            vector(origin.into()), vector(2.0 * axes.z_axis), vector(axes.x_axis + 0.4 * axes.z_axis)
        ));
        prop_assert!((w.seam().length() - turns * (TAU * radius).hypot(pitch)).abs() < 1e-9);
        for i in 0..20 {
            let part = f64::from(i) / 19.0;
            let phi = TAU * turns * part;
            let p = w.seam().at(part * w.seam().length());
            let out = axes * DVec3::new(phi.cos(), phi.sin(), 0.0);
            let exact = DVec3::from(origin) + radius * out + part * turns * pitch * axes.z_axis;
            prop_assert!((p.point - exact).length() < 1e-9, "{}", (p.point - exact).length());
            let tangent = (TAU * radius * axes.z_axis.cross(out) + pitch * axes.z_axis) / (TAU * radius).hypot(pitch);
            prop_assert!((p.tangent - tangent).length() < 1e-9 && (p.n2 - out).length() < 1e-9);
            let n1 = [out, tangent.cross(out), out.cross(tangent)][joint as usize];
            prop_assert!((p.n1 - n1).length() < 1e-9 && (p.bisector - (n1 + out).normalize()).length() < 1e-9);
            prop_assert!((p.phi.unwrap() - phi).abs() < 1e-9);
            prop_assert!((w.seam().s_of_phi(phi).unwrap() - p.s).abs() < 1e-8);
        }
        prop_assert!(w.seam().s_of_phi(TAU * turns + 0.01).is_none() && w.seam().s_of_phi(-0.01).is_none());
        prop_assert!(!w.seam().all_round());
        // The cylinder is there, and ends beyond the seam.
        let part = w.clamped(&|_| Err(std::io::ErrorKind::NotFound.into())).unwrap().part;
        prop_assert!(part.len() == 1 && part[0].name() == "cylinder");
    }
}

#[test]
fn mistakes_have_an_address() {
    let helix = "[seam.helix]\nradius_mm = 50\npitch_mm = 20\nturns = 2\n";
    with_seam(helix);
    assert_eq!(refused_key(&helix.replace("= 20", "= 0")), "seam.helix.pitch_mm");
    assert_eq!(refused_key(&helix.replace("= 2\n", "= 0\n")), "seam.helix.turns");
    assert_eq!(refused_key(&helix.replace("= 2\n", "= 2000\n")), "seam.helix.turns");
    assert_eq!(refused_key(&helix.replace("= 50", "= -50")), "seam.helix.radius_mm");
    assert_eq!(refused_key(&format!("{helix}zero_direction = [0, 0, 1]")), "seam.helix.zero_direction");
    assert_eq!(refused_key(&format!("{helix}[start]\nphi_deg = 90")), "start.phi_deg");
    assert_eq!(refused_key(&format!("{helix}[start]\nend_phi_deg = 90")), "start.end_phi_deg");
}
