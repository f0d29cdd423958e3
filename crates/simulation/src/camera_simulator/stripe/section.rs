//! True cross-sections of joints in the plane of the laser.

use crate::camera_simulator::random::Random;
use glam::DVec2;
use seamwright_vision::stripe::{Feature, JointKind, Quantity};
use std::f64::consts::{FRAC_PI_2, PI};

/// Extent of the parts to both sides, mm.
const REACH: f64 = 80.0;

const ARC_PIECES: usize = 40;

/// A joint's cross-section. Lengths in mm, angles in rad. The joint's own frame has its root at the origin and the upper
/// faces level (a fillet's bisector upright).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Section {
    /// A web on a skin.
    Fillet {
        /// Angle between the faces.
        angle: f64,
        /// Distance of the web's end from the skin.
        gap: f64,
    },
    /// A V groove.
    V {
        /// Bevel of each side, from the upright.
        bevels: [f64; 2],
        /// Depth of the groove's walls.
        depth: f64,
        /// Root gap.
        gap: f64,
        /// Height of the right plate over the left one; 0 without a gap.
        mismatch: f64,
    },
    /// A U groove.
    U {
        /// Bevel of the walls above the arcs.
        bevel: f64,
        /// Radius of the arcs.
        radius: f64,
        /// Depth to the root.
        depth: f64,
        /// Root gap.
        gap: f64,
    },
    /// A J groove: the right side curved, the left one upright.
    J {
        /// Bevel of the wall above the arc.
        bevel: f64,
        /// Radius of the arc.
        radius: f64,
        /// Depth to the root.
        depth: f64,
        /// Root gap.
        gap: f64,
    },
    /// The left sheet on the right one.
    Lap {
        /// Thickness of the upper sheet.
        thickness: f64,
        /// Distance between the sheets.
        gap: f64,
    },
    /// Two plates end to end.
    Butt {
        /// Gap; 0: a dark line only.
        gap: f64,
        /// Height of the right plate over the left one.
        mismatch: f64,
    },
    /// A plate without a joint.
    Plate,
    /// Two plates with an edge between them that is not a joint to weld: an outside corner.
    Ridge {
        /// Angle of the material.
        angle: f64,
    },
}

/// Pose of the joint's frame in the sensor's plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Placement {
    /// The joint point, mm.
    pub at: DVec2,
    /// Turn, rad.
    pub turn: f64,
    /// Left and right are exchanged.
    pub mirrored: bool,
}

impl Placement {
    fn place(&self, p: DVec2) -> DVec2 {
        let p = if self.mirrored { DVec2::new(-p.x, p.y) } else { p };
        self.at + DVec2::from_angle(self.turn).rotate(p)
    }
}

/// Truth of a joint in the sensor's plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// Kind of joint; `None` for sections without one.
    pub kind: Option<JointKind>,
    /// Its points, mm.
    pub points: Vec<(Feature, DVec2)>,
    /// Its lengths, areas and angles, mm and rad.
    pub values: Vec<(Quantity, f64)>,
    /// Dark point of a closed butt joint.
    pub dark: Option<DVec2>,
}

impl Truth {
    /// Returns the joint point.
    pub fn joint(&self) -> Option<DVec2> {
        self.points.iter().find(|p| p.0 == Feature::Joint).map(|p| p.1)
    }
}

impl Section {
    /// Creates a joint of the kind with random sizes.
    pub fn random(kind: JointKind, seed: u64) -> Self {
        let random = &mut Random::new(seed ^ 0x5ec7_1011);
        let gap = |random: &mut Random, most: f64| if random.chance(0.3) { 0.0 } else { random.within(0.3, most) };
        let degrees = |random: &mut Random, a: f64, b: f64| random.within(a, b).to_radians();
        match kind {
            JointKind::Fillet => Self::Fillet { angle: degrees(random, 65.0, 115.0), gap: gap(random, 1.5) },
            JointKind::V => {
                let (bevels, depth) = ([(); 2].map(|()| degrees(random, 22.0, 35.0)), random.within(4.0, 9.0));
                let gap = gap(random, 2.5);
                // If root faces touch, a mismatch would hide one of the roots.
                Self::V { bevels, depth, gap, mismatch: if gap > 0.0 { random.within(-0.8, 0.8) } else { 0.0 } }
            }
            JointKind::U | JointKind::J => {
                let (radius, gap) = (random.within(3.5, 6.0), gap(random, 2.0));
                let (bevel, depth) = (degrees(random, 8.0, 15.0), radius + random.within(1.5, 4.0));
                if kind == JointKind::U {
                    Self::U { bevel, radius, depth, gap }
                } else {
                    Self::J { bevel, radius, depth, gap }
                }
            }
            JointKind::Lap => Self::Lap { thickness: random.within(1.5, 4.0), gap: random.within(0.0, 1.0) },
            JointKind::Butt => Self::Butt {
                gap: gap(random, 2.0),
                mismatch: if random.chance(0.3) { 0.0 } else { random.within(-0.7, 0.7) },
            },
        }
    }

