//! The groove in the part's solids, against the polygons of the cross-section: air within the groove, metal beside it,
//! distances between.

use crate::jobs::{WithSeam, job};
use crate::part::NO_STL;
use glam::{DAffine3, DVec2, DVec3};
use seamwright_clearance::{Shape, Solid, nearest};
use seamwright_testkit::{Random, cases};
use seamwright_weld::{SeamPoint, Section, Welding};

/// Distance of a point from solids, mm; 0 inside.
fn distance(part: &[Solid], at: DVec3) -> f64 {
    let ball = Solid::new("ball", Shape::Sphere { radius: 1e-6 }, DAffine3::from_translation(at)).unwrap();
    let one = |s: &Solid| nearest(&ball, &DAffine3::IDENTITY, s, &DAffine3::IDENTITY, 1e6).unwrap().distance;
    part.iter().map(one).fold(f64::INFINITY, f64::min)
}

/// The groove's polygon, counter-clockwise.
fn polygon(section: &Section) -> Vec<DVec2> {
    section.first.iter().chain(section.second.iter().rev()).copied().collect()
}

fn is_inside(polygon: &[DVec2], p: DVec2) -> bool {
    (0..polygon.len()).fold(false, |inside, i| {
        let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let crosses = (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
        inside != crosses
    })
}

/// Distance of a point from the edges of both parts.
fn from_edges(section: &Section, p: DVec2) -> f64 {
    let one = |pair: &[DVec2]| {
        let along = pair[1] - pair[0];
        let part = ((p - pair[0]).dot(along) / along.length_squared().max(1e-30)).clamp(0.0, 1.0);
        p.distance(pair[0] + part * along)
    };
    section.first.windows(2).chain(section.second.windows(2)).map(one).fold(f64::INFINITY, f64::min)
}

/// A random preparation for a nozzle or a butt joint.
fn preparation(random: &mut Random, butt: bool) -> String {
    let thick = random.within(6.0, 40.0);
    let (gap, face) = (random.within(0.5, 3.0), random.within(0.5, 2.0));
    let common = format!("thickness_mm = {thick}\nroot_gap_mm = {gap}\nroot_face_mm = {face}\n");
    let round = format!("radius_mm = {}\nland_mm = 0\n", random.within(3.0, 5.0));
    match (butt, random.below(4)) {
        (true, 0) => format!("[joint.preparation.single_v]\nangle_deg = {}\n{common}", random.within(20.0, 70.0)),
        (true, 1) => format!("[joint.preparation.u]\nangle_deg = {}\n{round}{common}", random.within(2.0, 20.0)),
        (true, 2) => format!(
            "[joint.preparation.bevel]\nprepared = \"second\"\nangle_deg = {}\n{common}",
            random.within(15.0, 55.0)
        ),
        (true, _) => format!("[joint.preparation.square]\nthickness_mm = {thick}\nroot_gap_mm = {gap}\n"),
        (false, kind) => {
            let prepared = if kind % 2 == 0 { "first" } else { "second" };
            let leg = random.within(0.0, 8.0);
            let name = if kind < 2 { "t_bevel" } else { "t_j" };
            let round = if kind < 2 { String::new() } else { round };
            let angle = if kind < 2 { random.within(20.0, 50.0) } else { random.within(5.0, 20.0) };
            format!(
                "[joint.preparation.{name}]\nprepared = \"{prepared}\"\nangle_deg = {angle}\nleg_mm = {leg}\n{round}{common}"
            )
        }
    }
}

fn seam(random: &mut Random) -> (String, bool) {
    let radius = random.within(60.0, 200.0);
    let shell = radius * random.within(2.0, 8.0);
    match random.below(7) {
        0 => (format!("[seam.nozzle]\nradius_mm = {radius}\n[seam.nozzle.body.cylinder]\nradius_mm = {shell}\naxis = [1, 0, 0]\n"), false),
        1 => (format!("[seam.nozzle]\nradius_mm = {radius}\norigin_mm = [0, {}, 0]\n[seam.nozzle.body.cylinder]\nradius_mm = {shell}\naxis = [1, 0, 0]\n", 0.3 * (shell - radius)), false),
        2 => (format!("[seam.nozzle]\nradius_mm = {radius}\ndirection = [0.3, 0, 1]\n[seam.nozzle.body.sphere]\nradius_mm = {shell}\n"), false),
        3 => (format!("[seam.branch]\nradius_mm = {radius}\nchord_radius_mm = {shell}\nangle_deg = {}\n", random.within(60.0, 90.0)), false),
        4 => (format!("[seam.girth]\nradius_mm = {shell}\n"), true),
        5 => (format!("[seam.circle]\nradius_mm = {radius}\n"), false),
        _ => ("[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [200, 0, 0]\nfirst_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n".to_owned(), true),
    }
}

fn space(p: &SeamPoint, at: DVec2) -> DVec3 {
    p.point + at.x * p.towards_first + at.y * p.bisector
}

#[test]
fn a_groove_is_air_and_its_walls_are_metal() {
    let mut random = Random::new(46);
    let (mut joints, mut points) = (0, 0);
    for _ in 0..cases(24) {
        let (seam, butt) = seam(&mut random);
        let text = format!("{}\n[joint]\ncap_mm = 1\n{}", job(&seam), preparation(&mut random, butt));
        let Ok(welding) = Welding::read("job.toml", &text) else { continue };
        let part = welding.clamped(NO_STL).unwrap_or_else(|e| panic!("{e}\n{text}")).part;
        let joint = welding.joint.as_ref().unwrap();
        joints += 1;
        for _ in 0..25 {
            let p = welding.seam().at(random.within(0.02, 0.98) * welding.seam().weld_length());
            let section = joint.section(&p).unwrap();
            let polygon = polygon(&section);
            let (low, high) = polygon.iter().fold((polygon[0], polygon[0]), |(l, h), q| (l.min(*q), h.max(*q)));
            let at = DVec2::new(random.within(low.x, high.x), random.within(low.y, high.y));
            let off = from_edges(&section, at);
            let found = distance(&part, space(&p, at));
            // The bottom between the roots is metal too; surfaces that curve leave the section's straight lines.
            let root = [section.first[0], section.second[0]];
            let bottom = between([at, at], root).0;
            if is_inside(&polygon, at) {
                points += 1;
                let curved = off * off / 50.0;
                assert!(found <= off + 0.05, "{found} mm from metal, {off} from the edges, at s = {}\n{text}", p.s);
                let expected = off.min(bottom) - curved - 0.1;
                assert!(
                    found >= expected,
                    "{found} mm from metal, {off} and {bottom} from the edges, at s = {} {at}\n{text}",
                    p.s
                );
            }
            // Just behind the walls there is metal.
            for edge in [&section.first, &section.second] {
                let k = random.below(edge.len() - 1);
                let (a, b) = (edge[k], edge[k + 1]);
                let n = (b - a).perp().normalize_or_zero();
                let n = if is_inside(&polygon, a.midpoint(b) + 1e-6 * n) { -n } else { n };
                let behind = distance(&part, space(&p, a.midpoint(b) + 0.03 * n));
                assert!(behind < 0.06, "{behind} mm behind a wall at s = {}\n{text}", p.s);
            }
        }
    }
    println!("{joints} joints, {points} points");
    assert!(joints > 12 && points > 100, "{joints} joints, {points} points");
}

/// Nearest points of two segments in the plane, by their ends and their crossing.
fn between(a: [DVec2; 2], b: [DVec2; 2]) -> (f64, DVec2) {
    let foot = |p: DVec2, s: [DVec2; 2]| {
        let along = s[1] - s[0];
        s[0] + ((p - s[0]).dot(along) / along.length_squared().max(1e-30)).clamp(0.0, 1.0) * along
    };
    let cross = |s: [DVec2; 2], p: DVec2| (s[1] - s[0]).perp_dot(p - s[0]);
    if cross(a, b[0]) * cross(a, b[1]) < 0.0 && cross(b, a[0]) * cross(b, a[1]) < 0.0 {
        return (0.0, b[0]);
    }
    let ends = [
        (a[0].distance(foot(a[0], b)), foot(a[0], b)),
        (a[1].distance(foot(a[1], b)), foot(a[1], b)),
        (b[0].distance(foot(b[0], a)), b[0]),
        (b[1].distance(foot(b[1], a)), b[1]),
    ];
    ends.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

/// A torch in the groove of a straight joint: distance and height of the nearest point of the part are those of a
/// rectangle and the cross-section's polygon.
#[test]
fn a_torch_in_a_straight_groove_touches_where_polygons_do() {
    let mut random = Random::new(47);
    let mut heights = 0;
    for _ in 0..cases(30) {
        let butt = random.yes();
        let first = if butt { "[0, 0, 1]" } else { "[0, 1, 0]" };
        let seam = format!(
            "[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [400, 0, 0]\nfirst_normal = {first}\nsecond_normal = [0, 0, 1]\n"
        );
        let text = format!("{}\n[joint]\ncap_mm = 1\n{}", job(&seam), preparation(&mut random, butt));
        let Ok(welding) = Welding::read("job.toml", &text) else { continue };
        let part = welding.clamped(NO_STL).unwrap().part;
        let p = welding.seam().at(200.0);
        let section = welding.joint.as_ref().unwrap().section(&p).unwrap();
        let (sin, cos) = (0.5 * section.dihedral).sin_cos();
        let [first, second] = section.toes();
        let faces = [[first, first + 95.0 * DVec2::new(sin, cos)], [second, second + 95.0 * DVec2::new(-sin, cos)]];
        for _ in 0..12 {
            // A torch of this radius and length whose axis lies in the plane of the section.
            let (radius, length) = (random.within(0.3, 4.0), random.within(20.0, 60.0));
            let (low, high) = section.slices.heights();
            let height = random.within(low + 1.0, high + 15.0);
            let (left, right) = section.slices.edges(height.min(high - 1e-6));
            let tip = section.place(random.within(left, right), height);
            let lean = section.up.x.atan2(section.up.y) + random.within(-0.2, 0.2);
            let axis = DVec2::new(lean.sin(), lean.cos());
            let corners = [(-1.0, 0.0), (1.0, 0.0), (1.0, length), (-1.0, length)]
                .map(|(side, along)| tip + side * radius * axis.perp() + along * axis);
            let sides = [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]]);
            let root = [section.first[0], section.second[0]];
            let walls = section.first.windows(2).chain(section.second.windows(2)).map(|w| [w[0], w[1]]);
            let lines: Vec<[DVec2; 2]> = walls.chain(faces).chain([root]).collect();
            let nearest_2d =
                lines.iter().flat_map(|l| sides.map(|s| between(s, *l))).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            let along = space(&p, axis) - p.point;
            let pose = DAffine3::from_mat3_translation(
                glam::DMat3::from_cols(p.tangent, along.cross(p.tangent), along),
                space(&p, tip),
            );
            let torch = Solid::new("torch", Shape::Cylinder { radius, length }, pose).unwrap();
            let one = |s: &Solid| nearest(&torch, &DAffine3::IDENTITY, s, &DAffine3::IDENTITY, 1e6).unwrap();
            let found = part.iter().map(one).min_by(|a, b| a.distance.total_cmp(&b.distance)).unwrap();
            if nearest_2d.0 > 1e-3 {
                assert!(
                    (found.distance - nearest_2d.0).abs() < 0.04,
                    "{} for {}\n{text}",
                    found.distance,
                    nearest_2d.0
                );
                let of = (found.on_b - p.point).dot(p.bisector);
                // One nearest point only.
                let others = lines.iter().flat_map(|l| sides.map(|s| between(s, *l)));
                if others.filter(|o| o.0 < nearest_2d.0 + 0.1).all(|o| o.1.distance(nearest_2d.1) < 0.5) {
                    heights += 1;
                    assert!((of - nearest_2d.1.y).abs() < 0.6, "{of} for {}\n{text}", nearest_2d.1.y);
                }
            }
        }
    }
    assert!(heights > 50, "{heights}");
}

