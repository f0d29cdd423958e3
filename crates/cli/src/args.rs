//! The command line, as in the contract of `docs/reference/cli.md`.

pub(crate) mod arm;
pub(crate) mod bench;
pub(crate) mod cluster;
pub(crate) mod edit;
pub(crate) mod find_joint;
pub(crate) mod follow;
mod former;
pub(crate) mod io;
pub(crate) mod licences;
pub(crate) mod machine;
pub(crate) mod move_to;
pub(crate) mod part;
pub(crate) mod planning;
pub(crate) mod post;
mod pulses;
pub(crate) mod reach;
pub(crate) mod read;
pub(crate) mod records;
pub(crate) mod reduce;
pub(crate) mod run;
pub(crate) mod scan;
pub(crate) mod schedule;
pub(crate) mod serve;
pub(crate) mod shell;
mod simulate;
pub(crate) mod stripe;
pub(crate) mod study;
pub(crate) mod teach;

use clap::error::{ContextKind, ErrorKind};
use clap::{Args, Command, CommandFactory as _, FromArgMatches as _, Id, Parser, Subcommand, ValueEnum};
pub(crate) use planning::{AppendixArgs, KinematicsArgs, PlanningArgs};
pub(crate) use pulses::PulsesArgs;
pub(crate) use simulate::SimulateArgs;
use std::ffi::OsString;
use std::path::PathBuf;

/// Plans, checks, simulates and posts CNC welds of seams that curve through space.
///
/// Without a verb it starts the cell with its panel: open the printed address.
#[derive(Debug, Parser)]
#[command(
    name = "seamwright",
    version,
    about,
    long_about,
    after_help = "Exit codes: 0 done; 1 the weld cannot be made as requested; 2 invalid input; 3 the environment failed."
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) verb: Option<Verb>,
    /// Language of messages, reports and plots: en, uk, zh, de, ru [default: that of LC_ALL, LC_MESSAGES or LANG]
    #[arg(long, global = true, value_name = "CODE")]
    pub(crate) language: Option<String>,
    /// Without a verb: the options of `serve`.
    #[command(flatten)]
    pub(crate) serve: serve::ServeArgs,
    /// The former name by which the verb was called, and its present one.
    #[arg(skip)]
    pub(crate) renamed: Option<former::Renamed>,
}

impl Cli {
    /// Parses the arguments of the process.
    pub(crate) fn of_process() -> Result<Self, clap::Error> {
        let mut arguments: Vec<OsString> = std::env::args_os().collect();
        let renamed = former::rename(&mut arguments);
        let matches = Self::command().try_get_matches_from(arguments).map_err(with_listed_names)?;
        // clap can forbid all options before a verb, but `--language` is allowed there.
        let group = serve::ServeArgs::group_id();
        let option = group.and_then(|group| matches.get_many::<Id>(group.as_str())?.next());
        if let (Some(option), Some(verb)) = (option, matches.subcommand_name()) {
            let message = format!("the subcommand '{verb}' cannot be used with '--{option}' before it");
            return Err(Self::command().error(ErrorKind::ArgumentConflict, message));
        }
        let cli = Self::from_arg_matches(&matches).map_err(|error| error.format(&mut Self::command()))?;
        Ok(Self { renamed, ..cli })
    }

    /// The command with its listed verbs: without those for packages and other processes.
    pub(crate) fn listed() -> Command {
        let all = Self::command();
        let verbs = all.get_subcommands().filter(|verb| !verb.is_hide_set()).cloned();
        Command::new("seamwright")
            .version(env!("CARGO_PKG_VERSION"))
            .about(all.get_about().cloned().unwrap_or_default())
            .long_about(all.get_long_about().cloned().unwrap_or_default())
            .after_help(all.get_after_help().cloned().unwrap_or_default())
            .args(all.get_arguments().cloned())
            .groups(all.get_groups().cloned())
            .subcommands(verbs)
    }
}

