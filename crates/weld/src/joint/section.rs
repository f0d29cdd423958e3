use super::profile::Profile;
use crate::allowed::rounded;
use glam::DVec2;
use seamwright_geometry::Slices;
use seamwright_message::{Message, Unit};
use seamwright_program::{Fillet, Member, Preparation};
use std::f64::consts::PI;

/// Maximum dihedral angle of a fillet, rad: its faces are not in one plane.
const MAX_FILLET: f64 = 170.0 * PI / 180.0;
/// Minimum dihedral angle of a butt joint, rad: its faces are nearly in one plane.
const MIN_BUTT: f64 = 120.0 * PI / 180.0;

/// The joint cut square to the seam, mm: `x` is along [`SeamPoint::towards_first`](crate::SeamPoint), `y` along the
/// bisector, the seam is at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Dihedral angle between the faces, rad.
    pub dihedral: f64,
    /// Edge of the first part where the weld fuses to it, from the root to the toe.
    pub first: Vec<DVec2>,
    /// The same of the second part.
    pub second: Vec<DVec2>,
    /// Unit vector square to the line from toe to toe, out to the torch.
    pub up: DVec2,
    /// Area of the groove up to the line from toe to toe.
    pub slices: Slices,
    /// Area of the cap over that line, mm^2.
    pub cap: f64,
    /// Height of the cap, mm.
    pub cap_height: f64,
}

/// Position of the parts at one station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    /// Dihedral angle, rad.
    pub(crate) dihedral: f64,
    /// Root gap, mm.
    pub(crate) gap: f64,
    /// Height of the second part over the first, mm.
    pub(crate) mismatch: f64,
}

/// Reason why a station has no groove.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum NoGroove {
    /// The faces' dihedral angle (degrees) is too small for a butt joint.
    NoButt(f64),
    /// The faces' dihedral angle (degrees) is too large for a fillet or T-joint.
    NoCorner(f64),
    /// The prepared edge stays within its part; degrees.
    NeverOut { angle: f64, dihedral: f64 },
    /// The cut edge lies in the other part, at this angle (degrees) to its face.
    Inside(f64),
    /// The edges cross each other.
    Crossing,
    /// The groove has no area.
    Empty,
}

seamwright_message::display_by_message!(NoGroove);

impl NoGroove {
    /// Description of the fault.
    pub(crate) fn message(&self) -> Message {
        let of = |code, name, angle| Message::new(code).quantity(name, angle, Unit::Deg, 1);
        match self {
            Self::NoButt(dihedral) => of("weld-groove-no-butt", "dihedral", *dihedral),
            Self::NoCorner(dihedral) => of("weld-groove-no-corner", "dihedral", *dihedral),
            Self::NeverOut { angle, dihedral } => {
                of("weld-groove-edge-within-part", "angle", *angle).quantity("dihedral", *dihedral, Unit::Deg, 1)
            }
            Self::Inside(angle) => of("weld-groove-edge-in-other-part", "angle", *angle),
            Self::Crossing => Message::new("weld-groove-edges-cross"),
            Self::Empty => Message::new("weld-groove-empty"),
        }
    }

    /// Description of the fault at path length `s`, mm.
    pub(crate) fn at(&self, s: f64) -> Message {
        Message::new("weld-groove-at").quantity("s", s, Unit::Mm, 1).message("why", self.message())
    }

    /// The key of the preparation to look at, and the allowed values.
    pub(crate) fn cure(&self) -> (&'static str, Message) {
        let of = |code, name, angle: f64| Message::new(code).value(name, rounded(angle), Unit::Deg);
        match self {
            Self::NoButt(_) => ("", of("weld-allowed-butt-dihedral", "min", MIN_BUTT.to_degrees())),
            Self::NoCorner(_) => ("", of("weld-allowed-corner-dihedral", "max", MAX_FILLET.to_degrees())),
            Self::NeverOut { dihedral, .. } => {
                ("angle_deg", Message::new("document-less-than").quantity("max", *dihedral, Unit::Deg, 1))
            }
            Self::Inside(_) => ("cut_deg", Message::new("weld-allowed-edge-cut")),
            Self::Crossing => ("", Message::new("weld-allowed-larger-gap")),
            Self::Empty => ("", Message::new("weld-allowed-room-to-weld")),
        }
    }
}

/// The surfaces of both parts at the seam.
struct Faces {
    /// From the seam along the surface of the first and the second part.
    along: [DVec2; 2],
    /// Outward unit normals.
    out: [DVec2; 2],
}

impl Faces {
    fn new(dihedral: f64) -> Self {
        let (sin, cos) = (0.5 * dihedral).sin_cos();
        Self {
            along: [DVec2::new(sin, cos), DVec2::new(-sin, cos)],
            out: [DVec2::new(-cos, sin), DVec2::new(cos, sin)],
        }
    }
}

/// An edge of a part: a profile seen along a depth direction.
struct EdgeFrame {
    /// Origin of depth and lateral distance.
    origin: DVec2,
    depth: DVec2,
    lateral: DVec2,
}

