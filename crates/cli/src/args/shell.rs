//! Arguments of what packages need: completions and manual pages.

use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright completions bash > /usr/share/bash-completion/completions/seamwright")]
pub(crate) struct CompletionsArgs {
    /// Shell: bash, zsh, fish, elvish or powershell
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright man man/man1")]
pub(crate) struct ManArgs {
    /// Folder for seamwright.1, seamwright-plan.1 and the others; made if missing
    pub(crate) folder: PathBuf,
}
