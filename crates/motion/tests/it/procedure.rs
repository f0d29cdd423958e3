//! Planned passes under a procedure: heat input against the energy of the set-points, windows against closed forms and
//! dense sampling, positions against a frame built from the machine's poses.

use crate::planning::{read, read_machine};
use glam::{DMat3, DVec3};
use seamwright_machine::{Joints, Machine, Surroundings, shipped};
use seamwright_motion::procedure::{PassProcedure, PlannedPass, Quantity};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{ArcTime, Finding, Inclination, Procedure, TorchPath, WeldingPosition};
use seamwright_weld::Welding;

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");
const HEAD: &str = "schema = 1\nnumber = \"W 1\"\ntitle = \"t\"\nprocess = 135\n[[runs]]\n";

/// The saddle with these changes on its machine.
struct Held {
    welding: Welding,
    machine: Machine,
    motion: PassMotion,
    held: PassProcedure,
}

fn hold(changes: &[(&str, &str)], machine: &Machine, procedure: &str) -> Held {
    let mut text = SADDLE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    hold_job(&text, machine, procedure)
}

fn hold_job(text: &str, machine: &Machine, procedure: &str) -> Held {
    let welding = read(text);
    let procedure = Procedure::read("w.toml", &format!("{HEAD}{procedure}")).unwrap_or_else(|e| panic!("{e}")).value;
    let path = welding.path(0);
    let pass = &welding.program.value.passes[0];
    let motion = PassMotion::plan(machine, &path, pass, 1).unwrap_or_else(|f| panic!("{f:?}"));
    let planned = PlannedPass { machine, path: &path, pass, number: 1, motion: &motion };
    let held = PassProcedure::new(&procedure, planned);
    drop(path);
    Held { motion, held, machine: machine.clone(), welding }
}

fn saddle_welder(more: &str) -> Machine {
    let text = shipped("saddle-4axis").unwrap().text.replacen("schema = 1", &format!("schema = 1\n{more}"), 1);
    read_machine(&text)
}

fn quantity<'a>(held: &'a Held, key: &str) -> &'a Quantity {
    held.held.quantities.iter().find(|q| q.key == key).unwrap_or_else(|| panic!("{key}"))
}

fn findings(held: &Held) -> Vec<&Finding> {
    assert!(held.held.findings.iter().all(|f| f.kind == "procedure" && !f.allowed && f.pass == 1));
    held.held.findings.iter().collect()
}

const RAMPS: [(&str, &str); 2] = [
    ("current_a = 240", "current_a = { from = 200, to = 290 }"),
    ("voltage_v = 27", "voltage_v = { from = 30, to = 20 }"),
];

#[test]
fn heat_input_adds_up_to_the_energy_of_the_set_points() {
    let held = hold(&RAMPS, &saddle_welder(""), "passes = \"1\"\n");
    let pass = &held.welding.program.value.passes[0];
    let curve = &held.held.heat_input;
    let (from, to) = (curve[0].0, curve[curve.len() - 1].0);
    let area: f64 = curve.windows(2).map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0)).sum();
    // In time, from the speed profile alone.
    let profile = &held.motion.profile;
    let (start, end) = (profile.time(from), profile.time(to));
    let n = 200_000;
    let dt = (end - start) / f64::from(n);
    let mut cursor = 0;
    let energy: f64 = (0..n)
        .map(|i| {
            let s = profile.at(start + (f64::from(i) + 0.5) * dt, &mut cursor).s;
            let value = |name: &str| pass.process_at(name, s, ArcTime::TRAVEL).unwrap();
            0.8 * value("current_a") * value("voltage_v") * dt / 1000.0
        })
        .sum();
    assert!((area / energy - 1.0).abs() < 1e-6, "{area} kJ, {energy} kJ");
    let (least, greatest) = quantity(&held, "heat_input_kj_mm").found.unwrap();
    assert!(greatest - least > 0.02 && curve.iter().all(|p| p.1 >= least && p.1 <= greatest));
}

