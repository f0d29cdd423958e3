//! Bounds along motions against dense sampling.

use crate::common::{KINDS, pose, shape, solid};
use glam::{DAffine3, DQuat, DVec3};
use seamwright_clearance::{ClearanceError, Group, Limits, Motion, Scene, Shape, Solid, Watch};
use seamwright_testkit::{Random, cases};

/// Group 0 turns at a constant rate about an axis through `about` while that moves straight; the others stand.
struct Screw {
    axis: DVec3,
    rate: f64,
    about: DVec3,
    velocity: DVec3,
    /// Maximum distance of the group's solids from `about`.
    reach: f64,
    length: f64,
    start: DAffine3,
}

impl Motion for Screw {
    fn range(&self) -> (f64, f64) {
        (0.0, self.length)
    }
    fn frames(&self, s: f64, frames: &mut [DAffine3]) {
        frames[1..].fill(DAffine3::IDENTITY);
        let turn = DAffine3::from_quat(DQuat::from_axis_angle(self.axis, self.rate * s));
        let centre = self.about + self.velocity * s;
        frames[0] = DAffine3::from_translation(centre) * turn * self.start;
    }
    fn greatest_speed(&self, a: usize, b: usize, _: f64, _: f64) -> f64 {
        if a != 0 && b != 0 { 0.0 } else { self.velocity.length() + self.rate.abs() * self.reach }
    }
    /// A point is beside its chord by at most the acceleration times the square of the length over 8. Seen from the
    /// moving group, the others are up to 900 mm away, and have an acceleration from turn and way.
    fn greatest_bend(&self, a: usize, _: usize, from: f64, to: f64) -> f64 {
        let (reach, both) = if a == 0 { (self.reach, 0.0) } else { (900.0, 2.0 * self.velocity.length()) };
        (self.rate.powi(2) * reach + self.rate.abs() * both) * (to - from).powi(2) / 8.0
    }
}

fn group(name: &str, solids: Vec<Solid>) -> Group {
    Group { name: name.to_owned(), solids }
}

fn straight(from: DVec3, to: DVec3) -> Screw {
    let length = (to - from).length();
    let velocity = (to - from) / length;
    Screw { axis: DVec3::Z, rate: 0.0, about: from, velocity, reach: 0.0, length, start: DAffine3::IDENTITY }
}

const LIMITS: Limits = Limits { cutoff_mm: 100.0, precision_mm: 0.1, smallest: 0.01 };

#[test]
fn a_thin_plate_between_two_stations_is_found() {
    let tip = solid(Shape::Capsule { radius: 0.5, length: 20.0 }, DAffine3::IDENTITY);
    let plate = Shape::Box { size: DVec3::new(0.2, 40.0, 40.0) };
    let mut random = Random::new(11);
    for _ in 0..cases(100) {
        let x = random.within(50.0, 950.0);
        let plate = Solid::new("plate", plate.clone(), DAffine3::from_translation(DVec3::X * x)).unwrap();
        let watch = Watch::Apart { a: 0, b: 1, least_mm: 1.0 };
        let scene =
            Scene::new(vec![group("torch", vec![tip.clone()]), group("part", vec![plate])], vec![watch]).unwrap();
        let motion = straight(DVec3::ZERO, DVec3::X * 1000.0);
        // Stations 100 mm apart: all are far from the plate.
        let profile = scene.along(&motion, 10, &LIMITS).unwrap();
        let [stretch] = &profile.stretches[..] else { panic!("{:?}", profile.stretches) };
        // Nearer than 1 mm: half the plate, the radius and 1 mm, on both sides.
        assert!((stretch.from - (x - 1.6)).abs() < 0.02 && (stretch.to - (x + 1.6)).abs() < 0.02, "{stretch:?} {x}");
        // It touches: the sample shows it to within the precision, the bound exactly.
        assert!(stretch.at_least_mm == 0.0 && stretch.nearest.distance < 0.12, "{stretch:?}");
        assert!((stretch.s - x).abs() < 0.75 && stretch.nearest.place.is_some());
        let cell = (x / 100.0) as usize;
        assert!(profile.nearest(cell).unwrap().1.at_least_mm < 1e-12);
        assert!(profile.nearest((cell + 3) % 10).unwrap().1.at_least_mm > 50.0);
    }
}

