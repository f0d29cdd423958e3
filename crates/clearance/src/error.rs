use glam::DVec3;
use seamwright_message::{Message, Unit, display_by_message};

/// Maximum extent of a shape from its origin, mm: 10 km.
pub(crate) const FARTHEST_MM: f64 = 1e7;

/// Error of shapes, meshes and scenes. Lengths are in mm.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum ClearanceError {
    /// The size of this name (a code) is not a finite number in its range.
    Size { what: &'static str, value: f64, max: f64 },
    /// A capsule is shorter than its two ends.
    ShortCapsule { length: f64, radius: f64 },
    /// A solid is too far from the origin of its group.
    TooFar { value: f64, max: f64 },
    /// A pose scales, shears, mirrors or is not finite.
    NotRigid,
    /// The bytes are not an STL file.
    NotStl(Message),
    /// The STL file ends too early.
    CutShort(Message),
    /// A corner's coordinate is not a finite number. Triangles count from 1.
    NotFinite { triangle: usize },
    /// A corner is too far from the origin.
    TooLarge { triangle: usize, farthest_mm: f64 },
    /// The mesh has no triangle with an area.
    NoTriangles,
    /// The surface has holes or walls without thickness: edges without exactly two triangles, the middle of the first `at`.
    Open { edges: usize, at: DVec3 },
    /// A watch names a group that the scene does not have; both by index.
    NoSuchGroup { watch: usize, group: usize },
    /// A watch without a meaningful distance: a group that must be bounded has a half-space.
    Endless { watch: usize, group: String },
    /// A permitted zone of an invalid shape.
    ZoneShape { watch: usize },
    /// A permitted-zone watch without a zone.
    NoZone { watch: usize },
    /// An invalid minimum of a watch: a distance must be above 0 (overlapping bodies have 0), a margin finite.
    Minimum { watch: usize },
    /// The limit of the sampling of this name (a code) is not greater than 0.
    Limit { what: &'static str },
}

display_by_message!(ClearanceError);

impl ClearanceError {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        let new = Message::new;
        let of_watch = |code, watch: usize| Message::new(code).text("watch", watch.to_string());
        let of_triangle = |code, triangle: usize| Message::new(code).text("triangle", triangle.to_string());
        match *self {
            Self::Size { what, value, max } => {
                let message = new("clearance-size").message("what", new(what)).value("value", value, Unit::Mm);
                message.value("max", max, Unit::Mm)
            }
            Self::ShortCapsule { length, radius } => {
                new("clearance-short-capsule").value("length", length, Unit::Mm).value("min", 2.0 * radius, Unit::Mm)
            }
            Self::TooFar { value, max } => {
                new("clearance-too-far").value("value", value, Unit::Mm).value("max", max, Unit::Mm)
            }
            Self::NotRigid => new("clearance-not-rigid"),
            Self::NotStl(ref why) => new("clearance-not-stl").message("why", why.clone()),
            Self::CutShort(ref why) => new("clearance-stl-cut-short").message("why", why.clone()),
            Self::NotFinite { triangle } => of_triangle("clearance-corner-not-finite", triangle),
            Self::TooLarge { triangle, farthest_mm } => {
                of_triangle("clearance-corner-too-far", triangle).text("distance", format!("{farthest_mm:.3e}"))
            }
            Self::NoTriangles => new("clearance-no-triangles"),
            Self::Open { edges, at } => {
                let at = format!("({:.3}, {:.3}, {:.3})", at.x, at.y, at.z);
                new("clearance-open-surface").count("edges", edges).text("point", at)
            }
            Self::NoSuchGroup { watch, group } => {
                of_watch("clearance-no-such-group", watch).text("group", group.to_string())
            }
            Self::Endless { watch, ref group } => of_watch("clearance-unbounded-group", watch).text("group", group),
            Self::ZoneShape { watch } => of_watch("clearance-zone-shape", watch),
            Self::NoZone { watch } => of_watch("clearance-no-zone", watch),
            Self::Minimum { watch } => of_watch("clearance-minimum", watch),
            Self::Limit { what } => new("clearance-limit").message("what", new(what)),
        }
    }
}
