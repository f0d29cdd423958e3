//! Jobs with beads as programs: the metal deposited by the passes, from their speeds and wire feeds alone, fills the
//! joint.

use crate::jobs::{WithSeam, changed, read, refusal};
use seamwright_program::{ArcTime, Pass, Program, Role};
use seamwright_weld::Welding;
use std::f64::consts::FRAC_PI_4;

const HILLSIDE: &str = include_str!("../../../../examples/hillside.toml");

/// Wire of a weld, and the length of its seam.
#[derive(Clone, Copy)]
struct Wire {
    /// Metal per length of wire, mm^2.
    area: f64,
    turn: f64,
}

impl Wire {
    fn of(welding: &Welding) -> Self {
        let consumables = &welding.program.value.consumables;
        let (diameter, deposition) = (consumables.wire_mm.unwrap().get(), consumables.deposition.unwrap().get());
        Self { area: FRAC_PI_4 * diameter * diameter * deposition, turn: welding.seam().length() }
    }
}

/// Metal that a pass deposits per mm of seam at path length `seam_s`, mm^2: once for each of its beads, not again where it
/// overlaps itself.
fn deposited(pass: &Pass, seam_s: f64, Wire { area, turn }: Wire) -> Option<f64> {
    let begin = pass.begin_mm.get();
    let own = if pass.reverse { begin - seam_s } else { seam_s - begin };
    let first = own.rem_euclid(turn);
    let beads = 1 + pass.step_overs.len();
    let all = (0..beads).map(|k| first + k as f64 * turn).filter(|own| *own <= pass.length());
    let one = |own: f64| {
        let feed = pass.process_at("wire_feed_m_min", own, ArcTime::TRAVEL).unwrap() * 1000.0 / 60.0;
        area * feed / pass.speed_at(own)
    };
    all.map(one).reduce(|a, b| a + b)
}

/// True if a step-over of the pass is at path length `seam_s` of the seam.
fn steps_over(pass: &Pass, seam_s: f64, turn: f64) -> bool {
    let own = (seam_s - pass.begin_mm.get()).rem_euclid(turn);
    let away = own.min(turn - own);
    pass.step_overs.iter().any(|step| away <= 0.5 * step.length_mm.get())
}

/// Maximum relative difference of the deposited metal from groove and cap, along the seam.
fn off(welding: &Welding) -> f64 {
    let joint = welding.joint.as_ref().unwrap();
    let (turn, wire) = (welding.seam().length(), Wire::of(welding));
    let passes = &welding.program.value.passes;
    let off = |i: i32| {
        let s = turn * (f64::from(i) + 0.37) / 1000.0;
        // In a step-over the torch travels farther than along the seam.
        if passes.iter().any(|pass| steps_over(pass, s, turn)) {
            return 0.0;
        }
        let section = joint.section(&welding.seam().at(s)).unwrap();
        let sum: f64 = passes.iter().filter_map(|pass| deposited(pass, s, wire)).sum();
        (sum / section.total() - 1.0).abs()
    };
    (0..1000).map(off).fold(0.0, f64::max)
}

#[test]
fn welds_whose_last_station_rounds_up_are_planned() {
    for text in [
        include_str!("../../../../tests/data/field-trial/hillside212.toml"),
        include_str!("../../../../tests/data/field-trial/11-nozzle.toml"),
    ] {
        let welding = read(text);
        let (seam, passes) = (welding.seam(), &welding.program.value.passes);
        assert!(!seam.all_round() && passes.len() > 1);
        for pass in passes {
            assert!(pass.bead.as_ref().unwrap().s_mm.iter().all(|s| s.get() <= seam.weld_length()), "{}", pass.name);
        }
        assert_eq!(read(&welding.program.value.to_toml().unwrap()).program.value.passes.len(), passes.len());
    }
}

