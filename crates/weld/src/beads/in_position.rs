//! Beads of passes in the cross-sections, and their toes in the positions in which they are welded.

use super::findings::{TOE_ROUNDING_DEG, min_toe_deg, toe_finding};
use crate::welding::Welding;
use seamwright_program::{Bead, Finding, Inclination, PathRange, Role};

/// Numbers of the beads of a pass in the cross-sections: they count the beads at a station in the order of welding.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct BeadNumbers {
    /// The first one, from 1.
    pub first: Option<usize>,
    /// The last one; `None` if it welds one bead.
    pub last: Option<usize>,
}

/// The smaller toe angle of a bead at one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToeAt {
    /// Path length of the pass, mm.
    pub s: f64,
    /// Angle, rad.
    pub angle: f64,
    /// Index of the station of the bead plan.
    station: usize,
}

impl Welding {
    /// The numbers of each pass' beads. Empty where some beads are not all along the seam, as then the numbers differ
    /// along it.
    pub fn bead_numbers(&self) -> Vec<BeadNumbers> {
        if self.plan.as_ref().is_none_or(|plan| plan.parts.iter().any(|parts| !parts.is_empty())) {
            return Vec::new();
        }
        let mut known: Vec<&Bead> = Vec::new();
        let mut numbers = Vec::new();
        for pass in &self.program.value.passes {
            // A tack lies on the line of the root without being it.
            let beads = pass.beads().filter(|_| pass.role != Some(Role::Tack)).map(|(bead, _)| bead);
            let of_pass: Vec<usize> = beads
                .map(|bead| {
                    let old = known.iter().position(|other| *other == bead);
                    old.unwrap_or_else(|| {
                        known.push(bead);
                        known.len() - 1
                    }) + 1
                })
                .collect();
            let last = of_pass.last().copied().filter(|_| of_pass.len() > 1);
            numbers.push(BeadNumbers { first: of_pass.first().copied(), last });
        }
        numbers
    }

    /// The smaller toe angles of a pass of one bead, `number` in the cross-sections: at `inclinations` (path lengths of the
    /// pass, mm) as it sags there, without any as it is drawn.
    pub fn toes(&self, pass: usize, number: usize, inclinations: &[(f64, Inclination)]) -> Vec<ToeAt> {
        let (Some(plan), Some(seam)) = (&self.plan, &self.seam) else { return Vec::new() };
        let Some(&bead) = number.checked_sub(1).and_then(|i| plan.order.get(i)) else { return Vec::new() };
        let pass = &self.program.value.passes[pass];
        if inclinations.is_empty() || pass.weave.is_some() {
            let drawn = |station: usize| ToeAt {
                s: plan.stations[station],
                angle: plan.at_station(station)[bead].toes.min(),
                station,
            };
            return (0..plan.stations.len()).map(drawn).collect();
        }
        let sagged = |&(s, at): &(f64, Inclination)| {
            let on_seam = pass.seam_s(s);
            let on_seam = if seam.all_round() { on_seam.rem_euclid(seam.length()) } else { on_seam };
            let station = plan.stations.partition_point(|station| *station <= on_seam).max(1) - 1;
            ToeAt { s, angle: plan.at_station(station)[bead].min_toe_in(at), station }
        };
        inclinations.iter().map(sagged).collect()
    }

    /// The finding that a pass, counted from 0, has steeper toes in its positions than the quality level allows, though not
    /// as it is drawn.
    pub fn toe_finding_in_position(&self, pass: usize, inclinations: &[(f64, Inclination)]) -> Option<Finding> {
        let plan = self.plan.as_ref()?;
        let numbers = *self.bead_numbers().get(pass)?;
        let number = numbers.first.filter(|_| numbers.last.is_none())?;
        let bead = *plan.order.get(number - 1)?;
        let is_cap = plan.beads[bead].layer + 1 == plan.layers.len();
        let is_known = |f: &Finding| f.pass == pass + 1 && f.message.code == "weld-bead-toe-steep";
        if !is_cap || inclinations.is_empty() || self.findings().iter().any(is_known) {
            return None;
        }
        let window = &plan.last_window;
        let steep = self.toes(pass, number, inclinations).into_iter().filter_map(|toe| {
            let at = &plan.at_station(toe.station)[bead];
            let angle = toe.angle.to_degrees();
            let min = min_toe_deg(window, plan.dihedrals[toe.station], angle, at);
            (angle < min - TOE_ROUNDING_DEG).then_some((toe.s, angle, min))
        });
        let steep: Vec<(f64, f64, f64)> = steep.collect();
        let range = PathRange { from_mm: steep.first()?.0, to_mm: steep.last()?.0 };
        let worst = steep.iter().min_by(|a, b| (a.1 - a.2).total_cmp(&(b.1 - b.2)))?;
        Some(toe_finding(worst.1, worst.2, pass + 1, range, window))
    }
}
