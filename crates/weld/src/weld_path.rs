use crate::pass_path::PassPath;
use crate::points::PointPath;
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_program::{AxisPositions, Groove, PathRange, TorchPath};

/// The path of a pass: along the seam, or through points.
#[derive(Debug)]
pub enum WeldPath<'a> {
    /// Along the seam.
    Seam(Box<PassPath<'a>>),
    /// Through points.
    Points(&'a PointPath),
}

impl<'a> WeldPath<'a> {
    /// The path along the seam, if it is one.
    pub fn along_seam(&self) -> Option<&PassPath<'a>> {
        match self {
            Self::Seam(path) => Some(path),
            Self::Points(_) => None,
        }
    }

    fn path(&self) -> &dyn TorchPath {
        match self {
            Self::Seam(path) => &**path,
            Self::Points(points) => *points,
        }
    }
}

/// Every method is that of the path inside: also those with a default in the trait.
impl TorchPath for WeldPath<'_> {
    fn length(&self) -> f64 {
        self.path().length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.path().pose(s)
    }

    fn rate(&self, s: f64) -> f64 {
        self.path().rate(s)
    }

    fn is_timed(&self) -> bool {
        self.path().is_timed()
    }

    fn reached(&self, points: usize) -> Option<f64> {
        self.path().reached(points)
    }

    fn stops(&self) -> Vec<f64> {
        self.path().stops()
    }

    fn axes(&self, s: f64) -> Option<AxisPositions> {
        self.path().axes(s)
    }

    fn face(&self, s: f64) -> DVec3 {
        self.path().face(s)
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        self.path().groove(s)
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.path().second(s)
    }

    fn swing(&self, s: f64) -> Option<DVec3> {
        self.path().swing(s)
    }

    fn slower(&self, factor: f64) -> Option<Box<dyn TorchPath + '_>> {
        self.path().slower(factor)
    }

    fn centre(&self, s: f64) -> DVec3 {
        self.path().centre(s)
    }

    fn tangent(&self, s: f64) -> DVec3 {
        self.path().tangent(s)
    }

    fn line(&self, s: f64) -> (DVec3, DVec3) {
        self.path().line(s)
    }

    fn foot(&self, point: DVec3, guess: f64, within: PathRange) -> f64 {
        self.path().foot(point, guess, within)
    }

    fn knots(&self) -> Vec<f64> {
        self.path().knots()
    }

    fn bends(&self) -> Vec<f64> {
        self.path().bends()
    }
}