#[test]
fn every_example_with_beads_fills_its_joint() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut with_beads = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        if text.contains("\n[beads]") {
            let mut welding = read(&text);
            welding.program.value.passes.retain(|pass| pass.role != Some(Role::Tack));
            assert!(off(&welding) < 0.01, "{}: {}", path.display(), off(&welding));
            with_beads += 1;
        }
    }
    assert!(with_beads >= 2);
}

#[test]
fn what_is_deposited_fills_the_joint_within_one_percent() {
    let more = ("thickness_mm = 8 ", "thickness_mm = 25 ");
    for changes in [
        vec![],
        vec![more],
        vec![more, ("adapt = \"speed\"", "adapt = \"wire_feed\"")],
        vec![more, ("stagger_mm = 40", "stagger_mm = 133\nalternate = true\norder = \"from_second\"")],
    ] {
        let welding = read(&changed(HILLSIDE, &changes));
        assert!(off(&welding) < 0.01, "{changes:?}: {}", off(&welding));
        // Where the faces are nearly square, a convex cap of two beads is steep at its toes.
        let findings = welding.findings();
        let others = findings.iter().filter(|f| f.message.code != "weld-bead-toe-steep").count();
        assert_eq!(others, 0, "{changes:?}: {findings:#?}");
    }
}

#[test]
fn layers_that_end_leave_the_sum_right_but_at_their_ends() {
    let welding = read(&changed(
        HILLSIDE,
        &[
            ("radius_mm = 60", "radius_mm = 120"),
            ("thickness_mm = 8 ", "thickness_mm = 25 "),
            ("adapt = \"speed\"", "adapt = \"passes\"\ntie_in_mm = 0"),
        ],
    ));
    let passes = &welding.program.value.passes;
    let partial: Vec<&Pass> = passes.iter().filter(|p| p.length() < welding.seam().length()).collect();
    assert!(!partial.is_empty() && partial.iter().all(|p| p.length() >= 50.0 && p.name.starts_with("fill")));
    // Without a tie-in the others change over one station where a layer ends: apart from there all is filled.
    let (joint, turn) = (welding.joint.as_ref().unwrap(), welding.seam().length());
    let wire = Wire::of(&welding);
    let ends: Vec<f64> = partial.iter().flat_map(|p| [p.begin_mm.get(), p.begin_mm.get() + p.length()]).collect();
    let mut looked = 0;
    for i in 0..1000 {
        let s = turn * f64::from(i) / 1000.0;
        let near = |end: &f64| ((s - end + 0.5 * turn).rem_euclid(turn) - 0.5 * turn).abs() < 6.0;
        if ends.iter().any(near) {
            continue;
        }
        looked += 1;
        let total = joint.section(&welding.seam().at(s)).unwrap().total();
        let sum: f64 = passes.iter().filter_map(|pass| deposited(pass, s, wire)).sum();
        assert!((sum / total - 1.0).abs() < 0.01, "{s}: {sum} {total}");
    }
    assert!(looked > 800);
}

#[test]
fn the_program_that_comes_out_is_read_back_the_same() {
    let welding = read(HILLSIDE);
    let text = welding.program.value.to_toml().unwrap();
    let again = Program::read("program.toml", &text).unwrap();
    assert_eq!(again.value, welding.program.value);
    let again = read(&text);
    for pass in 0..welding.program.value.passes.len() {
        for i in 0..50 {
            use seamwright_program::TorchPath;
            let s = welding.path(pass).length() * f64::from(i) / 49.0;
            let (a, b) = (welding.path(pass).pose(s), again.path(pass).pose(s));
            assert!((a.point - b.point).length() < 1e-12 && (a.direction - b.direction).length() < 1e-12);
        }
    }
}

