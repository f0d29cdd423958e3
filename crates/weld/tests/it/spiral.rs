//! Girths welded in spirals: beads joined by step-overs. The torch is on the line of each bead outside them, its motion is
//! twice continuously differentiable, and the metal is that of the beads.

use crate::jobs::{WithSeam, changed, read, refusal};
use seamwright_program::{Pass, Program, Role, TorchPath};
use seamwright_testkit::{Random, cases};
use seamwright_weld::{BesideSeam, PassPath, Welding};

/// A girth with a root, fills and caps of several beads; `STEP` stands for the step-over.
const GIRTH: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.girth]\nradius_mm = 150\ndirection = [1, 0, 0]\n\
    zero_direction = [0, 0, 1]\n[joint]\ncap_mm = 1\n[joint.preparation.u]\nthickness_mm = 14\nangle_deg = 10\n\
    radius_mm = 6\nroot_face_mm = 2\n[start]\noverlap_mm = 15\n[beads]\nwire_mm = 1.2\norder = \"from_second\"\nSTEP\n\
    root = { speed_mm_s = 8 }\nfill = { layer_mm = 3 }\ncap = { layer_mm = 3 }\n[weld]\nspeed_mm_s = 6\n\
    [weld.process]\ncurrent_a = 250\nvoltage_v = 27\nwire_feed_m_min = 7\n";

/// A random girth, without a step-over and with one of the length given.
fn random_girth(random: &mut Random) -> (String, f64) {
    let step = random.within(20.0, 120.0);
    let tilt = if random.yes() { random.within(0.0, 12.0).to_radians() } else { 0.0 };
    let cut = format!("cut_normal = [{}, {}, 0]\n", tilt.cos(), tilt.sin());
    let text = changed(
        GIRTH,
        &[
            ("radius_mm = 150\n", &format!("radius_mm = {}\n{cut}", random.within(90.0, 300.0))),
            ("thickness_mm = 14", &format!("thickness_mm = {}", random.within(12.0, 24.0))),
            ("layer_mm = 3 }\ncap", &format!("layer_mm = {} }}\ncap", random.within(2.2, 3.6))),
            ("overlap_mm = 15", &format!("overlap_mm = {}", random.within(0.0, 40.0))),
            ("[beads]", &format!("[beads]\nstagger_mm = {}", random.within(0.0, 90.0))),
        ],
    );
    (text, step)
}

fn with_step(text: &str, step: f64) -> Welding {
    read(&changed(text, &[("STEP", &format!("step_over_mm = {step}"))]))
}

fn without(text: &str) -> Welding {
    read(&changed(text, &[("STEP\n", "")]))
}

/// The torch of pass `i` beside the seam at the own path length `own`.
fn beside(welding: &Welding, i: usize, own: f64) -> BesideSeam {
    let path = welding.path(i);
    let path = path.along_seam().unwrap();
    path.bead.unwrap().at(own, path.stretch.seam_s(own))
}

/// The passes that are not a spiral in the order of the beads: each with the pass of the spiral, and its bead there.
fn beads_of(welding: &Welding) -> Vec<(usize, usize)> {
    let passes = welding.program.value.passes.iter().enumerate();
    passes.flat_map(|(i, pass)| (0..=pass.step_overs.len()).map(move |k| (i, k))).collect()
}

#[test]
fn outside_step_overs_the_torch_is_on_the_line_of_each_bead() {
    let mut random = Random::new(31);
    let (mut looked, mut joined) = (0, 0);
    for _ in 0..cases(24) {
        let (text, step) = random_girth(&mut random);
        let (spiral, plain) = (with_step(&text, step), without(&text));
        let turn = spiral.seam().length();
        let beads = beads_of(&spiral);
        assert_eq!(beads.len(), plain.program.value.passes.len(), "{text}");
        for (alone, (i, k)) in beads.into_iter().enumerate() {
            let pass = &spiral.program.value.passes[i];
            joined += usize::from(k > 0);
            let (low, high) = (k as f64 * turn, (k as f64 + 1.0) * turn);
            for _ in 0..20 {
                let own = random.within(low, high);
                if pass.step_overs.iter().any(|step| (step.at_mm.get() - own).abs() < 0.5 * step.length_mm.get()) {
                    continue;
                }
                let (path, other) = (spiral.path(i), plain.path(alone));
                let (path, other) = (path.along_seam().unwrap(), other.along_seam().unwrap());
                let s = path.stretch.seam_s(own);
                let there = (s - other.stretch.begin).rem_euclid(turn);
                let tip = |path: &PassPath, own: f64| path.torch_at(&path.seam_point(own));
                let ((a, lean), (b, alone_lean)) = (tip(path, own), tip(other, there));
                assert!(a.distance(b) < 1e-9 && lean.distance(alone_lean) < 1e-9, "{} at {own}: {text}", pass.name);
                looked += 1;
            }
        }
    }
    assert!(looked > 1000 && joined > 50, "{looked} {joined}");
}

