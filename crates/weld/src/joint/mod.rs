//! The joint along the seam: its cross-section at any station, from both faces, the local dihedral angle and the fit-up
//! of the parts.
//!
//! **Cross-section.** It consists of two edges, cut off at their part's surface. Each edge is a profile (root face,
//! bevel, arc) seen along a depth direction: in a butt joint along the bisector of the faces, in a T-joint under the
//! standing part along the other part's face. Names are those of ISO 17659 and ISO 2553.
//!
//! **Area.** Slices square to the line from toe to toe have a width that is linear between the corners of the edges. So
//! the area is exactly quadratic there, and the height of a given area has a closed form.

mod measured;
mod outline;
mod profile;
mod section;
mod standard;
#[cfg(test)]
mod tests;

pub use measured::Groove;
pub use section::Section;

use crate::allowed::{between, rounded};
use crate::seam::{SeamCurve, SeamPoint};
use measured::{MeasuredGroove, MeasuredRow};
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};
use seamwright_program::{Joint, JointStandard, is_beyond};
pub(crate) use section::NoGroove;
pub(crate) use section::Place;

/// The joint of a seam.
#[derive(Debug, Clone, PartialEq)]
pub struct SeamJoint {
    joint: Joint,
    /// The seam's length if it is welded all round: then measured values come round too.
    period: Option<f64>,
    /// The groove before the weld, then after each measured layer.
    states: Vec<MeasuredGroove>,
}

impl SeamJoint {
    /// The joint at `joint` of a job or program file along its seam.
    ///
    /// # Errors
    /// With the key's address: sizes that contradict each other, positions outside the weld, a groove that is
    /// impossible all along the seam: with position and reason. Also remaining areas that the groove does not have.
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
        let period = seam.all_round().then(|| seam.length());
        let mut built = Self { joint: joint.clone(), period, states: MeasuredGroove::all(joint, seam) };
        let places = 720;
        for i in 0..=places {
            let p = seam.at(end * f64::from(i) / f64::from(places));
            for state in 0..built.states.len() {
                built.try_section(state, &p).map_err(|why| built.refused(file, &why, &p))?;
            }
        }
        built.set_open_parts(file, seam)?;
        Ok(built)
    }

    /// Sets the open part of the groove at each measured position from its area.
    fn set_open_parts<T>(&mut self, file: &Document<T>, seam: &SeamCurve) -> Result<(), DocumentError> {
        for state in 1..self.states.len() {
            for k in 0..self.states[state].rows.len() {
                let row = self.states[state].rows[k];
                let Some(remaining) = row.remaining else { continue };
                let p = seam.at(row.s);
                let section = self.try_section(state, &p).map_err(|why| self.refused(file, &why, &p))?;
                let (min, max) = (-section.cap, section.area());
                if remaining <= min || remaining > max {
                    let path = format!("joint.fit_up[{}].remaining_mm2", row.index);
                    let allowed = Message::new("document-more-than-up-to");
                    let allowed = allowed.quantity("min", min, Unit::Mm2, 1).quantity("max", max, Unit::Mm2, 1);
                    return Err(file.error_at(&path, Message::new("weld-remaining-area-impossible"), allowed));
                }
                self.states[state].rows[k].open = remaining / section.area();
            }
        }
        Ok(())
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

    /// Root gap and mismatch at path length `s`, mm, as last measured.
    pub fn fit_up(&self, s: f64) -> (f64, f64) {
        let last = self.states.len() - 1;
        let drawn = || MeasuredRow::drawn(self.joint.preparation.root_gap_mm());
        let at = self.measured(last, s).unwrap_or_else(drawn);
        (at.gap, at.mismatch)
    }

    /// Number of states in which the groove was measured; the first is that before the weld.
    pub(crate) fn states(&self) -> usize {
        self.states.len()
    }

    /// The number of layers that were complete in a state, and the index of its first entry in the file.
    pub(crate) fn after_layer(&self, state: usize) -> (usize, usize) {
        let state = &self.states[state];
        (state.after_layer, state.rows.first().map_or(0, |row| row.index))
    }

    /// The part of the groove's area that was open in a state at path length `s`; below 0 if more than filled.
    pub(crate) fn open_part(&self, state: usize, s: f64) -> f64 {
        self.measured(state, s).map_or(1.0, |row| row.open)
    }

    fn measured(&self, state: usize, s: f64) -> Option<MeasuredRow> {
        self.states[state].at(s, self.period)
    }

    /// The section at a station of the seam as measured in a state, or the reason for its absence.
    pub(crate) fn try_section(&self, state: usize, p: &SeamPoint) -> Result<Section, NoGroove> {
        self.section_of(&self.groove_in(state, p))
    }

    /// The section at a station of the seam as last measured; `None` without a groove.
    pub fn section(&self, p: &SeamPoint) -> Option<Section> {
        self.try_section(self.states.len() - 1, p).ok()
    }

    /// The groove of the drawing, or as fitted up before the weld, at a station of the seam.
    pub fn groove(&self, p: &SeamPoint) -> Groove {
        self.groove_in(0, p)
    }

    /// The groove as last measured, or of the drawing, at a station of the seam.
    fn last_measured(&self, p: &SeamPoint) -> Groove {
        self.groove_in(self.states.len() - 1, p)
    }

    fn groove_in(&self, state: usize, p: &SeamPoint) -> Groove {
        let (drawn, gap) = self.joint.groove(p.dihedral);
        let at = self.measured(state, p.s).unwrap_or(MeasuredRow::drawn(gap));
        let angle = drawn.map(|angle| angle + at.turn);
        Groove { dihedral: p.dihedral, gap: at.gap, mismatch: at.mismatch, angle }
    }

    /// The section that this preparation has with other sizes; `None` without a groove.
    pub fn section_with(&self, groove: &Groove) -> Option<Section> {
        self.section_of(groove).ok()
    }

    fn section_of(&self, groove: &Groove) -> Result<Section, NoGroove> {
        let Groove { dihedral, gap, mismatch, angle } = *groove;
        let place = Place { dihedral, gap, mismatch };
        let drawn = &self.joint.preparation;
        let differs = |angle: &f64| drawn.groove_angle(self.joint.side, dihedral) != Some(*angle);
        let Some(angle) = angle.filter(differs) else { return Section::new(&self.joint, place) };
        let turned = drawn.with_groove_angle(self.joint.side, angle).ok_or(NoGroove::Inside(angle.to_degrees()))?;
        Section::new(&Joint { preparation: turned, fit_up: Vec::new(), ..self.joint.clone() }, place)
    }
}