#[test]
fn mistakes_have_an_address_and_a_cure() {
    let wrong = |changes: &[(&str, &str)]| {
        let e = refusal(&changed(HILLSIDE, changes));
        (e.key, e.allowed.unwrap_or_default().to_string())
    };
    let key = |from: &str, to: &str| wrong(&[(from, to)]).0;
    let t_bevel = |key: &str| format!("joint.preparation.t_bevel{key}");
    assert_eq!(key("root_gap_mm = 2", "root_gap_mm = 20"), t_bevel(".root_gap_mm"));
    assert!(wrong(&[("root_gap_mm = 2", "root_gap_mm = 20")]).1.contains("0 mm to 8.0 mm"));
    assert_eq!(key("root_face_mm = 1.5", "root_face_mm = 8"), t_bevel(".root_face_mm"));
    assert_eq!(key("cut_deg = 45 ", "cut_deg = 45\nangle_deg = 50 "), t_bevel(""));
    assert_eq!(key("cut_deg = 45 ", "angle_deg = 110 "), t_bevel(".angle_deg"));
    assert_eq!(key("cut_deg = 45 ", "cut_deg = -20 "), t_bevel(".cut_deg"));
    assert_eq!(key("thickness_mm = 8 ", "thickness = 8 "), t_bevel(".thickness"));
    assert_eq!(
        key("[joint.preparation.t_bevel]", "[joint.preparation.single_v]"),
        "joint.preparation.single_v.cut_deg"
    );
    assert_eq!(key("deposition = 0.95", "deposition = 1.95"), "beads.deposition");
    assert_eq!(key("adapt = \"speed\"", "adapt = \"sped\""), "beads.adapt");
    assert_eq!(key("wire_mm = 1.2\n", ""), "beads.fill");
    assert_eq!(key("wire_feed_m_min = 8", "wire_feed_m_min = { from = 8, to = 9 }"), "weld.process.wire_feed_m_min");
    let (at, allowed) = wrong(&[("current_a = 150,", "curent_a = 150,")]);
    assert_eq!(at, "beads.root.process.curent_a");
    assert!(allowed.contains("current_a"), "{allowed}");
    assert_eq!(key("[beads]", "[beads]\nstation_mm = 0.01"), "beads.station_mm");
    assert_eq!(key("[beads]", "[[joint.fit_up]]\ns_mm = 1e4\nroot_gap_mm = 1\n[beads]"), "joint.fit_up[0].s_mm");
    // Beads too large for the groove are understood, but cannot be welded.
    let welding =
        read(&changed(HILLSIDE, &[("fill = { layer_mm = 3.5 }", "fill = { layer_mm = 3.5 }\nmost_percent = 3")]));
    let findings = welding.findings();
    assert!(!findings.is_empty() && findings.iter().all(|f| f.kind == "bead" && f.cure.is_some()), "{findings:#?}");
}

/// Finished passes stay in a job whose groove was measured again, to the last digit of the program.
#[test]
fn finished_passes_stay_when_the_groove_is_measured_again() {
    let entry = |s: f64, remaining: f64| {
        format!("[[joint.fit_up]]\ns_mm = {s}\nroot_gap_mm = 2\nafter_layer = 1\nremaining_mm2 = {remaining}\n")
    };
    let first = read(HILLSIDE);
    let scan: String = (0..8).map(|i| entry(50.0 * f64::from(i), 25.0 + 2.0 * f64::from(i % 3))).collect();
    let again = read(&HILLSIDE.replace("[joint.preparation.t_bevel]", &format!("{scan}[joint.preparation.t_bevel]")));
    let passes = |welding: &Welding| welding.program.value.passes.clone();
    assert_eq!(passes(&again)[0], passes(&first)[0]);
    assert_ne!(passes(&again)[1], passes(&first)[1]);
    let (joint, turn) = (again.joint.as_ref().unwrap(), again.seam().length());
    let wire = Wire::of(&again);
    for i in 0..300 {
        let s = turn * (f64::from(i) + 0.37) / 300.0;
        let above: f64 = passes(&again)[1..].iter().filter_map(|pass| deposited(pass, s, wire)).sum();
        let section = joint.section(&again.seam().at(s)).unwrap();
        let remaining = above - section.cap;
        assert!((23.0..31.0).contains(&remaining), "{s}: {remaining}");
        // At a measured station the metal of the passes is the area measured there.
        let k = (s / 50.0).round();
        if (s - 50.0 * k).abs() < 0.5 && k < 8.0 {
            assert!((remaining - 25.0 - 2.0 * (k % 3.0)).abs() < 0.6, "{s}: {remaining}");
        }
    }
}

