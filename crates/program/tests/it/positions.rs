//! Welding positions against welds that are turned into position, and against a second copy of the table.

use glam::{DQuat, DVec3};
use seamwright_program::WeldingPosition::{Pa, Pb, Pc, Pd, Pe, Pf, Pg};
use seamwright_program::{FilletOrButt, Inclination, PositionLimits, PositionStretch, WeldingPosition};
use seamwright_testkit::{Random, cases};

const JOINTS: [FilletOrButt; 2] = [FilletOrButt::Butt, FilletOrButt::Fillet];

/// A weld along x with its face up, first turned about its axis, then tilted uphill, then about the plumb line.
fn turned(slope_deg: f64, rotation_deg: f64, heading: f64) -> (DVec3, DVec3) {
    let rotate = DQuat::from_rotation_x(rotation_deg.to_radians());
    let tilt = DQuat::from_rotation_y(-slope_deg.to_radians());
    let place = DQuat::from_rotation_z(heading) * tilt * rotate;
    (place * DVec3::X, place * DVec3::Z)
}

fn inclination(slope_deg: f64, rotation_deg: f64) -> Inclination {
    Inclination { slope: slope_deg.to_radians(), rotation: rotation_deg.to_radians() }
}

fn position(joint: FilletOrButt, slope_deg: f64, rotation_deg: f64) -> WeldingPosition {
    PositionLimits::default().position(joint, inclination(slope_deg, rotation_deg))
}

#[test]
fn slope_and_rotation_are_those_a_weld_was_turned_by() {
    let mut random = Random::new(1);
    for _ in 0..cases(20_000) {
        let (slope, rotation) = (random.within(-89.0, 89.0), random.within(-180.0, 180.0));
        let (tangent, face) = turned(slope, rotation, random.within(-4.0, 4.0));
        // The face's component along the weld has no effect.
        let leaning = (face + random.within(-2.0, 2.0) * tangent).normalize();
        let found = Inclination::new(tangent, leaning, DVec3::Z);
        assert!((found.slope.to_degrees() - slope).abs() < 1e-10, "{slope} {rotation}");
        assert!((found.rotation.to_degrees() - rotation.abs()).abs() < 1e-7, "{slope} {rotation} {found:?}");
    }
}

#[test]
fn turning_weld_and_gravity_together_changes_nothing() {
    let mut random = Random::new(2);
    for _ in 0..cases(10_000) {
        let (tangent, up) = (random.direction(), random.direction());
        let face = random.direction().cross(tangent).normalize();
        let before = Inclination::new(tangent, face, up);
        let turn = DQuat::from_axis_angle(random.direction(), random.within(-7.0, 7.0));
        let after = Inclination::new(turn * tangent, turn * face, turn * up);
        let level = before.slope.cos().max(1e-3);
        assert!((before.slope - after.slope).abs() < 1e-13 && (before.rotation - after.rotation).abs() < 1e-12 / level);
        // Welding the other way turns the slope round and leaves the rotation.
        let back = Inclination::new(-tangent, face, up);
        assert!((before.slope + back.slope).abs() < 1e-15 && (before.rotation - back.rotation).abs() < 1e-12 / level);
    }
}

#[test]
fn the_test_pieces_of_the_standard_are_in_their_positions() {
    // Nominal slopes and rotations of ISO 6947, and the tolerance of test pieces about them: 5 and 10 degrees.
    let butt = [(Pa, 0.0, 0.0), (Pc, 0.0, 90.0), (Pe, 0.0, 180.0), (Pf, 90.0, 90.0), (Pg, -90.0, 90.0)];
    let fillet = [(Pa, 0.0, 0.0), (Pb, 0.0, 45.0), (Pc, 0.0, 90.0), (Pd, 0.0, 135.0), (Pe, 0.0, 180.0)];
    let vertical = [(Pf, 90.0, 45.0), (Pg, -90.0, 45.0)];
    let pieces = butt.into_iter().map(|p| (FilletOrButt::Butt, p));
    let pieces = pieces.chain(fillet.into_iter().chain(vertical).map(|p| (FilletOrButt::Fillet, p)));
    for (joint, (wanted, slope, rotation)) in pieces {
        for (more, turn) in [(0.0, 0.0), (5.0, 9.9), (5.0, -9.9), (-5.0, 9.9), (-5.0, -9.9)] {
            let (tangent, face) = turned(slope + more, rotation + turn, 0.3);
            let at = Inclination::new(tangent, face, DVec3::Z);
            assert_eq!(PositionLimits::default().position(joint, at), wanted, "{joint:?} {slope} {rotation} {at:?}");
        }
    }
}

