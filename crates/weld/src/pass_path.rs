use crate::attitude::Attitude;
use crate::bead_line::BesideSeam;
use crate::bead_path::BeadPath;
use crate::joint::SeamJoint;
use crate::seam::{SeamCurve, SeamPoint};
use crate::stretch::Stretch;
use glam::{DAffine3, DVec3};
use seamwright_geometry::Pose;
use seamwright_program::{Groove, TorchPath, Weaving, WovenPath, is_same_position, line_by_difference};

/// Half the way over which the tip's rate is a difference, mm: small against any bend that can be welded.
const HALF_MM: f64 = 1e-3;

/// The torch's path in one pass, in the machine's work frame. Its path length is that of the seam over which it runs,
/// counted from its start, also if the bead lies beside the seam.
#[derive(Debug)]
pub struct PassPath<'a> {
    /// The seam.
    pub seam: &'a SeamCurve,
    /// Its joint, if the file has one.
    pub joint: Option<&'a SeamJoint>,
    /// The part of it that the pass runs over, and which way.
    pub stretch: Stretch,
    /// Torch angles by the seam's path length.
    pub attitude: Attitude,
    /// Position of its beads beside the seam, if it has any.
    pub bead: Option<&'a BeadPath>,
    /// Weave of the torch about the bead's line, if any.
    pub weaving: Option<Weaving>,
    /// Distance of the machine's tip behind the arc, mm.
    pub drawn_back: f64,
    /// The frame of the pass' copy of the seam in the work frame: work offset and placement.
    pub placement: DAffine3,
}

impl PassPath<'_> {
    /// The point of the seam at the pass' path length `s`.
    pub fn seam_point(&self, s: f64) -> SeamPoint {
        self.seam.at(self.stretch.seam_s(s))
    }

    /// Work angle (offset from the bisector) and travel angle of the torch at path length `s`, rad.
    pub fn angles(&self, s: f64) -> (f64, f64) {
        let s = self.stretch.seam_s(s);
        let (work, travel) = self.attitude.angles(s);
        (work + self.beside(s).lean, travel)
    }

    /// The torch over a point of the seam, in the seam's frame: its tip, without a weave, and the unit vector from there
    /// to the torch.
    pub fn torch_at(&self, p: &SeamPoint) -> (DVec3, DVec3) {
        let beside = self.beside(p.s);
        (beside.over(p), self.attitude.leaning(p, beside.lean, self.stretch.sense))
    }

    /// The torch beside the seam at path length `s` of the seam, counted on from turn to turn.
    fn beside(&self, s: f64) -> BesideSeam {
        self.bead.map_or(BesideSeam::ON_SEAM, |bead| bead.at(self.stretch.own_s(s), s))
    }

    /// The torch tip over a point of the seam, in the seam's frame, without a weave, mm.
    fn tip_at(&self, p: &SeamPoint) -> DVec3 {
        self.beside(p.s).over(p)
    }

    /// Offset of the weaving tip from its line at path length `s`, mm: across towards the first part, and along in the
    /// direction of travel. `None` without a weave.
    pub fn woven(&self, s: f64) -> Option<(f64, f64)> {
        let (across, along) = self.weaving.as_ref()?.offset(s);
        let part = self.beside(self.stretch.seam_s(s)).weave_part;
        Some((part * across, part * along))
    }

    /// The same as a vector in the seam's frame: across in the plane square to the seam, which is square to the torch's
    /// `axis` but for the angle of the weave's plane; and along the seam.
    pub(crate) fn swing_at(&self, p: &SeamPoint, axis: DVec3, s: f64) -> DVec3 {
        let (Some(weaving), Some((across, along))) = (&self.weaving, self.woven(s)) else { return DVec3::ZERO };
        let aside = p.along.cross(axis).normalize();
        let aside = if aside.dot(p.towards_first) < 0.0 { -aside } else { aside };
        let (sin, cos) = weaving.plane().sin_cos();
        across * (cos * aside + sin * axis) + along * self.stretch.sense * p.along
    }

    /// The machine's tip of the woven torch over a point of the seam as a pose in the work frame.
    fn placed(&self, p: &SeamPoint, s: f64) -> Pose {
        let (tip, axis) = self.torch_at(p);
        let tip = tip + self.swing_at(p, axis, s) + self.drawn_back * axis;
        Pose { point: self.placement.transform_point3(tip), direction: self.placement.transform_vector3(-axis) }
    }
}

