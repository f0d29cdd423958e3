//! Nozzles on pipe bends against dense root finding on the distance from the ring.

use crate::brute_force::{Heights, first_inside, length};
use glam::DVec3;
use seamwright_geometry::{
    ByLength, Curve, DEFAULT_ACCURACY_MM, Edge, Error, SignedDistance, Torus, TorusIntersection, Tube,
};
use seamwright_testkit::{Random, cases};
use std::f64::consts::TAU;

/// A pipe bend and its inside, defined without the library.
#[derive(Debug, Clone, Copy)]
struct Bend {
    centre: DVec3,
    axis: DVec3,
    ring: f64,
    pipe: f64,
}

impl Bend {
    fn random(random: &mut Random) -> Self {
        let ring = random.within(100.0, 2000.0);
        Self { centre: random.vector(300.0), axis: random.direction(), ring, pipe: ring * random.within(0.1, 0.95) }
    }

    fn torus(&self) -> Torus {
        Torus::new(self.centre, self.axis, self.ring, self.pipe).unwrap()
    }

    fn level(&self, p: DVec3) -> f64 {
        let q = p - self.centre;
        (q.cross(self.axis).length() - self.ring).hypot(q.dot(self.axis)) - self.pipe
    }

    /// The last point of a line inside, in small steps from outside, then by bisection.
    fn brute(&self, foot: DVec3, d: DVec3) -> Option<DVec3> {
        let (middle, far) = ((self.centre - foot).dot(d), 1.01 * (self.ring + self.pipe));
        first_inside(|p| self.level(p), foot, d, &Heights { from: middle + far, to: middle - far, steps: 2000 })
    }

    /// A tube that stands somewhere on the pipe, leaning any way.
    fn tube(&self, random: &mut Random) -> Tube {
        let across = self.axis.cross(random.direction()).normalize();
        let direction = (across + 0.7 * random.direction()).normalize();
        let direction =
            if random.within(0.0, 1.0) < 0.5 { direction } else { (self.axis + 0.5 * direction).normalize() };
        let radius = self.pipe * random.within(0.05, 1.1);
        let direction = if random.within(0.0, 1.0) < 0.2 { -direction } else { direction };
        let origin = self.centre + self.ring * across;
        Tube::new(origin, direction, direction.any_orthonormal_vector(), radius).unwrap()
    }
}

#[test]
fn nozzles_agree_with_dense_root_finding() {
    let mut random = Random::new(21);
    let (mut stood, mut refused) = (0, 0);
    while stood < cases(800) {
        let bend = Bend::random(&mut random);
        let tube = bend.tube(&mut random);
        let d = tube.direction();
        let curve = match TorusIntersection::new(tube.clone(), bend.torus()) {
            Ok(curve) => curve,
            Err(e) => {
                refused += 1;
                // Some line of the wall misses the pipe, touches it, or meets another part of it first.
                let (axis, x) = (tube.on_axis(bend.centre), d.any_orthonormal_vector());
                let walls = (0..=240).map(|i| f64::from(i) * TAU / 240.0);
                let walls = walls.map(|a| axis + tube.radius() * (a.cos() * x + a.sin() * d.cross(x)));
                let heights: Vec<Option<f64>> = walls.map(|foot| bend.brute(foot, d).map(|p| p.dot(d))).collect();
                let jumps = |w: &[Option<f64>]| match (w[0], w[1]) {
                    (Some(a), Some(b)) => (a - b).abs() > 0.1 * tube.radius(),
                    _ => true,
                };
                assert!(!matches!(e, Error::Size { .. }) && heights.windows(2).any(jumps), "{bend:?} {tube:?} {e}");
                continue;
            }
        };
        stood += 1;
        for _ in 0..3 {
            let (phi, h) = (random.within(0.0, TAU), 1e-5);
            let e = curve.edge(phi);
            let steep = e.n2.dot(d);
            let found = bend.brute(e.point - (e.point - bend.centre).dot(d) * d, d);
            let Some(found) = found else {
                assert!(steep < 0.2, "{bend:?} {tube:?} {phi}");
                continue;
            };
            let off = (found - e.point).length() * steep.min(0.1) * 10.0;
            assert!(off < 1e-9 || steep < 0.1, "{bend:?} {tube:?} phi {phi}: {off:e}");
            assert!(e.n1.dot(e.d1).abs() < 1e-9 * e.d1.length() && e.n2.dot(e.d1).abs() < 1e-9 * e.d1.length());
            let (l, m, r) = (curve.jet(phi - h), curve.jet(phi), curve.jet(phi + h));
            let bends = m.d2.length() + m.d1.length();
            assert!(((r.point - l.point) / (2.0 * h) - m.d1).length() * steep.powi(3) < 1e-5 * bends, "{bend:?} {phi}");
            assert!(((r.d1 - l.d1) / (2.0 * h) - m.d2).length() * steep.powi(3) < 1e-2 * bends, "{bend:?} {phi}");
            let foot = bend.torus().foot(e.point + 0.1 * bend.pipe * e.n2);
            assert!((foot.distance - 0.1 * bend.pipe).abs() < 1e-9 && (foot.normal - e.n2).length() < 1e-9);
        }
    }
    assert!(refused > 50, "{refused}");
}

#[test]
fn a_nozzle_over_the_pipe_has_its_closed_form_and_length() {
    let (ring, pipe, r) = (300.0, 100.0, 40.0);
    let tube = Tube::new(DVec3::new(ring, 0.0, 0.0), DVec3::Z, DVec3::X, r).unwrap();
    let curve = TorusIntersection::new(tube, Torus::new(DVec3::ZERO, DVec3::Z, ring, pipe).unwrap()).unwrap();
    let exact = |phi: f64| {
        let (x, y) = (ring + r * phi.cos(), r * phi.sin());
        DVec3::new(x, y, (pipe * pipe - (x.hypot(y) - ring).powi(2)).sqrt())
    };
    for i in 0..100 {
        let phi = 0.063 * f64::from(i);
        assert!((curve.point(phi) - exact(phi)).length() < 1e-11);
    }
    let by = ByLength::new(curve, DEFAULT_ACCURACY_MM).unwrap();
    assert!((by.length() - length(exact, 4000).0).abs() < 1e-8);
}
