//! Nozzles on heads, across any of their zones, against dense root finding on the meridian's arcs and lines.

use crate::brute_force::{Heights, first_inside, length};
use glam::DVec3;
use seamwright_geometry::{
    ByLength, Curve, DEFAULT_ACCURACY_MM, Edge, Error, Flange, Head, HeadIntersection, SignedDistance, Tube,
};
use seamwright_testkit::{Random, cases};
use std::f64::consts::TAU;

/// A head's dimensions and its inside, defined without the library.
#[derive(Debug, Clone, Copy)]
enum Form {
    Torispherical { crown: f64, knuckle: f64 },
    Ellipsoidal { depth: f64 },
    Hemispherical,
    Flat { knuckle: f64 },
    Conical { half_angle: f64, knuckle: f64 },
}

#[derive(Debug, Clone, Copy)]
struct Case {
    form: Form,
    centre: DVec3,
    axis: DVec3,
    radius: f64,
    flange: f64,
}

impl Case {
    fn random(random: &mut Random) -> Self {
        let radius = random.within(100.0, 2000.0);
        let knuckle = radius * random.within(0.03, 0.6);
        let form = match random.within(0.0, 6.0) as u32 {
            0 | 1 => Form::Torispherical { crown: radius * random.within(1.05, 2.5), knuckle },
            2 => Form::Ellipsoidal { depth: radius * random.within(0.3, 1.2) },
            3 => Form::Hemispherical,
            4 => Form::Flat { knuckle },
            _ => Form::Conical { half_angle: random.within(0.3, 1.3), knuckle },
        };
        let flange = radius * random.within(0.1, 0.9);
        Self { form, centre: random.vector(500.0), axis: random.direction(), radius, flange }
    }

    fn head(&self) -> Head {
        let flange = Flange { centre: self.centre, axis: self.axis, radius: self.radius, length: self.flange };
        match self.form {
            Form::Torispherical { crown, knuckle } => Head::torispherical(flange, crown, knuckle),
            Form::Ellipsoidal { depth } => Head::ellipsoidal(flange, depth, 0.0),
            Form::Hemispherical => Head::hemispherical(flange),
            Form::Flat { knuckle } => Head::flat(flange, knuckle),
            Form::Conical { half_angle, knuckle } => Head::conical(flange, half_angle, knuckle),
        }
        .unwrap()
    }

    fn meridional(&self, p: DVec3) -> (f64, f64) {
        let z = (p - self.centre).dot(self.axis);
        ((p - self.centre).cross(self.axis).length(), z)
    }

    /// Border of the crown and the knuckle, if there is one: distance from the axis.
    fn border(&self) -> Option<f64> {
        match self.form {
            Form::Torispherical { crown, knuckle } => Some(crown * (self.radius - knuckle) / (crown - knuckle)),
            Form::Flat { knuckle } => Some(self.radius - knuckle),
            Form::Conical { half_angle, knuckle } => Some(self.radius - knuckle + knuckle * half_angle.cos()),
            Form::Ellipsoidal { .. } | Form::Hemispherical => None,
        }
    }

    /// Negative inside the head and its infinite flange.
    fn level(&self, p: DVec3) -> f64 {
        let (rho, z) = self.meridional(p);
        if z <= 0.0 || rho >= self.radius {
            return rho - self.radius;
        }
        let knuckled = |k: f64| (rho - (self.radius - k)).hypot(z) - k;
        let in_crown = self.border().is_some_and(|border| rho <= border);
        match self.form {
            Form::Torispherical { crown, knuckle } if in_crown => {
                let below = ((crown - knuckle).powi(2) - (self.radius - knuckle).powi(2)).sqrt();
                rho.hypot(z + below) - crown
            }
            Form::Flat { knuckle } if in_crown => z - knuckle,
            Form::Conical { half_angle: a, knuckle } if in_crown => {
                (rho - (self.radius - knuckle)) * a.cos() + z * a.sin() - knuckle
            }
            Form::Torispherical { knuckle, .. } | Form::Flat { knuckle } | Form::Conical { knuckle, .. } => {
                knuckled(knuckle)
            }
            Form::Ellipsoidal { depth } => ((rho / self.radius).hypot(z / depth) - 1.0) * depth,
            Form::Hemispherical => rho.hypot(z) - self.radius,
        }
    }

