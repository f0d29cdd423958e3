//! Discs on the sphere of directions, projected to discs in a plane.

use glam::{DVec2, DVec3};

#[derive(Debug, Clone, Copy)]
pub(super) struct Disc {
    centre: DVec2,
    radius: f64,
}

/// Stereographic projection of the sphere of directions from the point opposite to a pole: discs on the sphere are
/// discs in the plane, exactly.
pub(super) struct Chart {
    pole: DVec3,
    right: DVec3,
    up: DVec3,
}

impl Chart {
    pub(super) fn new(pole: DVec3) -> Self {
        let (right, up) = pole.any_orthonormal_pair();
        Self { pole, right, up }
    }

    /// The directions within the angle asin(`near` / |`v`|) of `v`, where `near` < |`v`|. None if they contain, or
    /// nearly contain, the point opposite to the pole, and so are no disc in this chart.
    pub(super) fn disc(&self, v: DVec3, near: f64) -> Option<Disc> {
        let length = v.length();
        let (c, sine) = (v / length, near / length);
        let below = ((1.0 - sine) * (1.0 + sine)).sqrt() + c.dot(self.pole);
        let centre = DVec2::new(c.dot(self.right), c.dot(self.up)) / below;
        (below > 1e-3).then_some(Disc { centre, radius: sine / below })
    }

    /// The direction at a position of the chart, a unit vector.
    pub(super) fn direction(&self, at: DVec2) -> DVec3 {
        let square = at.length_squared();
        ((1.0 - square) * self.pole + 2.0 * (at.x * self.right + at.y * self.up)) / (1.0 + square)
    }
}

impl Disc {
    fn has(&self, at: DVec2) -> bool {
        at.distance_squared(self.centre) <= (self.radius * (1.0 + 1e-9) + 1e-15).powi(2)
    }

    /// Intersections of two circles; none if one is inside the other or they are apart.
    fn crossings(&self, other: &Self) -> Option<[DVec2; 2]> {
        let way = other.centre - self.centre;
        let far = way.length();
        if far > self.radius + other.radius || far <= (self.radius - other.radius).abs() {
            return None;
        }
        let along = 0.5 * (far + (self.radius - other.radius) * (self.radius + other.radius) / far);
        let across = ((self.radius - along) * (self.radius + along)).max(0.0).sqrt();
        let unit = way / far;
        let foot = self.centre + along * unit;
        Some([foot + across * unit.perp(), foot - across * unit.perp()])
    }
}

/// A position common to all discs: the mean of the corners of their intersection. None if it is empty.
pub(super) fn common(discs: &[Disc]) -> Option<DVec2> {
    let (mut sum, mut corners) = (DVec2::ZERO, 0u32);
    for (i, one) in discs.iter().enumerate() {
        for (j, other) in discs.iter().enumerate().skip(i + 1) {
            for at in one.crossings(other).into_iter().flatten() {
                if discs.iter().enumerate().all(|(k, disc)| k == i || k == j || disc.has(at)) {
                    sum += at;
                    corners += 1;
                }
            }
        }
    }
    if corners > 0 {
        return Some(sum / f64::from(corners));
    }
    // Without corners the intersection is the smallest disc.
    let least = discs.iter().min_by(|a, b| a.radius.total_cmp(&b.radius))?;
    let inside = |disc: &Disc| disc.centre.distance(least.centre) + least.radius <= disc.radius * (1.0 + 1e-9) + 1e-15;
    discs.iter().all(inside).then_some(least.centre)
}

/// The last disc and two others without a common position, if the last disc made the intersection of all empty. By
/// Helly's theorem they exist in a plane; rounding may hide them.
pub(super) fn apart(discs: &[Disc]) -> Option<[usize; 3]> {
    let last = discs.len() - 1;
    for i in 0..last {
        for j in i..last {
            let three = [discs[i], discs[j], discs[last]];
            if common(if i == j { &three[1..] } else { &three }).is_none() {
                return Some([i, j, last]);
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(seed: u32) -> impl FnMut() -> f64 {
        let mut k = f64::from(seed);
        move || {
            k += 1.0;
            ((k * 12.9898).sin() * 43_758.545_3).rem_euclid(1.0)
        }
    }

    #[test]
    fn discs_of_the_chart_are_those_of_the_sphere() {
        let mut next = numbers(1);
        let mut vector = move || DVec3::new(next() - 0.5, next() - 0.5, next() - 0.5);
        for _ in 0..20_000 {
            let (pole, v, at) = (vector().normalize(), vector(), vector().normalize());
            let near = v.length() * vector().x.abs();
            let chart = Chart::new(pole);
            let Some(disc) = chart.disc(v, near) else { continue };
            let place = DVec2::new(at.dot(chart.right), at.dot(chart.up)) / (1.0 + at.dot(pole));
            assert!((chart.direction(place) - at).length() < 1e-9 / (1.0 + at.dot(pole)));
            let over = at.cross(v).length() - near;
            if over.abs() > 1e-6 {
                assert_eq!(disc.has(place), over < 0.0 && at.dot(v) > 0.0);
            }
        }
    }

    #[test]
    fn common_places_are_found_as_by_looking_everywhere() {
        let mut next = numbers(7);
        for case in 0..2000 {
            let discs: Vec<Disc> = (0..2 + case % 5)
                .map(|_| Disc { centre: DVec2::new(next(), next()), radius: 0.1 + 0.6 * next() })
                .collect();
            let grid = (0..100 * 100).map(|k| DVec2::new(f64::from(k % 100), f64::from(k / 100)) * 0.01);
            let seen = grid.into_iter().any(|at| discs.iter().all(|d| at.distance(d.centre) < d.radius));
            match common(&discs) {
                Some(at) => assert!(discs.iter().all(|d| d.has(at))),
                None => assert!(!seen, "{discs:?}"),
            }
            // Helly: if every three discs intersect, all do.
            let first = (2..=discs.len()).find(|n| common(&discs[..*n]).is_none());
            assert!(first.is_none_or(|n| apart(&discs[..n]).is_some()));
        }
    }
}
