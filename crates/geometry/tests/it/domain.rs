//! Nozzles that do not fit their body are refused with the reason.

use glam::DVec3;
use seamwright_geometry::{Error, Quadric, Tube, TubeIntersection};

fn on(body: Result<Quadric, Error>, origin: DVec3, direction: DVec3, radius: f64) -> Result<TubeIntersection, Error> {
    TubeIntersection::new(Tube::new(origin, direction, DVec3::X, radius).unwrap(), body.unwrap())
}

fn shell() -> Result<Quadric, Error> {
    Quadric::cylinder(DVec3::ZERO, DVec3::X, 800.0)
}

#[test]
fn what_does_not_meet_its_body_all_round_is_refused_with_the_reason() {
    let (o, z) = (DVec3::ZERO, DVec3::Z);
    assert_eq!(on(Quadric::sphere(o, 100.0), o, z, 250.0), Err(Error::TubeLargerThanBody));
    assert_eq!(on(shell(), DVec3::new(0.0, 2000.0, 0.0), z, 250.0), Err(Error::TubeBesideBody));
    assert!(matches!(on(shell(), DVec3::new(0.0, 700.0, 0.0), z, 250.0), Err(Error::NotClosed { .. })));
    assert_eq!(on(Quadric::plane(o, z), o, -z + DVec3::Y * 0.1, 20.0), Err(Error::NeverLeaves));
    // Along the shell's axis the nozzle never meets it.
    assert_eq!(on(Quadric::cylinder(o, z, 800.0), o, z, 20.0), Err(Error::NeverLeaves));
}

#[test]
fn larger_than_the_shell_does_not_close() {
    let Err(Error::NotClosed { from, to }) = on(shell(), DVec3::ZERO, DVec3::Z, 900.0) else { panic!() };
    let half = (800.0f64 / 900.0).asin();
    assert!((from - half).abs() < 1e-9 && (to - (std::f64::consts::PI - half)).abs() < 1e-9);
}

#[test]
fn equal_diameters_have_a_corner() {
    let Err(Error::Tangent { at }) = on(shell(), DVec3::ZERO, DVec3::Z, 800.0) else { panic!() };
    assert!((at.sin().abs() - 1.0).abs() < 1e-5);
    assert!(on(shell(), DVec3::ZERO, DVec3::Z, 799.9).is_ok());
    assert!(on(shell(), DVec3::ZERO, DVec3::Z, 800.000_01).is_err());
}

#[test]
fn a_little_larger_than_the_shell_is_seen_between_samples() {
    // The wall misses the shell only within a fraction of a degree, turned away from every sample.
    for turn in [0.0, 0.003, 0.0071, 0.0113, 0.0171] {
        for excess in [1e-4, 1e-6, 1e-8] {
            let zero = DVec3::new(f64::cos(turn), f64::sin(turn), 0.0);
            let tube = Tube::new(DVec3::ZERO, DVec3::Z, zero, 800.0 * (1.0 + excess)).unwrap();
            let found = TubeIntersection::new(tube, shell().unwrap());
            assert!(
                matches!(found, Err(Error::NotClosed { .. } | Error::Tangent { .. })),
                "{turn} {excess}: {found:?}"
            );
        }
    }
}

#[test]
fn a_nozzle_across_a_cones_apex_does_not_close() {
    let cone = || Quadric::cone(DVec3::ZERO, -DVec3::Z, 0.5);
    // Straight down on the tip: closed, below the apex.
    let tip = on(cone(), DVec3::ZERO, DVec3::Z, 20.0).unwrap();
    let z = -20.0 / 0.5f64.tan();
    for i in 0..20 {
        let p = seamwright_geometry::Curve::point(&tip, f64::from(i));
        assert!((p.z - z).abs() < 1e-9);
    }
    // Sideways across the apex: part of the wall is above it.
    assert!(on(cone(), DVec3::ZERO, DVec3::Y, 20.0).is_err());
}
