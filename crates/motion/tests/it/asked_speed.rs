//! A requested speed that changes along the pass: the profile follows it on a pass of any length, a binding limit is
//! always used up, and a lower speed is offered only if it helps.

use crate::number;
use crate::planning::{machine_of, read, shipped_machine};
use crate::{planning, positive};
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_motion::speed_profile::Bound;
use seamwright_program::{Finding, OnLimit, Pass, Ramp, Severity, Span, SpanValue, TorchPath};
use seamwright_testkit::{Random, cases};
use seamwright_weld::Welding;

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");

/// The saddle's pass with a speed that is linear between `(path length, mm; speed, mm/s)`, as a weld on its machine.
struct Case {
    welding: Welding,
    machine: Machine,
}

impl Case {
    fn new(speeds: &[(f64, f64)], on_limit: OnLimit) -> Self {
        let one = read(SADDLE);
        let mut program = one.program.value.clone();
        let pass = &mut program.passes[0];
        let process = pass.spans[0].process.clone();
        let length = one.seam.as_ref().unwrap().length();
        let mut places = speeds.to_vec();
        places.push((length, speeds[speeds.len() - 1].1));
        pass.spans = places
            .windows(2)
            .filter(|w| w[1].0 > w[0].0)
            .map(|w| Span {
                from_mm: seamwright_document::NonNegative::new(w[0].0).unwrap(),
                to_mm: positive(w[1].0),
                speed_mm_s: match w[0].1.total_cmp(&w[1].1).is_eq() {
                    true => SpanValue::Steady(positive(w[0].1)),
                    false => SpanValue::Ramp(Ramp { from: positive(w[0].1), to: positive(w[1].1) }),
                },
                process: process.clone(),
            })
            .collect();
        pass.on_limit = on_limit;
        program.procedure = None;
        let welding = read(&program.to_toml().unwrap());
        let machine = machine_of(&welding);
        Self { welding, machine }
    }

    fn pass(&self) -> &Pass {
        &self.welding.program.value.passes[0]
    }

    fn plan(&self) -> Result<PassMotion, Vec<Finding>> {
        planning::plan(&self.machine, &self.welding)
    }
}

fn speed_findings(findings: &[Finding]) -> Vec<&Finding> {
    findings.iter().filter(|f| f.kind == "speed").collect()
}

/// Missing a valley of the requested speed, a few millimetres wide, costs almost no time on a seam of one and a half
/// metres. The profile must follow it nevertheless. Bends that every axis can follow are no findings.
#[test]
fn a_bend_of_the_asked_speed_is_followed_on_a_long_weld() {
    for (low, way) in [(4.4, 2.5), (2.0, 5.0), (5.8, 1.0), (3.0, 12.0)] {
        follows(Valley { at: 700.0, before: 6.0, low, way });
    }
}

/// Also at any path length, and in any valley up to 0.5 mm/s per millimetre.
#[test]
fn any_bend_of_the_asked_speed_is_followed() {
    let mut random = Random::of_case(42);
    for _ in 0..cases(24) {
        let before = random.within(3.0, 8.0);
        let low = before * random.within(0.3, 1.0);
        let way = random.within(2.0, 30.0) * (before - low) + 0.5;
        follows(Valley { at: random.within(50.0, 1150.0), before, low, way });
    }
}

fn follows(valley: Valley) {
    let Valley { at, before, low, way } = valley;
    let speeds =
        [(0.0, before), (at, before), (at + way, low), (at + 2.0 * way, before), (1500.0, before), (1550.0, 5.0)];
    let case = Case::new(&speeds, OnLimit::Refuse);
    let motion = case.plan().unwrap_or_else(|findings| panic!("{valley:?}: {findings:#?}"));
    assert!(speed_findings(&motion.findings).is_empty(), "{valley:?}: {:#?}", motion.findings);
    let mut slowest = f64::INFINITY;
    for set in motion.set_points(1e-3).filter(|set| (20.0..1500.0).contains(&set.profile.s)) {
        slowest = slowest.min(set.profile.v / case.pass().speed_at(set.profile.s));
    }
    assert!(slowest > 1.0 - 4e-3, "{valley:?}: {slowest}");
}

/// A stretch on which the requested speed falls over `way` mm from `before` to `low` mm/s, and rises again over the
/// same distance.
#[derive(Debug, Clone, Copy)]
struct Valley {
    at: f64,
    before: f64,
    low: f64,
    way: f64,
}

/// Beads of a groove that opens and closes, in layers of which some end inside: steep ramps of the speed, and every
/// axis far from its limits.
#[test]
fn ends_of_layers_are_no_findings() {
    let text = include_str!("../../../../tests/data/field-trial/ts_0.toml");
    let welding = read(text);
    let machine = shipped_machine("saddle-4axis");
    let passes = &welding.program.value.passes;
    let changing = passes.iter().filter(|pass| pass.spans.iter().any(|span| span.speed_mm_s.is_ramp())).count();
    assert!(changing > 3, "{changing}");
    for (i, pass) in passes.iter().enumerate() {
        let planned = PassMotion::plan(&machine, &welding.path(i), pass, i + 1);
        let findings = planned.map_or_else(|findings| findings, |motion| motion.findings);
        assert!(speed_findings(&findings).is_empty(), "{}: {findings:#?}", pass.name);
    }
}

