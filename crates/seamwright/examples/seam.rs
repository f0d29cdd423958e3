//! The seam of a nozzle on a cylindrical shell: its length, and points with the torch attitude.
//!
//! `cargo run --release -p seamwright --example seam`

use seamwright::glam::DVec3;
use seamwright::program::TorchPath;
use seamwright::weld::Welding;
use std::error::Error;

/// The name of the machine is a required key, but only planning reads the machine.
const JOB: &str = r#"
schema = 1
title = "Nozzle 500 mm diameter on shell 1600 mm diameter"
machine = "torch-5axis"
[seam.nozzle]
radius_mm = 250
body.cylinder.radius_mm = 800
[torch]
travel_angle_deg = -10
[weld]
speed_mm_s = 10
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let welding = Welding::read("nozzle.toml", JOB)?;
    let seam = welding.seam.as_ref().ok_or("a job without a seam")?;
    // The torch is in the work frame. Without a placement in the job this is the frame of the seam.
    let torch = welding.path(0);
    println!("{}", welding.program.value.title);
    println!("length: {:.3} mm", seam.length());
    println!("    s mm  phi deg      x mm      y mm      z mm  faces deg  torch deg");
    for i in 0..=8 {
        let s = seam.length() * f64::from(i) / 8.0;
        let at = seam.at(s);
        // Seams without a centre, such as lines, have no angle phi.
        let phi = at.phi.map_or(f64::NAN, f64::to_degrees);
        let DVec3 { x, y, z } = at.point;
        let faces = at.dihedral.to_degrees();
        // The nozzle's axis is z, and the wire points down to the work.
        let from_axis = torch.pose(s).direction.angle_between(DVec3::NEG_Z).to_degrees();
        println!("{s:8.2} {phi:8.2} {x:9.3} {y:9.3} {z:9.3} {faces:10.2} {from_axis:10.2}");
    }
    Ok(())
}