#[test]
fn every_limit_parts_two_positions() {
    let parts = |joint, at: f64, row: [WeldingPosition; 2], slopes: &[f64]| {
        for &slope in slopes {
            let found = [at - 1e-6, at + 1e-6].map(|rotation| position(joint, slope, rotation));
            assert_eq!(found, row, "{joint:?} slope {slope}, rotation {at}");
        }
    };
    let (level, sloping) = ([0.0, 14.9, -14.9], [15.1, 45.0, 79.9]);
    let (butt, fillet) = (FilletOrButt::Butt, FilletOrButt::Fillet);
    parts(butt, 30.0, [Pa, Pc], &level);
    parts(butt, 100.0, [Pc, Pe], &level);
    parts(fillet, 30.0, [Pa, Pb], &level);
    parts(fillet, 55.0, [Pb, Pc], &level);
    parts(fillet, 100.0, [Pc, Pd], &level);
    parts(fillet, 145.0, [Pd, Pe], &[0.0, 14.9, -14.9, 15.1, -45.0, 79.9, -79.9]);
    parts(butt, 100.0, [Pf, Pe], &sloping);
    parts(fillet, 100.0, [Pf, Pd], &sloping);
    parts(butt, 100.0, [Pg, Pe], &sloping.map(|s| -s));
    parts(fillet, 100.0, [Pg, Pd], &sloping.map(|s| -s));
    for (joint, rotation, flat) in [(butt, 10.0, Pa), (butt, 60.0, Pc), (fillet, 40.0, Pb), (fillet, 99.0, Pc)] {
        for (slope, wanted) in [(15.0, flat), (15.0 + 1e-6, Pf), (-15.0, flat), (-15.0 - 1e-6, Pg)] {
            assert_eq!(position(joint, slope, rotation), wanted, "{joint:?} {slope} {rotation}");
        }
    }
    for (joint, rotation, overhead) in [(butt, 101.0, Pe), (fillet, 140.0, Pd), (fillet, 179.0, Pe)] {
        for (slope, wanted) in [(80.0 - 1e-6, overhead), (80.0 + 1e-6, Pf), (1e-6 - 80.0, overhead), (-80.0 - 1e-6, Pg)]
        {
            assert_eq!(position(joint, slope, rotation), wanted, "{joint:?} {slope} {rotation}");
        }
    }
}

/// The table of ISO 6947's production ranges as a chain of questions.
fn by_questions(joint: FilletOrButt, slope: f64, rotation: f64) -> WeldingPosition {
    let vertical = if slope > 0.0 { Pf } else { Pg };
    if slope.abs() > 80.0 || (slope.abs() > 15.0 && rotation <= 100.0) {
        return vertical;
    }
    match joint {
        FilletOrButt::Butt if rotation <= 30.0 => Pa,
        FilletOrButt::Butt if rotation <= 100.0 => Pc,
        FilletOrButt::Butt => Pe,
        FilletOrButt::Fillet if rotation <= 30.0 => Pa,
        FilletOrButt::Fillet if rotation <= 55.0 => Pb,
        FilletOrButt::Fillet if rotation <= 100.0 => Pc,
        FilletOrButt::Fillet if rotation <= 145.0 => Pd,
        FilletOrButt::Fillet => Pe,
    }
}

#[test]
fn random_welds_are_where_the_table_has_them() {
    let mut random = Random::new(3);
    let limits = PositionLimits::default();
    let mut seen = [0; 7];
    for i in 0..cases(50_000) {
        let (slope, rotation) = (random.within(-90.0, 90.0), random.within(0.0, 180.0));
        let joint = JOINTS[i % 2];
        let found = position(joint, slope, rotation);
        assert_eq!(found, by_questions(joint, slope, rotation), "{joint:?} {slope} {rotation}");
        seen[found as usize] += 1;
        // It is within its own limits and beyond all others'.
        for other in WeldingPosition::ALL {
            let beyond = limits.beyond(joint, other, inclination(slope, rotation));
            assert_eq!(beyond <= 0.0, other == found, "{joint:?} {slope} {rotation} {other}: {beyond}");
        }
    }
    assert!(seen.iter().all(|n| *n > 500), "{seen:?}");
}

