//! Area of unwoven beads against what surface tension holds in their welding position.

use super::inclination;
use super::planned_pass::PlannedPass;
use seamwright_message::{Message, Unit};
use seamwright_program::{BeadWindow, FilletOrButt, Finding, Inclination, PathRange, PositionLimits, Procedure, Role};

/// Stations at which each bead of a pass is compared.
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

/// Reports the range on which the bead of a pass is larger than its position or its procedure permits. `covered` is true if
/// a later pass lies on it; `period` is the length of a seam welded all round, mm.
pub(crate) fn finding(
    procedure: Option<&Procedure>,
    planned: PlannedPass,
    covered: bool,
    period: Option<f64>,
) -> Option<Finding> {
    let PlannedPass { pass, number, .. } = planned;
    if pass.weave.is_some() || !is_arc_bead(pass.role, procedure) {
        return None;
    }
    let given = procedure.and_then(|p| p.run_of(number, pass)?.max_unwoven_mm2).map(seamwright_document::Positive::get);
    // Inside a groove walls and earlier beads carry the metal. A root or fill pass may be the only one.
    let enclosed = covered && pass.role.is_some_and(|role| role != Role::Cap);
    let (mut range, mut worst): (Option<PathRange>, Option<Worst>) = (None, None);
    let places = |range: PathRange| {
        (0..=PLACES).map(move |i| range.from_mm + (range.to_mm - range.from_mm) * i as f64 / PLACES as f64)
    };
    for (bead, s) in pass.beads().flat_map(|(bead, range)| places(range).map(move |s| (bead, s))) {
        let at = inclination::at(planned, s).inclination;
        let max = given.unwrap_or_else(|| at.max_pool_mm2(enclosed));
        let area = bead.row_at(pass.seam_s(s), period).area_mm2;
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
    let window = BeadWindow::new(procedure, Role::Fill, None);
    is_laid && window.max_unwoven_mm.is_finite()
}

fn joint(procedure: Option<&Procedure>, planned: PlannedPass, s: f64) -> FilletOrButt {
    let dihedral = planned.path.groove(s).map_or(std::f64::consts::PI, |groove| groove.dihedral);
    procedure.map_or_else(|| PositionLimits::default().joint(dihedral), |p| p.joint(dihedral, dihedral))
}
