//! What the axes allow along a path, and how to say where they do not.

use crate::SpeedLaw;
use crate::law::{Bound, Certificate, Interval};
use seamwright_machine::Machine;
use seamwright_program::{Finding, OnLimit, Pass};

/// An axis asked for exactly its limit falls short by the law's reserve only: that is no finding.
const WORTH_SAYING: f64 = 2e-3;

/// A limit in words: which axis, which of its limits, how much that is.
pub(crate) fn limit(machine: &Machine, bound: Bound) -> Option<(usize, String)> {
    let (i, what, value, per) = match bound {
        Bound::Asked => return None,
        Bound::Speed(i) => (i, "speed", machine.axes[i].max_speed, "/s"),
        Bound::Acceleration(i) => (i, "acceleration", machine.axes[i].max_acceleration, "/s^2"),
        Bound::Jerk(i) => (i, "jerk", machine.axes[i].jerk(), "/s^3"),
    };
    let axis = &machine.axes[i];
    Some((i, format!("its {what} limit of {:.3} {}{per}", axis.to_file(value), axis.unit())))
}

/// Where the tip is slower than asked between run-up and run-down, and what keeps it from being faster.
pub(crate) fn speed_findings(machine: &Machine, certificate: &Certificate, pass: &Pass, number: usize) -> Vec<Finding> {
    let mut runs: Vec<Vec<&Interval>> = vec![Vec::new()];
    for interval in &certificate.intervals {
        let slow = interval.bound != Bound::Asked && interval.between;
        match runs.last_mut() {
            Some(run) if slow => run.push(interval),
            _ => runs.push(Vec::new()),
        }
    }
    let asked = |s: f64| pass.span_at(s).map_or(0.0, |span| span.speed_mm_s.get());
    let finding = |run: &Vec<&Interval>| {
        let slowest = run.iter().min_by(|a, b| a.speed.0.total_cmp(&b.speed.0))?;
        let (wanted, reached) = (asked(slowest.least_at), slowest.speed.0);
        if reached > wanted * (1.0 - WORTH_SAYING) {
            return None;
        }
        let (axis, limit) = limit(machine, slowest.bound)?;
        Some(Finding {
            kind: "speed",
            message: format!(
                "axis {} cannot keep {wanted:.3} mm/s: {limit} allows {reached:.3} mm/s",
                machine.axes[axis].name
            ),
            pass: number,
            from_mm: run[0].from,
            to_mm: run[run.len() - 1].to,
            cure: match pass.on_limit {
                OnLimit::Refuse => format!(
                    "ask for {:.3} mm/s, which every axis can keep everywhere, or set weld.on_limit = \"slow\" to slow down there",
                    // Rounded down, so that the number printed can be asked for.
                    (certificate.everywhere * 1e3).floor() * 1e-3
                ),
                OnLimit::Slow => "none needed: the weld slows down there, as asked".to_owned(),
            },
            allowed: pass.on_limit == OnLimit::Slow,
        })
    };
    runs.iter().filter_map(finding).collect()
}

/// A weld too short to reach the asked speed at all.
pub(crate) fn never_reached(law: &SpeedLaw, asked: f64, on_limit: OnLimit, pass: usize) -> Option<Finding> {
    let band = law.report();
    let reached = band.greatest;
    (reached < asked * (1.0 - WORTH_SAYING) && band.run_up_end >= band.run_down_start).then(|| Finding {
        kind: "speed",
        message: format!(
            "the weld is too short: between run-up and run-down it reaches {reached:.3} of {asked:.3} mm/s"
        ),
        pass,
        from_mm: 0.0,
        to_mm: band.run_up_end,
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
