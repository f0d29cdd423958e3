//! Arguments of `seamwright import`.

use super::post::{DialectArg, LevelArg};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example:
  seamwright import examples/ebw-fig1.mpf --machine ebw-7axis -o fig1.toml
  seamwright simulate fig1.toml -o out/fig1
What is not understood is an error with its line and column. Times of blocks are those of the control's own rule for
feeds. A pass begins where the part program calls a sub-program, where the arc goes on or off, and where the control
rests; outputs and codes become events by the machine file.")]
pub(crate) struct ReadArgs {
    /// Part program
    pub(crate) file: PathBuf,
    /// Machine that ships, or a machine file: it says what the addresses mean
    #[arg(long)]
    pub(crate) machine: String,
    /// The control [default: by the file's name and what stands in it]
    #[arg(long, value_enum)]
    pub(crate) dialect: Option<DialectArg>,
    /// What the words mean where the text does not say
    #[arg(long, value_enum, default_value = "joint")]
    pub(crate) level: LevelArg,
    /// Leave out what is not understood, and list it
    #[arg(long)]
    pub(crate) lenient: bool,
    /// How far the torch may pass from corners that the control goes through without a stop, mm
    #[arg(long, default_value_t = 0.1, value_name = "MM")]
    pub(crate) blend_mm: f64,
    /// Write the program to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// JSON of what was read instead of the program; with --output, beside it
    #[arg(long)]
    pub(crate) json: bool,
}
