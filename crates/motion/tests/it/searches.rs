//! Searches end: their number of trials is bounded, and a watch can stop them.

use crate::inner;
use crate::planning::{machine_of, plan_weld_under, read, read_machine};
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_document::Finite;
use seamwright_geometry::Pose;
use seamwright_geometry::numeric::bisect;
use seamwright_machine::{Clamped, Machine};
use seamwright_message::Argument;
use seamwright_motion::redundancy::holding;
use seamwright_motion::{PassMotion, SearchProgress, SearchStage, Stop, Terms, Watch, WeldMotion};
use seamwright_program::{Finding, TorchPath};
use std::cell::{Cell, RefCell};
use std::f64::consts::{PI, TAU};

const ARM_JOB: &str = include_str!("../../../../tests/data/field-trial/u3.toml");
const ARM: &str = include_str!("../../../../tests/data/field-trial/ur10e_near.toml");
const TABLE_JOB: &str = include_str!("../../../../tests/data/field-trial/u1.toml");
const ARM_AND_TABLE: &str = include_str!("../../../../tests/data/field-trial/ur10e-pos.toml");
/// The table is held level.
const LEVEL_JOB: &str = include_str!("../../../../tests/data/field-trial/u1h.toml");
const OTHER_JOB: &str = include_str!("../../../../tests/data/field-trial/i1.toml");
const OTHER_ARM: &str = include_str!("../../../../tests/data/field-trial/irb.toml");

/// Stops after a number of units of work, and stores the progress seen.
struct Counts {
    most: u64,
    last: Cell<SearchProgress>,
}

impl Watch for Counts {
    fn look(&self, progress: &SearchProgress) -> Result<(), Stop> {
        assert!((0.0..=1.0).contains(&progress.part), "{progress:?}");
        assert!(progress.work >= self.last.get().work && progress.passes == 1);
        self.last.set(*progress);
        if progress.work > self.most { Err(Stop::Cancelled) } else { Ok(()) }
    }
}

fn plan(job: &str, machine: &str, most: u64) -> (Result<WeldMotion, Vec<Finding>>, Machine) {
    let machine = read_machine(machine);
    let counts = Counts { most, last: Cell::default() };
    let terms = Terms { watch: Some(&counts), ..Terms::default() };
    let planned = plan_weld_under(&machine, &read(job), &Clamped::default(), terms);
    (planned, machine)
}

/// Work that takes seconds, at some 20 microseconds a unit.
const BOUND: u64 = 400_000;

/// In closed form with the rotation about the torch as a free axis; by Newton's method a pass took hundreds of millions
/// of starts.
#[test]
fn the_search_for_an_arm_ends_after_a_bounded_number_of_trials() {
    for (name, job, machine) in [
        ("arm", ARM_JOB, ARM),
        ("arm and table", TABLE_JOB, ARM_AND_TABLE),
        ("arm and level table", LEVEL_JOB, ARM_AND_TABLE),
        ("other arm", OTHER_JOB, OTHER_ARM),
    ] {
        let (planned, machine) = plan(job, machine, BOUND);
        let motion = planned.unwrap_or_else(|f| panic!("{name}: {f:#?}"));
        let welding = read(job);
        let (path, wanted) = (&motion.passes[0].path, welding.path(0));
        for i in 0..=500 {
            let s = path.length() * f64::from(i) / 500.0;
            let (q, pose) = (path.at(s), wanted.pose(s));
            assert!(machine.outside(&q).is_none(), "{name} at {s}");
            let tip = machine.forward(&q);
            assert!((tip.point - pose.point).length() < 1e-6, "{name} at {s}");
            assert!((tip.direction - pose.direction).length() < 1e-6, "{name} at {s}");
        }
    }
}

#[test]
fn a_search_that_is_stopped_says_how_far_it_came() {
    for most in [0, 1_000, 20_000] {
        let (planned, _) = plan(ARM_JOB, ARM, most);
        let findings = planned.unwrap_err();
        assert!(findings.len() == 1 && findings[0].kind == "search" && !findings[0].allowed, "{findings:#?}");
        assert_eq!(findings[0].message.code, "motion-search-cancelled");
        assert!(inner(&findings[0].message, "progress").argument("positions").is_some(), "{}", findings[0].message);
    }
}

