//! The crawl with a simulated camera on a known joint: exact except for noise, tacks and the frame's edge.

use glam::{DAffine3, DMat3, DVec2, DVec3};
use seamwright_message::Message;
use seamwright_teaching::{
    Answer, CameraPose, Command, Crawl, End, Event, FrameEnd, Patch, Row, Seen, Settings, Shape, View, smoothed,
};
use seamwright_testkit::Random;
use seamwright_vision::camera::{HeightTable, MapParameters, PlaneMap};

const SIZE: f64 = 512.0;

/// A beam deflected about a point 260 mm above the work.
fn table() -> HeightTable {
    let row = |height: f64| {
        let parameters = MapParameters {
            size_px: (512, 512),
            centre_px: DVec2::splat(255.5),
            mm_per_px: DVec2::splat(0.1 * (260.0 + height) / 260.0),
            rotation: 0.0,
            shear: 0.0,
            barrel: -0.01,
        };
        (height, PlaneMap::new(parameters).unwrap())
    };
    HeightTable::new(vec![row(-40.0), row(40.0)]).unwrap()
}

struct Cylinder(f64);

impl Shape for Cylinder {
    fn near(&self, point: DVec3) -> Option<Patch> {
        let normal = DVec3::new(point.x, point.y, 0.0).normalize();
        Some(Patch { point: DVec3::new(0.0, 0.0, point.z) + self.0 * normal, normal })
    }
}

struct Plane;

impl Shape for Plane {
    fn near(&self, point: DVec3) -> Option<Patch> {
        Some(Patch { point: DVec3::new(point.x, point.y, 0.0), normal: DVec3::Z })
    }
}

/// A joint as points every 0.1 mm, open or closed, with hidden stretches.
struct World {
    points: Vec<DVec3>,
    closed: bool,
    hidden: Vec<(f64, f64)>,
    noise: f64,
    random: Random,
}

impl World {
    fn new(curve: impl Fn(f64) -> DVec3, closed: bool) -> Self {
        let fine: Vec<DVec3> = (0..=200_000).map(|i| curve(f64::from(i) / 200_000.0)).collect();
        let (mut points, mut way) = (vec![fine[0]], 0.0);
        for w in fine.windows(2) {
            way += w[0].distance(w[1]);
            if way >= 0.1 * points.len() as f64 {
                points.push(w[1]);
            }
        }
        Self { points, closed, hidden: Vec::new(), noise: 0.2, random: Random::new(11) }
    }

    fn at(&self, i: i64) -> Option<DVec3> {
        let count = self.points.len() as i64;
        let i = if self.closed { i.rem_euclid(count) } else { i };
        usize::try_from(i).ok().and_then(|i| self.points.get(i)).copied()
    }

