use crate::run::{Found, Midline};
use crate::work_shape::{Aim, FrameEnd, Row};
use glam::DVec2;
use seamwright_vision::Frame;
use seamwright_vision::joint::{CONFIDENT, End, Follower, Joint, Options, Start, State};

/// Maximum distance of a joint from the point that a hand touches, pixels.
const BESIDE_PX: f64 = 18.0;
/// Spacing of the search for it, pixels.
const APART_PX: f64 = 3.0;
/// Number of confident rows that confirms it.
const FOUND: usize = 40;

/// Finds the midline with the guided follower of `vision::joint`. If there is no joint at a point given by hand, the
/// nearest one beside it counts.
#[derive(Debug, Clone)]
pub struct JointFollower {
    follower: Follower,
    /// Follower beside the given point, where a short line may be a scratch.
    beside: Follower,
}

impl JointFollower {
    /// Creates a follower over tacks of up to `longest_gap_px` pixels.
    #[must_use]
    pub fn new(longest_gap_px: f64) -> Self {
        let options = Options { gap: Some(longest_gap_px as f32), on_joint: true, ..Options::default() };
        let beside = Follower::new(Options { on_joint: false, ..options.clone() });
        Self { follower: Follower::new(options), beside }
    }
}

impl Midline for JointFollower {
    fn find(&mut self, frame: &Frame, aim: &Aim) -> Found {
        let joint = self.follower.follow(frame, &start(aim, 0.0));
        let there = found(joint);
        if !aim.by_hand || is_sure(joint, 1) {
            return there;
        }
        let places = (1..).map(|k| APART_PX * f64::from(k)).take_while(|off| *off <= BESIDE_PX);
        for off in places.flat_map(|off| [off, -off]) {
            let joint = self.beside.follow(frame, &start(aim, off));
            if is_sure(joint, FOUND) {
                return found(joint);
            }
        }
        there
    }
}

/// Returns the start `across` pixels to the right of the aim.
fn start(aim: &Aim, across: f64) -> Start {
    let at = aim.start + across * aim.direction.perp();
    Start { x: at.x as f32, y: at.y as f32, direction: aim.direction.to_angle() as f32, width: None }
}

fn is_sure(joint: &Joint, rows: usize) -> bool {
    joint.rows.iter().filter(|row| row.confidence >= CONFIDENT).count() >= rows
}

fn found(joint: &Joint) -> Found {
    let row = |r: &seamwright_vision::joint::Row| Row {
        px: DVec2::new(f64::from(r.x), f64::from(r.y)),
        confidence: f64::from(r.confidence),
        seen: r.state == State::Seen,
    };
    let end = match joint.end {
        End::LeftImage => FrameEnd::LeftImage,
        End::JointEnd => FrameEnd::JointEnd,
        End::Closed => FrameEnd::Closed,
        End::Lost => FrameEnd::Lost,
    };
    Found { rows: joint.rows.iter().map(row).collect(), end }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_vision::Pixels;

    const SIDE: usize = 400;

    /// Metal with noise from a fixed sequence, and a dark line at column 200 over these rows.
    fn metal(line: std::ops::Range<usize>) -> Vec<u8> {
        let mut state = 5u32;
        let mut pixel = |i: usize| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let dark = line.contains(&(i / SIDE)) && (i % SIDE).abs_diff(200) < 3;
            (if dark { 90 } else { 140 }) + (state >> 28) as u8
        };
        (0..SIDE * SIDE).map(&mut pixel).collect()
    }

    fn rows(pixels: &[u8], off: f64, by_hand: bool) -> Vec<Row> {
        let frame = Frame::new(SIDE, SIDE, Pixels::U8(pixels)).unwrap();
        let aim = Aim { start: DVec2::new(200.0 + off, 60.0), direction: DVec2::Y, by_hand };
        let mut rows = JointFollower::new(60.0).find(&frame, &aim).rows;
        rows.retain(|row| row.confidence >= f64::from(CONFIDENT));
        rows
    }

    /// A finger on a picture, or the position of a program, is a millimetre off; the automatic follower is not.
    #[test]
    fn a_hand_touches_beside_the_joint() {
        let joint = metal(50..SIDE);
        for off in [-17.0, -9.5, 6.0, 0.3, 11.0, 17.0] {
            let found = rows(&joint, off, true);
            assert!(
                found.len() >= FOUND && found.iter().all(|row| (row.px.x - 200.0).abs() < 1.0),
                "{off}: {}",
                found.len()
            );
        }
        assert!(rows(&joint, 11.0, false).is_empty() && rows(&joint, 40.0, true).is_empty());
        assert!(rows(&metal(0..0), 0.0, true).is_empty());
        // A scratch beside it is not a joint.
        assert!(rows(&metal(55..115), 9.0, true).is_empty());
    }
}
