//! The part made from a seam, against distances from the surfaces themselves (`SeamSurfaces`: other code, no solids):
//! random nozzles on every body, girths, ellipses, straight seams and curved T-joints, oblique and offset ones too.

use crate::jobs::{WithSeam, job};
use crate::part::NO_STL;
use glam::{DAffine3, DQuat, DVec3};
use seamwright_clearance::{Shape, Solid, nearest};
use seamwright_document::DocumentError;
use seamwright_geometry::SignedDistance;
use seamwright_testkit::{Random, cases};
use seamwright_weld::{SeamPoint, SeamSurfaces, Welding};

/// Radius of the ball that represents a point, mm.
const BALL_MM: f64 = 1e-6;
/// Permitted shortfall of the proven distance below the true one near round solids, as a share of the seam's length.
const SLACK: f64 = 1e-5;

/// A unit vector up to `angle` rad off `axis`.
fn near(random: &mut Random, axis: DVec3, angle: f64) -> DVec3 {
    DQuat::from_axis_angle(axis.cross(random.direction()).normalize(), random.within(0.0, angle)) * axis
}

fn place(random: &mut Random) -> DVec3 {
    random.direction() * random.within(0.0, 2000.0)
}

fn read(seam: &str) -> Result<Welding, DocumentError> {
    Welding::read("job.toml", &job(seam))
}

fn part(welding: &Welding) -> Vec<Solid> {
    welding.clamped(NO_STL).unwrap_or_else(|e| panic!("{e}\n{}", welding.program.text())).part
}

/// Distance of a point from solids; 0 inside.
fn distance(part: &[Solid], at: DVec3) -> f64 {
    let ball = Solid::new("ball", Shape::Sphere { radius: BALL_MM }, DAffine3::from_translation(at)).unwrap();
    let one = |s: &Solid| {
        let near = nearest(&ball, &DAffine3::IDENTITY, s, &DAffine3::IDENTITY, 1e6).unwrap();
        if near.distance > 0.0 { near.distance + BALL_MM } else { 0.0 }
    };
    part.iter().map(one).fold(f64::INFINITY, f64::min)
}

/// Distance from the nearer of the two surfaces' bodies; 0 inside.
fn true_distance(bodies: &[&dyn SignedDistance], at: DVec3) -> f64 {
    bodies.iter().map(|b| b.foot(at).distance).fold(f64::INFINITY, f64::min).max(0.0)
}

/// Points before the joint, on its faces, and behind it; `along` is the direction of the first part.
fn places(p: &SeamPoint, along: DVec3, random: &mut Random) -> Vec<DVec3> {
    // Not through a plate.
    let d = random.decades(1e-3, 8.0);
    let behind = random.decades(1e-3, 2.0);
    let up = random.within(0.0, 60.0);
    let before = p.point + d * (p.n1 * random.within(0.1, 1.0) + p.n2 * random.within(0.1, 1.0));
    vec![p.point, p.point + d * p.bisector, before, p.point + up * along, p.point + up * along + d * p.n1, {
        p.point - behind * p.bisector
    }]
}

/// Checks the part along the seam: distances are never too large, and at most `outside` mm too small.
fn check(welding: &Welding, bodies: &[&dyn SignedDistance], along: DVec3, outside: f64, random: &mut Random) {
    let (solids, slack) = (part(welding), 1e-3 + SLACK * welding.seam().length());
    for _ in 0..10 {
        let p = welding.seam().at(random.within(0.02, 0.98) * welding.seam().length());
        for (i, at) in places(&p, along, random).into_iter().enumerate() {
            let (found, truth) = (distance(&solids, at), true_distance(bodies, at));
            let good = found <= truth + 1e-6 && found >= truth - outside - slack;
            assert!(good, "place {i}: {found} mm, truly {truth}, at {at} (s = {})\n{}", p.s, welding.program.text());
        }
    }
}

