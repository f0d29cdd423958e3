use crate::arc::Arc;
use crate::curve::{Curve, Jet};
use crate::curve_chain::{Chain, Piece};
use crate::error::{Error, positive, unit};
use crate::line::Line;
use glam::{DVec2, DVec3, Vec2Swizzles};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Straight sides and corner radii below this fraction of the size are rounding and left out.
const NOTHING: f64 = 1e-9;

/// A rectangle in space whose corners are rounded, or sharp: `u` is the length in mm from the middle of the side that
/// the width's direction points to, counter-clockwise seen from the tip of the normal.
#[derive(Debug, Clone, PartialEq)]
pub struct RoundedRectangle {
    chain: Chain,
    centre: DVec3,
    /// Unit vectors along width and height.
    e1: DVec3,
    e2: DVec3,
    /// Half of width and height, mm.
    half: DVec2,
    corner: f64,
}

impl RoundedRectangle {
    /// The rectangle about `centre` in the plane with `normal`, as wide as `size.x` along `direction` (made
    /// perpendicular to the normal) and as high as `size.y` across it, its corners arcs of radius `corner` (0: sharp),
    /// mm.
    ///
    /// # Errors
    /// [`Error::Size`] for sizes not greater than 0 and a corner that is negative or greater than half the smaller
    /// side, [`Error::Direction`] and [`Error::Parallel`] for directions that span no plane.
    pub fn new(centre: DVec3, normal: DVec3, direction: DVec3, size: DVec2, corner: f64) -> Result<Self, Error> {
        let half = 0.5 * DVec2::new(positive("geometry-width", size.x)?, positive("geometry-height", size.y)?);
        let smaller = half.min_element();
        if !(0.0..=smaller * (1.0 + NOTHING)).contains(&corner) {
            return Err(Error::Size { what: "geometry-corner-radius", value: corner });
        }
        let corner = if corner < NOTHING * smaller { 0.0 } else { corner.min(smaller) };
        let n = unit("geometry-rectangle-normal", normal)?;
        let x = unit("geometry-width-direction", direction)?;
        let across = x - x.dot(n) * n;
        if across.length() < 1e-9 {
            return Err(Error::Parallel { first: "geometry-rectangle-normal", second: "geometry-width-direction" });
        }
        let e1 = across.normalize();
        let e2 = n.cross(e1);
        let at = |p: DVec2| centre + p.x * e1 + p.y * e2;
        let mut pieces = Vec::new();
        let mut from = DVec2::new(half.x, 0.0);
        // Each corner with the side before it; the last side ends where the first began.
        for (i, (sx, sy)) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].into_iter().enumerate() {
            let middle = DVec2::new(sx, sy) * (half - corner);
            let (sin, cos) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][i];
            let start = middle + corner * DVec2::new(cos, sin);
            let end = middle + corner * DVec2::new(-sin, cos);
            push_line(&mut pieces, at(from), at(start), smaller)?;
            if corner > 0.0 {
                pieces.push(Piece::Arc(Arc::new(at(middle), n, at(start), FRAC_PI_2)?));
            }
            from = end;
        }
        push_line(&mut pieces, at(from), at(DVec2::new(half.x, 0.0)), smaller)?;
        Ok(Self { chain: Chain::new(pieces, true)?, centre, e1, e2, half, corner })
    }

    /// The angle (rad) about the normal at parameter `u`, from the direction of the width, counted on beyond a turn.
    pub fn angle(&self, u: f64) -> f64 {
        let turns = (u / self.chain.domain().1).floor();
        let p = self.chain.point(u) - self.centre;
        let angle = p.dot(self.e2).atan2(p.dot(self.e1)).rem_euclid(TAU);
        // At the start and end of a turn, rounding may put the angle on the other side.
        let part = u / self.chain.domain().1 - turns;
        let beyond = if (part - angle / TAU).abs() > 0.5 { (part - angle / TAU).signum() } else { 0.0 };
        (turns + beyond) * TAU + angle
    }

    /// The parameter at an `angle` (rad) about the normal: the inverse of [`RoundedRectangle::angle`].
    pub fn at_angle(&self, angle: f64) -> f64 {
        let turns = (angle / TAU).floor();
        let (sin, cos) = angle.sin_cos();
        let ray = DVec2::new(cos, sin);
        // Intersection of the ray with the sharp rectangle; in a corner, with the arc.
        let out = self.half / ray.abs();
        let mut p = ray * out.min_element();
        let middle = self.half - self.corner;
        if p.x.abs() > middle.x && p.y.abs() > middle.y {
            let along = ray.abs().dot(middle);
            let off = ray.abs().perp_dot(middle);
            p = ray * (along + (self.corner * self.corner - off * off).max(0.0).sqrt());
        }
        turns * self.chain.domain().1 + self.length_to(p, angle - turns * TAU)
    }

    /// The length from the start to a point of the rectangle at an `angle` within the first turn.
    fn length_to(&self, p: DVec2, angle: f64) -> f64 {
        let straight = self.half - self.corner;
        let quarter = FRAC_PI_2 * self.corner + straight.x + straight.y;
        let quadrant = (angle / FRAC_PI_2).floor().clamp(0.0, 3.0);
        // Within a quadrant: from the middle of one side to that of the next. One sum of the way along the first side,
        // the turn of the arc and the way along the second, each clamped to its ends: no case distinction is needed.
        let even = (quadrant as u8).is_multiple_of(2);
        let (p, straight) = if even { (p.abs(), straight) } else { (p.abs().yx(), straight.yx()) };
        let off = (p - straight).max(DVec2::ZERO);
        let length = p.y.min(straight.y) + self.corner * off.y.atan2(off.x) + (straight.x - p.x).max(0.0);
        quadrant * quarter + length
    }
}

fn push_line(pieces: &mut Vec<Piece>, from: DVec3, to: DVec3, size: f64) -> Result<(), Error> {
    if from.distance(to) > NOTHING * size {
        pieces.push(Piece::Line(Line::new(from, to)?));
    }
    Ok(())
}

impl Curve for RoundedRectangle {
    fn domain(&self) -> (f64, f64) {
        self.chain.domain()
    }
    fn closed(&self) -> bool {
        true
    }
    fn jet(&self, u: f64) -> Jet {
        self.chain.jet(u)
    }
    fn breaks(&self) -> Vec<f64> {
        let mut breaks = self.chain.breaks();
        // The start is in the middle of a side.
        if self.half.y - self.corner > NOTHING * self.half.min_element() {
            breaks.remove(0);
        }
        breaks
    }
}