    fn brute(&self, foot: DVec3, d: DVec3) -> Option<DVec3> {
        let (middle, far) = ((self.centre - foot).dot(d), 6.0 * self.radius);
        first_inside(|p| self.level(p), foot, d, &Heights { from: middle + far, to: middle - far, steps: 2400 })
    }

    fn tube(&self, random: &mut Random) -> Tube {
        let rho = self.radius * random.within(0.3, 1.0);
        let across = self.axis.cross(random.direction()).normalize();
        let origin = self.centre + rho * across + self.axis * random.within(-0.3, 0.3) * self.radius;
        let lean = random.within(-0.3, 1.0);
        let direction = (self.axis + lean * across + 0.4 * random.direction()).normalize();
        let radius = self.radius * random.within(0.05, 0.35);
        Tube::new(origin, direction, direction.any_orthonormal_vector(), radius).unwrap()
    }

    /// 0 on the crown, 1 on the knuckle (or the oval), 2 on the flange; none within `hair` of a border.
    fn zone(&self, p: DVec3, hair: f64) -> Option<usize> {
        let (rho, z) = self.meridional(p);
        let crown = self.border().map_or(f64::INFINITY, |b| rho - b);
        if z.abs() < hair || crown.abs() < hair {
            return None;
        }
        Some(if z < 0.0 { 2 } else { usize::from(crown > 0.0) })
    }
}

/// The wall's foot on the plane through the tube's origin.
fn foot(tube: &Tube, p: DVec3, origin: DVec3) -> DVec3 {
    p - (p - origin).dot(tube.direction()) * tube.direction()
}

/// Random nozzles that stand on random heads.
fn each(seed: u8, count: u32, mut f: impl FnMut(&Case, &HeadIntersection)) {
    let mut random = Random::new(seed);
    let mut done = 0;
    while done < count {
        let case = Case::random(&mut random);
        if let Ok(curve) = HeadIntersection::new(case.tube(&mut random), case.head()) {
            f(&case, &curve);
            done += 1;
        }
    }
}

#[test]
fn nozzles_agree_with_dense_root_finding() {
    let mut random = Random::new(7);
    let mut crossed = 0;
    each(1, cases(1000), |case, curve| {
        crossed += u32::from(!curve.breaks().is_empty());
        let d = curve.tube().direction();
        for _ in 0..3 {
            let phi = random.within(0.0, TAU);
            let e = curve.edge(phi);
            let found = case.brute(foot(curve.tube(), e.point, case.centre), d);
            let Some(found) = found else {
                // Steps may pass over a line that hardly goes in.
                assert!(e.n2.dot(d) < 0.2, "{case:?} {phi}");
                continue;
            };
            let off = (found - e.point).length() * e.n2.dot(d).min(0.1) * 10.0;
            assert!(off < 1e-9, "{case:?} phi {phi}: {off:e}");
            assert!((e.point - curve.tube().on_axis(e.point)).length() - curve.tube().radius() < 1e-9);
            assert_eq!(e.point, curve.point(phi));
            // The normal is that of the level's differences.
            let (rho, z) = case.meridional(e.point);
            if case.zone(e.point, 1e-2).is_some() && (z < 0.0 || rho < case.radius - 1e-3) {
                let slope = |axis: DVec3| case.level(e.point + 1e-4 * axis) - case.level(e.point - 1e-4 * axis);
                let normal = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z)).normalize();
                assert!((normal - e.n2).length() < 1e-6, "{case:?} {phi} {}", (normal - e.n2).length());
            }
            assert!(e.n1.dot(e.d1).abs() < 1e-9 * e.d1.length() && e.n2.dot(e.d1).abs() < 1e-9 * e.d1.length());
        }
    });
    assert!(crossed > 300, "only {crossed} nozzles went over a border");
}

