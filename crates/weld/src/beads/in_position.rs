//! Beads of passes in the cross-sections, and their toes in the positions in which they are welded.

use super::findings::{TOE_ROUNDING_DEG, min_toe_deg, toe_finding};
use super::plan::BeadPlan;
use crate::seam::SeamCurve;
use crate::welding::Welding;
use seamwright_program::{Bead, Finding, Inclination, Pass, PathRange, Role, part_start, parts_of};

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
    /// The bead, as it is counted at a station.
    bead: usize,
}

impl Welding {
    /// The numbers of each pass' beads; empty without planned beads.
    pub fn bead_numbers(&self) -> Vec<BeadNumbers> {
        if self.plan.is_none() {
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

    /// The smaller toe angles of the beads of a pass, `numbers` in the cross-sections: at `inclinations` (path lengths of
    /// the pass, mm) as they sag there, without any as they are drawn.
    pub fn toes(&self, pass: usize, numbers: BeadNumbers, inclinations: &[(f64, Inclination)]) -> Vec<ToeAt> {
        let (Some(plan), Some(seam)) = (&self.plan, &self.seam) else { return Vec::new() };
        let pass = &self.program.value.passes[pass];
        let beads = LaidBeads { plan, seam, pass, first: numbers.first };
        if inclinations.is_empty() || pass.weave.is_some() {
            let step = plan.stations.get(1).copied().unwrap_or(f64::INFINITY);
            let count = parts_of(pass.length(), step);
            let drawn = (0..=count).filter_map(|i| beads.toe(part_start(pass.length(), i, count), None));
            return drawn.collect();
        }
        inclinations.iter().filter_map(|&(s, at)| beads.toe(s, Some(at))).collect()
    }

    /// The finding that a pass, counted from 0, whose beads have `numbers`, has steeper toes in its positions than the
    /// quality level allows, though not as it is drawn.
    pub fn toe_finding_in_position(
        &self,
        pass: usize,
        numbers: BeadNumbers,
        inclinations: &[(f64, Inclination)],
    ) -> Option<Finding> {
        let plan = self.plan.as_ref()?;
        let is_known = |f: &Finding| f.pass == pass + 1 && f.message.code == "weld-bead-toe-steep";
        if inclinations.is_empty() || self.findings().iter().any(is_known) {
            return None;
        }
        let window = &plan.last_window;
        let steep = self.toes(pass, numbers, inclinations).into_iter().filter_map(|toe| {
            let at = &plan.at_station(toe.station)[toe.bead];
            let angle = toe.angle.to_degrees();
            let min = min_toe_deg(window, plan.dihedrals[toe.station], angle, at);
            let is_cap = at.layer + 1 == plan.layers.len();
            (is_cap && angle < min - TOE_ROUNDING_DEG).then_some((toe.s, angle, min))
        });
        let steep: Vec<(f64, f64, f64)> = steep.collect();
        let range = PathRange { from_mm: steep.first()?.0, to_mm: steep.last()?.0 };
        let worst = steep.iter().min_by(|a, b| (a.1 - a.2).total_cmp(&(b.1 - b.2)))?;
        Some(toe_finding(worst.1, worst.2, pass + 1, range, window))
    }
}

/// The beads of a pass where they are laid.
struct LaidBeads<'a> {
    plan: &'a BeadPlan,
    seam: &'a SeamCurve,
    pass: &'a Pass,
    /// Number of the first one in the cross-sections.
    first: Option<usize>,
}

impl LaidBeads<'_> {
    /// The smaller toe angle at path length `s` of the pass, sagged as in the position `at`. None of a tack, and where the
    /// bead is not there.
    fn toe(&self, s: f64, at: Option<Inclination>) -> Option<ToeAt> {
        let before = self.pass.step_overs.iter().take_while(|step| step.at_mm.get() <= s).count();
        let bead = *self.plan.order.get(self.first? - 1 + before)?;
        let on_seam = self.pass.seam_s(s);
        let on_seam = if self.seam.all_round() { on_seam.rem_euclid(self.seam.length()) } else { on_seam };
        let station = self.plan.stations.partition_point(|station| *station <= on_seam).max(1) - 1;
        let laid = self.plan.at_station(station)[bead];
        let angle = at.map_or_else(|| laid.toes.min(), |at| laid.min_toe_in(at));
        (laid.area > 0.0).then_some(ToeAt { s, angle, station, bead })
    }
}
