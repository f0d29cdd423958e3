//! How the edges of a joint are prepared.

mod kinds;

use crate::joint::WeldedSide;
pub use kinds::{
    Bevel, Corner, DoubleBevel, DoubleU, DoubleV, Fillet, FlareBevel, FlareV, J, Lap, Member, SingleV, Square, TBevel,
    TDoubleBevel, TJ, U,
};
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// Joint preparation after ISO 9692-1, seen from the face.
///
/// In a butt joint both parts' surfaces lie (nearly) in one plane. In a fillet and the `t_` kinds one part's edge stands
/// on the face of the other, at the seam's local dihedral angle; the prepared part is the one whose edge it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Preparation {
    /// Square butt.
    Square(Square),
    /// Single V butt; with a broad root face a Y.
    SingleV(SingleV),
    /// Double V butt (X): `side` of the joint says which of both is welded.
    DoubleV(DoubleV),
    /// Single bevel butt.
    Bevel(Bevel),
    /// Double bevel butt (K).
    DoubleBevel(DoubleBevel),
    /// Single U butt.
    U(U),
    /// Double U butt.
    DoubleU(DoubleU),
    /// Single J butt.
    J(J),
    /// Square ends of two walls that meet at an outside corner.
    Corner(Corner),
    /// Fillet.
    Fillet(Fillet),
    /// Fillet along the edge of a plate that lies on another.
    Lap(Lap),
    /// A round part beside a flat one: flare bevel.
    FlareBevel(FlareBevel),
    /// Two round parts side by side: flare V.
    FlareV(FlareV),
    /// Single bevel T: a bevelled edge on a face, as of a nozzle set on its shell or let into it.
    TBevel(TBevel),
    /// Double bevel T (K): an edge bevelled on both sides.
    TDoubleBevel(TDoubleBevel),
    /// Single J on a face.
    TJ(TJ),
}

