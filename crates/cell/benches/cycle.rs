//! One cycle of a machine with ten axes: the set-point from the plan with its feed-forward, the inverse of its pose
//! moved by a correction, and ten position loops. Aim: 5 us in the median, 20 us for 999 of 1000.

use seamwright_machine::{Machine, Target, shipped};
use seamwright_motion::PassMotion;
use seamwright_servo::{Gains, Notch, PositionLoop, SetPoint};
use seamwright_weld::Welding;
use std::hint::black_box;
use std::time::Instant;

const JOB: &str = include_str!("../../../examples/t-joint.toml");
const PERIOD: f64 = 1e-3;
const CYCLES: usize = 1_000_000;

fn position_loop() -> Result<PositionLoop, seamwright_servo::Error> {
    PositionLoop::new(Gains::suggested(60.0, PERIOD), PERIOD, 60.0)?
        .with_notch(Notch::new(45.0, 0.2, 30.0, PERIOD)?)?
        .with_notch(Notch::new(160.0, 0.1, 80.0, PERIOD)?)
}

fn main() {
    let welding = Welding::read("t-joint", JOB).expect("the example is good");
    let program = &welding.program.value;
    let text = shipped(&program.machine).expect("it ships").text;
    let machine = Machine::read("machine", text).expect("it is good");
    let motion = PassMotion::plan(&machine, &welding.path(0), &program.passes[0], 1).expect("it can be welded");
    let mut loops: Vec<PositionLoop> = machine.axes.iter().map(|_| position_loop().expect("a good loop")).collect();
    assert_eq!(loops.len(), 10);

    let mut times = Vec::with_capacity(CYCLES);
    let (mut cursor, mut failed) = (0, 0);
    let mut near = motion.path.at(0.0);
    for k in 0..CYCLES {
        let t = (k as f64 * PERIOD) % motion.law.duration();
        let begin = Instant::now();
        let law = motion.law.at(black_box(t), &mut cursor);
        let point = motion.path.point(law.s, false);
        let mut target =
            Target { first: machine.forward_of(0, &point.q), second: Some(machine.forward_of(1, &point.q)) };
        // What a seam tracker moves the torch by.
        target.first.point += 0.1 * target.first.direction;
        match machine.inverse_near(black_box(target), &near) {
            Ok(solution) => near = solution.joints,
            Err(_) => failed += 1,
        }
        for (i, axis) in loops.iter_mut().enumerate() {
            let velocity = point.d1[i] * law.v;
            let acceleration = point.d2[i] * law.v * law.v + point.d1[i] * law.a;
            let set = SetPoint { position: near[i], velocity, acceleration };
            black_box(axis.update(set, near[i] - 1e-3));
        }
        times.push(begin.elapsed().as_nanos() as u64);
    }
    assert_eq!(failed, 0);
    times.sort_unstable();
    let at = |part: f64| times[((CYCLES - 1) as f64 * part) as usize] as f64 * 1e-3;
    println!("cycle of ten axes: median {:.2} us, p99.9 {:.2} us, most {:.0} us", at(0.5), at(0.999), at(1.0));
}
