//! Findings for axes beyond their ranges, and the effect of their cures.

use crate::planning::{machine_of, plan, plan_weld, read, read_machine, several_passes, shipped_machine};
use crate::{inner, number};
use glam::DVec3;
use seamwright_machine::{Clamped, Surroundings};
use seamwright_message::Message;
use seamwright_motion::WeldMotion;
use seamwright_program::{Finding, Pass, Program, TorchPath};
use seamwright_weld::Welding;

const CIRCLE: &str = include_str!("../../../../tests/data/field-trial/circle-80deg.toml");
const ROLLS: &str = include_str!("../../../../tests/data/field-trial/cb.toml");
const SCARA: &str = include_str!("../../../../tests/data/field-trial/scara.toml");
const SADDLE: &str = include_str!("../../../../examples/saddle.toml");

fn planned(job: &str) -> Result<(), Vec<Finding>> {
    let welding = read(job);
    plan(&machine_of(&welding), &welding).map(|_| ())
}

/// The finding describes the branch that exceeds its range by a tenth of a degree at four stations, not the one that
/// exceeds it by half a turn everywhere.
#[test]
fn a_range_finding_is_that_of_the_branch_that_lacks_least() {
    let found = planned(CIRCLE).unwrap_err();
    assert_eq!(found.len(), 4);
    assert!(
        found.iter().all(|f| f.kind == "range" && f.message.to_string().contains("0.100° beyond its limit")),
        "{found:#?}"
    );
    assert!(found.iter().map(|f| f.to_mm - f.from_mm).sum::<f64>() < 100.0);
}

fn code(cure: &Option<Message>) -> &str {
    cure.as_ref().map_or("", |cure| &cure.code)
}

fn cured(job: &str, cure: &Message) -> String {
    let mut table = read(job);
    let program: &mut Program = &mut table.program.value;
    let change = inner(cure, "change");
    if change.code == "motion-change-move" {
        let placement = &mut program.placement;
        let moved = placement.move_mm.get() + DVec3::from_array(["x", "y", "z"].map(|axis| number(change, axis)));
        placement.move_mm = seamwright_document::Point::new(moved).unwrap();
    } else {
        assert_eq!(change.code, "motion-change-work-angle");
        let torch = &mut program.passes[0].torch;
        let angle = torch.work_angle_deg.get() + number(change, "by");
        torch.work_angle_deg = seamwright_document::Finite::new(angle).unwrap();
    }
    program.to_toml().unwrap()
}

#[test]
fn a_cure_that_is_offered_cures() {
    let found = planned(CIRCLE).unwrap_err();
    let job = cured(CIRCLE, found[0].cure.as_ref().unwrap());
    planned(&job).unwrap_or_else(|f| panic!("{}: {f:#?}", found[0].cure_text()));
    // A line beyond one end of a slide.
    let line = "schema = 1\ntitle = \"t\"\nmachine = \"torch-5axis\"\n[seam.line]\nstart_mm = [700, 0, 100]\n\
                end_mm = [850, 0, 100]\nfirst_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[part]\nwatched = false\n\
                [weld]\nspeed_mm_s = 5\n";
    let found = planned(line).unwrap_err();
    assert!(found.iter().any(|f| f.kind == "range" && f.message.to_string().contains("axis x")), "{found:#?}");
    let job = cured(line, found[0].cure.as_ref().unwrap());
    planned(&job).unwrap_or_else(|f| panic!("{}: {f:#?}", found[0].cure_text()));
}

#[test]
fn no_cure_is_offered_where_none_helps() {
    let wide = SADDLE.replace("radius_mm = 250 ", "radius_mm = 700 ").replace("radius_mm = 800 ", "radius_mm = 2500 ");
    assert_ne!(wide, SADDLE);
    let found = planned(&wide).unwrap_err();
    let range: Vec<_> = found.iter().filter(|f| f.kind == "range").collect();
    assert!(
        !range.is_empty() && range.iter().all(|f| code(&f.cure).starts_with("motion-cure-range-none")),
        "{found:#?}"
    );
}

/// Passes continue turning within the range: forty thousand degrees are a hundred turns.
#[test]
fn nothing_unwinds_while_the_range_has_room() {
    let job = "schema = 1\ntitle = \"t\"\nmachine = \"cb.toml\"\n[seam.girth]\nradius_mm = 600\ndirection = [1, 0, 0]\n\
               [part]\nwatched = false\n[start]\noverlap_mm = 40\n[weld]\nspeed_mm_s = 7\n";
    let welding = several_passes(job, 14);
    let machine = read_machine(ROLLS);
    let motion = plan_weld(&machine, &welding, &Clamped::default()).unwrap_or_else(|f| panic!("{f:#?}"));
    let r = machine.axis("r").unwrap();
    for pair in motion.passes.windows(2) {
        let (end, start) = (pair[0].path.at(pair[0].path.length())[r], pair[1].path.at(0.0)[r]);
        assert!((end - start).abs() < std::f64::consts::PI + 1e-9, "{end} {start}");
    }
    let last = motion.passes.last().unwrap();
    assert!(last.path.at(last.path.length())[r].abs() > 13.0 * std::f64::consts::TAU);
    assert!(motion.findings.iter().all(|f| f.kind != "unwind"), "{:#?}", motion.findings);
}