    /// Returns the surfaces as lines of points; the laser shines from above.
    pub(super) fn surfaces(&self, placement: &Placement) -> Vec<Vec<DVec2>> {
        let p = DVec2::new;
        let lines = match *self {
            Self::Fillet { angle, gap } => {
                let (sin, cos) = (angle / 2.0).sin_cos();
                let (skin, web) = (p(sin, cos), p(-sin, cos));
                let end = web * (gap / angle.sin());
                vec![vec![web * REACH, end, end - 10.0 * skin], vec![-10.0 * skin, skin * REACH]]
            }
            Self::V { bevels, depth, gap, mismatch } => {
                let [left, right] = bevels.map(|b| depth * b.tan() + gap / 2.0);
                vec![
                    vec![p(-REACH, 0.0), p(-left, 0.0), p(-gap / 2.0, -depth), p(-gap / 2.0, -depth - 2.0)],
                    vec![p(gap / 2.0, -depth - 2.0), p(gap / 2.0, -depth), p(right, 0.0), p(REACH, 0.0)]
                        .into_iter()
                        .map(|q| q + p(0.0, mismatch))
                        .collect(),
                ]
            }
            Self::U { bevel, radius, depth, gap } => {
                let right = curved(bevel, radius, depth, gap);
                vec![right.iter().rev().map(|q| p(-q.x, q.y)).collect(), right]
            }
            Self::J { bevel, radius, depth, gap } => vec![
                vec![p(-REACH, 0.0), p(-gap / 2.0, 0.0), p(-gap / 2.0, -depth - 2.0)],
                curved(bevel, radius, depth, gap),
            ],
            Self::Lap { thickness, gap } => vec![
                vec![p(-REACH, thickness + gap), p(0.0, thickness + gap), p(0.0, gap), p(-20.0, gap)],
                vec![p(-REACH, 0.0), p(REACH, 0.0)],
            ],
            Self::Butt { gap, mismatch } => vec![
                vec![p(-REACH, 0.0), p(-gap / 2.0, 0.0), p(-gap / 2.0, -4.0)],
                vec![p(gap / 2.0, mismatch - 4.0), p(gap / 2.0, mismatch), p(REACH, mismatch)],
            ],
            Self::Plate => vec![vec![p(-REACH, 0.0), p(REACH, 0.0)]],
            Self::Ridge { angle } => {
                let (sin, cos) = (angle / 2.0).sin_cos();
                vec![vec![p(-sin, -cos) * REACH, DVec2::ZERO, p(sin, -cos) * REACH]]
            }
        };
        let place = |line: Vec<DVec2>| line.into_iter().map(|q| placement.place(q)).collect();
        lines.into_iter().map(place).collect()
    }

