//! Search for the placement of the work, or of the machine's base, with the largest margin, and its proof by the planner.
//!
//! A base placement is judged on the machine whose file has the base moved: the same text that is written then.

use crate::failure::Failure;
use crate::load::{Loaded, load_text, machine_text};
use crate::placing::{PlacedText, placed, placed_base};
use crate::planning::Planning;
use glam::DAffine3;
use seamwright_machine::{Machine, MachineFile};
use seamwright_message::Message;
use seamwright_motion::reach::{
    Judged, Judgement, Moved, Pivot, Placement, PlacementTask, ReachGrid, SearchResult, search,
};
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

/// Reason why a search ended early.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutOff {
    /// The time was over.
    Budget,
    /// It was cancelled.
    Cancelled,
}

/// A search for placements.
#[derive(Clone, Copy)]
pub struct ReachRequest<'a> {
    /// The work or the base.
    pub moved: Moved,
    /// The placements, relative to the present one.
    pub grid: ReachGrid,
    /// Time for search and plans.
    pub budget: Duration,
    /// Set to end the search with what it has found. The best placements are planned all the same, within the part of the
    /// budget that is meant for plans.
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
    /// The job with this placement, or the machine file with its base there.
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
    /// Reason for an early end of the search or the plans.
    pub cut_off: Option<CutOff>,
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

    /// The reason why it is over.
    fn cut_off(&self) -> CutOff {
        if self.is_cancelled() { CutOff::Cancelled } else { CutOff::Budget }
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

/// The text of a job or program, and the folder in which it lies.
#[derive(Clone, Copy)]
pub struct JobText<'a> {
    /// The text.
    pub text: &'a str,
    /// The folder.
    pub folder: &'a Path,
}

/// Searches placements for `loaded`, which was read from `job`. Then plans the best ones in turn until a plan succeeds.
///
/// # Errors
/// Passes that are given by axis positions, which no placement moves; a file without a place for the keys.
pub fn reach(loaded: &Loaded, job: JobText, request: &ReachRequest) -> Result<Reached, Failure> {
    let start = Instant::now();
    let paths = loaded.paths();
    let passes = loaded.passes(&paths);
    if let Some(pass) = passes.iter().position(|(path, _)| path.axes(0.0).is_some()) {
        let message = Message::new("project-reach-axes").pass("pass", pass + 1);
        let allowed = Message::new("project-reach-axes-allowed");
        return Err(loaded.welding.program.error_at(&loaded.welding.keys(pass).of(""), message, allowed).into());
    }
    let base = match request.moved {
        Moved::Work => None,
        Moved::Base => Some(MovableBase::new(loaded)?),
    };
    let pivot = base.as_ref().map_or_else(|| pivot(loaded), MovableBase::pivot);
    let procedure = loaded.welding.program.value.procedure.as_ref();
    let task = PlacementTask { machine: &loaded.machine, passes: &passes, procedure };
    let limit = request.budget;
    let deadline = Deadline { end: start + limit.mul_f64(SEARCH_PART), cancel: request.cancel, limit };
    let judging = Judging {
        task,
        base: base.as_ref(),
        pivot,
        deadline,
        count: AtomicUsize::new(0),
        fault: Mutex::new(None),
        request,
    };
    let mut search = search(&request.grid, &mut |placements| judging.judge_all(placements));
    if let Some(fault) = judging.fault() {
        return Err(fault);
    }
    let mut cut_off = (!search.is_complete).then(|| judging.deadline.cut_off());
    // A search that was cancelled leaves its plans the time that they would have had after the budget.
    let plans_end = (start + limit).min(Instant::now() + limit.mul_f64(1.0 - SEARCH_PART));
    let plans = Plans { loaded, job, judging: &judging, deadline: Deadline { end: plans_end, cancel: None, limit } };
    let tried = plans.of_best(&mut search, &mut cut_off)?;
    Ok(Reached { search, pivot, tried, cut_off })
}

/// A machine whose base is moved, as its file has it.
struct MovableBase<'a> {
    loaded: &'a Loaded,
    /// Name of the file, or of the supplied machine.
    file: String,
    text: String,
    machine: MachineFile,
}

