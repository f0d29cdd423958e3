//! Arguments of `seamwright edit`.

mod values;

use clap::{Args, Subcommand};
use seamwright_document::{Direction, Finite, NonNegative, Point, Positive};
use serde::Serialize;
use std::path::PathBuf;
use values::{
    by_name, direction, finite, length_range, named, non_negative, place, positive, steady_or_ramp, whole_range,
};

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright edit program.toml set-point --pass 1 --point 3 --set x_mm=12.5
  seamwright edit program.toml scale-speed --factor 0.9 --dry-run
  seamwright edit program.toml --script edits.json
  seamwright edit program.toml undo
Comments and layout stay; what would be no program is refused and nothing is written. Passes, spans and events count
from 1; point 0 is the start. What was done stands in FILE.edits."
)]
pub(crate) struct EditArgs {
    /// Program file
    pub(crate) file: PathBuf,
    /// Operation
    #[command(subcommand)]
    pub(crate) operation: Option<EditVerb>,
    /// JSON list of operations, applied in order, all or none (see `seamwright schema operation`)
    #[arg(long, value_name = "OPS.json")]
    pub(crate) script: Option<PathBuf>,
    /// Report as JSON
    #[arg(long, global = true)]
    pub(crate) json: bool,
    /// Show the changes without writing
    #[arg(long, global = true)]
    pub(crate) dry_run: bool,
    /// Write the result to this file; FILE and its history are unchanged
    #[arg(short, long, value_name = "OUT", global = true)]
    pub(crate) output: Option<PathBuf>,
}

