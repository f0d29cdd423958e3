//! Completions and manual pages, made from the arguments themselves.

use crate::args::Cli;
use crate::args::shell::{CompletionsArgs, ManArgs};
use crate::rows::print_text;
use seamwright_project::failure::Failure;
use seamwright_project::files::not_writable;

pub(crate) fn completions(args: &CompletionsArgs) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::listed(), "seamwright", &mut text);
    print_text(&String::from_utf8_lossy(&text))
}

pub(crate) fn man(args: &ManArgs) -> Result<(), Failure> {
    let pages =
        std::fs::create_dir_all(&args.folder).and_then(|()| clap_mangen::generate_to(Cli::listed(), &args.folder));
    pages.map_err(|error| not_writable(&args.folder, &error))
}