#[test]
fn windows_on_ramps_end_where_the_ramps_cross_them() {
    let window =
        "passes = \"1\"\nheat_input_kj_mm = [0.48, 0.49]\nranges = { current_a = [220, 260], voltage_v = [20, 28] }\n";
    let held = hold(&RAMPS, &saddle_welder(""), window);
    let length = held.motion.path.length();
    let stretches =
        |key: &str| -> Vec<(f64, f64)> { quantity(&held, key).outside.iter().map(|o| (o.from_mm, o.to_mm)).collect() };
    let near = |found: Vec<(f64, f64)>, wanted: &[(f64, f64)]| {
        assert_eq!(found.len(), wanted.len(), "{found:?} {wanted:?}");
        for (f, w) in found.iter().zip(wanted) {
            assert!((f.0 - w.0).abs() < 1e-7 && (f.1 - w.1).abs() < 1e-7, "{f:?} {w:?}");
        }
    };
    near(stretches("current_a"), &[(0.0, 20.0 / 90.0 * length), (60.0 / 90.0 * length, length)]);
    near(stretches("voltage_v"), &[(0.0, 0.2 * length)]);
    // 0.8 (200 + 90 x)(30 - 10 x) / 10 mm/s / 1000, where it is steady: the roots of a quadratic.
    let root = |heat: f64| {
        let c = 6000.0 - heat * 10.0 * 1000.0 / 0.8;
        let d = (700.0f64.powi(2) + 4.0 * 900.0 * c).sqrt();
        [(700.0 - d) / 1800.0 * length, (700.0 + d) / 1800.0 * length]
    };
    let heat = &quantity(&held, "heat_input_kj_mm").outside;
    let places: Vec<f64> = heat.iter().flat_map(|o| [o.from_mm, o.to_mm]).collect();
    for s in [root(0.48), root(0.49)].into_iter().flatten().filter(|s| *s > 1.0 && *s < length - 1.0) {
        assert!(places.iter().any(|p| (p - s).abs() < 1e-4), "{s} {places:?}");
    }
    // And against dense sampling.
    let pass = &held.welding.program.value.passes[0];
    let (from, to) = (held.held.heat_input[0].0, held.held.heat_input[held.held.heat_input.len() - 1].0);
    for i in 0..=20_000 {
        let s = from + (to - from) * f64::from(i) / 20_000.0;
        let value = |name: &str| pass.process_at(name, s, ArcTime::TRAVEL).unwrap();
        let found = 0.8e-3 * value("current_a") * value("voltage_v") / held.motion.profile.speed(s);
        let outside = heat.iter().any(|o| s >= o.from_mm && s <= o.to_mm);
        let close = (found - 0.48).abs() < 2e-6 || (found - 0.49).abs() < 2e-6;
        assert!(close || outside != (0.48..=0.49).contains(&found), "{s}: {found}");
    }
    assert_eq!(findings(&held).len(), 3 + heat.len());
}

/// Rotation from the work's coordinates with the axes at `q` to those with the work's axes `a` and `c` at zero. The
/// tool's slides have fixed directions in space; the torch tip gives these directions in the work.
fn work_to_zero(machine: &Machine, q: &Joints) -> DMat3 {
    let axis = |name: &str| machine.axis(name).unwrap();
    let slides = |q: &Joints| {
        let along = |name: &str| {
            let mut moved = *q;
            moved[axis(name)] += 100.0;
            (machine.forward(&moved).point - machine.forward(q).point).normalize()
        };
        let (x, y) = (along("x"), along("y"));
        DMat3::from_cols(x, y, x.cross(y))
    };
    let mut zero = *q;
    zero[axis("a")] = 0.0;
    zero[axis("c")] = 0.0;
    slides(&zero) * slides(q).transpose()
}

