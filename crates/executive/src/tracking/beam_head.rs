use seamwright_tracking::beam::{BeamReplay, BeamTracking, Orders, Picture};
use seamwright_tracking::lead::Moment;

/// Source of the orders.
pub enum BeamHead<'a> {
    /// The beam's own view.
    Tracking(Box<BeamTracking<'a>>),
    /// The record of an earlier pass.
    Replay(Box<BeamReplay<'a>>),
}

impl BeamHead<'_> {
    /// Runs a cycle, as [`BeamTracking::cycle`].
    pub fn cycle(&mut self, now: Moment, speed: f64, welds: bool) -> Orders {
        match self {
            Self::Tracking(head) => head.cycle(now, speed, welds),
            Self::Replay(head) => head.cycle(now, speed),
        }
    }

    /// Takes in a picture that has arrived at `t_s`.
    pub fn take(&mut self, picture: &Picture<'_>, t_s: f64) {
        match self {
            Self::Tracking(head) => drop(head.take(picture, t_s)),
            Self::Replay(head) => head.take(picture, t_s),
        }
    }

    /// Returns the start of the search for the joint in a frame taken at `s_mm`: distance ahead (mm), and the
    /// expected distance aside of the taught seam, if known.
    #[must_use]
    pub fn looks_for(&self, s_mm: f64, speed: f64) -> (f64, Option<f64>) {
        match self {
            Self::Tracking(head) => {
                let from = head.zone().from_mm.max(-speed);
                (from, head.expected(s_mm + from))
            }
            Self::Replay(head) => (0.0, Some(head.expected(s_mm))),
        }
    }
}

/// Time at rest before the weld, s: the beam looks at the joint from its start on.
pub const LOOK_S: f64 = 1.5;
/// Distance before the end of the seam in which an unseen joint ahead raises no alarm, mm.
pub const END_MM: f64 = 1.0;
/// Spacing of the record's rows, mm.
pub const STEP_MM: f64 = 0.1;
/// Maximum variation of the pictures' latency, s.
pub const LATENCY_VARIATION_S: f64 = 0.01;