#[test]
fn just_clear_and_just_not() {
    let ball = solid(Shape::Sphere { radius: 5.0 }, DAffine3::IDENTITY);
    for (height, clear) in [(17.01, true), (16.99, false)] {
        let post = solid(Shape::Sphere { radius: 10.0 }, DAffine3::from_translation(DVec3::Z * height));
        let watch = Watch::Apart { a: 0, b: 1, least_mm: 2.0 };
        let scene = Scene::new(vec![group("a", vec![ball.clone()]), group("b", vec![post])], vec![watch]).unwrap();
        let profile = scene.along(&straight(DVec3::X * -333.0, DVec3::X * 444.0), 7, &LIMITS).unwrap();
        assert_eq!(profile.stretches.is_empty(), clear, "{:?}", profile.stretches);
        let (s, nearest) = profile.traces[0].nearest;
        assert!((nearest.distance - (height - 15.0)).abs() < 0.2 && (s - 333.0).abs() < 4.0);
    }
}

#[test]
fn cell_bounds_hold_between_all_places() {
    let mut random = Random::new(12);
    for case in 0..cases(150) {
        let solids = |count: usize, size: f64, random: &mut Random| -> Vec<Solid> {
            let kinds: Vec<usize> = (0..count).map(|_| [0, 1, 2, 3, 4, 5, 7][random.below(7)]).collect();
            kinds.into_iter().map(|k| solid(shape(k, random), pose(random, size))).collect()
        };
        let (moving, mut standing) = (solids(2, 20.0, &mut random), solids(4, 120.0, &mut random));
        if case % 3 == 0 {
            standing.push(solid(shape(6 % KINDS, &mut random), DAffine3::from_translation(DVec3::Z * -100.0)));
        }
        let start = pose(&mut random, 10.0);
        // No solid is larger than 60 mm from its origin, itself within 35 of the group's, that within 18 of the axis.
        let motion = Screw {
            axis: random.direction(),
            rate: random.within(-0.05, 0.05),
            about: random.vector(100.0),
            velocity: random.direction() * random.within(0.2, 1.5),
            reach: 60.0 + 35.0 + 18.0,
            length: random.within(50.0, 300.0),
            start,
        };
        let least_mm = random.within(1.0, 20.0);
        let watches =
            vec![Watch::Apart { a: if case % 2 == 0 { 0 } else { 1 }, b: if case % 2 == 0 { 1 } else { 0 }, least_mm }];
        let scene = Scene::new(vec![group("a", moving), group("b", standing)], watches).unwrap();
        let profile = scene.along(&motion, 12, &LIMITS).unwrap();
        let mut frames = [DAffine3::IDENTITY; 2];
        for k in 0..12 {
            let (from, to) = (profile.edges[k], profile.edges[k + 1]);
            let mut least = f64::INFINITY;
            for i in 0..=40 {
                let s = from + (to - from) * f64::from(i) / 40.0;
                motion.frames(s, &mut frames);
                let d = scene.evaluate(0, &frames, 200.0).distance;
                least = least.min(d);
                // Violations are inside a stretch; stretches contain only distances close to the limit or below.
                let within = profile.stretches.iter().any(|x| (x.from..=x.to).contains(&s));
                assert!(d >= least_mm || within, "{d} at {s} is in no stretch");
                assert!(d < 1.1 * least_mm + 0.2 || !within, "{d} at {s} is in a stretch below {least_mm}");
            }
            let bound = profile.traces[0].cells[k].at_least_mm;
            assert!(bound <= least.min(100.0) + 1e-9, "cell {k}: {bound} above {least}");
            // The bound is also tight: to the precision, and half a step of the dense sampling.
            let speed = motion.greatest_speed(0, 1, from, to);
            let short = 0.1 + 0.1 * least + speed * (to - from) / 80.0;
            assert!(bound >= least.min(100.0) - short, "cell {k}: {bound} for {least}");
        }
        assert_eq!(scene.is_clear_along(&motion, &LIMITS).unwrap(), profile.stretches.is_empty());
        for stretch in &profile.stretches {
            assert!(stretch.nearest.distance < least_mm + 0.05, "{stretch:?}");
            assert!(
                stretch.at_least_mm <= stretch.nearest.distance && stretch.from <= stretch.s && stretch.s <= stretch.to
            );
        }
    }
}

