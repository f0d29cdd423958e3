use crate::{Attitude, SeamCurve};
use glam::DAffine3;
use seamwright_geometry::Pose;
use seamwright_program::TorchPath;

/// The torch's path in one pass, in the machine's work frame.
#[derive(Debug)]
pub struct PassPath<'a> {
    /// The seam.
    pub seam: &'a SeamCurve,
    /// Torch angles.
    pub attitude: Attitude,
    /// The seam's frame in the work frame: work offset and placement.
    pub placement: DAffine3,
}

impl TorchPath for PassPath<'_> {
    fn length(&self) -> f64 {
        self.seam.weld_length()
    }

    fn pose(&self, s: f64) -> Pose {
        let p = self.seam.at(s);
        Pose {
            point: self.placement.transform_point3(p.point),
            direction: self.placement.transform_vector3(-self.attitude.torch_axis(&p)),
        }
    }

    fn knots(&self) -> Vec<f64> {
        self.attitude.knots(self.length())
    }
}
