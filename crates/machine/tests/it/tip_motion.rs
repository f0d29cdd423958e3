//! Derivatives of a tip's place against differences of the forward kinematics.

use seamwright_machine::{AxisKind, Joints, Machine, SHIPPED};

#[test]
fn derivatives_are_those_of_differences_of_the_forward_kinematics() {
    for shipped in SHIPPED {
        let machine = Machine::read(shipped.name, shipped.text).unwrap();
        for case in 0..200 {
            let random = |i: usize, k: usize| (f64::from(case) * 1.7 + i as f64 * 2.3 + k as f64 * 0.9).sin();
            let scale = |i: usize| if machine.axes[i].kind == AxisKind::Rotary { 0.3 } else { 20.0 };
            let count = machine.axes.len();
            let ahead = 15.0 * random(0, 7);
            let motion: [Joints; 4] =
                std::array::from_fn(|k| std::array::from_fn(|i| if i < count { scale(i) * random(i, k) } else { 0.0 }));
            let at = |u: f64| {
                let place = |i: usize| {
                    let [q, d1, d2, d3] = motion.map(|m| m[i]);
                    q + u * (d1 + u / 2.0 * (d2 + u / 3.0 * d3))
                };
                machine.forward(&std::array::from_fn(place)).ahead(ahead).point
            };
            let h = 2e-3;
            let [m3, m2, m1, p0, p1, p2, p3] = [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0].map(|k| at(k * h));
            let wanted = [
                (8.0 * (p1 - m1) - (p2 - m2)) / (12.0 * h),
                (16.0 * (p1 + m1) - (p2 + m2) - 30.0 * p0) / (12.0 * h * h),
                (-13.0 * (p1 - m1) + 8.0 * (p2 - m2) - (p3 - m3)) / (8.0 * h * h * h),
            ];
            let found = machine.tip_derivatives(&motion, ahead);
            for (k, (found, wanted)) in found.iter().zip(wanted).enumerate() {
                let off = found.distance(wanted) / (1.0 + wanted.length());
                assert!(off < [1e-8, 1e-6, 1e-4][k], "{}: derivative {}: {found} {wanted}", machine.name, k + 1);
            }
        }
    }
}
