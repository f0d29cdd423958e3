use glam::DVec3;
use seamwright_message::{Message, Unit, display_by_message};

/// Maximum extent of a shape from its origin, mm: 10 km.
pub(crate) const FARTHEST_MM: f64 = 1e7;

/// Error of shapes, meshes and scenes.
#[derive(Debug, Clone, PartialEq)]
pub enum ClearanceError {
    /// A size is not a finite number in its range.
    Size {
        /// Code of the size's name.
        what: &'static str,
        /// The value, mm.
        value: f64,
        /// Maximum, mm.
        max: f64,
    },
    /// A capsule is shorter than its two ends.
    ShortCapsule {
        /// Its length, mm.
        length: f64,
        /// Its radius, mm.
        radius: f64,
    },
    /// A solid is too far from the origin of its group.
    TooFar {
        /// Its largest coordinate, mm.
        value: f64,
        /// Maximum, mm.
        max: f64,
    },
    /// A pose scales, shears, mirrors or is not finite.
    NotRigid,
    /// The bytes are not an STL file.
    NotStl(Message),
    /// The STL file ends too early.
    CutShort(Message),
    /// A corner's coordinate is not a finite number.
    NotFinite {
        /// Number of the triangle, from 1.
        triangle: usize,
    },
    /// A corner is too far from the origin.
    TooLarge {
        /// Number of the triangle, from 1.
        triangle: usize,
        /// Its largest coordinate, mm.
        farthest_mm: f64,
    },
    /// The mesh has no triangle with an area.
    NoTriangles,
    /// The surface has holes or walls without thickness.
    Open {
        /// Number of edges that do not belong to exactly two triangles.
        edges: usize,
        /// Middle of the first of them, mm.
        at: DVec3,
    },
    /// A watch names a group that the scene does not have.
    NoSuchGroup {
        /// Index of the watch.
        watch: usize,
        /// Index of the group.
        group: usize,
    },
    /// A watch without a meaningful distance: a group that must be bounded has a half-space.
    Endless {
        /// Index of the watch.
        watch: usize,
        /// Name of the group.
        group: String,
    },
    /// A permitted zone of an invalid shape.
    ZoneShape {
        /// Index of the watch.
        watch: usize,
    },
    /// A permitted-zone watch without a zone.
    NoZone {
        /// Index of the watch.
        watch: usize,
    },
    /// An invalid minimum of a watch: a distance must be above 0 (overlapping bodies have 0), a margin finite.
    Minimum {
        /// Index of the watch.
        watch: usize,
    },
    /// A limit of the sampling is not greater than 0.
    Limit {
        /// Code of the limit's name.
        what: &'static str,
    },
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