// Serialized as the operation that it is.
#[derive(Debug, Clone, Subcommand, Serialize)]
#[serde(tag = "op", rename_all = "snake_case")]
pub(crate) enum EditVerb {
    /// Set numbers of a point
    #[command(after_help = "Example: seamwright edit p.toml set-point --pass 1 --point 3 --set x_mm=12.5,time_s=2")]
    SetPoint {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        /// 0 is the start
        #[arg(long)]
        point: usize,
        /// Columns and their numbers
        #[arg(long, value_name = "NAME=V,..", value_delimiter = ',', value_parser = named, required_unless_present = "speeds")]
        #[serde(serialize_with = "by_name")]
        set: Vec<(String, Finite)>,
        /// Columns of the position and their speeds per second, of cubics that end or start there
        #[arg(long, value_name = "NAME=V,..", value_delimiter = ',', value_parser = named)]
        #[serde(serialize_with = "by_name")]
        speeds: Vec<(String, Finite)>,
    },
    /// Insert a point with its numbers, or halfway to the next
    #[command(after_help = "Example: seamwright edit p.toml insert-point --pass 1 --after 3 --numbers 10,0,5,180,2")]
    InsertPoint {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long)]
        after: usize,
        /// A number for each column
        #[arg(long, value_name = "V,..", value_delimiter = ',', value_parser = finite, allow_hyphen_values = true)]
        numbers: Option<Vec<Finite>>,
    },
    /// Delete points; their times go to the next one left
    #[command(after_help = "Example: seamwright edit p.toml delete-points --pass 1 --from 3 --to 5")]
    DeletePoints {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long)]
        from: usize,
        /// The last one [default: only the first]
        #[arg(long)]
        to: Option<usize>,
    },
    /// Change the interpolation of a span: rapid, line, arc, spline, cubic (with the spline's speeds), taught
    #[command(after_help = "Example: seamwright edit p.toml interpolate --pass 1 --span 2 --along arc --via-mm 10,5,0")]
    Interpolate {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        /// The span, from 1
        #[arg(long)]
        span: usize,
        #[arg(long, value_parser = ["rapid", "line", "arc", "spline", "cubic", "taught"])]
        along: String,
        /// A point on the arc
        #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true)]
        via_mm: Option<Point>,
        /// Axis of a helix
        #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
        normal: Option<Direction>,
        /// Time or speed of points that were reached by rapid
        #[arg(long, value_parser = positive)]
        pace: Option<Positive>,
    },
    /// Split a span, behind a point or at a path length
    #[command(after_help = "Example: seamwright edit p.toml split-span --pass 1 --s-mm 120")]
    SplitSpan {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long, conflicts_with = "s_mm")]
        point: Option<usize>,
        /// From the start of the pass
        #[arg(long, value_parser = finite, allow_hyphen_values = true)]
        s_mm: Option<Finite>,
    },
    /// Join a span with the next one
    #[command(after_help = "Example: seamwright edit p.toml join-spans --pass 1 --span 2")]
    JoinSpans {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        /// The span, from 1
        #[arg(long)]
        span: usize,
    },
    /// Turn a pass to run from its end to its start
    #[command(after_help = "Example: seamwright edit p.toml reverse-pass --pass 1 --seam-length-mm 1600.83")]
    ReversePass {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        /// Length of a seam welded all round
        #[arg(long, value_parser = positive)]
        seam_length_mm: Option<Positive>,
    },
    /// Shift the start of a closed run to another point, of a pass along the seam, or of the weld to another angle
    #[command(after_help = "Example: seamwright edit p.toml shift-start --pass 1 --point 4")]
    ShiftStart {
        #[arg(long)]
        pass: Option<usize>,
        #[arg(long)]
        point: Option<usize>,
        #[arg(long, value_parser = non_negative)]
        begin_mm: Option<NonNegative>,
        #[arg(long, value_parser = finite, allow_hyphen_values = true)]
        phi_deg: Option<Finite>,
    },
    /// Mirror poses about a plane, or positions of an axis about a value
    #[command(after_help = "Examples: seamwright edit p.toml mirror --at-mm 100,0,0 --normal 1,0,0
          seamwright edit p.toml mirror --pass 2 --axis x --about 100")]
    Mirror {
        /// The pass [default: all through points]
        #[arg(long)]
        pass: Option<usize>,
        #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true)]
        at_mm: Option<Point>,
        #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
        normal: Option<Direction>,
        #[arg(long)]
        axis: Option<String>,
        #[arg(long, value_parser = finite, allow_hyphen_values = true)]
        about: Option<Finite>,
    },
    /// Move points by the torch's frame (travel, across, torch), or a pass beside the seam
    #[command(after_help = "Examples: seamwright edit p.toml offset --pass 1 --dy-mm 0.5 --dz-mm=-1
          seamwright edit p.toml offset --pass 2 --across-mm 2 --work-angle-deg 5")]
    Offset {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        /// First and last point, of a pass through points [default: all]
        #[arg(long, value_name = "FROM,TO", value_parser = whole_range)]
        points: Option<[usize; 2]>,
        #[arg(long, value_parser = finite, allow_hyphen_values = true, default_value = "0")]
        dx_mm: Finite,
        #[arg(long, value_parser = finite, allow_hyphen_values = true, default_value = "0")]
        dy_mm: Finite,
        #[arg(long, value_parser = finite, allow_hyphen_values = true, default_value = "0")]
        dz_mm: Finite,
        #[arg(long, value_parser = finite, allow_hyphen_values = true, default_value = "0")]
        across_mm: Finite,
        #[arg(long, value_parser = finite, allow_hyphen_values = true, default_value = "0")]
        out_mm: Finite,
        #[arg(long, value_parser = finite, allow_hyphen_values = true, default_value = "0")]
        work_angle_deg: Finite,
    },
    /// Travel faster or slower
    #[command(after_help = "Example: seamwright edit p.toml scale-speed --pass 1 --s-mm 100,200 --factor 0.8")]
    ScaleSpeed {
        /// The pass [default: all]
        #[arg(long)]
        pass: Option<usize>,
        /// First and last point, of a pass through points [default: all]
        #[arg(long, value_name = "FROM,TO", value_parser = whole_range)]
        points: Option<[usize; 2]>,
        /// Path lengths from the start of a pass along the seam, mm [default: all]
        #[arg(long, value_name = "FROM,TO", value_parser = length_range)]
        s_mm: Option<[NonNegative; 2]>,
        /// 2 is twice as fast
        #[arg(long, value_parser = positive)]
        factor: Positive,
    },
    /// Set a process value over a range: a number, or a ramp
    #[command(after_help = "Examples: seamwright edit p.toml set-process --pass 1 --name current_a --value 180
          seamwright edit p.toml set-process --pass 1 --s-mm 100,200 --name current_a --value 180,150")]
    SetProcess {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        /// First and last point, of a pass through points [default: all]
        #[arg(long, value_name = "FROM,TO", value_parser = whole_range)]
        points: Option<[usize; 2]>,
        /// Path lengths from the start of a pass along the seam, mm [default: all]
        #[arg(long, value_name = "FROM,TO", value_parser = length_range)]
        s_mm: Option<[NonNegative; 2]>,
        #[arg(long)]
        name: String,
        /// A number, or start and end of a ramp
        #[arg(long, value_name = "V or FROM,TO", value_delimiter = ',', value_parser = finite, allow_hyphen_values = true, num_args = 1..=2)]
        #[serde(serialize_with = "steady_or_ramp")]
        value: Vec<Finite>,
    },
    /// Number the points in column n
    #[command(after_help = "Example: seamwright edit p.toml renumber --start 10 --step 10")]
    Renumber {
        /// The pass [default: all through points]
        #[arg(long)]
        pass: Option<usize>,
        #[arg(long, default_value_t = 10)]
        start: usize,
        #[arg(long, default_value_t = 10)]
        step: usize,
    },
    /// Reduce points joined by lines to lines and arcs
    #[command(after_help = "Example: seamwright edit p.toml reduce --pass 1 --tolerance-mm 0.05 --axis-tolerance 0.1")]
    Reduce {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long, value_parser = positive)]
        tolerance_mm: Positive,
        /// Of further columns [default: the number of --tolerance-mm]
        #[arg(long, value_parser = positive)]
        axis_tolerance: Option<Positive>,
    },
    /// Set the active work offset
    #[command(after_help = "Example: seamwright edit p.toml set-offset --name table")]
    SetOffset {
        /// Without it no offset is active
        #[arg(long)]
        name: Option<String>,
    },
    /// Set or remove a variable
    #[command(after_help = "Example: seamwright edit p.toml set-variable --name lift --value 3.5")]
    SetVariable {
        #[arg(long)]
        name: String,
        /// Without it the variable is removed
        #[arg(long, value_parser = finite, allow_hyphen_values = true)]
        value: Option<Finite>,
    },
    /// Set name, role, arc or repetitions of a pass
    #[command(after_help = "Example: seamwright edit p.toml set-pass --pass 2 --name cap --role cap --repeat 2")]
    SetPass {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long)]
        name: Option<String>,
        #[arg(long, value_parser = ["tack", "root", "fill", "cap", "cosmetic"])]
        role: Option<String>,
        #[arg(long)]
        arc: Option<bool>,
        #[arg(long)]
        repeat: Option<u16>,
    },
    /// Add a pass from a JSON file
    #[command(after_help = "Example: seamwright edit p.toml add-pass --at 1 --from pass.json")]
    #[serde(skip)]
    AddPass {
        /// Its position in the order [default: last]
        #[arg(long)]
        at: Option<usize>,
        /// The pass, with the keys of the program file
        #[arg(long, value_name = "FILE.json")]
        from: PathBuf,
    },
    /// Delete a pass
    #[command(after_help = "Example: seamwright edit p.toml delete-pass --pass 2")]
    DeletePass {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
    },
    /// Move a pass to another position in the order
    #[command(after_help = "Example: seamwright edit p.toml move-pass --pass 3 --to 1")]
    MovePass {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long)]
        to: usize,
    },
    /// Insert a copy of a pass behind it
    #[command(after_help = "Example: seamwright edit p.toml duplicate-pass --pass 1 --name second")]
    DuplicatePass {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long)]
        name: Option<String>,
    },
    /// Add an event to a pass through points
    #[command(after_help = "Example: seamwright edit p.toml add-event --pass 1 --after 3 --gas true")]
    #[serde(skip)]
    AddEvent(EventArgs),
    /// Delete an event
    #[command(after_help = "Example: seamwright edit p.toml delete-event --pass 1 --event 2")]
    DeleteEvent {
        /// The pass, from 1
        #[arg(long)]
        pass: usize,
        #[arg(long)]
        event: usize,
    },
    /// Write the document in the usual order and layout
    #[command(after_help = "Example: seamwright edit p.toml format")]
    Format,
    /// Undo the last edit
    #[command(after_help = "Example: seamwright edit p.toml undo")]
    #[serde(skip)]
    Undo(StepArgs),
    /// Redo the last undone edit
    #[command(after_help = "Example: seamwright edit p.toml redo")]
    #[serde(skip)]
    Redo(StepArgs),
    /// List the edits, and the undone ones
    #[command(after_help = "Example: seamwright edit p.toml history")]
    #[serde(skip)]
    History,
}

#[derive(Debug, Clone, Args)]
pub(crate) struct EventArgs {
    #[arg(long)]
    pub(crate) pass: usize,
    /// Points reached before
    #[arg(long)]
    pub(crate) after: usize,
    #[arg(long)]
    pub(crate) gas: Option<bool>,
    #[arg(long)]
    pub(crate) wire: Option<bool>,
    /// Number of a digital output, with --on
    #[arg(long)]
    pub(crate) output_number: Option<u16>,
    #[arg(long)]
    pub(crate) on: Option<bool>,
    #[arg(long)]
    pub(crate) message: Option<String>,
    #[arg(long)]
    pub(crate) call: Option<String>,
}

#[derive(Debug, Clone, Args)]
pub(crate) struct StepArgs {
    /// Also after a change by hand, as far as possible
    #[arg(long)]
    pub(crate) force: bool,
}