impl<'a> MovableBase<'a> {
    fn new(loaded: &'a Loaded) -> Result<Self, Failure> {
        let text = loaded.machine_text()?;
        let path = loaded.machine_file.as_ref().map(|path| path.display().to_string());
        let file = path.unwrap_or_else(|| loaded.welding.program.value.machine.clone());
        let machine = MachineFile::read(&file, &text)?.value;
        Ok(Self { loaded, file, text, machine })
    }

    /// The vertical through the origin of the base frame.
    fn pivot(&self) -> Pivot {
        Pivot { point: glam::DVec3::ZERO, up: self.loaded.machine.up }
    }

    /// The machine file with its base displaced by `by` in the base frame, and its machine.
    fn moved(&self, by: &DAffine3) -> Result<(PlacedText, Machine), Failure> {
        let placed = placed_base(&self.text, &self.file, &self.machine, by)?;
        let machine = machine_text(&self.file, &placed.text, self.loaded.folder())?;
        Ok((placed, machine))
    }
}

/// Plans of the best placements.
struct Plans<'a> {
    loaded: &'a Loaded,
    job: JobText<'a>,
    judging: &'a Judging<'a>,
    deadline: Deadline<'a>,
}

impl Plans<'_> {
    /// Plans the best placements in turn until a plan succeeds.
    fn of_best(&self, search: &mut SearchResult, cut_off: &mut Option<CutOff>) -> Result<Vec<TriedPlacement>, Failure> {
        let mut tried: Vec<TriedPlacement> = Vec::new();
        for placement in candidates(search) {
            if tried.len() == MAX_PLANS {
                break;
            }
            if self.deadline.is_over() {
                cut_off.get_or_insert(CutOff::Budget);
                break;
            }
            let grid = &self.judging.request.grid;
            if tried.iter().any(|other| is_near(grid, &other.judged.placement, &placement)) {
                continue;
            }
            let Some(judgement) = self.judging.judge(&placement, &self.deadline)? else { continue };
            if judgement.margin().is_none() {
                continue;
            }
            let judged = Judged { placement, cell: None, judgement };
            let Some(plan) = self.try_placement(judged)? else {
                cut_off.get_or_insert(CutOff::Budget);
                break;
            };
            let is_planned = plan.plan.is_ok();
            search.judged.push(plan.judged.clone());
            tried.push(plan);
            if is_planned {
                break;
            }
        }
        Ok(tried)
    }

    /// Plans the job with a placement as its files would be read; none if the time is over.
    fn try_placement(&self, judged: Judged) -> Result<Option<TriedPlacement>, Failure> {
        let (loaded, JobText { text, folder }) = (self.loaded, self.job);
        let file = loaded.welding.program.file();
        let by = judged.placement.affine(&self.judging.pivot);
        let (placed, moved) = match self.judging.base {
            Some(base) => {
                let (placed, machine) = base.moved(&by)?;
                (placed, Loaded { machine, ..load_text(file, text, folder)? })
            }
            None => {
                let placed = placed(text, &loaded.welding.program, &by)?;
                let moved = load_text(file, &placed.text, folder)?;
                (placed, moved)
            }
        };
        let stop = AtomicBool::new(false);
        let progress = |_: &SearchProgress| stop.store(self.deadline.is_over(), Ordering::Relaxed);
        let planning = Planning { limit: None, cancel: Some(&stop), progress: Some(&progress) };
        let planned =
            moved.with_torch_angles(&planning).and_then(|moved| moved.try_plan_under(&moved.machine, &planning));
        match planned {
            Ok(plan) => Ok(Some(TriedPlacement { judged, plan, placed })),
            Err(Failure::Cancelled) => Ok(None),
            Err(failure) => Err(failure),
        }
    }
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

struct Judging<'a> {
    task: PlacementTask<'a>,
    /// The base that is moved; none if the work is.
    base: Option<&'a MovableBase<'a>>,
    pivot: Pivot,
    deadline: Deadline<'a>,
    count: AtomicUsize,
    /// The first fault that ended a judgement.
    fault: Mutex<Option<Failure>>,
    request: &'a ReachRequest<'a>,
}

