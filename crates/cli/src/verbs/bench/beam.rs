//! Beam mode on a simulated half-ring.

use seamwright_machine::{Machine, shipped};
use seamwright_message::Message;
use seamwright_motion::PassMotion;
use seamwright_program::TorchPath as _;
use seamwright_project::failure::Failure;
use seamwright_simulation::acceptance::Gate;
use seamwright_simulation::tracking::beam::{BeamJob, MOVED_MM, beam_rows, moved_since};
use seamwright_teaching::{SeamLine, Station};
use seamwright_weld::Welding;

const JOB: &str = include_str!("../../../../../examples/half-ring.toml");
/// Start of the later pass.
const LATER: [&str; 2] = ["phi_deg = 30\n", "phi_deg = 42\n"];

/// Rows of beam mode: from pixels once, and from points with this many seeds.
pub(super) fn rows(seeds: u64) -> Result<Vec<Gate>, Failure> {
    let weldings =
        [Welding::read("half-ring.toml", JOB)?, Welding::read("half-ring.toml", &JOB.replace(LATER[0], LATER[1]))?];
    let first = &weldings[0];
    let name = &first.program.value.machine;
    let text = shipped(name)
        .ok_or_else(|| Failure::environment(Message::new("cli-bench-not-shipped").text("machine", name)))?
        .text;
    let machine = Machine::read(name, text)?;
    let paths = weldings.each_ref().map(|welding| welding.path(0));
    let [a, b] = [0, 1].map(|i: usize| PassMotion::plan(&machine, &paths[i], &weldings[i].program.value.passes[0], 1));
    let planned = |motion: Result<PassMotion, Vec<_>>| {
        motion.map_err(|_| Failure::environment(Message::new("cli-bench-half-ring")))
    };
    let (a, b) = (planned(a)?, planned(b)?);
    let seam = first.seam.as_ref();
    let seam = seam.ok_or_else(|| Failure::environment(Message::new("cli-bench-half-ring")))?;
    let place = first.program.value.seam_in_work();
    let nominal = SeamLine::sampled(paths[0].length(), false, |s| {
        let p = seam.at(s);
        Station { point: place.transform_point3(p.point), normal: place.transform_vector3(p.bisector) }
    });
    let job = BeamJob {
        machine: &machine,
        nominal: &nominal,
        first: (&paths[0], &a),
        later: (&paths[1], &b),
        speed_mm_s: 10.0,
    };
    let mut rows = beam_rows("half-ring", &job, seeds)?;
    let found = moved_since(&job, 1)?;
    let frames = format!("half-ring, moved by {MOVED_MM} mm before the later pass, which is refused");
    rows.push(Gate::at_most(&frames, "told wrong by", (found - MOVED_MM).abs(), 0.05, "mm"));
    Ok(rows)
}