/// Stops where `part` of `stage` is done, after it has begun for the `time`-th time.
struct StopsIn {
    stage: SearchStage,
    time: usize,
    part: f64,
    seen: RefCell<Vec<SearchProgress>>,
}

impl StopsIn {
    fn new(stage: SearchStage, time: usize, part: f64) -> Self {
        Self { stage, time, part, seen: RefCell::default() }
    }

    fn begun(&self) -> usize {
        self.seen.borrow().iter().filter(|seen| seen.stage == self.stage && seen.begins).count()
    }
}

impl Watch for StopsIn {
    fn look(&self, progress: &SearchProgress) -> Result<(), Stop> {
        self.seen.borrow_mut().push(*progress);
        let is_there = progress.stage == self.stage && self.begun() >= self.time && progress.part >= self.part;
        if is_there { Err(Stop::OutOfTime(5.0)) } else { Ok(()) }
    }
}

fn plan_on_shipped(job: &str, fixtures: Vec<Solid>, watch: &StopsIn) -> Result<WeldMotion, Vec<Finding>> {
    let welding = read(job);
    let clamped = Clamped { fixtures, least_mm: 2.0, ..Clamped::default() };
    plan_weld_under(&machine_of(&welding), &welding, &clamped, Terms { watch: Some(watch), ..Terms::default() })
}

/// A ball on the torch's axis, where no torch angle clears it.
fn ball_on_torch(job: &str, back_mm: f64) -> Vec<Solid> {
    let welding = read(job);
    let pose = welding.path(0).pose(0.4 * welding.path(0).length());
    let at = DAffine3::from_translation(pose.point - back_mm * pose.direction);
    vec![Solid::new("clamp", Shape::Sphere { radius: 40.0 }, at).unwrap()]
}

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");
const HEAD_NOZZLE: &str = include_str!("../../../../examples/head-nozzle.toml");
const OBLIQUE_GIRTH: &str = include_str!("../../../../examples/oblique-girth.toml");
const CIRCLE: &str = include_str!("../../../../tests/data/field-trial/circle-80deg.toml");
const FAST_WEAVE: &str = include_str!("../../../../tests/data/field-trial/saddle-weave-8hz.toml");

#[test]
fn cures_that_are_cut_off_say_how_many_changes_were_tried() {
    let wide = SADDLE.replace("radius_mm = 250 ", "radius_mm = 700 ").replace("radius_mm = 800 ", "radius_mm = 2500 ");
    let ranges = |part: f64| {
        let found = plan_on_shipped(&wide, Vec::new(), &StopsIn::new(SearchStage::Cure, 1, part)).unwrap_err();
        found.into_iter().find(|f| f.kind == "range").unwrap().cure.unwrap()
    };
    assert_eq!(ranges(0.0).code, "motion-cure-range-no-time");
    assert_eq!(ranges(0.5).code, "motion-cure-range-stopped");

    let clearance = |part: f64| {
        let watch = StopsIn::new(SearchStage::Cure, 1, part);
        let found = plan_on_shipped(HEAD_NOZZLE, ball_on_torch(HEAD_NOZZLE, 100.0), &watch).unwrap_err();
        found.into_iter().find(|f| f.kind == "clearance").unwrap().cure.unwrap()
    };
    let some = clearance(0.4);
    assert_eq!(some.code, "motion-cure-clearance-stopped");
    let counts = ["tried", "angles"].map(|name| some.argument(name).cloned());
    assert_eq!(counts, [3, 6].map(|count| Some(Argument::Count(count))));
    assert_eq!(clearance(2.0).code, "motion-cure-clearance-none");
}

/// A change that cures the ranges may cause other findings.
#[test]
fn a_cure_is_planned_as_a_whole_before_it_is_offered() {
    let watch = StopsIn::new(SearchStage::Cure, usize::MAX, 0.0);
    let found = plan_on_shipped(CIRCLE, Vec::new(), &watch).unwrap_err();
    let cure = found[0].cure.as_ref().unwrap();
    assert!(["motion-cure-range-weld", "motion-cure-range-pass"].contains(&&*cure.code), "{found:#?}");
    let seen = watch.seen.borrow();
    let trials = seen.iter().skip_while(|seen| seen.stage != SearchStage::Cure);
    assert!(trials.filter(|seen| seen.stage == SearchStage::Speed && seen.begins).count() > 0);
}

