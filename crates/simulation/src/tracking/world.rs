use super::displacement::Displacement;
use glam::{DQuat, DVec2, DVec3};
use seamwright_executive::tracking::PassPosition;
use seamwright_tracking::lead::SeamFrame;

/// Placement error of a whole part, in the work frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Shift, mm.
    pub shift: DVec3,
    /// Rotation about `about`.
    pub turn: DQuat,
    /// Centre of the rotation, mm.
    pub about: DVec3,
}

impl Placement {
    /// Placement as taught.
    pub const RIGHT: Self = Self { shift: DVec3::ZERO, turn: DQuat::IDENTITY, about: DVec3::ZERO };
}

/// Hidden truth of one seam: taught and true position.
pub struct World<'a> {
    /// The taught seam by path length, also some way beyond its ends.
    pub taught: &'a (dyn Fn(f64) -> SeamFrame + Sync),
    /// Displacement of the seam.
    pub displacement: Displacement,
    /// Placement of its part.
    pub placement: Placement,
    /// Position of the pass on the seam, to which the displacement refers.
    pub along: PassPosition,
    /// Start and end of the joint by path length, mm; `None`: everywhere.
    pub ends_mm: Option<(f64, f64)>,
}

/// Search range for a crossing of a plane, to both sides of its expected position, mm.
const REACH_MM: f64 = 12.0;

impl World<'_> {
    /// Returns the position of the seam at path length `s` of the taught one while the pool is at `pool`.
    #[must_use]
    pub fn place(&self, s: f64, pool: f64) -> DVec3 {
        let frame = (self.taught)(s);
        let place = self.along.place(s);
        // Heat sees the pool at the distance `s - pool`, with the same sign.
        let by = self.displacement.at(place, place - (s - pool));
        let by = if self.along.reverse { DVec2::new(-by.x, by.y) } else { by };
        let bent = frame.point + by.x * frame.lateral + by.y * frame.height;
        self.placement.about + self.placement.turn * (bent - self.placement.about) + self.placement.shift
    }

    /// Returns the distance from path length `s` to the end of the joint, mm; infinite for a closed one.
    #[must_use]
    pub fn left(&self, s: f64) -> f64 {
        self.ends_mm.map_or(f64::INFINITY, |(_, end)| end - s)
    }

    /// Returns true if there is a joint at path length `s`.
    #[must_use]
    pub fn has(&self, s: f64) -> bool {
        self.ends_mm.is_none_or(|(from, to)| (from..=to).contains(&s))
    }

    /// Intersects the seam with the plane square to the torch's way, `ahead` mm before the torch at `s`. Returns
    /// lateral and height from the taught torch, mm, and the path length there; `None` without an intersection within
    /// reach.
    #[must_use]
    pub fn crossing(&self, s: f64, ahead: f64, pool: f64) -> Option<(DVec2, f64)> {
        let frame = (self.taught)(s);
        let off = |place: f64| self.place(place, pool) - frame.point;
        let way = |place: f64| off(place).dot(frame.along) - ahead;
        let found = |place: f64| {
            let off = off(place);
            (DVec2::new(off.dot(frame.lateral), off.dot(frame.height)), place)
        };
        // The way is nearly straight: mostly a few secant steps from the expected position are enough.
        let (mut before, mut place) = ((s + ahead, way(s + ahead)), s + ahead);
        place -= before.1;
        for _ in 0..6 {
            let here = way(place);
            if here.abs() < 1e-10 && (place - s - ahead).abs() < REACH_MM {
                return Some(found(place));
            }
            let slope = (here - before.1) / (place - before.0);
            before = (place, here);
            place -= here / slope;
        }
        let (mut low, mut high) = (s + ahead - REACH_MM, s + ahead + REACH_MM);
        if way(low) > 0.0 || way(high) < 0.0 {
            return None;
        }
        // False position with halving (Illinois).
        let (mut at_low, mut at_high) = (way(low), way(high));
        place = 0.5 * (low + high);
        for _ in 0..40 {
            place = (low * at_high - high * at_low) / (at_high - at_low);
            let here = way(place);
            if here.abs() < 1e-10 || high - low < 1e-10 {
                break;
            }
            if here > 0.0 {
                (high, at_high, at_low) = (place, here, 0.5 * at_low);
            } else {
                (low, at_low, at_high) = (place, here, 0.5 * at_high);
            }
        }
        Some(found(place))
    }

    /// Returns the deviation of the weld from the seam, lateral and height, mm, with the torch at `s` and its slide
    /// at `slide`.
    #[must_use]
    pub fn miss(&self, s: f64, slide: DVec2) -> Option<DVec2> {
        self.crossing(s, 0.0, s).map(|(seam, _)| slide - seam)
    }
}

#[cfg(test)]
mod tests {
    use super::super::displacement::Part;
    use super::*;

    fn straight(s: f64) -> SeamFrame {
        SeamFrame { point: DVec3::X * s, along: DVec3::X, lateral: DVec3::Y, height: DVec3::Z }
    }

    fn circle(s: f64) -> SeamFrame {
        let (sin, cos) = (s / 300.0).sin_cos();
        let point = 300.0 * DVec3::new(sin, 1.0 - cos, 0.0);
        SeamFrame { point, along: DVec3::new(cos, sin, 0.0), lateral: DVec3::new(-sin, cos, 0.0), height: DVec3::Z }
    }

    #[test]
    fn on_a_straight_seam_the_miss_is_the_displacement() {
        let wave = Part::Wave { length_mm: 40.0, size: DVec2::new(1.0, 0.5), phase: DVec2::new(0.3, 1.0) };
        let displacement = Displacement::of(wave);
        let world = World {
            taught: &straight,
            displacement: displacement.clone(),
            placement: Placement::RIGHT,
            along: PassPosition::default(),
            ends_mm: None,
        };
        for i in 0..1000 {
            let s = 0.37 * f64::from(i);
            let miss = world.miss(s, DVec2::new(0.1, 0.2)).unwrap();
            assert!(miss.distance(DVec2::new(0.1, 0.2) - displacement.at(s, s)) < 1e-9);
        }
    }

    /// A circle shifted as a whole: its intersection with a line has a closed form.
    #[test]
    fn of_a_shifted_circle() {
        let shift = DVec3::new(1.3, -0.8, 0.6);
        let placement = Placement { shift, ..Placement::RIGHT };
        let world = World {
            taught: &circle,
            displacement: Displacement::default(),
            placement,
            along: PassPosition::default(),
            ends_mm: None,
        };
        for i in 0..500 {
            let s = f64::from(i);
            for ahead in [0.0, 20.0] {
                let frame = circle(s);
                let (seen, _) = world.crossing(s, ahead, s).unwrap();
                let point = frame.point + ahead * frame.along + seen.x * frame.lateral;
                let centre = DVec3::new(0.0, 300.0, 0.0) + shift;
                assert!((point.distance(centre.with_z(0.0)) - 300.0).abs() < 1e-8);
                assert!((seen.y - 0.6).abs() < 1e-12 && seen.x.abs() < 3.0);
            }
        }
    }
}
