//! What is asked of a stripe, and what is answered.

use arrayvec::ArrayVec;
use glam::DVec2;
use serde::Serialize;
use thiserror::Error;

/// Joints that can be looked for, as a sensor sees them from above.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JointKind {
    /// Two faces at 60 to 120 degrees.
    Fillet,
    /// A V groove between two shoulders, with or without a root gap.
    V,
    /// The end of an upper sheet on a lower one.
    Lap,
    /// Two plates end to end, with or without a gap.
    Butt,
    /// A U groove: steep walls that end in arcs at the root.
    U,
    /// A J groove: one such side, the other one upright.
    J,
}

impl JointKind {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Fillet, Self::V, Self::Lap, Self::Butt, Self::U, Self::J];
}

/// Where the joint point should be, from a result before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// y and z, mm.
    pub at: DVec2,
    /// How far off is nothing unusual, mm.
    pub within: f64,
}

/// What is asked of a stripe. Lengths are in the unit of the profile: mm, or pixels without a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripeTask {
    /// The joint that should be there.
    pub joint: JointKind,
    /// A smaller step is the mismatch of a butt joint, a greater one that of a lap joint.
    pub least_step: f64,
    /// Thickness of a lap joint's upper sheet; its gap is known only with it.
    pub thickness: Option<f64>,
    /// Where the joint should be.
    pub expected: Option<Expected>,
}

impl StripeTask {
    /// The joint in mm: steps below 1 mm are mismatch.
    #[must_use]
    pub fn in_mm(joint: JointKind) -> Self {
        Self { joint, least_step: 1.0, thickness: None, expected: None }
    }

    /// The joint in pixels: steps below 20 pixels are mismatch.
    #[must_use]
    pub fn in_pixels(joint: JointKind) -> Self {
        Self { least_step: 20.0, ..Self::in_mm(joint) }
    }

    /// The same with the upper sheet's thickness; steps below half of it are mismatch.
    #[must_use]
    pub fn with_thickness(self, thickness: f64) -> Self {
        Self { thickness: Some(thickness), least_step: 0.5 * thickness, ..self }
    }
}

/// Places of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Feature {
    /// What the torch goes for: the corner of a fillet, the middle of the root of a groove, the foot of a lap joint's
    /// end, the middle of a butt joint's gap.
    Joint,
    /// Where the left plate's surface ends at the groove, the gap or the step.
    LeftEdge,
    /// The same of the right plate.
    RightEdge,
    /// Root of a groove's left side.
    LeftRoot,
    /// Root of its right side.
    RightRoot,
    /// End of a lap joint's upper sheet.
    UpperEdge,
}

impl Feature {
    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Joint => "joint",
            Self::LeftEdge => "left_edge",
            Self::RightEdge => "right_edge",
            Self::LeftRoot => "left_root",
            Self::RightRoot => "right_root",
            Self::UpperEdge => "upper_edge",
        }
    }
}

/// Lengths, areas and angles of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Root gap; of a lap joint the distance between the sheets, of a fillet that of the web's end from the other face.
    Gap,
    /// Height of the right plate's surface over the left one's.
    Mismatch,
    /// Cross-section of the groove below the line between its edges.
    Area,
    /// Angle between the faces of a fillet, the walls of a V groove, a U or J groove's wall and the upright, rad.
    Angle,
    /// Turn from the left plate's surface to the right one's, rad; positive if they make a valley.
    Bend,
    /// Distance of a groove's edges.
    Width,
    /// Depth of a groove's root below the line between its edges.
    Depth,
    /// Height of a lap joint's upper surface over the lower one.
    Height,
    /// Radius of a U or J groove's arcs.
    Radius,
}

impl Quantity {
    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gap => "gap",
            Self::Mismatch => "mismatch",
            Self::Area => "area",
            Self::Angle => "angle",
            Self::Bend => "bend",
            Self::Width => "width",
            Self::Depth => "depth",
            Self::Height => "height",
            Self::Radius => "radius",
        }
    }

    /// Power of the unit of length that it has; none for angles.
    #[must_use]
    pub fn power(self) -> Option<u8> {
        match self {
            Self::Angle | Self::Bend => None,
            Self::Area => Some(2),
            _ => Some(1),
        }
    }
}