#[test]
fn borders_between_zones_are_where_they_should_be_and_nothing_jumps_there() {
    let mut borders = 0;
    each(2, cases(500), |case, curve| {
        let breaks = curve.breaks();
        assert!(breaks.windows(2).all(|w| w[0] < w[1]) && breaks.iter().all(|u| (0.0..TAU).contains(u)));
        for &u in &breaks {
            borders += 1;
            let (rho, z) = case.meridional(curve.point(u));
            let off = z.abs().min(case.border().map_or(f64::INFINITY, |b| (rho - b).abs()));
            assert!(off < 2e-9, "{case:?}: a break {off} mm from a border");
            let h = 1e-13;
            let (before, after) = (curve.edge(u - h), curve.edge(u + h));
            // At a flat exit angle of the wall the accuracy is lower.
            let flat = 1e-9 * (1.0 + 0.01 / before.n2.dot(curve.tube().direction()).powi(2));
            let apart = after.point - before.point - 2.0 * h * before.d1;
            let turned = after.d1.normalize() - before.d1.normalize();
            assert!(apart.length() < flat, "{case:?} {:e}", apart.length());
            assert!(turned.length() < flat, "{case:?} {:e}", turned.length());
            assert!((after.n1 - before.n1).length() < 1e-9 && (after.n2 - before.n2).length() < flat);
        }
        // Between two breaks the zone stays the same.
        let mut seen = vec![None; breaks.len().max(1)];
        for i in 0..500 {
            let phi = TAU * f64::from(i) / 500.0;
            let piece = breaks.iter().filter(|u| **u <= phi).count() % seen.len();
            if let Some(zone) = case.zone(curve.point(phi), 1e-4) {
                assert!(*seen[piece].get_or_insert(zone) == zone, "{case:?} at {phi} of {breaks:?}");
            }
        }
    });
    assert!(borders > 400, "{borders}");
}

#[test]
fn derivatives_and_lengths_are_those_of_differences() {
    let mut random = Random::new(9);
    each(3, cases(100), |case, curve| {
        let breaks = curve.breaks();
        for _ in 0..20 {
            let (phi, h) = (random.within(0.0, TAU), 1e-5);
            let near = |u: f64| (phi - u).abs() < 3.0 * h || (phi - u).abs() > TAU - 3.0 * h;
            if breaks.iter().any(|u| near(*u)) {
                continue;
            }
            let (l, m, r) = (curve.jet(phi - h), curve.jet(phi), curve.jet(phi + h));
            let bend = m.d2.length() + m.d1.length();
            let steep = curve.edge(phi).n2.dot(curve.tube().direction()).powi(3);
            assert!(((r.point - l.point) / (2.0 * h) - m.d1).length() * steep < 1e-5 * bend, "{case:?} {phi}");
            assert!(((r.d1 - l.d1) / (2.0 * h) - m.d2).length() * steep < 1e-2 * bend, "{case:?} {phi}");
            assert!((m.d1.length() - curve.speed(phi)).abs() < 1e-12 * bend);
        }
    });
    // Lengths of chords, extrapolated to none.
    each(4, cases(5), |case, curve| {
        let (length, correction) = length(|u| curve.point(u), 5000);
        let by = ByLength::new(curve, DEFAULT_ACCURACY_MM).unwrap();
        let off = (by.length() - length).abs();
        assert!(off < 1e-9 * by.length() + 0.01 * correction, "{case:?}: {off:e}");
        for i in 0..200 {
            let s = by.length() * f64::from(i) / 200.0;
            assert!((by.length_at(by.parameter(s)) - s).abs() < 1e-10);
        }
    });
}

#[test]
fn what_is_refused_does_not_close_on_the_head() {
    let mut random = Random::new(5);
    let mut kinds = [0; 2];
    for _ in 0..cases(400) {
        let case = Case::random(&mut random);
        let tube = case.tube(&mut random);
        let d = tube.direction();
        let axis = tube.on_axis(case.centre);
        let Err(error) = HeadIntersection::new(tube.clone(), case.head()) else { continue };
        let x = d.any_orthonormal_vector();
        let walls = (0..360).map(|i| f64::from(i) * TAU / 360.0);
        let walls = walls.map(|a| axis + tube.radius() * (a.cos() * x + a.sin() * d.cross(x)));
        let ends: Vec<_> = walls.map(|foot| case.brute(foot, d)).collect();
        let missed = ends.iter().any(Option::is_none);
        let below = ends.iter().flatten().any(|p| case.meridional(*p).1 < -case.flange);
        match error {
            Error::BeyondHead { .. } => {
                kinds[0] += 1;
                assert!(below || missed, "{case:?} {error}");
            }
            Error::NotClosed { from, to } => {
                kinds[1] += 1;
                assert!(missed || below || to - from < 0.02, "{case:?} {error}");
            }
            Error::TubeBesideBody | Error::TubeLargerThanBody => assert!(missed || below, "{case:?} {error}"),
            _ => panic!("{case:?} {error}"),
        }
    }
    assert!(kinds.iter().all(|n| *n > 4), "{kinds:?}");
}

