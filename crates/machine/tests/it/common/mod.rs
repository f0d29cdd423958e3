//! Seeded random machines and poses.

use seamwright_document::DocumentError;
use seamwright_machine::{AxisKind, Joints, Machine, shipped};
use seamwright_testkit::Random;

pub(crate) fn random_joints(machine: &Machine, random: &mut Random) -> Joints {
    let mut q = Joints::default();
    for (value, axis) in q.iter_mut().zip(&machine.axes) {
        let (low, high) = axis.range.unwrap_or((-9.0, 9.0));
        *value = random.within(low, high);
    }
    q
}

/// Distance of the pose from a singular one: the volume spanned by the decided axes' unit columns over all of point and
/// direction, as far as the number of axes allows.
pub(crate) fn conditioning(machine: &Machine, q: &Joints) -> f64 {
    let columns = machine.jacobian(q);
    let head = &machine.heads[0];
    let mut basis: Vec<[f64; 6]> = Vec::new();
    let mut volume = 1.0;
    for i in head.chain.axes().iter().filter(|&i| !head.free().has(i)) {
        let (p, d) = (columns[i].0, 1000.0 * columns[i].1);
        let mut v = [p.x, p.y, p.z, d.x, d.y, d.z];
        let dot = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let before = dot(&v, &v).sqrt();
        for b in &basis {
            let along = dot(&v, b);
            v.iter_mut().zip(b).for_each(|(x, y)| *x -= along * y);
        }
        let length = dot(&v, &v).sqrt();
        volume *= length / before.max(1e-300);
        v.iter_mut().for_each(|x| *x /= length.max(1e-300));
        basis.push(v);
    }
    volume
}

/// The text of a machine file with `count` axes of random kind, side, sense, direction and position.
pub(crate) fn random_chain(random: &mut Random, count: u32) -> String {
    let mut text = String::from("schema = 1\nname = \"random\"\ntitle = \"random\"\n");
    for k in 0..count {
        let side = if random.below(2) == 0 { "tool" } else { "work" };
        // Some along the frame's axes, as on real machines; some in any direction.
        let direction = if random.below(2) == 0 {
            let mut v = [0.0; 3];
            v[random.below(3)] = if random.below(2) == 0 { 1.0 } else { -1.0 };
            v
        } else {
            random.vector(1.0).to_array()
        };
        let limits = |u: &str| format!("max_speed_{u}_s = 10\nmax_acceleration_{u}_s2 = 100\n");
        text += &if random.below(5) < 2 {
            format!("[[{side}]]\naxis = \"q{k}\"\nmove = {direction:?}\nrange_mm = [-300, 300]\n{}", limits("mm"))
        } else {
            let at = random.vector(200.0).to_array();
            format!(
                "[[{side}]]\naxis = \"q{k}\"\nturn = {direction:?}\nat_mm = {at:?}\nrange_deg = [-170, 170]\n{}",
                limits("deg")
            )
        };
        let (shift, turn, angle) =
            (random.vector(150.0).to_array(), random.vector(1.0).to_array(), random.within(-180.0, 180.0));
        text += &format!("[[{side}]]\nfixed = {{ move_mm = {shift:?}, turn = {turn:?}, angle_deg = {angle} }}\n");
    }
    text + &format!("[torch]\ndirection = {:?}\n", random.vector(1.0).to_array())
}

pub(crate) fn same(machine: &Machine, a: &Joints, b: &Joints, within: f64) -> bool {
    machine.axes.iter().zip(a.iter().zip(b)).all(|(axis, (a, b))| {
        let d = match axis.kind {
            AxisKind::Linear => a - b,
            AxisKind::Rotary => (a - b + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI,
        };
        d.abs() <= within
    })
}

/// The error of a machine file's text with `from`, which it contains, replaced once; it has an address.
pub(crate) fn refusal(text: &str, from: &str, to: &str) -> DocumentError {
    assert!(text.contains(from), "{from}");
    let error = Machine::read("m.toml", &text.replacen(from, to, 1)).unwrap_err();
    assert!(error.line > 0, "{error}");
    error
}

pub(crate) fn shipped_machine(name: &str) -> Machine {
    Machine::read(name, shipped(name).unwrap().text).unwrap()
}
