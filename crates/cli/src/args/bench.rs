//! Arguments of `seamwright tools bench`.

use clap::{Args, Subcommand, ValueEnum};

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright tools bench vision --frames 200 > vision.md")]
pub(crate) struct BenchArgs {
    #[command(subcommand)]
    pub(crate) verb: BenchVerb,
}

#[derive(Debug, Subcommand)]
pub(crate) enum BenchVerb {
    /// Joint detection in simulated frames and stripes: each requirement, its value and its limit
    Vision(BenchVisionArgs),
    /// Tracking of simulated seams during welding: deviation of each weld from its seam, with the papers'
    /// algorithms and without tracking
    Tracking(BenchTrackingArgs),
    /// Every fault of every device in every situation of a cell, against the required reaction
    Faults(BenchFaultsArgs),
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright tools bench faults --seeds 10
The cell is that of the example saddle. Exit code 1 if a case does not end as required.")]
pub(crate) struct BenchFaultsArgs {
    /// Number of moments at which each fault occurs
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    pub(crate) seeds: u64,
    /// JSON instead of markdown
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright tools bench tracking --seeds 10 > tracking.md
Welds are the same for the same number. Gates that are not kept are marked; they do not change the exit code.")]
pub(crate) struct BenchTrackingArgs {
    /// Number of welds of each kind; the worst counts
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..=1000))]
    pub(crate) seeds: u64,
    /// Print only this table
    #[arg(long, value_enum)]
    pub(crate) table: Option<TrackingTable>,
    /// JSON instead of markdown
    #[arg(long)]
    pub(crate) json: bool,
}

/// A table of `bench tracking`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TrackingTable {
    /// Seams of all kinds by all methods
    Seams,
    /// A long T-joint and a saddle
    Parts,
    /// Failing sensors and slides
    Faults,
    /// Beam mode
    Beam,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright tools bench vision --frames 200 > vision.md
Frames are the same for the same number. Gates that are not kept are marked; they do not change the exit code.")]
pub(crate) struct BenchVisionArgs {
    /// Number of frames of each kind
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    pub(crate) frames: u64,
    /// JSON instead of markdown
    #[arg(long)]
    pub(crate) json: bool,
}
