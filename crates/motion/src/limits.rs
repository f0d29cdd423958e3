//! What the axes allow along a path, and how to say where they do not.

use crate::{JointPath, SpeedLaw};
use seamwright_machine::Machine;
use seamwright_program::{Finding, OnLimit};

/// The planned speed away from run-up and run-down: the certificate of the band that is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedReport {
    /// Path length where the run-up ends, mm.
    pub run_up_end: f64,
    /// Path length where the run-down begins, mm.
    pub run_down_start: f64,
    /// Least planned speed between them, mm/s.
    pub least: f64,
    /// Greatest planned speed between them, mm/s.
    pub greatest: f64,
}

/// Which limit of which axis bounds the steady speed at `s`: the axis, and true if it is its acceleration.
fn binding(machine: &Machine, path: &JointPath, s: f64, before: bool) -> (usize, bool) {
    let p = path.point(s, before);
    let mut best = (f64::INFINITY, 0, false);
    for (i, axis) in machine.axes.iter().enumerate() {
        let by_speed = axis.max_speed / p.d1[i].abs();
        let by_acceleration = (axis.max_acceleration / p.d2[i].abs()).sqrt();
        for (v, acceleration) in [(by_speed, false), (by_acceleration, true)] {
            if v < best.0 {
                best = (v, i, acceleration);
            }
        }
    }
    (best.1, best.2)
}

/// Where an axis cannot keep the asked speed, and which speed it could hold: exactly where the law slows down for it.
pub(crate) fn speed_findings(
    machine: &Machine,
    path: &JointPath,
    law: &SpeedLaw,
    on_limit: OnLimit,
    pass: usize,
) -> Vec<Finding> {
    let everywhere = law.everywhere;
    let mut runs = Runs::default();
    // Places farther apart than this along the path are runs of their own.
    let gap = path.length() / 400.0;
    let mut last = f64::NEG_INFINITY;
    for slow in &law.slow {
        if slow.s > last + gap {
            runs.add(last, None);
        }
        last = slow.s;
        let (index, acceleration) = binding(machine, path, slow.s, slow.cell_end);
        let axis = &machine.axes[index];
        let what = if acceleration { "acceleration" } else { "speed" };
        let limit = axis.to_file(if acceleration { axis.max_acceleration } else { axis.max_speed });
        let per = if acceleration { "/s^2" } else { "/s" };
        let message = format!(
            "axis {} cannot keep {:.3} mm/s: its {what} limit of {limit:.3} {}{per} allows {:.3} mm/s",
            axis.name,
            slow.asked,
            axis.unit(),
            slow.holds
        );
        runs.add(slow.s, Some((index, slow.asked - slow.holds, message)));
    }
    runs.findings(|run| Finding {
        kind: "speed",
        message: run.message.clone(),
        pass,
        from_mm: run.from,
        to_mm: run.to,
        cure: match on_limit {
            OnLimit::Refuse => format!(
                "ask for {:.3} mm/s, which every axis can keep everywhere, or set weld.on_limit = \"slow\" to slow down there",
                // Rounded down, so that the number printed can be asked for.
                (everywhere * 1e3).floor() * 1e-3
            ),
            OnLimit::Slow => "none needed: the weld slows down there, as asked".to_owned(),
        },
        allowed: on_limit == OnLimit::Slow,
    })
}

/// A weld too short to reach the asked speed at all.
pub(crate) fn never_reached(law: &SpeedLaw, asked: f64, on_limit: OnLimit, pass: usize) -> Option<Finding> {
    let reached = law.report().greatest;
    (reached < asked * (1.0 - 1e-6) && law.slow.is_empty()).then(|| Finding {
        kind: "speed",
        message: format!(
            "the weld is too short: between run-up and run-down it reaches {reached:.3} of {asked:.3} mm/s"
        ),
        pass,
        from_mm: 0.0,
        to_mm: law.report().run_up_end,
        cure: format!("ask for {:.3} mm/s or less, or set weld.on_limit = \"slow\"", (reached * 1e3).floor() * 1e-3),
        allowed: on_limit == OnLimit::Slow,
    })
}

/// Joins neighbouring places with the same complaint into runs, keeping the worst message of each.
#[derive(Default)]
pub(crate) struct Runs {
    runs: Vec<Run>,
    open: bool,
}

/// A stretch of the path with one complaint.
pub(crate) struct Run {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) message: String,
    key: usize,
    worst: f64,
}

impl Runs {
    /// Adds the next place: nothing, or a complaint as (key, how bad, message).
    pub(crate) fn add(&mut self, s: f64, complaint: Option<(usize, f64, String)>) {
        let Some((key, worst, message)) = complaint else {
            self.open = false;
            return;
        };
        match self.runs.last_mut().filter(|r| self.open && r.key == key) {
            Some(run) => {
                run.to = s;
                if worst > run.worst {
                    (run.worst, run.message) = (worst, message);
                }
            }
            None => self.runs.push(Run { from: s, to: s, message, key, worst }),
        }
        self.open = true;
    }

    pub(crate) fn findings(&self, make: impl Fn(&Run) -> Finding) -> Vec<Finding> {
        self.runs.iter().map(make).collect()
    }
}
