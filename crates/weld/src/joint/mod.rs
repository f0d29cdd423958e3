//! The joint along the seam: its cross-section at any station, from both faces, the local dihedral angle and the fit-up
//! of the parts.
//!
//! **Cross-section.** It consists of two edges, cut off at their part's surface. Each edge is a profile (root face,
//! bevel, arc) seen along a depth direction: in a butt joint along the bisector of the faces, in a T-joint under the
//! standing part along the other part's face. Names are those of ISO 17659 and ISO 2553.
//!
//! **Area.** Slices square to the line from toe to toe have a width that is linear between the corners of the edges. So
//! the area is exactly quadratic there, and the height of a given area has a closed form.

mod outline;
mod profile;
mod section;
mod standard;
#[cfg(test)]
mod tests;

pub use section::Section;

use crate::allowed::{between, rounded};
use crate::seam::{SeamCurve, SeamPoint};
use seamwright_document::{Document, DocumentError, NonNegative};
use seamwright_message::{Message, Unit};
use seamwright_program::{AtDihedral, Joint, JointStandard, is_beyond};
pub(crate) use section::NoGroove;
use section::Place;

/// The joint of a seam.
#[derive(Debug, Clone, PartialEq)]
pub struct SeamJoint {
    joint: Joint,
    /// The seam's length if it is welded all round: then gap and mismatch come round too.
    period: Option<f64>,
}

impl SeamJoint {
    /// The joint at `joint` of a job or program file along its seam.
    ///
    /// # Errors
    /// With the key's address: sizes that contradict each other, positions outside the weld, a groove that is
    /// impossible all along the seam: with position and reason.
    pub fn new<T>(file: &Document<T>, joint: &Joint, seam: &SeamCurve) -> Result<Self, DocumentError> {
        joint.check(file, "joint")?;
        let end = if seam.all_round() { seam.length() } else { seam.weld_length() };
        for (i, at) in joint.fit_up.iter().enumerate() {
            if is_beyond(at.s_mm.get(), end) {
                let path = format!("joint.fit_up[{i}].s_mm");
                let allowed = between(0.0, rounded(end), Unit::Mm);
                return Err(file.error_at(&path, Message::new("weld-position-beside-weld"), allowed));
            }
        }
        let is_aws = joint.standard == Some(JointStandard::AwsD11);
        if is_aws && !joint.preparation.is_t() {
            let message = Message::new("weld-standard-of-other-joints").text("standard", "AWS D1.1");
            return Err(file.error_at("joint.standard", message, Message::new("program-edge-on-face")));
        }
        let built = Self { joint: joint.clone(), period: seam.all_round().then(|| seam.length()) };
        let places = 720;
        for i in 0..=places {
            let p = seam.at(end * f64::from(i) / f64::from(places));
            built.try_section(&p).map_err(|why| built.refused(file, &why, &p))?;
        }
        Ok(built)
    }

    fn refused<T>(&self, file: &Document<T>, why: &NoGroove, p: &SeamPoint) -> DocumentError {
        let (key, allowed) = why.cure();
        let key = self.joint.preparation.given_key(key);
        let mut path = format!("joint.preparation.{}", self.joint.preparation.key());
        if !key.is_empty() {
            path = format!("{path}.{key}");
        }
        file.error_at(&path, why.at(p.s), allowed)
    }

    /// The joint as it is in the file.
    pub fn joint(&self) -> &Joint {
        &self.joint
    }

    /// Root gap and mismatch at path length `s`, mm.
    pub fn fit_up(&self, s: f64) -> (f64, f64) {
        let at = &self.joint.fit_up;
        let value = |i: usize| (at[i].root_gap_mm.get(), at[i].mismatch_mm.get());
        let (Some(first), Some(last)) = (at.first(), at.last()) else {
            return (self.joint.preparation.root_gap_mm(), 0.0);
        };
        let mut s = s;
        if let Some(period) = self.period {
            s = first.s_mm.get() + (s - first.s_mm.get()).rem_euclid(period);
        }
        let i = at.partition_point(|f| f.s_mm.get() <= s);
        let between = |a: (f64, f64), b: (f64, f64), from: f64, to: f64| {
            let part = (s - from) / (to - from);
            (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1))
        };
        match (i.checked_sub(1), self.period) {
            (None, _) => value(0),
            (Some(k), _) if i < at.len() => between(value(k), value(i), at[k].s_mm.get(), at[i].s_mm.get()),
            (Some(k), Some(period)) => between(value(k), value(0), last.s_mm.get(), first.s_mm.get() + period),
            (Some(k), None) => value(k),
        }
    }

    /// Groove angle (rad) and root gap (mm) that the joint gives by the dihedral angle (rad); constant beyond its rows.
    fn at_dihedral(&self, dihedral: f64) -> (Option<f64>, Option<f64>) {
        let (rows, degrees) = (&self.joint.at_dihedral, dihedral.to_degrees());
        let i = rows.partition_point(|row| row.dihedral_deg.get() <= degrees);
        let (Some(low), Some(high)) = (rows.get(i.saturating_sub(1)), rows.get(i).or(rows.last())) else {
            return (None, None);
        };
        let [from, to] = [low, high].map(|row| row.dihedral_deg.get());
        let part = if to > from { ((degrees - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let between = |a: Option<f64>, b: Option<f64>| Some(a? + part * (b? - a?));
        let angle = |row: &AtDihedral| row.angle_deg.map(|angle| angle.get().to_radians());
        let gap = |row: &AtDihedral| row.root_gap_mm.map(NonNegative::get);
        (between(angle(low), angle(high)), between(gap(low), gap(high)))
    }

    /// The section at a station of the seam, or the reason for its absence.
    pub(crate) fn try_section(&self, p: &SeamPoint) -> Result<Section, NoGroove> {
        let (drawn, mismatch) = self.fit_up(p.s);
        let (angle, gap) = self.at_dihedral(p.dihedral);
        let gap = gap.filter(|_| self.joint.fit_up.is_empty()).unwrap_or(drawn);
        Section::new(&self.joint, Place { dihedral: p.dihedral, gap, mismatch, angle })
    }

    /// The section at a station of the seam; `None` without a groove.
    pub fn section(&self, p: &SeamPoint) -> Option<Section> {
        self.try_section(p).ok()
    }
}
