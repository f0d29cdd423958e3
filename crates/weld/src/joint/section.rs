use super::profile::Profile;
use crate::allowed::rounded;
use glam::DVec2;
use seamwright_document::{NonNegative, Positive};
use seamwright_geometry::Slices;
use seamwright_message::{Message, Unit};
use seamwright_program::{Fillet, Joint, Member, Preparation, WeldedSide};
use std::f64::consts::PI;

/// Maximum dihedral angle of a fillet, rad: its faces are not in one plane.
const MAX_FILLET: f64 = 170.0 * PI / 180.0;
/// Minimum dihedral angle of a butt joint, rad: its faces are nearly in one plane.
const MIN_BUTT: f64 = 120.0 * PI / 180.0;
/// Dihedral angles of corner joints, rad: square ends open a groove there, and its faces do not meet again behind it.
const CORNER: [f64; 2] = [200.0 * PI / 180.0, 330.0 * PI / 180.0];

/// The joint cut square to the seam, mm: `x` is along [`SeamPoint::towards_first`](crate::SeamPoint), `y` along the
/// bisector, the seam is at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Dihedral angle between the faces, rad.
    pub dihedral: f64,
    /// Root gap, mm: along the wall of the part that stands; in a butt joint across the bisector.
    pub gap: f64,
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
    /// True for a first and a second part whose surface goes on round beyond its toe.
    rounds: [bool; 2],
}

/// Position of the parts at one station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    /// Dihedral angle, rad.
    pub(crate) dihedral: f64,
    /// Root gap, mm: see [`Section::gap`].
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
    /// The faces' dihedral angle (degrees) is not that of an outside corner.
    NoOutsideCorner(f64),
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
            Self::NoOutsideCorner(dihedral) => of("weld-groove-no-outside-corner", "dihedral", *dihedral),
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
            Self::NoOutsideCorner(_) => {
                let [min, max] = CORNER.map(|angle| rounded(angle.to_degrees()));
                let allowed = Message::new("weld-allowed-outside-corner").value("min", min, Unit::Deg);
                ("", allowed.value("max", max, Unit::Deg))
            }
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

/// A wall: its surface through `at` with the outward normal `out`.
#[derive(Clone, Copy)]
struct Wall {
    at: DVec2,
    out: DVec2,
    thickness: f64,
}

/// An edge of a part: a profile seen along a depth direction.
struct EdgeFrame {
    /// Origin of depth and lateral distance.
    origin: DVec2,
    depth: DVec2,
    lateral: DVec2,
}

impl EdgeFrame {
    /// The edge in the section within its wall: from its inside face to the surface.
    fn cut(&self, corners: &[DVec2], wall: Wall) -> Option<Vec<DVec2>> {
        let all = self.all(corners);
        let height = |p: DVec2| (p - wall.at).dot(wall.out);
        let crossing = |a: DVec2, b: DVec2, level: f64| a + (b - a) * ((level - height(a)) / (height(b) - height(a)));
        let outside = all.iter().position(|c| height(*c) >= 0.0).filter(|i| *i > 0)?;
        let mut edge = all[..outside].to_vec();
        edge.push(crossing(all[outside - 1], all[outside], 0.0));
        // A floor square to the depth may start beyond the inside of a wall that slopes.
        let inside = -wall.thickness - ON_LINE_MM;
        let within = edge.iter().rposition(|c| height(*c) < inside).map_or(0, |last| last + 1);
        if within > 0 {
            edge[within - 1] = crossing(edge[within - 1], edge[within], -wall.thickness);
            edge.drain(..within - 1);
        }
        Some(edge)
    }

    fn all(&self, corners: &[DVec2]) -> Vec<DVec2> {
        corners.iter().map(|c| self.origin + c.x * self.lateral + c.y * self.depth).collect()
    }
}