#[test]
fn distances_are_those_of_the_nearest_point_of_the_meridian() {
    let mut random = Random::new(6);
    for _ in 0..cases(60) {
        let case = Case::random(&mut random);
        let head = case.head();
        let line = head.outline(1e-4 * case.radius);
        let line = line.into_iter().chain([(case.radius, -9.0 * case.radius)]).collect::<Vec<_>>();
        for _ in 0..20 {
            let p = case.centre + random.vector(1.5 * case.radius);
            let (rho, z) = case.meridional(p);
            let nearest = |w: &[(f64, f64)]| {
                let (a, b) = (glam::DVec2::from(w[0]), glam::DVec2::from(w[1]));
                let q = glam::DVec2::new(rho, z);
                let t = ((q - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                q.distance(a + t * (b - a))
            };
            let expected = line.windows(2).map(nearest).fold(f64::INFINITY, f64::min);
            let foot = head.foot(p);
            if case.level(p) > 0.0 {
                assert!((foot.distance - expected).abs() < 1.1e-4 * case.radius, "{case:?} {p}");
                let onto = p - foot.distance * foot.normal;
                assert!(case.level(onto).abs() < 1e-9, "{case:?} {p}");
            }
        }
        // The outline is nowhere inside.
        let across = case.axis.any_orthonormal_vector();
        for &(rho, z) in &line {
            assert!(case.level(case.centre + rho * across + z * case.axis) > -1e-9, "{case:?}");
        }
    }
}

#[test]
fn a_nozzle_on_the_axis_stays_on_its_zone_even_along_a_border() {
    let (crown, knuckle, radius) = (808.0, 88.0, 400.0);
    let flange = Flange { centre: DVec3::ZERO, axis: DVec3::Z, radius, length: 30.0 };
    let head = || Head::torispherical(flange, crown, knuckle).unwrap();
    let border = crown * (radius - knuckle) / (crown - knuckle);
    for r in [50.0, border - 1.0, border, border + 1.0, 399.0] {
        let tube = Tube::new(DVec3::ZERO, DVec3::Z, DVec3::X, r).unwrap();
        let curve = HeadIntersection::new(tube, head()).unwrap();
        assert!(curve.breaks().is_empty(), "{r}");
        let height = curve.point(0.0).z;
        assert!((0..100).all(|i| (curve.point(f64::from(i)).z - height).abs() < 1e-10));
    }
}

#[test]
fn contradictory_sizes_are_refused() {
    let flange = Flange { centre: DVec3::ZERO, axis: DVec3::Z, radius: 400.0, length: 30.0 };
    for (crown, knuckle) in
        [(400.0, 50.0), (300.0, 50.0), (800.0, 400.0), (800.0, 0.0), (f64::NAN, 50.0), (800.0, f64::NAN)]
    {
        let refused = Head::torispherical(flange, crown, knuckle);
        assert!(matches!(refused, Err(Error::Range { .. })), "{crown} {knuckle}");
    }
    assert!(matches!(Head::flat(flange, 401.0), Err(Error::Range { .. })));
    assert!(Head::conical(flange, 1.6, 50.0).is_err());
    assert!(Head::ellipsoidal(flange, 0.0, 0.0).is_err());
    assert!(Head::hemispherical(Flange { length: -1.0, ..flange }).is_err());
    assert!(Head::hemispherical(Flange { axis: DVec3::ZERO, length: 1.0, ..flange }).is_err());
}
