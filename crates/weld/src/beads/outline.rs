//! Outlines of beads as metal, for drawing.
//!
//! A point of the groove is given by its part of the width (0 at the second part, 1 at the first) and the area below its
//! height. In these coordinates areas are exact: a surface whose mean over the width is a layer's area has just that area
//! below it, whatever the walls are. So surfaces are waves about their layer's level, with a crown on each bead, and the
//! flank between two beads is half of the earlier one's parabola, about the line that divides their areas.

use super::fill::BeadAt;
use crate::joint::Section;
use glam::DVec2;

/// Samples of a surface across the groove.
const SAMPLES: usize = 192;
/// Points of a flank.
const FLANK: usize = 16;
/// Height of a fill layer's waves as a part of its height: shallow, as valleys are filled.
///
/// This, [`VALLEY`] and [`UNDER`] are for drawing only: areas, layers and toe angles do not depend on them. They were chosen by
/// eye on the examples and checked on `random_joints.rs`: the column `drawn-%` is the 95th percentile of the difference
/// between an outline's area and its bead's.
const WAVE: f64 = 0.1;
/// Depth of the valleys in a cap of several beads as a part of the cap's height. The model of `toes.rs` has 0.14 of a bead's
/// height at the default spacing.
const VALLEY: f64 = 0.3;
/// Part of its parabola's half width by which an earlier bead lies under a later one; the rest is melted again.
const UNDER: f64 = 0.5;

/// A bead's boundary to its neighbour.
#[derive(Debug, Clone, Copy)]
struct Flank {
    /// Part of the width at which it divides the areas.
    at: f64,
    /// Half width of the earlier bead's parabola, as a part of the groove's; negative if that is the bead on the right.
    under: f64,
}

impl Flank {
    const fn wall(at: f64) -> Self {
        Self { at, under: 0.0 }
    }

    /// Its part of the width at a part of the layer's height. Its mean over the height is [`Flank::at`].
    fn part(&self, height: f64) -> f64 {
        (self.at + self.under * ((1.0 - height).max(0.0).sqrt() - 2.0 / 3.0)).clamp(0.0, 1.0)
    }
}

/// Areas below a surface at evenly spaced parts of the width.
struct Surface(Vec<f64>);

impl Surface {
    fn at(&self, part: f64) -> f64 {
        let x = part.clamp(0.0, 1.0) * SAMPLES as f64;
        let i = (x.floor() as usize).min(SAMPLES - 1);
        self.0[i] + (self.0[i + 1] - self.0[i]) * (x - i as f64)
    }
}

fn part(i: usize) -> f64 {
    i as f64 / SAMPLES as f64
}

impl Section {
    /// Outlines of beads in the order of welding, mm: with a crown on each, and later ones over the flanks of earlier
    /// ones. Together they cover groove and cap.
    pub fn outlines(&self, beads: &[BeadAt]) -> Vec<Vec<DVec2>> {
        let mut outlines = vec![Vec::new(); beads.len()];
        let mut layers: Vec<usize> = beads.iter().map(|bead| bead.layer).collect();
        layers.sort_unstable();
        layers.dedup();
        let mut below = Surface(vec![0.0; SAMPLES + 1]);
        for layer in layers {
            // From the second part to the first, each with its rank in the order of welding.
            let mut row: Vec<usize> = (0..beads.len()).filter(|i| beads[*i].layer == layer).collect();
            row.sort_by_key(|i| beads[*i].index);
            let one = &beads[row[0]];
            let level = self.surface(one, &below, None);
            let flanks = self.flanks(&row, one, &below, &level);
            let above = self.surface(one, &below, Some(&flanks));
            for (k, bead) in row.iter().enumerate() {
                outlines[*bead] = self.around([flanks[k], flanks[k + 1]], &below, &above);
            }
            below = above;
        }
        outlines
    }

    /// Top of the layer of `bead` over `below`; with its beads' `flanks` it has a crown on each.
    fn surface(&self, bead: &BeadAt, below: &Surface, flanks: Option<&[Flank]>) -> Surface {
        let (from, to) = bead.filled;
        let over = (to - self.area()).max(0.0);
        let level = to.min(self.area());
        // Waves are small beside the layer, and leave what is over the line from toe to toe to the cap.
        let wave = if over > 0.0 { 0.0 } else { (WAVE * (to - from)).min(self.area() - to) };
        let tops: Vec<f64> = flanks.map_or(vec![0.0, 1.0], |all| all.iter().map(|flank| flank.part(1.0)).collect());
        let mut bead = 0;
        let mut values = Vec::with_capacity(SAMPLES + 1);
        for i in 0..=SAMPLES {
            let x = part(i);
            while bead + 2 < tops.len() && x > tops[bead + 1] {
                bead += 1;
            }
            let u = ((x - tops[bead]) / (tops[bead + 1] - tops[bead]).max(1e-9)).clamp(0.0, 1.0);
            // Parabolas of mean 1.
            let (own, whole) = (6.0 * u * (1.0 - u), 6.0 * x * (1.0 - x));
            let cap = if tops.len() > 2 { whole * (1.0 - VALLEY) + whole.min(1.5) * VALLEY * own } else { whole };
            let waves = if flanks.is_some() { wave * (own - 1.0) } else { 0.0 };
            values.push(level + over * cap + waves);
        }
        // The mean is the layer's, also of a cap with valleys.
        let mean = 0.5 * (values[0] + values[SAMPLES]) + values[1..SAMPLES].iter().sum::<f64>();
        let (mean, wanted) = (mean / SAMPLES as f64 - level, to - level);
        if over > 0.0 && mean > 0.0 {
            values.iter_mut().for_each(|v| *v = level + (*v - level) * wanted / mean);
        } else {
            values.iter_mut().for_each(|v| *v += wanted - mean);
        }
        for (value, under) in values.iter_mut().zip(&below.0) {
            *value = value.max(*under);
        }
        Surface(values)
    }

