//! Search for the placement of the work with the largest margin, and its proof by the planner.

use crate::failure::Failure;
use crate::load::{Loaded, load_text};
use crate::placing::{PlacedText, placed};
use crate::planning::Planning;
use seamwright_message::Message;
use seamwright_motion::reach::{Judged, Judgement, Pivot, Placement, PlacementTask, ReachGrid, SearchResult, search};
use seamwright_motion::{SearchProgress, Stop, Watch, WeldMotion};
use seamwright_program::Finding;
use seamwright_weld::SeamCurve;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Part of the budget for the search; the rest is for plans of the best placements.
const SEARCH_PART: f64 = 0.7;
/// Maximum number of placements that are planned.
const MAX_PLANS: usize = 6;
/// Ranks of placements closer than this are equal.
const SAME_SCORE: f64 = 2e-3;
/// Minimum distance of a placement from one whose plan failed, in cells of the grid.
const APART: f64 = 0.5;
/// Number of samples of the seam whose middle is the pivot.
const SAMPLES: u32 = 60;

/// A search for placements.
#[derive(Clone, Copy)]
pub struct ReachRequest<'a> {
    /// The placements, relative to the present one.
    pub grid: ReachGrid,
    /// Time for search and plans.
    pub budget: Duration,
    /// Set to end the search with what it has found.
    pub cancel: Option<&'a AtomicBool>,
    /// Shown the number of placements judged so far.
    pub progress: Option<&'a (dyn Fn(usize) + Sync)>,
}

/// A weldable placement that the planner tried.
pub struct TriedPlacement {
    /// The placement, with the margin of its rounded values.
    pub judged: Judged,
    /// The plan, or the findings against it.
    pub plan: Result<WeldMotion, Vec<Finding>>,
    /// The job with this placement.
    pub placed: PlacedText,
}

impl TriedPlacement {
    /// Minimum clearance over all passes, mm; none if nothing is watched.
    pub fn clearance_mm(&self) -> Option<f64> {
        let passes = self.plan.as_ref().ok()?.clearance.iter().flatten();
        passes.filter_map(|pass| pass.nearest.as_ref().map(|nearest| nearest.0)).reduce(f64::min)
    }
}

/// Result of a search.
pub struct Reached {
    /// Everything judged.
    pub search: SearchResult,
    /// Axis about which placements turn the work.
    pub pivot: Pivot,
    /// Placements that were planned, in the order of their margins. The last one is the best placement if its plan
    /// succeeded.
    pub tried: Vec<TriedPlacement>,
    /// True if the budget ended the search or the plans, or it was cancelled.
    pub is_cut_off: bool,
}

impl Reached {
    /// The best placement that the planner has planned.
    pub fn best(&self) -> Option<&TriedPlacement> {
        self.tried.last().filter(|tried| tried.plan.is_ok())
    }
}

/// Ends the work at a time or on request.
struct Deadline<'a> {
    end: Instant,
    cancel: Option<&'a AtomicBool>,
    limit: Duration,
}

impl Deadline<'_> {
    fn is_over(&self) -> bool {
        Instant::now() >= self.end || self.is_cancelled()
    }

    fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
    }
}

impl Watch for Deadline<'_> {
    fn look(&self, _: &SearchProgress) -> Result<(), Stop> {
        match self.is_over() {
            true if self.is_cancelled() => Err(Stop::Cancelled),
            true => Err(Stop::OutOfTime(self.limit.as_secs_f64())),
            false => Ok(()),
        }
    }
}

/// Searches placements of the work of `loaded`, whose file has the text `text` and lies in `folder`. Then plans the best
/// ones in turn until a plan succeeds.
///
/// # Errors
/// Passes that are given by axis positions, which no placement moves; a file without a place for the keys.
pub fn reach(loaded: &Loaded, text: &str, folder: &Path, request: &ReachRequest) -> Result<Reached, Failure> {
    let start = Instant::now();
    let end_of = |part: f64| Deadline {
        end: start + request.budget.mul_f64(part),
        cancel: request.cancel,
        limit: request.budget,
    };
    let paths = loaded.paths();
    let passes = loaded.passes(&paths);
    if let Some(pass) = passes.iter().position(|(path, _)| path.axes(0.0).is_some()) {
        let message = Message::new("project-reach-axes").pass("pass", pass + 1);
        let allowed = Message::new("project-reach-axes-allowed");
        return Err(loaded.welding.program.error_at(&loaded.welding.keys(pass).of(""), message, allowed).into());
    }
    let pivot = pivot(loaded);
    let procedure = loaded.welding.program.value.procedure.as_ref();
    let task = PlacementTask { machine: &loaded.machine, passes: &passes, procedure };
    let judging = Judging { task, pivot, deadline: end_of(SEARCH_PART), count: AtomicUsize::new(0), request };
    let mut search = search(&request.grid, &mut |placements| judging.judge_all(placements));
    let deadline = end_of(1.0);
    let mut tried: Vec<TriedPlacement> = Vec::new();
    let mut is_cut_off = !search.is_complete;
    for judged in candidates(&search) {
        if tried.len() == MAX_PLANS {
            break;
        }
        if deadline.is_over() {
            is_cut_off = true;
            break;
        }
        if tried.iter().any(|other| is_near(&request.grid, &other.judged.placement, &judged)) {
            continue;
        }
        let Some(judgement) = task.judge(judged.affine(&pivot), Some(&deadline)) else { continue };
        if judgement.margin().is_none() {
            continue;
        }
        let judged = Judged { placement: judged, cell: None, judgement };
        let Some(plan) = try_placement(loaded, text, folder, judged, &pivot, &deadline)? else {
            is_cut_off = true;
            break;
        };
        let is_planned = plan.plan.is_ok();
        search.judged.push(plan.judged.clone());
        tried.push(plan);
        if is_planned {
            break;
        }
    }
    Ok(Reached { search, pivot, tried, is_cut_off })
}

