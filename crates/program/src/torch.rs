use crate::path_range::PathRange;
use glam::DVec3;
use schemars::JsonSchema;
use seamwright_document::{Finite, NonNegative, Positive};
use seamwright_geometry::Pose;
use serde::{Deserialize, Serialize};

/// Torch angles along a pass. Give constant angles, or `at` several places between which they change smoothly.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Torch {
    /// Work angle as an offset from the faces' bisector, degrees: positive leans the torch towards the first part
    /// (the nozzle), negative towards the second (the body).
    #[serde(default)]
    pub work_angle_deg: Finite,
    /// Travel angle, degrees: positive is a drag angle (the torch leans forward, the wire points back), negative a
    /// push angle.
    #[serde(default)]
    pub travel_angle_deg: Finite,
    /// Angles at several path lengths, instead of the constant ones.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub at: Vec<TorchAt>,
    /// Stick-out, mm: wire between contact tip and arc. The torch is drawn back along its axis by what this is more than
    /// the machine's own, which it is if missing. The machine's file must have `stick_out_mm` in `[torch]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stick_out_mm: Option<Positive>,
    /// Search of angles for passes on which the torch comes too near to part or fixtures; no search if missing. A pass
    /// that is clear keeps its angles. In the plan's program the angles found stand in `at`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub search: Option<TorchSearch>,
}

impl Torch {
    /// Stick-out, mm: its own, or that of the `machine`.
    pub fn stick_out_or(&self, machine: Option<f64>) -> Option<f64> {
        self.stick_out_mm.map(Positive::get).or(machine)
    }
}

/// Limits of a search of torch angles. The windows of the procedure limit it too.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TorchSearch {
    /// Maximum change of the work angle in both senses, degrees.
    pub max_work_deg: NonNegative,
    /// Maximum change of the travel angle in both senses, degrees; the same all along a pass.
    pub max_travel_deg: NonNegative,
    /// Maximum stick-out, mm, tried in steps where no angles are clear; the stick-out stays if missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_stick_out_mm: Option<Positive>,
}

impl Default for TorchSearch {
    fn default() -> Self {
        let degrees = |value| NonNegative::new(value).unwrap_or_default();
        Self { max_work_deg: degrees(25.0), max_travel_deg: degrees(10.0), max_stick_out_mm: None }
    }
}

/// Torch angles at one path length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorchAt {
    /// Path length from the start of the weld, mm.
    pub s_mm: Finite,
    /// Work angle there, degrees.
    #[serde(default)]
    pub work_angle_deg: Finite,
    /// Travel angle there, degrees.
    #[serde(default)]
    pub travel_angle_deg: Finite,
}

/// The joint at one station, in the work frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groove {
    /// Unit tangent in the direction of welding.
    pub tangent: DVec3,
    /// Unit vector across the bisector of the faces, normal to the seam, towards the first part.
    pub towards_first: DVec3,
    /// Unit vector from the root out to the face of the weld, along the bisector.
    pub face: DVec3,
    /// Angle between the faces seen from the torch, rad.
    pub dihedral: f64,
}

impl Groove {
    /// Sines of the angles of the unit vector `direction` to the faces of the first and of the second part: positive
    /// between them, in the air.
    pub fn off_faces(&self, direction: DVec3) -> [f64; 2] {
        let (sin, cos) = (0.5 * self.dihedral).sin_cos();
        [1.0, -1.0].map(|side: f64| direction.dot(sin * self.face - side * cos * self.towards_first))
    }
}

/// Maximum number of axes of a machine.
pub const MAX_AXES: usize = 12;
/// Positions of a machine's axes in its file's order, mm or rad; 0 beyond the last one.
pub type AxisPositions = [f64; MAX_AXES];

/// A path of the torch in the work frame by path length: the view of a pass for the crates of machines and time.
///
/// Every path has a length and poses. The other methods have defaults for a plain line; [`TorchPath::groove`],
/// [`TorchPath::second`], [`TorchPath::weave`] and [`TorchPath::points`] return `None` without that capability.
/// `face`, `axes` and `foot` follow from the others and are not overridden.
pub trait TorchPath: Sync {
    /// Length, mm: `s` runs from 0 to this.
    fn length(&self) -> f64;

    /// The torch tip and the direction in which wire or beam points (from the torch to the work) at path length `s`;
    /// continuous, and smooth between knots.
    fn pose(&self, s: f64) -> Pose;

    /// Way of the tip by path length at `s`, without its weave: exactly 1 if the tip is on the line whose length `s`
    /// counts, different beside it. At a knot any value between those on either side.
    fn rate(&self, _s: f64) -> f64 {
        1.0
    }

