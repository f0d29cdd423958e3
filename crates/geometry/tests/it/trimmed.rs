//! Tubes on a chord, trimmed by another tube, against dense independent root finding on the two cylinders.

use crate::brute_force::{Heights, first_inside};
use glam::DVec3;
use seamwright_geometry::numeric::bisect;
use seamwright_geometry::{
    ByLength, Curve, DEFAULT_ACCURACY_MM, Edge, Error, Quadric, TrimmedIntersection, Tube, TubeIntersection,
};
use seamwright_testkit::{Random, cases};
use std::f64::consts::{PI, TAU};

/// A round body and its inside, defined without the library.
#[derive(Debug, Clone, Copy)]
struct Rod {
    point: DVec3,
    axis: DVec3,
    radius: f64,
}

impl Rod {
    fn level(&self, p: DVec3) -> f64 {
        (p - self.point).cross(self.axis).length() - self.radius
    }

    fn normal(&self, p: DVec3) -> DVec3 {
        let h = 1e-4;
        DVec3::from_array(DVec3::AXES.map(|e| (self.level(p + h * e) - self.level(p - h * e)) / (2.0 * h))).normalize()
    }

    fn quadric(&self) -> Quadric {
        Quadric::cylinder(self.point, self.axis, self.radius).unwrap()
    }
}

#[derive(Debug, Clone, Copy)]
struct Joint {
    chord: Rod,
    branch: Rod,
    other: Rod,
}

impl Joint {
    fn random(random: &mut Random) -> Self {
        let chord = random.within(50.0, 500.0);
        let leg = |random: &mut Random, x: f64, side: f64, widest: f64| {
            let radius = chord * random.within(0.1, widest);
            let angle = random.within(25.0, 88.0).to_radians();
            let y = random.within(-1.0, 1.0)
                * 0.9
                * (chord - radius)
                * if random.within(0.0, 1.0) < 0.3 { 0.0 } else { 1.0 };
            Rod { point: DVec3::new(x, y, 0.0), axis: DVec3::new(side * angle.cos(), 0.0, angle.sin()), radius }
        };
        let branch = leg(random, 0.0, 1.0, 0.85);
        let x = -chord * random.within(-0.6, 1.5);
        let other = leg(random, x, -1.0, 0.95);
        Self { chord: Rod { point: DVec3::ZERO, axis: DVec3::X, radius: chord }, branch, other }
    }

    fn tube(&self) -> Tube {
        Tube::new(self.branch.point, self.branch.axis, DVec3::X, self.branch.radius).unwrap()
    }

    fn curve(&self) -> Result<TrimmedIntersection, Error> {
        TrimmedIntersection::new(self.tube(), self.chord.quadric(), self.other.quadric())
    }

    /// Foot of the wall's line at an angle.
    fn foot(&self, phi: f64) -> DVec3 {
        let d = self.branch.axis;
        let e1 = (DVec3::X - DVec3::X.dot(d) * d).normalize();
        self.branch.point + self.branch.radius * (phi.cos() * e1 + phi.sin() * d.cross(e1))
    }

    fn level(&self, p: DVec3) -> f64 {
        self.chord.level(p).min(self.other.level(p))
    }

    /// The last point of the wall's line inside, in small steps from outside, then by bisection; true if it is on the
    /// other branch.
    fn brute(&self, phi: f64) -> Option<(DVec3, bool)> {
        let (foot, d) = (self.foot(phi), self.branch.axis);
        let heights = Heights { from: 30.0 * self.chord.radius, to: 0.0, steps: 6000 };
        let p = first_inside(|p| self.level(p), foot, d, &heights)?;
        Some((p, self.other.level(p).abs() < self.chord.level(p).abs()))
    }
}

