//! Redundancy resolution: against an exhaustive search, on the example, on random work, and without a feasible path.

use crate::number;
use crate::planning;

use crate::planning::{read, read_machine, shipped_machine};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine, Solution, shipped};
use seamwright_motion::PassMotion;
use seamwright_motion::redundancy::{Clearance, FreeAxes, resolve};
use seamwright_program::{Finding, TorchPath};
use seamwright_testkit::{Random, cases};
use seamwright_weld::Welding;
use std::f64::consts::TAU;

const EXAMPLE: &str = include_str!("../../../../examples/oblique-girth.toml");

fn choose(machine: &Machine, welding: &Welding, speed: f64) -> Result<FreeAxes, Vec<Finding>> {
    resolve(machine, &welding.path(0), speed, &welding.program.value.passes[0].spare_axes, None, 1)
}

fn girth(random: &mut Random, rest: &str) -> String {
    let (radius, cut, phi) = (random.within(60.0, 200.0), random.within(0.0, 0.5), random.within(-180.0, 180.0));
    let (x, y, z) = (random.within(-60.0, 60.0), random.within(-60.0, 60.0), random.within(80.0, 250.0));
    let (lean, turn) = (random.within(0.0, 12.0), random.within(-1.0, 1.0));
    format!(
        "schema = 1\ntitle = \"random\"\nmachine = \"ebw-7axis\"\n[placement]\nmove_mm = [{x}, {y}, {z}]\n\
         turn = [1, {turn}, 0]\nangle_deg = {lean}\n[seam.girth]\nradius_mm = {radius}\n\
         cut_normal = [{}, 0, {}]\n[start]\nphi_deg = {phi}\n{rest}",
        cut.sin(),
        cut.cos()
    )
}

/// Positions of all axes at `stations + 1` evenly spaced path lengths.
fn rows(machine: &Machine, path: &dyn TorchPath, free: &FreeAxes, stations: usize) -> Vec<Joints> {
    let mut q = free.start().unwrap();
    let place = |i: usize| path.length() * i as f64 / stations as f64;
    let follow = |i: usize| {
        q = machine.inverse_near(path.pose(place(i)), &free.at(place(i), &q)).unwrap().joints;
        q
    };
    (0..=stations).map(follow).collect()
}

/// Sum over the inner stations of squared accelerations and over the cells of squared speeds, each as a part of the
/// axis' limit: the discrete cost, written down anew.
fn cost_of(machine: &Machine, rows: &[Joints], h: f64, v: f64, motion: f64) -> f64 {
    let triple = |w: &[Joints]| turn(machine, [&w[0], &w[1], &w[2]], h, v, motion);
    let first = speed_cost(machine, &rows[0], &rows[1], h, v) * motion;
    first + rows.windows(3).map(triple).sum::<f64>()
}

fn speed_cost(machine: &Machine, a: &Joints, b: &Joints, h: f64, v: f64) -> f64 {
    machine.axes.iter().enumerate().map(|(i, axis)| ((b[i] - a[i]) / h * v / axis.max_speed).powi(2)).sum()
}

fn turn(machine: &Machine, [a, b, c]: [&Joints; 3], h: f64, v: f64, motion: f64) -> f64 {
    let bend = |(i, axis): (usize, &seamwright_machine::Axis)| {
        ((c[i] - 2.0 * b[i] + a[i]) / (h * h) * v * v / axis.max_acceleration).powi(2)
    };
    machine.axes.iter().enumerate().map(bend).sum::<f64>() + motion * speed_cost(machine, b, c, h, v)
}

