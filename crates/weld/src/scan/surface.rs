//! The surface that a groove shows to a sensor, by the unknown sizes.

use crate::joint::{Groove, SeamJoint, Section};
use crate::seam::SeamPoint;
use glam::DVec2;
use seamwright_program::Preparation;

/// Pose of the sensor, sizes of the groove, surface of the metal.
pub(super) type Unknowns = [f64; 10];
/// Position of the seam in the sensor's frame, mm.
pub(super) const AT_Y: usize = 0;
pub(super) const AT_Z: usize = 1;
/// Rotation from the sensor's frame to that of the section, rad.
pub(super) const TURN: usize = 2;
pub(super) const DIHEDRAL: usize = 3;
pub(super) const GAP: usize = 4;
pub(super) const MISMATCH: usize = 5;
pub(super) const ANGLE: usize = 6;
/// Depth of the metal's surface below the line from toe to toe in its middle, mm; slope; half curvature, 1/mm.
pub(super) const DEPTH: usize = 7;
pub(super) const SLOPE: usize = 8;
pub(super) const BEND: usize = 9;

/// Standard deviations of parts from their drawing, mm and rad: gap and mismatch of tacked parts (ISO 5817 allows a
/// mismatch of 3 mm), angles of thermal cutting and fit-up (ISO 13920 and ISO 9692-1 allow about 2 degrees).
const TOLERANCE: [(usize, f64); 4] = [(DIHEDRAL, 0.04), (GAP, 2.0), (MISMATCH, 2.0), (ANGLE, 0.05)];
/// The same of the metal's surface: within these it is a bead's. Wide, so that profiles decide.
const METAL: [(usize, f64); 3] = [(DEPTH, 50.0), (SLOPE, 0.15), (BEND, 0.03)];

/// Extent of the faces beyond the toes, mm.
const FACE_MM: f64 = 200.0;
/// Pieces of the metal's surface.
const PIECES: usize = 8;

/// The sizes of a preparation that a profile shows; `None` if it does not show enough of them.
pub(super) fn free_sizes(preparation: &Preparation) -> Option<&'static [usize]> {
    match preparation {
        Preparation::SingleV(_) | Preparation::DoubleV(_) => Some(&[DIHEDRAL, GAP, MISMATCH, ANGLE]),
        Preparation::U(_) | Preparation::DoubleU(_) => Some(&[DIHEDRAL, GAP, MISMATCH, ANGLE]),
        Preparation::TBevel(_) | Preparation::TDoubleBevel(_) | Preparation::TJ(_) => Some(&[DIHEDRAL, GAP, ANGLE]),
        Preparation::Fillet(_) => Some(&[DIHEDRAL]),
        // An upright wall is seen edge-on.
        Preparation::Square(_) | Preparation::Bevel(_) | Preparation::DoubleBevel(_) | Preparation::J(_) => None,
        Preparation::Corner(_) | Preparation::Lap(_) => None,
        Preparation::FlareBevel(_) | Preparation::FlareV(_) => None,
    }
}

/// A piece of the surface, from left to right as the sensor sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Segment {
    pub(super) piece: Piece,
    pub(super) from: DVec2,
    pub(super) to: DVec2,
}

/// The part that a segment belongs to, with its index from the root.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece {
    SecondFace,
    SecondEdge(usize),
    Metal(usize),
    FirstEdge(usize),
    FirstFace,
}

/// The surface of a groove in the section's frame, from the second part to the first.
#[derive(Debug, Clone)]
pub(super) struct Surface {
    pub(super) segments: Vec<Segment>,
    /// The ends of the metal at the second and the first part.
    pub(super) ends: Option<[DVec2; 2]>,
    pub(super) section: Section,
}

/// The known data of a station.
#[derive(Debug, Clone)]
pub(super) struct Fixed<'a> {
    joint: &'a SeamJoint,
    pub(super) drawn: Groove,
    pub(super) welded: bool,
    /// Indices of the unknowns that are estimated.
    pub(super) free: Vec<usize>,
}

impl<'a> Fixed<'a> {
    pub(super) fn new(joint: &'a SeamJoint, p: &SeamPoint, welded: bool) -> Self {
        let sizes = free_sizes(&joint.joint().preparation).unwrap_or_default();
        let metal: &[usize] = if welded { &[DEPTH, SLOPE, BEND] } else { &[] };
        let free = [AT_Y, AT_Z, TURN].iter().chain(sizes).chain(metal).copied().collect();
        Self { joint, drawn: joint.groove(p), welded, free }
    }

