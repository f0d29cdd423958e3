//! Plays a job on a simulated cell: drives with inertia, friction, encoders and current limits.
//!
//! `cargo run --release -p seamwright --example simulate`

use seamwright::load;
use seamwright::simulation::{self, Conditions, simulate};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let job = load(Path::new("first-weld"))?;
    let motion = job.plan()?;
    let paths = job.paths();
    let passes = job.passes(&paths);
    // The same seed gives the same disturbances, and so the same weld.
    let conditions = Conditions { seed: 1, ..Conditions::default() };
    let mut cycles = 0_u32;
    // Sees every servo period: the place to write a trace.
    let observer = |_: &simulation::Sample| {
        cycles += 1;
        Ok::<(), simulation::Error>(())
    };
    let summaries = simulate(&job.machine, &passes, &motion, conditions, observer)?;
    println!("{cycles} cycles of {} ms", 1e3 * job.machine.servo_period_s);
    for ((_, pass), summary) in passes.iter().zip(&summaries) {
        println!("{}: travel time: {:.3} s, arc on: {:.3} s", pass.name, summary.weld_s, summary.arc_on_s);
        let (error, allowed) = (summary.path_error_mm.max, pass.tolerance.path_mm.get());
        println!("  path error: {error:.3} mm of {allowed} mm, at s = {:.1} mm", summary.path_error_at_mm);
        // A weld without a steady phase has no speed to evaluate.
        if let Some(speed) = summary.tip_speed_mm_s {
            println!("  tip speed: {:.3} to {:.3} mm/s", speed.min, speed.max);
        }
        for axis in &summary.axes {
            println!("  drive {}: at most {:.0} % of its peak current", axis.axis, 100.0 * axis.current);
        }
    }
    Ok(())
}
