use crate::pass_path::PassPath;
use crate::points::PointPath;
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_program::{Groove, ThroughPoints, TorchPath, WovenPath};

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

    fn line_point(&self, s: f64) -> DVec3 {
        self.path().line_point(s)
    }

    fn line(&self, s: f64) -> (DVec3, DVec3) {
        self.path().line(s)
    }

    fn knots(&self) -> Vec<f64> {
        self.path().knots()
    }

    fn bends(&self) -> Vec<f64> {
        self.path().bends()
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        self.path().groove(s)
    }

    fn root(&self, s: f64) -> Option<DVec3> {
        self.path().root(s)
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.path().second(s)
    }

    fn drawn_back(&self) -> f64 {
        self.path().drawn_back()
    }

    fn weave(&self) -> Option<&dyn WovenPath> {
        self.path().weave()
    }

    fn points(&self) -> Option<&dyn ThroughPoints> {
        self.path().points()
    }
}
