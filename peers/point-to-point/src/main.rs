//! Plans the cases on standard input, one a line: for each axis position, speed, acceleration, target and the highest
//! speed, acceleration and jerk. Prints for each the duration (s), the maximum share of a limit that is used, how
//! far it ends from its target, and the time of planning (us; the best of five).

use seamwright_motion::jog::{AxisLimits, PointToPoint, State};
use std::io::{self, BufRead};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for line in io::stdin().lock().lines() {
        let line = line?;
        let values = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let (mut from, mut target, mut limits) = (State::default(), from_zero(), Vec::new());
        for (i, axis) in values.chunks_exact(7).enumerate() {
            (from.q[i], from.speed[i], from.acceleration[i], target[i]) = (axis[0], axis[1], axis[2], axis[3]);
            let range = (f64::NEG_INFINITY, f64::INFINITY);
            limits.push(AxisLimits { speed: axis[4], acceleration: axis[5], jerk: axis[6], range });
        }
        let mut plan = PointToPoint::with_limits(limits.clone());
        let mut best = f64::INFINITY;
        for _ in 0..5 {
            let start = Instant::now();
            plan.plan(&from, &target, 1.0)?;
            best = best.min(start.elapsed().as_secs_f64() * 1e6);
        }
        let (mut most, mut off) = (0.0f64, 0.0f64);
        let end = plan.at(plan.duration());
        for (i, l) in limits.iter().enumerate() {
            off = off.max((end.q[i] - target[i]).abs()).max(end.speed[i].abs());
            for k in 0..=500 {
                let s = plan.at(plan.duration() * f64::from(k) / 500.0);
                most = most.max(s.speed[i].abs() / l.speed).max(s.acceleration[i].abs() / l.acceleration);
            }
        }
        println!("{},{most},{off},{best}", plan.duration());
    }
    Ok(())
}

fn from_zero() -> [f64; 12] {
    State::default().q
}