#[test]
fn positions_along_a_pass_change_where_the_limits_are_passed_and_do_not_flicker() {
    let limits = PositionLimits::default();
    let places: Vec<f64> = (0..=97).map(|i| f64::from(i) * 360.0 / 97.0).collect();
    // Round a pipe with its axis level, welded from the top down one side and up the other.
    let pipe = |s: f64| {
        let phi = s.to_radians();
        Inclination::new(DVec3::new(phi.cos(), 0.0, -phi.sin()), DVec3::new(phi.sin(), 0.0, phi.cos()), DVec3::Z)
    };
    let found = limits.along(FilletOrButt::Butt, &places, pipe);
    let wanted = [(Pa, 0.0, 15.0), (Pg, 15.0, 100.0), (Pe, 100.0, 260.0), (Pf, 260.0, 345.0), (Pa, 345.0, 360.0)];
    check(&found, &wanted);
    // Beyond the limit of PA by 3.9 degrees at most: still PA; by 4.1: PB, from the limit on.
    let swing = |most: f64| move |s: f64| inclination(0.0, 30.0 + most * s.to_radians().sin());
    check(&limits.along(FilletOrButt::Fillet, &places, swing(3.9)), &[(Pa, 0.0, 360.0)]);
    check(&limits.along(FilletOrButt::Fillet, &places, swing(4.2)), &[(Pb, 0.0, 180.0), (Pa, 180.0, 360.0)]);
    let none = PositionLimits { hysteresis_deg: Default::default(), ..limits };
    check(&none.along(FilletOrButt::Fillet, &places, swing(0.1)), &[(Pb, 0.0, 180.0), (Pa, 180.0, 360.0)]);
}

fn check(found: &[PositionStretch], wanted: &[(WeldingPosition, f64, f64)]) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (f, (position, from, to)) in found.iter().zip(wanted) {
        let near = (f.from_mm - from).abs() < 1e-9 && (f.to_mm - to).abs() < 1e-9;
        assert!(f.position == *position && near, "{f:?}, not {position} {from} {to}");
    }
}

#[test]
fn positions_of_random_swings_change_on_limits_and_for_a_reason() {
    let (mut random, mut changes) = (Random::new(5), 0);
    for i in 0..cases(300) {
        let terms: Vec<[f64; 4]> = (0..4)
            .map(|_| {
                let [a, b] = [40.0, 60.0].map(|size| random.within(-size, size));
                [a, b, random.within(0.2, 3.0), random.within(0.0, 6.0)]
            })
            .collect();
        let swing = |s: f64| {
            let sum = |k: usize| terms.iter().map(|t| t[k] * (t[2] * s + t[3]).sin()).sum::<f64>();
            inclination(sum(0).clamp(-89.0, 89.0), (90.0 + sum(1)).clamp(0.0, 180.0))
        };
        let joint = JOINTS[i % 2];
        let limits = PositionLimits::default();
        let places: Vec<f64> = (0..=3000).map(|i| 6.0 * f64::from(i) / 3000.0).collect();
        let found = limits.along(joint, &places, swing);
        assert!(found[0].from_mm.abs() < 1e-12 && (found[found.len() - 1].to_mm - 6.0).abs() < 1e-12);
        // Every station is within its position's limits and the hysteresis.
        for &s in &places {
            let beyond = limits.beyond(joint, position_of(&found, s), swing(s));
            assert!(beyond <= 4.0 + 1e-6, "{s}: {beyond}");
        }
        for pair in found.windows(2) {
            let [before, after] = pair else { unreachable!() };
            assert!(
                before.position != after.position
                    && (before.to_mm - after.from_mm).abs() < 1e-12
                    && after.to_mm > after.from_mm
            );
            // It changes on a limit of the new position, and somewhere in that the old one would be too far off.
            let entered = limits.beyond(joint, after.position, swing(after.from_mm));
            assert!(entered.abs() < 1e-6, "{entered} {pair:?}");
            let inside = places.iter().filter(|s| **s >= after.from_mm && **s <= after.to_mm);
            let off = inside.map(|s| limits.beyond(joint, before.position, swing(*s))).fold(0.0, f64::max);
            assert!(off > 4.0, "{off} {pair:?}");
            changes += 1;
        }
    }
    assert!(changes > 500, "{changes}");
}

fn position_of(stretches: &[PositionStretch], s: f64) -> WeldingPosition {
    stretches.iter().find(|p| s <= p.to_mm).unwrap().position
}