#[test]
fn position_and_work_angle_are_twice_continuously_differentiable_in_step_overs() {
    const H: f64 = 0.02;
    let mut random = Random::new(32);
    for _ in 0..cases(24) {
        let (text, step) = random_girth(&mut random);
        let spiral = with_step(&text, step);
        for (i, pass) in spiral.program.value.passes.iter().enumerate() {
            for over in &pass.step_overs {
                let range = over.range();
                let at = |own: f64| {
                    let b = beside(&spiral, i, own);
                    [b.across, b.out, b.lean]
                };
                let (before, after) = (at(range.from_mm), at(range.to_mm));
                for join in [range.from_mm, over.at_mm.get(), range.to_mm] {
                    for k in 0..3 {
                        let value = |steps: f64| at(join + steps * H)[k];
                        let second = |side: f64| (value(0.0) - 2.0 * value(side) + value(2.0 * side)) / (H * H);
                        let slope =
                            |side: f64| side * (4.0 * value(side) - 3.0 * value(0.0) - value(2.0 * side)) / (2.0 * H);
                        // A transition that were only once differentiable would jump by 6 over the length's square.
                        let way = (after[k] - before[k]).abs() + 0.01;
                        let jump = 60.0 * way / step.powi(3) * 4.0 * H + 1e-7;
                        assert!((second(1.0) - second(-1.0)).abs() < jump + 1e-4 * way, "{k} at {join}: {text}");
                        assert!((slope(1.0) - slope(-1.0)).abs() < 1e-5 * way + 1e-9, "{k} at {join}: {text}");
                    }
                }
            }
        }
    }
}

/// Metal of the first `length` mm of a pass as a part of what its run lays at its own speed, by the travel of the torch.
fn volume(welding: &Welding, i: usize, length: f64) -> f64 {
    let (pass, path) = (&welding.program.value.passes[i], welding.path(i));
    let mut ends = vec![0.0, length];
    ends.extend(pass.step_overs.iter().flat_map(|step| [step.range().from_mm, step.range().to_mm]));
    ends.sort_by(f64::total_cmp);
    let cell = |pair: &[f64]| {
        let h = (pair[1] - pair[0]) / 200.0;
        let at = |k: u32| pair[0] + (f64::from(k) + 0.5) * h;
        (0..200).map(|k| h * path.rate(at(k)) / pass.speed_at(at(k))).sum::<f64>()
    };
    ends.windows(2).map(cell).sum()
}