/// Dynamic programming over pairs of nodes: the minimum cost of all paths through `nodes`.
fn exhaustive(machine: &Machine, nodes: &[Vec<Joints>], h: f64, v: f64, motion: f64) -> (f64, Vec<usize>) {
    let count = |k: usize| nodes[k].len();
    let mut totals: Vec<f64> = Vec::new();
    for a in &nodes[0] {
        totals.extend(nodes[1].iter().map(|b| motion * speed_cost(machine, a, b, h, v)));
    }
    let mut back: Vec<Vec<usize>> = Vec::new();
    for k in 2..nodes.len() {
        let (mut next, mut from) = (vec![f64::INFINITY; count(k - 1) * count(k)], vec![0; count(k - 1) * count(k)]);
        for (i, a) in nodes[k - 2].iter().enumerate() {
            for (j, b) in nodes[k - 1].iter().enumerate() {
                let so_far = totals[i * count(k - 1) + j];
                for (l, c) in nodes[k].iter().enumerate() {
                    let at = j * count(k) + l;
                    if so_far < next[at] {
                        let total = so_far + turn(machine, [a, b, c], h, v, motion);
                        if total < next[at] {
                            (next[at], from[at]) = (total, i);
                        }
                    }
                }
            }
        }
        totals = next;
        back.push(from);
    }
    let last = nodes.len() - 1;
    let end = (0..totals.len()).min_by(|&a, &b| totals[a].total_cmp(&totals[b])).unwrap();
    let (mut j, mut l) = (end / count(last), end % count(last));
    let mut way = vec![l, j];
    for k in (2..=last).rev() {
        let i = back[k - 2][j * count(k) + l];
        (j, l) = (i, j);
        way.push(i);
    }
    way.reverse();
    (totals[end], way)
}

/// The minimum discrete cost, found by exhaustive search over the whole ranges, then about its own best path with
/// successively finer nodes until no neighbour is better.
fn least_cost(machine: &Machine, path: &dyn TorchPath, free: &[usize], stations: usize, v: f64, motion: f64) -> f64 {
    let h = path.length() / stations as f64;
    let target = |k: usize| path.pose(h * k as f64);
    let node = |k: usize, near: &Joints| -> Option<Joints> {
        let found: Option<Solution> = machine.inverse_near(target(k), near).ok();
        found.map(|s| s.joints).filter(|q| machine.outside(q).is_none())
    };
    let range = |axis: usize| machine.axes[axis].range.unwrap_or((-0.5 * TAU, 0.5 * TAU));
    let samples: usize = if free.len() == 1 { 61 } else { 10 };
    let mut steps: Vec<f64> = free.iter().map(|&a| (range(a).1 - range(a).0) / (samples as f64 - 1.0)).collect();
    let combine = |base: &Joints, offsets: &dyn Fn(usize) -> Vec<f64>| {
        let mut all = vec![*base];
        for (f, &axis) in free.iter().enumerate() {
            let each = |q: &Joints| {
                offsets(f)
                    .into_iter()
                    .map(|o| {
                        let mut q = *q;
                        q[axis] = o;
                        q
                    })
                    .collect::<Vec<_>>()
            };
            all = all.iter().flat_map(each).collect();
        }
        all
    };
    let mut base = machine.home();
    base[machine.axis("u").unwrap()] = 90f64.to_radians();
    let whole = combine(&base, &|f| (0..samples).map(|i| range(free[f]).0 + steps[f] * i as f64).collect());
    let nodes: Vec<Vec<Joints>> = (0..=stations).map(|k| whole.iter().filter_map(|q| node(k, q)).collect()).collect();
    let (mut least, way) = exhaustive(machine, &nodes, h, v, motion);
    let mut best: Vec<Joints> = way.iter().enumerate().map(|(k, &i)| nodes[k][i]).collect();
    let most = if free.len() == 1 { 4 } else { 2 };
    while steps[0] > if free.len() == 1 { 1e-5 } else { 3e-5 } {
        let near = |k: usize| {
            let around =
                combine(&best[k], &|f| (-most..=most).map(|o| best[k][free[f]] + steps[f] * f64::from(o)).collect());
            around.iter().filter_map(|q| node(k, q)).collect::<Vec<_>>()
        };
        let nodes: Vec<Vec<Joints>> = (0..=stations).map(near).collect();
        let (cost, way) = exhaustive(machine, &nodes, h, v, motion);
        if cost > least * (1.0 - 1e-5) {
            steps.iter_mut().for_each(|s| *s *= 0.5);
        }
        if cost < least {
            least = cost;
            best = way.iter().enumerate().map(|(k, &i)| nodes[k][i]).collect();
        }
    }
    least
}

