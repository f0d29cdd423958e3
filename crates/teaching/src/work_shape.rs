use glam::{DAffine3, DVec2, DVec3};
use seamwright_vision::camera::{HeightError, HeightTable};

/// A point of the work's surface and its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Point, mm.
    pub point: DVec3,
    /// Unit normal, out of the work.
    pub normal: DVec3,
}

/// Surface known before any measurement: the nominal part at its nominal pose, in the work frame.
pub trait Shape {
    /// Returns the surface near `point`; `None` where it is unknown.
    fn near(&self, point: DVec3) -> Option<Patch>;
}

/// Unknown shape: the surface continues as last measured.
impl Shape for () {
    fn near(&self, _point: DVec3) -> Option<Patch> {
        None
    }
}

/// Camera pose of a frame, and the height of the work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The camera's frame in the work frame: x to the right in the picture, y down, z away from the camera.
    pub camera: DAffine3,
    /// Height of the work on the optical axis, mm in the camera's frame, if focus or a stripe measured it.
    pub height: Option<f64>,
}

/// Start of the midline search in a frame, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aim {
    /// Start position.
    pub start: DVec2,
    /// Unit direction of the midline, x right, y down.
    pub direction: DVec2,
    /// The operator gave the start, with an accuracy of about a millimetre.
    pub by_hand: bool,
}

/// A point of the midline detected in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Position, pixels.
    pub px: DVec2,
    /// 0 to 1.
    pub confidence: f64,
    /// Detected instead of extrapolated.
    pub seen: bool,
}

/// Reason for the end of a midline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameEnd {
    /// At the picture's edge.
    LeftImage,
    /// The joint ends.
    JointEnd,
    /// The joint returns to its start, in this frame.
    Closed,
    /// The joint is no longer visible.
    Lost,
}

/// Maximum number of Newton steps along a ray; two suffice near a surface.
const STEPS: usize = 4;

/// Surface shown by a frame: nominal shape or a plane, raised to the measured height.
pub(super) struct Surface<'a> {
    table: &'a HeightTable,
    shape: &'a dyn Shape,
    camera: DAffine3,
    /// Height on the optical axis, mm.
    height: f64,
    /// Plane used where the shape is unknown.
    plane: Patch,
    /// Height of the measured surface above the shape, mm.
    raised: f64,
}

impl<'a> Surface<'a> {
    /// Creates the surface in `view` near `expected`, its expected point and normal.
    pub(super) fn new(table: &'a HeightTable, shape: &'a dyn Shape, view: &View, expected: Patch) -> Self {
        let camera = view.camera;
        let axis = camera.transform_vector3(DVec3::Z);
        let expected = shape.near(expected.point).map_or(expected, |patch| Patch { normal: patch.normal, ..expected });
        // Without a measurement: the intersection of the optical axis with the expected surface.
        let slope = axis.dot(expected.normal);
        let assumed = (expected.point - camera.translation).dot(expected.normal) / slope;
        let height = view.height.unwrap_or(assumed);
        let at = camera.transform_point3(DVec3::Z * height);
        let raised = shape.near(at).map_or(0.0, |patch| (at - patch.point).dot(patch.normal));
        Self { table, shape, camera, height, plane: Patch { point: at, ..expected }, raised }
    }

    /// Returns the intersection of the optical axis with the surface.
    pub(super) fn on_axis(&self) -> DVec3 {
        self.camera.transform_point3(DVec3::Z * self.height)
    }

    /// Returns the height of the surface above the shape, mm.
    pub(super) fn raised(&self) -> f64 {
        self.raised
    }

    pub(super) fn normal(&self, point: DVec3) -> DVec3 {
        self.shape.near(point).map_or(self.plane.normal, |patch| patch.normal)
    }

    /// Returns the distance of a point from the surface along its normal, and that normal.
    fn above(&self, point: DVec3) -> (f64, DVec3) {
        match self.shape.near(point) {
            Some(patch) => ((point - patch.point).dot(patch.normal) - self.raised, patch.normal),
            None => ((point - self.plane.point).dot(self.plane.normal), self.plane.normal),
        }
    }

    /// Returns the surface point seen in a pixel, and the unit viewing direction.
    pub(super) fn point(&self, px: DVec2) -> Result<(DVec3, DVec3), HeightError> {
        let axis = self.camera.transform_vector3(DVec3::Z);
        let mut height = self.height;
        let mut point = self.camera.transform_point3(self.table.to_point(px, height)?);
        for _ in 0..STEPS {
            let (above, normal) = self.above(point);
            height -= above / axis.dot(normal).min(-0.2);
            point = self.camera.transform_point3(self.table.to_point(px, height)?);
            if above.abs() < 1e-7 {
                break;
            }
        }
        let (low, high) = self.table.range();
        let nearer = if height - 1.0 < low { (height + 1.0).min(high) } else { height - 1.0 };
        let before = self.camera.transform_point3(self.table.to_point(px, nearer)?);
        let ray = (point - before) * (height - nearer).signum();
        Ok((point, ray.try_normalize().unwrap_or(axis)))
    }

    pub(super) fn px(&self, point: DVec3) -> Result<DVec2, HeightError> {
        self.table.to_px(self.camera.inverse().transform_point3(point))
    }

    /// Returns whether a pixel is in the frame, at least `margin` pixels from its edge.
    pub(super) fn in_frame(&self, px: DVec2, margin: f64) -> bool {
        let (width, height) = self.table.size_px();
        let inside = |v: f64, size: usize| v >= margin && v <= size as f64 - 1.0 - margin;
        inside(px.x, width) && inside(px.y, height)
    }
}
