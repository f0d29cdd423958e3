/// Use of a beam in a weld, counted in cycles.
#[derive(Debug, Clone, Default)]
pub struct BeamUse {
    /// Cycles with the beam on the weld, and away from it; the current and the longest run away.
    cycles: [u32; 2],
    away: u32,
    longest_away: u32,
    /// Maximum deflection and offset of the gun, mm.
    pub used: [f64; 2],
}

impl BeamUse {
    /// Adds a cycle with the beam on the weld or away from it, its deflection and the offset of the gun, mm.
    pub fn cycle(&mut self, welds: bool, deflection: f64, carried: f64) {
        self.cycles[usize::from(!welds)] += 1;
        self.away = if welds { 0 } else { self.away + 1 };
        self.longest_away = self.longest_away.max(self.away);
        self.used = [self.used[0].max(deflection.abs()), self.used[1].max(carried.abs())];
    }

    /// Returns the share of cycles with the beam away from the weld, and the maximum number in a row.
    #[must_use]
    pub fn away(&self) -> (f64, u32) {
        let [on, off] = self.cycles.map(f64::from);
        (off / (on + off).max(1.0), self.longest_away)
    }
}
