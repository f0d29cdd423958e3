//! Joints: how the edges are prepared and how they were fitted up.

use crate::insert::Insert;
use crate::preparation::Preparation;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// The joint along the seam.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Joint {
    /// Preparation of the edges.
    pub preparation: Preparation,
    /// The side that is welded. The seam lies on its surface.
    #[serde(default, skip_serializing_if = "WeldedSide::is_face")]
    pub side: WeldedSide,
    /// Groove gouged into the back before it is welded, down to sound metal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gouge: Option<Gouge>,
    /// Backing behind the root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub backing: Option<Backing>,
    /// Consumable insert in the root gap, fused by the root pass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub insert: Option<Insert>,
    /// Groove angle and root gap by the dihedral angle, linear in between, of an edge that stands on a face; they replace
    /// those of the preparation.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub at_dihedral: Vec<AtDihedral>,
    /// Standard whose ranges the joint is compared with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub standard: Option<JointStandard>,
    /// Height of the cap's middle over the line from toe to toe (excess weld metal, convexity), mm.
    #[serde(default)]
    pub cap_mm: NonNegative,
    /// The groove as measured, linear in between; without it that of the drawing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fit_up: Vec<FitUp>,
}

/// Side of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WeldedSide {
    /// The side that is welded first, or the only one.
    #[default]
    Face,
    /// The other side, with the face welded.
    Back,
}

impl WeldedSide {
    /// True for the face.
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
    pub fn is_face(&self) -> bool {
        *self == Self::Face
    }
}

/// The groove that gouging leaves: round at its bottom, with straight sides.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gouge {
    /// Depth below the bottom of the preparation on the back, or below the back's surface where that is not prepared, mm.
    pub depth_mm: Positive,
    /// Radius of the bottom, mm.
    #[serde(default = "gouge_radius")]
    pub radius_mm: Positive,
    /// Angle of each side from the depth direction, degrees.
    #[serde(default = "gouge_angle")]
    pub angle_deg: NonNegative,
}

/// Usual radius of a groove of air carbon arc gouging with an electrode of 8 to 10 mm, mm.
fn gouge_radius() -> Positive {
    Positive::new(5.0).unwrap_or(Positive::TEN)
}

/// Usual angle of its sides, degrees: ground out to a U that a torch can reach into.
fn gouge_angle() -> NonNegative {
    NonNegative::new(20.0).unwrap_or_default()
}

/// Angle of a gouge's sides that it must stay below, degrees.
const MAX_GOUGE_DEG: f64 = 85.0;

/// Backing behind the root of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Backing {
    /// Kind of backing.
    pub kind: BackingKind,
    /// Width, mm.
    #[serde(default = "backing_width")]
    pub width_mm: Positive,
    /// Thickness, mm.
    #[serde(default = "backing_thickness")]
    pub thickness_mm: Positive,
}

/// Usual width of a backing strip, mm.
fn backing_width() -> Positive {
    Positive::new(25.0).unwrap_or(Positive::TEN)
}

/// Usual thickness of a backing strip for arc welds, mm.
fn backing_thickness() -> Positive {
    Positive::new(6.0).unwrap_or(Positive::TEN)
}

/// Kind of a backing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BackingKind {
    /// A strip of metal that is welded to the root and stays.
    Strip,
    /// The same as a ring in a tube.
    Ring,
    /// Ceramic tiles.
    Ceramic,
    /// A copper bar.
    Copper,
    /// A bed of flux.
    Flux,
}

/// Groove angle and root gap at one dihedral angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AtDihedral {
    /// Dihedral angle between the parts' outsides, degrees.
    pub dihedral_deg: Positive,
    /// Groove angle there, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Positive>,
    /// Root gap there, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root_gap_mm: Option<NonNegative>,
}

/// A standard for joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum JointStandard {
    /// ISO 9692-1: thickness, groove angle, root gap and root face of arc-welded butt joints in steel, and the root gap
    /// of fillets.
    #[serde(rename = "iso_9692_1")]
    Iso9692,
    /// AWS D1.1: details A to D of groove welds in T-, Y- and K-connections of tubes, welded from one side.
    #[serde(rename = "aws_d1_1")]
    AwsD11,
    /// ASME VIII-1, UW-16: throat of the cover fillet of a nozzle.
    #[serde(rename = "asme_uw_16")]
    AsmeUw16,
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

