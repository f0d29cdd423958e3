//! Area of unwoven beads against what surface tension holds in their welding position.

use super::inclination;
use super::planned_pass::PlannedPass;
use seamwright_message::{Message, Unit};
use seamwright_program::{
    Bead, BeadWindow, FilletOrButt, Finding, Inclination, PathRange, PositionLimits, Procedure, Role,
};

/// Stations at which a pass is compared.
const PLACES: usize = 120;
/// Areas are rounded in programs, and positions change from one station to the next: a bead larger by this part only is
/// no finding.
const ROUNDING: f64 = 0.01;

/// The bead that exceeds its limit most.
struct Worst {
    s: f64,
    area: f64,
    max: f64,
    at: Inclination,
}

/// Reports the range on which the bead of a pass is larger than its position or its procedure permits. `period` is the
/// length of a seam welded all round, mm.
pub(crate) fn finding(procedure: Option<&Procedure>, planned: PlannedPass, period: Option<f64>) -> Option<Finding> {
    let PlannedPass { path, pass, number, .. } = planned;
    let bead = pass.bead.as_ref().filter(|_| pass.weave.is_none() && is_arc_bead(pass.role, procedure))?;
    let given = procedure.and_then(|p| p.run_of(number, pass)?.max_unwoven_mm2).map(seamwright_document::Positive::get);
    // Inside a groove walls and earlier beads carry the metal.
    let enclosed = pass.role.is_some_and(|role| role != Role::Cap);
    let (mut range, mut worst): (Option<PathRange>, Option<Worst>) = (None, None);
    for i in 0..=PLACES {
        let s = path.length() * i as f64 / PLACES as f64;
        let at = inclination::at(planned, s).inclination;
        let max = given.unwrap_or_else(|| at.max_pool_mm2(enclosed));
        let area = area_at(bead, pass.seam_s(s), period);
        if area <= max * (1.0 + ROUNDING) {
            continue;
        }
        let known = range.get_or_insert(PathRange::at(s));
        known.to_mm = s;
        if worst.as_ref().is_none_or(|w| area / max > w.area / w.max) {
            worst = Some(Worst { s, area, max, at });
        }
    }
    let (range, worst) = range.zip(worst)?;
    let limits = procedure.map_or_else(PositionLimits::default, |p| p.position_limits);
    let position = limits.position(joint(procedure, planned, worst.s), worst.at);
    let message = Message::new("motion-pool-too-large")
        .quantity("area", worst.area, Unit::Mm2, 1)
        .quantity("s", worst.s, Unit::Mm, 0)
        .text("position", position.to_string())
        .quantity("max", worst.max, Unit::Mm2, 1);
    let finding = Finding::error("pool", message, number, range, Message::new("motion-cure-pool"));
    Some(Finding { allowed: true, ..finding })
}

/// True for passes of a consumable electrode or wire: beams have no limit, and tacks no bead of their own.
fn is_arc_bead(role: Option<Role>, procedure: Option<&Procedure>) -> bool {
    let is_laid = !matches!(role, Some(Role::Tack | Role::Cosmetic));
    // Beams have no limit of width, and no pool that sags.
    let window = BeadWindow::new(procedure, Role::Fill, None);
    is_laid && window.max_unwoven_mm.is_finite()
}

fn joint(procedure: Option<&Procedure>, planned: PlannedPass, s: f64) -> FilletOrButt {
    let dihedral = planned.path.groove(s).map_or(std::f64::consts::PI, |groove| groove.dihedral);
    let fillet_up_to = PositionLimits::default().fillet_up_to_deg.get();
    match procedure {
        Some(procedure) => procedure.joint(dihedral, dihedral),
        None if dihedral.to_degrees() <= fillet_up_to => FilletOrButt::Fillet,
        None => FilletOrButt::Butt,
    }
}

/// Area of a bead at path length `s` of the seam, mm^2, linear between its rows.
fn area_at(bead: &Bead, s: f64, period: Option<f64>) -> f64 {
    let Some(first) = bead.s_mm.first() else { return 0.0 };
    let s = period.map_or(s, |period| first.get() + (s - first.get()).rem_euclid(period));
    let i = bead.s_mm.partition_point(|row| row.get() <= s);
    let area = |k: usize| bead.area_mm2[k].get();
    let Some(before) = i.checked_sub(1) else { return area(0) };
    let (after, to) = match (bead.s_mm.get(i), period) {
        (Some(row), _) => (i, row.get()),
        (None, Some(period)) => (0, first.get() + period),
        (None, None) => return area(before),
    };
    let from = bead.s_mm[before].get();
    area(before) + (area(after) - area(before)) * ((s - from) / (to - from)).clamp(0.0, 1.0)
}