/// A joint that was found. Lengths in mm, or in pixels without a map; angles in rad.
#[derive(Debug, Clone, PartialEq)]
pub struct Features {
    /// The joint that was asked for.
    pub kind: JointKind,
    /// Its places, the joint point first: y and z.
    pub points: ArrayVec<(Feature, DVec2), 6>,
    /// What was measured of it.
    pub values: ArrayVec<(Quantity, f64), 8>,
    /// 0 to 1; from [`Features::CONFIDENT`] on it may be followed.
    pub confidence: f64,
    /// What takes most of the confidence, if that is too little to follow it.
    pub doubt: Option<Doubt>,
}

/// What takes confidence from a joint that was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Doubt {
    /// What is seen does not lie on the joint's lines, or something as bright lies beside them.
    #[error("much of what is seen is not on the joint's lines: reflections or spatter")]
    Clutter,
    /// A part of the joint is seen in few columns.
    #[error("a part of the joint is seen in fewer than 30 columns: move the sensor nearer or across the whole joint")]
    Short,
    /// A part of the joint is not straight.
    #[error("a part of the joint is not straight: its places are several rows off the line")]
    Uneven,
    /// The light on a part has holes, goes on beyond its end, or something hides the end.
    #[error(
        "the light does not begin and end where the joint's parts do: dark places on them, light beyond their ends, or \
         something that hides an end"
    )]
    Light,
    /// The shape is nearly that of another joint.
    #[error("the shape is at the limit of this kind of joint")]
    Shape,
    /// It is far from where it was before.
    #[error("it is far from where it was expected")]
    Moved,
    /// A place or value is no finite number.
    #[error("a place or a value of it is not known")]
    Unknown,
}

impl Features {
    /// Least confidence to follow what was found.
    pub const CONFIDENT: f64 = 0.5;

    /// A place.
    #[must_use]
    pub fn point(&self, feature: Feature) -> Option<DVec2> {
        self.points.iter().find(|p| p.0 == feature).map(|p| p.1)
    }

    /// The joint point.
    #[must_use]
    pub fn joint(&self) -> DVec2 {
        // Every joint puts it first.
        self.point(Feature::Joint).unwrap_or(DVec2::NAN)
    }

    /// A value.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> Option<f64> {
        self.values.iter().find(|v| v.0 == quantity).map(|v| v.1)
    }

    /// Whether it may be followed.
    #[must_use]
    pub fn is_confident(&self) -> bool {
        self.confidence >= Self::CONFIDENT
    }
}

/// Why there are no features.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum NoFeatures {
    /// No chain of bright places.
    #[error("there is no stripe")]
    NoStripe,
    /// Nearly all of the image is white.
    #[error("the image is saturated: shorter exposure or less light")]
    Saturated,
    /// The stripe is seen in too few columns.
    #[error("the stripe is seen in {found} of {columns} columns, a quarter is needed")]
    ShortStripe {
        /// Columns with it.
        found: usize,
        /// Columns of the image.
        columns: usize,
    },
    /// Too few places in a profile.
    #[error("the profile has {found} usable points, {needed} are needed")]
    TooFewPoints {
        /// Places there are.
        found: usize,
        /// Places there must be.
        needed: usize,
    },
    /// No two faces at 60 to 120 degrees that meet, or there is more than these.
    #[error("no corner of two faces at 60 to 120 degrees that make up the profile")]
    NoCorner,
    /// No walls between two shoulders as this groove has them.
    #[error("no groove of this kind between two shoulders")]
    NoGroove,
    /// No two parallel sheets with a step that is high enough.
    #[error("no step between two parallel sheets")]
    NoStep,
    /// No two plates in line with a gap, a mismatch or a dark line between them.
    #[error("no gap, mismatch or dark line between two plates in line")]
    NoSeam,
}
