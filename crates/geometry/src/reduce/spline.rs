//! Polylines to one cubic spline through few of their points.

use super::check;
use super::reduction::Tolerances;
use crate::cubic_spline::CubicSpline;
use crate::curve::Curve as _;
use crate::error::Error;
use crate::slopes::End;
use crate::spline::{Ends, Spline, chord_lengths};
use glam::DVec3;

/// A polyline as a spline.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineReduction {
    /// Indices of the interpolated points, including the first and the last.
    pub kept: Vec<usize>,
    /// The natural cubic spline through them, by length along the polyline: its speed is nearly 1.
    pub spline: Spline,
    /// Maximum distance of a point from it, mm; at most the tolerance.
    pub max_error: f64,
}

/// Reduces a polyline to the natural cubic spline, by length along it, through few of its points. All other points are
/// within `tolerances.path_mm` of it; further columns (each as long as `points`, in any unit) are natural splines
/// through the same points by the same parameter, within `tolerances.columns`. In any one frame.
///
/// Points are added in the middle of intervals with a point outside the tolerance, until all are within it. Then points
/// are removed again while the tolerance holds, the one with the smallest jump of the third derivative first. So no
/// single one is superfluous; another choice may still have fewer.
///
/// # Errors
/// As [`reduce`](super::reduce); [`Error::TooFewPoints`] for fewer than two points, [`Error::Knots`] for two equal
/// neighbouring points.
pub fn reduce_to_spline(points: &[DVec3], axes: &[Vec<f64>], tolerances: Tolerances) -> Result<SplineReduction, Error> {
    check(points, axes, tolerances)?;
    let ways = chord_lengths(points, false)?;
    let thinning = Thinning { points, axes, ways, tolerances };
    let mut best = thinning.through(vec![0, points.len() - 1])?;
    loop {
        let far = |gap: &[usize]| (gap[0] + 1..gap[1]).any(|i| thinning.away(&best, i).is_none());
        let middle = |gap: &[usize]| thinning.middle(gap[0], gap[1]).filter(|_| far(gap));
        let more: Vec<usize> = best.kept.windows(2).filter_map(middle).collect();
        if more.is_empty() {
            break;
        }
        let mut kept = [best.kept, more].concat();
        kept.sort_unstable();
        best = thinning.through(kept)?;
    }
    while let Some(fewer) = thinning.without_one(&best)? {
        best = fewer;
    }
    let max_error = (0..points.len()).filter_map(|i| thinning.away(&best, i)).fold(0.0, f64::max);
    Ok(SplineReduction { kept: best.kept, spline: best.spline, max_error })
}

/// A choice of points, and the splines through them.
struct Through {
    kept: Vec<usize>,
    spline: Spline,
    axes: Vec<CubicSpline>,
}

struct Thinning<'a> {
    points: &'a [DVec3],
    axes: &'a [Vec<f64>],
    /// Length along the polyline up to each point, mm.
    ways: Vec<f64>,
    tolerances: Tolerances,
}