#[test]
fn permitted_zones_are_walked_too() {
    // A ball that leaves one permitted box for another that overlaps it, and then leaves that.
    let ball = solid(Shape::Sphere { radius: 5.0 }, DAffine3::IDENTITY);
    let zone = |x: f64| solid(Shape::Box { size: DVec3::splat(100.0) }, DAffine3::from_translation(DVec3::X * x));
    let watch = Watch::Inside { group: 0, of: 1, zones: vec![zone(0.0), zone(70.0)], least_mm: 2.0 };
    let scene = Scene::new(vec![group("torch", vec![ball]), group("base", Vec::new())], vec![watch]).unwrap();
    let profile = scene.along(&straight(DVec3::ZERO, DVec3::X * 150.0), 15, &LIMITS).unwrap();
    let [stretch] = &profile.stretches[..] else { panic!("{:?}", profile.stretches) };
    // The second box ends at 120: a margin of 2 mm is left until 113.
    assert!((stretch.from - 113.0).abs() < 0.02 && (stretch.to - 150.0).abs() < 1e-12, "{stretch:?}");
    assert!((stretch.nearest.distance + 35.0).abs() < 1e-9 && (stretch.s - 150.0).abs() < 1e-12);
    // At the change of boxes, 35: a margin of 50 - 35 - 5.
    let least = (0..10).map(|k| profile.traces[0].cells[k].at_least_mm).fold(f64::INFINITY, f64::min);
    assert!(least <= 10.0 && least > 8.5, "{least}");
}

#[test]
fn the_work_is_bounded() {
    struct Counted(Screw, std::cell::Cell<usize>);
    impl Motion for Counted {
        fn range(&self) -> (f64, f64) {
            self.0.range()
        }
        fn frames(&self, s: f64, frames: &mut [DAffine3]) {
            self.1.set(self.1.get() + 1);
            self.0.frames(s, frames);
        }
        fn greatest_speed(&self, _: usize, _: usize, _: f64, _: f64) -> f64 {
            self.0.reach
        }
    }
    /// The same, with the bend of a straight motion known.
    struct Straight(Counted);
    impl Motion for Straight {
        fn range(&self) -> (f64, f64) {
            self.0.range()
        }
        fn frames(&self, s: f64, frames: &mut [DAffine3]) {
            self.0.frames(s, frames);
        }
        fn greatest_speed(&self, a: usize, b: usize, from: f64, to: f64) -> f64 {
            self.0.greatest_speed(a, b, from, to)
        }
        fn greatest_bend(&self, _: usize, _: usize, _: f64, _: f64) -> f64 {
            0.0
        }
    }
    let ball = solid(Shape::Sphere { radius: 5.0 }, DAffine3::IDENTITY);
    let floor = |z: f64| solid(Shape::HalfSpace, DAffine3::from_translation(DVec3::Z * z));
    let scene = |z: f64| {
        let watch = Watch::Apart { a: 1, b: 0, least_mm: 1.0 };
        Scene::new(vec![group("a", vec![ball.clone()]), group("b", vec![floor(z)])], vec![watch]).unwrap()
    };
    let motion =
        |speed: f64| Counted(Screw { reach: speed, ..straight(DVec3::ZERO, DVec3::X * 100.0) }, Default::default());
    let limits = Limits { smallest: 0.1, ..LIMITS };
    let look = |z: f64, speed: f64| {
        let motion = motion(speed);
        let profile = scene(z).along(&motion, 100, &limits).unwrap();
        (profile, motion.1.get())
    };
    // Beside the floor, far nearer than the stations, also exactly at the limit: no more samples than one a station.
    for z in [-7.0, -6.000_001] {
        let motion = Straight(motion(1.0));
        let profile = scene(z).along(&motion, 100, &limits).unwrap();
        assert!(profile.stretches.is_empty() && motion.0.1.get() <= 101, "{}", motion.0.1.get());
        assert!(profile.traces[0].cells.iter().all(|c| (c.at_least_mm + z + 5.0).abs() < 1e-6));
    }
    // Far away: a few samples. Sliding exactly at the limit, or without a speed bound: not below the smallest cell.
    assert!(look(-1000.0, 1.0).1 < 10);
    for (z, speed) in [(-6.000_001, 1.0), (-50.0, f64::INFINITY), (-50.0, f64::NAN)] {
        let (profile, looks) = look(z, speed);
        assert!((100..2000).contains(&looks), "{looks}");
        assert!(profile.stretches.len() == 1 && profile.stretches[0].nearest.distance >= 1.0);
        assert!(profile.traces[0].cells.iter().all(|c| c.at_least_mm < 1.0));
    }
}

