use super::plan::{finish, write_program};
use super::simulate::{judge, weld};
use crate::args::records::RecordArgs;
use crate::examples::EXAMPLES;
use crate::failure::Failure;
use crate::files::Output;
use crate::load::load_text;
use seamwright_cell::Conditions;
use std::path::Path;

/// Where the example weld leaves its report.
const FOLDER: &str = "out/saddle";

/// Plans and welds the first example in simulation.
pub(crate) fn run() -> Result<(), Failure> {
    let example = &EXAMPLES[0];
    let loaded = load_text(&format!("examples/{}.toml", example.name), example.text, Path::new("."))?;
    let motion = loaded.plan()?;
    let mut output = Output::new(Path::new(FOLDER))?;
    let conditions = Conditions { seed: 1, ..Conditions::default() };
    let (report, desk) = weld(&loaded, &motion, (conditions, false), &mut output, &RecordArgs::default())?;
    write_program(&mut output, &loaded)?;
    finish(output, &report, false)?;
    judge(report)?;
    desk.judge()
}
