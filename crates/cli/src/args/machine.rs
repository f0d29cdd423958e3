//! Arguments of `seamwright machine`.

use super::arm::{ImportArgs, NewArgs};
use super::io::IoArgs;
use super::move_to::MoveArgs;
use super::planning::KinematicsArgs;
use super::reach::ReachArgs;
use super::run::LatencyArgs;
use clap::{Args, Subcommand, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine show torch-5axis > machine.toml")]
pub(crate) struct MachineArgs {
    #[command(subcommand)]
    pub(crate) verb: MachineVerb,
}

#[derive(Debug, Subcommand)]
pub(crate) enum MachineVerb {
    /// List the shipped machines
    List(ListMachinesArgs),
    /// Print the file of a shipped machine
    Show(ShowArgs),
    /// Write the machine file of an arm from its URDF description
    Import(Box<ImportArgs>),
    /// Write a new machine file
    New(NewArgs),
    /// Find the work offset from touched points: the position of the part in the machine
    Place(PlaceArgs),
    /// Find the placement of the work with which the axes keep the largest margin over the whole seam; draw a map
    Reach(Box<ReachArgs>),
    /// Test a machine file: inverse, Jacobian, units, singular configurations, reach; draw its axes
    Check(CheckMachineArgs),
    /// Tune the position loops on the drives of a machine file, in simulation, and measure their margins
    Tune(TuneArgs),
    /// Forward or inverse kinematics of rows on standard input
    Kinematics(KinematicsArgs),
    /// Synchronised point-to-point move of all axes, jerk-limited and checked for collisions, as set-points
    Move(MoveArgs),
    /// Read the registers of a machine's devices by name: raw, scaled, age; once or live
    Io(IoArgs),
    /// Print the program that a robot control needs to take set-points
    RobotProgram(RobotProgramArgs),
    /// Measure the latency of a cyclic thread on this computer
    Latency(LatencyArgs),
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine list --json")]
pub(crate) struct ListMachinesArgs {
    /// JSON instead of a table
    #[arg(long)]
    pub(crate) json: bool,
}

/// Protocol of a robot control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum RobotProtocolName {
    /// Universal Robots RTDE: a program in URScript
    Rtde,
    /// ABB EGM: a module in RAPID
    Egm,
    /// KUKA RSI: a configuration, and a program in KRL
    Rsi,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine robot-program rtde > seamwright.script")]
pub(crate) struct RobotProgramArgs {
    /// Protocol of the control
    pub(crate) protocol: RobotProtocolName,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine show torch-5axis > machine.toml")]
pub(crate) struct ShowArgs {
    /// Shipped machine
    pub(crate) name: String,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine tune machines/saddle-4axis.toml -o out/tuning
Exit code 1 if an axis cannot be tuned to a gain margin of 6 dB and a phase margin of 35 degrees.")]
pub(crate) struct TuneArgs {
    /// Shipped machine, or a machine file
    pub(crate) machine: String,
    /// Tune only this axis
    #[arg(long, value_name = "NAME")]
    pub(crate) axis: Option<String>,
    /// Folder for tuning.toml and a Bode plot of each axis, bode-AXIS.svg; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// JSON instead of a table
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine check machines/torch-5axis.toml -o out/torch-5axis
Exit code 1 if a test fails; remarks on unusual values do not count.")]
pub(crate) struct CheckMachineArgs {
    /// Shipped machine, or a machine file
    pub(crate) machine: String,
    /// Folder for check.html, check.json and machine.svg; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Print check.json instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
    /// Seed of the random positions: the same seed gives the same result
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Random positions of the round trip, for each head
    #[arg(long, default_value_t = 20_000, value_name = "N")]
    pub(crate) poses: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlaceMethod {
    /// Three or more points with their nominal positions (nx_mm,ny_mm,nz_mm)
    ThreePoint,
    /// Touches of three faces: plane (z = 0), line (y = 0, along x), point (x = 0)
    PlaneLinePoint,
    /// Touches of the seam's surfaces: nozzle and body
    BestFit,
    /// Touches around a nozzle that turns about its nominal axis: run-out
    Chuck,
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: seamwright machine place examples/saddle.toml --points examples/saddle-touched.csv"
)]
pub(crate) struct PlaceArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    /// Touched points, CSV: x_mm,y_mm,z_mm in the work frame, or one column per axis of the machine; and feature or
    /// nx_mm,ny_mm,nz_mm as the method needs; - for standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) points: PathBuf,
    /// Method of computing the position of the part
    #[arg(long, value_enum, default_value = "best-fit")]
    pub(crate) method: PlaceMethod,
    /// Name of the work offset
    #[arg(long, default_value = "measured")]
    pub(crate) name: String,
    /// Radius of the probe's ball, if the points are its centres; 0 for points on the surface
    #[arg(long, default_value_t = 0.0, value_name = "R")]
    pub(crate) probe_radius_mm: f64,
    /// Maximum accepted residual, mm
    #[arg(long, default_value_t = 1.0, value_name = "MM")]
    pub(crate) largest_mm: f64,
    /// JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
    /// Write the job with the active offset to this file; the rest and its comments are preserved
    #[arg(short, long, value_name = "NEWJOB")]
    pub(crate) output: Option<PathBuf>,
}