impl EdgeFrame {
    /// Corners in the section, cut off at the surface through `at` with the outward normal `out`.
    fn cut(&self, corners: &[DVec2], at: DVec2, out: DVec2) -> Option<Vec<DVec2>> {
        let place = |c: &DVec2| self.origin + c.x * self.lateral + c.y * self.depth;
        let height = |p: DVec2| (p - at).dot(out);
        let mut edge: Vec<DVec2> = Vec::with_capacity(corners.len());
        for corner in corners.iter().map(place) {
            let h = height(corner);
            if h < 0.0 {
                edge.push(corner);
                continue;
            }
            let before = *edge.last()?;
            let b = height(before);
            edge.push(before + (corner - before) * (b / (b - h)));
            return Some(edge);
        }
        None
    }

    fn all(&self, corners: &[DVec2]) -> Vec<DVec2> {
        corners.iter().map(|c| self.origin + c.x * self.lateral + c.y * self.depth).collect()
    }
}

impl Section {
    /// The section of a joint with this preparation and a cap of `cap_height`.
    pub(crate) fn new(preparation: &Preparation, cap_height: f64, place: Place) -> Result<Self, NoGroove> {
        let faces = Faces::new(place.dihedral);
        if preparation.is_butt() && place.dihedral < MIN_BUTT {
            return Err(NoGroove::NoButt(place.dihedral.to_degrees()));
        }
        if !preparation.is_butt() && place.dihedral > MAX_FILLET {
            return Err(NoGroove::NoCorner(place.dihedral.to_degrees()));
        }
        let [first, second] = match preparation {
            Preparation::Square(p) => {
                let square = Profile::Square;
                butt(&faces, place, [(square, 0.5), (square, 0.5)], p.thickness_mm.get())?
            }
            Preparation::SingleV(p) => {
                let angle = 0.5 * p.angle_deg.get().to_radians();
                let side = Profile::Bevel { root_face: p.root_face_mm.get(), angle };
                butt(&faces, place, [(side, 0.5), (side, 0.5)], p.thickness_mm.get())?
            }
            Preparation::Bevel(p) => {
                let angle = p.angle_deg.get().to_radians();
                let side = Profile::Bevel { root_face: p.root_face_mm.get(), angle };
                butt(&faces, place, one(side, p.prepared), p.thickness_mm.get())?
            }
            Preparation::U(p) => butt(&faces, place, [(p.into(), 0.5), (p.into(), 0.5)], p.thickness_mm.get())?,
            Preparation::J(p) => butt(&faces, place, one(p.into(), p.prepared), p.thickness_mm.get())?,
            Preparation::FlareV(p) => {
                let radius = p.radius_mm.get();
                let side = Profile::Round { radius, unfilled: p.unfilled_mm.get() };
                butt(&faces, place, [(side, 0.5), (side, 0.5)], radius)?
            }
            Preparation::Fillet(p) => fillet(&faces, place, p),
            Preparation::FlareBevel(p) => {
                let radius = p.radius_mm.get();
                let side = Profile::Round { radius, unfilled: p.unfilled_mm.get() };
                corner(&faces, place, Corner { edge: side, prepared: p.round, thickness: radius, leg: 0.0 })?
            }
            Preparation::TBevel(p) => {
                let angle = match (p.angle_deg, p.cut_deg) {
                    (_, Some(cut)) => cut.get().to_radians() + place.dihedral - 0.5 * PI,
                    (angle, None) => angle.map_or(0.0, |a| a.get().to_radians()),
                };
                if angle < 0.0 {
                    return Err(NoGroove::Inside(angle.to_degrees()));
                }
                let sin = place.dihedral.sin();
                let edge = Profile::Bevel { root_face: p.root_face_mm.get() / sin, angle };
                let thickness = p.thickness_mm.get();
                corner(&faces, place, Corner { edge, prepared: p.prepared, thickness, leg: p.leg_mm.get() })?
            }
            Preparation::TJ(p) => {
                let (edge, thickness) = (p.into(), p.thickness_mm.get());
                corner(&faces, place, Corner { edge, prepared: p.prepared, thickness, leg: p.leg_mm.get() })?
            }
        };
        Self::between(place.dihedral, first, second, cap_height)
    }

    fn between(dihedral: f64, first: Vec<DVec2>, second: Vec<DVec2>, cap_height: f64) -> Result<Self, NoGroove> {
        // Both edges have corners: they are made of profiles.
        let [Some(toe1), Some(toe2)] = [first.last(), second.last()] else { return Err(NoGroove::Empty) };
        let chord = *toe1 - *toe2;
        let up = DVec2::new(-chord.y, chord.x).try_normalize().ok_or(NoGroove::Empty)?;
        if crossing(&first, &second) {
            return Err(NoGroove::Crossing);
        }
        let corners: Vec<DVec2> = first.iter().chain(second.iter().rev()).copied().collect();
        let turns = (0..corners.len()).map(|i| corners[i].perp_dot(corners[(i + 1) % corners.len()])).sum::<f64>();
        let slices = Slices::new(&corners, up).filter(|_| turns > 0.0).ok_or(NoGroove::Empty)?;
        let cap = 2.0 / 3.0 * chord.length() * cap_height;
        Ok(Self { dihedral, first, second, up, slices, cap, cap_height })
    }

