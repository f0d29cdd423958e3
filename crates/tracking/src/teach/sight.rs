use glam::{DAffine3, DVec2, DVec3};
use seamwright_vision::camera::{HeightError, HeightTable};

/// A place of the work's surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// A point of it, mm.
    pub point: DVec3,
    /// Unit normal, out of the work.
    pub normal: DVec3,
}

/// What is known of the surface before it is seen: the nominal part, where it is nominally. In the work frame.
pub trait Shape {
    /// The surface near `point`; none where nothing is known.
    fn near(&self, point: DVec3) -> Option<Patch>;
}

/// Nothing is known: the surface goes on as it was seen last.
impl Shape for () {
    fn near(&self, _point: DVec3) -> Option<Patch> {
        None
    }
}

/// From where a frame was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The camera's frame in the work frame: x to the right in the picture, y down, z away from the camera.
    pub camera: DAffine3,
    /// Height of the work on the optical axis, mm in the camera's frame, if focus or a stripe measured it.
    pub height: Option<f64>,
}

/// Where the midline of a frame is to be looked for, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aim {
    /// Where it begins.
    pub start: DVec2,
    /// Unit direction in which it goes, x right, y down.
    pub direction: DVec2,
    /// Somebody has said where it starts: a hand is right to a millimetre or so.
    pub by_hand: bool,
}

/// A place on the midline that was found in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Pixels.
    pub px: DVec2,
    /// 0 to 1.
    pub confidence: f64,
    /// Seen, and not only coasted over.
    pub seen: bool,
}

/// Why a midline ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameEnd {
    /// At the picture's rim.
    LeftImage,
    /// The joint ends.
    JointEnd,
    /// It comes back to where it began, in this frame.
    Closed,
    /// It is seen no longer.
    Lost,
}

/// Steps of Newton's method along a ray: what is near a surface is on it after two.
const STEPS: usize = 4;

/// The surface that a frame shows: nominal shape or a plane, raised to where the height was measured.
pub(super) struct Surface<'a> {
    table: &'a HeightTable,
    shape: &'a dyn Shape,
    camera: DAffine3,
    /// Height on the optical axis, mm.
    height: f64,
    /// The plane that it is where no shape is known.
    plane: Patch,
    /// How far the measured surface lies above the shape.
    raised: f64,
}

impl<'a> Surface<'a> {
    /// The surface in `view`, about `expected`: a place where it should be and its normal.
    pub(super) fn new(table: &'a HeightTable, shape: &'a dyn Shape, view: &View, expected: Patch) -> Self {
        let camera = view.camera;
        let axis = camera.transform_vector3(DVec3::Z);
        let expected = shape.near(expected.point).map_or(expected, |patch| Patch { normal: patch.normal, ..expected });
        // Where the optical axis meets the expected surface, if nothing was measured.
        let slope = axis.dot(expected.normal);
        let assumed = (expected.point - camera.translation).dot(expected.normal) / slope;
        let height = view.height.unwrap_or(assumed);
        let at = camera.transform_point3(DVec3::Z * height);
        let raised = shape.near(at).map_or(0.0, |patch| (at - patch.point).dot(patch.normal));
        Self { table, shape, camera, height, plane: Patch { point: at, ..expected }, raised }
    }

    /// Where the optical axis meets it.
    pub(super) fn on_axis(&self) -> DVec3 {
        self.camera.transform_point3(DVec3::Z * self.height)
    }

    /// How far it lies above the shape.
    pub(super) fn raised(&self) -> f64 {
        self.raised
    }

    /// The normal near a point.
    pub(super) fn normal(&self, point: DVec3) -> DVec3 {
        self.shape.near(point).map_or(self.plane.normal, |patch| patch.normal)
    }

    /// Distance of a point from the surface, along its normal.
    fn above(&self, point: DVec3) -> (f64, DVec3) {
        match self.shape.near(point) {
            Some(patch) => ((point - patch.point).dot(patch.normal) - self.raised, patch.normal),
            None => ((point - self.plane.point).dot(self.plane.normal), self.plane.normal),
        }
    }

    /// The point at which a pixel looks, and the unit direction in which it does.
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

    /// The pixel in which a point is seen.
    pub(super) fn px(&self, point: DVec3) -> Result<DVec2, HeightError> {
        self.table.to_px(self.camera.inverse().transform_point3(point))
    }

    /// Whether a pixel is in the frame, `margin` pixels from its rim.
    pub(super) fn in_frame(&self, px: DVec2, margin: f64) -> bool {
        let (width, height) = self.table.size_px();
        let inside = |v: f64, size: usize| v >= margin && v <= size as f64 - 1.0 - margin;
        inside(px.x, width) && inside(px.y, height)
    }
}
