//! What the axes allow along a path, and how to say where they do not.

use crate::JointPath;
use seamwright_machine::Machine;
use seamwright_program::{Finding, OnLimit};

/// Which limit of which axis bounds the speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bound {
    /// Index of the axis.
    pub axis: usize,
    /// True if its acceleration bounds, false if its speed.
    pub acceleration: bool,
}

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

/// The highest steady speed (mm/s) that every axis allows at `s`, and what bounds it.
pub(crate) fn steady_speed(machine: &Machine, path: &JointPath, s: f64, before: bool) -> (f64, Bound) {
    let p = path.point(s, before);
    let mut best = (f64::INFINITY, Bound { axis: 0, acceleration: false });
    for (i, axis) in machine.axes.iter().enumerate() {
        let by_speed = axis.max_speed / p.d1[i].abs();
        let by_acceleration = (axis.max_acceleration / p.d2[i].abs()).sqrt();
        for (v, acceleration) in [(by_speed, false), (by_acceleration, true)] {
            if v < best.0 {
                best = (v, Bound { axis: i, acceleration });
            }
        }
    }
    best
}

/// Where an axis cannot keep the asked speed, and which speed it could hold.
pub(crate) fn speed_findings(
    machine: &Machine,
    path: &JointPath,
    asked: &dyn Fn(f64) -> f64,
    on_limit: OnLimit,
    pass: usize,
) -> Vec<Finding> {
    let places = 4000;
    let mut runs = Runs::default();
    let mut everywhere = f64::INFINITY;
    for i in 0..=places {
        let s = path.length() * f64::from(i) / f64::from(places);
        let (v, bound) = steady_speed(machine, path, s, false);
        everywhere = everywhere.min(v);
        let too_slow = (v < asked(s) * (1.0 - 1e-9)).then(|| {
            let axis = &machine.axes[bound.axis];
            let what = if bound.acceleration { "acceleration" } else { "speed" };
            let limit = axis.to_file(if bound.acceleration { axis.max_acceleration } else { axis.max_speed });
            let per = if bound.acceleration { "/s^2" } else { "/s" };
            let message = format!(
                "axis {} cannot keep {:.3} mm/s: its {what} limit of {limit:.3} {}{per} allows {v:.3} mm/s",
                axis.name,
                asked(s),
                axis.unit()
            );
            (bound.axis, asked(s) - v, message)
        });
        runs.add(s, too_slow);
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
    pub(crate) worst: f64,
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
