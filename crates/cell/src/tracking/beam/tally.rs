use super::super::tally::Tally;
use glam::DVec2;

/// Statistics of a beam's weld, cycle by cycle.
#[derive(Debug, Clone, Default)]
pub(crate) struct BeamTally {
    /// Distances across.
    pub(super) across: Tally,
    /// Distances out of the surface.
    pub(super) out: Tally,
    /// Cycles with the beam on the weld, and away from it; the current and the longest run away.
    cycles: [u32; 2],
    away: u32,
    longest_away: u32,
    /// Maximum deflection and offset of the gun, mm.
    pub(crate) used: [f64; 2],
}

impl BeamTally {
    /// Adds a miss, across and out of the surface, over this stretch of the way, mm.
    pub(crate) fn add(&mut self, miss: DVec2, way: f64) {
        self.across.add(miss.with_y(0.0), way);
        self.out.add(miss.with_x(0.0), way);
    }

    pub(crate) fn cycle(&mut self, welds: bool, deflection: f64, carried: f64) {
        self.cycles[usize::from(!welds)] += 1;
        self.away = if welds { 0 } else { self.away + 1 };
        self.longest_away = self.longest_away.max(self.away);
        self.used = [self.used[0].max(deflection.abs()), self.used[1].max(carried.abs())];
    }

    /// Returns the share of cycles with the beam away from the weld, and the maximum number in a row.
    pub(crate) fn away(&self) -> (f64, u32) {
        let [on, off] = self.cycles.map(f64::from);
        (off / (on + off).max(1.0), self.longest_away)
    }
}
