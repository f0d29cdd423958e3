use crate::args::reach::ReachArgs;
use crate::clock;
use crate::interrupt::on_ctrl_c;
use crate::labels::labelled;
use crate::progress::Progress;
use crate::refusals::{at_most, not_allowed, refused};
use crate::rows::{json_text, print_either};
use crate::verbs::positive;
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit};
use seamwright_motion::reach::{Moved, PlacementMargin, ReachGrid, ReachSpan, SpanError};
use seamwright_project::failure::Failure;
use seamwright_project::files::{self, Output};
use seamwright_project::load::{Loaded, load};
use seamwright_project::placing::inline;
use seamwright_project::reach::{CutOff, JobText, ReachRequest, Reached, TriedPlacement, reach};
use seamwright_report::{BestPlacement, Drawing as _, Language, PlacementRow, ReachFigures, reach_page};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Maximum number of places in the grid.
const MAX_CELLS: usize = 100_000;
/// Longest budget that is allowed, s.
const MAX_BUDGET_S: f64 = 1e6;
/// Largest displacement that is allowed, mm, and rotation, degrees.
const MAX_MM: f64 = 1e5;
const MAX_DEG: f64 = 360.0;
/// Placements of the local search, about, for the progress bar.
const LOCAL: u64 = 200;

pub(crate) fn run(args: &ReachArgs) -> Result<(), Failure> {
    let grid = grid(args)?;
    let budget = positive("--budget", args.budget)?;
    if budget > MAX_BUDGET_S {
        return Err(not_allowed("--budget", budget, at_most(MAX_BUDGET_S, Unit::S)));
    }
    if args.apply && !args.base && !args.job.is_file() {
        let (fault, allowed) = ("cli-reach-no-file", "cli-reach-job-file");
        return Err(refused("--apply", args.job.display(), Message::new(fault), Message::new(allowed)));
    }
    let loaded = load(&args.job)?;
    let target = Target::new(args, &loaded)?;
    let mut output = args.output.as_deref().map(Output::new).transpose()?;
    let reached = search(args, &loaded, grid, budget)?;
    let figures = figures(args, &loaded, &reached);
    let language = Language::of_process();
    let mut text = summary(&figures, &reached, budget);
    if let Some(best) = reached.best().filter(|_| args.base) {
        let entry = Message::new("cli-reach-base-entry").text("file", &target.name).key("key", &best.placed.key);
        labelled(&mut text, "cli-label-entry", entry.text("entry", inline(&best.placed.transform)));
    }
    if let Some(mut output) = output.take() {
        let map = figures.map(&grid, language);
        let file = loaded.welding.program.file();
        output.text("reach.html", &reach_page(&figures, &map, file, &clock::now(), language))?;
        output.text("reach.svg", &map.to_svg_standalone())?;
        output.text("reach.csv", &figures.csv())?;
        output.text("reach.json", &json_text(&figures)?)?;
        for path in output.finish()? {
            labelled(&mut text, "cli-label-wrote", path.display());
        }
    }
    if let (Some(best), true) = (reached.best(), args.apply) {
        target.apply(best)?;
        labelled(&mut text, "cli-label-wrote", &target.name);
    }
    print_either(args.json, &figures, || text)?;
    if figures.best.is_some() { Ok(()) } else { Err(Failure::Printed) }
}

fn search(args: &ReachArgs, loaded: &Loaded, grid: ReachGrid, budget: f64) -> Result<Reached, Failure> {
    let cancel = on_ctrl_c()?;
    let bar = Progress::new("cli-progress-reach", grid.count() as u64 + LOCAL);
    let show = |judged: usize| bar.at(judged as u64);
    let budget = Duration::from_secs_f64(budget);
    let request = ReachRequest { moved: moved(args), grid, budget, cancel: Some(&cancel), progress: Some(&show) };
    let folder = args.job.parent().unwrap_or(Path::new("."));
    reach(loaded, JobText { text: loaded.welding.program.text(), folder }, &request)
}

fn moved(args: &ReachArgs) -> Moved {
    if args.base { Moved::Base } else { Moved::Work }
}

/// The file that holds the placement.
struct Target {
    /// Its name; of a machine without a file that of the machine.
    name: String,
    path: Option<PathBuf>,
    /// Its text before the search.
    text: String,
}

