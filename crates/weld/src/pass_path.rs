use crate::{Attitude, SeamCurve, SeamPoint};
use glam::{DAffine3, DVec3};
use seamwright_geometry::Pose;
use seamwright_program::{Groove, TorchPath};

/// Knots nearer to each other are one, mm.
const NEAR_MM: f64 = 1e-6;

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

impl PassPath<'_> {
    /// The torch over a point of the seam.
    fn torch_at(&self, p: &SeamPoint) -> Pose {
        Pose {
            point: self.placement.transform_point3(p.point),
            direction: self.placement.transform_vector3(-self.attitude.torch_axis(p)),
        }
    }
}

impl TorchPath for PassPath<'_> {
    fn length(&self) -> f64 {
        self.seam.weld_length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.torch_at(&self.seam.at(s))
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.seam.across(&self.seam.at(s)).map(|p| self.torch_at(&p))
    }

    fn face(&self, s: f64) -> DVec3 {
        self.placement.transform_vector3(self.seam.at(s).bisector)
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        let p = self.seam.at(s);
        let [tangent, towards_first] = [p.tangent, p.towards_first].map(|v| self.placement.transform_vector3(v));
        Some(Groove { tangent, towards_first, dihedral: p.dihedral })
    }

    fn knots(&self) -> Vec<f64> {
        let mut knots = self.seam.knots();
        // A place of the attitude next to one of the seam is that one.
        let apart = |s: &f64| knots.iter().all(|knot| (knot - s).abs() > NEAR_MM);
        let more: Vec<f64> = self.attitude.knots(self.length()).into_iter().filter(apart).collect();
        knots.extend(more);
        knots.sort_by(f64::total_cmp);
        knots
    }
}
