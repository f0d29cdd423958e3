//! Joints: how the edges are prepared and how they were fitted up.

use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// The joint along the seam.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Joint {
    /// Preparation of the edges.
    pub preparation: Preparation,
    /// Height of the cap's middle over the line from toe to toe (excess weld metal, convexity), mm.
    #[serde(default)]
    pub cap_mm: NonNegative,
    /// The groove as measured, linear in between; without it that of the drawing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fit_up: Vec<FitUp>,
}

/// Joint preparation after ISO 9692-1, from the side that is welded.
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
    /// Single bevel butt.
    Bevel(Bevel),
    /// Single U butt.
    U(U),
    /// Single J butt.
    J(J),
    /// Fillet.
    Fillet(Fillet),
    /// A round part beside a flat one: flare bevel.
    FlareBevel(FlareBevel),
    /// Two round parts side by side: flare V.
    FlareV(FlareV),
    /// Single bevel T: a bevelled edge on a face, as of a nozzle set on its shell or let into it.
    TBevel(TBevel),
    /// Single J on a face.
    TJ(TJ),
}

/// One of the two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Member {
    /// The first part: nozzle, tube, wall.
    #[default]
    First,
    /// The second part: body, plate.
    Second,
}

/// Square butt preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Square {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
}

/// Single V preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SingleV {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Groove angle between the faces, degrees.
    pub angle_deg: Positive,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
}

/// Single bevel preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bevel {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle from the square edge, degrees.
    pub angle_deg: Positive,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// The part that is bevelled.
    #[serde(default)]
    pub prepared: Member,
}

/// Single U preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct U {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle of each face, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius on each side, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
}

/// Single J preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct J {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle from the square edge, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// The part that is prepared.
    #[serde(default)]
    pub prepared: Member,
}

/// Fillet: give `leg_mm`, or both legs apart, or `throat_mm`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fillet {
    /// Leg length on both parts, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub leg_mm: Option<Positive>,
    /// Leg length on the first part, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first_leg_mm: Option<Positive>,
    /// Leg length on the second part, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second_leg_mm: Option<Positive>,
    /// Throat, mm: equal legs that change with the dihedral angle so that the throat stays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub throat_mm: Option<Positive>,
    /// Root gap between the parts, mm, along the part that stands; the leg on that part is longer by it.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// The part that stands on the other.
    #[serde(default)]
    pub prepared: Member,
}

/// Flare bevel: a round part that touches a flat one, filled to the line square to the flat one that touches the round
/// one. The seam is the line where those two meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlareBevel {
    /// Radius of the round part, mm.
    pub radius_mm: Positive,
    /// Depth next to the line of contact that is not filled, mm.
    #[serde(default)]
    pub unfilled_mm: NonNegative,
    /// The round part.
    #[serde(default)]
    pub round: Member,
}

/// Flare V: two round parts that touch, filled to the line that touches both. The seam lies on that line, above the
/// contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlareV {
    /// Radius of both parts, mm.
    pub radius_mm: Positive,
    /// Depth next to the line of contact that is not filled, mm.
    #[serde(default)]
    pub unfilled_mm: NonNegative,
}

/// Single bevel T: give the angle of the groove, or that of the cut.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TBevel {
    /// Thickness of the part whose edge is prepared, mm.
    pub thickness_mm: Positive,
    /// Groove angle between its bevel and the other part's face, degrees: the same all along the seam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Positive>,
    /// Angle of the cut from the square edge, degrees: the same all along, so that the groove angle follows the
    /// dihedral angle, groove = cut + (dihedral - 90).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut_deg: Option<Finite>,
    /// Root gap, mm, along the wall of the part whose edge is prepared: so far it is lifted off the other.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm: the part of the wall's thickness that is not bevelled.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// Leg of the cover fillet on the other part's face, mm.
    #[serde(default)]
    pub leg_mm: NonNegative,
    /// The part whose edge is prepared: `first` for a nozzle set on, `second` for one let into its shell.
    #[serde(default)]
    pub prepared: Member,
}

/// Single J on a face.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TJ {
    /// Thickness of the part whose edge is prepared, mm.
    pub thickness_mm: Positive,
    /// Angle between the J's straight part and the other part's face, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Root gap, mm, along the wall of the part whose edge is prepared: so far it is lifted off the other.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm: the part of the wall's thickness that is not prepared.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// Leg of the cover fillet on the other part's face, mm.
    #[serde(default)]
    pub leg_mm: NonNegative,
    /// The part whose edge is prepared.
    #[serde(default)]
    pub prepared: Member,
}