impl Judging<'_> {
    /// Judges a placement; none if the time is over.
    fn judge(&self, placement: &Placement, deadline: &Deadline) -> Result<Option<Judgement>, Failure> {
        let by = placement.affine(&self.pivot);
        let Some(base) = self.base else { return Ok(self.task.judge(by, Some(deadline))) };
        let (_, machine) = base.moved(&by)?;
        let task = PlacementTask { machine: &machine, ..self.task };
        Ok(task.judge(DAffine3::IDENTITY, Some(deadline)))
    }

    /// The fault that ended the search, if any.
    fn fault(&self) -> Option<Failure> {
        self.fault.lock().ok()?.take()
    }

    /// The same in the search: a fault is kept, and no judgement is made.
    fn judge_or_keep(&self, placement: &Placement) -> Option<Judgement> {
        match self.judge(placement, &self.deadline) {
            Ok(judgement) => judgement,
            Err(failure) => {
                if let Ok(mut fault) = self.fault.lock() {
                    fault.get_or_insert(failure);
                }
                None
            }
        }
    }

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
                let judgement = self.judge_or_keep(placement);
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use seamwright_machine::shipped;
    use seamwright_motion::reach::ReachSpan;
    use seamwright_testkit::{Random, cases};

    /// A nozzle on a shell, near enough for the arms.
    const NOZZLE: &str = include_str!("../../../tests/data/nozzle-on-arm.toml");

    const ELLIPSE: &str = include_str!("../../../examples/ellipse.toml");

    fn loaded(job: &str) -> Loaded {
        load_text("job.toml", job, Path::new(".")).unwrap()
    }

    fn grid(spans: [(f64, f64, usize); 4]) -> ReachGrid {
        ReachGrid { spans: spans.map(|(from, to, cells)| ReachSpan::new(from, to, cells).unwrap()) }
    }

    /// Judges the job of `loaded` on `machine`, with the work displaced by `by` in the work frame.
    fn judged_on(loaded: &Loaded, machine: &Machine, by: DAffine3) -> Judgement {
        let paths = loaded.paths();
        let task = PlacementTask { machine, passes: &loaded.passes(&paths), procedure: None };
        task.judge(by, None).unwrap()
    }

    fn assert_same(a: &Judgement, b: &Judgement, case: &str) {
        match (a, b) {
            (Judgement::Weldable(a), Judgement::Weldable(b)) => {
                assert!((a.range - b.range).abs() < 1e-5, "{case}: {a:?} {b:?}");
            }
            (Judgement::Fails(a), Judgement::Fails(b)) => assert_eq!(a.kind, b.kind, "{case}"),
            _ => panic!("{case}: {a:?} {b:?}"),
        }
    }

    fn random_base(random: &mut Random, max_mm: [f64; 3]) -> DAffine3 {
        let by = DVec3::from_array(max_mm.map(|max| random.within(-max, max)));
        let turn = glam::DQuat::from_rotation_z(random.within(-0.6, 0.6));
        DAffine3::from_rotation_translation(turn, by)
    }

    /// On a machine whose work frame is its base frame, a base moved by T is the work moved by the inverse of T.
    #[test]
    fn a_moved_base_is_judged_as_work_moved_the_other_way() {
        let loaded = loaded(ELLIPSE);
        let base = MovableBase::new(&loaded).unwrap();
        let mut random = Random::new(147);
        let mut weldable = [0, 0];
        for case in 0..cases(60u32) {
            let by = random_base(&mut random, [700.0, 250.0, 0.0]);
            let (_, machine) = base.moved(&by).unwrap();
            let moved = judged_on(&loaded, &machine, DAffine3::IDENTITY);
            let brute = judged_on(&loaded, &loaded.machine, by.inverse());
            assert_same(&moved, &brute, &format!("{case} {by:?}"));
            weldable[usize::from(brute.margin().is_some())] += 1;
        }
        assert!(weldable.iter().all(|count| *count > 5), "{weldable:?}");
    }

    /// Beside a positioner, and on a rail, the torch stands to the work as that of an arm whose own chain begins with T.
    #[test]
    fn a_moved_base_is_a_moved_arm() {
        let mut random = Random::new(148);
        for name in ["irb-2600-positioner", "irb-2600-rail"] {
            let loaded = loaded(&NOZZLE.replace("MACHINE", name));
            let base = MovableBase::new(&loaded).unwrap();
            let text = shipped(name).unwrap().text;
            for case in 0..cases(20u32) {
                let by = random_base(&mut random, [250.0, 250.0, 150.0]);
                let step = crate::placing::inline(&crate::work_offset::rounded(&by).unwrap());
                let arm = text.replacen("[[tool]]", &format!("[[tool]]\nfixed = {step}\n[[tool]]"), 1);
                let arm = machine_text("arm.toml", &arm, Path::new(".")).unwrap();
                let (_, machine) = base.moved(&by).unwrap();
                let mut q = machine.home();
                for (i, axis) in machine.axes.iter().enumerate() {
                    let (low, high) = axis.range.unwrap();
                    q[i] = random.within(low, high);
                }
                let [a, b] = [&machine, &arm].map(|machine| machine.forward(&q));
                assert!(a.point.distance(b.point) < 1e-5, "{name} {case}: {a:?} {b:?}");
                assert!(a.direction.distance(b.direction) < 1e-8, "{name} {case}: {a:?} {b:?}");
            }
        }
    }

    /// The search finds the best cell of its grid, and its text is the machine of that cell.
    #[test]
    fn the_best_base_of_the_grid_is_found() {
        let loaded = loaded(ELLIPSE);
        let grid = grid([(-400.0, 500.0, 4), (-100.0, 150.0, 3), (0.0, 0.0, 1), (0.0, 0.0, 1)]);
        let brute = (0..12).map(|k| {
            let by = grid.placement([k % 4, k / 4, 0, 0]).affine(&Pivot { point: DVec3::ZERO, up: DVec3::Z });
            judged_on(&loaded, &loaded.machine, by.inverse()).score()
        });
        let brute = brute.fold(f64::MIN, f64::max);
        let budget = Duration::from_secs(300);
        let request = ReachRequest { moved: Moved::Base, grid, budget, cancel: None, progress: None };
        let reached = reach(&loaded, JobText { text: ELLIPSE, folder: Path::new(".") }, &request).unwrap();
        let cells = reached.search.judged.iter().filter(|judged| judged.cell.is_some());
        let found = cells.map(|judged| judged.judgement.score()).fold(f64::MIN, f64::max);
        assert!((found - brute).abs() < 1e-5, "{found} {brute}");
        // The local search goes on from there.
        let best = reached.best().unwrap();
        assert!(best.judged.judgement.score() >= brute - 1e-5, "{} {brute}", best.judged.judgement.score());
        let machine = machine_text("m.toml", &best.placed.text, Path::new(".")).unwrap();
        let score = judged_on(&loaded, &machine, DAffine3::IDENTITY).score();
        assert!((score - best.judged.judgement.score()).abs() < 1e-5);
        assert_eq!((best.placed.key.as_str(), reached.cut_off), ("work[0].fixed", None));
    }

    /// A cancelled search plans the best placement so far.
    #[test]
    fn a_cancelled_search_has_the_best_placement_so_far() {
        let loaded = loaded(ELLIPSE);
        let grid = grid([(-300.0, 300.0, 100), (-100.0, 100.0, 100), (0.0, 0.0, 1), (0.0, 0.0, 1)]);
        let cancel = AtomicBool::new(false);
        let stop = |judged: usize| cancel.store(judged >= 30, Ordering::Relaxed);
        let (budget, job) = (Duration::from_secs(600), JobText { text: ELLIPSE, folder: Path::new(".") });
        let request = ReachRequest { moved: Moved::Work, grid, budget, cancel: Some(&cancel), progress: Some(&stop) };
        let reached = reach(&loaded, job, &request).unwrap();
        assert_eq!(reached.cut_off, Some(CutOff::Cancelled));
        let judged = reached.search.judged.len();
        assert!((30..300).contains(&judged), "{judged}");
        let best = reached.best().unwrap().judged.judgement.score();
        let most = reached.search.judged.iter().map(|judged| judged.judgement.score()).fold(f64::MIN, f64::max);
        assert!(best >= most - 2.0 * SAME_SCORE, "{best} {most}");
    }
}
