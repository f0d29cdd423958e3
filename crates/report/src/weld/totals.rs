//! Totals of all passes: lengths, times, energy, weld metal, consumables, cost.

use super::figures::PassFigures;
use seamwright_document::Positive;
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{ArcTime, Consumables, Costs, Pass, Procedure, Program, Role};
use serde::Serialize;

/// Number of instants for integrating process values while the arc is on; a ramp of a tenth of it is exact to 0.01 %.
const INSTANTS: u32 = 4000;
/// Period of the duty cycle of power sources (IEC 60974-1), s.
const DUTY_PERIOD_S: f64 = 600.0;

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
    /// Time of the waits between passes, s.
    pub wait_s: f64,
    /// Time from home to home, s.
    pub total_s: f64,
    /// Part of the time from home to home with the arc on, %.
    pub arc_percent: f64,
    /// Duty cycle of the power source: maximum part of 10 minutes with the arc on (IEC 60974-1), %.
    pub duty_percent: f64,
    /// Arc energy U I t, kJ; `None` if a pass with an arc has no current or voltage.
    pub arc_energy_kj: Option<f64>,
    /// Energy from the mains for it, kWh.
    pub mains_kwh: Option<f64>,
    /// Length of wire, m; `None` if a pass with an arc has no wire feed.
    pub wire_m: Option<f64>,
    /// Mass of wire, kg; `None` also without its diameter.
    pub wire_kg: Option<f64>,
    /// Mass of weld metal, kg.
    pub weld_metal_kg: Option<f64>,
    /// Shielding gas, l; `None` without its flow.
    pub gas_l: Option<f64>,
    /// Flux, kg; `None` without its ratio to the wire.
    pub flux_kg: Option<f64>,
    /// Cost by the rates of the job, if it has any.
    pub cost: Option<CostFigures>,
}

/// Cost of a weld.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CostFigures {
    /// Name of the currency.
    pub currency: String,
    /// Labour.
    pub labour: Option<f64>,
    /// Machine.
    pub machine: Option<f64>,
    /// Wire.
    pub wire: Option<f64>,
    /// Shielding gas.
    pub gas: Option<f64>,
    /// Flux.
    pub flux: Option<f64>,
    /// Energy from the mains.
    pub energy: Option<f64>,
    /// Sum of these.
    pub total: f64,
    /// Rates of the job whose quantity is unknown, so that they are not in the sum.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without: Vec<&'static str>,
}

impl TotalsFigures {
    pub(super) fn new(passes: &[PassFigures], program: &Program, motion: &WeldMotion) -> Self {
        let sum = |of: fn(&PassFigures) -> f64| passes.iter().map(of).sum::<f64>();
        let consumables = &program.consumables;
        let (arc_on_s, total_s) = (sum(|p| p.plan.arc_on_s), motion.total_s());
        let arc_energy_kj: Option<f64> = passes.iter().map(|p| p.arc_energy_kj).sum();
        let wire_kg = passes.iter().map(|p| p.wire_kg).sum::<Option<f64>>();
        let gas_s = passes.iter().filter(|p| p.plan.arc_on_s > 0.0).map(|p| p.plan.total_s).sum::<f64>();
        let mut totals = Self {
            passes: passes.len(),
            length_mm: sum(|p| p.plan.length_mm),
            weld_s: sum(|p| p.plan.weld_s),
            arc_on_s,
            air_s: motion.air_s(),
            wait_s: motion.wait_s(),
            total_s,
            arc_percent: if total_s > 0.0 { 100.0 * arc_on_s / total_s } else { 0.0 },
            duty_percent: duty_percent(&arcs(passes)),
            arc_energy_kj,
            mains_kwh: arc_energy_kj.map(|kj| kj / 3600.0 / consumables.source_efficiency.get()),
            wire_m: passes.iter().map(|p| p.wire_m).sum(),
            wire_kg,
            weld_metal_kg: passes.iter().map(|p| p.weld_metal_kg).sum(),
            gas_l: consumables.gas_l_min.map(|flow| flow.get() * gas_s / 60.0),
            flux_kg: consumables.flux_per_wire.zip(wire_kg).map(|(ratio, wire)| ratio.get() * wire),
            cost: None,
        };
        totals.cost = program.costs.as_ref().map(|costs| totals.cost_by(costs));
        totals
    }

    fn cost_by(&self, costs: &Costs) -> CostFigures {
        let mut without = Vec::new();
        let mut item = |name, rate: Option<Positive>, quantity: Option<f64>| {
            let cost = rate.zip(quantity).map(|(rate, quantity)| rate.get() * quantity);
            if rate.is_some() && cost.is_none() {
                without.push(name);
            }
            cost
        };
        let hours = Some(self.total_s / 3600.0);
        let items = [
            item("labour", costs.labour_per_h, hours),
            item("machine", costs.machine_per_h, hours),
            item("wire", costs.wire_per_kg, self.wire_kg),
            item("gas", costs.gas_per_m3, self.gas_l.map(|litres| litres / 1000.0)),
            item("flux", costs.flux_per_kg, self.flux_kg),
            item("energy", costs.energy_per_kwh, self.mains_kwh),
        ];
        let [labour, machine, wire, gas, flux, energy] = items;
        let total = items.into_iter().flatten().sum();
        CostFigures { currency: costs.currency.clone(), labour, machine, wire, gas, flux, energy, total, without }
    }
}