fn body(random: &mut Random, kind: usize, size: f64) -> (String, DVec3, DVec3) {
    let (axis, at) = (random.direction(), place(random));
    let out = random.direction();
    let across = out.reject_from_normalized(axis).normalize();
    let (table, foot, direction) = match kind {
        0 => (
            format!("cylinder]\nradius_mm = {size}\npoint_mm = {:?}\naxis = {:?}", at.to_array(), axis.to_array()),
            at + random.within(-500.0, 500.0) * axis,
            across,
        ),
        1 => {
            let half: f64 = random.within(5.0, 60.0);
            let far = size / half.to_radians().tan();
            let wall = across * half.to_radians().cos() - axis * half.to_radians().sin();
            (
                format!("cone]\nhalf_angle_deg = {half}\napex_mm = {:?}\naxis = {:?}", at.to_array(), axis.to_array()),
                at + far * axis,
                wall,
            )
        }
        2 => (format!("sphere]\nradius_mm = {size}\ncentre_mm = {:?}", at.to_array()), at, out),
        3 => {
            let semi = [size, size * random.within(0.5, 1.0), size * random.within(0.3, 1.0)];
            let (z, x) = (axis.to_array(), across.to_array());
            let table = format!(
                "ellipsoid]\nsemi_axes_mm = {semi:?}\ncentre_mm = {:?}\naxis = {z:?}\nx_direction = {x:?}",
                at.to_array()
            );
            (table, at, near(random, axis, 1.0))
        }
        _ => (format!("plane]\nnormal = {:?}\npoint_mm = {:?}", axis.to_array(), at.to_array()), at, axis),
    };
    (format!("[seam.nozzle.body.{table}\n"), foot, direction)
}

#[test]
fn random_nozzles_on_every_body() {
    let mut random = Random::new(1);
    let (mut made, mut refused) = ([0; 5], 0);
    for case in 0..cases(400) {
        let kind = case % 5;
        let size = random.decades(50.0, 3000.0);
        let radius = size * random.within(0.02, 0.95);
        let (table, foot, out) = body(&mut random, kind, size);
        let direction = near(&mut random, out, 1.3);
        let origin = foot + random.within(0.0, 0.6 * (size - radius)) * direction.any_orthonormal_vector();
        let seam = format!(
            "[seam.nozzle]\nradius_mm = {radius}\norigin_mm = {:?}\ndirection = {:?}\n{table}",
            origin.to_array(),
            direction.to_array()
        );
        let Ok(welding) = read(&seam) else {
            refused += 1;
            continue;
        };
        made[kind] += 1;
        let surfaces = SeamSurfaces::new(&welding.program, welding.program.value.seam.as_ref().unwrap()).unwrap();
        // A head is a mesh around the ellipsoid.
        let outside = if kind == 3 { 0.1 } else { 0.0 };
        check(&welding, &[&*surfaces.first, &*surfaces.second], direction, outside, &mut random);
    }
    println!("made {made:?}, refused {refused}");
    assert!(made.iter().all(|m| *m >= cases(24)), "too few: {made:?}, refused {refused}");
}

#[test]
fn random_girths() {
    let mut random = Random::new(2);
    for _ in 0..cases(200) {
        let direction = random.direction();
        let cut = near(&mut random, direction, 1.4);
        let seam = format!(
            "[seam.girth]\nradius_mm = {}\norigin_mm = {:?}\ndirection = {:?}\ncut_normal = {:?}\n",
            random.decades(5.0, 1000.0),
            place(&mut random).to_array(),
            direction.to_array(),
            cut.to_array()
        );
        let welding = read(&seam).unwrap_or_else(|e| panic!("{e}"));
        let surfaces = SeamSurfaces::new(&welding.program, welding.program.value.seam.as_ref().unwrap()).unwrap();
        check(&welding, &[&*surfaces.first], DVec3::ZERO, 0.0, &mut random);
    }
}

#[test]
fn random_ellipses() {
    let mut random = Random::new(3);
    for case in 0..cases(200) {
        let normal = random.direction();
        let fillet = case % 4 != 0;
        let seam = format!(
            "[seam.ellipse]\na_mm = {}\nb_mm = {}\ncentre_mm = {:?}\nnormal = {:?}\na_direction = {:?}\njoint = \"{}\"\n",
            random.decades(5.0, 2000.0),
            random.decades(5.0, 2000.0),
            place(&mut random).to_array(),
            normal.to_array(),
            random.direction().to_array(),
            if fillet { "fillet" } else { "butt" }
        );
        let welding = read(&seam).unwrap_or_else(|e| panic!("{e}"));
        let surfaces = SeamSurfaces::new(&welding.program, welding.program.value.seam.as_ref().unwrap()).unwrap();
        let (wall, plate) = (&*surfaces.first, &*surfaces.second);
        let bodies: &[&dyn SignedDistance] = if fillet { &[wall, plate] } else { &[plate] };
        check(&welding, bodies, if fillet { normal } else { DVec3::ZERO }, 0.02, &mut random);
    }
}

