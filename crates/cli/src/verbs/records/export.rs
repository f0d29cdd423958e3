use super::data::open;
use crate::args::records::ExportArgs;
use crate::clock;
use crate::rows::{json_text, print_either};
use seamwright_message::{Language, Message};
use seamwright_project::failure::Failure;
use seamwright_project::files::{Output, written_text};
use seamwright_report::recorded_weld_page;

pub(super) fn run(args: &ExportArgs) -> Result<(), Failure> {
    let data = open(args.data.data.as_deref())?;
    let library = data.library();
    let detail = library.detail(args.id)?;
    let figures = data.figures(args.id)?;
    let mut output = Output::new(&args.output)?;
    for file in detail.files.iter().filter(|f| f.rows.is_some()) {
        output.take(&file.name, &data.weld_folder(args.id).join(&file.name))?;
    }
    let program = library.program_of(args.id)?;
    output.text("record.json", &json_text(&detail)?)?;
    let page = recorded_weld_page(&detail, &figures, &program.text, &clock::now(), Language::of_process());
    output.text("report.html", &page)?;
    output.text("program.toml", &program.text)?;
    let paths = output.finish()?;
    let wrote = |files: &String| format!("{}\n", Message::new("cli-wrote").text("files", files));
    print_either(args.data.json, &detail, || written_text(&paths).iter().map(wrote).collect())
}
