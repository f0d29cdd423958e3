use glam::DVec3;

/// Error of shapes, meshes and scenes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ClearanceError {
    /// A size is not a finite number in its range.
    #[error("{what} of {value} mm is not possible here")]
    Size {
        /// Name of the size.
        what: &'static str,
        /// The value, mm.
        value: f64,
    },
    /// A pose scales, shears, mirrors or is not finite.
    #[error("the pose is not a rigid motion")]
    NotRigid,
    /// The bytes are not an STL file.
    #[error("this is not an STL file: {0}")]
    NotStl(String),
    /// The STL file ends too early.
    #[error("the STL file is cut short: {0}")]
    CutShort(String),
    /// A corner's coordinate is not a finite number.
    #[error("triangle {triangle} has a corner that is not a finite number")]
    NotFinite {
        /// Number of the triangle, from 1.
        triangle: usize,
    },
    /// A corner is too far from the origin.
    #[error("triangle {triangle} has a corner {farthest_mm:.3e} mm from the origin")]
    TooLarge {
        /// Number of the triangle, from 1.
        triangle: usize,
        /// Its largest coordinate, mm.
        farthest_mm: f64,
    },
    /// The mesh has no triangle with an area.
    #[error("the mesh has no triangles")]
    NoTriangles,
    /// The surface has holes or walls without thickness.
    #[error(
        "the surface is not closed: {edges} edges do not have exactly two triangles, one of them at \
         ({:.3}, {:.3}, {:.3}) mm", at.x, at.y, at.z
    )]
    Open {
        /// Number of edges that do not belong to exactly two triangles.
        edges: usize,
        /// Middle of the first of them, mm.
        at: DVec3,
    },
    /// A watch names a group that the scene does not have.
    #[error("watch {watch} names group {group}, which there is not")]
    NoSuchGroup {
        /// Index of the watch.
        watch: usize,
        /// Index of the group.
        group: usize,
    },
    /// A watch without a meaningful distance: a group that must be bounded has a half-space.
    #[error("watch {watch}: group `{group}` has a half-space, and needs an end here")]
    Endless {
        /// Index of the watch.
        watch: usize,
        /// Name of the group.
        group: String,
    },
    /// A permitted zone of an invalid shape.
    #[error("watch {watch}: a permitted zone is a box, a cylinder, a sphere or a half-space")]
    ZoneShape {
        /// Index of the watch.
        watch: usize,
    },
    /// A permitted-zone watch without a zone.
    #[error("watch {watch} has no permitted zone")]
    NoZone {
        /// Index of the watch.
        watch: usize,
    },
    /// An invalid minimum of a watch: a distance must be above 0 (overlapping bodies have 0), a margin finite.
    #[error("watch {watch}: the least distance of two groups must be greater than 0, and the least room finite")]
    Least {
        /// Index of the watch.
        watch: usize,
    },
    /// A limit of the sampling is not greater than 0.
    #[error("{what} must be greater than 0")]
    Limit {
        /// Name of the limit.
        what: &'static str,
    },
}