#[test]
fn random_straight_seams() {
    let mut random = Random::new(4);
    for case in 0..cases(300) {
        let (start, along) = (place(&mut random), random.direction());
        // From faces that nearly look at each other to a butt joint.
        let between = match case % 6 {
            0 => 0.0,
            1 => random.decades(1e-5, 0.1),
            2 => std::f64::consts::PI - random.decades(1e-3, 0.1),
            _ => random.within(0.1, 3.0),
        };
        let first = along.any_orthonormal_vector();
        let second = DQuat::from_axis_angle(along, between) * first;
        let end = start + random.decades(20.0, 3000.0) * along;
        let seam = format!(
            "[seam.line]\nstart_mm = {:?}\nend_mm = {:?}\nfirst_normal = {:?}\nsecond_normal = {:?}\n",
            start.to_array(),
            end.to_array(),
            first.to_array(),
            second.to_array()
        );
        let welding = read(&seam).unwrap_or_else(|e| panic!("{e}"));
        let surfaces = SeamSurfaces::new(&welding.program, welding.program.value.seam.as_ref().unwrap()).unwrap();
        check(&welding, &[&*surfaces.first, &*surfaces.second], DVec3::ZERO, 0.0, &mut random);
    }
}

/// A T-joint with its middle line turned about `axis` through the origin, from `start` over `sweep` rad.
struct Tee {
    axis: DVec3,
    start: DVec3,
    sweep: f64,
    skin: DVec3,
    web: f64,
}

impl Tee {
    fn random(random: &mut Random) -> Self {
        let axis = random.direction();
        let out = axis.any_orthonormal_vector();
        let radius = random.decades(30.0, 20_000.0);
        let sweep = random.decades(0.02, 3.0);
        // Out of the skin: along the axis (a web curved sideways), from it or to it (a curved skin), or between.
        let turn = match random.within(0.0, 4.0) as u32 {
            0 => 0.0,
            1 => 0.5 * std::f64::consts::PI,
            2 => -0.5 * std::f64::consts::PI,
            _ => random.within(-3.0, 3.0),
        };
        let skin = turn.cos() * axis + turn.sin() * out;
        Self { axis, start: radius * out, sweep, skin, web: random.decades(1.0, 0.2 * radius.min(100.0)) }
    }

    fn seam(&self) -> String {
        let at = |part: f64| (DQuat::from_axis_angle(self.axis, part * self.sweep) * self.start).to_array();
        format!(
            "[seam.t_joint]\nstart_mm = {:?}\nend_mm = {:?}\nvia_mm = {:?}\nskin_normal = {:?}\nweb_mm = {}\n",
            at(0.0),
            at(1.0),
            at(0.4),
            self.skin.to_array(),
            self.web
        )
    }

    /// A point of the cross-section at the part `u` of the arc.
    fn at(&self, u: f64, left: f64, out: f64) -> DVec3 {
        let along = self.axis.cross(self.start).normalize();
        let at_start = self.start + left * self.skin.cross(along) + out * self.skin;
        DQuat::from_axis_angle(self.axis, u * self.sweep) * at_start
    }

    /// Distance of the cross-section's point from the axis, negative beyond it.
    fn off_axis(&self, left: f64, out: f64) -> f64 {
        let along = self.axis.cross(self.start).normalize();
        (self.start + left * self.skin.cross(along) + out * self.skin).dot(self.start.normalize())
    }
}