/// The groove as measured at one position, before the weld or after some of its layers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitUp {
    /// Path length from the start of the weld, mm.
    pub s_mm: NonNegative,
    /// Root gap there, mm.
    pub root_gap_mm: NonNegative,
    /// Height of the second part's surface above the first's, mm; negative: the second part lies lower.
    #[serde(default)]
    pub mismatch_mm: Finite,
    /// Groove angle there, degrees: it replaces the angle of the preparation, and is measured as that. As drawn if
    /// missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<NonNegative>,
    /// Number of layers that were complete when this was measured. The layers above are planned from it; those below
    /// stay as planned from the entries before.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub after_layer: usize,
    /// Area of the groove that is still open there, mm^2, from the surface of the last layer up to the line from toe to
    /// toe, without the cap; negative if the surface is above that line. Needed after a layer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub remaining_mm2: Option<Finite>,
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Preparation {
    /// Its key.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Square(_) => "square",
            Self::SingleV(_) => "single_v",
            Self::Bevel(_) => "bevel",
            Self::U(_) => "u",
            Self::J(_) => "j",
            Self::Fillet(_) => "fillet",
            Self::FlareBevel(_) => "flare_bevel",
            Self::FlareV(_) => "flare_v",
            Self::TBevel(_) => "t_bevel",
            Self::TJ(_) => "t_j",
        }
    }

    /// Groove angle where the faces are at this dihedral angle, rad, as `angle_deg` of the preparation counts it; `None`
    /// without straight bevelled edges.
    pub fn groove_angle(&self, dihedral: f64) -> Option<f64> {
        match self {
            Self::SingleV(p) => Some(p.angle_deg.get().to_radians()),
            Self::Bevel(p) => Some(p.angle_deg.get().to_radians()),
            Self::U(p) => Some(p.angle_deg.get().to_radians()),
            Self::J(p) => Some(p.angle_deg.get().to_radians()),
            Self::TBevel(p) => match (p.angle_deg, p.cut_deg) {
                (_, Some(cut)) => Some(cut.get().to_radians() + dihedral - FRAC_PI_2),
                (angle, None) => angle.map(|angle| angle.get().to_radians()),
            },
            Self::TJ(p) => Some(p.angle_deg.get().to_radians()),
            Self::Square(_) | Self::Fillet(_) | Self::FlareBevel(_) | Self::FlareV(_) => None,
        }
    }

    /// The same preparation with this groove angle, rad; `None` if it has no angle, or none of this size.
    #[must_use]
    pub fn with_groove_angle(&self, angle: f64) -> Option<Self> {
        let positive = Positive::new(angle.to_degrees());
        let from_zero = NonNegative::new(angle.to_degrees());
        Some(match self {
            Self::SingleV(p) => Self::SingleV(SingleV { angle_deg: positive?, ..p.clone() }),
            Self::Bevel(p) => Self::Bevel(Bevel { angle_deg: positive?, ..p.clone() }),
            Self::U(p) => Self::U(U { angle_deg: from_zero?, ..p.clone() }),
            Self::J(p) => Self::J(J { angle_deg: from_zero?, ..p.clone() }),
            Self::TBevel(p) => Self::TBevel(TBevel { angle_deg: Some(positive?), cut_deg: None, ..p.clone() }),
            Self::TJ(p) => Self::TJ(TJ { angle_deg: from_zero?, ..p.clone() }),
            Self::Square(_) | Self::Fillet(_) | Self::FlareBevel(_) | Self::FlareV(_) => return None,
        })
    }

    /// Least and largest groove angle that leaves an edge, degrees; `None` without straight bevelled edges.
    fn angle_range_deg(&self) -> Option<[f64; 2]> {
        // The arc of a U or J ends within the wall: radius (1 - sin angle) is less than its depth.
        let least = |radius: Positive, thickness: Positive, root_face: NonNegative| {
            let part = 1.0 - (thickness.get() - root_face.get()) / radius.get();
            part.clamp(0.0, 1.0).asin().to_degrees()
        };
        match self {
            Self::SingleV(_) => Some([0.0, 170.0]),
            Self::Bevel(_) => Some([0.0, 85.0]),
            Self::TBevel(_) => Some([0.0, 150.0]),
            Self::U(p) => Some([least(p.radius_mm, p.thickness_mm, p.root_face_mm), 60.0]),
            Self::J(p) => Some([least(p.radius_mm, p.thickness_mm, p.root_face_mm), 60.0]),
            Self::TJ(p) => Some([least(p.radius_mm, p.thickness_mm, p.root_face_mm), 60.0]),
            Self::Square(_) | Self::Fillet(_) | Self::FlareBevel(_) | Self::FlareV(_) => None,
        }
    }

    /// The key that a file gives instead of `key`, if it does: an angle of a bevel may be given by its cut.
    pub fn given_key(&self, key: &'static str) -> &'static str {
        match self {
            Self::TBevel(p) if key == "angle_deg" && p.cut_deg.is_some() => "cut_deg",
            _ => key,
        }
    }

    /// Thickness of the prepared part, mm; none of a fillet or a flare groove.
    pub fn thickness_mm(&self) -> Option<f64> {
        let thickness = match self {
            Self::Square(p) => p.thickness_mm,
            Self::SingleV(p) => p.thickness_mm,
            Self::Bevel(p) => p.thickness_mm,
            Self::U(p) => p.thickness_mm,
            Self::J(p) => p.thickness_mm,
            Self::TBevel(p) => p.thickness_mm,
            Self::TJ(p) => p.thickness_mm,
            Self::Fillet(_) | Self::FlareBevel(_) | Self::FlareV(_) => return None,
        };
        Some(thickness.get())
    }

    /// Key of the size that the area of the groove follows from, below [`Preparation::key`].
    pub fn size_key(&self) -> &'static str {
        match self {
            Self::Square(_) | Self::SingleV(_) | Self::Bevel(_) | Self::U(_) | Self::J(_) => "thickness_mm",
            Self::TBevel(_) | Self::TJ(_) => "thickness_mm",
            Self::FlareBevel(_) | Self::FlareV(_) => "radius_mm",
            Self::Fillet(p) if p.throat_mm.is_some() => "throat_mm",
            Self::Fillet(p) if p.first_leg_mm.is_some() => "first_leg_mm",
            Self::Fillet(_) => "leg_mm",
        }
    }

    /// True if both parts' surfaces lie in one plane, nearly.
    pub fn is_butt(&self) -> bool {
        matches!(self, Self::Square(_) | Self::SingleV(_) | Self::Bevel(_) | Self::U(_) | Self::J(_) | Self::FlareV(_))
    }

    /// Thickness of the parts of a butt joint with walls, mm.
    fn butt_thickness_mm(&self) -> Option<f64> {
        match self {
            Self::Square(p) => Some(p.thickness_mm.get()),
            Self::SingleV(p) => Some(p.thickness_mm.get()),
            Self::Bevel(p) => Some(p.thickness_mm.get()),
            Self::U(p) => Some(p.thickness_mm.get()),
            Self::J(p) => Some(p.thickness_mm.get()),
            Self::Fillet(_) | Self::FlareBevel(_) | Self::FlareV(_) | Self::TBevel(_) | Self::TJ(_) => None,
        }
    }

    /// The widest root gap that still is one, mm: the thickness of the wall (a fillet's leg), or the width that the
    /// bevels open at the surface of a joint at right angles or in a plane, if that is more.
    fn max_root_gap_mm(&self) -> f64 {
        let bevel = |thickness: Positive, root_face: NonNegative, degrees: f64, sides: f64| {
            let width = sides * (thickness.get() - root_face.get()) * degrees.to_radians().tan();
            width.max(thickness.get())
        };
        match self {
            Self::Square(p) => p.thickness_mm.get(),
            Self::SingleV(p) => bevel(p.thickness_mm, p.root_face_mm, 0.5 * p.angle_deg.get(), 2.0),
            Self::Bevel(p) => bevel(p.thickness_mm, p.root_face_mm, p.angle_deg.get(), 1.0),
            Self::U(p) => bevel(p.thickness_mm, p.root_face_mm, p.angle_deg.get(), 2.0),
            Self::J(p) => bevel(p.thickness_mm, p.root_face_mm, p.angle_deg.get(), 1.0),
            Self::Fillet(p) => {
                let legs = [p.leg_mm, p.first_leg_mm, p.second_leg_mm, p.throat_mm];
                legs.into_iter().flatten().map(Positive::get).fold(f64::INFINITY, f64::min)
            }
            Self::FlareBevel(_) | Self::FlareV(_) => f64::INFINITY,
            Self::TBevel(p) => p.thickness_mm.get(),
            Self::TJ(p) => p.thickness_mm.get(),
        }
    }

    /// Root gap of the drawing, mm.
    pub fn root_gap_mm(&self) -> f64 {
        match self {
            Self::Square(p) => p.root_gap_mm.get(),
            Self::SingleV(p) => p.root_gap_mm.get(),
            Self::Bevel(p) => p.root_gap_mm.get(),
            Self::U(p) => p.root_gap_mm.get(),
            Self::J(p) => p.root_gap_mm.get(),
            Self::Fillet(p) => p.root_gap_mm.get(),
            Self::FlareBevel(_) | Self::FlareV(_) => 0.0,
            Self::TBevel(p) => p.root_gap_mm.get(),
            Self::TJ(p) => p.root_gap_mm.get(),
        }
    }
}

