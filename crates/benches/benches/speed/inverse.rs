//! Cost of the inverse from a neighbour: closed forms (aim: 200 ns), and Newton's method on a 7-axis arm (aim: 20 us);
//! of all branches of a six-axis arm (aims: 1 us with a spherical wrist, 2 us with three parallel axes).

use crate::measure::time;
use seamwright_machine::{Joints, Machine, SHIPPED, Target, shipped};
use std::hint::black_box;

pub(crate) fn inverse() {
    for shipped in SHIPPED {
        let machine = Machine::read(shipped.name, shipped.text).unwrap();
        let poses: Vec<_> = (0..997)
            .map(|i| {
                let mut q = machine.home();
                for (k, q) in q.iter_mut().enumerate() {
                    *q += (f64::from(i) * 0.37 + k as f64).sin() * 0.7;
                }
                (machine.forward(&q), q)
            })
            .collect();
        let mut i = 0;
        time(&format!("inverse, {}", shipped.name), || {
            i = (i + 1) % poses.len();
            black_box(machine.inverse_near(black_box(&poses[i].0), &poses[i].1))
        });
    }
}

/// All branches of a frame.
pub(crate) fn arms() {
    for name in ["irb-2600", "ur10e"] {
        let machine = Machine::read(name, shipped(name).unwrap().text).unwrap();
        let framed = |q: &Joints| Target { across: Some(machine.across(q)), ..Target::from(machine.forward(q)) };
        let of_eight = (1..).map(|k| machine.spread(k)).map(|q| (framed(&q), q));
        let of_eight = of_eight.filter(|(target, q)| machine.inverse(*target, q).is_ok_and(|found| found.len() == 8));
        let poses: Vec<_> = of_eight.take(997).collect();
        let mut i = 0;
        time(&format!("inverse, all 8 branches, {name}"), || {
            i = (i + 1) % poses.len();
            black_box(machine.inverse(black_box(poses[i].0), &poses[i].1))
        });
    }
}

/// An arm of seven rotary axes, each perpendicular to the one before it; the inverse starts 0.01 rad away, as along a
/// path.
pub(crate) fn numeric() {
    let mut text = String::from("schema = 1\nname = \"arm\"\ntitle = \"7R arm\"\n");
    for (k, z) in [0.0, 340.0, 340.0, 740.0, 740.0, 1140.0, 1140.0].iter().enumerate() {
        let turn = if k % 2 == 0 { "[0, 0, 1]" } else { "[0, 1, 0]" };
        text += &format!(
            "[[tool]]\naxis = \"j{k}\"\nturn = {turn}\nat_mm = [0, 0, {z}]\nrange_deg = [-160, 160]\n\
             max_speed_deg_s = 90\nmax_acceleration_deg_s2 = 300\n"
        );
    }
    text += "[[tool]]\nfixed = { move_mm = [60, 0, 1266] }\n[torch]\ndirection = [1, 0, 1]\n";
    let machine = Machine::read("arm.toml", &text).unwrap();
    let poses: Vec<_> = (1..998)
        .map(|k| {
            let q = machine.spread(k);
            let near = std::array::from_fn(|i| if machine.free().has(i) || i > 6 { q[i] } else { q[i] + 0.01 });
            (machine.forward(&q), near)
        })
        .collect();
    let mut i = 0;
    time("inverse, 7R arm by Newton's method", || {
        i = (i + 1) % poses.len();
        black_box(machine.inverse_near(black_box(poses[i].0), &poses[i].1))
    });
}