/// Maximum height of a cap, mm; a higher one is a mistake.
const MAX_CAP_MM: f64 = 50.0;

fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Joint {
    /// Checks that the sizes at `path` of a file do not contradict each other.
    ///
    /// # Errors
    /// With the key's address: a root face as high as the part, invalid angles, a radius that does not fit. Also a
    /// fillet without or with several sizes, a back that has no groove, and positions that do not increase.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        self.preparation.check(file, &format!("{path}.preparation"))?;
        if self.cap_mm.get() > MAX_CAP_MM {
            let allowed =
                Message::new("document-between").value("min", 0.0, Unit::Mm).value("max", MAX_CAP_MM, Unit::Mm);
            return Err(file.error_at(&format!("{path}.cap_mm"), Message::new("program-cap-implausible"), allowed));
        }
        self.check_back(file, path)?;
        self.check_gaps(file, path)?;
        self.check_insert(file, path)?;
        self.check_fit_up(file, path)?;
        self.check_at_dihedral(file, path)
    }

    /// Groove angle (rad, as `angle_deg` of the preparation counts it; `None` without straight bevelled edges) and root gap
    /// (mm) of the drawing where the faces are at this dihedral angle, rad.
    pub fn groove(&self, dihedral: f64) -> (Option<f64>, f64) {
        let (angle, gap) = self.at_dihedral(dihedral.to_degrees());
        let angle = angle.map(f64::to_radians);
        let drawn = || self.preparation.groove_angle(self.side, dihedral);
        (angle.or_else(drawn), gap.unwrap_or_else(|| self.preparation.root_gap_mm()))
    }

    /// Groove angle (degrees) and root gap (mm) of the rows by the dihedral angle, degrees: linear in between, constant
    /// beyond.
    fn at_dihedral(&self, degrees: f64) -> (Option<f64>, Option<f64>) {
        let rows = &self.at_dihedral;
        let i = rows.partition_point(|row| row.dihedral_deg.get() <= degrees);
        let (Some(low), Some(high)) = (rows.get(i.saturating_sub(1)), rows.get(i).or(rows.last())) else {
            return (None, None);
        };
        let [from, to] = [low, high].map(|row| row.dihedral_deg.get());
        let part = if to > from { ((degrees - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let between = |a: Option<f64>, b: Option<f64>| Some(a? + part * (b? - a?));
        let angle = |row: &AtDihedral| row.angle_deg.map(Positive::get);
        let gap = |row: &AtDihedral| row.root_gap_mm.map(NonNegative::get);
        (between(angle(low), angle(high)), between(gap(low), gap(high)))
    }

    /// Depth (mm) of the groove on the side that is welded, with the root face on the face and what is gouged on the back.
    pub fn depth_mm(&self) -> f64 {
        let [face, back] = self.preparation.depths_mm();
        match self.side {
            WeldedSide::Face => face + self.preparation.root_face_mm().unwrap_or(0.0),
            WeldedSide::Back => back + self.gouge.map_or(0.0, |gouge| gouge.depth_mm.get()),
        }
    }

    /// Checks that the back has a groove, and that only the back is gouged, no deeper than the wall.
    fn check_back<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let wrong = |key: &str, code, allowed: Message| {
            Err(file.error_at(&format!("{path}.{key}"), Message::new(code), allowed))
        };
        let preparation = &self.preparation;
        let has_back = preparation.is_double() || (preparation.is_butt() && self.gouge.is_some());
        match (self.side, &self.gouge) {
            (WeldedSide::Face, None) => return Ok(()),
            (WeldedSide::Face, Some(_)) => {
                return wrong("gouge", "program-gouge-on-face", Message::new("program-side-back"));
            }
            (WeldedSide::Back, _) if !has_back => {
                return wrong("side", "program-back-without-groove", Message::new("program-groove-on-back"));
            }
            (WeldedSide::Back, None) => return Ok(()),
            (WeldedSide::Back, Some(gouge)) => {
                let room = preparation.thickness_mm().unwrap_or(0.0) - preparation.depths_mm()[1];
                if gouge.depth_mm.get() >= room {
                    let allowed = Message::new("document-less-than").quantity("max", room, Unit::Mm, 3);
                    return wrong("gouge.depth_mm", "program-gouge-through-wall", allowed);
                }
                if gouge.angle_deg.get() >= MAX_GOUGE_DEG {
                    let allowed = Message::new("document-less-than").value("max", MAX_GOUGE_DEG, Unit::Deg);
                    return wrong("gouge.angle_deg", "program-gouge-angle-too-large", allowed);
                }
            }
        }
        if matches!(preparation, Preparation::Corner(_) | Preparation::FlareV(_)) {
            return wrong("side", "program-back-without-groove", Message::new("program-groove-on-back"));
        }
        Ok(())
    }

    /// Checks that root gaps and mismatches leave a groove; mismatched walls still face each other.
    fn check_gaps<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let drawn = format!("{path}.preparation.{}.root_gap_mm", self.preparation.key());
        self.preparation.check_gap(file, &drawn, self.preparation.root_gap_mm())?;
        for (i, at) in self.fit_up.iter().enumerate() {
            self.preparation.check_gap(file, &format!("{path}.fit_up[{i}].root_gap_mm"), at.root_gap_mm.get())?;
        }
        for (i, at) in self.at_dihedral.iter().enumerate() {
            let gap = at.root_gap_mm.map_or(0.0, NonNegative::get);
            self.preparation.check_gap(file, &format!("{path}.at_dihedral[{i}].root_gap_mm"), gap)?;
        }
        let Some(wall) = self.preparation.thickness_mm().filter(|_| self.preparation.is_butt()) else { return Ok(()) };
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

    /// Checks that the rows by dihedral angle increase, all give the same quantities, and belong to an edge on a face.
    fn check_at_dihedral<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let Some(first) = self.at_dihedral.first() else { return Ok(()) };
        let is_cut = matches!(&self.preparation, Preparation::TBevel(p) if p.cut_deg.is_some());
        let takes_angle = !is_cut && self.preparation.is_t();
        if !self.preparation.is_t() || (first.angle_deg.is_some() && !takes_angle) {
            let message = Message::new("program-at-dihedral-without-edge");
            return Err(file.error_at(&format!("{path}.at_dihedral"), message, Message::new("program-edge-on-face")));
        }
        for (i, row) in self.at_dihedral.iter().enumerate() {
            let given = |row: &AtDihedral| (row.angle_deg.is_some(), row.root_gap_mm.is_some());
            if given(row) != given(first) || given(row) == (false, false) {
                let message = Message::new("program-at-dihedral-unequal");
                let allowed = Message::new("program-same-keys-in-rows");
                return Err(file.error_at(&format!("{path}.at_dihedral[{i}]"), message, allowed));
            }
            let before = i.checked_sub(1).map(|k| self.at_dihedral[k].dihedral_deg);
            if let Some(before) = before.filter(|before| row.dihedral_deg <= *before) {
                let allowed = Message::new("document-more-than").value("min", before.get(), Unit::Deg);
                let key = format!("{path}.at_dihedral[{i}].dihedral_deg");
                return Err(file.error_at(&key, Message::new("program-dihedrals-increase"), allowed));
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
            let Some([min, max]) = self.preparation.angle_range_deg(self.side) else {
                let allowed = Message::new("program-allowed-bevelled-kinds");
                return Err(file.error_at(&key, Message::new("program-fit-up-without-angle"), allowed));
            };
            let upright =
                angle.get() == 0.0 && min == 0.0 && self.preparation.with_groove_angle(self.side, 0.0).is_some();
            let is_between = min < angle.get() && angle.get() < max;
            if !upright && !is_between {
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

/// Kind of joint along a closed seam in a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RimJoint {
    /// A wall stands on the plate.
    #[default]
    Fillet,
    /// Both parts lie in one plane.
    Butt,
    /// The plate ends at the seam, and the wall goes on below it: an outside corner.
    Corner,
}