#[test]
fn as_good_as_an_exhaustive_search() {
    let machine = shipped_machine("ebw-7axis");
    let [u, w] = ["u", "w"].map(|n| machine.axis(n).unwrap());
    let mut random = Random::new(1);
    let mut worst = 0.0f64;
    for case in 0..cases(4) {
        let (hold, free, stations) = match case % 2 {
            0 => ("hold = { u = 90 }\n", vec![w], 10),
            _ => ("", vec![u, w], 7),
        };
        let motion = f64::from(case / 2 % 2);
        let rest = format!(
            "end_phi_deg = 1000\n[spare_axes]\nposition = \"any\"\n{hold}[spare_axes.weights]\nmotion = {motion}\n\
             limits = 0\nsingularity = 0\nwind_up = 0\n[weld]\nspeed_mm_s = 30\n"
        );
        let text = girth(&mut random, &rest);
        let phi: f64 = text.split("phi_deg = ").nth(1).unwrap().lines().next().unwrap().parse().unwrap();
        let text = text.replace("end_phi_deg = 1000", &format!("end_phi_deg = {}", phi + random.within(20.0, 50.0)));
        let welding = read(&text);
        let path = welding.path(0);
        let chosen = choose(&machine, &welding, 30.0).unwrap_or_else(|f| panic!("{f:#?}\n{text}"));
        let h = path.length() / stations as f64;
        let ours = cost_of(&machine, &rows(&machine, &path, &chosen, stations), h, 30.0, motion);
        let least = least_cost(&machine, &path, &free, stations, 30.0, motion);
        worst = worst.max(ours / least);
    }
    assert!(worst < 1.02, "{worst}");
}

#[test]
fn the_example_keeps_the_beam_on_the_normal_and_the_seam_flat() {
    let (machine, welding) = (shipped_machine("ebw-7axis"), read(EXAMPLE));
    let path = welding.path(0);
    let motion = PassMotion::plan(&machine, &path, &welding.program.value.passes[0], 1).unwrap();
    assert!(motion.findings.is_empty(), "{:#?}", motion.findings);
    let axis_z = DVec3::Z;
    for i in 0..=2000 {
        let s = path.length() * f64::from(i) / 2000.0;
        let q = motion.path.at(s);
        assert!(machine.outside(&q).is_none());
        let tip = machine.forward(&q);
        // The tube's axis is z: the surface's normal is level and points away from it.
        let normal = (tip.point - tip.point.dot(axis_z) * axis_z).normalize();
        assert!((-tip.direction).angle_between(normal).to_degrees() < 0.1);
        assert!((tip.point - path.pose(s).point).length() < 1e-9);
        assert!(machine.up_in_work(&q).angle_between(normal).to_degrees() < 10.0, "{s}");
    }
    // More than once round.
    let w = machine.axis("w").unwrap();
    assert!((motion.path.at(0.0)[w] - motion.path.at(path.length())[w]).abs() > 350f64.to_radians());
}

/// Whole plans: in range, on the path, and twice continuously differentiable by differences.
fn check_motion(machine: &Machine, welding: &Welding, motion: &PassMotion) {
    check_motion_at(4000, machine, welding, motion);
}

/// The same at `n` places.
fn check_motion_at(n: usize, machine: &Machine, welding: &Welding, motion: &PassMotion) {
    let path = welding.path(0);
    let joints = &motion.path;
    let at = |i: usize| path.length() * i as f64 / n as f64;
    let (mut last, h) = (joints.point(0.0, false), at(1));
    for i in 1..=n {
        let p = joints.point(at(i), i == n);
        assert!(machine.outside(&p.q).is_none());
        assert!((machine.forward(&p.q).point - path.pose(at(i)).point).length() < 1e-9);
        for k in 0..machine.axes.len() {
            let unit = machine.axes[k].max_speed;
            // Taylor from both ends: the remainder is of third order in the step.
            let middle = 0.5 * h * (last.d1[k] + p.d1[k]) - (p.q[k] - last.q[k]);
            assert!(middle.abs() < 1e-6 * unit, "{} at {}: {middle}", machine.axes[k].name, at(i));
            let slope = 0.5 * h * (last.d2[k] + p.d2[k]) - (p.d1[k] - last.d1[k]);
            assert!(slope.abs() < 1e-6 * unit, "{} at {}: {slope}", machine.axes[k].name, at(i));
        }
        last = p;
    }
}

