//! Label placement without overlaps.

use crate::glyph::{Point, distance};
use crate::svg::{Anchor, Rect, Svg};
use crate::text::width;

/// Moves labels along a line as little as needed to separate neighbours.
///
/// `wanted` are the middles and `sizes` the lengths. The result, in the same order, keeps the labels inside `lo..hi` as
/// long as they fit there.
pub(crate) fn spread(wanted: &[f64], sizes: &[f64], lo: f64, hi: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|a, b| wanted[*a].total_cmp(&wanted[*b]));
    let mut placed = wanted.to_vec();
    let mut edge = lo;
    for &i in &order {
        placed[i] = placed[i].max(edge + 0.5 * sizes[i]);
        edge = placed[i] + 0.5 * sizes[i];
    }
    let mut edge = hi;
    for &i in order.iter().rev() {
        placed[i] = placed[i].min(edge - 0.5 * sizes[i]);
        edge = placed[i] - 0.5 * sizes[i];
    }
    placed
}

pub(crate) struct Name<'a> {
    pub(crate) text: &'a str,
    pub(crate) at: Point,
    /// Class of the line that leads to a name farther away than `near`, px.
    pub(crate) leader: &'a str,
    pub(crate) near: f64,
}

impl Name<'_> {
    /// Writes the name inside `frame`, off everything in `taken`, to which it is added.
    pub(crate) fn write(&self, svg: &mut Svg, frame: Rect, taken: &mut Vec<Rect>, ink: &[Point]) {
        let bounds = frame.inset(3.0);
        let size = Size { w: width(self.text, 12.0) + 4.0, h: 15.0 };
        let label = beside(bounds.nearest(self.at), size, bounds, taken, ink);
        let end = label.nearest(self.at);
        if distance(end, self.at) > self.near {
            svg.line(self.leader, self.at.0, self.at.1, end.0, end.1);
        }
        svg.text("halo", label.x + 0.5 * label.w, label.y + 11.5, Anchor::Middle, self.text);
        taken.push(label);
    }
}

/// Size of a label, px.
#[derive(Debug, Clone, Copy)]
struct Size {
    w: f64,
    h: f64,
}

/// Returns the position of a label of this size beside `point`. It lies inside `bounds`, off the labels in `taken`, and
/// on as few `ink` points as possible.
fn beside(point: Point, size: Size, bounds: Rect, taken: &[Rect], ink: &[Point]) -> Rect {
    let Size { w, h } = size;
    let mut best = (f64::INFINITY, Rect { x: point.0, y: point.1, w, h });
    for distance in [10.0, 18.0, 28.0, 42.0, 60.0, 84.0] {
        for turn in 0..16 {
            let (sin, cos) = (f64::from(turn) * std::f64::consts::TAU / 16.0 - 0.4).sin_cos();
            let centre = (point.0 + cos * (distance + 0.5 * w), point.1 + sin * (distance + 0.5 * h));
            let place = Rect { x: centre.0 - 0.5 * w, y: centre.1 - 0.5 * h, w, h };
            let cost = 1000.0 * outside(place, bounds)
                + taken.iter().map(|t| 100.0 * overlap(place, *t)).sum::<f64>()
                + 5.0 * ink.iter().filter(|p| holds(place, **p)).count() as f64
                + 0.2 * distance;
            if cost < best.0 {
                best = (cost, place);
            }
        }
    }
    best.1
}

fn outside(r: Rect, bounds: Rect) -> f64 {
    let over = [bounds.x - r.x, bounds.y - r.y, r.right() - bounds.right(), r.bottom() - bounds.bottom()];
    over.iter().map(|o| o.max(0.0)).sum()
}

fn overlap(a: Rect, b: Rect) -> f64 {
    let w = a.right().min(b.right()) - a.x.max(b.x);
    let h = a.bottom().min(b.bottom()) - a.y.max(b.y);
    w.max(0.0) * h.max(0.0)
}

fn holds(r: Rect, p: Point) -> bool {
    (r.x - 2.0..=r.right() + 2.0).contains(&p.0) && (r.y - 2.0..=r.bottom() + 2.0).contains(&p.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_labels_keep_apart_and_in_order() {
        let places = spread(&[50.0, 52.0, 99.0, 1.0], &[12.0; 4], 0.0, 100.0);
        let mut sorted = places.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(sorted.windows(2).all(|w| w[1] - w[0] >= 12.0 - 1e-9), "{places:?}");
        assert!(sorted[0] >= 6.0 && sorted[3] <= 94.0);
        assert!(places[3] < places[0] && places[0] < places[1] && places[1] < places[2]);
        assert!(spread(&[], &[], 0.0, 1.0).is_empty());
    }

    #[test]
    fn a_label_avoids_labels_curve_and_edge() {
        let bounds = Rect { x: 0.0, y: 0.0, w: 200.0, h: 100.0 };
        let curve: Vec<_> = (0..50).map(|i| (f64::from(i) * 4.0, 50.0)).collect();
        let size = Size { w: 60.0, h: 14.0 };
        let first = beside((100.0, 50.0), size, bounds, &[], &curve);
        let second = beside((100.0, 50.0), size, bounds, &[first], &curve);
        assert!(overlap(first, second) == 0.0);
        for place in [first, second] {
            assert!(outside(place, bounds) == 0.0 && !curve.iter().any(|p| holds(place, *p)));
        }
    }
}