#[test]
fn positions_are_seen_from_the_part_as_the_machine_turns_it() {
    let up = DVec3::new(0.6, 0.0, 0.8);
    let text = shipped("table-tilting-xyzac").unwrap().text.replacen("schema = 1", "schema = 1\nup = [0.6, 0, 0.8]", 1);
    let machine = read_machine(&text);
    let trunnion = include_str!("../../../../examples/trunnion-saddle.toml");
    let held = hold_job(trunnion, &machine, "passes = \"1\"\npositions = [\"PB\", \"PC\"]\n");
    let path = held.welding.path(0);
    for (s, found) in held.held.inclinations.iter().step_by(7) {
        let turn = work_to_zero(&held.machine, &held.motion.path.at(*s));
        let wanted = Inclination::new(turn * path.line(*s).1, turn * path.face(*s), up);
        let off = (wanted.slope - found.slope).abs().max((wanted.rotation - found.rotation).abs());
        assert!(off < 1e-5, "s = {s}: {found:?} {wanted:?}");
    }
    let wrong: Vec<&_> = held
        .held
        .positions
        .iter()
        .filter(|p| ![WeldingPosition::Pb, WeldingPosition::Pc].contains(&p.position))
        .collect();
    assert!(!wrong.is_empty(), "{:?}", held.held.positions);
    for (finding, stretch) in findings(&held).iter().zip(&wrong) {
        assert!((finding.from_mm, finding.to_mm) == (stretch.from_mm, stretch.to_mm), "{finding:?}");
        assert!(
            finding.message.to_string().contains(&stretch.position.to_string())
                && finding.message.to_string().contains("PB, PC")
        );
    }
    // With gravity along the axis that turns the part the result is independent of the turn.
    let level = hold(&[], &saddle_welder(""), "passes = \"1\"\npositions = [\"PB\"]\n");
    assert!(level.held.findings.is_empty() && level.held.positions.len() == 1, "{:?}", level.held.positions);
}

#[test]
fn what_the_plan_does_not_know_or_has_no_run_for_is_a_finding() {
    let machine = saddle_welder("");
    let held = hold(&[("voltage_v = 27\n", "")], &machine, "passes = \"1\"\nheat_input_kj_mm = [0.4, 0.65]\n");
    let found = findings(&held);
    assert!(found.len() == 1 && found[0].message.to_string().contains("voltage_v") && held.held.heat_input.is_empty());
    let held = hold(&[], &machine, "passes = \"1\"\nranges = { gas_l_min = [12, 18] }\n");
    assert!(findings(&held)[0].message.to_string().contains("does not give gas_l_min"));
    let held = hold(&[], &machine, "name = \"root\"\n");
    assert!(findings(&held)[0].message.to_string().contains("no run of W 1 is for pass 1 (pass 1)"));
    // The angles are those that the axes reach: this machine cannot lean along the seam.
    let held = hold(&[], &machine, "passes = \"1\"\ntravel_angle_deg = [-2, 2]\n");
    let worst = held.motion.attitude_error.0.to_degrees();
    let (least, greatest) = quantity(&held, "travel_angle_deg").found.unwrap();
    assert!(greatest.max(-least) > 2.0 && greatest.max(-least) <= worst + 1e-6, "{least} {greatest} {worst}");
    assert_eq!(findings(&held).len(), quantity(&held, "travel_angle_deg").outside.len());
    let speed = hold(&[], &machine, "passes = \"1\"\nspeed_mm_s = [10, 12]\n");
    assert!(findings(&speed).is_empty(), "{:?}", speed.held.findings);
}

#[test]
fn a_whole_weld_is_held_to_its_procedure() {
    let text = SADDLE.replace("speed_mm_s = 10", "speed_mm_s = 7");
    let welding = read(&text);
    let program = &welding.program.value;
    let machine = saddle_welder("");
    let clamped = seamwright_machine::Clamped::default();
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let path = welding.path(0);
    let passes: Vec<(&dyn TorchPath, &seamwright_program::Pass)> = vec![(&path, &program.passes[0])];
    let mut motion = WeldMotion::plan(&machine, &around, &passes, 30.0).unwrap();
    motion.hold_to(program.procedure.as_ref().unwrap(), &machine, &passes);
    assert_eq!(motion.procedure.len(), 1);
    let against: Vec<&Finding> = motion.findings.iter().filter(|f| !f.allowed).collect();
    assert!(against.len() == 2 && against.iter().all(|f| f.kind == "procedure"), "{against:?}");
    assert!(against[0].message.to_string().contains("the speed of the tip is 7 mm/s"), "{}", against[0].message);
    assert!(against[1].message.to_string().contains("heat input is 0.7406 kJ/mm"), "{}", against[1].message);
}