    /// Point at path length `s` of the line on which the tip moves, or about which it weaves.
    fn line_point(&self, s: f64) -> DVec3 {
        let tip = self.pose(s).ahead(self.drawn_back()).point;
        tip - self.weave().map_or(DVec3::ZERO, |weave| weave.swing(s))
    }

    /// The same point, and the unit tangent of that line.
    fn line(&self, s: f64) -> (DVec3, DVec3) {
        line_by_difference(|s| self.line_point(s), s, self.length())
    }

    /// Path lengths inside the path where a derivative may jump, increasing.
    fn knots(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Knots at which the first or the second derivative may jump: elsewhere no axis has to stop.
    fn bends(&self) -> Vec<f64> {
        self.knots()
    }

    /// The joint at path length `s`, if its faces are known; without them there are no work angles.
    fn groove(&self, _s: f64) -> Option<Groove> {
        None
    }

    /// Root of the joint at path length `s`, in the work frame, if its cross-section is known.
    fn root(&self, _s: f64) -> Option<DVec3> {
        None
    }

    /// Tip and direction of a second torch that welds at the same time, at path length `s` of the first.
    fn second(&self, _s: f64) -> Option<Pose> {
        None
    }

    /// Distance of the machine's torch tip behind the arc along the torch's axis, mm: what the stick-out is more than
    /// the machine's. [`pose`](Self::pose) is the machine's tip, the line that of the arc.
    fn drawn_back(&self) -> f64 {
        0.0
    }

    /// The weave of the tip about the path's line.
    fn weave(&self) -> Option<&dyn WovenPath> {
        None
    }

    /// The points through which the path is given, with their times.
    fn points(&self) -> Option<&dyn ThroughPoints> {
        None
    }

    /// Unit vector from the root of the joint out to its face at path length `s`: it points up for a weld in the flat
    /// position (ISO 6947). Without a known joint the opposite of the torch's direction.
    fn face(&self, s: f64) -> DVec3 {
        self.groove(s).map_or_else(|| -self.pose(s).direction, |groove| groove.face)
    }

    /// Positions of the axes at path length `s`, of a path that is given by them.
    fn axes(&self, s: f64) -> Option<AxisPositions> {
        self.points()?.axes(s)
    }

    /// Path length in the range `within` of the path's point nearest to `point`, which must lie near the path at path
    /// length `guess`. Makes two Newton steps on the foot of the perpendicular. With a weave, the swing at `guess` is
    /// subtracted from `point`, and the foot is on the line.
    fn foot(&self, point: DVec3, guess: f64, within: PathRange) -> f64 {
        let point = point - self.weave().map_or(DVec3::ZERO, |weave| weave.swing(guess));
        (0..2).fold(guess, |s, _| {
            let ((centre, tangent), rate) = (self.line(s), self.rate(s));
            let along = (point - centre).dot(tangent) / rate;
            if rate > STILL { (s + along).clamp(within.from_mm, within.to_mm) } else { s }
        })
    }
}

/// A path whose tip weaves.
pub trait WovenPath: Sync {
    /// Offset of the tip from its line at path length `s`, as a vector.
    fn swing(&self, s: f64) -> DVec3;

    /// The same path with its weave slowed down to `factor` times its speed, below 1; 0 removes the weave.
    fn slower(&self, factor: f64) -> Box<dyn TorchPath + '_>;
}

/// A path through points. Its `s` counts planned time and not the tip's way: speeds along it are those by `s`, for any
/// motion of the tip.
pub trait ThroughPoints {
    /// Path length at which this many points are reached.
    fn reached(&self, points: usize) -> Option<f64>;

    /// Path lengths at which the torch stops.
    fn stops(&self) -> Vec<f64>;

    /// Positions of the axes at path length `s`, if the points are given by them.
    fn axes(&self, s: f64) -> Option<AxisPositions>;
}

/// A tip that moves less than this by path length stands still.
const STILL: f64 = 1e-6;

/// Point of the path `tip` at `s` and its unit tangent, by a difference of 1e-3 mm to each side: small against any bend
/// that can be welded.
pub fn line_by_difference(tip: impl Fn(f64) -> DVec3, s: f64, length: f64) -> (DVec3, DVec3) {
    let h = 1e-3_f64.min(0.25 * length);
    let (behind, ahead) = ((s - h).max(0.0), (s + h).min(length));
    (tip(s), (tip(ahead) - tip(behind)).normalize())
}