/// The wire tips of all beads are outside of the part and of earlier beads, but for their crowns.
#[test]
fn the_wire_is_never_inside_metal() {
    let mut random = Random::new(48);
    let (mut welds, mut tips) = (0, 0);
    for _ in 0..cases(24) {
        let (seam, butt) = seam(&mut random);
        let text = format!(
            "{}\n[joint]\ncap_mm = 1\n{}[beads]\nstation_mm = 20\nfill = {{ area_mm2 = {}, layer_mm = {} }}\n",
            job(&seam),
            preparation(&mut random, butt),
            random.within(20.0, 60.0),
            random.within(2.5, 4.0)
        );
        let Ok(welding) = Welding::read("job.toml", &text) else { continue };
        // Metal of more beads side by side is rounded up to columns, and crowns grow with the layer: no bead fills a
        // deep square gap.
        if text.contains("square") || welding.plan.as_ref().unwrap().layers.iter().any(|layer| layer.beads > 4) {
            continue;
        }
        welds += 1;
        let part = welding.clamped(NO_STL).unwrap().part;
        let metal = welding.metal().unwrap();
        let metal: Vec<Vec<Solid>> =
            metal.by_pass().collect::<Result<_, _>>().unwrap_or_else(|e| panic!("{e}\n{text}"));
        for (i, before) in metal.iter().enumerate().take(welding.program.value.passes.len()) {
            let path = welding.path(i);
            let path = path.along_seam().unwrap();
            for _ in 0..6 {
                let p = path.seam_point(random.within(0.05, 0.95) * path.stretch.length);
                let (tip, _) = path.torch_at(&p);
                let section = welding.joint.as_ref().unwrap().section(&p).unwrap();
                let crown = 0.4 * (space(&p, section.up) - p.point);
                tips += 1;
                assert!(distance(&part, tip + 1e-3 * crown) > 0.0, "pass {i} at s = {} is in the part\n{text}", p.s);
                assert!(distance(before, tip + crown) > 0.0, "pass {i} at s = {} is in a bead\n{text}", p.s);
            }
        }
    }
    println!("{welds} welds, {tips} tips");
    assert!(welds > 8 && tips > 200, "{welds} welds, {tips} tips");
}
