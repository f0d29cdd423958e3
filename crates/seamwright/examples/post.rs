//! Writes a weld as a part program for LinuxCNC, with a proof.
//!
//! `cargo run --release -p seamwright --example post [FILE]`; without FILE it prints the start of the text.

use seamwright::load;
use seamwright::post::{Control, Dialect, Feed, Options};
use seamwright::project::posting::proven;
use std::error::Error;
use std::path::Path;

/// Number of lines printed without a file.
const LINES: usize = 12;

fn main() -> Result<(), Box<dyn Error>> {
    let job = load(Path::new("ellipse"))?;
    let motion = job.plan()?;
    let control = Control::new(&job.machine, Dialect::Linuxcnc)?;
    // Reads the text back, plays it by the control's rules and compares it with the plan: unproven text is an error.
    let (text, proof) = proven(&job, &motion, &control, &Options::default(), Feed::InverseTime)?;
    for message in proof.messages() {
        println!("{message}");
    }
    // From the text that was read back, not from the plan.
    let arc_on: f64 = proof.passes.iter().map(|pass| pass.arc_s).sum();
    println!("arc on: {arc_on:.3} s");
    match std::env::args_os().nth(1) {
        Some(file) => std::fs::write(file, &text)?,
        None => text.lines().take(LINES).for_each(|line| println!("  {line}")),
    }
    Ok(())
}
