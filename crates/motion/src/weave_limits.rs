//! Maximum frequency of a weave if the axes cannot keep the requested speed with it.
//!
//! With the centre line at its requested speed, the use of the limits by a weave repeats from swing to swing and
//! changes only as slowly as the seam. So a few windows of one swing each show feasibility and maximum frequency at a
//! small fraction of the cost of a plan. The result is then verified by one whole plan before it is reported.

use crate::effort::Effort;
use crate::follower::Follower;
use crate::joint_path::JointPath;
use crate::pass_channels::PassChannels;
use crate::planned::Planned;
use crate::speed_findings::{Binding, keeps_speed};
use crate::speed_profile::{Bound, Certificate, Channels, SpeedProfile};
use crate::stretch::Stretch;
use seamwright_machine::{AxisLimits, Joints};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, OnLimit, Pass};
use std::cell::Cell;

/// Relative accuracy of the maximum frequency.
const CLOSE: f64 = 2e-3;
/// Minimum factor of the requested frequency that is tried.
const MIN_FACTOR: f64 = 0.02;
/// Windows along the pass, and swings in each.
const WINDOWS: usize = 24;
const SWINGS: f64 = 1.1;
/// Samples in every panel of a window.
const PLACES: u32 = 8;
/// Steps in which the axes are followed from window to window.
const STEPS: usize = 20;
/// Maximum use of the limits by a weave in the windows; the rest is the profile's reserve.
const USED: f64 = 0.997;
/// Use of a limit above which the whole pass is certainly infeasible.
const TOO_MUCH: f64 = 1.02;
/// Units of effort of a window at one frequency, and of a whole plan.
const WINDOW_WORK: u64 = 150;
const PLAN_WORK: u64 = 6000;
/// Effort of a usual search, the reference of its progress.
const USUAL_WORK: f64 = 12.0 * WINDOW_WORK as f64 * WINDOWS as f64 + PLAN_WORK as f64;
/// Factors of the frequency found in the windows that are planned as a whole until one can be kept.
const PLANNED: [f64; 3] = [1.0, 0.97, 0.9];

/// A pass that weaves, as a machine follows it.
pub(crate) struct Woven<'a> {
    follower: Follower<'a>,
    start: &'a Joints,
    pass: &'a Pass,
    windows: Vec<Window>,
    effort: &'a Effort<'a>,
    spent: Cell<u64>,
}

/// A part of the pass, one swing long.
struct Window {
    /// Path length of its middle, mm.
    middle: f64,
    near: Joints,
}

/// A station with a steady speed of the centre line there.
#[derive(Clone, Copy)]
struct Station {
    at: f64,
    /// Speed by path length, mm/s.
    speed: f64,
}

/// Maximum use of a limit.
#[derive(Clone, Copy)]
struct Used {
    /// Used fraction of the limit at the requested speed of the centre line.
    part: f64,
    bound: Bound,
    at: f64,
    /// Fraction of the requested speed at which the limit would be just used up.
    holds: f64,
}

impl<'a> Woven<'a> {
    /// None if the pass does not weave, or is hardly longer than its weave needs to widen and narrow.
    pub(crate) fn new(
        follower: Follower<'a>,
        start: &'a Joints,
        pass: &'a Pass,
        effort: &'a Effort<'a>,
    ) -> Option<Self> {
        let weave = pass.weave.as_ref()?;
        let length = follower.path.length();
        let fade = weave.fade_mm.get();
        let (from, to) = (fade, length - fade);
        if to - from <= 0.1 * length {
            return None;
        }
        let line = follower.path.weave()?.slower(0.0);
        let line = Follower { path: &*line, ..follower };
        let mut windows = Vec::with_capacity(WINDOWS);
        let (mut q, mut here) = (*start, 0.0);
        for k in 0..WINDOWS {
            if !effort.spend(STEPS as u64, 0.0) {
                return None;
            }
            let middle = from + (to - from) * (k as f64 + 0.5) / WINDOWS as f64;
            for step in 1..=STEPS {
                let s = here + (middle - here) * step as f64 / STEPS as f64;
                q = line.near(s, &q).ok()?.joints;
            }
            here = middle;
            windows.push(Window { middle, near: q });
        }
        Some(Self { follower, start, pass, windows, effort, spent: Cell::new(0) })
    }

    /// Counts `work` more units. Returns false if planning is stopped.
    fn spend(&self, work: u64) -> bool {
        self.spent.set(self.spent.get() + work);
        self.effort.spend(work, (self.spent.get() as f64 / USUAL_WORK).min(1.0))
    }