impl Preparation {
    /// Its key.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Square(_) => "square",
            Self::SingleV(_) => "single_v",
            Self::DoubleV(_) => "double_v",
            Self::Bevel(_) => "bevel",
            Self::DoubleBevel(_) => "double_bevel",
            Self::U(_) => "u",
            Self::DoubleU(_) => "double_u",
            Self::J(_) => "j",
            Self::Corner(_) => "corner",
            Self::Fillet(_) => "fillet",
            Self::Lap(_) => "lap",
            Self::FlareBevel(_) => "flare_bevel",
            Self::FlareV(_) => "flare_v",
            Self::TBevel(_) => "t_bevel",
            Self::TDoubleBevel(_) => "t_double_bevel",
            Self::TJ(_) => "t_j",
        }
    }

    /// The key that a file gives instead of `key`, if it does: an angle of a bevel may be given by its cut.
    pub fn given_key(&self, key: &'static str) -> &'static str {
        match self {
            Self::TBevel(p) if key == "angle_deg" && p.cut_deg.is_some() => "cut_deg",
            _ => key,
        }
    }

    /// Groove angle on a side where the faces are at this dihedral angle, rad, as `angle_deg` counts it; `None` without
    /// straight bevelled edges.
    pub fn groove_angle(&self, side: WeldedSide, dihedral: f64) -> Option<f64> {
        let of_side = |face: Positive, back: Option<Positive>| match side {
            WeldedSide::Face => face.get(),
            WeldedSide::Back => back.unwrap_or(face).get(),
        };
        let degrees = match self {
            Self::SingleV(p) => p.angle_deg.get(),
            Self::DoubleV(p) => of_side(p.angle_deg, p.back_angle_deg),
            Self::Bevel(p) => p.angle_deg.get(),
            Self::DoubleBevel(p) => of_side(p.angle_deg, p.back_angle_deg),
            Self::U(p) => p.angle_deg.get(),
            Self::DoubleU(p) => p.angle_deg.get(),
            Self::J(p) => p.angle_deg.get(),
            Self::TBevel(p) => match (p.angle_deg, p.cut_deg) {
                (_, Some(cut)) => return Some(cut.get().to_radians() + dihedral - FRAC_PI_2),
                (angle, None) => angle?.get(),
            },
            Self::TDoubleBevel(p) => of_side(p.angle_deg, p.back_angle_deg),
            Self::TJ(p) => p.angle_deg.get(),
            Self::Square(_) | Self::Corner(_) | Self::Fillet(_) | Self::Lap(_) => return None,
            Self::FlareBevel(_) | Self::FlareV(_) => return None,
        };
        Some(degrees.to_radians())
    }

    /// The same preparation with this groove angle on a side, rad; `None` if it has no angle, or none of this size.
    #[must_use]
    pub fn with_groove_angle(&self, side: WeldedSide, angle: f64) -> Option<Self> {
        let positive = Positive::new(angle.to_degrees());
        let from_zero = NonNegative::new(angle.to_degrees());
        let of_side = |face: Positive, back: Option<Positive>| match side {
            WeldedSide::Face => Some((positive?, Some(back.unwrap_or(face)))),
            WeldedSide::Back => Some((face, Some(positive?))),
        };
        Some(match self {
            Self::SingleV(p) => Self::SingleV(SingleV { angle_deg: positive?, ..p.clone() }),
            Self::DoubleV(p) => {
                let (angle_deg, back_angle_deg) = of_side(p.angle_deg, p.back_angle_deg)?;
                Self::DoubleV(DoubleV { angle_deg, back_angle_deg, ..p.clone() })
            }
            Self::Bevel(p) => Self::Bevel(Bevel { angle_deg: positive?, ..p.clone() }),
            Self::DoubleBevel(p) => {
                let (angle_deg, back_angle_deg) = of_side(p.angle_deg, p.back_angle_deg)?;
                Self::DoubleBevel(DoubleBevel { angle_deg, back_angle_deg, ..p.clone() })
            }
            Self::U(p) => Self::U(U { angle_deg: from_zero?, ..p.clone() }),
            Self::DoubleU(p) => Self::DoubleU(DoubleU { angle_deg: from_zero?, ..p.clone() }),
            Self::J(p) => Self::J(J { angle_deg: from_zero?, ..p.clone() }),
            Self::TBevel(p) => Self::TBevel(TBevel { angle_deg: Some(positive?), cut_deg: None, ..p.clone() }),
            Self::TDoubleBevel(p) => {
                let (angle_deg, back_angle_deg) = of_side(p.angle_deg, p.back_angle_deg)?;
                Self::TDoubleBevel(TDoubleBevel { angle_deg, back_angle_deg, ..p.clone() })
            }
            Self::TJ(p) => Self::TJ(TJ { angle_deg: from_zero?, ..p.clone() }),
            Self::Square(_) | Self::Corner(_) | Self::Fillet(_) | Self::Lap(_) => return None,
            Self::FlareBevel(_) | Self::FlareV(_) => return None,
        })
    }

    /// Least and largest groove angle that leaves an edge on a side, degrees; `None` without straight bevelled edges.
    pub(crate) fn angle_range_deg(&self, side: WeldedSide) -> Option<[f64; 2]> {
        let depth = self.depths_mm()[usize::from(side == WeldedSide::Back)];
        // The arc of a U or J ends within the wall: radius (1 - sin angle) is less than its depth.
        let least = |radius: Positive| (1.0 - depth / radius.get()).clamp(0.0, 1.0).asin().to_degrees();
        match self {
            Self::SingleV(_) | Self::DoubleV(_) => Some([0.0, 170.0]),
            Self::Bevel(_) | Self::DoubleBevel(_) => Some([0.0, 85.0]),
            Self::TBevel(_) | Self::TDoubleBevel(_) => Some([0.0, 150.0]),
            Self::U(p) => Some([least(p.radius_mm), 60.0]),
            Self::DoubleU(p) => Some([least(p.radius_mm), 60.0]),
            Self::J(p) => Some([least(p.radius_mm), 60.0]),
            Self::TJ(p) => Some([least(p.radius_mm), 60.0]),
            Self::Square(_) | Self::Corner(_) | Self::Fillet(_) | Self::Lap(_) => None,
            Self::FlareBevel(_) | Self::FlareV(_) => None,
        }
    }

    /// Thickness (mm) of the prepared part, root gap and root face (mm) as drawn; `None` of a fillet or a flare groove,
    /// and of preparations without a root face.
    fn sizes(&self) -> (Option<Positive>, NonNegative, Option<NonNegative>) {
        match self {
            Self::Square(p) => (Some(p.thickness_mm), p.root_gap_mm, None),
            Self::SingleV(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::DoubleV(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::Bevel(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::DoubleBevel(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::U(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::DoubleU(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::J(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::Corner(p) => (Some(p.thickness_mm), p.root_gap_mm, None),
            Self::Fillet(p) => (None, p.root_gap_mm, None),
            Self::Lap(p) => (Some(p.thickness_mm), p.root_gap_mm, None),
            Self::FlareBevel(_) | Self::FlareV(_) => (None, NonNegative::default(), None),
            Self::TBevel(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::TDoubleBevel(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
            Self::TJ(p) => (Some(p.thickness_mm), p.root_gap_mm, Some(p.root_face_mm)),
        }
    }

    /// Thickness of the prepared part, mm; `None` of a fillet or a flare groove.
    pub fn thickness_mm(&self) -> Option<f64> {
        self.sizes().0.map(Positive::get)
    }

    /// Root gap of the drawing, mm.
    pub fn root_gap_mm(&self) -> f64 {
        self.sizes().1.get()
    }

    /// Root face of the drawing, mm; `None` of preparations without one.
    pub fn root_face_mm(&self) -> Option<f64> {
        self.sizes().2.map(NonNegative::get)
    }

    /// Key of the size that the area of the groove follows from, below [`Preparation::key`].
    pub fn size_key(&self) -> &'static str {
        match self {
            Self::FlareBevel(_) | Self::FlareV(_) => "radius_mm",
            Self::Fillet(p) if p.throat_mm.is_some() => "throat_mm",
            Self::Fillet(p) if p.first_leg_mm.is_some() => "first_leg_mm",
            Self::Fillet(_) | Self::Lap(_) => "leg_mm",
            _ => "thickness_mm",
        }
    }

    /// True if the edges face each other over the bisector of the parts' surfaces: in butt and corner joints.
    pub fn is_butt(&self) -> bool {
        let across = matches!(self, Self::Square(_) | Self::SingleV(_) | Self::Bevel(_) | Self::U(_) | Self::J(_));
        across || matches!(self, Self::FlareV(_) | Self::Corner(_)) || (self.is_double() && !self.is_t())
    }

    /// True if an edge stands on the other part's face with a bevel or a J.
    pub fn is_t(&self) -> bool {
        matches!(self, Self::TBevel(_) | Self::TDoubleBevel(_) | Self::TJ(_))
    }

    /// The part whose edge stands on the other's face; `None` where none does.
    pub fn standing(&self) -> Option<Member> {
        match self {
            Self::TBevel(p) => Some(p.prepared),
            Self::TDoubleBevel(p) => Some(p.prepared),
            Self::TJ(p) => Some(p.prepared),
            Self::Fillet(p) => Some(p.prepared),
            Self::Lap(p) => Some(p.prepared),
            Self::FlareBevel(p) => Some(p.round),
            _ => None,
        }
    }

    /// True if both sides are prepared.
    pub fn is_double(&self) -> bool {
        self.double().is_some()
    }

    /// Sizes of an edge that is prepared on both sides.
    fn double(&self) -> Option<Double> {
        let (thickness, root_face, depth) = match self {
            Self::DoubleV(p) => (p.thickness_mm, p.root_face_mm, p.depth_mm),
            Self::DoubleBevel(p) => (p.thickness_mm, p.root_face_mm, p.depth_mm),
            Self::DoubleU(p) => (p.thickness_mm, p.root_face_mm, p.depth_mm),
            Self::TDoubleBevel(p) => (p.thickness_mm, p.root_face_mm, p.depth_mm),
            _ => return None,
        };
        Some(Double { thickness: thickness.get(), root_face: root_face.get(), depth: depth.map(Positive::get) })
    }

    /// Depths (mm) of the preparation on the face, down to the root face, and on the back.
    pub fn depths_mm(&self) -> [f64; 2] {
        let (thickness, _, root_face) = self.sizes();
        match (self.double(), thickness) {
            (Some(double), _) => double.depths(),
            (None, Some(thickness)) => [thickness.get() - root_face.map_or(0.0, NonNegative::get), 0.0],
            (None, None) => [0.0, 0.0],
        }
    }

    /// The widest root gap that still is one, mm: the thickness of the wall (a fillet's leg), or the width that the
    /// bevels open at the surface of a joint at right angles or in a plane, if that is more.
    fn max_root_gap_mm(&self) -> f64 {
        let [depth, _] = self.depths_mm();
        let thickness = self.thickness_mm().unwrap_or(f64::INFINITY);
        let bevel = |degrees: f64, sides: f64| (sides * depth * degrees.to_radians().tan()).max(thickness);
        match self {
            Self::SingleV(p) => bevel(0.5 * p.angle_deg.get(), 2.0),
            Self::DoubleV(p) => bevel(0.5 * p.angle_deg.get(), 2.0),
            Self::Bevel(p) => bevel(p.angle_deg.get(), 1.0),
            Self::DoubleBevel(p) => bevel(p.angle_deg.get(), 1.0),
            Self::U(p) => bevel(p.angle_deg.get(), 2.0),
            Self::DoubleU(p) => bevel(p.angle_deg.get(), 2.0),
            Self::J(p) => bevel(p.angle_deg.get(), 1.0),
            Self::Fillet(p) => {
                let legs = [p.leg_mm, p.first_leg_mm, p.second_leg_mm, p.throat_mm];
                legs.into_iter().flatten().map(Positive::get).fold(f64::INFINITY, f64::min)
            }
            Self::Lap(p) => p.leg_mm.get(),
            _ => thickness,
        }
    }
}

/// Maximum leg or throat of a fillet, mm; a larger one is a mistake.
const MAX_FILLET_MM: f64 = 150.0;

/// Sizes of an edge that is prepared on both sides, mm.
#[derive(Debug, Clone, Copy)]
struct Double {
    thickness: f64,
    root_face: f64,
    /// Depth on the face, if it is given.
    depth: Option<f64>,
}

impl Double {
    fn depths(self) -> [f64; 2] {
        let both = self.thickness - self.root_face;
        let face = self.depth.unwrap_or(0.5 * both);
        [face, both - face]
    }
}

impl Preparation {
    /// The sizes of fillets, mm, with their keys.
    fn fillet_sizes(&self) -> Vec<(&'static str, f64)> {
        let given = |key, size: Option<Positive>| size.map(|size| (key, size.get()));
        match self {
            Self::Fillet(p) => [
                given("leg_mm", p.leg_mm),
                given("first_leg_mm", p.first_leg_mm),
                given("second_leg_mm", p.second_leg_mm),
                given("throat_mm", p.throat_mm),
            ]
            .into_iter()
            .flatten()
            .collect(),
            Self::Lap(p) => vec![("leg_mm", p.leg_mm.get())],
            Self::TBevel(p) => vec![("leg_mm", p.leg_mm.get())],
            Self::TDoubleBevel(p) => vec![("leg_mm", p.leg_mm.get())],
            Self::TJ(p) => vec![("leg_mm", p.leg_mm.get())],
            _ => Vec::new(),
        }
    }

    /// Checks that the sizes at `path` of a file do not contradict each other. Fails with the key's address.
    pub(crate) fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let at = Keys { file, path: format!("{path}.{}", self.key()) };
        if let Some((key, _)) = self.fillet_sizes().into_iter().find(|(_, size)| *size > MAX_FILLET_MM) {
            let allowed = Message::new("document-at-most").value("max", MAX_FILLET_MM, Unit::Mm);
            return at.wrong(key, "program-fillet-implausible", allowed);
        }
        if let (Some(thickness), _, Some(root_face)) = self.sizes()
            && root_face.get() >= thickness.get()
        {
            return at.wrong("root_face_mm", "program-root-face-too-high", below("thickness_mm", thickness));
        }
        if let Some(Double { thickness, root_face, depth: Some(depth) }) = self.double()
            && depth >= thickness - root_face
        {
            let allowed = Message::new("document-less-than").quantity("max", thickness - root_face, Unit::Mm, 3);
            return at.wrong("depth_mm", "program-depth-leaves-no-back", allowed);
        }
        let [depth, back] = self.depths_mm();
        match self {
            Self::Square(_) | Self::Corner(_) => Ok(()),
            Self::SingleV(p) => at.angle("angle_deg", Some(p.angle_deg), 170.0),
            Self::DoubleV(p) => {
                at.angle("angle_deg", Some(p.angle_deg), 170.0)?;
                at.angle("back_angle_deg", p.back_angle_deg, 170.0)
            }
            Self::Bevel(p) => at.angle("angle_deg", Some(p.angle_deg), 85.0),
            Self::DoubleBevel(p) => {
                at.angle("angle_deg", Some(p.angle_deg), 85.0)?;
                at.angle("back_angle_deg", p.back_angle_deg, 85.0)
            }
            Self::U(p) => at.curved(p.angle_deg, p.radius_mm, depth),
            Self::DoubleU(p) => at.curved(p.angle_deg, p.radius_mm, depth.min(back)),
            Self::J(p) => at.curved(p.angle_deg, p.radius_mm, depth),
            Self::TJ(p) => at.curved(p.angle_deg, p.radius_mm, depth),
            Self::Fillet(p) => {
                let both = usize::from(p.first_leg_mm.is_some() && p.second_leg_mm.is_some());
                let one = p.first_leg_mm.is_some() != p.second_leg_mm.is_some();
                let given = usize::from(p.leg_mm.is_some()) + usize::from(p.throat_mm.is_some()) + both;
                if given == 1 && !one {
                    return Ok(());
                }
                let message = Message::new("program-fillet-size-unclear");
                Err(file.error_at(&at.path, message, Message::new("program-fillet-sizes")))
            }
            Self::Lap(p) if p.leg_mm > p.thickness_mm => {
                let allowed = Message::new("program-positive-up-to-key").key("key", "thickness_mm");
                let allowed = allowed.value("max", p.thickness_mm.get(), Unit::Mm);
                at.wrong("leg_mm", "program-lap-leg-too-long", allowed)
            }
            Self::Lap(_) => Ok(()),
            Self::FlareBevel(p) => at.unfilled(p.unfilled_mm, p.radius_mm),
            Self::FlareV(p) => at.unfilled(p.unfilled_mm, p.radius_mm),
            Self::TBevel(p) => {
                if p.angle_deg.is_some() != p.cut_deg.is_some() {
                    return Ok(());
                }
                let message = Message::new("program-bevel-angle-unclear");
                Err(file.error_at(&at.path, message, Message::new("program-bevel-angles")))
            }
            Self::TDoubleBevel(_) => Ok(()),
        }
    }

    /// Checks that a root gap (mm) at a key of a file leaves a groove: it is not wider than the wall, or than the groove
    /// that the edges open where that is more. Fails with the key's address.
    pub(crate) fn check_gap<T>(&self, file: &Document<T>, key: &str, gap: f64) -> Result<(), DocumentError> {
        let most = self.max_root_gap_mm();
        if gap <= most {
            return Ok(());
        }
        let allowed = Message::new("document-between").value("min", 0.0, Unit::Mm).quantity("max", most, Unit::Mm, 1);
        Err(file.error_at(key, Message::new("program-root-gap-too-wide"), allowed))
    }
}

/// The keys of a preparation in a file.
struct Keys<'a, T> {
    file: &'a Document<T>,
    path: String,
}

impl<T> Keys<'_, T> {
    fn wrong(&self, key: &str, code: &'static str, allowed: Message) -> Result<(), DocumentError> {
        Err(self.file.error_at(&format!("{}.{key}", self.path), Message::new(code), allowed))
    }

    fn angle(&self, key: &str, degrees: Option<Positive>, most: f64) -> Result<(), DocumentError> {
        if degrees.is_none_or(|degrees| degrees.get() < most) {
            return Ok(());
        }
        let allowed = Message::new("document-less-than").value("max", most, Unit::Deg);
        self.wrong(key, "program-groove-angle-too-large", allowed)
    }

    /// Checks an edge with an arc that is `depth` mm high.
    fn curved(&self, slope: NonNegative, radius: Positive, depth: f64) -> Result<(), DocumentError> {
        self.angle("angle_deg", Positive::new(slope.get()), 60.0)?;
        let high = radius.get() * (1.0 - slope.get().to_radians().sin());
        if high < depth {
            return Ok(());
        }
        let allowed = Message::new("document-less-than").quantity("max", depth * radius.get() / high, Unit::Mm, 3);
        self.wrong("radius_mm", "program-radius-too-large", allowed)
    }

    fn unfilled(&self, unfilled: NonNegative, radius: Positive) -> Result<(), DocumentError> {
        if unfilled.get() < radius.get() {
            return Ok(());
        }
        self.wrong("unfilled_mm", "program-nothing-filled", below("radius_mm", radius))
    }
}

fn below(key: &'static str, max: Positive) -> Message {
    Message::new("program-less-than-key").key("key", key).value("max", max.get(), Unit::One)
}