impl Section {
    /// The section of a joint at a place.
    pub(crate) fn new(joint: &Joint, place: Place) -> Result<Self, NoGroove> {
        let faces = Faces::new(place.dihedral);
        let preparation = &joint.preparation;
        let degrees = place.dihedral.to_degrees();
        if preparation.is_butt() && place.dihedral < MIN_BUTT {
            return Err(NoGroove::NoButt(degrees));
        }
        if !preparation.is_butt() && place.dihedral > MAX_FILLET {
            return Err(NoGroove::NoCorner(degrees));
        }
        let [first, second] = match preparation {
            Preparation::Corner(_) if !(CORNER[0]..=CORNER[1]).contains(&place.dihedral) => {
                return Err(NoGroove::NoOutsideCorner(degrees));
            }
            Preparation::Fillet(p) => fillet(&faces, place, p),
            Preparation::Lap(p) => {
                let leg = Some(p.leg_mm);
                fillet(&faces, place, &Fillet { leg_mm: leg, prepared: p.prepared, ..Fillet::default() })
            }
            Preparation::FlareBevel(p) => {
                let radius = p.radius_mm.get();
                let side = Profile::Round { radius, unfilled: p.unfilled_mm.get() };
                corner(&faces, place, Corner { edge: side, prepared: p.round, thickness: radius, leg: 0.0 })?
            }
            Preparation::TBevel(_) | Preparation::TDoubleBevel(_) | Preparation::TJ(_) => {
                corner(&faces, place, edge_on_face(joint, place)?)?
            }
            _ => butt(&faces, place, butt_edges(joint, place), joint.depth_mm())?,
        };
        let rounds = match preparation {
            Preparation::FlareBevel(p) => [p.round == Member::First, p.round == Member::Second],
            Preparation::FlareV(_) => [true; 2],
            _ => [false; 2],
        };
        Ok(Self { rounds, ..Self::between(place, first, second, joint.cap_mm.get())? })
    }

    fn between(place: Place, first: Vec<DVec2>, second: Vec<DVec2>, cap_height: f64) -> Result<Self, NoGroove> {
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
        let Place { dihedral, gap, .. } = place;
        Ok(Self { dihedral, gap, first, second, up, slices, cap, cap_height, rounds: [false; 2] })
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

    /// Length of the line from toe to toe, mm.
    pub fn chord(&self) -> f64 {
        let [first, second] = self.toes();
        first.distance(second)
    }

    /// Directions of the first and the second part's boundary beyond `height` along [`Section::up`]: of the wall of the
    /// groove, or of the surface at the toes.
    pub(crate) fn beyond(&self, height: f64) -> [DVec2; 2] {
        let (sin, cos) = (0.5 * self.dihedral).sin_cos();
        let last =
            |edge: &[DVec2], plane: DVec2| edge.windows(2).last().map_or(plane, |w| (w[1] - w[0]).normalize_or(plane));
        let surface = |i: usize, edge: &[DVec2], plane: DVec2| if self.rounds[i] { last(edge, plane) } else { plane };
        let surfaces = [surface(0, &self.first, DVec2::new(sin, cos)), surface(1, &self.second, DVec2::new(-sin, cos))];
        let (low, high) = self.slices.heights();
        if height >= high - ON_LINE_MM * (high - low).max(1.0) {
            return surfaces;
        }
        let wall = |edge: &[DVec2], surface: DVec2| {
            let rises = |w: &&[DVec2]| w[0].dot(self.up) <= height && height < w[1].dot(self.up);
            edge.windows(2).rfind(rises).map_or(surface, |w| (w[1] - w[0]).normalize_or(surface))
        };
        [wall(&self.first, surfaces[0]), wall(&self.second, surfaces[1])]
    }

    /// Unit vector to a sensor that sees the faces beside the groove and the edges at the toes as little slanted as
    /// possible.
    pub fn view(&self) -> DVec2 {
        let (sin, cos) = (0.5 * self.dihedral).sin_cos();
        // Directions of the surface from the second part to the first.
        let upper = |edge: &[DVec2]| edge.windows(2).last().map_or(DVec2::ZERO, |w| w[1] - w[0]);
        let lines = [DVec2::new(sin, -cos), -upper(&self.second), upper(&self.first), DVec2::new(sin, cos)];
        let slopes = lines.map(DVec2::to_angle);
        let (low, high) = slopes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(*s), h.max(*s)));
        DVec2::from_angle(0.5 * (low + high)).perp()
    }

    /// The middle of the groove's bottom.
    pub fn root(&self) -> DVec2 {
        let [first, second] = [&self.first, &self.second].map(|edge| edge.first().copied().unwrap_or_default());
        first.midpoint(second)
    }

    /// The toes on the first and the second part.
    pub fn toes(&self) -> [DVec2; 2] {
        [&self.first, &self.second].map(|edge| edge.last().copied().unwrap_or_default())
    }

    /// The directions in which a torch at `at` sees out of the groove past everything `beyond` that distance (mm), the wire
    /// being thin before it: angles from the bisector of the faces, rad, positive towards the first part, the smaller one
    /// first. The edges above the point limit them, and beyond the toes the faces.
    pub fn free_angles(&self, at: DVec2, beyond: f64) -> [f64; 2] {
        let (sin, cos) = (0.5 * self.dihedral).sin_cos();
        let limit = |edge: &[DVec2], sense: f64| {
            let far = edge.last().map(|toe| *toe + FAR_MM * DVec2::new(sense * sin, cos));
            let corners: Vec<DVec2> = edge.iter().copied().chain(far).collect();
            let crossings = corners.windows(2).flat_map(|ends| on_circle(at, beyond, [ends[0], ends[1]]));
            let points: Vec<DVec2> =
                edge.iter().copied().filter(|p| p.distance(at) >= beyond).chain(crossings).collect();
            let ways = points.into_iter().map(|point| point - at).filter(|way| way.dot(self.up) > ON_LINE_MM);
            ways.map(|way| sense * way.x.atan2(way.y)).fold(0.5 * self.dihedral, f64::min)
        };
        [-limit(&self.second, -1.0), limit(&self.first, 1.0)]
    }

    /// The point at (`across`, `height`) along [`Section::across`] and [`Section::up`], mm.
    pub fn place(&self, across: f64, height: f64) -> DVec2 {
        across * self.across() + height * self.up
    }
}