/// A binding limit of the certificate is used up there, or in the stretches before or after with changing speed.
#[test]
fn no_limit_is_blamed_that_is_not_used_up() {
    let cases: [&[(f64, f64)]; 4] = [
        &[(0.0, 6.0), (400.0, 6.0), (402.0, 3.0), (410.0, 7.0)],
        &[(0.0, 40.0), (300.0, 40.0), (301.0, 12.0), (500.0, 60.0)],
        &[(0.0, 200.0)],
        &[(0.0, 20.0), (500.0, 20.0), (500.5, 80.0), (900.0, 25.0)],
    ];
    for speeds in cases {
        let case = Case::new(speeds, OnLimit::Slow);
        let motion = case.plan().unwrap_or_else(|findings| panic!("{findings:#?}"));
        let axes = &case.machine.axes;
        let used = |bound: Bound, (from, to): (f64, f64)| -> f64 {
            let mut most = 0.0f64;
            for cell in 0..motion.profile.cells() {
                for part in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let p = motion.profile.in_cell(cell, part);
                    if p.s < from - 1e-9 || p.s > to + 1e-9 {
                        continue;
                    }
                    let joint = motion.path.point(p.s, part > 0.5);
                    let (v, a, j) = (p.v, p.a, p.j);
                    let here = |i: usize| [joint.d1[i], joint.d2[i], joint.d3[i]];
                    most = most.max(match bound {
                        Bound::Speed(i) => (here(i)[0] * v / axes[i].max_speed).abs(),
                        Bound::Acceleration(i) => {
                            let [q1, q2, _] = here(i);
                            ((q2 * v * v + q1 * a) / axes[i].max_acceleration).abs()
                        }
                        Bound::Jerk(i) => {
                            let [q1, q2, q3] = here(i);
                            ((q3 * v.powi(3) + 3.0 * q2 * v * a + q1 * j) / axes[i].jerk()).abs()
                        }
                        Bound::Asked | Bound::Change => 1.0,
                    });
                }
            }
            most
        };
        let intervals = &motion.certificate.intervals;
        for (k, interval) in intervals.iter().enumerate() {
            if matches!(interval.bound, Bound::Asked | Bound::Change) {
                continue;
            }
            let slowed = |i: &&seamwright_motion::speed_profile::Interval| i.bound != Bound::Asked;
            let from = intervals[..=k].iter().rev().take_while(slowed).last().unwrap().from;
            let to = intervals[k..].iter().take_while(slowed).last().unwrap().to;
            let used = used(interval.bound, (from, to));
            assert!(used > 0.85, "{speeds:?}: {interval:?} uses {used}");
        }
    }
}

#[test]
fn a_lower_speed_is_offered_only_where_it_helps() {
    let cases: [&[(f64, f64)]; 4] = [
        &[(0.0, 200.0)],
        &[(0.0, 40.0), (700.0, 40.0), (700.2, 8.0), (900.0, 40.0)],
        &[(0.0, 20.0), (500.0, 20.0), (500.01, 60.0)],
        &[(0.0, 60.0), (400.0, 160.0), (1000.0, 60.0)],
    ];
    let mut offered = 0;
    for speeds in cases {
        let findings = match Case::new(speeds, OnLimit::Refuse).plan() {
            Ok(_) => continue,
            Err(findings) => findings,
        };
        for finding in speed_findings(&findings) {
            let cure = finding.cure.as_ref().unwrap_or_else(|| panic!("{finding:#?}"));
            let part = match &*cure.code {
                "motion-cure-speed" | "motion-cure-speed-at-most" => number(cure, "speed") / speeds[0].1,
                "motion-cure-speed-part" => 0.01 * number(cure, "part"),
                _ => continue,
            };
            assert!(part < 1.0, "{finding:#?}");
            let lower: Vec<(f64, f64)> = speeds.iter().map(|(s, v)| (*s, part * v)).collect();
            let planned = Case::new(&lower, OnLimit::Refuse).plan();
            assert!(planned.is_ok(), "{speeds:?}: {}: {:#?}", finding.cure_text(), planned.err());
            offered += 1;
        }
    }
    assert!(offered > 0);
}

#[test]
fn no_finding_has_a_cure_that_is_none() {
    let slow = Case::new(&[(0.0, 200.0)], OnLimit::Slow).plan().unwrap();
    let refused = Case::new(&[(0.0, 200.0)], OnLimit::Refuse).plan().unwrap_err();
    let notes = speed_findings(&slow.findings);
    assert!(!notes.is_empty() && notes.iter().all(|f| f.severity() == Severity::Note), "{:#?}", slow.findings);
    assert!(refused.iter().all(|f| f.cure.is_some()), "{refused:#?}");
    assert!(slow.path.length() > 0.0 && Case::new(&[(0.0, 5.0)], OnLimit::Refuse).welding.path(0).length() > 0.0);
}

/// Excessive times are refused with their key before planning, which would never end.
#[test]
fn times_that_no_weld_takes_are_refused() {
    let refused = |from: &str, to: &str, key: &str| {
        assert!(SADDLE.contains(from), "{from}");
        let error = Welding::read("job.toml", &SADDLE.replace(from, to)).unwrap_err().to_string();
        assert!(error.contains(key), "{to}: {error}");
        error
    };
    for key in ["preflow_s = 0.5", "travel_delay_s = 0.3", "crater_s = 0.8", "postflow_s = 3"] {
        let name = key.split(' ').next().unwrap();
        refused(key, &format!("{name} = 1e6"), &format!("sequence.{name}"));
    }
    // Below the minimum of any file, and days along this seam.
    refused("speed_mm_s = 10", "speed_mm_s = 1e-9", "weld.speed_mm_s");
    let slow = refused("speed_mm_s = 10", "speed_mm_s = 0.01", "weld.speed_mm_s");
    assert!(slow.contains("would travel for"), "{slow}");
    // The maximum speed in a file is bounded by the axes, and costs no more than others.
    let fast = Case::new(&[(0.0, 1e5)], OnLimit::Slow).plan().unwrap();
    assert!(fast.profile.cells() < 20_000 && fast.profile.duration() > 1.0, "{}", fast.profile.cells());
}
