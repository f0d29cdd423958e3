//! Plans a job on a machine from a text: a gantry of three axes with an upright torch.
//!
//! `cargo run --release -p seamwright --example own_machine`

use seamwright::load;
use seamwright::machine::Machine;
use seamwright::project::failure::write_findings;
use std::error::Error;
use std::io;
use std::path::Path;

const MACHINE: &str = r#"
schema = 1
name = "gantry"
title = "Gantry with an upright torch"
torch.direction = [0, 0, -1]
[[tool]]
axis = "x"
move = [1, 0, 0]
range_mm = [-300, 300]
max_speed_mm_s = 100
max_acceleration_mm_s2 = 500
max_jerk_mm_s3 = 2000
[[tool]]
axis = "y"
move = [0, 1, 0]
range_mm = [-200, 200]
max_speed_mm_s = 100
max_acceleration_mm_s2 = 500
max_jerk_mm_s3 = 2000
[[tool]]
axis = "z"
move = [0, 0, 1]
range_mm = [-50, 150]
home_mm = 100
max_speed_mm_s = 50
max_acceleration_mm_s2 = 500
max_jerk_mm_s3 = 2000
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let machine = Machine::read("gantry.toml", MACHINE)?;
    // The job names another machine, but seam, torch angles and speed are independent of it.
    let job = load(Path::new("ellipse"))?;
    let motion = job.plan_on(&machine)?;
    println!("{} on {}", job.welding.program.value.title, machine.title);
    // The job has one pass.
    let pass = &motion.passes[0];
    println!("length: {:.3} mm, time: {:.3} s", pass.path.length(), pass.profile.duration());
    for (i, axis) in machine.axes.iter().enumerate() {
        // Positions are in mm and rad inside; `to_file` converts to mm and degrees.
        let positions = pass.set_points(machine.servo_period_s).map(|point| axis.to_file(point.q[i]));
        let (low, high) = positions.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), q| (q.min(l), q.max(h)));
        println!("axis {}: {low:.3} to {high:.3} {}", axis.name, axis.unit());
    }
    // Without shapes in the machine file there is no collision check; the plan has a warning.
    write_findings(&mut io::stdout(), &motion.findings)?;
    Ok(())
}
