use serde::{Deserialize, Serialize};

/// Bins per factor of two: the resolution is an eighth of the lateness.
const BINS_AN_OCTAVE: u32 = 8;
/// Number of bins, up to 2^40 ns.
const BINS: usize = 40 * BINS_AN_OCTAVE as usize;

/// Lateness of cycle starts: a histogram of fixed size with bins that grow with the lateness.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(into = "Filled", from = "Filled")]
pub struct Latency {
    bins: Box<[u64; BINS]>,
    count: u64,
    most_ns: u64,
    missed: u64,
}

/// A [`Latency`] between processes: its filled bins.
#[derive(Serialize, Deserialize)]
struct Filled {
    /// Number of each filled bin, with its count.
    bins: Vec<(u16, u64)>,
    most_ns: u64,
    missed: u64,
}

impl From<Latency> for Filled {
    fn from(all: Latency) -> Self {
        let filled = (0u16..).zip(all.bins.iter().copied()).filter(|(_, count)| *count > 0);
        Self { bins: filled.collect(), most_ns: all.most_ns, missed: all.missed }
    }
}

impl From<Filled> for Latency {
    fn from(filled: Filled) -> Self {
        let mut all = Self { most_ns: filled.most_ns, missed: filled.missed, ..Self::default() };
        for (bin, count) in filled.bins {
            if let Some(known) = all.bins.get_mut(usize::from(bin)) {
                *known = known.saturating_add(count);
                all.count = all.count.saturating_add(count);
            }
        }
        all
    }
}

impl Default for Latency {
    fn default() -> Self {
        Self { bins: Box::new([0; BINS]), count: 0, most_ns: 0, missed: 0 }
    }
}

impl Latency {
    /// Adds a cycle that started late by `late_ns`, with the number of cycles missed before it.
    pub fn add(&mut self, late_ns: u64, missed: u32) {
        self.bins[bin(late_ns)] += 1;
        self.count += 1;
        self.most_ns = self.most_ns.max(late_ns);
        self.missed += u64::from(missed);
    }

    /// Returns the number of cycles.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the number of missed cycles.
    pub fn missed(&self) -> u64 {
        self.missed
    }

    /// Returns the maximum lateness, us.
    pub fn most_us(&self) -> f64 {
        self.most_ns as f64 * 1e-3
    }

    /// Returns the quantile `part` (0 to 1) of the lateness, us; at most an eighth too large.
    pub fn quantile_us(&self, part: f64) -> f64 {
        let wanted = (part * self.count as f64).ceil().max(1.0) as u64;
        let mut seen = 0;
        let found = self.bins.iter().position(|n| {
            seen += n;
            seen >= wanted
        });
        found.map_or(self.most_us(), |bin| upper_ns(bin).min(self.most_ns as f64) * 1e-3)
    }

    /// Returns the bins that are not empty: upper limit of the lateness (us), and number of cycles.
    pub fn bins(&self) -> impl Iterator<Item = (f64, u64)> {
        (0..BINS).filter(|bin| self.bins[*bin] > 0).map(|bin| (upper_ns(bin) * 1e-3, self.bins[bin]))
    }
}

/// Returns the bin of a lateness: its octave, and the eighth within that.
fn bin(ns: u64) -> usize {
    if ns < u64::from(BINS_AN_OCTAVE) {
        return ns as usize;
    }
    let octave = ns.ilog2();
    let part = (ns >> (octave - 3)) & 7;
    (((octave - 2) * BINS_AN_OCTAVE) as usize + part as usize).min(BINS - 1)
}

/// Returns the upper limit of a bin, ns.
fn upper_ns(bin: usize) -> f64 {
    let (octave, part) = (bin / BINS_AN_OCTAVE as usize, bin % BINS_AN_OCTAVE as usize);
    if octave == 0 { (part + 1) as f64 } else { (8 + part + 1) as f64 * 2f64.powi(octave as i32 - 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_against_sorting() {
        let mut state = 7u64;
        let mut all = Vec::new();
        let mut latency = Latency::default();
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let ns = 2f64.powf((state >> 11) as f64 / (1u64 << 53) as f64 * 30.0) as u64;
            all.push(ns);
            latency.add(ns, 0);
        }
        all.sort_unstable();
        for part in [0.01, 0.5, 0.9, 0.99, 0.999, 1.0] {
            let exact = all[((part * all.len() as f64).ceil() as usize).saturating_sub(1)] as f64 * 1e-3;
            let found = latency.quantile_us(part);
            assert!(found >= exact && found <= exact * 1.13 + 0.001, "{part}: {found} {exact}");
        }
        assert_eq!(latency.bins().map(|b| b.1).sum::<u64>(), 20_000);
        assert!(latency.bins().zip(latency.bins().skip(1)).all(|(a, b)| a.0 < b.0));
    }
}