#[test]
fn random_work_is_welded_smoothly_and_the_same_every_time() {
    let ebw = shipped_machine("ebw-7axis");
    let mut random = Random::new(7);
    let mut made = 0;
    for case in 0..cases(20) {
        let text = girth(&mut random, "overlap_mm = 10\n[weld]\nspeed_mm_s = 8\non_limit = \"slow\"\n");
        let welding = read(&text);
        match planning::plan(&ebw, &welding) {
            Ok(motion) => {
                check_motion(&ebw, &welding, &motion);
                made += 1;
            }
            Err(findings) => println!("{findings:#?}\n{text}"),
        }
        if case % 5 == 0 {
            assert_eq!(choose(&ebw, &welding, 8.0), choose(&ebw, &welding, 8.0));
        }
    }
    assert!(made * 10 >= cases(20) * 9, "{made}");
}

#[test]
fn three_axes_to_spare() {
    let dual = shipped_machine("dual-laser-10axis");
    let mut random = Random::new(9);
    for _ in 0..cases(8) {
        let [x, y, z] = [random.within(-500.0, 500.0), random.within(-200.0, 200.0), random.within(0.0, 60.0)];
        let (dx, dy) = (random.within(100.0, 600.0), random.within(-150.0, 150.0));
        let across = DVec3::new(-dy, dx, 0.0).normalize();
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"dual-laser-10axis\"\n[seam.line]\nstart_mm = [{x}, {y}, {z}]\n\
             end_mm = [{}, {}, {z}]\nfirst_normal = [{}, {}, 0]\nsecond_normal = [0, 0, 1]\n[torch]\n\
             work_angle_deg = -10\n[weld]\nspeed_mm_s = 20\non_limit = \"slow\"\n",
            x + dx,
            y + dy,
            across.x,
            across.y,
        );
        let welding = read(&text);
        let motion = planning::plan(&dual, &welding);
        check_motion(&dual, &welding, &motion.unwrap_or_else(|f| panic!("{f:#?}\n{text}")));
    }
}

/// A whole nozzle with the seven-axis arm: the planner swivels the elbow (arm angle, by the third axis) and turns the torch.
#[test]
fn a_seven_axis_arm_welds_a_nozzle() {
    let text = "schema = 1\ntitle = \"nozzle\"\nmachine = \"iiwa-14\"\n[placement]\nmove_mm = [-100, 0, 160]\n\
        [seam.nozzle]\nradius_mm = 60\nwall_mm = 6\n[seam.nozzle.body.cylinder]\nradius_mm = 150\naxis = [1, 0, 0]\n\
        [start]\nphi_deg = 0\noverlap_mm = 10\n[weld]\nspeed_mm_s = 6\n";
    let machine = shipped_machine("iiwa-14");
    let welding = read(text);
    let motion = planning::plan(&machine, &welding).unwrap_or_else(|findings| panic!("{findings:#?}"));
    // The wrist turns faster than other machines: the remainder needs finer steps.
    check_motion_at(8000, &machine, &welding, &motion);
    let third = machine.axis("a3").unwrap();
    let (mut elbow, mut axis) = ([f64::INFINITY, f64::NEG_INFINITY], [f64::INFINITY, f64::NEG_INFINITY]);
    let widen = |range: &mut [f64; 2], value: f64| *range = [range[0].min(value), range[1].max(value)];
    let start = machine.arm_configuration(&motion.path.at(0.0)).unwrap();
    for i in 0..=200 {
        let q = motion.path.at(motion.path.length() * f64::from(i) / 200.0);
        widen(&mut elbow, machine.arm_angle(&q).unwrap().to_degrees());
        widen(&mut axis, q[third].to_degrees());
        let now = machine.arm_configuration(&q).unwrap();
        assert_eq!((now.shoulder, now.elbow, now.wrist), (start.shoulder, start.elbow, start.wrist));
        assert!(machine.arm_margins(&q).unwrap().min() > 0.05);
    }
    println!("arm angle {elbow:.1?} degrees, a3 {axis:.1?} degrees");
    assert!(elbow[1] - elbow[0] > 2.0, "{elbow:?}");
}

