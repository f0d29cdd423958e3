//! Motion along taught points: the saddle of the rivals' table cut in pieces of any size.

use seamwright_machine::{Joints, Machine, shipped};
use seamwright_motion::law::LawStream;
use seamwright_motion::taught::{Corner, TaughtPath};

/// A machine with the limits of the rivals' measurement: 50 mm/s, 500 mm/s^2; 60 deg/s, 600 deg/s^2; jerk ten times that.
fn machine() -> Machine {
    // Both rotary axes through the origin, as in that measurement.
    let text = shipped("table-tilting-xyzac").unwrap().text.replace("at_mm = [0, 20, 10]", "at_mm = [0, 0, 0]");
    let mut machine = Machine::read("machine", &text).unwrap();
    for axis in &mut machine.axes {
        let unit = if axis.unit() == "mm" { 50.0 } else { 60f64.to_radians() };
        (axis.max_speed, axis.max_acceleration, axis.max_jerk) = (unit, 10.0 * unit, 100.0 * unit);
    }
    machine
}

/// Axis positions along the saddle R = 60, r = 25, A = 20 sin, C one turn, every `step` mm of the tip's way.
fn saddle(machine: &Machine, step: f64) -> Vec<Joints> {
    let at = |phi: f64| {
        let z = (3600.0 - (25.0 * phi.sin()).powi(2)).sqrt();
        let tilt = 20f64.to_radians() * phi.sin();
        let mut q = Joints::default();
        q[..5].copy_from_slice(&[25.0, -z * tilt.sin(), z * tilt.cos(), tilt, phi]);
        q
    };
    let tip = |phi: f64| machine.forward(&at(phi)).point;
    let mut points = vec![at(0.0)];
    let (mut phi, mut way) = (0.0, 0.0);
    let small = 1e-5;
    let mut last = tip(0.0);
    while phi < std::f64::consts::TAU {
        phi += small;
        let next = tip(phi);
        way += next.distance(last);
        last = next;
        if way >= step {
            points.push(at(phi));
            way -= step;
        }
    }
    points.push(at(std::f64::consts::TAU));
    points
}

#[test]
fn any_segmentation_is_the_same_weld() {
    let machine = machine();
    for (step, tol) in
        [(2.0, 0.01), (2.0, 0.002), (0.5, 0.01), (0.5, 0.002), (0.02, 0.01), (0.02, 0.002), (0.02, 0.0005)]
    {
        let points = saddle(&machine, step);
        let count = points.len();
        let path = TaughtPath::new(&machine, points.into_iter(), 20.0, Corner::Stop, tol);
        let started = std::time::Instant::now();
        let mut stream = LawStream::new(path, 3.0);
        let (mut t, mut fastest) = (0.0, 0.0f64);
        let mut speeds = Vec::new();
        while let Some(p) = stream.at(t) {
            let v = stream.path().tip_rate(p.s) * p.v;
            fastest = fastest.max(v);
            speeds.push(v);
            t += 1e-3;
        }
        println!(
            "{step}: {count} points, {:?}, fastest {fastest} stops {} {:?}",
            stream.duration(),
            stream.stops(),
            started.elapsed()
        );
    }
}