#[test]
fn frames_that_are_no_frames_are_not_clear() {
    let ball = solid(Shape::Sphere { radius: 5.0 }, DAffine3::IDENTITY);
    let zones = vec![solid(Shape::HalfSpace, DAffine3::IDENTITY)];
    let watches =
        vec![Watch::Apart { a: 0, b: 1, least_mm: 1.0 }, Watch::Inside { group: 0, of: 1, zones, least_mm: 1.0 }];
    let scene = Scene::new(vec![group("a", vec![ball.clone()]), group("b", vec![ball])], watches).unwrap();
    for x in [f64::NAN, f64::INFINITY, 1e300] {
        let motion = straight(DVec3::ZERO, DVec3::X * 10.0);
        let motion = Screw { start: DAffine3::from_translation(DVec3::X * x), ..motion };
        let profile = scene.along(&motion, 5, &LIMITS).unwrap();
        assert_eq!(profile.stretches.len(), 2);
        assert!(profile.stretches.iter().all(|s| s.nearest.distance <= 0.0 && s.from <= 0.0 && s.to >= 10.0));
    }
    let endless = Screw { length: f64::NAN, ..straight(DVec3::ZERO, DVec3::X) };
    assert!(!scene.along(&endless, 5, &LIMITS).unwrap().stretches.is_empty());
}

#[test]
fn scenes_that_say_nothing_are_refused() {
    let ball = solid(Shape::Sphere { radius: 5.0 }, DAffine3::IDENTITY);
    let floor = solid(Shape::HalfSpace, DAffine3::IDENTITY);
    let groups = || vec![group("ball", vec![ball.clone()]), group("floor", vec![floor.clone()])];
    let scene = |watch: Watch| Scene::new(groups(), vec![watch]).map(|_| ()).unwrap_err();
    let apart = |a, b| Watch::Apart { a, b, least_mm: 1.0 };
    assert_eq!(scene(apart(0, 2)), ClearanceError::NoSuchGroup { watch: 0, group: 2 });
    assert_eq!(scene(apart(1, 1)), ClearanceError::Endless { watch: 0, group: "floor".into() });
    for least_mm in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(scene(Watch::Apart { a: 0, b: 1, least_mm }), ClearanceError::Minimum { watch: 0 });
    }
    let inside = |group, zones| Watch::Inside { group, of: 1, zones, least_mm: 0.0 };
    assert_eq!(scene(inside(0, vec![])), ClearanceError::NoZone { watch: 0 });
    let cone = solid(Shape::Cone { radius: 1.0, top_radius: 0.0, length: 1.0 }, DAffine3::IDENTITY);
    assert_eq!(scene(inside(0, vec![cone])), ClearanceError::ZoneShape { watch: 0 });
    assert_eq!(scene(inside(1, vec![ball.clone()])), ClearanceError::Endless { watch: 0, group: "floor".into() });
    let fine = Scene::new(groups(), vec![apart(1, 0)]).unwrap();
    assert_eq!(fine.watches()[0].groups(), (0, 1));
    let no = fine.along(&straight(DVec3::ZERO, DVec3::X), 1, &Limits { smallest: 0.0, ..LIMITS });
    assert_eq!(no.unwrap_err(), ClearanceError::Limit { what: "clearance-smallest-cell" });
}