impl Joint {
    /// Checks that the sizes at `path` of a file do not contradict each other.
    ///
    /// # Errors
    /// With the key's address: a root face as high as the part, invalid angles, a radius that does not fit. Also a
    /// fillet without or with several sizes, and positions that do not increase.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let at = |key: &str| format!("{path}.preparation.{}.{key}", self.preparation.key());
        let wrong = |key: &str, code, allowed: Message| Err(file.error_at(&at(key), Message::new(code), allowed));
        let below = |key: &str, max: Positive| {
            Message::new("program-less-than-key").key("key", key).value("max", max.get(), Unit::One)
        };
        let face = |face: NonNegative, thickness: Positive| match face.get() < thickness.get() {
            true => Ok(()),
            false => wrong("root_face_mm", "program-root-face-too-high", below("thickness_mm", thickness)),
        };
        let angle = |degrees: f64, most: f64| match degrees < most {
            true => Ok(()),
            false => {
                let allowed = Message::new("document-less-than").value("max", most, Unit::Deg);
                wrong("angle_deg", "program-groove-angle-too-large", allowed)
            }
        };
        let curved = |slope: NonNegative, radius: Positive, thickness: Positive, root_face: NonNegative| {
            face(root_face, thickness)?;
            angle(slope.get(), 60.0)?;
            let depth = thickness.get() - root_face.get();
            let high = radius.get() * (1.0 - slope.get().to_radians().sin());
            if high < depth {
                return Ok(());
            }
            let max = depth * radius.get() / high;
            let allowed = Message::new("document-less-than").quantity("max", max, Unit::Mm, 3);
            wrong("radius_mm", "program-radius-too-large", allowed)
        };
        let unfilled = |unfilled: NonNegative, radius: Positive| match unfilled.get() < radius.get() {
            true => Ok(()),
            false => wrong("unfilled_mm", "program-nothing-filled", below("radius_mm", radius)),
        };
        match &self.preparation {
            Preparation::Square(_) => {}
            Preparation::SingleV(p) => {
                face(p.root_face_mm, p.thickness_mm)?;
                angle(p.angle_deg.get(), 170.0)?;
            }
            Preparation::Bevel(p) => {
                face(p.root_face_mm, p.thickness_mm)?;
                angle(p.angle_deg.get(), 85.0)?;
            }
            Preparation::U(p) => curved(p.angle_deg, p.radius_mm, p.thickness_mm, p.root_face_mm)?,
            Preparation::J(p) => curved(p.angle_deg, p.radius_mm, p.thickness_mm, p.root_face_mm)?,
            Preparation::Fillet(p) => {
                let both = usize::from(p.first_leg_mm.is_some() && p.second_leg_mm.is_some());
                let one = p.first_leg_mm.is_some() != p.second_leg_mm.is_some();
                let given = usize::from(p.leg_mm.is_some()) + usize::from(p.throat_mm.is_some()) + both;
                if given != 1 || one {
                    let message = Message::new("program-fillet-size-unclear");
                    let allowed = Message::new("program-fillet-sizes");
                    return Err(file.error_at(&format!("{path}.preparation.fillet"), message, allowed));
                }
            }
            Preparation::FlareBevel(p) => unfilled(p.unfilled_mm, p.radius_mm)?,
            Preparation::FlareV(p) => unfilled(p.unfilled_mm, p.radius_mm)?,
            Preparation::TBevel(p) => {
                face(p.root_face_mm, p.thickness_mm)?;
                if p.angle_deg.is_some() == p.cut_deg.is_some() {
                    let message = Message::new("program-bevel-angle-unclear");
                    let allowed = Message::new("program-bevel-angles");
                    return Err(file.error_at(&format!("{path}.preparation.t_bevel"), message, allowed));
                }
            }
            Preparation::TJ(p) => curved(p.angle_deg, p.radius_mm, p.thickness_mm, p.root_face_mm)?,
        }
        self.check_gaps(file, path)?;
        self.check_fit_up(file, path)
    }

    /// Checks that root gaps and mismatches leave a groove: a gap is not wider than the wall, or than the groove that
    /// the edges open where that is more; mismatched walls still face each other.
    fn check_gaps<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let most = self.preparation.max_root_gap_mm();
        let drawn = format!("{path}.preparation.{}.root_gap_mm", self.preparation.key());
        let measured = |i: usize| format!("{path}.fit_up[{i}].root_gap_mm");
        let gaps = std::iter::once((drawn, self.preparation.root_gap_mm()));
        for (key, gap) in gaps.chain(self.fit_up.iter().enumerate().map(|(i, f)| (measured(i), f.root_gap_mm.get()))) {
            if gap > most {
                let allowed = Message::new("document-between").value("min", 0.0, Unit::Mm);
                let allowed = allowed.quantity("max", most, Unit::Mm, 1);
                return Err(file.error_at(&key, Message::new("program-root-gap-too-wide"), allowed));
            }
        }
        let Some(wall) = self.preparation.butt_thickness_mm() else { return Ok(()) };
        for (i, at) in self.fit_up.iter().enumerate() {
            if at.mismatch_mm.get().abs() >= wall {
                let allowed = Message::new("document-strictly-between");
                let allowed = allowed.value("min", -wall, Unit::Mm).value("max", wall, Unit::Mm);
                let key = format!("{path}.fit_up[{i}].mismatch_mm");
                return Err(file.error_at(&key, Message::new("program-mismatch-too-large"), allowed));
            }
        }
        Ok(())
    }

    fn check_fit_up<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        for (i, pair) in self.fit_up.windows(2).enumerate() {
            if pair[1].after_layer < pair[0].after_layer {
                let key = file
                    .given_or(&format!("{path}.fit_up[{}].after_layer", i + 1), &format!("{path}.fit_up[{}]", i + 1))
                    .to_owned();
                let allowed = Message::new("document-at-least").value("min", pair[0].after_layer as f64, Unit::One);
                return Err(file.error_at(&key, Message::new("program-layers-increase"), allowed));
            }
            if pair[1].after_layer == pair[0].after_layer && pair[1].s_mm <= pair[0].s_mm {
                let key = format!("{path}.fit_up[{}].s_mm", i + 1);
                let allowed = Message::new("document-more-than").value("min", pair[0].s_mm.get(), Unit::Mm);
                return Err(file.error_at(&key, Message::new("program-positions-increase"), allowed));
            }
        }
        for (i, at) in self.fit_up.iter().enumerate() {
            self.check_measured(file, &format!("{path}.fit_up[{i}]"), at)?;
        }
        let flare = matches!(self.preparation, Preparation::FlareBevel(_) | Preparation::FlareV(_));
        if flare && self.fit_up.iter().any(|f| f.root_gap_mm.get() > 0.0) {
            let message = Message::new("program-flare-root-gap");
            return Err(file.error_at(&format!("{path}.fit_up"), message, "root_gap_mm = 0"));
        }
        Ok(())
    }
}