impl Target {
    /// Refuses `--apply` for a supplied machine.
    fn new(args: &ReachArgs, loaded: &Loaded) -> Result<Self, Failure> {
        if !args.base {
            let name = args.job.display().to_string();
            return Ok(Self { name, path: Some(args.job.clone()), text: loaded.welding.program.text().to_owned() });
        }
        let (path, wanted) = (loaded.machine_file.clone(), &loaded.welding.program.value.machine);
        if args.apply && path.is_none() {
            let fault = Message::new("cli-reach-supplied");
            return Err(refused("--apply", wanted, fault, Message::new("cli-reach-own-machine").text("name", wanted)));
        }
        let name = path.as_ref().map_or_else(|| wanted.clone(), |path| path.display().to_string());
        Ok(Self { name, path, text: loaded.machine_text()? })
    }

    /// Writes the best placement, unless somebody else has changed the file since.
    fn apply(&self, best: &TriedPlacement) -> Result<(), Failure> {
        let Some(path) = &self.path else { return Ok(()) };
        if files::read(path)? != self.text {
            return Err(Failure::input(Message::new("cli-reach-changed").text("file", &self.name)));
        }
        files::write(path, &best.placed.text)
    }
}

fn grid(args: &ReachArgs) -> Result<ReachGrid, Failure> {
    let mm = |option, value: &str| span(option, value, MAX_MM, 1.0);
    let turn = span("--turn", &args.turn, MAX_DEG, 1f64.to_radians())?;
    let grid = ReachGrid { spans: [mm("--x", &args.x)?, mm("--y", &args.y)?, mm("--z", &args.z)?, turn] };
    if grid.count() > MAX_CELLS {
        let cells = Message::new("cli-reach-cells-allowed").count("max", MAX_CELLS);
        let options = [("--x", &args.x), ("--y", &args.y), ("--z", &args.z), ("--turn", &args.turn)];
        let largest = options.into_iter().zip(&grid.spans).max_by_key(|(_, span)| span.cells());
        let (option, value) = largest.map_or(("--x", &args.x), |(option, _)| option);
        let fault = Message::new("cli-reach-too-many-cells").count("cells", grid.count());
        return Err(refused(option, value, fault, cells));
    }
    Ok(grid)
}

/// A range of an option, `FROM,TO` or `FROM,TO,CELLS`, with ends within `max`, times `unit`.
fn span(option: &str, value: &str, max: f64, unit: f64) -> Result<ReachSpan, Failure> {
    let form = || not_allowed(option, value, Message::new("cli-reach-form"));
    let parts: Vec<&str> = value.split(',').map(str::trim).collect();
    let (ends, cells) = match parts[..] {
        [from, to] => ([from, to], "1"),
        [from, to, cells] => ([from, to], cells),
        _ => return Err(form()),
    };
    let [from, to] = ends.map(|end| end.parse::<f64>().ok().filter(|end| end.abs() <= max));
    let cells: usize = cells.parse().map_err(|_| form())?;
    let (Some(from), Some(to)) = (from, to) else {
        let allowed = Message::new("cli-reach-ends").value("min", -max, Unit::One).value("max", max, Unit::One);
        return Err(not_allowed(option, value, allowed));
    };
    ReachSpan::new(from * unit, to * unit, cells).map_err(|error| match error {
        SpanError::Reversed => {
            refused(option, value, Message::new("cli-reach-reversed"), Message::new("cli-reach-form"))
        }
        SpanError::NoCells | SpanError::NotFinite => form(),
    })
}

fn figures(args: &ReachArgs, loaded: &Loaded, reached: &Reached) -> ReachFigures {
    let machine = &loaded.machine;
    let title = &loaded.welding.program.value.title;
    let mut figures = ReachFigures::new(title, machine, &reached.pivot, &reached.search);
    figures.moved = moved(args);
    figures.cut_off = reached.cut_off.is_some();
    figures.best = reached.best().map(|best| best_placement(machine, best));
    figures
}

fn best_placement(machine: &Machine, best: &TriedPlacement) -> BestPlacement {
    let planned = best.plan.as_ref().map(|plan| PlacementMargin::of_plan(machine, plan)).unwrap_or_default();
    BestPlacement {
        row: PlacementRow::new(machine, &best.judged),
        planned_range_margin: planned.range,
        planned_axis: planned.nearest.map(|nearest| machine.axes[nearest.axis].name.clone()),
        clearance_mm: best.clearance_mm(),
        key: best.placed.key.clone(),
        move_mm: best.placed.transform.move_mm.get().to_array(),
        turn: best.placed.transform.turn.map(|turn| turn.unit().to_array()),
        angle_deg: best.placed.transform.angle_deg.get(),
    }
}