/// Profiles of both edges of a butt joint on the side that is welded, each with its share of the gap.
fn butt_edges(joint: &Joint, place: Place) -> [(Profile, f64); 2] {
    let angle = joint.preparation.groove_angle(joint.side, place.dihedral).unwrap_or_default();
    let bevel = |root_face: NonNegative, angle: f64| Profile::Bevel { root_face: root_face.get(), angle };
    let both = |side: Profile| [side, side];
    let one = |side: Profile, prepared: Member| match prepared {
        Member::First => [side, Profile::Square],
        Member::Second => [Profile::Square, side],
    };
    let sides = match &joint.preparation {
        Preparation::SingleV(p) => both(bevel(p.root_face_mm, 0.5 * angle)),
        Preparation::DoubleV(p) => both(bevel(p.root_face_mm, 0.5 * angle)),
        Preparation::Bevel(p) => one(bevel(p.root_face_mm, angle), p.prepared),
        Preparation::DoubleBevel(p) => one(bevel(p.root_face_mm, angle), p.prepared),
        Preparation::U(p) => both(p.into()),
        Preparation::DoubleU(p) => both(p.into()),
        Preparation::J(p) => one(p.into(), p.prepared),
        Preparation::FlareV(p) => both(Profile::Round { radius: p.radius_mm.get(), unfilled: p.unfilled_mm.get() }),
        // Each end is square to its own face.
        Preparation::Corner(_) => both(Profile::Bevel { root_face: 0.0, angle: 0.5 * (place.dihedral - PI) }),
        _ => both(Profile::Square),
    };
    sides.map(|side| (of_back(joint, side), 0.5))
}

/// The profile that an edge has on the side that is welded: on the back without its root face, and gouged.
fn of_back(joint: &Joint, edge: Profile) -> Profile {
    if joint.side == WeldedSide::Face {
        return edge;
    }
    let edge = edge.without_root_face();
    let [_, depth] = joint.preparation.depths_mm();
    let Some(gouge) = &joint.gouge else { return edge };
    let (radius, side) = (gouge.radius_mm.get(), gouge.angle_deg.get().to_radians());
    edge.gouged(depth, radius, side)
}

/// The prepared edge of an edge on a face.
fn edge_on_face(joint: &Joint, place: Place) -> Result<Corner, NoGroove> {
    let (edge, prepared, leg) = match &joint.preparation {
        Preparation::TBevel(p) => {
            let angle = joint.preparation.groove_angle(joint.side, place.dihedral).unwrap_or_default();
            (Profile::Bevel { root_face: p.root_face_mm.get(), angle }, p.prepared, p.leg_mm)
        }
        Preparation::TDoubleBevel(p) => {
            let angle = joint.preparation.groove_angle(joint.side, place.dihedral).unwrap_or_default();
            let edge = Profile::Bevel { root_face: p.root_face_mm.get(), angle };
            (of_back(joint, edge), p.prepared, p.leg_mm)
        }
        Preparation::TJ(p) => (p.into(), p.prepared, p.leg_mm),
        _ => (Profile::Square, Member::First, NonNegative::default()),
    };
    match edge.angle() {
        Some(angle) if angle < 0.0 => Err(NoGroove::Inside(angle.to_degrees())),
        _ => Ok(Corner { edge, prepared, thickness: joint.depth_mm(), leg: leg.get() }),
    }
}