    /// Returns the truth of the section in this placement.
    pub fn truth(&self, placement: &Placement) -> Truth {
        let p = DVec2::new;
        let mut dark = None;
        let (kind, points, values) = match *self {
            Self::Fillet { angle, gap } => (
                Some(JointKind::Fillet),
                vec![(Feature::Joint, DVec2::ZERO)],
                vec![(Quantity::Angle, angle), (Quantity::Gap, gap)],
            ),
            Self::V { bevels, depth, gap, mismatch } => {
                let [a, b] = bevels.map(|b| depth * b.tan() + gap / 2.0);
                let [left, right] = [p(-a, 0.0), p(b, mismatch)];
                let roots = [p(-gap / 2.0, -depth), p(gap / 2.0, mismatch - depth)];
                let joint = (roots[0] + roots[1]) / 2.0;
                // Area of the polygon of edges and roots.
                let corners = [left, roots[0], roots[1], right];
                let area: f64 = (0..4).map(|i| corners[i].perp_dot(corners[(i + 1) % 4])).sum::<f64>() / 2.0;
                let mismatch = if placement.mirrored { -mismatch } else { mismatch };
                (
                    Some(JointKind::V),
                    vec![(Feature::Joint, joint), (Feature::LeftEdge, left), (Feature::RightEdge, right)],
                    vec![
                        (Quantity::Gap, gap),
                        (Quantity::Mismatch, mismatch),
                        (Quantity::Area, area),
                        (Quantity::Angle, bevels[0] + bevels[1]),
                    ],
                )
            }
            Self::U { bevel, radius, depth, gap } => {
                let half = curved_width(bevel, radius, depth) + gap / 2.0;
                let area = 2.0 * curved_area(bevel, radius, depth) + gap * depth;
                (
                    Some(JointKind::U),
                    vec![
                        (Feature::Joint, p(0.0, -depth)),
                        (Feature::LeftEdge, p(-half, 0.0)),
                        (Feature::RightEdge, p(half, 0.0)),
                    ],
                    vec![
                        (Quantity::Gap, gap),
                        (Quantity::Radius, radius),
                        (Quantity::Area, area),
                        (Quantity::Angle, 2.0 * bevel),
                    ],
                )
            }
            Self::J { bevel, radius, depth, gap } => {
                let right = curved_width(bevel, radius, depth) + gap / 2.0;
                (
                    Some(JointKind::J),
                    vec![
                        (Feature::Joint, p(0.0, -depth)),
                        (Feature::LeftEdge, p(-gap / 2.0, 0.0)),
                        (Feature::RightEdge, p(right, 0.0)),
                    ],
                    vec![
                        (Quantity::Gap, gap),
                        (Quantity::Radius, radius),
                        (Quantity::Area, curved_area(bevel, radius, depth) + gap * depth),
                    ],
                )
            }
            Self::Lap { thickness, gap } => (
                Some(JointKind::Lap),
                vec![(Feature::Joint, DVec2::ZERO), (Feature::UpperEdge, p(0.0, thickness + gap))],
                vec![(Quantity::Height, thickness + gap), (Quantity::Gap, gap)],
            ),
            Self::Butt { gap, mismatch } => {
                if gap < 0.1 && mismatch.abs() < 0.1 {
                    dark = Some(placement.place(DVec2::ZERO));
                }
                let edges = [p(-gap / 2.0, 0.0), p(gap / 2.0, mismatch)];
                (
                    Some(JointKind::Butt),
                    vec![
                        (Feature::Joint, (edges[0] + edges[1]) / 2.0),
                        (Feature::LeftEdge, edges[0]),
                        (Feature::RightEdge, edges[1]),
                    ],
                    vec![
                        (Quantity::Gap, gap),
                        (Quantity::Mismatch, if placement.mirrored { -mismatch } else { mismatch }),
                    ],
                )
            }
            Self::Plate | Self::Ridge { .. } => (None, Vec::new(), Vec::new()),
        };
        let other = |feature: Feature| match feature {
            Feature::LeftEdge if placement.mirrored => Feature::RightEdge,
            Feature::RightEdge if placement.mirrored => Feature::LeftEdge,
            same => same,
        };
        let points = points.into_iter().map(|(f, q)| (other(f), placement.place(q))).collect();
        Truth { kind, points, values, dark }
    }
}

/// Returns the right side of a U groove, from below the root to the far end of the surface.
fn curved(bevel: f64, radius: f64, depth: f64, gap: f64) -> Vec<DVec2> {
    let centre = DVec2::new(gap / 2.0, radius - depth);
    let at = |i: usize| {
        let angle = -FRAC_PI_2 + (FRAC_PI_2 - bevel) * i as f64 / ARC_PIECES as f64;
        centre + radius * DVec2::from_angle(angle)
    };
    let below = DVec2::new(gap / 2.0, -depth - 2.0);
    let edge = DVec2::new(gap / 2.0 + curved_width(bevel, radius, depth), 0.0);
    std::iter::once(below).chain((0..=ARC_PIECES).map(at)).chain([edge, DVec2::new(REACH, 0.0)]).collect()
}

/// Distance from the root to the edge of a curved side, across.
fn curved_width(bevel: f64, radius: f64, depth: f64) -> f64 {
    let (sin, cos) = bevel.sin_cos();
    radius * cos + (depth - radius * (1.0 - sin)) * bevel.tan()
}

/// Area between root and edge of a curved side: the rectangle about the arc less the area below it, and the wall's
/// part.
fn curved_area(bevel: f64, radius: f64, depth: f64) -> f64 {
    let (sin, cos) = bevel.sin_cos();
    let wall = depth - radius * (1.0 - sin);
    // Below the arc's upper end: a sector of pi/2 - bevel, less the triangle below the level of the centre.
    let sector = radius * radius * (PI / 2.0 - bevel) / 2.0;
    let triangle = radius * cos * radius * sin / 2.0;
    let arc = sector - triangle;
    arc + wall * (radius * cos + wall * bevel.tan() / 2.0)
}