    /// The boundaries of a row of beads of equal area between two surfaces, from the second part to the first.
    fn flanks(&self, row: &[usize], bead: &BeadAt, below: &Surface, above: &Surface) -> Vec<Flank> {
        let count = row.len();
        let thick: Vec<f64> = above.0.iter().zip(&below.0).map(|(a, b)| a - b).collect();
        let sums: Vec<f64> = thick
            .windows(2)
            .scan(0.0, |sum, pair| {
                *sum += 0.5 * (pair[0] + pair[1]);
                Some(*sum)
            })
            .collect();
        let whole = sums[SAMPLES - 1];
        let half = 0.5 * bead.width / self.mean_width(bead);
        let mut flanks = vec![Flank::wall(0.0)];
        for k in 1..count {
            let wanted = whole * k as f64 / count as f64;
            let i = sums.partition_point(|sum| *sum < wanted).min(SAMPLES - 1);
            let before = if i == 0 { 0.0 } else { sums[i - 1] };
            let at = (i as f64 + (wanted - before) / (sums[i] - before).max(f64::MIN_POSITIVE)) / SAMPLES as f64;
            let under = if row[k - 1] < row[k] { UNDER * half } else { -UNDER * half };
            flanks.push(Flank { at, under });
        }
        flanks.push(Flank::wall(1.0));
        flanks
    }

    fn mean_width(&self, bead: &BeadAt) -> f64 {
        (bead.filled.1 - bead.filled.0) / bead.layer_height
    }

    /// The point at a part of the width with `area` below it.
    pub(crate) fn point(&self, part: f64, area: f64) -> DVec2 {
        let (low, high) = self.slices.heights();
        let height = self.slices.height_of(area);
        // Just below the top: there the edges are those of the toes.
        let (left, right) = self.slices.edges(height.min(high - 1e-9 * (high - low)));
        self.place(left + part * (right - left), height + (area - self.area()).max(0.0) / self.chord())
    }

    /// The outline between two flanks and two surfaces.
    fn around(&self, [second, first]: [Flank; 2], below: &Surface, above: &Surface) -> Vec<DVec2> {
        let mut outline = self.side(first, below, above);
        outline.extend(self.along(above, first.part(1.0), second.part(1.0)));
        outline.extend(self.side(second, below, above).into_iter().rev());
        outline.extend(self.along(below, second.part(0.0), first.part(0.0)));
        outline.dedup_by(|a, b| a.distance_squared(*b) < 1e-18);
        outline
    }

    /// A flank from the lower surface to the upper one; at a wall with the wall's corners.
    fn side(&self, flank: Flank, below: &Surface, above: &Surface) -> Vec<DVec2> {
        let at = |k: usize| {
            let height = k as f64 / FLANK as f64;
            let part = flank.part(height);
            let (low, high) = (below.at(part), above.at(part));
            self.point(part, low + (high - low) * height)
        };
        let is_wall = flank.at <= 0.0 || flank.at >= 1.0;
        if !is_wall {
            return (0..=FLANK).map(at).collect();
        }
        let [low, high] = [below.at(flank.at), above.at(flank.at)].map(|area| self.slices.height_of(area));
        let edge =
            |(height, (left, right)): (f64, (f64, f64))| self.place(if flank.at <= 0.0 { left } else { right }, height);
        let mut side = vec![at(0)];
        side.extend(self.slices.corners_between(low, high).map(edge));
        side.push(at(FLANK));
        side
    }

    /// A surface between two parts of the width, in either sense.
    fn along(&self, surface: &Surface, from: f64, to: f64) -> Vec<DVec2> {
        let (low, high) = (from.min(to), from.max(to));
        let mut parts = vec![low];
        parts.extend((0..=SAMPLES).map(part).filter(|x| *x > low && *x < high));
        parts.push(high);
        if from > to {
            parts.reverse();
        }
        parts.into_iter().map(|x| self.point(x, surface.at(x))).collect()
    }
}