    /// Finding for a requested weave that is certainly too fast for the requested speed; planning can then stop.
    pub(crate) fn too_fast(&self, number: usize) -> Option<Finding> {
        if self.pass.on_limit != OnLimit::Refuse {
            return None;
        }
        let all: Vec<Used> = self.used(1.0)?;
        let over: Vec<&Used> = all.iter().filter(|used| used.part > TOO_MUCH).collect();
        let worst = over.iter().min_by(|a, b| a.holds.total_cmp(&b.holds))?;
        let factor = self.highest()?;
        let asked = self.pass.speed_at(worst.at);
        let binding = Binding::new(self.follower.machine, worst.bound)?;
        let reached = worst.holds * asked;
        let (message, cure) = self.too_fast_because(binding.cannot_keep(asked, reached), factor)?;
        let range = Stretch { from: over[0].at, to: over[over.len() - 1].at };
        Some(Finding::error("speed", message, number, range, cure))
    }

    /// Replaces the findings of kind `speed` by ones for a weave that is too fast, with its maximum frequency. They
    /// stay unchanged if no slower weave helps.
    pub(crate) fn explain(&self, findings: &mut [Finding]) {
        let too_fast: Vec<&mut Finding> = findings.iter_mut().filter(|f| f.kind == "speed" && !f.allowed).collect();
        if too_fast.is_empty() {
            return;
        }
        if let Some(factor) = self.highest() {
            for finding in too_fast {
                if let Some((message, cure)) = self.too_fast_because(finding.message.clone(), factor) {
                    (finding.message, finding.cure) = (message, Some(cure));
                }
            }
        }
    }

    /// Message of a weave that is too fast for `reason`, and the operator action: a weave `factor` times as fast is
    /// possible.
    fn too_fast_because(&self, reason: Message, factor: f64) -> Option<(Message, Message)> {
        let weave = self.pass.weave.as_ref()?;
        let slower = weave.faster(factor);
        let message =
            |code| Message::new(code).message("reason", reason).value("width", weave.width_mm.get(), Unit::Mm);
        Some(match (slower.frequency_hz.map(f64::from), slower.pitch_mm.map(f64::from)) {
            (Some(frequency), _) => {
                let rounded = (frequency * 1e4).floor() * 1e-4;
                (
                    message("motion-weave-frequency").quantity("frequency", frequency, Unit::Hz, 4),
                    Message::new("motion-cure-weave-frequency").number("frequency", rounded, 4),
                )
            }
            (None, pitch) => {
                let pitch = pitch.unwrap_or_default();
                let rounded = (pitch * 1e4).ceil() * 1e-4;
                (
                    message("motion-weave-pitch").quantity("pitch", pitch, Unit::Mm, 4),
                    Message::new("motion-cure-weave-pitch").number("pitch", rounded, 4),
                )
            }
        })
    }

    /// Maximum factor below 1 of the weave's frequency at which the requested speed can be kept, if any: to [`CLOSE`]
    /// and not above it, by bisection in the windows and a whole plan.
    fn highest(&self) -> Option<f64> {
        let fits = |factor: f64| self.used(factor).is_some_and(|all| all.iter().all(|used| used.part <= USED));
        // The use of most limits by a weave grows with the same power of its frequency as of the speed.
        let guess = self.used(1.0)?.iter().map(|used| used.holds).fold(1.0, f64::min);
        let factor = greatest(guess, fits)?;
        PLANNED.iter().map(|part| part * factor).find(|factor| self.keeps(*factor))
    }

    /// Maximum use of a limit in each window with a weave `factor` times as fast; none if the axes cannot follow.
    fn used(&self, factor: f64) -> Option<Vec<Used>> {
        let slower = self.follower.path.weave()?.slower(factor);
        let follower = Follower { path: &*slower, ..self.follower };
        let used = |window: &Window| {
            let goes_on = self.spend(WINDOW_WORK);
            goes_on.then(|| self.used_in(window, follower, factor)).flatten()
        };
        self.windows.iter().map(used).collect()
    }

