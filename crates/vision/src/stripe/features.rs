//! Task and result of reading a stripe.

use arrayvec::ArrayVec;
use glam::DVec2;
use seamwright_message::{Message, display_by_message, named_enum};
use serde::Serialize;

/// Joint types that can be detected, as seen by a sensor from above.
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

/// Expected position of the joint point, from a previous result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// y and z, mm.
    pub at: DVec2,
    /// Normal deviation from it, mm.
    pub within: f64,
}

/// Task for reading a stripe. Lengths are in the unit of the profile: mm, or pixels without a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripeTask {
    /// The type of the joint.
    pub joint: JointKind,
    /// Limit between the mismatch of a butt joint (below) and the step of a lap joint (above).
    pub least_step: f64,
    /// Thickness of a lap joint's upper sheet; required to measure its gap.
    pub thickness: Option<f64>,
    /// Expected position of the joint.
    pub expected: Option<Expected>,
}

impl StripeTask {
    /// Creates a task in mm: steps below 1 mm are mismatch.
    #[must_use]
    pub fn in_mm(joint: JointKind) -> Self {
        Self { joint, least_step: 1.0, thickness: None, expected: None }
    }

    /// Creates a task in pixels: steps below 20 pixels are mismatch.
    #[must_use]
    pub fn in_pixels(joint: JointKind) -> Self {
        Self { least_step: 20.0, ..Self::in_mm(joint) }
    }

    /// Sets the upper sheet's thickness; steps below half of it are mismatch.
    #[must_use]
    pub fn with_thickness(self, thickness: f64) -> Self {
        Self { thickness: Some(thickness), least_step: 0.5 * thickness, ..self }
    }
}

named_enum! {
    /// Feature points of a joint.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Feature {
        /// Target of the torch: a fillet's corner, the middle of a groove's root or butt joint's gap, or the foot of a lap
        /// joint's upper edge.
        Joint => "joint",
        /// End of the left plate's surface at the groove, the gap or the step.
        LeftEdge => "left_edge",
        /// End of the right plate's surface.
        RightEdge => "right_edge",
        /// Root of a groove's left side.
        LeftRoot => "left_root",
        /// Root of a groove's right side.
        RightRoot => "right_root",
        /// End of a lap joint's upper sheet.
        UpperEdge => "upper_edge",
    }
}

named_enum! {
    /// Measured lengths, areas and angles of a joint.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Quantity {
        /// Root gap; for a lap joint the distance between the sheets, for a fillet the distance of the web's end from the
        /// other face.
        Gap => "gap",
        /// Height of the right plate's surface above the left one's.
        Mismatch => "mismatch",
        /// Cross-section of the groove below the line between its edges.
        Area => "area",
        /// Angle between a fillet's faces, a V groove's walls, or a U or J groove's wall and the upright, rad.
        Angle => "angle",
        /// Turn from the left plate's surface to the right one's, rad; positive if they make a valley.
        Bend => "bend",
        /// Distance between a groove's edges.
        Width => "width",
        /// Depth of a groove's root below the line between its edges.
        Depth => "depth",
        /// Height of a lap joint's upper surface above the lower one.
        Height => "height",
        /// Radius of a U or J groove's arcs.
        Radius => "radius",
    }
}

impl Quantity {
    /// Returns the power of its unit of length; `None` for angles.
    #[must_use]
    pub fn power(self) -> Option<u8> {
        match self {
            Self::Angle | Self::Bend => None,
            Self::Area => Some(2),
            _ => Some(1),
        }
    }
}

/// A detected joint. Lengths are in mm, or in pixels without a map; angles in rad.
#[derive(Debug, Clone, PartialEq)]
pub struct Features {
    /// The type of joint that was searched.
    pub kind: JointKind,
    /// Feature points (y, z), the joint point first.
    pub points: ArrayVec<(Feature, DVec2), 6>,
    /// Measured quantities.
    pub values: ArrayVec<(Quantity, f64), 8>,
    /// Confidence, 0 to 1; see [`Features::CONFIDENT`].
    pub confidence: f64,
    /// Main reason for a confidence below [`Features::CONFIDENT`].
    pub doubt: Option<Doubt>,
}

named_enum! {
    /// Reason for a low confidence of a detected joint.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Doubt {
        /// Points lie off the joint's lines, or something as bright lies beside them.
        Clutter: "vision-doubt-clutter",
        /// A part of the joint is visible in few columns only.
        Short: "vision-doubt-short",
        /// A part of the joint is not straight.
        Uneven: "vision-doubt-uneven",
        /// The light on a part has holes, continues beyond its end, or the end is hidden.
        Light: "vision-doubt-light",
        /// The shape is nearly that of another joint.
        Shape: "vision-doubt-shape",
        /// The joint is far from its expected position.
        Moved: "vision-doubt-moved",
        /// A point or value is not finite.
        Unknown: "vision-doubt-unknown",
    }
}

impl Features {
    /// Minimum confidence to follow a detected joint.
    pub const CONFIDENT: f64 = 0.5;

    /// Returns a feature point.
    #[must_use]
    pub fn point(&self, feature: Feature) -> Option<DVec2> {
        self.points.iter().find(|p| p.0 == feature).map(|p| p.1)
    }

    /// Returns the joint point.
    #[must_use]
    pub fn joint(&self) -> DVec2 {
        // Every joint type stores it first.
        self.point(Feature::Joint).unwrap_or(DVec2::NAN)
    }

    /// Returns a measured value.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> Option<f64> {
        self.values.iter().find(|v| v.0 == quantity).map(|v| v.1)
    }

    /// Returns true if the joint may be followed.
    #[must_use]
    pub fn is_confident(&self) -> bool {
        self.confidence >= Self::CONFIDENT
    }
}

/// Reason why no joint was detected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoFeatures {
    /// No chain of bright points.
    NoStripe,
    /// More than half of the image's background is saturated.
    Saturated,
    /// The stripe is visible in too few columns.
    ShortStripe {
        /// Columns with the stripe.
        found: usize,
        /// Columns of the image.
        columns: usize,
    },
    /// Too few points in a profile.
    TooFewPoints {
        /// Usable points.
        found: usize,
        /// Required points.
        needed: usize,
    },
    /// No two faces at 60 to 120 degrees that meet, or the profile has more than these.
    NoCorner,
    /// No walls of this groove type between two shoulders.
    NoGroove,
    /// No two parallel sheets with a high enough step.
    NoStep,
    /// No two plates in line with a gap, a mismatch or a dark line between them.
    NoSeam,
}

impl NoFeatures {
    /// Returns the description of the reason.
    pub fn message(&self) -> Message {
        let new = Message::new;
        match *self {
            Self::NoStripe => new("vision-no-stripe"),
            Self::Saturated => new("vision-saturated"),
            Self::ShortStripe { found, columns } => {
                new("vision-short-stripe").count("found", found).count("columns", columns)
            }
            Self::TooFewPoints { found, needed } => {
                new("vision-too-few-points").count("found", found).count("needed", needed)
            }
            Self::NoCorner => new("vision-no-corner"),
            Self::NoGroove => new("vision-no-groove"),
            Self::NoStep => new("vision-no-step"),
            Self::NoSeam => new("vision-no-seam"),
        }
    }
}

display_by_message!(Doubt, NoFeatures);