#[test]
fn contradictory_measurements_are_refused_at_their_keys() {
    let entry =
        |keys: &str| HILLSIDE.replace("[joint.preparation", &format!("[[joint.fit_up]]\n{keys}\n[joint.preparation"));
    for (keys, key) in [
        ("s_mm = 0\nroot_gap_mm = 2\nremaining_mm2 = 20", "joint.fit_up[0].remaining_mm2"),
        ("s_mm = 0\nroot_gap_mm = 2\nafter_layer = 1", "joint.fit_up[0].after_layer"),
        ("s_mm = 0\nroot_gap_mm = 2\nafter_layer = 40\nremaining_mm2 = 20", "joint.fit_up[0].after_layer"),
        ("s_mm = 0\nroot_gap_mm = 2\nafter_layer = 1\nremaining_mm2 = 200", "joint.fit_up[0].remaining_mm2"),
        ("s_mm = 0\nroot_gap_mm = 2\nafter_layer = 1\nremaining_mm2 = -200", "joint.fit_up[0].remaining_mm2"),
        ("s_mm = 0\nroot_gap_mm = 2\nangle_deg = 170", "joint.fit_up[0].angle_deg"),
        ("s_mm = 0\nroot_gap_mm = 2\nangle_deg = 0", "joint.fit_up[0].angle_deg"),
        (
            "s_mm = 0\nroot_gap_mm = 2\nafter_layer = 1\nremaining_mm2 = 20\n[[joint.fit_up]]\ns_mm = 5\nroot_gap_mm = 2",
            "joint.fit_up[1]",
        ),
    ] {
        let refused = refusal(&entry(keys));
        assert_eq!(refused.key, key, "{refused}");
    }
    let square = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [100, 0, 0]\n\
        first_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n[joint.preparation.square]\nthickness_mm = 4\n\
        root_gap_mm = 1\n[[joint.fit_up]]\ns_mm = 0\nroot_gap_mm = 1\nangle_deg = 5\n[weld]\nspeed_mm_s = 5\n";
    assert_eq!(refusal(square).key, "joint.fit_up[0].angle_deg");
}

/// A pipe welded by an orbital head: less wire and current overhead and uphill, in every pass.
const ORBITAL: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.girth]\nradius_mm = 84.15\n\
    [start]\noverlap_mm = 15\n[joint]\ncap_mm = 1\n[joint.preparation.single_v]\nthickness_mm = 11\nangle_deg = 50\n\
    root_gap_mm = 2\nroot_face_mm = 1\n[beads]\nwire_mm = 1.2\nalternate = true\nfill = { layer_mm = 3 }\n\
    [[beads.sectors]]\nphi_deg = 0\nfactors = { current_a = 1.0, wire_feed_m_min = 1.0 }\n\
    [[beads.sectors]]\nphi_deg = 90\nfactors = { current_a = 0.92, wire_feed_m_min = 0.85 }\n\
    [[beads.sectors]]\nphi_deg = 180\nfactors = { current_a = 0.9, wire_feed_m_min = 0.8 }\n\
    [weld]\nspeed_mm_s = 5\n[weld.process]\ncurrent_a = 200\nvoltage_v = 22\nwire_feed_m_min = 6\n";

