use super::data::open;
use crate::args::records::ExportArgs;
use crate::clock;
use crate::refusals::not_json;
use crate::rows::{print_json, print_text};
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
    let json = serde_json::to_string_pretty(&detail).map_err(not_json)?;
    output.text("record.json", &(json + "\n"))?;
    let page = recorded_weld_page(&detail, &figures, &program.text, &clock::now(), Language::of_process());
    output.text("report.html", &page)?;
    output.text("program.toml", &program.text)?;
    let paths = output.finish()?;
    if args.data.json {
        return print_json(&detail);
    }
    let wrote = |files: &String| format!("{}\n", Message::new("cli-wrote").text("files", files));
    print_text(&written_text(&paths).iter().map(wrote).collect::<String>())
}