fn summary(figures: &ReachFigures, reached: &Reached, budget: f64) -> String {
    let mut text = format!("{}\n", figures.title);
    labelled(&mut text, "cli-label-machine", &figures.machine);
    let moved = match figures.moved {
        Moved::Work => "cli-reach-moves-work",
        Moved::Base => "cli-reach-moves-base",
    };
    labelled(&mut text, "cli-label-moved", Message::new(moved));
    let judged = Message::new("cli-reach-judged").count("placements", figures.placements.len());
    labelled(&mut text, "cli-label-judged", judged.count("weldable", figures.weldable()));
    match reached.cut_off {
        Some(CutOff::Budget) => {
            let cut_off = Message::new("cli-reach-cut-off").value("budget", budget, Unit::S);
            labelled(&mut text, "cli-label-budget", cut_off);
        }
        Some(CutOff::Cancelled) => labelled(&mut text, "cli-label-budget", Message::new("cli-reach-interrupted")),
        None => {}
    }
    if let Some(present) = figures.placements.first() {
        labelled(&mut text, "cli-label-present", described(present));
    }
    for tried in reached.tried.iter().filter(|tried| tried.plan.is_err()) {
        let [x, y, z, turn] = tried.judged.placement.coordinates();
        let at = at(x, y, z, turn.to_degrees());
        let finding = tried.plan.as_ref().err().and_then(|found| found.iter().find(|finding| !finding.allowed));
        let reason = finding.map_or_else(Message::default, |finding| finding.message.clone());
        let failed = Message::new("cli-reach-not-planned").message("placement", at).message("reason", reason);
        labelled(&mut text, "cli-label-judged", failed);
    }
    match &figures.best {
        Some(best) => {
            let row = &best.row;
            labelled(&mut text, "cli-label-best", at(row.x_mm, row.y_mm, row.z_mm, row.turn_deg));
            labelled(&mut text, "cli-label-best", described(row));
            if let Some(axis) = &best.planned_axis {
                let margin = 100.0 * best.planned_range_margin;
                let planned = Message::new("cli-reach-planned").quantity("margin", margin, Unit::Percent, 1);
                labelled(&mut text, "cli-label-planned", planned.axis("axis", axis));
            }
            if let Some(clearance) = best.clearance_mm {
                let clearance = Message::new("quantity").quantity("value", clearance, Unit::Mm, 1);
                labelled(&mut text, "cli-label-clearance", clearance);
            }
            // That of a machine file comes with the name of the file.
            if figures.moved == Moved::Work {
                let [x, y, z] = best.move_mm.map(|v| format!("{v}"));
                let entry =
                    Message::new("cli-reach-entry").key("key", &best.key).text("vector", format!("[{x}, {y}, {z}]"));
                labelled(&mut text, "cli-label-entry", entry.quantity("angle", best.angle_deg, Unit::Deg, 3));
            }
        }
        None => labelled(&mut text, "cli-label-best", Message::new("cli-reach-none")),
    }
    text
}

fn at(x: f64, y: f64, z: f64, turn_deg: f64) -> Message {
    // `+ 0.0` turns a negative zero into zero.
    Message::new("cli-reach-at")
        .quantity("x", x + 0.0, Unit::Mm, 1)
        .quantity("y", y + 0.0, Unit::Mm, 1)
        .quantity("z", z + 0.0, Unit::Mm, 1)
        .quantity("turn", turn_deg + 0.0, Unit::Deg, 1)
}

/// The margin of a placement, or the reason why it fails.
fn described(row: &PlacementRow) -> Message {
    let station = |message: Message| {
        message.pass("pass", row.pass.unwrap_or(1)).quantity("s", row.s_mm.unwrap_or_default(), Unit::Mm, 1)
    };
    match (&row.reason, row.range_margin, &row.axis) {
        (Some(reason), ..) => station(Message::new("cli-reach-fails").message("reason", reason.clone())),
        (None, Some(margin), Some(axis)) => {
            let margin = Message::new("cli-reach-margin").quantity("margin", 100.0 * margin, Unit::Percent, 1);
            station(margin.axis("axis", axis))
        }
        _ => Message::new("cli-reach-free"),
    }
}
