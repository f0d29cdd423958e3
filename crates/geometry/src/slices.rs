use glam::DVec2;

/// A simple polygon sliced by parallel lines: its area below a height, the height for a given area, and its edges at a
/// height.
///
/// Heights are along `up`, lateral positions along `up` turned clockwise by a right angle. Between the heights of two
/// corners all edges are straight, so area is exactly quadratic in height there.
#[derive(Debug, Clone, PartialEq)]
pub struct Slices {
    slabs: Vec<Slab>,
    area: f64,
}

/// The polygon between the heights of two neighbouring corners.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Slab {
    low: f64,
    high: f64,
    /// Leftmost and rightmost position, and sum of widths, at `low` and `high`.
    left: [f64; 2],
    right: [f64; 2],
    width: [f64; 2],
    /// Area of the polygon below `low`.
    below: f64,
}

/// Corners whose heights differ by less, as a part of the polygon's height, are level.
const LEVEL: f64 = 1e-12;

impl Slices {
    /// Slices of the polygon with these corners, in order either way round; `up` is a unit vector. None if it has no
    /// height or no area.
    pub fn new(corners: &[DVec2], up: DVec2) -> Option<Self> {
        let across = DVec2::new(up.y, -up.x);
        let points: Vec<DVec2> = corners.iter().map(|p| DVec2::new(across.dot(*p), up.dot(*p))).collect();
        let mut heights: Vec<f64> = points.iter().map(|p| p.y).collect();
        heights.sort_by(f64::total_cmp);
        let (lowest, highest) = (*heights.first()?, *heights.last()?);
        let level = LEVEL * (highest - lowest);
        heights.dedup_by(|later, earlier| *later - *earlier <= level);
        let mut built = Self { slabs: Vec::with_capacity(heights.len()), area: 0.0 };
        let mut crossings: Vec<(f64, [f64; 2])> = Vec::new();
        for pair in heights.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            let middle = 0.5 * (low + high);
            crossings.clear();
            for (i, a) in points.iter().enumerate() {
                let b = points[(i + 1) % points.len()];
                if (a.y < middle) != (b.y < middle) {
                    let at = |h: f64| a.x + (b.x - a.x) * ((h - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
                    crossings.push((at(middle), [at(low), at(high)]));
                }
            }
            crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (first, last) = (crossings.first()?.1, crossings.last()?.1);
            let sum = |end: usize| crossings.chunks_exact(2).map(|c| c[1].1[end] - c[0].1[end]).sum::<f64>();
            let width = [sum(0), sum(1)];
            built.slabs.push(Slab { low, high, left: first, right: last, width, below: built.area });
            built.area += 0.5 * (width[0] + width[1]) * (high - low);
        }
        (built.area > 0.0).then_some(built)
    }

    /// Area of the whole polygon.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Lowest and highest height.
    pub fn heights(&self) -> (f64, f64) {
        (self.slabs[0].low, self.slabs[self.slabs.len() - 1].high)
    }

    /// Area below `height`.
    pub fn area_below(&self, height: f64) -> f64 {
        let slab = &self.slabs[self.slab(height)];
        let h = height.clamp(slab.low, slab.high) - slab.low;
        slab.below + h * (slab.width[0] + 0.5 * h * slab.slope())
    }

    /// The height with `area` below it, clamped to the lowest and highest.
    pub fn height_of(&self, area: f64) -> f64 {
        let slab = &self.slabs[self.slabs.partition_point(|s| s.below < area).saturating_sub(1)];
        let (a, w, slope) = ((area - slab.below).max(0.0), slab.width[0].max(0.0), slab.slope());
        // The root of w h + slope h^2 / 2 = a, in the form that keeps its digits.
        let root = (w * w + 2.0 * slope * a).max(0.0).sqrt();
        let h = if w + root > 0.0 { 2.0 * a / (w + root) } else { 0.0 };
        slab.low + h.min(slab.high - slab.low)
    }

    /// Leftmost and rightmost position of the polygon at `height`; at a jump, of the slice above.
    pub fn edges(&self, height: f64) -> (f64, f64) {
        let slab = &self.slabs[self.slab(height)];
        let part = ((height - slab.low) / (slab.high - slab.low)).clamp(0.0, 1.0);
        let at = |ends: [f64; 2]| ends[0] + part * (ends[1] - ends[0]);
        (at(slab.left), at(slab.right))
    }

    /// Heights of corners strictly between two heights, each with the leftmost and rightmost position below it and then
    /// above it.
    pub fn corners_between(&self, low: f64, high: f64) -> impl Iterator<Item = (f64, (f64, f64))> {
        let ends = |slab: &Slab, end: usize| (slab.left[end], slab.right[end]);
        let pairs = self.slabs.windows(2).filter(move |pair| pair[0].high > low && pair[0].high < high);
        pairs.flat_map(move |pair| [(pair[0].high, ends(&pair[0], 1)), (pair[0].high, ends(&pair[1], 0))])
    }

    fn slab(&self, height: f64) -> usize {
        self.slabs.partition_point(|s| s.low <= height).saturating_sub(1)
    }
}

impl Slab {
    fn slope(&self) -> f64 {
        (self.width[1] - self.width[0]) / (self.high - self.low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shoelace(points: &[DVec2]) -> f64 {
        0.5 * (0..points.len()).map(|i| points[i].perp_dot(points[(i + 1) % points.len()])).sum::<f64>()
    }

    fn below(points: &[DVec2], up: DVec2, height: f64) -> f64 {
        let mut kept = Vec::new();
        for (i, a) in points.iter().enumerate() {
            let b = points[(i + 1) % points.len()];
            let (da, db) = (height - up.dot(*a), height - up.dot(b));
            if da >= 0.0 {
                kept.push(*a);
            }
            if (da > 0.0) != (db > 0.0) {
                kept.push(*a + (b - *a) * (da / (da - db)));
            }
        }
        shoelace(&kept).abs()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        /// Stars about a point are simple polygons of any shape.
        #[test]
        fn areas_are_those_of_the_cut_polygon(
            radii in proptest::collection::vec(0.2..5.0f64, 3..24),
            turn in 0.0..std::f64::consts::TAU,
            part in 0.0..1.0f64,
        ) {
            let n = radii.len() as f64;
            let corner = |(i, r): (usize, &f64)| *r * DVec2::from_angle(std::f64::consts::TAU * i as f64 / n);
            let points: Vec<DVec2> = radii.iter().enumerate().map(corner).collect();
            let up = DVec2::from_angle(turn);
            let slices = Slices::new(&points, up).unwrap();
            prop_assert!((slices.area() - shoelace(&points)).abs() < 1e-10);
            let (low, high) = slices.heights();
            let h = low + part * (high - low);
            let area = below(&points, up, h);
            prop_assert!((slices.area_below(h) - area).abs() < 1e-9, "{} {area}", slices.area_below(h));
            prop_assert!((slices.area_below(slices.height_of(area)) - area).abs() < 1e-9);
            // The left edge is not right of the right one.
            let (left, right) = slices.edges(h);
            prop_assert!(left <= right + 1e-9);
        }
    }

    #[test]
    fn closed_forms() {
        // A trapezoid 2 wide below, 6 above, 4 high.
        let points = [(0.0, 0.0), (2.0, 0.0), (4.0, 4.0), (-2.0, 4.0)].map(|(x, y)| DVec2::new(x, y));
        let slices = Slices::new(&points, DVec2::Y).unwrap();
        assert!((slices.area() - 16.0).abs() < 1e-12);
        assert!((slices.area_below(1.0) - 2.5).abs() < 1e-12);
        assert!((slices.height_of(2.5) - 1.0).abs() < 1e-12);
        let (left, right) = slices.edges(2.0);
        assert!((left + 1.0).abs() < 1e-12 && (right - 3.0).abs() < 1e-12);
        assert!(slices.height_of(-1.0).abs() < 1e-15 && (slices.height_of(99.0) - 4.0).abs() < 1e-15);
        // A triangle on its tip, and the other way round.
        let tip = [(0.0, 0.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
        assert!((Slices::new(&tip, DVec2::Y).unwrap().height_of(0.25) - 0.5).abs() < 1e-15);
        assert!(Slices::new(&[DVec2::ZERO, DVec2::X, 2.0 * DVec2::X], DVec2::Y).is_none());
    }
}
