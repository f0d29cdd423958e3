//! Welding positions that a procedure allows take precedence over preferred ones.

use crate::planning::{read, read_machine, shipped_machine};
use seamwright_machine::{Clamped, Machine, Surroundings};
use seamwright_motion::{Terms, WeldMotion};
use seamwright_program::{Finding, Pass, Procedure, TorchPath};

const GANTRY: &str = include_str!("../../../../tests/data/field-trial/gantry8.toml");
const NOZZLE: &str = include_str!("../../../../tests/data/field-trial/g8.toml");
/// A girth seam round a standing tube, whose face is level with the table level.
const GIRTH: &str = "schema = 1\ntitle = \"t\"\nmachine = \"ebw-7axis\"\n[placement]\nmove_mm = [0, 0, 160]\n\
    [seam.girth]\nradius_mm = 200\ndirection = [0, 0, 1]\n[part]\nwatched = false\n[start]\nphi_deg = 30\n\
    overlap_mm = 60\n[weld]\nspeed_mm_s = 15\n";

/// Findings against the plan of a job under a procedure that allows these positions.
fn findings(job: &str, machine: &Machine, process: u32, positions: &str) -> Vec<Finding> {
    let text = format!(
        "schema = 1\nnumber = \"W\"\ntitle = \"t\"\nprocess = {process}\n[[runs]]\npasses = \"1\"\npositions = {positions}\n"
    );
    let procedure = Procedure::read("wps.toml", &text).unwrap_or_else(|e| panic!("{e}")).value;
    let welding = read(job);
    let clamped = Clamped::default();
    let around = Surroundings::new(machine, &clamped).unwrap();
    let path = welding.path(0);
    let passes: [(&dyn TorchPath, &Pass); 1] = [(&path, &welding.program.value.passes[0])];
    let terms = Terms { procedure: Some(&procedure), ..Terms::default() };
    let mut motion =
        WeldMotion::plan_under(machine, &around, &passes, 30.0, terms).unwrap_or_else(|f| panic!("{f:#?}"));
    motion.hold_to(&procedure, machine, &passes);
    motion.findings.into_iter().filter(|f| !f.allowed).collect()
}

#[test]
fn allowed_positions_come_before_a_flat_face() {
    let gantry = read_machine(GANTRY);
    let found = findings(NOZZLE, &gantry, 135, "[\"PA\", \"PB\"]");
    assert!(found.is_empty(), "{found:#?}");
    let ebw = shipped_machine("ebw-7axis");
    for (position, allowed) in [("any", "[\"PA\", \"PC\"]"), ("flat", "[\"PC\"]"), ("any", "[\"PA\"]")] {
        let job = format!("{GIRTH}[spare_axes]\nposition = \"{position}\"\n");
        let found = findings(&job, &ebw, 51, allowed);
        assert!(found.is_empty(), "{position}, {allowed}: {found:#?}");
    }
}