/// The same error; an unknown verb is compared with the listed verbs only.
fn with_listed_names(error: clap::Error) -> clap::Error {
    if error.kind() != ErrorKind::InvalidSubcommand {
        return error;
    }
    let word = |error: &clap::Error| error.get(ContextKind::InvalidSubcommand).cloned();
    let listed = Cli::listed().try_get_matches().err().filter(|listed| word(listed) == word(&error));
    listed.unwrap_or(error)
}

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Plan a job: weld program, checks, timing, report
    Plan(PlanArgs),
    /// Run the checks of a plan only; exit code 1 if the weld cannot be made as requested
    Check(CheckArgs),
    /// Plan many seams from one table: results, part programs, load of the machines, report
    Schedule(schedule::ScheduleArgs),
    /// Study tolerances of a job: probabilities, distributions and causes from many drawn plans
    Study(study::StudyArgs),
    /// Weld in simulation: drives, friction, encoders; trace and report
    Simulate(SimulateArgs),
    /// Run a job on a cell in real time, under orders from standard input
    Run(run::RunArgs),
    /// Start the cell and the operator's panel in the browser; also without any verb
    #[command(after_help = serve::HELP)]
    Serve(serve::ServeArgs),
    /// Stop the running cell at once: process off, axes at rest; needs neither panel nor login
    Stop(serve::StopArgs),
    /// Run the cell of a panel, which starts this process: executive and devices
    #[command(hide = true)]
    Cell(serve::CellArgs),
    /// Answer a question of the panel on standard input, with little memory and time
    #[command(hide = true)]
    AnswerOneQuestion(serve::QuestionArgs),
    /// Write a part program for another control
    Post(post::PostArgs),
    /// Read a part program of a control as a weld program
    Import(read::ReadArgs),
    /// Edit a program file: points, spans, passes, speeds; undo and redo
    Edit(edit::EditArgs),
    /// Teach a seam by camera: frames to a program of lines and arcs or a spline, with a report
    Teach(teach::TeachArgs),
    /// Recorded welds: list, show, export, verify, recover after a crash
    Records(records::RecordsArgs),
    /// Machines: list, show, check, place the work, tune, kinematics, moves, devices, latency
    Machine(machine::MachineArgs),
    /// The joint in an image: its line, or the features of a laser stripe
    Vision(VisionArgs),
    /// Tables of single results: seam, sections, set-points, pulses, reduced and followed points
    Tools(ToolsArgs),
    /// List the shipped example jobs and procedures, or print one to copy
    Examples(ExamplesArgs),
    /// Print the JSON Schema of a file format
    Schema(SchemaArgs),
    /// Print the licences of Seamwright and of all third-party packages in it, or its bill of materials (SBOM)
    #[command(alias = "licenses")]
    Licences(licences::LicencesArgs),
    /// Print the completions of a shell
    #[command(hide = true)]
    Completions(shell::CompletionsArgs),
    /// Write a manual page of every verb to a folder
    #[command(hide = true)]
    Man(shell::ManArgs),
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright vision joint joint.png --start 320,240 --direction-deg 90")]
pub(crate) struct VisionArgs {
    #[command(subcommand)]
    pub(crate) verb: VisionVerb,
}

#[derive(Debug, Subcommand)]
pub(crate) enum VisionVerb {
    /// The joint line in one image: its midline, station by station
    Joint(find_joint::FindJointArgs),
    /// The joint in an image or a profile of a laser stripe: joint point, gap, mismatch, area, angles
    Stripe(stripe::StripeArgs),
    /// The groove in a series of profiles along the seam: gap, mismatch, angle, open area, with their uncertainties
    Scan(scan::ScanArgs),
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright tools seam saddle --phi-deg 0,45,90")]
pub(crate) struct ToolsArgs {
    #[command(subcommand)]
    pub(crate) verb: ToolsVerb,
}

#[derive(Debug, Subcommand)]
pub(crate) enum ToolsVerb {
    /// The seam's geometry as a table: points, tangents, normals, bisector, dihedral angle
    Seam(SeamArgs),
    /// Cross-sections of the joint with all beads: a table, and a drawing
    Section(SectionArgs),
    /// The timed set-points of every axis, streamed
    Motion(MotionArgs),
    /// Step and direction pulses for steppers, with the selected microstepping
    Pulses(PulsesArgs),
    /// Set-points along taught points of any number, at constant speed
    Follow(follow::FollowArgs),
    /// Reduce taught points to lines and arcs whose ends are points
    Reduce(reduce::ReduceArgs),
    /// Compare textbook interpolators with the exact one
    Interpolate(InterpolateArgs),
    /// Run the acceptance benchmarks of this build
    Bench(bench::BenchArgs),
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: seamwright tools seam examples/saddle.toml --phi-deg 0,45,90"
)]
pub(crate) struct SeamArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    #[command(flatten)]
    pub(crate) places: PlacesArgs,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