    /// The drawn groove with the metal's surface at `depth`.
    pub(super) fn start(&self, depth: f64) -> Unknowns {
        let Groove { dihedral, gap, mismatch, angle } = self.drawn;
        [0.0, 0.0, 0.0, dihedral, gap, mismatch, angle.unwrap_or_default(), depth, 0.0, 0.0]
    }

    /// Value and standard deviation that the drawing gives for an unknown.
    pub(super) fn drawn_value(&self, unknown: usize) -> Option<(f64, f64)> {
        let (_, tolerance) = TOLERANCE.iter().chain(&METAL).find(|(i, _)| *i == unknown)?;
        Some((self.start(0.0)[unknown], *tolerance))
    }

    pub(super) fn section(&self, u: &Unknowns) -> Option<Section> {
        let angle = self.drawn.angle.map(|_| u[ANGLE]);
        let groove = Groove { dihedral: u[DIHEDRAL], gap: u[GAP].max(0.0), mismatch: u[MISMATCH], angle };
        self.joint.section_with(&groove)
    }

    /// The surface with these sizes; `None` without a groove.
    pub(super) fn surface(&self, u: &Unknowns) -> Option<Surface> {
        let section = self.section(u)?;
        let (sin, cos) = (0.5 * section.dihedral).sin_cos();
        let [first_toe, second_toe] = section.toes();
        let far = [first_toe + FACE_MM * DVec2::new(sin, cos), second_toe + FACE_MM * DVec2::new(-sin, cos)];
        let metal = self.welded.then(|| Metal::new(&section, u));
        let (second, second_end) = above(&section.second, metal.as_ref());
        let (first, first_end) = above(&section.first, metal.as_ref());
        let mut segments = vec![Segment { piece: Piece::SecondFace, from: far[1], to: second_toe }];
        segments.extend(second.iter().rev().map(|(i, [low, high])| Segment {
            piece: Piece::SecondEdge(*i),
            from: *high,
            to: *low,
        }));
        if let Some(metal) = &metal {
            segments.extend(metal.pieces(second_end, first_end));
        }
        segments.extend(first.iter().map(|(i, [low, high])| Segment {
            piece: Piece::FirstEdge(*i),
            from: *low,
            to: *high,
        }));
        segments.push(Segment { piece: Piece::FirstFace, from: first_toe, to: far[0] });
        Some(Surface { segments, ends: metal.map(|_| [second_end, first_end]), section })
    }
}

/// The metal's surface: a parabola over the line from toe to toe.
struct Metal {
    across: DVec2,
    up: DVec2,
    middle: f64,
    top: f64,
    depth: f64,
    slope: f64,
    bend: f64,
}

impl Metal {
    fn new(section: &Section, u: &Unknowns) -> Self {
        let [first, second] = section.toes();
        let (across, up) = (section.across(), section.up);
        let middle = 0.5 * across.dot(first + second);
        Self { across, up, middle, top: up.dot(first), depth: u[DEPTH], slope: u[SLOPE], bend: u[BEND] }
    }

    fn height(&self, across: f64) -> f64 {
        let x = across - self.middle;
        self.top - self.depth + x * (self.slope + x * self.bend)
    }

    /// Height of a point over the surface.
    fn over(&self, p: DVec2) -> f64 {
        self.up.dot(p) - self.height(self.across.dot(p))
    }

    fn pieces(&self, from: DVec2, to: DVec2) -> impl Iterator<Item = Segment> {
        let [x0, x1] = [from, to].map(|p| self.across.dot(p));
        let at = move |k: usize| match k {
            0 => from,
            PIECES => to,
            _ => {
                let x = x0 + (x1 - x0) * k as f64 / PIECES as f64;
                x * self.across + self.height(x) * self.up
            }
        };
        (0..PIECES).map(move |k| Segment { piece: Piece::Metal(k), from: at(k), to: at(k + 1) })
    }
}

/// The segments of an edge (low end first) above the metal, with their indices from the root; and the metal's end there.
fn above(edge: &[DVec2], metal: Option<&Metal>) -> (Vec<(usize, [DVec2; 2])>, DVec2) {
    let all = edge.windows(2).map(|w| [w[0], w[1]]).enumerate();
    let root = edge.first().copied().unwrap_or_default();
    let Some(metal) = metal else { return (all.collect(), root) };
    let mut there = Vec::new();
    let mut end = root;
    for (i, [low, high]) in all {
        let [a, b] = [metal.over(low), metal.over(high)];
        if b <= 0.0 {
            there.clear();
            end = high;
        } else if a < 0.0 {
            there.clear();
            end = low + (high - low) * (a / (a - b));
            there.push((i, [end, high]));
        } else {
            there.push((i, [low, high]));
        }
    }
    (there, end)
}
