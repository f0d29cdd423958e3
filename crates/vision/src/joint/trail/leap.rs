use super::detection::MinRows;
use super::{BACK, CHORD, FITTED, Limits, Look, Place, ROWS, TAKEN_CLEAR, Trail};
use crate::joint::axis::{Axis, Station};
use crate::joint::levels::Picture;
use crate::joint::strip::{GROUP, LIT, SEEN_AROUND};

/// ... and the maximum turn between two of them, rad.
const CORNER: f32 = 0.6;
/// Curvatures of the joint tried below the object that hides it, rad/px.
const BENDS: [f32; 5] = [0.0, 0.006, -0.006, 0.012, -0.012];
/// Minimum rows of a strip behind a corner that show the joint.
const SHOWN: usize = (9 * ROWS).div_ceil(10);
/// Rows of half a strip, and those of them measured as in the whole strip.
const HALF: usize = ROWS / 2;
const KNOWN: usize = HALF - GROUP - SEEN_AROUND;
const _: () = assert!(HALF.is_multiple_of(LIT), "the light of half a strip is levelled as in the whole one");
/// Points per leap behind a corner.
const LEAP: usize = 12;

impl Trail {
    /// Returns the point before a turn too sharp for a joint, among the last points and after the `checked` ones.
    pub(super) fn corner(&self, checked: usize) -> Option<usize> {
        let (places, most) = (&self.places, CORNER.tan());
        let from = places.len().saturating_sub(TAKEN_CLEAR + CHORD).max(CHORD).max(checked);
        (from..places.len().saturating_sub(CHORD)).find_map(|i| {
            let [a, b, c] = [places[i - CHORD].at, places[i].at, places[i + CHORD].at];
            let (before, after) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
            let (sin, cos) = (before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]);
            (sin.abs() > most * cos).then_some(i - CHORD)
        })
    }

    /// Leaps over an object that hides the joint; returns the axis where the joint is seen again, if it is.
    pub(super) fn leap(&mut self, picture: &Picture, look: &mut Look, limits: &Limits) -> Option<Axis> {
        let [.., before, last] = self.places[..] else { return None };
        let heading = (last.at[1] - before.at[1]).atan2(last.at[0] - before.at[0]);
        let axis = self.way_on(&Axis { at: last.at, heading, curvature: 0.0 }, 1.0, 2 * FITTED);
        // Behind a known obstacle the joint may bend unseen.
        let bends = if limits.hidden.is_some() { &BENDS[..] } else { &BENDS[..1] };
        let straight = Axis { curvature: 0.0, ..axis };
        let mut gone = 0;
        loop {
            gone += LEAP;
            if !(limits.inside)(straight.station(gone as f32).at) || gone as f32 > limits.gap {
                return None;
            }
            let mut best: Option<(f32, Axis)> = None;
            let axes = bends.iter().map(|bend| Axis { curvature: *bend, ..axis });
            for axis in axes.filter(|axis| (limits.inside)(axis.station(gone as f32).at)) {
                let beyond = beyond(&axis, gone);
                // Half a strip is enough to exclude most places without a joint.
                self.unroll(picture, &beyond, BACK as f32, HALF, look);
                if !self.may_show(look, MinRows { shown: KNOWN - (ROWS - SHOWN), among: KNOWN }) {
                    continue;
                }
                self.unroll(picture, &beyond, BACK as f32, ROWS, look);
                if !self.may_show(look, MinRows { shown: SHOWN, among: ROWS }) {
                    continue;
                }
                let score = self.see_unrolled(&mut look.clone(), gone);
                let is_joint = self.count() >= SHOWN && self.is_steady();
                if is_joint && best.is_none_or(|(most, _)| score > most) {
                    best = Some((score, axis));
                }
            }
            let Some((_, axis)) = best else { continue };
            let place = |i| Place { at: axis.station(i as f32).at, seen: false, contrast: look.contrast };
            self.places.extend((0..gone).map(place));
            return Some(beyond(&axis, gone));
        }
    }
}

/// Returns the straight axis from `gone` pixels along an axis on.
fn beyond(axis: &Axis, gone: usize) -> Axis {
    let Station { at, tangent } = axis.station(gone as f32);
    Axis { at, heading: tangent[1].atan2(tangent[0]), curvature: 0.0 }
}
