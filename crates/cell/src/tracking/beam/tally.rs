use glam::DVec2;

/// What a beam's weld was like, cycle by cycle.
#[derive(Debug, Clone, Default)]
pub(super) struct BeamTally {
    /// Distances across and out of the surface, mm, and the way they hold for.
    misses: Vec<(DVec2, f64)>,
    /// Cycles with the beam on the weld, and away from it; the longest run of these.
    cycles: [u32; 2],
    away: u32,
    longest_away: u32,
    /// Greatest deflection and carrying, mm.
    pub(super) used: [f64; 2],
}

impl BeamTally {
    pub(super) fn add(&mut self, miss: DVec2, way: f64) {
        self.misses.push((miss.abs(), way));
    }

    pub(super) fn cycle(&mut self, welds: bool, deflection: f64, carried: f64) {
        self.cycles[usize::from(!welds)] += 1;
        self.away = if welds { 0 } else { self.away + 1 };
        self.longest_away = self.longest_away.max(self.away);
        self.used = [self.used[0].max(deflection.abs()), self.used[1].max(carried.abs())];
    }

    /// Part of the cycles with the beam away from the weld, and the most of them in a row.
    pub(super) fn away(&self) -> (f64, u32) {
        let [on, off] = self.cycles.map(f64::from);
        (off / (on + off).max(1.0), self.longest_away)
    }

    /// The distance, across or out of the surface, within which this part of the way lies; infinite of no way.
    pub(super) fn quantile(&mut self, part: f64, across: bool) -> f64 {
        let value = |miss: &DVec2| if across { miss.x } else { miss.y };
        self.misses.sort_by(|a, b| value(&a.0).total_cmp(&value(&b.0)));
        let whole = self.way();
        let mut way = 0.0;
        let found = self.misses.iter().find(|(_, by)| {
            way += by;
            way >= part * whole
        });
        found.or(self.misses.last()).map_or(f64::INFINITY, |(miss, _)| value(miss))
    }

    /// Way that was welded, mm.
    pub(super) fn way(&self) -> f64 {
        self.misses.iter().map(|m| m.1).sum()
    }
}