/// Both edges of a butt joint: depth goes in along the bisector, to the parts' inside faces. The second part lies
/// `mismatch` further out.
fn butt(faces: &Faces, place: Place, sides: [(Profile, f64); 2], thickness: f64) -> Result<[Vec<DVec2>; 2], NoGroove> {
    let (sin, cos) = (0.5 * place.dihedral).sin_cos();
    let edge = |i: usize| {
        let (profile, share) = sides[i];
        let shift = if i == 1 { place.mismatch } else { 0.0 };
        let frame = EdgeFrame {
            origin: DVec2::new(0.0, shift),
            depth: DVec2::NEG_Y,
            lateral: if i == 0 { DVec2::X } else { DVec2::NEG_X },
        };
        let gap = share * place.gap;
        let corners = match profile {
            Profile::Round { .. } => profile.corners(gap, thickness),
            // Faces that slope away from the bisector: a wall measures more along it, less the slope over the gap.
            _ => profile.scaled(1.0 / sin).corners(gap, (thickness - gap * cos) / sin),
        };
        match profile {
            Profile::Round { .. } => Ok(frame.all(&corners)),
            _ => frame.cut(&corners, Wall { at: frame.origin, out: faces.out[i], thickness }).ok_or(NoGroove::Empty),
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
///
/// The root gap is measured along the wall of the part that stands: that part is lifted by it. So the root stays on the
/// wall's inside (a nozzle's bore) at every dihedral angle, and the face begins where that inside meets it.
fn corner(faces: &Faces, place: Place, c: Corner) -> Result<[Vec<DVec2>; 2], NoGroove> {
    let (on, through) = match c.prepared {
        Member::First => (0, 1),
        Member::Second => (1, 0),
    };
    let frame = EdgeFrame { origin: DVec2::ZERO, depth: -faces.along[through], lateral: faces.out[through] };
    let (sin, cos) = place.dihedral.sin_cos();
    let slant = c.thickness / sin;
    let corners = match c.edge {
        Profile::Round { .. } => c.edge.corners(place.gap, slant),
        edge => edge.scaled(1.0 / sin).corners(place.gap * sin, slant - place.gap * cos),
    };
    let edge = match c.edge.angle() {
        None => frame.all(&corners),
        Some(angle) => {
            let never = NoGroove::NeverOut { angle: angle.to_degrees(), dihedral: place.dihedral.to_degrees() };
            if angle >= place.dihedral {
                return Err(never);
            }
            frame.cut(&corners, Wall { at: DVec2::ZERO, out: faces.out[on], thickness: c.thickness }).ok_or(never)?
        }
    };
    let inside = if c.edge.angle().is_some() { slant } else { corners.first().map_or(slant, |root| root.y) };
    let mut face = vec![inside * frame.depth];
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
    let legs = [p.first_leg_mm, p.second_leg_mm].map(|leg| leg.map_or(equal, Positive::get));
    let edge = |i: usize, member: Member| {
        let leg = if p.prepared == member { legs[i] + place.gap } else { legs[i] };
        vec![DVec2::ZERO, leg * faces.along[i]]
    };
    [edge(0, Member::First), edge(1, Member::Second)]
}

/// A way along a face beyond every groove, mm.
const FAR_MM: f64 = 1e5;

/// Points of a segment at the distance `radius` from `centre`.
fn on_circle(centre: DVec2, radius: f64, [from, to]: [DVec2; 2]) -> impl Iterator<Item = DVec2> {
    let (start, way) = (from - centre, to - from);
    let (a, b, c) = (way.length_squared(), start.dot(way), start.length_squared() - radius * radius);
    let root = (b * b - a * c).sqrt();
    let parts = [(-b - root) / a, (-b + root) / a].into_iter().filter(|part| (0.0..=1.0).contains(part));
    parts.map(move |part| from + part * way)
}

/// Points nearer to a line than this are on it, mm: far above rounding, and far below what can be cut.
const ON_LINE_MM: f64 = 1e-9;

/// True if the edges cross, other than at their roots or where they lie on each other.
fn crossing(first: &[DVec2], second: &[DVec2]) -> bool {
    let apart = |line: &[DVec2], ends: &[DVec2]| {
        let along = (line[1] - line[0]).normalize_or_zero();
        let [a, b] = [0, 1].map(|i| along.perp_dot(ends[i] - line[0]));
        a.min(b) < -ON_LINE_MM && a.max(b) > ON_LINE_MM
    };
    first.windows(2).any(|a| second.windows(2).any(|b| apart(a, b) && apart(b, a)))
}