impl Joint {
    /// Checks the measured angle and the remaining area of the entry at `path`.
    fn check_measured<T>(&self, file: &Document<T>, path: &str, at: &FitUp) -> Result<(), DocumentError> {
        if let Some(angle) = at.angle_deg {
            let key = format!("{path}.angle_deg");
            let Some([min, max]) = self.preparation.angle_range_deg() else {
                let allowed = Message::new("program-allowed-bevelled-kinds");
                return Err(file.error_at(&key, Message::new("program-fit-up-without-angle"), allowed));
            };
            let upright = angle.get() == 0.0 && min == 0.0 && self.preparation.with_groove_angle(0.0).is_some();
            if !upright && !(angle.get() > min && angle.get() < max) {
                let allowed = Message::new("document-strictly-between");
                let allowed = allowed.quantity("min", min, Unit::Deg, 3).value("max", max, Unit::Deg);
                return Err(file.error_at(&key, Message::new("program-fit-up-angle-invalid"), allowed));
            }
        }
        match (at.after_layer, at.remaining_mm2) {
            (0, Some(_)) => {
                let allowed = Message::new("program-allowed-after-layer");
                Err(file.error_at(
                    &format!("{path}.remaining_mm2"),
                    Message::new("program-remaining-before-weld"),
                    allowed,
                ))
            }
            (1.., None) => {
                let allowed = Message::new("program-allowed-remaining");
                Err(file.error_at(&format!("{path}.after_layer"), Message::new("program-remaining-missing"), allowed))
            }
            _ => Ok(()),
        }
    }
}

/// Kind of joint along a seam in a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FilletOrButt {
    /// A wall stands on the plate.
    #[default]
    Fillet,
    /// Both parts lie in one plane.
    Butt,
}