impl TorchPath for PassPath<'_> {
    fn length(&self) -> f64 {
        self.stretch.length
    }

    fn pose(&self, s: f64) -> Pose {
        self.placed(&self.seam_point(s), s)
    }

    /// Without the attitude, which it does not depend on.
    fn line_point(&self, s: f64) -> DVec3 {
        let p = self.seam_point(s);
        self.placement.transform_point3(self.tip_at(&p))
    }

    fn line(&self, s: f64) -> (DVec3, DVec3) {
        if self.bead.is_some() {
            return line_by_difference(|s| self.line_point(s), s, self.length());
        }
        let p = self.seam_point(s);
        (self.placement.transform_point3(p.point), self.placement.transform_vector3(self.stretch.sense * p.tangent))
    }

    fn rate(&self, s: f64) -> f64 {
        if self.bead.is_none() {
            return 1.0;
        }
        let (behind, ahead) = ((s - HALF_MM).max(0.0), (s + HALF_MM).min(self.length()));
        let tip = |s: f64| self.tip_at(&self.seam_point(s));
        (tip(ahead) - tip(behind)).length() / (ahead - behind)
    }

    fn root(&self, s: f64) -> Option<DVec3> {
        let p = self.seam_point(s);
        let root = self.joint?.section(&p)?.root();
        Some(self.placement.transform_point3(p.point + root.x * p.towards_first + root.y * p.bisector))
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.seam.across(&self.seam_point(s)).map(|p| self.placed(&p, s))
    }

    fn drawn_back(&self) -> f64 {
        self.drawn_back
    }

    fn weave(&self) -> Option<&dyn WovenPath> {
        self.weaving.as_ref().map(|_| self as &dyn WovenPath)
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        let p = self.seam_point(s);
        let [tangent, towards_first, face] =
            [self.stretch.sense * p.tangent, p.towards_first, p.bisector].map(|v| self.placement.transform_vector3(v));
        Some(Groove { tangent, towards_first, face, dihedral: p.dihedral })
    }

    fn knots(&self) -> Vec<f64> {
        self.with_weave(Weaving::knots)
    }

    fn bends(&self) -> Vec<f64> {
        self.with_weave(Weaving::bends)
    }
}

impl WovenPath for PassPath<'_> {
    fn swing(&self, s: f64) -> DVec3 {
        let p = self.seam_point(s);
        let (_, axis) = self.torch_at(&p);
        self.placement.transform_vector3(self.swing_at(&p, axis, s))
    }

    fn slower(&self, factor: f64) -> Box<dyn TorchPath + '_> {
        let weaving = self.weaving.as_ref().filter(|_| factor > 0.0).map(|weaving| weaving.faster(factor));
        Box::new(PassPath { attitude: self.attitude.clone(), weaving, ..*self })
    }
}

impl PassPath<'_> {
    /// Positions at which a derivative of seam, torch attitude or bead may jump, with those of the weave.
    fn with_weave(&self, of: impl Fn(&Weaving) -> Vec<f64>) -> Vec<f64> {
        let range = self.stretch.range();
        let mut knots = self.seam.knots_within(range);
        knots.sort_by(f64::total_cmp);
        let of_seam = knots.len();
        // A position of the torch attitude or of the bead next to one of the seam counts as that one.
        let more =
            [self.attitude.knots_within(range), self.bead.map_or(Vec::new(), |bead| bead.knots_within(&self.stretch))];
        for place in more.into_iter().flatten() {
            let next = knots[..of_seam].partition_point(|knot| *knot < place);
            if knots[next.saturating_sub(1)..of_seam.min(next + 1)].iter().all(|knot| !is_same_position(*knot, place)) {
                knots.push(place);
            }
        }
        let mut own: Vec<f64> = knots.into_iter().map(|s| self.stretch.own_s(s)).collect();
        own.extend(self.weaving.as_ref().map_or(Vec::new(), of));
        own.sort_by(f64::total_cmp);
        own.dedup_by(|a, b| is_same_position(*a, *b));
        own
    }
}