/// A line on the slide X of `torch-5axis`, which ends at 800 mm to both sides.
fn line(from: f64, to: f64) -> Welding {
    let job = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"torch-5axis\"\n[seam.line]\nstart_mm = [{from}, 0, 100]\n\
         end_mm = [{to}, 0, 100]\nfirst_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[part]\nwatched = false\n\
         [weld]\nspeed_mm_s = 5\n"
    );
    read(&job)
}

fn cure_of_first(weld: &[Welding]) -> Message {
    let machine = shipped_machine("torch-5axis");
    let clamped = Clamped::default();
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let paths: Vec<_> = weld.iter().map(|welding| welding.path(0)).collect();
    let passes: Vec<(&dyn TorchPath, &Pass)> =
        paths.iter().zip(weld).map(|(path, w)| (path as &dyn TorchPath, &w.program.value.passes[0])).collect();
    let found = WeldMotion::plan(&machine, &around, &passes, 30.0).unwrap_err();
    found.into_iter().find(|f| f.kind == "range" && f.pass == 1).unwrap().cure.unwrap()
}

#[test]
fn no_cure_of_one_pass_takes_another_out_of_its_range() {
    let alone = cure_of_first(&[line(700.0, 850.0)]);
    let moves = |cure: &Message| (-51.0..=-50.0).contains(&number(inner(cure, "change"), "x"));
    assert!(alone.code == "motion-cure-range-weld" && moves(&alone), "{alone}");
    let both = cure_of_first(&[line(700.0, 850.0), line(-100.0, 100.0)]);
    assert_eq!(both, alone);
    let opposed = cure_of_first(&[line(700.0, 850.0), line(-790.0, -700.0)]);
    assert!(opposed.code.starts_with("motion-cure-range-none"), "{opposed}");
    // Another pass with the same excess before and after leaves the cure valid for this pass alone.
    let outside = cure_of_first(&[line(700.0, 850.0), line(-990.0, -900.0)]);
    assert!(outside.code == "motion-cure-range-pass" && moves(&outside), "{outside}");
    // Without a known weld the cure covers this pass only.
    let machine = shipped_machine("torch-5axis");
    let single = line(700.0, 850.0);
    let found = plan(&machine, &single).unwrap_err();
    assert_eq!(code(&found[0].cure), "motion-cure-range-pass");
}

#[test]
fn a_reason_names_only_changes_that_were_tried() {
    // A rotary axis exceeds its range by more than work angles of 20 degrees can cure; no shift of the work is tried.
    let steep = CIRCLE.replace("work_angle_deg = -35.1", "work_angle_deg = -70").replace("0, 0, 200", "0, 0, 500");
    let found = planned(&steep).unwrap_err();
    let range = found.iter().find(|f| f.kind == "range").unwrap_or_else(|| panic!("{found:#?}"));
    assert_eq!(code(&range.cure), "motion-cure-range-none-angle");
    // Out of reach: no shift of the work can be derived.
    let far = read(
        "schema = 1\ntitle = \"t\"\nmachine = \"scara.toml\"\n[seam.line]\nstart_mm = [800, -20, 0]\n\
         end_mm = [800, 20, 0]\nfirst_normal = [1, 0, 1]\nsecond_normal = [-1, 0, 1]\n[part]\nwatched = false\n\
         [weld]\nspeed_mm_s = 5\n",
    );
    let machine = read_machine(SCARA);
    let found = plan(&machine, &far).unwrap_err();
    assert_eq!((found[0].kind.as_ref(), code(&found[0].cure)), ("reach", "motion-cure-range-none-angle"));
}

#[test]
fn a_cure_names_the_key_that_the_pass_has() {
    let [first, second] = [0, 600].map(|s| format!("[[torch.at]]\ns_mm = {s}\nwork_angle_deg = -35.1\n"));
    let job = CIRCLE.replace("[torch]\nwork_angle_deg = -35.1\n", &(first + &second));
    let cure = planned(&job).unwrap_err()[0].cure.clone().unwrap();
    let change = inner(&cure, "change");
    assert_eq!(change.code, "motion-change-work-angles");
    let by = number(change, "by");
    planned(&job.replace("-35.1", &format!("{}", by - 35.1))).unwrap_or_else(|f| panic!("{cure}: {f:#?}"));
}