    /// Maximum use of a limit in one window by `follower`, which weaves `factor` times as fast.
    fn used_in(&self, window: &Window, follower: Follower, factor: f64) -> Option<Used> {
        let Window { middle, near } = *window;
        let weave = self.pass.weave.as_ref()?.faster(factor);
        let speed = self.pass.speed_at(middle);
        let period = weave.frequency_hz.map_or(weave.pitch_mm.map_or(0.0, f64::from), |hz| speed / hz.get());
        let half = 0.5 * SWINGS * period;
        let range = Stretch { from: (middle - half).max(0.0), to: (middle + half).min(follower.path.length()) };
        let near = follower.near(range.from, &near).ok()?.joints;
        let joints = JointPath::over(follower, &near, range).ok()?;
        let channels = PassChannels::new(follower.machine, &joints, self.pass, 1.0);
        let mut rows = vec![[0.0; 3]; channels.limits().len()];
        let mut most = Used { part: 0.0, bound: Bound::Asked, at: middle, holds: f64::INFINITY };
        let mut edges = joints.edges();
        // The last edge is the end of the pass.
        *edges.last_mut()? = range.to;
        for panel in edges.windows(2) {
            for place in 0..=PLACES {
                let s = panel[0] + (panel[1] - panel[0]) * f64::from(place) / f64::from(PLACES);
                let rate = channels.derivatives(s, place == PLACES, &mut rows);
                let station = Station { at: s, speed: channels.asked(s) / rate };
                most = greater(most, station, &rows, channels.limits());
            }
        }
        Some(most)
    }

    /// True if the pass can be planned at the requested speed with a weave `factor` times as fast; false if planning is
    /// stopped.
    fn keeps(&self, factor: f64) -> bool {
        // The watch is called before and after the plan.
        self.spend(PLAN_WORK / 2) && self.plans(factor) && self.spend(PLAN_WORK / 2)
    }

    fn plans(&self, factor: f64) -> bool {
        let Some(weave) = self.follower.path.weave() else { return false };
        let slower = weave.slower(factor);
        let follower = Follower { path: &*slower, ..self.follower };
        let Ok(joints) = JointPath::new(follower, self.start) else { return false };
        let channels = PassChannels::new(follower.machine, &joints, self.pass, 1.0);
        let Ok(profile) = SpeedProfile::new(&channels) else { return false };
        let (certificate, legs) = (Certificate::new(&channels, &profile), profile.legs());
        let planned = Planned {
            machine: follower.machine,
            joints: &joints,
            profile: &profile,
            certificate: &certificate,
            legs: &legs,
        };
        keeps_speed(planned, self.pass)
    }
}

/// The greater use of a limit: `most`, or that of channels with the derivatives `rows` at a station.
fn greater(most: Used, station: Station, rows: &[[f64; 3]], limits: &[AxisLimits]) -> Used {
    let Station { at, speed } = station;
    rows.iter().zip(limits).enumerate().fold(most, |most, (i, ([q1, q2, q3], limits))| {
        let uses = [
            (q1.abs() * speed / limits.speed, Bound::Speed(i), 1.0),
            (q2.abs() * speed.powi(2) / limits.acceleration, Bound::Acceleration(i), 2.0),
            (q3.abs() * speed.powi(3) / limits.jerk, Bound::Jerk(i), 3.0),
        ];
        uses.into_iter().fold(most, |most, (part, bound, power)| Used {
            part: most.part.max(part),
            ..if part.powf(-1.0 / power) < most.holds {
                Used { part, bound, at, holds: part.powf(-1.0 / power) }
            } else {
                most
            }
        })
    })
}

/// Maximum factor below 1 that fits, if any, to [`CLOSE`] and never above it: about a `guess`, in doubling steps until
/// it is bracketed, then by bisection.
fn greatest(guess: f64, fits: impl Fn(f64) -> bool) -> Option<f64> {
    let mut step = 2.0 * CLOSE;
    let (mut low, mut high) = ((guess.min(1.0) / (1.0 + step)).max(MIN_FACTOR), 1.0);
    if fits(low) {
        while low * (1.0 + step) < 1.0 {
            let next = low * (1.0 + step);
            if !fits(next) {
                high = next;
                break;
            }
            (low, step) = (next, 2.0 * step);
        }
    } else {
        loop {
            if low <= MIN_FACTOR {
                return None;
            }
            (low, high, step) = ((low / (1.0 + step)).max(MIN_FACTOR), low, 2.0 * step);
            if fits(low) {
                break;
            }
        }
    }
    while high > low * (1.0 + CLOSE) {
        let middle = (low * high).sqrt();
        if fits(middle) { low = middle } else { high = middle }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_factor_is_found_from_below() {
        for i in 1..200 {
            let bound = f64::from(i) / 200.0;
            for guess in [1e-9, 0.5 * bound, 0.999 * bound, bound, 1.001 * bound, 3.0 * bound, 1.0] {
                match greatest(guess, |f| f <= bound) {
                    Some(found) => {
                        assert!(found <= bound && found * (1.0 + CLOSE) >= bound, "{guess} {bound}: {found}");
                    }
                    None => assert!(bound < 1.5 * MIN_FACTOR, "{guess} {bound}"),
                }
            }
        }
    }
}
