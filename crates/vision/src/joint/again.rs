//! A joint that is lost is tried once more in other ways; what is found so has no confidence.

use super::follow::{Follower, Inside, known_width};
use super::levels::Light;
use super::noise::NoiseBy;
use super::trail::Look;
use super::{End, Joint, Row, Start, State, judge};
use crate::Frame;

/// Another way counts if the joint is so many times as long by it.
const LONGER: f32 = 1.25;
/// What is narrower is looked for with widths up to this part of the one before, and is narrower than this part of them ...
pub(super) const NARROWER: f32 = 0.7;
/// ... and as long as this part of it: what is wider is its surroundings.
const AS_LONG: f32 = 0.9;

/// A joint is wide if it is followed on this level or a coarser one.
const COARSE: usize = 2;
/// An open gap is darker than the metal by this part of its light at least. Where a wide one ends ...
const BLACK: f32 = 0.4;
/// ... and the metal is so many times as light or as dark as at its start, it is looked for by the logarithm of light too.
const CHANGED: f32 = 1.6;

impl Follower {
    /// Tries again if the joint ended so that it may go on; `looks` are those at its start and its end.
    pub(super) fn try_again(&mut self, frame: &Frame, start: &Start, inside: &Inside, mut looks: [Look; 2]) {
        // Of a narrow joint nothing else is seen.
        let is_lost = |joint: &Joint, looks: &[Look; 2]| joint.end == End::Lost && looks[0].level >= COARSE;
        if is_lost(&self.joint, &looks) {
            // A wide joint that bends beside the edge of a shadow is no noise.
            self.trail.tell_noise_by(NoiseBy::Metal);
            looks = self.follow_again(Light::Given, frame, start, inside, LONGER).unwrap_or(looks);
        }
        if is_lost(&self.joint, &looks) && known_width(start).is_none() {
            // A dark strip may have been taken for the joint in it.
            self.narrower = NARROWER * looks[0].width_in_frame();
            looks = self.follow_again(Light::Given, frame, start, inside, AS_LONG).unwrap_or(looks);
            self.narrower = f32::INFINITY;
        }
        if matches!(self.joint.end, End::Lost | End::JointEnd) && is_in_other_light(&looks) {
            // In the shade what is dirt is as deep as a joint.
            let start = Start { width: Some(looks[0].width_in_frame()), ..*start };
            self.follow_again(Light::Logarithm, frame, &start, inside, LONGER);
        }
    }

    /// Follows once more; what was found before comes back unless the joint is so many times as long now.
    fn follow_again(
        &mut self,
        light: Light,
        frame: &Frame,
        start: &Start,
        inside: &Inside,
        longer: f32,
    ) -> Option<[Look; 2]> {
        std::mem::swap(&mut self.joint, &mut self.before);
        let least = longer * way(&self.before.rows);
        let looks = self.follow_in(light, frame, start, inside, least);
        if looks.is_none() || way(&self.joint.rows) < least {
            std::mem::swap(&mut self.joint, &mut self.before);
            return None;
        }
        judge::doubtful(&mut self.joint.rows, 0);
        if self.joint.end == End::LeftImage {
            // What is nowhere sure is not known to lead out of the frame.
            self.joint.end = End::Lost;
        }
        looks
    }
}

/// True if the joint is a wide open gap and the metal's light is another one at its last than at its first.
fn is_in_other_light([first, last]: &[Look; 2]) -> bool {
    let is_gap = first.level >= COARSE && first.contrast > BLACK * first.metal();
    is_gap && !(1.0 / CHANGED..=CHANGED).contains(&(last.metal() / first.metal()))
}

/// How far a joint is followed to where it is seen last, pixels.
fn way(rows: &[Row]) -> f32 {
    let seen = rows.iter().rposition(|row| row.state == State::Seen).map_or(0, |last| last + 1);
    rows[..seen].windows(2).map(|pair| (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y)).sum()
}
