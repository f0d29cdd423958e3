use crate::chain::Turn;
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// Distance (mm) below which the wrist is on the second axis: this axis is then free.
const ON_AXIS_MM: f64 = 1e-9;
/// Sine of the angle at the elbow below which both solutions are one.
pub(super) const STRETCHED: f64 = 1e-9;

/// Upper arm and forearm: two parallel axes that move a point in the plane across them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TwoLinks {
    /// A point on the first axis, and the directions of the plane's coordinates.
    pub(super) origin: DVec3,
    pub(super) x: DVec3,
    pub(super) y: DVec3,
    /// From the first axis to the second, and from there to the point, with both axes at zero.
    pub(super) first: DVec2,
    pub(super) second: DVec2,
}

/// Turns of the two axes; none for the first if it is free.
#[derive(Debug, Clone, Copy)]
pub(super) struct LinkTurns {
    pub(super) first: Option<Turn>,
    pub(super) second: Turn,
    /// True if the links are in line.
    pub(super) stretched: bool,
}

impl TwoLinks {
    /// Coordinates of `point` in the plane, from the first axis.
    pub(super) fn coordinates(&self, point: DVec3) -> DVec2 {
        let v = point - self.origin;
        DVec2::new(v.dot(self.x), v.dot(self.y))
    }

    /// The point of the links with the second axis turned and the first one at zero.
    pub(super) fn folded(&self, second: Turn) -> DVec2 {
        self.first + second.of_plane(self.second)
    }

    /// Length of the stretched links, mm.
    pub(super) fn length(&self) -> f64 {
        self.first.length() + self.second.length()
    }

    /// The turn of the second axis that puts both links in line, stretched.
    pub(super) fn in_line(&self) -> Turn {
        Turn::along(self.second.perp().dot(self.first), self.first.dot(self.second))
    }

    /// Turns that bring the point to `target`, or the distance (mm) by which the nearest point misses it.
    pub(super) fn solve(&self, target: DVec2) -> Result<ArrayVec<LinkTurns, 2>, f64> {
        // |first + R second|^2 = |target|^2: a cosine of the angle from the stretched links.
        let (upper, fore) = (self.first.length(), self.second.length());
        let far = target.length();
        let product = upper * fore;
        let cosine = 0.5 * (far * far - upper * upper - fore * fore);
        if cosine.abs() > product * (1.0 + 1e-12) {
            return Err(if cosine > 0.0 { far - upper - fore } else { (upper - fore).abs() - far });
        }
        let sine = ((product - cosine) * (product + cosine)).max(0.0).sqrt();
        let stretched = sine < STRETCHED * product;
        let half = if stretched { Turn::along(0.0, cosine.signum()) } else { Turn::along(sine, cosine) };
        let in_line = self.in_line();
        let solution = |second: Turn| {
            let reached = self.folded(second);
            let first = (far > ON_AXIS_MM).then(|| Turn::along(reached.perp_dot(target), reached.dot(target)));
            LinkTurns { first, second, stretched }
        };
        let mut found = ArrayVec::new();
        found.push(solution(in_line.and(half)));
        if !stretched {
            found.push(solution(in_line.and(half.back())));
        }
        Ok(found)
    }
}