#[test]
fn a_held_axis_stands_still() {
    let held = EXAMPLE.replace("# hold = { u = 90 } ", "hold = { u = 88, w = -20 } ");
    let welding = read(&held);
    // Both held: half a turn away from the seam's start the beam cannot get there.
    assert!(choose(&shipped_machine("ebw-7axis"), &welding, 10.0).unwrap().start().is_none());
    let welding = read(&EXAMPLE.replace("# hold = { u = 90 } ", "hold = { u = 88 } "));
    let machine = shipped_machine("ebw-7axis");
    let motion = planning::plan(&machine, &welding).unwrap();
    let u = machine.axis("u").unwrap();
    for i in 0..=100 {
        let q = motion.path.at(motion.path.length() * f64::from(i) / 100.0);
        assert!((q[u] - 88f64.to_radians()).abs() < 1e-12);
    }
}

#[test]
fn obstacles_are_kept_clear_of() {
    let machine = shipped_machine("ebw-7axis");
    let u = machine.axis("u").unwrap();
    let welding = read(&EXAMPLE.replace("position = \"flat\"", "position = \"any\""));
    let least = |clearance: Option<Clearance>| {
        let wishes = &welding.program.value.passes[0].spare_axes;
        let free = resolve(&machine, &welding.path(0), 10.0, wishes, clearance, 1).unwrap();
        rows(&machine, &welding.path(0), &free, 400).iter().map(|q| q[u].to_degrees()).fold(f64::INFINITY, f64::min)
    };
    let freely = least(None);
    // An obstacle that the table approaches below ten degrees more than its free tilt.
    let distance = |q: &Joints| (q[u].to_degrees() - freely - 10.0) * 2.0;
    let clear = least(Some(Clearance { distance: &distance, wanted_mm: 10.0 }));
    assert!(clear > freely + 12.0, "{freely} {clear}");
}

fn refused(machine: &Machine, text: &str) -> Vec<Finding> {
    let findings = choose(machine, &read(text), 10.0).unwrap_err();
    assert!(findings.iter().all(|f| !f.allowed && f.from_mm <= f.to_mm));
    findings
}

#[test]
fn where_there_is_no_way_it_says_why() {
    let ebw = shipped_machine("ebw-7axis");
    // Too long: with the tube lying, the cut is 1350 mm from the table's tilt axis less 150 tan 20, and X ends at 1000.
    let lying = EXAMPLE.replace("# hold = { u = 90 } ", "hold = { u = 90 } ");
    let far = refused(&ebw, &lying.replace("move_mm = [0, 0, 160]", "move_mm = [0, 0, 1200]"));
    assert!(
        far.len() == 1 && far[0].kind == "range" && far[0].message.to_string().contains("axis x would have to go 404.")
    );
    assert!(far[0].from_mm < 1e-9 && far[0].to_mm > 990.0);
    // With the table level the normals are level too, and the gun cannot lie down.
    let level = refused(&ebw, &EXAMPLE.replace("# hold = { u = 90 } ", "hold = { u = 0 } "));
    assert!(
        level.iter().all(|f| f.kind == "range"
            && (f.message.to_string().contains("axis v") || f.message.to_string().contains("axis q")))
    );
    // A table with less range than the seam's turn: every station can be reached, but not in sequence.
    let text = shipped("ebw-7axis").unwrap().text.replace("continuous = true", "range_deg = [-105, 105]");
    let short = read_machine(&text);
    let jump = refused(&short, &EXAMPLE.replace("position = \"flat\"", "position = \"any\""));
    let turns = |f: &Finding| f.message.to_string().contains("axis w") || f.message.to_string().contains("axis q");
    assert!(jump.len() == 1 && jump[0].kind == "jump" && turns(&jump[0]));
    // An invalid hold.
    let hold = refused(&ebw, &EXAMPLE.replace("# hold = { u = 90 } ", "hold = { tilt = 0 } "));
    assert!(hold[0].kind == "hold" && hold[0].cure_text().contains("u") && hold[0].cure_text().contains("w"));
}