    fn distance(&self, p: DVec3) -> f64 {
        self.points
            .windows(2)
            .map(|w| {
                let (along, off) = (w[1] - w[0], p - w[0]);
                let part = (off.dot(along) / along.length_squared()).clamp(0.0, 1.0);
                (off - part * along).length()
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// Simulates the midline that a follower detects from `start` along `direction`.
    fn midline(
        &mut self,
        table: &HeightTable,
        camera: &DAffine3,
        start: DVec2,
        direction: DVec2,
    ) -> (Vec<Row>, FrameEnd) {
        let back = camera.inverse();
        let px = |p: DVec3| {
            let seen = back.transform_point3(p);
            table.to_px(seen).ok().filter(|px| px.min_element() >= 0.0 && px.max_element() <= SIZE - 1.0)
        };
        let nearest = (0..self.points.len() as i64)
            .filter_map(|i| Some((i, px(self.at(i)?)?.distance(start))))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((from, off)) = nearest else { return (Vec::new(), FrameEnd::Lost) };
        if off > 20.0 {
            return (Vec::new(), FrameEnd::Lost);
        }
        let sense = match (self.at(from - 3), self.at(from + 3)) {
            (Some(a), Some(b)) => px(b).zip(px(a)).map_or(1.0, |(b, a)| (b - a).dot(direction)),
            (None, _) => 1.0,
            (_, None) => -1.0,
        };
        let mut rows = Vec::new();
        let mut dark = 0;
        for k in 0.. {
            let i = if sense > 0.0 { from + k } else { from - k };
            let Some(point) = self.at(i) else { return (rows, FrameEnd::JointEnd) };
            let Some(at) = px(point) else { return (rows, FrameEnd::LeftImage) };
            let way = 0.1 * i.rem_euclid(self.points.len() as i64) as f64;
            let seen = !self.hidden.iter().any(|(a, b)| (*a..*b).contains(&way));
            dark = if seen { 0 } else { dark + 1 };
            if dark > 100 {
                return (rows, FrameEnd::Lost);
            }
            let noise =
                DVec2::new(self.random.within(-1.0, 1.0), self.random.within(-1.0, 1.0)) * self.noise * 3f64.sqrt();
            rows.push(Row { px: at + noise, confidence: if seen { 0.9 } else { 0.0 }, seen });
        }
        unreachable!()
    }
}

fn start(at: DVec3, along: DVec3, normal: DVec3) -> CameraPose {
    CameraPose { point: at, normal, along: along.normalize() }
}

/// Height of the true surface on the optical axis.
fn height(truth: &dyn Shape, camera: &DAffine3) -> f64 {
    let axis = camera.transform_vector3(DVec3::Z);
    (0..20).fold(0.0, |height, _| {
        let point = camera.transform_point3(DVec3::Z * height);
        let patch = truth.near(point).unwrap();
        height - (point - patch.point).dot(patch.normal) / axis.dot(patch.normal)
    })
}

/// Runs a crawl; `refuse` marks poses out of the machine's reach, `answer` gives the operator's answers.
fn crawl<'a>(
    world: &mut World,
    table: &'a HeightTable,
    shape: &'a dyn Shape,
    truth: &dyn Shape,
    from: CameraPose,
    refuse: impl Fn(&CameraPose) -> bool,
    mut answer: impl FnMut(&str) -> Answer,
) -> (Crawl<'a>, End) {
    let mut crawl = Crawl::new(Settings::default(), table, shape, from);
    let mut command = crawl.next(Event::Start);
    let mut camera = DAffine3::IDENTITY;
    for _ in 0..2000 {
        command = match command {
            Command::Move(pose) if refuse(&pose) => crawl.next(Event::Refused(Message::verbatim("axis x"))),
            Command::Move(pose) => {
                // The direction of the picture's x axis is arbitrary.
                let z = -pose.normal;
                let x = z.any_orthonormal_vector();
                camera = DAffine3 { matrix3: DMat3::from_cols(x, z.cross(x), z), translation: pose.point - 3.0 * z };
                crawl.next(Event::Reached)
            }
            Command::Look => {
                // Focus measures the height of the work to 0.02 mm.
                let height = height(truth, &camera) + 0.02 * world.random.within(-1.0, 1.0);
                let view = View { camera, height: Some(height) };
                let aim = crawl.aim(&view).unwrap();
                let (rows, end) = world.midline(table, &camera, aim.start, aim.direction);
                crawl.next(Event::Seen(Seen { view, rows: &rows, end }))
            }
            Command::Ask(why) => crawl.next(Event::Operator(answer(&why.to_string()))),
            Command::Done(end) => return (crawl, end),
        };
    }
    panic!("no end: {:?}", crawl.notes().last());
}

/// Returns RMS and maximum distance of the smoothed line from the joint, without bridged stretches.
fn errors(world: &World, crawl: &Crawl, closed: bool) -> (f64, f64) {
    let line = smoothed(crawl.line(), 1.0, 2.5, closed);
    let off: Vec<f64> = line.iter().filter(|p| p.confidence > 0.0).map(|p| world.distance(p.point)).collect();
    let square = off.iter().map(|d| d * d).sum::<f64>() / off.len() as f64;
    (square.sqrt(), off.iter().copied().fold(0.0, f64::max))
}

fn no_one(why: &str) -> Answer {
    panic!("asked: {why}")
}

/// An ellipse on a cylinder: a tube cut at 20 degrees.
fn oblique(t: f64) -> DVec3 {
    let (sin, cos) = (t * std::f64::consts::TAU).sin_cos();
    DVec3::new(150.0 * cos, 150.0 * sin, 150.0 * 20f64.to_radians().tan() * cos)
}

#[test]
fn a_closed_joint_round_a_tube_closes() {
    let table = table();
    let mut world = World::new(oblique, true);
    world.hidden = vec![(100.0, 106.0), (400.0, 404.0)];
    let from = start(oblique(0.0) + DVec3::new(0.0, 0.3, 0.4), DVec3::new(0.0, 1.0, 0.2), DVec3::X);
    let (crawl, end) = crawl(&mut world, &table, &Cylinder(149.0), &Cylinder(150.0), from, |_| false, no_one);
    let End::Closed { gap_mm } = end else { panic!("{end:?}") };
    let (rms, max) = errors(&world, &crawl, true);
    assert!(gap_mm < 0.1 && rms < 0.03 && max < 0.1, "gap {gap_mm}, rms {rms}, max {max}");
    let length = 0.1 * world.points.len() as f64;
    assert!((crawl.line().length() - length).abs() < 0.02 * length);
    // Steps are long where the joint is clearly visible, so that few frames suffice.
    assert!(crawl.notes().len() < 160, "{}", crawl.notes().len());
    assert!(crawl.notes().iter().skip(1).filter(|n| n.overlap_mm.is_some()).count() > 100);
}

#[test]
fn without_a_known_shape_the_normal_goes_along() {
    let table = table();
    // Half round a tube cut square: the normal turns by half a turn.
    let half = |t: f64| DVec3::new(100.0 * (3.0 * t).cos(), 100.0 * (3.0 * t).sin(), 0.0);
    let mut world = World::new(half, false);
    let from = start(half(0.0), DVec3::Y, DVec3::X);
    let (crawl, end) = crawl(&mut world, &table, &(), &Cylinder(100.0), from, |_| false, no_one);
    assert_eq!(end, End::JointEnd);
    let last = crawl.line().points().last().unwrap();
    assert!(last.point.distance(half(1.0)) < 0.3, "{}", last.point);
    assert!(crawl.target().normal.dot(half(1.0).normalize()) > 0.99, "{}", crawl.target().normal);
}

/// An S of two arcs of radius 60 mm.
fn s_curve(t: f64) -> DVec3 {
    let way = 240.0 * t;
    let angle = |w: f64| w / 60.0;
    if way <= 120.0 {
        DVec3::new(60.0 * angle(way).sin(), 60.0 * (1.0 - angle(way).cos()), 0.0)
    } else {
        let (joint, a) = (s_curve(0.5), angle(120.0));
        let centre = joint + 60.0 * DVec3::new(-a.sin(), a.cos(), 0.0);
        let (b, other) = (angle(way - 120.0), 2.0 * joint - centre);
        let out = joint - other;
        let (sin, cos) = (-b).sin_cos();
        other + DVec3::new(cos * out.x - sin * out.y, sin * out.x + cos * out.y, 0.0)
    }
}

#[test]
fn an_open_joint_ends_where_it_ends() {
    let table = table();
    let mut world = World::new(s_curve, false);
    world.hidden = vec![(60.0, 65.0), (150.0, 154.0)];
    let (crawl, end) =
        crawl(&mut world, &table, &Plane, &Plane, start(DVec3::ZERO, DVec3::X, DVec3::Z), |_| false, no_one);
    assert_eq!(end, End::JointEnd);
    let (rms, max) = errors(&world, &crawl, false);
    assert!(rms < 0.03 && max < 0.1, "rms {rms}, max {max}");
    assert!(crawl.line().points().last().unwrap().point.distance(s_curve(1.0)) < 0.3);
}

#[test]
fn lost_it_asks_and_goes_on_from_the_operators_point() {
    let table = table();
    let mut world = World::new(s_curve, false);
    world.hidden = vec![(80.0, 130.0)];
    let beyond = world.points[1320];
    let mut asked = Vec::new();
    let from = start(DVec3::ZERO, DVec3::X, DVec3::Z);
    let (crawl, end) = crawl(
        &mut world,
        &table,
        &Plane,
        &Plane,
        from,
        |pose| pose.point.z > 10.0,
        |why| {
            asked.push(why.to_owned());
            // The operator's first point is out of reach.
            let up = if asked.len() == 1 { 20.0 } else { 0.0 };
            Answer::Point(beyond + DVec3::new(0.3, 0.2, up), Some(s_curve(0.56) - s_curve(0.55)))
        },
    );
    assert_eq!((end, asked.len()), (End::JointEnd, 2), "{asked:?}");
    assert_eq!(asked[1], "axis x");
    assert!(crawl.line().points().iter().all(|p| p.point.z < 1.0));
    assert!(crawl.line().points().last().unwrap().point.distance(s_curve(1.0)) < 0.3);
    let (rms, max) = errors(&world, &crawl, false);
    assert!(rms < 0.03 && max < 0.15, "rms {rms}, max {max}");
    // The gap has no points.
    let gap = crawl.line().ways().windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
    assert!(gap > 40.0, "{gap}");
}

#[test]
fn an_operator_who_gives_up_keeps_what_was_found() {
    let table = table();
    let mut world = World::new(s_curve, false);
    world.hidden = vec![(80.0, 130.0)];
    let from = start(DVec3::ZERO, DVec3::X, DVec3::Z);
    let (crawl, end) = crawl(&mut world, &table, &Plane, &Plane, from, |_| false, |_| Answer::End);
    assert_eq!(end, End::Operator);
    assert!((crawl.line().length() - 80.0).abs() < 1.0, "{}", crawl.line().length());
}

#[test]
fn limits_stop_it_short_of_them() {
    let table = table();
    let mut world = World::new(s_curve, false);
    let from = start(DVec3::ZERO, DVec3::X, DVec3::Z);
    let (crawl, end) = crawl(&mut world, &table, &Plane, &Plane, from, |pose| pose.point.x > 40.0, no_one);
    assert_eq!(end, End::Limit(Message::verbatim("axis x")));
    assert!(crawl.target().point.x > 39.0, "{}", crawl.target().point.x);
    // An unreachable start gives an empty line.
    let (crawl, end) = self::crawl(&mut world, &table, &Plane, &Plane, from, |_| true, no_one);
    assert!(crawl.line().is_empty() && matches!(end, End::Limit(_)));
}

#[test]
fn frames_that_do_not_agree_are_not_believed() {
    let table = table();
    let plane = Plane;
    let mut world = World::new(s_curve, false);
    let mut crawl = Crawl::new(Settings::default(), &table, &plane, start(DVec3::ZERO, DVec3::X, DVec3::Z));
    crawl.next(Event::Start);
    let mut looks = 0;
    let mut command = crawl.next(Event::Reached);
    let mut camera = DAffine3::IDENTITY;
    let why = loop {
        command = match command {
            Command::Move(pose) => {
                let z = -pose.normal;
                let x = z.any_orthonormal_vector();
                camera = DAffine3 { matrix3: DMat3::from_cols(x, z.cross(x), z), translation: pose.point };
                crawl.next(Event::Reached)
            }
            Command::Look => {
                looks += 1;
                if looks == 1 {
                    let z = DVec3::NEG_Z;
                    let x = z.any_orthonormal_vector();
                    camera = DAffine3 { matrix3: DMat3::from_cols(x, z.cross(x), z), translation: DVec3::ZERO };
                }
                let view = View { camera, height: Some(0.0) };
                let aim = crawl.aim(&view).unwrap();
                // From the fifth frame on the picture is shifted: a scratch beside the joint.
                let (mut rows, end) = world.midline(&table, &camera, aim.start, aim.direction);
                if looks >= 5 {
                    rows.iter_mut().for_each(|r| r.px += DVec2::new(12.0, -12.0));
                }
                crawl.next(Event::Seen(Seen { view, rows: &rows, end }))
            }
            Command::Ask(why) => break why,
            Command::Done(end) => panic!("{end:?}"),
        };
    };
    assert!(why.code == "tracking-crawl-frames-apart" && looks == 6, "{why} after {looks}");
    assert!(crawl.line().points().iter().all(|p| world.distance(p.point) < 0.2));
}
