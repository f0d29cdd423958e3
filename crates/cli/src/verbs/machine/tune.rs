use super::tuning_report::{AxisTuning, snippet, table};
use crate::args::machine::TuneArgs;
use crate::labels::labelled;
use crate::progress::Progress;
use crate::refusals::refused;
use crate::rows::print_either;
use seamwright_machine::{Axis, Machine};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::files::{Output, written_text};
use seamwright_project::load::machine_and_file;
use seamwright_report::Drawing as _;
use seamwright_simulation::tune_axis;

pub(crate) fn run(args: &TuneArgs) -> Result<(), Failure> {
    let (machine, file) = machine_and_file(&args.machine)?;
    let axes = chosen(&machine, args.axis.as_deref())?;
    let mut output = args.output.as_deref().map(Output::new).transpose()?;
    let mut progress = Progress::new("cli-progress-tuning", axes.len() as u64);
    let mut tunings = Vec::with_capacity(axes.len());
    for axis in axes {
        tunings.push(AxisTuning::new(axis, tune_axis(axis, machine.servo_period_s)));
        progress.step();
    }
    drop(progress);
    let mut text = table(&machine.name, &tunings);
    if let Some(mut output) = output.take() {
        for tuning in &tunings {
            if let Some(bode) = tuning.bode() {
                output.text(&format!("bode-{}.svg", tuning.axis), &bode.grid().to_svg_standalone())?;
            }
        }
        output.text("tuning.toml", &snippet(file.file(), &tunings))?;
        for line in written_text(&output.finish()?) {
            labelled(&mut text, "cli-label-wrote", line);
        }
    }
    print_either(args.json, &tunings, || text)?;
    if tunings.iter().all(|t| t.tuned.is_some()) { Ok(()) } else { Err(Failure::Printed) }
}

fn chosen<'a>(machine: &'a Machine, name: Option<&str>) -> Result<Vec<&'a Axis>, Failure> {
    let all: Vec<&Axis> = machine.axes.iter().collect();
    let Some(name) = name else { return Ok(all) };
    let names = || all.iter().map(|a| a.name.as_str()).collect::<Vec<_>>().join(", ");
    match all.iter().find(|a| a.name == name) {
        Some(axis) => Ok(vec![axis]),
        None => Err(refused("--axis", name, Message::new("cli-no-such-axis"), names())),
    }
}