#[test]
fn near_a_singular_attitude_it_says_which_speed_can_be_held() {
    let machine = shipped_machine("table-tilting-xyzac");
    // The torch leans from one side over to the other, past upright by 4 degrees: the table must turn quickly there.
    let plan = |speed: f64| {
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"table-tilting-xyzac\"\n[seam.line]\nstart_mm = [-60, 20, 10]\n\
             end_mm = [60, 20, 10]\nfirst_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n[[torch.at]]\ns_mm = 0\n\
             work_angle_deg = 4\ntravel_angle_deg = -20\n[[torch.at]]\ns_mm = 119\nwork_angle_deg = 4\n\
             travel_angle_deg = 20\n[weld]\nspeed_mm_s = {speed}\n"
        );
        let welding = read(&text);
        planning::plan(&machine, &welding)
    };
    let found = (1..60).find_map(|i| {
        let speed = 0.5 * 1.1f64.powi(i);
        let findings = plan(speed).unwrap_or_else(|f| panic!("{f:#?}")).findings;
        findings.into_iter().find(|f| f.kind == "singular")
    });
    let found = found.unwrap();
    assert!(
        found.allowed
            && found.from_mm > 30.0
            && found.to_mm < 90.0
            && (4.0..5.0).contains(&number(&found.message, "distance"))
    );
    let holds = number(&found.message, "holds");
    assert!(plan(0.995 * holds).is_ok());
    assert!(plan(1.01 * holds).unwrap_err().iter().any(|f| f.kind == "speed"));
}

/// Both fillets of a web along x at once.
struct BothSides;

impl TorchPath for BothSides {
    fn length(&self) -> f64 {
        200.0
    }
    fn pose(&self, s: f64) -> Pose {
        let bend = 2.0 * (s / 40.0).sin();
        Pose { point: DVec3::new(s, 1.0 + bend, 0.0), direction: DVec3::new(0.0, -0.75f64.sqrt(), -0.5) }
    }
    fn second(&self, s: f64) -> Option<Pose> {
        let Pose { point, direction } = self.pose(s);
        Some(Pose { point: point - 2.0 * DVec3::Y, direction: direction * DVec3::new(1.0, -1.0, 1.0) })
    }
}

#[test]
fn two_torches_leave_nothing_to_spare() {
    let machine = shipped_machine("dual-laser-10axis");
    let mut pass = read(EXAMPLE).program.value.passes.remove(0);
    pass.on_limit = seamwright_program::OnLimit::Slow;
    pass.spare_axes.hold.insert("c".to_owned(), seamwright_document::Finite::new(0.0).unwrap());
    assert!(PassMotion::plan(&machine, &BothSides, &pass, 1).unwrap_err()[0].kind == "hold");
    pass.spare_axes.hold.clear();
    let motion = PassMotion::plan(&machine, &BothSides, &pass, 1).unwrap_or_else(|f| panic!("{f:#?}"));
    for i in 0..=200 {
        let s = f64::from(i);
        let q = motion.path.at(s);
        let second = BothSides.second(s).unwrap();
        assert!((machine.forward(&q).point - BothSides.pose(s).point).length() < 1e-9);
        assert!((machine.forward_of(1, &q).point - second.point).length() < 1e-9);
        assert!((machine.forward_of(1, &q).direction - second.direction).length() < 1e-9);
    }
}
