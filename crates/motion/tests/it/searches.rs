//! Searches end: how much they try is bounded, and who watches them can stop them.

use seamwright_machine::{Clamped, Machine, Surroundings};
use seamwright_motion::{SearchProgress, Stop, Terms, Watch, WeldMotion};
use seamwright_program::{Finding, Pass, TorchPath};
use seamwright_weld::Welding;
use std::cell::Cell;

const ARM_JOB: &str = include_str!("../../../../tests/data/field-trial/u3.toml");
const ARM: &str = include_str!("../../../../tests/data/field-trial/ur10e_near.toml");
const TABLE_JOB: &str = include_str!("../../../../tests/data/field-trial/u1.toml");
const ARM_AND_TABLE: &str = include_str!("../../../../tests/data/field-trial/ur10e-pos.toml");
/// With the table level by wish.
const LEVEL_JOB: &str = include_str!("../../../../tests/data/field-trial/u1h.toml");
const OTHER_JOB: &str = include_str!("../../../../tests/data/field-trial/i1.toml");
const OTHER_ARM: &str = include_str!("../../../../tests/data/field-trial/irb.toml");

/// Stops after so many units of work, and keeps what it saw.
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

fn plan(job: &str, machine: &str, most: u64) -> (Result<WeldMotion, Vec<Finding>>, Machine, u64) {
    let (welding, machine) = (Welding::read("job.toml", job).unwrap(), Machine::read("m.toml", machine).unwrap());
    let clamped = Clamped::default();
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let path = welding.path(0);
    let passes: [(&dyn TorchPath, &Pass); 1] = [(&path, &welding.program.value.passes[0])];
    let counts = Counts { most, last: Cell::default() };
    let planned =
        WeldMotion::plan_under(&machine, &around, &passes, 30.0, Terms { procedure: None, watch: Some(&counts) });
    let work = counts.last.get().work;
    drop(around);
    (planned, machine, work)
}

/// Work that takes well below a minute, at some 20 microseconds a unit.
const BOUND: u64 = 2_000_000;

/// Arms have no closed form here: before, a pass took hundreds of millions of starts of Newton's method.
#[test]
fn the_search_for_an_arm_ends_after_a_bounded_number_of_trials() {
    for (name, job, machine) in [
        ("arm", ARM_JOB, ARM),
        ("arm and table", TABLE_JOB, ARM_AND_TABLE),
        ("arm and level table", LEVEL_JOB, ARM_AND_TABLE),
        ("other arm", OTHER_JOB, OTHER_ARM),
    ] {
        let (planned, machine, work) = plan(job, machine, BOUND);
        let motion = planned.unwrap_or_else(|f| panic!("{name}: {f:#?}"));
        println!("{name}: {work} units, {:.1} s from home to home", motion.total_s());
        let welding = Welding::read("job.toml", job).unwrap();
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
        let (planned, _, _) = plan(ARM_JOB, ARM, most);
        let findings = planned.unwrap_err();
        assert!(findings.len() == 1 && findings[0].kind == "search" && !findings[0].allowed, "{findings:#?}");
        assert!(findings[0].message.contains("tried positions"), "{}", findings[0].message);
    }
}