/// Angles at which the brute curve changes from one body to the other, by bisection.
fn brute_corners(joint: &Joint, places: u32) -> Vec<f64> {
    let on = |phi: f64| joint.brute(phi).map(|b| b.1);
    let step = TAU / f64::from(places);
    let sides: Vec<_> = (0..=places).map(|i| on(f64::from(i) * step)).collect();
    let mut corners = Vec::new();
    for (i, pair) in sides.windows(2).enumerate() {
        if pair[0] != pair[1] {
            let (a, b) = bisect(i as f64 * step, (i as f64 + 1.0) * step, 60, |phi| on(phi) == pair[0]);
            corners.push(0.5 * (a + b));
        }
    }
    corners
}

#[test]
fn trimmed_tubes_lie_on_both_bodies_with_their_corners_where_three_surfaces_meet() {
    let mut random = Random::new(61);
    let (mut trimmed, mut plain, mut refused) = (0, 0, 0);
    let mut off = Vec::new();
    for _ in 0..cases(1200) {
        let joint = Joint::random(&mut random);
        let curve = match joint.curve() {
            Ok(curve) => curve,
            Err(Error::Beside { at }) => {
                // Beside this line the end of the tube jumps from the other branch down to the chord.
                let beside = [at - 1e-4, at + 1e-4].map(|phi| joint.brute(phi).unwrap());
                assert_ne!(beside[0].1, beside[1].1, "{at} {joint:?}");
                let jump = (beside[0].0 - beside[1].0).dot(joint.branch.axis).abs();
                assert!(jump > 0.05, "{jump} {at} {joint:?}");
                refused += 1;
                continue;
            }
            Err(e) => panic!("{e} {joint:?}"),
        };
        let breaks = curve.breaks();
        if breaks.is_empty() {
            plain += 1;
        } else {
            trimmed += 1;
        }
        for _ in 0..4 {
            let phi = random.within(0.0, TAU);
            if breaks.iter().any(|b| (b - phi).abs() < 1e-6) {
                continue;
            }
            let e = curve.edge(phi);
            let (p, on_other) = joint.brute(phi).unwrap();
            assert!((e.point - p).length() < 1e-7 * joint.chord.radius, "{phi} {} {p} {joint:?}", e.point);
            assert_eq!(curve.on_other(phi), on_other, "{phi} {joint:?}");
            let body = if on_other { joint.other } else { joint.chord };
            assert!(body.level(e.point).abs() < 1e-9 && joint.branch.level(e.point).abs() < 1e-9);
            assert!(
                (e.n2 - body.normal(e.point)).length() < 1e-8 && (e.n1 - joint.branch.normal(e.point)).length() < 1e-8
            );
            let h = 1e-6;
            let d1 = (curve.point(phi + h) - curve.point(phi - h)) / (2.0 * h);
            assert!(
                (d1 - e.d1).length() < 1e-4 * (1.0 + e.d1.length()) || breaks.iter().any(|b| (b - phi).abs() < 2.0 * h)
            );
            assert!((curve.jet(phi).d1 - e.d1).length() < 1e-12 * (1.0 + e.d1.length()));
        }
        for at in breaks {
            let (before, behind) = (curve.point(at - 1e-13), curve.point(at));
            // If the wall's line nearly touches the other branch, points along it are less accurate.
            assert!(before.distance(behind) < 1e-6, "{} {joint:?}", before.distance(behind));
            let corner = if curve.on_other(at) { before } else { behind };
            for rod in [joint.chord, joint.branch, joint.other] {
                assert!(rod.level(corner).abs() < 1e-9, "{} {joint:?}", rod.level(corner));
            }
            off.push(before.distance(behind));
        }
    }
    off.sort_by(f64::total_cmp);
    // At least 99 of 100 meet to rounding.
    let usual = off[off.len() * 99 / 100];
    assert!(usual < 1e-9, "{usual}");
    assert!(trimmed > 150 && plain > 100 && refused > 30, "{trimmed} {plain} {refused}");
}

