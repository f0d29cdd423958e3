//! Thinning of long polylines to screen resolution.

type Point = (f64, f64);

/// Maximum number of points of a polyline that is drawn unchanged.
const PLAIN: usize = 2000;

/// Maximum number of points of a longer polyline that turns back in x, after coarsening.
const MAX_POINTS: usize = 5000;

/// Splits px points at gaps (a coordinate that is NaN) and thins long polylines.
///
/// With non-decreasing x, each pixel column keeps its first, lowest, highest and last point. All peaks remain, and the
/// number of points is at most four times the width. A curve that turns back drops points closer than a quarter of a
/// pixel, or more if it is still too long. Invisible gaps, less than a pixel wide, are closed.
pub(crate) fn thin(points: impl Iterator<Item = Point> + Clone) -> Vec<Vec<Point>> {
    if points.clone().nth(PLAIN).is_none() {
        return split(points);
    }
    let mut last = f64::NEG_INFINITY;
    let forward = points.clone().filter(drawn).all(|p| {
        let ahead = p.0 >= last;
        last = p.0;
        ahead
    });
    if forward {
        return columns(points);
    }
    let mut tolerance = 0.25;
    loop {
        let runs = apart(points.clone(), tolerance);
        if runs.iter().map(Vec::len).sum::<usize>() <= MAX_POINTS || tolerance > 1000.0 {
            return runs;
        }
        tolerance *= 2.0;
    }
}

fn drawn(p: &Point) -> bool {
    !(p.0.is_nan() || p.1.is_nan())
}

fn split(points: impl Iterator<Item = Point>) -> Vec<Vec<Point>> {
    let mut runs = Runs::default();
    for p in points {
        if drawn(&p) { runs.push(p) } else { runs.gap() }
    }
    runs.done
}

fn apart(points: impl Iterator<Item = Point>, tolerance: f64) -> Vec<Vec<Point>> {
    let mut runs = Runs::default();
    let mut kept: Option<Point> = None;
    let mut skipped: Option<Point> = None;
    let far = |a: Point, b: Point| (a.0 - b.0).hypot(a.1 - b.1) > tolerance;
    for p in points {
        if !drawn(&p) {
            runs.gap();
            skipped = None;
        } else if kept.is_none_or(|k| far(k, p)) {
            runs.push(p);
            kept = Some(p);
            skipped = None;
        } else {
            skipped = Some(p);
        }
    }
    if let Some(p) = skipped {
        runs.push(p);
    }
    runs.done
}

fn columns(points: impl Iterator<Item = Point>) -> Vec<Vec<Point>> {
    let mut runs = Runs::default();
    let mut column: Option<Column> = None;
    let mut gap = false;
    for p in points {
        if !drawn(&p) {
            gap = true;
            continue;
        }
        match &mut column {
            Some(c) if c.first.0.floor() as i64 == p.0.floor() as i64 => c.take(p),
            _ => {
                if let Some(c) = &column {
                    c.flush(&mut runs);
                }
                if gap && column.as_ref().is_some_and(|c| p.0 - c.last.0 > 1.0) {
                    runs.gap();
                }
                column = Some(Column::new(p));
            }
        }
        gap = false;
    }
    if let Some(c) = &column {
        c.flush(&mut runs);
    }
    runs.done
}

/// Runs of points without a gap.
#[derive(Default)]
struct Runs {
    done: Vec<Vec<Point>>,
    open: bool,
}

impl Runs {
    fn push(&mut self, p: Point) {
        match self.done.last_mut() {
            Some(run) if self.open => run.push(p),
            _ => self.done.push(vec![p]),
        }
        self.open = true;
    }

    fn gap(&mut self) {
        self.open = false;
    }
}

/// Visible points of one pixel column; the numbers give their order.
struct Column {
    count: usize,
    first: Point,
    low: (usize, Point),
    high: (usize, Point),
    last: Point,
}

impl Column {
    fn new(p: Point) -> Self {
        Self { count: 1, first: p, low: (0, p), high: (0, p), last: p }
    }

    fn take(&mut self, p: Point) {
        if p.1 < self.low.1.1 {
            self.low = (self.count, p);
        }
        if p.1 > self.high.1.1 {
            self.high = (self.count, p);
        }
        self.last = p;
        self.count += 1;
    }

    fn flush(&self, runs: &mut Runs) {
        let mut kept = [(0, self.first), self.low, self.high, (self.count - 1, self.last)];
        kept.sort_by_key(|(order, _)| *order);
        let mut previous = None;
        for (order, p) in kept {
            if previous != Some(order) {
                runs.push(p);
            }
            previous = Some(order);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_points_keep_every_peak() {
        let n = 1_000_000;
        let spike = |i: usize| match i {
            123_456 => -40.0,
            777_777 => 90.0,
            _ => ((i * 7919) % 1000) as f64 * 0.01,
        };
        let points = (0..n).map(|i| (i as f64 * 800.0 / n as f64, spike(i)));
        let runs = thin(points.clone());
        assert_eq!(runs.len(), 1);
        assert!(runs[0].len() <= 4 * 801, "{}", runs[0].len());
        assert!(runs[0].is_sorted_by(|a, b| a.0 <= b.0));
        for column in 0..800 {
            let of = |all: &mut dyn Iterator<Item = Point>| {
                all.filter(|p| p.0 as usize == column).fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p.1), h.max(p.1)))
            };
            let from = column * n / 800;
            let mut source = points.clone().skip(from.saturating_sub(1)).take(n / 800 + 2);
            assert_eq!(of(&mut source), of(&mut runs[0].iter().copied()), "column {column}");
        }
    }

    #[test]
    fn gaps_split_short_and_long_polylines() {
        let hole = |i: usize, n: usize| if (n / 3..n / 2).contains(&i) { f64::NAN } else { 1.0 };
        for n in [12, 60_000] {
            let runs = thin((0..n).map(|i| (i as f64 * 600.0 / n as f64, hole(i, n))));
            assert_eq!(runs.len(), 2, "{n}");
        }
        assert!(thin([(f64::NAN, 1.0), (1.0, f64::NAN)].into_iter()).is_empty());
        let alternating = (0..100_000).map(|i| (f64::from(i) * 0.008, if i % 2 == 0 { 1.0 } else { f64::NAN }));
        assert_eq!(thin(alternating).len(), 1, "gaps under a pixel are closed");
    }

    #[test]
    fn a_curve_that_turns_back_stays_bounded_and_near() {
        let n = 300_000;
        let circle = (0..=n).map(|i| {
            let a = f64::from(i) / f64::from(n) * std::f64::consts::TAU * 5.0;
            (200.0 + 100.0 * a.cos(), 200.0 + 100.0 * a.sin())
        });
        let runs = thin(circle);
        assert_eq!(runs.len(), 1);
        assert!(runs[0].len() <= MAX_POINTS + 1, "{}", runs[0].len());
        for p in &runs[0] {
            assert!(((p.0 - 200.0).hypot(p.1 - 200.0) - 100.0).abs() < 1e-9);
        }
        let noise = (0..n).map(|i| (f64::from(i % 809 * 7919 % 800), f64::from(i % 211 * 7919 % 200)));
        assert!(thin(noise).iter().map(Vec::len).sum::<usize>() <= MAX_POINTS + 1);
    }
}
