use super::{BACK, FITTED, Limits, Look, Place, ROWS, TAKEN, Trail};
use crate::joint::axis::Axis;
use crate::joint::levels::Picture;

/// Chords this many places long ...
pub(in crate::joint) const CHORD: usize = 14;
/// ... do not turn by more than this, rad.
const CORNER: f32 = 0.6;
/// Places leapt over at a time behind a corner.
const LEAP: usize = 12;

impl Trail {
    /// The place before a turn that is sharper than a joint's, among the last places and after those that were checked.
    pub(super) fn corner(&self, checked: usize) -> Option<usize> {
        let (places, most) = (&self.places, CORNER.tan());
        let from = places.len().saturating_sub(TAKEN + CHORD).max(CHORD).max(checked);
        (from..places.len().saturating_sub(CHORD)).find_map(|i| {
            let [a, b, c] = [places[i - CHORD].at, places[i].at, places[i + CHORD].at];
            let (before, after) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
            let (sin, cos) = (before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]);
            (sin.abs() > most * cos).then_some(i - CHORD)
        })
    }

    /// Goes on over what hides the joint, without looking at it: the axis where the joint is seen again, if it is.
    pub(super) fn leap<F: Fn([f32; 2]) -> bool>(
        &mut self,
        picture: &Picture,
        look: &mut Look,
        limits: &Limits<F>,
    ) -> Option<Axis> {
        let [.., before, last] = self.places[..] else { return None };
        let heading = (last.at[1] - before.at[1]).atan2(last.at[0] - before.at[0]);
        let axis = self.way_on(&Axis { at: last.at, heading, curvature: 0.0 }, 1.0, 2 * FITTED);
        let axis = Axis { curvature: 0.0, ..axis };
        let mut gone = 0;
        loop {
            for i in gone..gone + LEAP {
                let at = axis.station(i as f32).at;
                if !(limits.inside)(at) || i as f32 > limits.gap {
                    return None;
                }
                self.places.push(Place { at, seen: false, contrast: look.contrast });
            }
            gone += LEAP;
            let there = Axis { at: axis.station(gone as f32).at, ..axis };
            self.see(picture, &there, BACK as f32, &mut look.clone(), gone);
            let seen = self.count();
            if 10 * seen >= 9 * ROWS && self.is_steady() {
                return Some(there);
            }
        }
    }
}