/// Returns the times at which the arc goes on and off, from home, s.
fn arcs(passes: &[PassFigures]) -> Vec<(f64, f64)> {
    let mut now = 0.0;
    let arc = |pass: &PassFigures| {
        now += pass.air_before_s + pass.wait_before_s;
        let on = now + pass.plan.sequence.preflow_s.get();
        now += pass.plan.total_s;
        (on, on + pass.plan.arc_on_s)
    };
    passes.iter().map(arc).filter(|(on, off)| off > on).collect()
}

/// Returns the maximum part of 10 minutes within these times, which follow one another, %.
fn duty_percent(arcs: &[(f64, f64)]) -> f64 {
    // The maximum is reached where the period begins with an arc, or ends with one.
    let starts = arcs.iter().flat_map(|(on, off)| [*on, off - DUTY_PERIOD_S]);
    let within = |start: f64| {
        let end = start + DUTY_PERIOD_S;
        let first = arcs.partition_point(|(_, off)| *off <= start);
        let there = arcs[first..].iter().take_while(|(on, _)| *on < end);
        there.map(|(on, off)| off.min(end) - on.max(start)).sum::<f64>()
    };
    100.0 * starts.map(within).fold(0.0, f64::max) / DUTY_PERIOD_S
}

/// Diameter of the wire and the part of it that becomes weld metal, of the consumables or the procedure.
pub(super) struct Wire {
    kg_per_m: Option<f64>,
    deposition: Option<f64>,
}

impl Wire {
    pub(super) fn of(consumables: &Consumables, procedure: Option<&Procedure>) -> Self {
        let diameter = consumables.wire_mm.or(procedure.and_then(|p| p.wire_diameter_mm));
        let area = |d: f64| std::f64::consts::FRAC_PI_4 * d * d;
        Self {
            // mm^2 times g/cm^3 is g/m.
            kg_per_m: diameter.map(|d| 1e-3 * area(d.get()) * consumables.wire_g_cm3.get()),
            deposition: consumables.deposition.map(Positive::get).or(procedure.map(Procedure::deposition_efficiency)),
        }
    }

    /// Returns the mass of a length of wire, kg; zero of none.
    pub(super) fn mass_kg(&self, metres: Option<f64>) -> Option<f64> {
        let metres = metres?;
        if metres <= 0.0 { Some(0.0) } else { Some(metres * self.kg_per_m?) }
    }

    /// Returns the mass of weld metal from a mass of wire, kg.
    pub(super) fn weld_metal_kg(&self, wire_kg: Option<f64>) -> Option<f64> {
        let wire_kg = wire_kg?;
        if wire_kg <= 0.0 { Some(0.0) } else { Some(wire_kg * self.deposition?) }
    }
}

/// Returns the mass of the consumable insert that a pass melts along `length` mm, kg.
pub(super) fn insert_kg(program: &Program, pass: &Pass, length: f64) -> f64 {
    let insert = program.joint.as_ref().and_then(|joint| joint.insert.as_ref());
    let Some(insert) = insert.filter(|_| pass.role == Some(Role::Root) && pass.bead.is_some()) else { return 0.0 };
    1e-6 * insert.area_mm2() * length * program.consumables.wire_g_cm3.get()
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

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    #[test]
    fn the_duty_cycle_is_that_of_the_worst_ten_minutes() {
        assert!(duty_percent(&[]).abs() < 1e-12);
        assert!((duty_percent(&[(0.0, 60.0)]) - 10.0).abs() < 1e-9);
        assert!((duty_percent(&[(0.0, 3600.0)]) - 100.0).abs() < 1e-9);
        // Two arcs of 300 s, 300 s apart: 600 s hold one of them and nothing of the other, or parts of both.
        assert!((duty_percent(&[(0.0, 300.0), (600.0, 900.0)]) - 50.0).abs() < 1e-9);
        assert!((duty_percent(&[(0.0, 300.0), (400.0, 700.0)]) - 500.0 / 6.0).abs() < 1e-9);
    }

    /// Against a period that is shifted in small steps.
    #[test]
    fn no_other_period_has_more_arc() {
        let mut random = Random::new(61);
        for _ in 0..300 {
            let mut now = 0.0;
            let arcs: Vec<(f64, f64)> = (0..1 + random.below(12))
                .map(|_| {
                    let on = now + random.within(0.0, 300.0);
                    now = on + random.within(1.0, 400.0);
                    (on, now)
                })
                .collect();
            let overlap = |start: f64| {
                let part = |(on, off): &(f64, f64)| (off.min(start + 600.0) - on.max(start)).max(0.0);
                arcs.iter().map(part).sum::<f64>() / 6.0
            };
            let steps = (now + 1200.0) as u32;
            let brute = (0..steps).map(|i| overlap(f64::from(i) - 600.0)).fold(0.0, f64::max);
            let found = duty_percent(&arcs);
            assert!(found >= brute - 1e-9 && found <= brute + 0.4, "{found} {brute}");
        }
    }

    /// 1.2 mm of steel: 8.878 g/m, as in the tables of wire makers.
    #[test]
    fn wire_has_the_mass_of_its_cylinder() {
        let consumables = Consumables { wire_mm: Positive::new(1.2), ..Consumables::default() };
        let wire = Wire::of(&consumables, None);
        assert!((wire.mass_kg(Some(1000.0)).unwrap() - 8.878).abs() < 1e-3);
        assert_eq!(wire.weld_metal_kg(Some(1.0)), None);
        assert_eq!(wire.weld_metal_kg(Some(0.0)), Some(0.0));
        assert_eq!(Wire::of(&Consumables::default(), None).mass_kg(Some(1.0)), None);
    }
}