impl Thinning<'_> {
    fn through(&self, kept: Vec<usize>) -> Result<Through, Error> {
        let places = kept.iter().map(|i| self.points[*i]).collect();
        let knots = kept.iter().map(|i| self.ways[*i]).collect();
        let spline = Spline::new(knots, places, Ends::Open(End::Natural, End::Natural))?;
        let column = |values: &Vec<f64>| {
            let rows: Vec<(f64, f64)> = kept.iter().zip(spline.knots()).map(|(i, u)| (*u, values[*i])).collect();
            CubicSpline::natural(&rows)
        };
        let axes = self.axes.iter().map(column).collect::<Result<_, _>>()?;
        Ok(Through { kept, spline, axes })
    }

    /// The index between two kept ones that is nearest to the middle of their lengths.
    fn middle(&self, from: usize, to: usize) -> Option<usize> {
        let middle = 0.5 * (self.ways[from] + self.ways[to]);
        (from + 1..to).min_by(|a, b| (self.ways[*a] - middle).abs().total_cmp(&(self.ways[*b] - middle).abs()))
    }

    /// Distance of point `i` from the spline; none if it or one of its columns exceeds the tolerance.
    fn away(&self, through: &Through, i: usize) -> Option<f64> {
        let Through { spline, axes, .. } = through;
        let foot = spline.foot(self.points[i], self.ways[i]);
        let away = self.points[i].distance(spline.point(foot));
        let carried = |(column, values): (&CubicSpline, &Vec<f64>)| {
            (column.at(foot).0 - values[i]).abs() <= self.tolerances.columns
        };
        (away <= self.tolerances.path_mm && axes.iter().zip(self.axes).all(carried)).then_some(away)
    }

    /// The splines without the first point that can be removed, smallest jump tried first.
    fn without_one(&self, best: &Through) -> Result<Option<Through>, Error> {
        let knots = best.spline.knots();
        let jump = |k: usize| (best.spline.third(knots[k]) - best.spline.third(knots[k - 1])).length();
        let mut order: Vec<usize> = (1..best.kept.len() - 1).collect();
        order.sort_by(|a, b| jump(*a).total_cmp(&jump(*b)));
        for k in order {
            let mut kept = best.kept.clone();
            kept.remove(k);
            let fewer = self.through(kept)?;
            let holds = |(from, to): (usize, usize)| (from..to).all(|i| self.away(&fewer, i).is_some());
            // Checks the new interval first: failures are most likely there.
            let gap = (best.kept[k - 1], best.kept[k + 1]);
            if holds(gap) && holds((0, gap.0)) && holds((gap.1, self.points.len())) {
                return Ok(Some(fewer));
            }
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    fn distance(spline: &Spline, p: DVec3) -> f64 {
        let (from, to) = spline.domain();
        let at = |k: u32| spline.point(from + (to - from) * f64::from(k) / 4000.0);
        (0..=4000).map(|k| at(k).distance(p)).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn random_curves_are_kept_within_the_tolerance_by_few_points() {
        for seed in 0..24 {
            let mut random = Random::new(seed);
            let waves: Vec<[f64; 7]> = (0..3).map(|_| std::array::from_fn(|_| random.within(-1.0, 1.0))).collect();
            let closed = seed % 3 == 0;
            let curve = |t: f64| {
                let round = if closed { 50.0 * DVec3::new(t.cos(), t.sin(), 0.0) } else { 40.0 * t * DVec3::X };
                let wave = |(k, w): (usize, &[f64; 7])| {
                    let phase = (k + 1) as f64 * t;
                    DVec3::new(w[0], w[1], w[2]) * phase.sin() + DVec3::new(w[3], w[4], w[5]) * phase.cos()
                };
                round + 4.0 * waves.iter().enumerate().map(wave).sum::<DVec3>()
            };
            let ts: Vec<f64> = (0..=500).map(|i| std::f64::consts::TAU * f64::from(i) / 500.0).collect();
            let points: Vec<DVec3> =
                ts.iter().map(|t| curve(*t) + 0.005 * random.within(-1.0, 1.0) * DVec3::ONE).collect();
            let column: Vec<f64> = ts.iter().map(|t| 0.3 * t.sin()).collect();
            let tolerances = Tolerances { path_mm: 0.05, columns: 0.005 };
            let found = reduce_to_spline(&points, std::slice::from_ref(&column), tolerances).unwrap();
            assert!(found.kept.len() < 60, "seed {seed}: {}", found.kept.len());
            assert_eq!((found.kept[0], found.kept.last()), (0, Some(&500)));
            let away = points.iter().step_by(5).map(|p| distance(&found.spline, *p)).fold(0.0, f64::max);
            // With steps of about 0.1 mm along the curve the brute force slightly overestimates.
            assert!(found.max_error <= tolerances.path_mm, "seed {seed}: {}", found.max_error);
            assert!(away <= found.max_error + 0.02, "seed {seed}: {away} {}", found.max_error);
            // The spline of the column passes through it at the kept points.
            let rows: Vec<(f64, f64)> =
                found.kept.iter().zip(found.spline.knots()).map(|(i, u)| (*u, column[*i])).collect();
            let carried = CubicSpline::natural(&rows).unwrap();
            for (i, p) in points.iter().enumerate().step_by(23) {
                let guess = found.spline.knots()[found.kept.partition_point(|k| *k < i)];
                let (from, to) = (guess - 60.0, guess + 60.0);
                let near = (0..=1200).map(|k| from + (to - from) * f64::from(k) / 1200.0);
                let foot = near
                    .min_by(|a, b| found.spline.point(*a).distance(*p).total_cmp(&found.spline.point(*b).distance(*p)));
                let off = (carried.at(foot.unwrap()).0 - column[i]).abs();
                assert!(off <= tolerances.columns + 0.002, "seed {seed}, point {i}: {off}");
            }
        }
    }

    #[test]
    fn straight_lines_need_two_points_and_what_is_none_is_refused() {
        let line: Vec<DVec3> = (0..50).map(|i| f64::from(i) * DVec3::new(0.3, -0.1, 0.2)).collect();
        let fine = Tolerances { path_mm: 0.01, columns: 1.0 };
        let (zero, coarse) = (Tolerances { path_mm: 0.0, ..fine }, Tolerances { path_mm: 0.1, ..fine });
        let found = reduce_to_spline(&line, &[], fine).unwrap();
        assert_eq!(found.kept, [0, 49]);
        assert!(found.max_error < 1e-12);
        assert_eq!(reduce_to_spline(&line[..2], &[], fine).unwrap().kept, [0, 1]);
        assert!(matches!(reduce_to_spline(&line[..1], &[], fine), Err(Error::TooFewPoints { .. })));
        assert!(matches!(reduce_to_spline(&line, &[], zero), Err(Error::Size { .. })));
        assert!(matches!(reduce_to_spline(&line, &[vec![0.0; 9]], coarse), Err(Error::Column { .. })));
        assert!(matches!(reduce_to_spline(&[line[0], line[0]], &[], coarse), Err(Error::Knots { .. })));
        assert!(matches!(reduce_to_spline(&[line[0], DVec3::NAN], &[], coarse), Err(Error::Place { .. })));
    }
}
