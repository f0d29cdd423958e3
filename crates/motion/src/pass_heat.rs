//! Preheat and cooling time of a planned pass by EN 1011-2.

use crate::procedure::PassProcedure;
use seamwright_document::{Finite, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{CoolingTime, Finding, Hardening, HeatFlow, Joint, Materials, PathRange, Program, Run};
use serde::Serialize;

/// Temperature of a workshop and of work that is not preheated, degrees Celsius.
pub const ROOM_C: f64 = 20.0;
/// Preheat may be less than the standard asks for by this, K: temperatures are not measured better.
const MEASURED_K: f64 = 1.0;
/// Above this temperature of the work there is no cooling from 800 to 500 degrees Celsius to speak of.
const MAX_WORK_C: f64 = 450.0;

/// Preheat and cooling of a pass by EN 1011-2.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PassHeat {
    /// Minimum and maximum heat input, kJ/mm; infinite where the torch stops with the arc on.
    pub heat_input_kj_mm: (f64, f64),
    /// Thickness that cools the weld, mm: of the thicker part.
    pub thickness_mm: f64,
    /// Minimum temperature before the pass by method B, degrees Celsius, if composition and hydrogen are known; below
    /// room temperature no preheat is needed.
    pub preheat_c: Option<f64>,
    /// Whether the values are in the ranges of method B.
    pub in_range: bool,
    /// Minimum and maximum temperature of the work before the pass, degrees Celsius: from preheat or the procedure to
    /// the maximum interpass temperature.
    pub work_c: (f64, f64),
    /// Minimum and maximum cooling time from 800 to 500 degrees Celsius, s.
    pub t85_s: (f64, f64),
    /// Flow of heat at the minimum.
    pub heat_flow: HeatFlow,
}

impl PassHeat {
    /// The heat of pass `number` of a program (counted from 1), compared with its procedure as `held`. `None` without
    /// materials, procedure, power or thickness.
    pub fn new(program: &Program, number: usize, held: &PassProcedure) -> Option<Self> {
        let (materials, procedure) = (program.materials.as_ref()?, program.procedure.as_ref()?);
        let pass = program.passes.get(number - 1)?;
        let found = held.quantities.iter().find(|q| q.key == "heat_input_kj_mm")?.found?;
        let thickness_mm = thickness_mm(Some(materials), program.joint.as_ref())?;
        let hydrogen = materials.weld_metal.as_ref().map(|metal| metal.hydrogen_ml_100g.get());
        let hardening = materials.decisive_cet().zip(hydrogen).map(|(cet, hydrogen_ml_100g)| Hardening {
            cet,
            thickness_mm,
            hydrogen_ml_100g,
            heat_input_kj_mm: found.0,
        });
        let preheat_c = hardening.map(|hardening| hardening.preheat_c());
        let work_c = work_c(program, procedure.run_of(number, pass), preheat_c, number == 1);
        let cooling = |heat_input_kj_mm: f64, work_c: f64| {
            let factors = materials.shape_factors(held.joint);
            CoolingTime { heat_input_kj_mm, work_c: work_c.min(MAX_WORK_C), thickness_mm, factors }.t85_s()
        };
        let (shortest, heat_flow) = cooling(found.0, work_c.0);
        Some(Self {
            heat_input_kj_mm: found,
            thickness_mm,
            preheat_c,
            in_range: hardening.is_none_or(|hardening| hardening.is_in_range()),
            work_c,
            t85_s: (shortest, cooling(found.1, work_c.1).0),
            heat_flow,
        })
    }

    /// Findings against the heat of pass `number`: a cooling time outside the window of the materials, less preheat in
    /// the procedure than the standard asks for.
    pub(crate) fn findings(&self, program: &Program, number: usize) -> Vec<Finding> {
        let (Some(materials), Some(pass)) = (&program.materials, program.passes.get(number - 1)) else {
            return Vec::new();
        };
        let range = PathRange::up_to(pass.length());
        let mut all = Vec::new();
        if let Some((least, most)) = materials.t85_s.map(seamwright_program::Window::ends) {
            let slow = self.t85_s.1 > most;
            if slow || self.t85_s.0 < least {
                let found = if slow { self.t85_s.1 } else { self.t85_s.0 };
                let message = if found.is_finite() { "motion-cooling-outside" } else { "motion-cooling-unbounded" };
                let message = Message::new(message).quantity("found", found, Unit::S, 1);
                let message = message.value("min", least, Unit::S).value("max", most, Unit::S);
                let cure = Message::new(if slow { "motion-cure-cooling-slow" } else { "motion-cure-cooling-fast" });
                all.push(Finding::error("cooling", message, number, range, cure));
            }
        }
        if let Some(needed) = self.preheat_c.filter(|needed| *needed > self.work_c.0 + MEASURED_K) {
            let message = Message::new("motion-preheat-low").quantity("needed", needed, Unit::DegC, 0);
            let message = message.quantity("found", self.work_c.0, Unit::DegC, 0);
            let cure = Message::new("motion-cure-preheat-low").quantity("needed", needed, Unit::DegC, 0);
            all.push(Finding { allowed: true, ..Finding::error("preheat", message, number, range, cure) });
        }
        if !self.in_range {
            all.push(Finding::note("preheat", Message::new("motion-preheat-range"), number, range));
        }
        all
    }
}

/// Thickness of the thicker part, mm: of the materials, or of the joint.
pub(crate) fn thickness_mm(materials: Option<&Materials>, joint: Option<&Joint>) -> Option<f64> {
    let of_joint = joint.and_then(|joint| joint.preparation.thickness_mm());
    let parts = materials.map(|materials| [&materials.first, materials.second()]);
    let given = parts.into_iter().flatten().map(|m| m.thickness_mm.map(Positive::get));
    given.chain([of_joint]).flatten().reduce(f64::max)
}

/// Minimum and maximum temperature of the work before a pass: what the procedure asks for, else what method B does.
fn work_c(program: &Program, run: Option<&Run>, preheat_c: Option<f64>, is_first: bool) -> (f64, f64) {
    let ends = |window: Option<seamwright_program::Window>| window.map(seamwright_program::Window::ends);
    let room = program.materials.as_ref().and_then(|m| m.work_c).map_or(ROOM_C, Finite::get);
    let preheat = ends(run.and_then(|run| run.preheat_c));
    let interpass = ends(run.and_then(|run| run.interpass_c));
    let lowest = preheat.or(interpass).map_or_else(|| preheat_c.unwrap_or(room).max(room), |window| window.0);
    let below = program.interpass.as_ref().and_then(|interpass| interpass.below_c).map(Positive::get);
    let highest = if is_first { preheat.map(|window| window.1) } else { below.or(interpass.map(|window| window.1)) };
    (lowest, highest.unwrap_or(lowest).max(lowest))
}
