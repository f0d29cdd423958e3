use glam::DVec2;
use seamwright_document::{NonNegative, Positive};
use seamwright_program::{DoubleU, J, TJ, U};
use std::f64::consts::FRAC_PI_2;

/// Chords of an arc.
const CHORDS: u32 = 24;

/// Length of an edge's straight part, as a multiple of the depth: it is cut off at the part's surface.
const FAR: f64 = 1e3;

/// Shape of one part's edge, from the root out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Profile {
    /// Straight all the way.
    Square,
    /// Root face, then straight at this angle from the depth direction, rad.
    Bevel { root_face: f64, angle: f64 },
    /// Root face, land, an arc, then straight at this angle.
    Curved { root_face: f64, angle: f64, radius: f64, land: f64 },
    /// A round part that touches at depth `radius`; next to the contact `unfilled` is left.
    Round { radius: f64, unfilled: f64 },
    /// A preparation without a root face, `depth` deep at this angle, gouged below: round at the bottom, then straight at
    /// the angle `side`.
    Gouged { depth: f64, angle: f64, radius: f64, side: f64 },
}

impl Profile {
    fn curved(root_face: NonNegative, degrees: NonNegative, radius: Positive, land: NonNegative) -> Self {
        let angle = degrees.get().to_radians();
        Self::Curved { root_face: root_face.get(), angle, radius: radius.get(), land: land.get() }
    }

    /// Angle of its straight part from the depth direction, rad; `None` on a round part.
    pub(crate) fn angle(self) -> Option<f64> {
        match self {
            Self::Square => Some(0.0),
            Self::Bevel { angle, .. } | Self::Curved { angle, .. } => Some(angle),
            Self::Gouged { angle, side, .. } => Some(angle.max(side)),
            Self::Round { .. } => None,
        }
    }

    /// The same with the root face, a part of the wall's thickness, longer by this factor: as long as it is in a section
    /// whose depth does not go square through the wall.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Bevel { root_face, angle } => Self::Bevel { root_face: factor * root_face, angle },
            Self::Curved { root_face, angle, radius, land } => {
                Self::Curved { root_face: factor * root_face, angle, radius, land }
            }
            Self::Gouged { depth, angle, radius, side } => Self::Gouged { depth: factor * depth, angle, radius, side },
            Self::Square | Self::Round { .. } => self,
        }
    }

    /// The same without a root face.
    pub(crate) fn without_root_face(self) -> Self {
        match self {
            Self::Bevel { angle, .. } => Self::Bevel { root_face: 0.0, angle },
            Self::Curved { angle, radius, land, .. } => Self::Curved { root_face: 0.0, angle, radius, land },
            Self::Square | Self::Round { .. } | Self::Gouged { .. } => self,
        }
    }

    /// The same, `depth` deep and gouged below, with this radius at the bottom and this angle at the sides.
    pub(crate) fn gouged(self, depth: f64, radius: f64, side: f64) -> Self {
        Self::Gouged { depth, angle: self.angle().unwrap_or(0.0), radius, side }
    }

    /// Corners of the edge in (lateral, depth), mm, from the root at lateral `gap` and depth `thickness` on, until far
    /// outside of the part; a round edge ends where it touches the surface.
    pub(crate) fn corners(self, gap: f64, thickness: f64) -> Vec<DVec2> {
        let root = DVec2::new(gap, thickness);
        let out = |from: DVec2, angle: f64| from + FAR * thickness * DVec2::new(angle.sin(), -angle.cos());
        match self {
            Self::Square => vec![root, out(root, 0.0)],
            Self::Bevel { root_face, angle } => {
                let edge = DVec2::new(gap, thickness - root_face);
                let mut corners = vec![root, edge, out(edge, angle)];
                corners.dedup();
                corners
            }
            Self::Curved { root_face, angle, radius, land } => {
                let edge = DVec2::new(gap, thickness - root_face);
                let centre = edge + DVec2::new(land, -radius);
                let sweep = FRAC_PI_2 - angle;
                let on_arc = |k: u32| {
                    let turn = sweep * f64::from(k) / f64::from(CHORDS);
                    centre + corner_radius(radius, sweep, k) * DVec2::new(turn.sin(), turn.cos())
                };
                let mut corners = vec![root, edge];
                corners.extend((0..=CHORDS).map(on_arc));
                corners.push(out(on_arc(CHORDS), angle));
                corners.dedup();
                corners
            }
            Self::Gouged { depth, angle, radius, side } => {
                let gouge = Self::Curved { root_face: 0.0, angle: side, radius, land: 0.0 }.corners(0.0, thickness);
                wider(&gouge, DVec2::new(gap, depth), angle)
            }
            Self::Round { radius, unfilled } => {
                // By the angle about the round part's axis, from that of the contact up to the surface.
                let first = (unfilled / radius).asin();
                let on_arc = |k: u32| {
                    let sweep = FRAC_PI_2 - first;
                    let turn = first + sweep * f64::from(k) / f64::from(CHORDS);
                    let at = corner_radius(radius, sweep, k) * DVec2::new(turn.cos(), turn.sin());
                    DVec2::new(gap, 0.0) + DVec2::splat(radius) - at
                };
                (0..=CHORDS).map(on_arc).collect()
            }
        }
    }
}

/// The wider of a gouge and of the bevel at `angle` above its own root, at each depth, from the gouge's bottom out.
fn wider(gouge: &[DVec2], root: DVec2, angle: f64) -> Vec<DVec2> {
    let bevel = |y: f64| root.x + (root.y - y) * angle.tan();
    let below = gouge.partition_point(|p| p.y > root.y);
    let mut corners = gouge[..below].to_vec();
    let (Some(last), Some(next)) = (corners.last().copied(), gouge.get(below).copied()) else { return gouge.to_vec() };
    // Where the bevel's root is wider than the gouge, a step leads out to it.
    let at_root = last + (next - last) * ((last.y - root.y) / (last.y - next.y));
    corners.push(at_root);
    let above: Vec<DVec2> = std::iter::once(at_root).chain(gouge[below..].iter().copied()).collect();
    corners.push(DVec2::new(at_root.x.max(root.x), root.y));
    for pair in above.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|p| p.x - bevel(p.y));
        if a * b < 0.0 {
            corners.push(pair[0] + (pair[1] - pair[0]) * (a / (a - b)));
        }
        corners.push(DVec2::new(pair[1].x.max(bevel(pair[1].y)), pair[1].y));
    }
    corners.dedup();
    corners
}

/// Distance of corner `k` of an arc's chords from its centre: a little more than the radius between the arc's ends, so
/// that the chords enclose the arc's area within 0.003 % of the radius' square.
fn corner_radius(radius: f64, sweep: f64, k: u32) -> f64 {
    let step = sweep / f64::from(CHORDS);
    if k == 0 || k == CHORDS { radius } else { radius * (step / step.sin()).sqrt() }
}

impl From<&U> for Profile {
    fn from(p: &U) -> Self {
        Self::curved(p.root_face_mm, p.angle_deg, p.radius_mm, p.land_mm)
    }
}

impl From<&DoubleU> for Profile {
    fn from(p: &DoubleU) -> Self {
        Self::curved(p.root_face_mm, p.angle_deg, p.radius_mm, p.land_mm)
    }
}

impl From<&J> for Profile {
    fn from(p: &J) -> Self {
        Self::curved(p.root_face_mm, p.angle_deg, p.radius_mm, p.land_mm)
    }
}

impl From<&TJ> for Profile {
    fn from(p: &TJ) -> Self {
        Self::curved(p.root_face_mm, p.angle_deg, p.radius_mm, p.land_mm)
    }
}
