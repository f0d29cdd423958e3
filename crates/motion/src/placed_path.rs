//! A torch path with its work moved and turned.

use crate::path_source::PathSource;
use glam::{DAffine3, DVec3};
use seamwright_geometry::Pose;
use seamwright_program::{Groove, ThroughPoints, TorchPath, WovenPath};

/// A torch path moved by a rigid displacement of the work, in the work frame.
pub(crate) struct PlacedPath<'a> {
    path: PathSource<'a>,
    by: DAffine3,
}

impl<'a> PlacedPath<'a> {
    pub(crate) fn new(path: &'a dyn TorchPath, by: DAffine3) -> Self {
        Self { path: PathSource::Lent(path), by }
    }

    fn path(&self) -> &dyn TorchPath {
        self.path.get()
    }

    fn pose_of(&self, pose: Pose) -> Pose {
        Pose { point: self.by.transform_point3(pose.point), direction: self.turned(pose.direction) }
    }

    fn turned(&self, direction: DVec3) -> DVec3 {
        self.by.transform_vector3(direction)
    }
}

impl TorchPath for PlacedPath<'_> {
    fn length(&self) -> f64 {
        self.path().length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.pose_of(self.path().pose(s))
    }

    fn rate(&self, s: f64) -> f64 {
        self.path().rate(s)
    }

    fn line_point(&self, s: f64) -> DVec3 {
        self.by.transform_point3(self.path().line_point(s))
    }

    fn line(&self, s: f64) -> (DVec3, DVec3) {
        let (point, tangent) = self.path().line(s);
        (self.by.transform_point3(point), self.turned(tangent))
    }

    fn knots(&self) -> Vec<f64> {
        self.path().knots()
    }

    fn bends(&self) -> Vec<f64> {
        self.path().bends()
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        let Groove { tangent, towards_first, face, dihedral } = self.path().groove(s)?;
        let [tangent, towards_first, face] = [tangent, towards_first, face].map(|v| self.turned(v));
        Some(Groove { tangent, towards_first, face, dihedral })
    }

    fn root(&self, s: f64) -> Option<DVec3> {
        self.path().root(s).map(|root| self.by.transform_point3(root))
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.path().second(s).map(|pose| self.pose_of(pose))
    }

    fn drawn_back(&self) -> f64 {
        self.path().drawn_back()
    }

    fn weave(&self) -> Option<&dyn WovenPath> {
        self.path().weave().map(|_| self as &dyn WovenPath)
    }

    fn points(&self) -> Option<&dyn ThroughPoints> {
        self.path().points()
    }
}

impl WovenPath for PlacedPath<'_> {
    fn swing(&self, s: f64) -> DVec3 {
        self.path().weave().map_or(DVec3::ZERO, |weave| self.turned(weave.swing(s)))
    }

    fn slower(&self, factor: f64) -> Box<dyn TorchPath + '_> {
        Box::new(PlacedPath { path: self.path.slower(factor), by: self.by })
    }
}
