use crate::convex::Convex;
use crate::placed::Placed;
use glam::{DAffine3, DVec3};

/// A convex body on its way from one pose to another, every point of it along a straight line: the hull of both ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Swept {
    from: Placed,
    to: Placed,
    /// Upper bound of the distance of any point of it from the nearer end, mm.
    beside: f64,
}

impl Swept {
    /// `body` moves from its pose to `to`.
    pub(crate) fn new(body: Placed, to: DAffine3) -> Self {
        let to = body.at(to);
        Self { from: body, to, beside: body.displacement(&to) / 2.0 }
    }
}

impl Convex for Swept {
    fn support(&self, direction: DVec3) -> DVec3 {
        let (p, q) = (self.from.support(direction), self.to.support(direction));
        if p.dot(direction) > q.dot(direction) { p } else { q }
    }

    fn radius(&self) -> f64 {
        self.from.radius()
    }

    fn at_least(&self, point: DVec3) -> f64 {
        self.from.at_least(point).min(self.to.at_least(point)) - self.beside
    }

    fn inner_point(&self) -> DVec3 {
        (self.from.inner_point() + self.to.inner_point()) / 2.0
    }
}
