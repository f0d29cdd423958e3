//! Shapes, zones and watches: shipped machines are clear at home; distances between links agree with brute force; speed
//! bounds hold.

use crate::common::{random_joints, shipped_machine};
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Limits, Shape, Solid, Watch};
use seamwright_machine::{Clamped, CollisionMonitor, Course, Joints, Machine, SHIPPED, Surroundings, shipped};
use seamwright_testkit::{Random, cases};

#[test]
fn shipped_machines_are_clear_at_home_and_watch_something() {
    for s in SHIPPED {
        let machine = shipped_machine(s.name);
        let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
        assert!(around.nearest(&machine.home(), 1e4).is_some(), "{}", s.name);
        assert!(around.is_clear(&machine.home()), "{}", s.name);
    }
}

/// A straight line in axis space: `s` from 0 to 1.
struct Straight {
    from: Joints,
    to: Joints,
}

impl Course for Straight {
    fn range(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn at(&self, s: f64) -> Joints {
        std::array::from_fn(|i| self.from[i] + s * (self.to[i] - self.from[i]))
    }
    fn greatest_rates(&self, _: f64, _: f64) -> Joints {
        std::array::from_fn(|i| (self.to[i] - self.from[i]).abs())
    }
    fn greatest_rate_changes(&self, _: f64, _: f64) -> Joints {
        Joints::default()
    }
}

/// Distances along random moves, straight and curved in the axes, by conservative sampling, are lower bounds of dense
/// sampling.
#[test]
fn distances_along_a_course_are_never_too_great() {
    for s in SHIPPED {
        let machine = shipped_machine(s.name);
        let ball = Solid::new(
            "ball",
            Shape::Sphere { radius: 60.0 },
            DAffine3::from_translation(DVec3::new(40.0, 20.0, 60.0)),
        );
        let clamped = Clamped { part: vec![ball.unwrap()], least_mm: 1.0, ..Clamped::default() };
        let around = Surroundings::new(&machine, &clamped).unwrap();
        let mut random = Random::new(17);
        for _ in 0..cases(20) {
            let (from, to) = (random_joints(&machine, &mut random), random_joints(&machine, &mut random));
            bounds_hold(s.name, &around, &Straight { from, to });
            let by: Joints = std::array::from_fn(|i| 0.3 * (to[i] - from[i]));
            bounds_hold(s.name, &around, &Bend { from, by, rates: by.map(|by| 1.9 * by.abs()) });
        }
    }
}

fn bounds_hold(name: &str, around: &Surroundings, course: &impl Course) {
    let machine = shipped_machine(name);
    let limits = Limits { cutoff_mm: 200.0, precision_mm: 2.0, smallest: 1e-4 };
    let profile = around.along(course, 50, &limits).unwrap();
    for i in 0..=1000 {
        let at = f64::from(i) / 1000.0;
        let frames = machine.link_frames(&course.at(at));
        let cell = ((at * 50.0) as usize).min(49);
        let neighbour = if i % 20 == 0 { cell.saturating_sub(1) } else { cell };
        for (watch, trace) in profile.traces.iter().enumerate() {
            let truth = distance(&machine, around, watch, &frames);
            let bound = trace.cells[cell].at_least_mm.min(trace.cells[neighbour].at_least_mm);
            assert!(bound <= truth + 1e-6, "{name} {:?}: {bound} > {truth} at {at}", around.bodies(watch));
        }
    }
}

/// The distance of a watch in one configuration, by the scene's own evaluation (tested against brute force in its
/// crate).
fn distance(machine: &Machine, around: &Surroundings, watch: usize, frames: &[DAffine3]) -> f64 {
    let groups: Vec<DAffine3> = around.scene().groups().iter().map(|g| frames[link_of(machine, &g.name)]).collect();
    around.scene().evaluate(watch, &groups, 1e6).distance
}

/// The link of a group by its name: that of its first frame; part and fixtures stand on the work.
fn link_of(machine: &Machine, group: &str) -> usize {
    let first = group.split('/').next().unwrap();
    match machine.links.frame(first) {
        Some(frame) => frame.link,
        None if group.contains("zone") => machine.links.base(),
        None => 0,
    }
}

#[test]
fn zones_are_watched() {
    let text = shipped("torch-5axis").unwrap().text.to_owned()
        + "
[[zones]]
name = \"cell\"
kind = \"permitted\"
watch = [\"torch\"]
least_mm = 2
[[zones.solids]]
shape.box = { size_mm = [600, 600, 600] }
at = { move_mm = [0, 0, 250] }
[[zones]]
name = \"clamp\"
kind = \"forbidden\"
on = \"work\"
watch = [\"torch\", \"part\"]
least_mm = 5
[[zones.solids]]
shape.sphere = { radius_mm = 50 }
at = { move_mm = [200, 0, 0] }
";
    let machine = Machine::read("m", &text).unwrap();
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    let at = |name: &str, value: f64, q: &Joints| {
        let mut q = *q;
        q[machine.axis(name).unwrap()] = value;
        q
    };
    let up = at("z", 100.0, &machine.home());
    assert!(around.is_clear(&up));
    // The torch reaches 14 mm to the side: 286 mm is the last position in the zone, 284 with its margin.
    assert!(around.is_clear(&at("y", 283.9, &up)) && !around.is_clear(&at("y", 284.1, &up)));
    // The forbidden ball moves with the table: x = 200 brings it under the torch.
    let low = at("z", 30.0, &machine.home());
    assert!(around.is_clear(&low) && !around.is_clear(&at("x", 200.0, &low)));
    let inside = around.scene().watches().iter().filter(|w| matches!(w, Watch::Inside { .. })).count();
    assert_eq!(inside, 1);
}

#[test]
fn mistakes_have_an_address() {
    let wrong = |more: &str| {
        let text = shipped("torch-5axis").unwrap().text.to_owned() + more;
        let e = Machine::read("m.toml", &text).unwrap_err();
        assert!(e.line > 0);
        (e.key.clone(), e.to_string())
    };
    let stl = |shape: &str| format!("[[shapes.b]]\nshape.{shape}\n");
    assert_eq!(wrong("[[shapes.wrist]]\nshape.sphere = { radius_mm = 4 }\n").0, "shapes.wrist");
    assert_eq!(wrong(&stl("sphere = { radius_mm = 0 }")).0, "shapes.b[0].shape.sphere.radius_mm");
    assert_eq!(wrong(&stl("ball = { radius_mm = 3 }")).0, "shapes.b[0].shape.ball");
    let missing = wrong(&stl("stl = { file = \"gone.stl\" }"));
    assert_eq!(missing.0, "shapes.b[0].shape.stl.file");
    assert!(missing.1.contains("could not be read"));
    let zone = |k: &str, more: &str| format!("[[zones]]\nname = \"z\"\nkind = \"{k}\"\n{more}\n");
    let cone = "[[zones.solids]]\nshape.cone = { radius_mm = 4, length_mm = 9 }\n";
    assert_eq!(wrong(&zone("permitted", cone)).0, "zones[0].solids[0]");
    assert_eq!(wrong(&zone("permitted", "solids = []")).0, "zones[0].solids");
    assert_eq!(wrong(&zone("allowed", cone)).0, "zones[0].kind");
    assert_eq!(wrong(&zone("forbidden", &format!("on = \"w\"\n{cone}"))).0, "zones[0].on");
    assert_eq!(wrong(&zone("forbidden", &format!("watch = [\"torch\", \"parts\"]\n{cone}"))).0, "zones[0].watch[1]");
    assert_eq!(wrong("[clearance]\nignore = [[\"a\", \"q\"]]\n").0, "clearance.ignore[0][1]");
    assert_eq!(wrong("[clearance]\nleast_mm = -1\n").0, "clearance.least_mm");
}

#[test]
fn stl_files_are_checked() {
    let facet = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        let v = |p: [f64; 3]| format!("vertex {} {} {}\n", p[0], p[1], p[2]);
        format!("facet normal 0 0 0\nouter loop\n{}{}{}endloop\nendfacet\n", v(a), v(b), v(c))
    };
    let (o, x, y, z) = ([0.0; 3], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 9.0]);
    let body = facet(o, y, x) + &facet(o, x, z) + &facet(o, z, y);
    let whole = format!("solid s\n{body}{}endsolid s\n", facet(x, y, z));
    let text = shipped("torch-5axis").unwrap().text.to_owned() + "[[shapes.b]]\nshape.stl = { file = \"t.stl\" }\n";
    let read = |stl: String| {
        Machine::read_with("m.toml", &text, &move |name| {
            assert_eq!(name, "t.stl");
            Ok(stl.clone().into_bytes())
        })
    };
    let machine = read(whole.clone()).unwrap();
    assert!(machine.solids.solids.iter().any(|(_, s)| s.name() == "b: t.stl"));
    for (bad, what) in [
        (format!("solid s\n{body}endsolid s\n"), "not closed"),
        (whole.replace("vertex 0 0 9", "vertex 0 nan 9"), "finite"),
        ("solid s\nendsolid s\n".to_owned(), "triangle"),
    ] {
        let e = read(bad).unwrap_err();
        assert_eq!(e.key, "shapes.b[0].shape.stl.file");
        assert!(e.to_string().contains(what), "{what}: {e}");
    }
}

/// A curved motion of all axes for `s` from 0 to 1.
struct Bend {
    from: Joints,
    by: Joints,
    rates: Joints,
}

impl Course for Bend {
    fn range(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn at(&self, s: f64) -> Joints {
        std::array::from_fn(|i| self.from[i] + self.by[i] * s + 0.3 * self.by[i] * (3.0 * s + i as f64).sin())
    }
    fn greatest_rates(&self, _from: f64, _to: f64) -> Joints {
        self.rates
    }
    fn greatest_rate_changes(&self, from: f64, to: f64) -> Joints {
        // The second derivative is at most 0.3 times the square of 3.
        std::array::from_fn(|i| self.by[i].abs() * (2.7 * (to - from)).min(1.8))
    }
}

/// Motions proven by a monitor are clear at every sample, and it proves most motions that are clear with a margin.
#[test]
fn keepers_prove_only_what_is_so() {
    let block = Solid::new("block", Shape::Box { size: DVec3::splat(90.0) }, DAffine3::IDENTITY).unwrap();
    let clamped = Clamped { part: vec![block], least_mm: 2.0, ..Clamped::default() };
    for name in ["torch-5axis", "table-tilting-xyzac", "ebw-7axis", "dual-laser-10axis"] {
        let machine = shipped_machine(name);
        let around = Surroundings::new(&machine, &clamped).unwrap();
        let mut monitor = CollisionMonitor::new(&around, &machine.home());
        let mut random = Random::new(2);
        let (mut proven, mut missed, mut touching) = (0, 0, 0);
        let mut from = random_joints(&machine, &mut random);
        for case in 0..cases(1200) {
            if case % 8 == 0 {
                from = random_joints(&machine, &mut random);
            }
            let far = random_joints(&machine, &mut random);
            // From 1e-5 to a tenth of the way.
            let part = 10f64.powi(-1 - (case % 5));
            let by: Joints = std::array::from_fn(|i| part * (far[i] - from[i]));
            let bend = Bend { from, by, rates: by.map(|b| 1.9 * b.abs()) };
            let places: Vec<Joints> = (0..=60).map(|i| bend.at(f64::from(i) / 60.0)).collect();
            let ends = |pick: fn(f64, f64) -> f64| -> Joints {
                // Between the samples it goes a little farther.
                let more = |i: usize| pick(-1.0, 1.0) * 0.02 * by[i].abs();
                std::array::from_fn(|i| places.iter().map(|q| q[i]).reduce(pick).unwrap() + more(i))
            };
            let clear = places.iter().all(|q| around.is_clear(q));
            match monitor.prove(&bend, &ends(f64::min), &ends(f64::max), 16) {
                Ok(()) => {
                    assert!(clear, "{name}: {case}");
                    proven += 1;
                }
                Err(watch) => {
                    assert!(watch < around.scene().watches().len());
                    if clear { missed += 1 } else { touching += 1 }
                }
            }
            from = places[60];
            if !around.is_clear(&from) {
                from = random_joints(&machine, &mut random);
            }
        }
        assert!(proven > 200 && missed * 10 < proven && touching > 0);
    }
}
