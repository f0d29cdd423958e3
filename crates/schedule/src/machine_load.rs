//! Load of the machines: list scheduling of parts, longest first (Graham 1969, LPT rule).

use serde::Serialize;
use std::collections::BTreeMap;

/// One part to be welded.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// Name of its row.
    pub name: String,
    /// Time to set it up, s.
    pub setup_s: f64,
    /// Time on each machine that can weld it, s.
    pub times: BTreeMap<String, f64>,
}

/// A machine with its parts in order.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineLoad {
    /// Its name.
    pub machine: String,
    /// Its parts in order.
    pub parts: Vec<Occupation>,
    /// End of its last part, s.
    pub end_s: f64,
}

/// A machine occupied by one part, from the beginning of its set-up.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Occupation {
    /// Name of the part's row.
    pub name: String,
    /// Beginning of the set-up, s.
    pub from_s: f64,
    /// Beginning of the weld, s.
    pub weld_s: f64,
    /// End, s.
    pub to_s: f64,
}

/// Distributes parts over machines: the longest first, each to the machine that is done with it the earliest. On
/// equal machines the last one is done at most a third later than in the best distribution.
pub fn machine_load(mut tasks: Vec<Task>) -> Vec<MachineLoad> {
    let longest = |task: &Task| task.setup_s + task.times.values().copied().fold(f64::INFINITY, f64::min);
    tasks.retain(|task| !task.times.is_empty());
    tasks.sort_by(|a, b| longest(b).total_cmp(&longest(a)).then_with(|| a.name.cmp(&b.name)));
    let mut loads: BTreeMap<String, MachineLoad> = BTreeMap::new();
    for task in tasks {
        let end = |machine: &String| loads.get(machine).map_or(0.0, |load: &MachineLoad| load.end_s);
        let done = |(machine, time): &(&String, &f64)| end(machine) + task.setup_s + **time;
        let Some((machine, time)) = task.times.iter().min_by(|a, b| done(a).total_cmp(&done(b))) else { continue };
        let from_s = end(machine);
        let (weld_s, to_s) = (from_s + task.setup_s, from_s + task.setup_s + time);
        let load = loads.entry(machine.clone()).or_insert_with(|| MachineLoad {
            machine: machine.clone(),
            parts: Vec::new(),
            end_s: 0.0,
        });
        load.parts.push(Occupation { name: task.name.clone(), from_s, weld_s, to_s });
        load.end_s = to_s;
    }
    loads.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::{Random, cases};

    fn task(name: usize, times: &[(usize, f64)]) -> Task {
        let times = times.iter().map(|(machine, s)| (format!("m{machine}"), *s)).collect();
        Task { name: format!("{name:03}"), setup_s: 0.0, times }
    }

    /// The end of the last machine in the best of all distributions.
    fn best(times: &[f64], machines: usize) -> f64 {
        let mut best = f64::INFINITY;
        for code in 0..machines.pow(times.len() as u32) {
            let mut ends = vec![0.0; machines];
            let mut rest = code;
            for t in times {
                ends[rest % machines] += t;
                rest /= machines;
            }
            best = best.min(ends.iter().copied().fold(0.0, f64::max));
        }
        best
    }

    #[test]
    fn every_part_is_welded_once_and_the_end_is_near_the_best() {
        let mut random = Random::new(48);
        for _ in 0..cases(300) {
            let machines = 2 + random.below(2);
            let times: Vec<f64> = (0..3 + random.below(6)).map(|_| random.within(1.0, 50.0)).collect();
            let everywhere = |t: &f64| (0..machines).map(|m| (m, *t)).collect::<Vec<_>>();
            let tasks = times.iter().enumerate().map(|(i, t)| task(i, &everywhere(t))).collect();
            let loads = machine_load(tasks);
            let mut names: Vec<&String> = loads.iter().flat_map(|load| load.parts.iter().map(|p| &p.name)).collect();
            names.sort();
            assert_eq!(names.len(), times.len());
            names.dedup();
            assert_eq!(names.len(), times.len());
            for load in &loads {
                assert!(load.parts.windows(2).all(|w| (w[0].to_s - w[1].from_s).abs() < 1e-9));
            }
            let end = loads.iter().map(|load| load.end_s).fold(0.0, f64::max);
            // Graham's bound for the longest first on equal machines.
            let bound = 4.0 / 3.0 - 1.0 / (3.0 * machines as f64);
            assert!(end <= bound * best(&times, machines) + 1e-9, "{times:?}");
        }
    }

    #[test]
    fn a_part_goes_only_to_a_machine_that_can_weld_it() {
        let loads = machine_load(vec![
            task(1, &[(0, 10.0)]),
            task(2, &[(0, 10.0)]),
            task(3, &[(0, 9.0), (1, 30.0)]),
            task(4, &[]),
        ]);
        let on = |machine: &str| loads.iter().find(|l| l.machine == machine).map_or(0, |l| l.parts.len());
        assert_eq!((on("m0"), on("m1")), (3, 0));
    }
}