#[test]
fn a_spiral_lays_the_metal_of_its_beads() {
    let mut random = Random::new(33);
    let mut worst = 0.0f64;
    for _ in 0..cases(12) {
        let (text, step) = random_girth(&mut random);
        let (spiral, plain) = (with_step(&text, step), without(&text));
        let turn = spiral.seam().length();
        let mut sums = vec![0.0; spiral.program.value.passes.len()];
        let mut counts = vec![0.0; sums.len()];
        for (alone, (i, _)) in beads_of(&spiral).into_iter().enumerate() {
            sums[i] += volume(&plain, alone, turn);
            counts[i] += 1.0;
        }
        for (i, (sum, count)) in sums.into_iter().zip(counts).enumerate() {
            let found = volume(&spiral, i, count * turn);
            worst = worst.max((found / sum - 1.0).abs());
        }
    }
    println!("metal within {:.4} % of that of the beads", 100.0 * worst);
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn one_arc_start_for_each_role() {
    let spiral = with_step(GIRTH, 60.0);
    let passes = &spiral.program.value.passes;
    let names: Vec<&str> = passes.iter().map(|pass| pass.name.as_str()).collect();
    let roles: Vec<Option<Role>> = passes.iter().map(|pass| pass.role).collect();
    assert_eq!(roles, [Some(Role::Root), Some(Role::Fill), Some(Role::Cap)], "{names:?}");
    assert!(names[1].starts_with("fill 2") && names[1].contains(" to "), "{names:?}");
    let turn = spiral.seam().length();
    for pass in passes {
        assert!((pass.length() - (pass.step_overs.len() as f64 + 1.0) * turn - 15.0).abs() < 1e-9, "{}", pass.name);
        let steps = pass.step_overs.iter().enumerate();
        assert!(steps.clone().all(|(k, step)| (step.at_mm.get() - (k as f64 + 1.0) * turn).abs() < 1e-9));
    }
    assert!(spiral.findings().is_empty(), "{:#?}", spiral.findings());
    // Both welds end with the same metal.
    let last = |welding: &Welding| welding.metal().unwrap().by_pass().last().unwrap().unwrap();
    let plain = without(GIRTH);
    for (a, b) in last(&spiral).iter().zip(&last(&plain)) {
        assert_eq!(format!("{:?}", a.shape()), format!("{:?}", b.shape()));
    }
}

#[test]
fn the_program_of_a_spiral_is_read_back_the_same() {
    let spiral = with_step(GIRTH, 60.0);
    let text = spiral.program.value.to_toml().unwrap();
    assert!(text.contains("[[passes.step_overs]]"));
    assert_eq!(Program::read("program.toml", &text).unwrap().value, spiral.program.value);
    let again = read(&text);
    for (i, pass) in spiral.program.value.passes.iter().enumerate() {
        for k in 0..200 {
            let s = pass.length() * f64::from(k) / 199.0;
            let (a, b) = (spiral.path(i).pose(s), again.path(i).pose(s));
            assert!((a.point - b.point).length() < 1e-12 && (a.direction - b.direction).length() < 1e-12);
        }
        // Backwards it goes over the same points.
        let back = pass.turned(Some(spiral.seam().length()));
        assert_eq!(back.turned(Some(spiral.seam().length())).step_overs.len(), pass.step_overs.len());
        let beads: Vec<_> = pass.beads().map(|(bead, _)| bead.clone()).collect();
        let turned: Vec<_> = back.beads().map(|(bead, _)| bead.clone()).collect();
        assert!(beads.iter().rev().eq(&turned));
    }
}

#[test]
fn mistakes_have_an_address_and_a_cure() {
    let key = |changes: &[(&str, &str)]| {
        let mut all = vec![("STEP", "step_over_mm = 60")];
        all.extend_from_slice(changes);
        refusal(&changed(GIRTH, &all)).key
    };
    assert_eq!(key(&[("overlap_mm = 15", "end_phi_deg = 200")]), "beads.step_over_mm");
    assert_eq!(key(&[("step_over_mm = 60", "step_over_mm = 600")]), "beads.step_over_mm");
    assert_eq!(key(&[("step_over_mm = 60", "step_over_mm = 0")]), "beads.step_over_mm");
    assert_eq!(key(&[("step_over_mm = 60", "step_over_mm = 1")]), "beads.step_over_mm");
    assert_eq!(key(&[("[beads]", "[beads]\nalternate = true")]), "beads.alternate");
    assert_eq!(key(&[("[beads]", "[beads]\nadapt = \"passes\"")]), "beads.adapt");
    assert_eq!(key(&[("[weld]\n", "[order]\nparts = \"quadrants\"\n[weld]\n")]), "order.parts");
    let spiral = with_step(GIRTH, 60.0);
    let program = |change: fn(&mut Pass)| {
        let mut program = spiral.program.value.clone();
        change(&mut program.passes[1]);
        refusal(&program.to_toml().unwrap()).key
    };
    assert_eq!(program(|pass| pass.bead = None), "passes[1].step_overs[0]");
    assert_eq!(program(|pass| pass.step_overs[1].at_mm = pass.step_overs[0].at_mm), "passes[1].step_overs[1].at_mm");
    assert_eq!(program(|pass| pass.step_overs[0].bead.s_mm.clear()), "passes[1].step_overs[0].bead.s_mm");
}
