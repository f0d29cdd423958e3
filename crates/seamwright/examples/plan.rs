//! Plans a job on its machine: passes, times and findings.
//!
//! `cargo run --release -p seamwright --example plan [JOB]`, where JOB is a file or the name of a shipped example.

use seamwright::load;
use seamwright::motion::PassMotion;
use seamwright::project::failure::write_findings;
use std::error::Error;
use std::io;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let name = std::env::args_os().nth(1).map_or(PathBuf::from("saddle"), PathBuf::from);
    let job = load(&name)?;
    // If the machine cannot make the weld as asked, the error lists where, why, and a cure.
    let motion = job.plan()?;
    let program = &job.welding.program.value;
    println!("{}", program.title);
    println!("on {}", job.machine.title);
    for (pass, planned) in program.passes.iter().zip(&motion.passes) {
        let (length, time) = (planned.path.length(), planned.profile.duration());
        // Of the tip, between the acceleration and the deceleration phase.
        let (slowest, fastest) = planned.tip_band(&job.machine);
        println!("{}: {length:.2} mm in {time:.2} s, at {slowest:.2} to {fastest:.2} mm/s", pass.name);
    }
    let arc_on: f64 = motion.passes.iter().map(PassMotion::arc_on_s).sum();
    println!("arc on: {arc_on:.2} s; from home to home: {:.2} s", motion.total_s());
    // A weld that can be made may have findings too: warnings and notes.
    write_findings(&mut io::stdout(), &motion.findings)?;
    Ok(())
}
