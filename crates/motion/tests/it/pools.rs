//! Beads larger than their position holds, against a dense search along the pass.

use crate::number;
use crate::planning::{read, shipped_machine};
use seamwright_document::NonNegative;
use seamwright_machine::Machine;
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{Finding, Inclination, Pass, PathRange, Role, TorchPath};

/// Stations of the dense search.
const PLACES: usize = 6000;
/// Part by which a bead may be larger without a finding, and by which rows between stations may differ.
const ROUNDING: f64 = 0.02;

/// Area between two rows of a bead that goes all round, mm^2, from its definition.
fn area(pass: &Pass, s: f64, period: f64) -> f64 {
    let bead = pass.bead.as_ref().unwrap();
    let first = bead.s_mm[0].get();
    let s = first + (pass.seam_s(s) - first).rem_euclid(period);
    let mut rows: Vec<(f64, f64)> =
        bead.s_mm.iter().zip(&bead.area_mm2).map(|(s, area)| (s.get(), area.get())).collect();
    rows.push((first + period, rows[0].1));
    let ends = rows.windows(2).find(|ends| (ends[0].0..=ends[1].0).contains(&s)).unwrap();
    let part = (s - ends[0].0) / (ends[1].0 - ends[0].0);
    ends[0].1 + part * (ends[1].1 - ends[0].1)
}

/// The bead's area as a part of what its position holds, all along the pass: path length and that part.
fn parts(machine: &Machine, motion: &PassMotion, path: &dyn TorchPath, pass: &Pass, period: f64) -> Vec<(f64, f64)> {
    // Another pass covers it, unless it is a cap.
    let enclosed = pass.role != Some(Role::Cap);
    let one = |i: usize| {
        let s = path.length() * i as f64 / PLACES as f64;
        let up = machine.up_in_work(&motion.path.at(s));
        let at = Inclination::new(path.groove(s).unwrap().tangent, path.face(s), up);
        (s, area(pass, s, period) / at.max_pool_mm2(enclosed))
    };
    (0..=PLACES).map(one).collect()
}

fn found(machine: &Machine, motion: &PassMotion, path: &dyn TorchPath, pass: &Pass, period: f64) -> Vec<Finding> {
    let mut weld = WeldMotion { passes: vec![motion.clone()], ..WeldMotion::default() };
    // The second pass is not planned, but lies on the first.
    weld.check_pools(None, machine, &[(path, pass), (path, pass)], Some(period));
    weld.findings
}

#[test]
fn beads_larger_than_their_position_holds_are_reported_where_they_are() {
    let (mut some, mut none) = (0, 0);
    for (job, machine) in [
        (include_str!("../../../../examples/thick-saddle.toml"), "saddle-4axis"),
        (include_str!("../../../../examples/hillside.toml"), "torch-5axis"),
    ] {
        let (welding, machine) = (read(job), shipped_machine(machine));
        let last = welding.program.value.passes.len() - 1;
        let of_beads: Vec<usize> = (0..=last).filter(|i| welding.program.value.passes[*i].bead.is_some()).collect();
        // The lowest bead, and two of the cap.
        for i in [of_beads[0], of_beads[of_beads.len() - 2], of_beads[of_beads.len() - 1]] {
            let path = welding.path(i);
            let period = welding.seam.as_ref().unwrap().length();
            let mut pass = welding.program.value.passes[i].clone();
            pass.weave = None;
            let motion = PassMotion::plan(&machine, &path, &pass, 1).unwrap_or_else(|f| panic!("{f:?}"));
            for factor in [0.2, 1.0, 2.0, 3.0, 6.0] {
                let mut scaled = pass.clone();
                let areas = &mut scaled.bead.as_mut().unwrap().area_mm2;
                areas.iter_mut().for_each(|a| *a = NonNegative::new(factor * a.get()).unwrap());
                let findings = found(&machine, &motion, &path, &scaled, period);
                let parts = parts(&machine, &motion, &path, &scaled, period);
                let step = path.length() / 120.0;
                let beyond = |limit: f64| parts.iter().filter(move |p| p.1 > limit).map(|p| p.0);
                let Some(finding) = findings.first() else {
                    assert!(beyond(1.0 + 2.0 * ROUNDING).count() < 2 * PLACES / 120, "{i} {factor}");
                    none += 1;
                    continue;
                };
                some += 1;
                assert!(findings.len() == 1 && finding.kind == "pool" && finding.allowed && finding.pass == 1);
                let range = PathRange { from_mm: finding.from_mm, to_mm: finding.to_mm };
                let outside = |s: &f64| *s < range.from_mm - step || *s > range.to_mm + step;
                assert!(!beyond(1.0 + 2.0 * ROUNDING).any(|s| outside(&s)), "{i} {factor}: {range:?}");
                for s in [range.from_mm, range.to_mm] {
                    assert!(beyond(1.0).any(|at| (at - s).abs() <= 2.0 * path.length() / PLACES as f64), "{s}");
                }
                let worst = number(&finding.message, "area") / number(&finding.message, "max");
                let most = parts.iter().map(|p| p.1).fold(0.0, f64::max);
                assert!(worst <= most * 1.001 && worst > 0.9 * most, "{i} {factor}: {worst} of {most}");
            }
        }
    }
    assert!(some >= 4 && none >= 4, "{some} {none}");
}