/// The vertical through the middle of the seam, or of the first pass.
fn pivot(loaded: &Loaded) -> Pivot {
    let path = loaded.welding.path(0);
    let path: &dyn seamwright_program::TorchPath = &path;
    let place = |i: u32| path.line_point(path.length() * f64::from(i) / f64::from(SAMPLES));
    // On a seam that comes round the end would count twice.
    let round = loaded.welding.seam.as_ref().is_some_and(SeamCurve::all_round);
    let count = if round { SAMPLES } else { SAMPLES + 1 };
    let point = (0..count).map(place).sum::<glam::DVec3>() / f64::from(count);
    Pivot { point, up: loaded.machine.up_in_work(&loaded.machine.home()) }
}

/// Weldable placements from the best to the worst, rounded; among equal ones the nearest to the present one first.
fn candidates(search: &SearchResult) -> Vec<Placement> {
    let mut weldable: Vec<&Judged> = search.judged.iter().filter(|j| j.judgement.margin().is_some()).collect();
    // A degree counts like a mm.
    let moved = |p: &Placement| p.by.length() + p.turn.to_degrees().abs();
    let rank = |judged: &Judged| (judged.judgement.score() / SAME_SCORE).round();
    weldable
        .sort_by(|a, b| rank(b).total_cmp(&rank(a)).then_with(|| moved(&a.placement).total_cmp(&moved(&b.placement))));
    weldable.into_iter().map(|judged| judged.placement.rounded()).collect()
}

/// True if `b` is so near to `a` that a plan would fail for the same reason.
fn is_near(grid: &ReachGrid, a: &Placement, b: &Placement) -> bool {
    let apart = a.coordinates().into_iter().zip(b.coordinates()).zip(&grid.spans);
    apart.into_iter().all(|((a, b), span)| (a - b).abs() < APART * span.step().max(f64::MIN_POSITIVE))
}

/// Plans the job with a placement as its file would be read; none if the time is over.
fn try_placement(
    loaded: &Loaded,
    text: &str,
    folder: &Path,
    judged: Judged,
    pivot: &Pivot,
    deadline: &Deadline,
) -> Result<Option<TriedPlacement>, Failure> {
    let placed = placed(text, &loaded.welding.program, &judged.placement.affine(pivot))?;
    let moved = load_text(loaded.welding.program.file(), &placed.text, folder)?;
    let stop = AtomicBool::new(false);
    let progress = |_: &SearchProgress| stop.store(deadline.is_over(), Ordering::Relaxed);
    let planning = Planning { limit: None, cancel: Some(&stop), progress: Some(&progress) };
    let planned = moved.with_torch_angles(&planning).and_then(|moved| moved.try_plan_under(&moved.machine, &planning));
    match planned {
        Ok(plan) => Ok(Some(TriedPlacement { judged, plan, placed })),
        Err(Failure::Cancelled) => Ok(None),
        Err(failure) => Err(failure),
    }
}

struct Judging<'a> {
    task: PlacementTask<'a>,
    pivot: Pivot,
    deadline: Deadline<'a>,
    count: AtomicUsize,
    request: &'a ReachRequest<'a>,
}

impl Judging<'_> {
    /// Judges placements on all cores. The result does not depend on their number.
    fn judge_all(&self, placements: &[Placement]) -> Vec<Option<Judgement>> {
        let results: Vec<Mutex<Option<Judgement>>> = placements.iter().map(|_| Mutex::new(None)).collect();
        let next = AtomicUsize::new(0);
        let work = || {
            while let Some((placement, result)) = {
                let i = next.fetch_add(1, Ordering::Relaxed);
                placements.get(i).zip(results.get(i))
            } {
                if self.deadline.is_over() {
                    break;
                }
                let judgement = self.task.judge(placement.affine(&self.pivot), Some(&self.deadline));
                let done = self.count.fetch_add(1, Ordering::Relaxed) + 1;
                // A poisoned lock belongs to a thread that panicked: the scope passes that on.
                if let Ok(mut result) = result.lock() {
                    *result = judgement;
                }
                if let Some(progress) = self.request.progress {
                    progress(done);
                }
            }
        };
        let cores = std::thread::available_parallelism().map_or(1, usize::from).min(placements.len());
        std::thread::scope(|scope| {
            (1..cores).for_each(|_| drop(scope.spawn(work)));
            work();
        });
        results.into_iter().map(|result| result.into_inner().ok().flatten()).collect()
    }
}
