//! Arguments of `seamwright import`.

use super::post::{LevelArg, PostTargetArg};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example:
  seamwright import examples/ebw-fig1.mpf --machine ebw-7axis -o fig1.toml
  seamwright simulate fig1.toml -o out/fig1
  seamwright import weld.mod --machine irb-2600 -o weld.toml
An unknown word is an error with its line and column. Times of blocks are those of the control's own rule for
feeds. A pass begins where the part program calls a sub-program, where the arc goes on or off, and where the control
rests; outputs and codes become events by the machine file. Robot programs: the moves between arc start and arc end; the
planner chooses the rotation about the torch, external axes and transfer moves.")]
pub(crate) struct ReadArgs {
    /// Part program, or robot program
    pub(crate) file: PathBuf,
    /// Shipped machine, or a machine file: it defines the addresses
    #[arg(long)]
    pub(crate) machine: String,
    /// The control [default: by the file's name and content]
    #[arg(long, value_enum)]
    pub(crate) dialect: Option<PostTargetArg>,
    /// Meaning of the words where the program does not define it; not for robots
    #[arg(long, value_enum, default_value = "joint")]
    pub(crate) level: LevelArg,
    /// Omit unknown words and list them; not for robots
    #[arg(long)]
    pub(crate) lenient: bool,
    /// Maximum distance of the torch from corners without a stop, mm
    #[arg(long, default_value_t = 0.1, value_name = "MM")]
    pub(crate) blend_mm: f64,
    /// Write the program to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Print a summary as JSON instead of the program; with --output, in addition to it
    #[arg(long)]
    pub(crate) json: bool,
}