/// Positions along the seam.
#[derive(Debug, Args)]
pub(crate) struct PlacesArgs {
    /// This many points at equal arc length from the start of the weld to its end, both included [default: 101; 9
    /// sections]
    #[arg(long, group = "where", value_name = "N")]
    pub(crate) points: Option<u32>,
    /// A point every D mm from the start of the weld, and its end
    #[arg(long, group = "where", value_name = "D")]
    pub(crate) every_mm: Option<f64>,
    /// Points at these angles about the nozzle's axis (eccentric angles of an ellipse), in degrees
    #[arg(long, group = "where", value_name = "A,B,..", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) phi_deg: Option<Vec<f64>>,
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: seamwright tools section examples/hillside.toml --phi-deg 0,45,90 --svg sections.svg"
)]
pub(crate) struct SectionArgs {
    /// Job file with a joint, or the name of an example
    pub(crate) job: PathBuf,
    #[command(flatten)]
    pub(crate) places: PlacesArgs,
    /// Draw the sections to this file, at the same scale
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = "Example: seamwright plan examples/saddle.toml -o out/saddle")]
pub(crate) struct PlanArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    /// Folder for program.toml, report.json and report.html; made if missing [default: out/ and the job's name]
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Also write the plots of the report as SVG files, into the folder plots/
    #[arg(long)]
    pub(crate) plots: bool,
    #[command(flatten)]
    pub(crate) appendix: AppendixArgs,
    /// Also write the part program for this control, with its proof in the report; may be repeated
    #[arg(long, value_enum, value_name = "DIALECT")]
    pub(crate) post: Vec<post::PostTargetArg>,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
    /// Print report.json instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright check examples/saddle.toml
  seamwright check jobs/*.toml
With several jobs the highest exit code counts; with --json each is an object with its job and findings, or its error."
)]
pub(crate) struct CheckArgs {
    /// Job or program files, or names of examples
    #[arg(required = true, value_name = "JOB")]
    pub(crate) jobs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
    /// JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}

/// Data for a control with its own fine interpolation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ExportArg {
    /// Control points of a uniform cubic B-spline, for PMAC's SPLINE1 mode: its curve then passes through our
    /// set-points. 24 points at rest lead in, from t_s below 0, and out
    Spline1,
    /// Positions, and the axes' speeds in separate columns, for moves by position, velocity and time (PVT)
    Pvt,
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright tools motion examples/ellipse.toml --period-ms 10 > set-points.csv
  seamwright tools motion examples/saddle.toml --period-ms 0.1 --coarse-ms 10 > fine.csv
  seamwright tools motion examples/saddle.toml --period-ms 10 --export spline1 > spline1.csv
  printf 't_s,command,value\\n8,override,60\\n12,hold,\\n20,resume,\\n' > commands.csv
  seamwright tools motion examples/saddle.toml --commands commands.csv > run.csv"
)]
pub(crate) struct MotionArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    /// Period of the set-points, ms [default: the machine's servo period]
    #[arg(long, value_name = "T")]
    pub(crate) period_ms: Option<f64>,
    /// Interval of exact set-points, ms, a whole multiple of the period; between them a cubic spline without
    /// jumps in speed or acceleration
    #[arg(long, value_name = "C")]
    pub(crate) coarse_ms: Option<f64>,
    /// Set-points for a control with its own fine interpolation
    #[arg(long, value_enum, conflicts_with = "coarse_ms")]
    pub(crate) export: Option<ExportArg>,
    /// Run under an operator's commands from this CSV: t_s,command,value, where command is override (value:
    /// percent, 0 to 150), hold, resume, reverse, step (value: mm to weld) or abort
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["coarse_ms", "export"])]
    pub(crate) commands: Option<PathBuf>,
    /// Include the transfer moves from home to the first weld and from the last back home
    #[arg(long)]
    pub(crate) air: bool,
    /// Write the speeds of each pass and its binding limits to this file, as JSON
    #[arg(long, value_name = "FILE")]
    pub(crate) certificate: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum CurveArg {
    /// An ellipse in the plane (ELLIPSE-2015)
    Ellipse,
    /// A nozzle on a cylindrical shell (SADDLE-2020)
    Saddle,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum MethodArg {
    /// Equal steps along the curve, or equal chords
    Exact,
    /// Increments of the eccentric angle, dt = dL / |OM|, as printed in ELLIPSE-2015
    EccentricAngle,
    /// Point-by-point comparison, pulse by pulse
    PointByPoint,
    /// Comparison of integrals, pulse by pulse
    ComparisonIntegral,
    /// Digital differential analyser, pulse by pulse
    Dda,
    /// All of them, and two other rules for the eccentric angle
    All,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum StepArg {
    /// Equal arc length per step: constant speed
    Arc,
    /// Equal chords
    Chord,
}

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright tools interpolate --curve ellipse --method exact --step chord > points.csv
  seamwright tools interpolate --curve ellipse --method all --summary --svg ellipse.svg
The defaults are the papers' examples: the ellipse of ELLIPSE-2015 (20 x 16 mm, from (0, 16) clockwise to (20, 0), 5 mm/s,
10 ms) and the saddle of SADDLE-2020 (250 on 800 mm, 10 mm/s, 20 ms)."
)]
pub(crate) struct InterpolateArgs {
    #[arg(long, value_enum)]
    pub(crate) curve: CurveArg,
    #[arg(long, value_enum, default_value = "exact")]
    pub(crate) method: MethodArg,
    /// Exact method: the constant quantity of every step
    #[arg(long, value_enum, default_value = "arc")]
    pub(crate) step: StepArg,
    /// Speed, mm/s [default: the paper's]
    #[arg(long)]
    pub(crate) speed_mm_s: Option<f64>,
    /// Period, ms [default: the paper's]
    #[arg(long)]
    pub(crate) period_ms: Option<f64>,
    /// Pulse equivalent of the pulse methods, mm
    #[arg(long, default_value_t = 0.001)]
    pub(crate) pulse_mm: f64,
    /// Ellipse: semi-axis along x, mm
    #[arg(long, default_value_t = 20.0)]
    pub(crate) a_mm: f64,
    /// Ellipse: semi-axis along y, mm
    #[arg(long, default_value_t = 16.0)]
    pub(crate) b_mm: f64,
    /// Ellipse: start point x,y in mm [default: 0,b]
    #[arg(long, value_delimiter = ',', num_args = 1, allow_hyphen_values = true, value_name = "X,Y")]
    pub(crate) start_mm: Option<Vec<f64>>,
    /// Ellipse: end point x,y in mm; equal to the start for a full turn [default: a,0]
    #[arg(long, value_delimiter = ',', num_args = 1, allow_hyphen_values = true, value_name = "X,Y")]
    pub(crate) end_mm: Option<Vec<f64>>,
    /// Ellipse: a full turn from the start point, clockwise
    #[arg(long, conflicts_with = "end_mm")]
    pub(crate) full_turn: bool,
    /// Saddle: radius of the nozzle, mm
    #[arg(long, default_value_t = 250.0)]
    pub(crate) nozzle_radius_mm: f64,
    /// Saddle: radius of the shell, mm
    #[arg(long, default_value_t = 800.0)]
    pub(crate) shell_radius_mm: f64,
    /// Saddle: angle to sweep, degrees
    #[arg(long, default_value_t = 360.0, allow_hyphen_values = true)]
    pub(crate) sweep_deg: f64,
    /// Print statistics, one row per method, instead of points
    #[arg(long)]
    pub(crate) summary: bool,
    /// Draw the paths and their errors to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  seamwright examples
  seamwright examples saddle > my.toml
  seamwright examples --procedures")]
pub(crate) struct ExamplesArgs {
    #[command(flatten)]
    pub(crate) list: ListArgs,
    /// Welding procedures instead of jobs
    #[arg(long)]
    pub(crate) procedures: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ListArgs {
    /// Print the file of this entry instead of the list
    pub(crate) name: Option<String>,
    /// JSON instead of a table
    #[arg(long, conflicts_with = "name")]
    pub(crate) json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Job,
    Machine,
    Operation,
    Procedure,
    Program,
    Study,
    /// OpenAPI 3.1 of the panel's server
    Rest,
    /// Types of the panel's server
    Typescript,
}

#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = "Example: seamwright schema job > job.schema.json")]
pub(crate) struct SchemaArgs {
    /// File format, or interface
    #[arg(value_enum)]
    pub(crate) format: Format,
}

#[cfg(test)]
mod tests {
    use super::Cli;

    /// The page of commands in the book is made from the arguments; `SEAMWRIGHT_BLESS=1` writes it.
    #[test]
    fn the_reference_of_commands_is_current() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/commands.md");
        let options = clap_markdown::MarkdownOptions::new().title("Commands".to_owned()).show_footer(false);
        let page = clap_markdown::help_markdown_custom::<Cli>(&options);
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            std::fs::write(path, &page).unwrap();
        }
        let current = std::fs::read_to_string(path).unwrap_or_default();
        assert!(current == page, "docs/reference/commands.md: run this test with SEAMWRIGHT_BLESS=1");
    }
}
