//! Totals of all passes: lengths, times, arc energy, wire.

use super::figures::PassFigures;
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{ArcTime, Pass};
use serde::Serialize;

/// Number of instants for integrating process values while the arc is on; a ramp of a tenth of it is exact to 0.01 %.
const INSTANTS: u32 = 4000;

/// Sums over all passes; mm, s.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TotalsFigures {
    /// Number of passes, including tacks.
    pub passes: usize,
    /// Length of all passes together, mm.
    pub length_mm: f64,
    /// Travel time, s.
    pub weld_s: f64,
    /// Time with the arc (or beam) on, s.
    pub arc_on_s: f64,
    /// Time of the transfer moves, s.
    pub air_s: f64,
    /// Time from home to home, s.
    pub total_s: f64,
    /// Arc energy U I t, kJ; `None` if a pass with an arc has no current or voltage.
    pub arc_energy_kj: Option<f64>,
    /// Length of wire, m; `None` if a pass with an arc has no wire feed.
    pub wire_m: Option<f64>,
}

impl TotalsFigures {
    pub(super) fn new(passes: &[PassFigures], motion: &WeldMotion) -> Self {
        let sum = |of: fn(&PassFigures) -> f64| passes.iter().map(of).sum();
        Self {
            passes: passes.len(),
            length_mm: sum(|p| p.plan.length_mm),
            weld_s: sum(|p| p.plan.weld_s),
            arc_on_s: sum(|p| p.plan.arc_on_s),
            air_s: motion.air_s(),
            total_s: motion.total_s(),
            arc_energy_kj: passes.iter().map(|p| p.arc_energy_kj).sum(),
            wire_m: passes.iter().map(|p| p.wire_m).sum(),
        }
    }
}

/// Returns the arc energy U I t of one pass, kJ: zero without an arc, `None` without current and voltage.
pub(super) fn arc_energy_kj(pass: &Pass, motion: &PassMotion) -> Option<f64> {
    let watts = |name: &dyn Fn(&str) -> Option<f64>| Some(name("current_a")? * name("voltage_v")?);
    Some(while_arc_is_on(pass, motion, watts)? / 1000.0)
}

/// Returns the wire of one pass, m: zero without an arc, `None` without a wire feed.
pub(super) fn wire_m(pass: &Pass, motion: &PassMotion) -> Option<f64> {
    let metres_per_minute = |name: &dyn Fn(&str) -> Option<f64>| name("wire_feed_m_min");
    Some(while_arc_is_on(pass, motion, metres_per_minute)? / 60.0)
}

/// Integrates `rate` of the process values over the time with the arc on.
fn while_arc_is_on(
    pass: &Pass,
    motion: &PassMotion,
    rate: impl Fn(&dyn Fn(&str) -> Option<f64>) -> Option<f64>,
) -> Option<f64> {
    let arc_on = motion.arc_on_s();
    if arc_on <= 0.0 {
        return Some(0.0);
    }
    let step = arc_on / f64::from(INSTANTS);
    let mut cursor = 0;
    let instants = (0..INSTANTS).map(|i| {
        let since_on = (f64::from(i) + 0.5) * step;
        let travelled = (since_on - motion.sequence.travel_delay_s.get()).clamp(0.0, motion.profile.duration());
        let s = motion.profile.at(travelled, &mut cursor).s;
        let time = ArcTime { since_on_s: since_on, until_off_s: arc_on - since_on };
        Some(rate(&|name| pass.process_at(name, s, time))? * step)
    });
    instants.sum()
}
