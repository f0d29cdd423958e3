use super::plan::finish;
use super::simulate::weld;
use crate::examples::EXAMPLES;
use crate::failure::Failure;
use crate::files::Output;
use crate::load::load_text;
use std::path::Path;

/// Where the example weld leaves its report.
const FOLDER: &str = "out/saddle";

/// Plans and welds the first example in simulation.
pub(crate) fn run() -> Result<(), Failure> {
    let example = &EXAMPLES[0];
    let loaded = load_text(&format!("examples/{}.toml", example.name), example.text, Path::new("."))?;
    let motion = loaded.plan()?;
    let mut output = Output::new(Path::new(FOLDER))?;
    let report = weld(&loaded, &motion, 1, &mut output)?;
    let program = loaded.welding.program.value.to_toml().map_err(|e| Failure::Environment(e.to_string()))?;
    output.text("program.toml", &program)?;
    finish(output, &report, false)
}