#[test]
fn sectors_change_every_pass_by_the_position_on_the_seam() {
    let welding = read(ORBITAL);
    assert!(off(&welding) < 4e-3, "{}", off(&welding));
    let (seam, passes) = (welding.seam(), &welding.program.value.passes);
    assert!(passes.len() >= 4 && passes.iter().any(|pass| pass.reverse));
    let factor = |phi: f64, at: [f64; 3]| match phi {
        phi if phi < 90.0 => at[0] + (at[1] - at[0]) * phi / 90.0,
        phi if phi < 180.0 => at[1] + (at[2] - at[1]) * (phi - 90.0) / 90.0,
        phi => at[2] + (at[0] - at[2]) * (phi - 180.0) / 180.0,
    };
    for pass in passes {
        for i in 0..200 {
            let own = pass.length() * (f64::from(i) + 0.3) / 200.0;
            let sense = if pass.reverse { -1.0 } else { 1.0 };
            let s = pass.begin_mm.get() + sense * own;
            let phi = seam.at(s).phi.unwrap().to_degrees().rem_euclid(360.0);
            for (name, drawn, at) in
                [("current_a", 200.0, [1.0, 0.92, 0.9]), ("wire_feed_m_min", 6.0, [1.0, 0.85, 0.8])]
            {
                let value = pass.process_at(name, own, ArcTime::TRAVEL).unwrap();
                assert!((value / (drawn * factor(phi, at)) - 1.0).abs() < 2e-5, "{} {name} {phi}", pass.name);
            }
            assert!((pass.process_at("voltage_v", own, ArcTime::TRAVEL).unwrap() - 22.0).abs() < 1e-12);
        }
    }
    let key = |from: &str, to: &str| refusal(&ORBITAL.replace(from, to)).key;
    assert_eq!(key("phi_deg = 90\n", ""), "beads.sectors[1]");
    assert_eq!(key("phi_deg = 90\n", "s_mm = 9999\n"), "beads.sectors[1].s_mm");
    assert_eq!(key("phi_deg = 90", "phi_deg = 180"), "beads.sectors");
    assert_eq!(key("current_a = 0.92, ", "power_w = 0.92, "), "beads.sectors[1].factors.power_w");
    assert_eq!(key("current_a = 0.92, ", ""), "beads.sectors[1].factors");
    assert_eq!(key("alternate = true", "adapt = \"wire_feed\""), "beads.sectors[0].factors.wire_feed_m_min");
}

/// A pipe with a ring of filler metal in its root gap.
fn with_insert(root: &str) -> String {
    ORBITAL
        .replace(
            "root_gap_mm = 2\nroot_face_mm = 1\n",
            "root_gap_mm = 2.5\nroot_face_mm = 1\n[joint.insert]\nkind = \"ring\"\nwidth_mm = 2.4\nheight_mm = 3.2\n",
        )
        .replace("alternate = true\n", &format!("root = {{ layer_mm = 3, {root} }}\n"))
        .split("[[beads.sectors]]")
        .next()
        .unwrap()
        .to_owned()
        + "[weld]\nspeed_mm_s = 5\n[weld.process]\ncurrent_a = 200\nvoltage_v = 22\nwire_feed_m_min = 6\n"
}

