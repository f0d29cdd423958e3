use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine reach first-weld --x=-100,100,5 --y=-100,100,5 -o out/reach
Ranges are relative to the present placement: FROM,TO or FROM,TO,CELLS. The grid has CELLS places from FROM to TO. With 1
cell it is at the present placement, and only the local search uses the range. A negative FROM needs the equals sign.
Ctrl-C ends the search with the best placement so far, a second one ends the program.
Exit code 1 if no placement is weldable and planned.")]
pub(crate) struct ReachArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    /// Move the machine's base, with all that stands on it, instead of the work; ranges are then in the base frame
    #[arg(long)]
    pub(crate) base: bool,
    /// Displacements of the work along x of the work frame, mm
    #[arg(long, value_name = "FROM,TO,CELLS", default_value = "-300,300,9", allow_hyphen_values = true)]
    pub(crate) x: String,
    /// Displacements along y, mm
    #[arg(long, value_name = "FROM,TO,CELLS", default_value = "-300,300,9", allow_hyphen_values = true)]
    pub(crate) y: String,
    /// Displacements along z, mm
    #[arg(long, value_name = "FROM,TO,CELLS", default_value = "-200,200,1", allow_hyphen_values = true)]
    pub(crate) z: String,
    /// Rotations about the vertical through the middle of the seam, with --base through the origin of the base frame, degrees
    #[arg(long, value_name = "FROM,TO,CELLS", default_value = "-180,180,1", allow_hyphen_values = true)]
    pub(crate) turn: String,
    /// Time for search and plans, s; at its end the best placement so far is the result
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0)]
    pub(crate) budget: f64,
    /// Write the best placement into the job file, with --base into the machine file; its comments and all other entries are
    /// preserved
    #[arg(long)]
    pub(crate) apply: bool,
    /// Folder for reach.html, reach.svg (the map), reach.csv and reach.json; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Print reach.json instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}
