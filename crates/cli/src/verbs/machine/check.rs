use crate::args::machine::CheckMachineArgs;
use crate::clock;
use crate::labels::labelled;
use crate::progress::Progress;
use crate::refusals::{between, not_allowed};
use crate::rows::{json_text, print_either};
use seamwright_machine::check::{Check, CheckOptions};
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::load::machine_and_file;
use seamwright_report::{Drawing as _, Language, MachineDrawing, check_page, check_text};

/// Maximum number of positions of a round trip: ten million take minutes.
const MAX_POSES: u32 = 10_000_000;

pub(crate) fn run(args: &CheckMachineArgs) -> Result<(), Failure> {
    if !(1..=MAX_POSES).contains(&args.poses) {
        return Err(not_allowed("--poses", args.poses, between(1.0, f64::from(MAX_POSES))));
    }
    let (machine, file) = machine_and_file(&args.machine)?;
    let mut output = args.output.as_deref().map(Output::new).transpose()?;
    let options = CheckOptions { seed: args.seed, poses: args.poses };
    let mut progress = Progress::new("cli-progress-machine", Check::steps(&machine, &options));
    let check = Check::run(&file, &machine, &options, &mut || progress.step());
    drop(progress);
    let language = Language::of_process();
    let mut text = check_text(&check, language);
    if let Some(mut output) = output.take() {
        let drawing = MachineDrawing::new(&machine, language);
        output.text("check.html", &check_page(&check, &drawing, file.file(), file.text(), &clock::now(), language))?;
        output.text("check.json", &json_text(&check)?)?;
        output.text("machine.svg", &drawing.to_svg_standalone())?;
        for path in output.finish()? {
            labelled(&mut text, "cli-label-wrote", path.display());
        }
    }
    print_either(args.json, &check, || text)?;
    if check.passed { Ok(()) } else { Err(Failure::Printed) }
}