/// The insert is metal of the root bead: wire adds the rest, or nothing at one speed.
#[test]
fn an_insert_is_part_of_the_root_bead() {
    let insert = 2.4 * 3.2;
    for (root, is_fused_alone) in
        [("process = { wire_feed_m_min = 0 }", true), ("process = { wire_feed_m_min = 2 }", false)]
    {
        let welding = read(&with_insert(root));
        let (joint, turn) = (welding.joint.as_ref().unwrap(), welding.seam().length());
        let passes = &welding.program.value.passes;
        let first = &passes[0];
        assert_eq!(first.role, Some(Role::Root));
        let area = first.bead.as_ref().unwrap().area_mm2[0].get();
        assert!(area > 0.7 * insert, "{area}");
        let (slowest, fastest) = first.speeds();
        assert!((fastest - slowest).abs() < 1e-9, "a pipe has one section");
        assert_eq!((slowest - 5.0).abs() < 1e-9, is_fused_alone, "{slowest}");
        for i in 0..50 {
            let s = turn * (f64::from(i) + 0.37) / 50.0;
            let section = joint.section(&welding.seam().at(s)).unwrap();
            let wire: f64 = passes.iter().filter_map(|pass| deposited(pass, s, Wire::of(&welding))).sum();
            let root = if is_fused_alone { area } else { insert };
            assert!(
                (wire + root - section.total()).abs() < 0.01 * section.total(),
                "{wire} {root} {}",
                section.total()
            );
            let drawn = joint.insert(&section).unwrap();
            assert!(drawn.iter().all(|p| p.x.abs() <= 0.5 * section.gap));
        }
    }
    let key = |from: &str, to: &str| {
        let text = with_insert("process = { wire_feed_m_min = 0 }");
        assert!(text.contains(from), "{from}");
        refusal(&text.replace(from, to)).key
    };
    let gap = "joint.preparation.single_v.root_gap_mm";
    assert_eq!(key("root_gap_mm = 2.5", "root_gap_mm = 2"), gap);
    assert_eq!(key("root_gap_mm = 2.5", "root_gap_mm = 3.2"), gap);
    assert_eq!(key("kind = \"ring\"", "kind = \"y_shape\""), "joint.insert");
    assert_eq!(key("height_mm = 3.2", "height_mm = 12"), "joint.insert.height_mm");
    assert_eq!(key("[joint.insert]", "[joint.backing]\nkind = \"ceramic\"\n[joint.insert]"), "joint.insert");
    assert_eq!(key("root = {", "cap = {"), "joint.insert");
    let loose = "[[joint.fit_up]]\ns_mm = 0\nroot_gap_mm = 3.5\n[joint.insert]";
    assert_eq!(key("[joint.insert]", loose), "joint.fit_up[0].root_gap_mm");
}

/// A bead has one number in sections, in passes and in the table of toes, also where layers end and in spirals.
#[test]
fn beads_have_one_number_all_along_the_seam() {
    let layers_that_end = changed(
        HILLSIDE,
        &[
            ("radius_mm = 60", "radius_mm = 120"),
            ("thickness_mm = 8 ", "thickness_mm = 25 "),
            ("adapt = \"speed\"", "adapt = \"passes\""),
        ],
    );
    let spiral =
        changed(HILLSIDE, &[("thickness_mm = 8 ", "thickness_mm = 25 "), ("[beads]", "[beads]\nstep_over_mm = 30")]);
    for text in [layers_that_end, spiral] {
        let welding = read(&text);
        let (plan, joint, seam) = (welding.plan.as_ref().unwrap(), welding.joint.as_ref().unwrap(), welding.seam());
        let numbers = welding.bead_numbers();
        let all: Vec<usize> = numbers.iter().flat_map(|n| n.first.into_iter().chain(n.last)).collect();
        assert_eq!(all.iter().max(), Some(&plan.count()), "{all:?}");
        for (i, pass) in welding.program.value.passes.iter().enumerate() {
            // The line of the pass is that of the bead with its number, wherever the bead is.
            for (k, (bead, range)) in pass.beads().enumerate() {
                let on_seam = pass.seam_s(0.5 * (range.from_mm + range.to_mm)).rem_euclid(seam.length());
                let station = plan.stations.iter().rposition(|s| *s <= on_seam).unwrap();
                let s = plan.stations[station];
                let section = joint.section(&seam.at(s)).unwrap();
                let here = plan.in_order(&section, s);
                let same = here.iter().find(|at| plan.number(at) == numbers[i].first.unwrap() + k).unwrap();
                let row = bead.row_at(s, Some(seam.length()));
                let at = &plan.at_station(station).iter().find(|at| (at.layer, at.index) == (same.layer, same.index));
                let tip = at.unwrap().tip;
                assert!(
                    (row.across_mm - tip.x).abs() < 1e-3 && (row.out_mm - tip.y).abs() < 1e-3,
                    "{i} {k}: {row:?} {tip}"
                );
            }
            let toes = welding.toes(i, numbers[i], &[]);
            assert!(!toes.is_empty() && toes.iter().all(|toe| (0.0..=pass.length()).contains(&toe.s)), "{i}");
        }
    }
}