#[test]
fn corners_are_all_found() {
    let mut random = Random::new(62);
    let mut compared = 0;
    while compared < cases(20) {
        let joint = Joint::random(&mut random);
        let Ok(curve) = joint.curve() else { continue };
        let brute = brute_corners(&joint, 360);
        // Pieces shorter than the samples here may give more breaks.
        let breaks = curve.breaks();
        let short = breaks.windows(2).any(|b| b[1] - b[0] < 0.04);
        assert!(short || brute.len() == breaks.len(), "{brute:?} {breaks:?} {joint:?}");
        if short || brute.is_empty() {
            continue;
        }
        compared += 1;
        for (b, c) in brute.iter().zip(&breaks) {
            let apart = curve.point(*b).distance(curve.point(*c));
            assert!(apart < 1e-9 * joint.chord.radius.max(100.0), "{apart} mm {b} {c} {joint:?}");
        }
        let by_length = ByLength::new(&curve, DEFAULT_ACCURACY_MM).unwrap();
        let mut ends = vec![0.0];
        ends.extend(&breaks);
        ends.push(TAU);
        // Piece by piece, so that no corner is cut.
        let piece = |from: f64, to: f64| -> f64 {
            let at = |k: u32| curve.point(from + (to - from) * (1.0 - 1e-14) * f64::from(k) / 4000.0);
            (0..4000).map(|k| at(k).distance(at(k + 1))).sum()
        };
        let polyline: f64 = ends.windows(2).map(|w| piece(w[0], w[1])).sum();
        assert!((by_length.length() - polyline).abs() < 1e-6 * polyline, "{} {polyline}", by_length.length());
    }
}

/// Equal branches at the same angle, symmetrical: both corners lie in the plane between them.
#[test]
fn a_symmetrical_joint_has_its_corners_in_the_middle() {
    let mut random = Random::new(63);
    let mut found = 0;
    for _ in 0..cases(2000) {
        let (chord, angle) = (random.within(60.0, 300.0), random.within(30.0, 80.0f64).to_radians());
        let radius = chord * random.within(0.2, 0.9);
        let toe = (chord * angle.cos() - radius) / angle.sin();
        let overlap = random.within(0.05, 0.6) * radius / angle.sin();
        // Axes at -x and +x of the plane x = 0.
        let half = -toe - 0.5 * overlap;
        let rod = |side: f64| Rod {
            point: side * half * DVec3::X,
            axis: DVec3::new(side * angle.cos(), 0.0, angle.sin()),
            radius,
        };
        let joint = Joint {
            chord: Rod { point: DVec3::ZERO, axis: DVec3::X, radius: chord },
            branch: rod(1.0),
            other: rod(-1.0),
        };
        let Ok(curve) = joint.curve() else { continue };
        found += 1;
        let corners: Vec<DVec3> = curve.breaks().into_iter().map(|phi| curve.point(phi)).collect();
        assert_eq!(corners.len(), 2, "{joint:?}");
        for p in &corners {
            assert!(p.x.abs() < 1e-9, "{p}");
            // In that plane: the chord's circle, and half an ellipse of the branch.
            let across = half * angle.sin() + p.z * angle.cos();
            assert!((across * across + p.y * p.y - radius * radius).abs() < 1e-9 * radius * radius);
        }
        assert!((corners[0].y + corners[1].y).abs() < 1e-9 && (corners[0].z - corners[1].z).abs() < 1e-9);
        // The curve on the other branch is plane: equal cylinders that cross meet in ellipses.
        for i in 0..20 {
            let phi = PI * (0.5 + f64::from(i) / 20.0);
            let p = curve.point(phi);
            assert!(!curve.on_other(phi) || p.x.abs() < 1e-9, "{p}");
        }
    }
    assert!(found > cases(1000), "{found}");
}

#[test]
fn far_apart_it_is_the_plain_curve() {
    let mut random = Random::new(64);
    for _ in 0..cases(500) {
        let mut joint = Joint::random(&mut random);
        joint.other.point.x -= 40.0 * joint.chord.radius;
        let curve = joint.curve().unwrap();
        let plain = TubeIntersection::new(joint.tube(), joint.chord.quadric()).unwrap();
        assert!(curve.breaks().is_empty());
        let phi = random.within(0.0, TAU);
        assert_eq!(curve.edge(phi), plain.edge(phi));
    }
}
