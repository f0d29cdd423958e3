//! Our inverse of a 6R arm, expressed as a chain like any other, beside rs-opw-kinematics, which knows such arms only:
//! the same positions come back, and both times in one run.
//!
//! Theirs answers a whole frame in closed form with all branches; ours a point and a direction (the torch may turn
//! about itself) by Newton's method from the neighbour, with the redundant axis held.

use rs_opw_kinematics::kinematic_traits::{Kinematics, Pose};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use seamwright_machine::Machine;
use std::hint::black_box;
use std::time::Instant;

/// The dimensions of an ABB IRB 2400/10 in the arm's straight pose, mm.
const A1: f64 = 100.0;
const A2: f64 = -135.0;
const C1: f64 = 615.0;
const C2: f64 = 705.0;
const C3: f64 = 755.0;
const C4: f64 = 85.0;

fn main() {
    let theirs = OPWKinematics::new(Parameters {
        a1: A1 * 1e-3,
        a2: A2 * 1e-3,
        c1: C1 * 1e-3,
        c2: C2 * 1e-3,
        c3: C3 * 1e-3,
        c4: C4 * 1e-3,
        ..Parameters::new()
    });
    let ours = Machine::read("arm.toml", &chain()).unwrap_or_else(|e| panic!("{e}"));
    let poses: Vec<([f64; 6], Pose)> = (1..=1000)
        .map(|k| {
            let q = ours.spread(k);
            let q: [f64; 6] = std::array::from_fn(|i| q[i]);
            (q, theirs.forward(&q))
        })
        .collect();
    let (mut forward, mut back, mut compared) = (0.0f64, 0.0f64, 0);
    for (q, pose) in &poses {
        let mut joints = [0.0; 12];
        joints[..6].copy_from_slice(q);
        let tip = ours.forward(&joints);
        let t = pose.translation.vector * 1e3;
        let z = pose.rotation * nalgebra::Vector3::z();
        forward = forward.max((tip.point.x - t.x).hypot(tip.point.y - t.y).hypot(tip.point.z - t.z));
        forward = forward.max(1e3 * (tip.direction.x - z.x).hypot(tip.direction.y - z.y).hypot(tip.direction.z - z.z));
        // From a neighbour half a degree away, as along a path.
        let near: [f64; 12] = std::array::from_fn(|i| if i < 6 && !ours.free().has(i) { joints[i] + 0.01 } else { joints[i] });
        // Near the wrist's or the elbow's singular pose the axes are not determined.
        if q[4].sin().abs() > 0.1
            && let Ok(found) = ours.inverse_near(tip, &near)
        {
            let worst = (0..6).map(|i| (found.joints[i] - joints[i]).abs()).fold(0.0, f64::max);
            if worst < 0.5 {
                back = back.max(worst);
                compared += 1;
            }
        }
    }
    let their_time = time(poses.len(), |i| drop(black_box(theirs.inverse_continuing(&poses[i].1, &poses[i].0))));
    let our_time = time(poses.len(), |i| {
        let mut near = [0.0; 12];
        near[..6].copy_from_slice(&poses[i].0);
        let tip = ours.forward(&near);
        (0..6).filter(|&k| !ours.free().has(k)).for_each(|k| near[k] += 0.01);
        drop(black_box(ours.inverse_near(tip, &near)));
    });
    let good = forward < 1e-6 && back < 1e-8 && compared > 800;
    println!(
        "{}: 6R arm: forward agrees to {forward:.1e} mm, {compared} of 1000 positions come back to {back:.1e} rad; \
         ours {our_time:.2} us, rs-opw-kinematics {their_time:.2} us, ratio {:.2}",
        if good { "ok" } else { "FAILED" },
        our_time / their_time
    );
    std::process::exit(i32::from(!good));
}

/// Microseconds a call, the best of several rounds over all poses.
fn time(count: usize, mut call: impl FnMut(usize)) -> f64 {
    let round = |call: &mut dyn FnMut(usize)| {
        let start = Instant::now();
        (0..count).for_each(|i| call(i));
        start.elapsed().as_secs_f64() * 1e6 / count as f64
    };
    (0..20).map(|_| round(&mut call)).fold(f64::INFINITY, f64::min)
}

/// The arm as a chain.
fn chain() -> String {
    let axes = [
        ("j1", "z", [0.0, 0.0, 0.0]),
        ("j2", "y", [A1, 0.0, C1]),
        ("j3", "y", [A1, 0.0, C1 + C2]),
        ("j4", "z", [A1 + A2, 0.0, 0.0]),
        ("j5", "y", [A1 + A2, 0.0, C1 + C2 + C3]),
        ("j6", "z", [A1 + A2, 0.0, 0.0]),
    ];
    let mut text = String::from("schema = 1\nname = \"arm\"\ntitle = \"6R arm\"\n");
    for (name, about, [x, y, z]) in axes {
        let turn = if about == "z" { "[0, 0, 1]" } else { "[0, 1, 0]" };
        text += &format!(
            "[[tool]]\naxis = \"{name}\"\nturn = {turn}\nat_mm = [{x}, {y}, {z}]\nrange_deg = [-170, 170]\n\
             max_speed_deg_s = 150\nmax_acceleration_deg_s2 = 600\n"
        );
    }
    let flange = C1 + C2 + C3 + C4;
    text + &format!("[[tool]]\nfixed = {{ move_mm = [{}, 0, {flange}] }}\n[torch]\ndirection = [0, 0, 1]\n", A1 + A2)
}