    /// Area of the groove up to the line from toe to toe, mm^2.
    pub fn area(&self) -> f64 {
        self.slices.area()
    }

    /// Area to be filled: groove and cap, mm^2.
    pub fn total(&self) -> f64 {
        self.area() + self.cap
    }

    /// Unit vector across [`Section::up`], towards the first part.
    pub fn across(&self) -> DVec2 {
        DVec2::new(self.up.y, -self.up.x)
    }

    /// The toes on the first and the second part.
    pub fn toes(&self) -> [DVec2; 2] {
        [&self.first, &self.second].map(|edge| edge.last().copied().unwrap_or_default())
    }

    /// The point at (`across`, `height`) along [`Section::across`] and [`Section::up`], mm.
    pub fn place(&self, across: f64, height: f64) -> DVec2 {
        across * self.across() + height * self.up
    }
}

/// One side prepared, the other square. Each side has half the gap.
fn one(side: Profile, prepared: Member) -> [(Profile, f64); 2] {
    match prepared {
        Member::First => [(side, 0.5), (Profile::Square, 0.5)],
        Member::Second => [(Profile::Square, 0.5), (side, 0.5)],
    }
}

/// Both edges of a butt joint: depth goes in along the bisector. The second part lies `mismatch` further out.
fn butt(faces: &Faces, place: Place, sides: [(Profile, f64); 2], thickness: f64) -> Result<[Vec<DVec2>; 2], NoGroove> {
    let edge = |i: usize| {
        let (profile, share) = sides[i];
        let shift = if i == 1 { place.mismatch } else { 0.0 };
        let frame = EdgeFrame {
            origin: DVec2::new(0.0, shift),
            depth: DVec2::NEG_Y,
            lateral: if i == 0 { DVec2::X } else { DVec2::NEG_X },
        };
        let corners = profile.corners(share * place.gap, thickness);
        match profile {
            Profile::Round { .. } => Ok(frame.all(&corners)),
            _ => frame.cut(&corners, frame.origin, faces.out[i]).ok_or(NoGroove::Empty),
        }
    };
    Ok([edge(0)?, edge(1)?])
}

/// A prepared edge on the other part's face.
#[derive(Clone, Copy)]
struct Corner {
    edge: Profile,
    prepared: Member,
    /// Thickness of the prepared part.
    thickness: f64,
    /// Leg of the cover fillet on the face.
    leg: f64,
}

/// Both edges where the depth goes in along the face of the part that goes through, under the other.
fn corner(faces: &Faces, place: Place, c: Corner) -> Result<[Vec<DVec2>; 2], NoGroove> {
    let (on, through) = match c.prepared {
        Member::First => (0, 1),
        Member::Second => (1, 0),
    };
    let frame = EdgeFrame { origin: DVec2::ZERO, depth: -faces.along[through], lateral: faces.out[through] };
    let slant = c.thickness / place.dihedral.sin();
    let corners = c.edge.corners(place.gap, slant);
    let edge = match c.edge.angle() {
        None => frame.all(&corners),
        Some(angle) => {
            let never = NoGroove::NeverOut { angle: angle.to_degrees(), dihedral: place.dihedral.to_degrees() };
            if angle >= place.dihedral {
                return Err(never);
            }
            frame.cut(&corners, DVec2::ZERO, faces.out[on]).ok_or(never)?
        }
    };
    let deepest = corners.first().map_or(slant, |root| root.y);
    let mut face = vec![deepest * frame.depth];
    if c.leg > 0.0 {
        face.push(-c.leg * frame.depth);
    } else {
        face.push(DVec2::ZERO);
    }
    Ok(match c.prepared {
        Member::First => [edge, face],
        Member::Second => [face, edge],
    })
}

/// Both edges of a fillet: the faces themselves, up to the legs.
fn fillet(faces: &Faces, place: Place, p: &Fillet) -> [Vec<DVec2>; 2] {
    let equal = match (p.leg_mm, p.throat_mm) {
        (Some(leg), _) => leg.get(),
        (None, Some(throat)) => throat.get() / (0.5 * place.dihedral).cos(),
        (None, None) => 0.0,
    };
    let legs = [p.first_leg_mm, p.second_leg_mm].map(|leg| leg.map_or(equal, seamwright_document::Positive::get));
    let longer = place.gap / place.dihedral.sin();
    let edge = |i: usize, member: Member| {
        let leg = if p.prepared == member { legs[i] + longer } else { legs[i] };
        vec![DVec2::ZERO, leg * faces.along[i]]
    };
    [edge(0, Member::First), edge(1, Member::Second)]
}

/// True if the edges cross, other than at their roots.
fn crossing(first: &[DVec2], second: &[DVec2]) -> bool {
    let side = |a: DVec2, b: DVec2, p: DVec2| (b - a).perp_dot(p - a);
    first.windows(2).any(|a| {
        second.windows(2).any(|b| {
            side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < -1e-18
                && side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < -1e-18
        })
    })
}