#[test]
fn curved_t_joints_are_enclosed_and_hardly_larger() {
    let mut random = Random::new(5);
    for _ in 0..cases(300) {
        let tee = Tee::random(&mut random);
        let welding = read(&tee.seam()).unwrap_or_else(|e| panic!("{e}"));
        let solids = part(&welding);
        for _ in 0..20 {
            let (u, half) = (random.within(0.01, 0.99), 0.5 * tee.web);
            let (left, out) = (random.within(-1.0, 1.0) * half, random.within(0.0, 99.0));
            let beside = half + random.decades(0.1, 40.0);
            let side = if random.within(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
            let text = || format!("u {u} left {left} out {out} beside {beside} side {side}\n{}", tee.seam());
            if tee.off_axis(left, out) > 0.7 * tee.start.length() {
                let found = distance(&solids, tee.at(u, left, out));
                assert!(found < 1e-6, "web: {found} {}", text());
                let found = distance(&solids, tee.at(u, side * half, out));
                assert!(found < 1e-6, "web's face: {found} {}", text());
            }
            let reaches = tee.off_axis(side * beside, 0.0) > 0.7 * tee.start.length();
            if reaches {
                let found = distance(&solids, tee.at(u, side * beside, 0.0));
                assert!(found < 1e-6, "skin's face: {found} {}", text());
                // In the corner both faces have the distances of the coordinates, if neither bends towards the point.
                let d = random.decades(1e-3, 1.0);
                let found = distance(&solids, tee.at(u, side * (half + d), d));
                assert!(
                    (d - 0.02 - d * d / tee.start.length()..=d + 1e-6).contains(&found),
                    "corner: {found} for {d} {}",
                    text()
                );
            }
        }
    }
}

#[test]
fn sizes_out_of_this_world_are_refused_or_made_in_no_time() {
    // At a speed that is through in a day.
    let fast = |seam: &str| Welding::read("job.toml", &job(seam).replace("speed_mm_s = 5", "speed_mm_s = 5000"));
    let clamp = |seam: &str| fast(seam).and_then(|w| w.clamped(NO_STL).map(|c| c.part.len()));
    for seam in [
        "[seam.ellipse]\na_mm = 1.5e5\nb_mm = 1.5e5\n",
        "[seam.ellipse]\na_mm = 2e5\nb_mm = 30\n",
        "[seam.ellipse]\na_mm = 1e6\nb_mm = 1e6\n",
        "[seam.t_joint]\nstart_mm = [-1e7, 0, 0]\nvia_mm = [0, 0, 0.1]\nend_mm = [1e7, 0, 0]\nskin_normal = [0, 0, 1]\nweb_mm = 4\n",
        "[seam.t_joint]\nstart_mm = [-1e7, 0, 0]\nvia_mm = [0, 1e7, 0]\nend_mm = [1e7, 0, 0]\nskin_normal = [0, 0, 1]\nweb_mm = 4\n",
        "[seam.nozzle]\nradius_mm = 30\nbody.ellipsoid = { semi_axes_mm = [1e7, 1e7, 1e7] }\n",
        "[seam.nozzle]\nradius_mm = 30\nbody.ellipsoid = { semi_axes_mm = [5e3, 5e3, 2500] }\n",
        "[seam.nozzle]\nradius_mm = 1e5\nbody.sphere = { radius_mm = 2e5 }\n",
        "[seam.nozzle]\nradius_mm = 30\nbody.sphere = { radius_mm = 200 }\n[part]\nnozzle_length_mm = 1e6\n",
    ] {
        let start = std::time::Instant::now();
        match clamp(seam) {
            Ok(count) => println!("{count} solids after {:?}", start.elapsed()),
            Err(e) => {
                println!("{e}");
                assert_eq!(e.key, "seam");
            }
        }
        assert!(start.elapsed().as_secs_f64() < 5.0, "{seam}");
    }
}

#[test]
fn bodies_that_end_within_the_seam_are_refused() {
    for seam in [
        "[seam.nozzle]\nradius_mm = 60\nbody.cylinder = { radius_mm = 200 }\n",
        "[seam.nozzle]\nradius_mm = 60\nbody.plane = { normal = [0, 0, 1] }\n",
        "[seam.nozzle]\nradius_mm = 60\nbody.cone = { half_angle_deg = 30, axis = [0, 0, -1], apex_mm = [0, 30, 400] }\n",
        "[seam.ellipse]\na_mm = 60\nb_mm = 40\n",
        "[seam.girth]\nradius_mm = 60\ncut_normal = [1, 0, 1]\n",
        "[seam.t_joint]\nstart_mm = [0, 0, 0]\nend_mm = [60, 0, 0]\nskin_normal = [0, 0, 1]\nweb_mm = 10\n",
    ] {
        let with = |mm: f64| read(&format!("{seam}[part]\nbody_length_mm = {mm}\n")).and_then(|w| w.clamped(NO_STL));
        let e = with(9.0).unwrap_err();
        println!("{e}");
        assert_eq!(e.key, "part.body_length_mm", "{seam}");
        with(300.0).unwrap_or_else(|e| panic!("{e}"));
    }
}
