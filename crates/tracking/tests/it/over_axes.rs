//! Corrections over the machine's own axes, on the machines that ship.

use glam::{DVec2, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisSet, Joints, Machine, shipped};
use seamwright_testkit::Random;
use seamwright_tracking::actuator::{OverAxes, RESERVE};

fn machine(name: &str) -> Machine {
    Machine::read(name, shipped(name).unwrap().text).unwrap()
}

/// Returns random axis positions in the middle half of the ranges.
fn somewhere(machine: &Machine, random: &mut Random) -> Joints {
    let mut q = Joints::default();
    for (q, axis) in q.iter_mut().zip(&machine.axes) {
        let (low, high) = axis.range.unwrap_or((-3.0, 3.0));
        *q = low + (high - low) * random.within(0.25, 0.75);
    }
    q
}

const CARRIERS: [&str; 4] = ["saddle-4axis", "torch-5axis", "table-tilting-xyzac", "ebw-7axis"];

/// The tool centre point is shifted exactly, also when the correction jumps by millimetres within a cycle or two. If
/// the axes can give any direction, the torch keeps its own.
#[test]
fn the_tip_is_shifted_and_the_torch_keeps_its_direction() {
    for name in CARRIERS {
        let machine = machine(name);
        let mut random = Random::new(7);
        let (mut done, mut turned) = (0, 0.0f64);
        while done < 1000 {
            let q = somewhere(&machine, &mut random);
            let mut over = OverAxes::new(&machine);
            let by = random.vector(3.0);
            // A correction grows over cycles.
            let Some(x) = (1..=30).map(|i| over.shifted(&q, by * f64::from(i) / 30.0).ok()).last().flatten() else {
                continue;
            };
            done += 1;
            let (planned, here) = (machine.forward(&q), machine.forward(&x));
            assert!(here.point.distance(planned.point + by) < 1e-7, "{name}: {}", here.point - planned.point - by);
            turned = turned.max(here.direction.angle_between(planned.direction));
        }
        let most = if name == "saddle-4axis" { 0.1 } else { 1e-4 };
        assert!(turned < most, "{name}: turned by {turned}");
    }
}

/// On a five-axis machine the solution is unique: that of the closed-form inverse.
#[test]
fn five_axes_go_where_the_inverse_says() {
    for name in ["torch-5axis", "table-tilting-xyzac"] {
        let machine = machine(name);
        let mut random = Random::new(11);
        let mut compared = 0;
        for _ in 0..1000 {
            let q = somewhere(&machine, &mut random);
            let by = random.vector(2.0);
            let mut over = OverAxes::new(&machine);
            let planned = machine.forward(&q);
            let target = Pose { point: planned.point + by, ..planned };
            let (Ok(known), Ok(_)) = (machine.inverse_near(target, &q), over.shifted(&q, 0.5 * by)) else { continue };
            let Ok(x) = over.shifted(&q, by) else { continue };
            compared += 1;
            for (axis, (x, known)) in machine.axes.iter().zip(x.iter().zip(&known.joints)) {
                assert!((x - known).abs() < 0.01, "{name} {}: {x} {known}", axis.name);
            }
        }
        assert!(compared > 500, "{name}: {compared}");
    }
}

/// The result does not depend on the path of the correction, also with redundant axes.
#[test]
fn the_way_does_not_matter() {
    let machine = machine("ebw-7axis");
    let mut random = Random::new(13);
    let mut compared = 0;
    for _ in 0..500 {
        let q = somewhere(&machine, &mut random);
        let by = random.vector(2.0);
        let settled = |ways: &[DVec3]| {
            let mut over = OverAxes::new(&machine);
            ways.iter().map(|by| over.shifted(&q, *by).ok()).last().flatten()
        };
        let round = [random.vector(2.0), random.vector(2.0), by, by, by];
        let (Some(a), Some(b)) = (settled(&[0.5 * by, by, by, by]), settled(&round)) else { continue };
        compared += 1;
        let apart = (0..machine.axes.len()).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-6, "{apart}");
    }
    assert!(compared > 300, "{compared}");
}

/// Held axes stand still to the last bit, and the others shift the tip as exactly and keep the torch's direction.
#[test]
fn held_axes_stand_still_while_the_others_shift_the_tip() {
    let machine = machine("ebw-7axis");
    let held: AxisSet = ["u", "w"].into_iter().map(|name| machine.axis(name).unwrap()).collect();
    let mut random = Random::new(23);
    let (mut done, mut used) = (0, 0);
    while done < 500 {
        let q = somewhere(&machine, &mut random);
        let by = random.vector(3.0);
        let settled =
            |mut over: OverAxes<'_>| (1..=30).map(|i| over.shifted(&q, by * f64::from(i) / 30.0).ok()).last()?;
        let Some(x) = settled(OverAxes::new(&machine).holding(held)) else { continue };
        done += 1;
        let (planned, here) = (machine.forward(&q), machine.forward(&x));
        assert!(here.point.distance(planned.point + by) < 1e-7, "{}", here.point - planned.point - by);
        assert!(here.direction.angle_between(planned.direction) < 1e-4);
        assert!(held.iter().all(|i| x[i].to_bits() == q[i].to_bits()));
        let free = settled(OverAxes::new(&machine));
        used += usize::from(free.is_some_and(|x| held.iter().all(|i| (x[i] - q[i]).abs() > 1e-6)));
    }
    assert!(used > 400, "{used}");
}

/// All heads on one carrier are shifted alike.
#[test]
fn all_heads_are_carried_along() {
    let machine = machine("dual-laser-10axis");
    let mut random = Random::new(19);
    for _ in 0..500 {
        let q = somewhere(&machine, &mut random);
        let by = random.vector(3.0);
        let mut over = OverAxes::carrying_all(&machine);
        let x = over.shifted(&q, by).unwrap();
        for head in 0..2 {
            let way = machine.forward_of(head, &x).point - machine.forward_of(head, &q).point;
            assert!(way.distance(by) < 1e-6, "{head}: {way} {by}");
        }
    }
}

/// A correction within its limits moves no axis faster than its reserve, at stationary planned positions.
#[test]
fn corrections_keep_the_reserve() {
    for name in CARRIERS {
        let machine = machine(name);
        let mut random = Random::new(17);
        let mut steps = 0;
        for _ in 0..200 {
            let q = somewhere(&machine, &mut random);
            let along = random.vector(1.0).normalize();
            let lateral = along.any_orthonormal_vector();
            let directions = [lateral, along.cross(lateral)];
            let Ok(limits) = OverAxes::new(&machine).limits(std::iter::once((q, directions)), 5.0) else { continue };
            let speed = limits.motion.speed;
            let mut over = OverAxes::new(&machine);
            let mut last = q;
            for i in 1..200 {
                let go = 1e-3 * speed * f64::from(i);
                let by = DVec2::splat(go.min(1.0));
                let Ok(x) = over.shifted(&q, by.x * directions[0] + by.y * directions[1]) else { break };
                for (k, axis) in machine.axes.iter().enumerate() {
                    let rate = (x[k] - last[k]).abs() / 1e-3;
                    assert!(rate <= RESERVE * axis.max_speed, "{name} {}: {rate}", axis.name);
                }
                last = x;
                steps += 1;
            }
        }
        assert!(steps > 10_000, "{name}: {steps}");
    }
}