#[test]
fn a_search_for_a_clear_way_that_is_cut_off_is_a_finding() {
    let free = StopsIn::new(SearchStage::Sampling, usize::MAX, 0.0);
    plan_on_shipped(OBLIQUE_GIRTH, Vec::new(), &free).unwrap();
    let watch = StopsIn::new(SearchStage::Sampling, free.begun() + 1, 0.0);
    let found = plan_on_shipped(OBLIQUE_GIRTH, ball_on_torch(OBLIQUE_GIRTH, 300.0), &watch).unwrap_err();
    assert!(found.iter().any(|f| f.kind == "clearance"), "{found:#?}");
    assert!(found.iter().any(|f| f.kind == "search" && !f.allowed), "{found:#?}");
}

#[test]
fn the_search_for_a_weave_shows_progress_and_is_stopped() {
    let all = StopsIn::new(SearchStage::Weave, usize::MAX, 0.0);
    let found = plan_on_shipped(FAST_WEAVE, Vec::new(), &all).unwrap_err();
    assert!(found.iter().any(|f| f.message.code == "motion-weave-frequency"), "{found:#?}");
    let seen = all.seen.borrow();
    let parts: Vec<f64> = seen.iter().filter(|seen| seen.stage == SearchStage::Weave).map(|seen| seen.part).collect();
    assert!(parts.len() > 50 && parts.windows(2).all(|w| w[0] <= w[1]) && parts[parts.len() - 1] > 0.3, "{parts:?}");
    let found = plan_on_shipped(FAST_WEAVE, Vec::new(), &StopsIn::new(SearchStage::Weave, 1, 0.2)).unwrap_err();
    assert!(found.len() == 1 && found[0].kind == "search", "{found:#?}");
}

/// A level circle about `centre`, its point farthest along x at `far` of its length; the torch points down.
struct Circle {
    centre: DVec3,
    far: f64,
}

impl Circle {
    const RADIUS_MM: f64 = 100.0;
}

impl TorchPath for Circle {
    fn length(&self) -> f64 {
        TAU * Self::RADIUS_MM
    }

    fn pose(&self, s: f64) -> Pose {
        let angle = s / Self::RADIUS_MM - TAU * self.far;
        let beside = DVec3::new(angle.cos(), angle.sin(), 0.0);
        Pose { point: self.centre + Self::RADIUS_MM * beside, direction: DVec3::NEG_Z }
    }
}

/// A part of the seam shorter than the distance of two searches along it: 14 of 1440 samples.
#[test]
fn a_hundredth_of_a_seam_out_of_an_arm_s_reach_is_found() {
    let mut pass = read(ARM_JOB).program.value.passes[0].clone();
    pass.spare_axes.hold.insert("j6".to_owned(), Finite::new(0.0).unwrap());
    let machine = read_machine(ARM);
    let held = holding(&machine, &pass.spare_axes).unwrap();
    let mut near = held.home();
    near[held.axis("j6").unwrap()] = 0.0;
    let circle = |x: f64| Circle { centre: DVec3::new(x, 0.0, 100.0), far: 732.0 / 1440.0 };
    let reaches = |x: f64| held.inverse(circle(x).pose(PI * Circle::RADIUS_MM * 2.0 * 732.0 / 1440.0), &near).is_ok();
    assert!(reaches(0.0) && !reaches(1500.0));
    let (low, _) = bisect(0.0, 1500.0, 40, reaches);
    let found = PassMotion::plan(&machine, &circle(low + 0.05), &pass, 1).unwrap_err();
    let reach: Vec<&Finding> = found.iter().filter(|f| f.kind == "reach").collect();
    assert!(reach.len() == 1 && reach[0].to_mm - reach[0].from_mm < 10.0, "{found:#?}");
    assert!((reach[0].from_mm..reach[0].to_mm).contains(&(TAU * Circle::RADIUS_MM * 732.0 / 1440.0)), "{found:#?}");
}
