use crate::allowed::{at_most, between, rounded};
use crate::pass_keys::PassKeys;
use crate::seam::SeamCurve;
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};
use seamwright_program::{Pass, PathRange, is_beyond};

/// Maximum number of turns of a pass on one bead; more are a mistake. Each step-over to another bead permits one more.
const MAX_TURNS: f64 = 2.0;

/// The part of a seam that a pass runs over, one way or the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Path length on the seam at the start of the pass, mm from the start of the weld.
    pub begin: f64,
    /// 1 along the weld's direction, -1 against it.
    pub sense: f64,
    /// Length of the pass along the seam, mm.
    pub length: f64,
}

impl Stretch {
    /// The stretch of `pass` on `seam`; `keys` are those of its values in `file`.
    ///
    /// # Errors
    /// With the key's address: a pass that starts beside the weld or goes on beyond its ends, or goes round a closed
    /// seam more than twice on one bead. Also step-overs on a seam that is not welded all round.
    pub fn new<T>(file: &Document<T>, keys: &PassKeys, pass: &Pass, seam: &SeamCurve) -> Result<Self, DocumentError> {
        let (begin, length, weld) = (pass.begin_mm.get(), pass.length(), seam.weld_length());
        let sense = if pass.reverse { -1.0 } else { 1.0 };
        if is_beyond(begin, weld) {
            let message = Message::new("weld-pass-begins-beyond-end");
            return Err(file.error_at(&keys.of("begin_mm"), message, between(0.0, rounded(weld), Unit::Mm)));
        }
        if !pass.step_overs.is_empty() && !seam.all_round() {
            let message = Message::new("weld-step-over-needs-closed-seam");
            return Err(file.error_at(&keys.of("step_overs"), message, Message::new("weld-allowed-no-step-over")));
        }
        let turns = MAX_TURNS + pass.step_overs.len() as f64;
        let (room, code) = match (seam.all_round(), pass.reverse) {
            (true, _) => (turns * seam.length(), "weld-pass-round-more-than-twice"),
            (false, false) => (weld - begin, "weld-pass-beyond-end"),
            (false, true) => (begin, "weld-pass-beyond-start"),
        };
        if is_beyond(length, room) {
            let last = pass.spans.len().saturating_sub(1);
            let allowed = at_most(rounded(room), Unit::Mm);
            return Err(file.error_at(&keys.of(&format!("spans[{last}].to_mm")), Message::new(code), allowed));
        }
        Ok(Self { begin, sense, length: length.min(room) })
    }

    /// All of the weld, in its direction.
    pub fn whole(seam: &SeamCurve) -> Self {
        Self { begin: 0.0, sense: 1.0, length: seam.weld_length() }
    }

    /// Path length on the seam at the pass' own path length `s`, mm; on a closed seam it counts on beyond its ends.
    pub fn seam_s(&self, s: f64) -> f64 {
        self.begin + self.sense * s
    }

    /// The pass' own path length at path length `seam_s` on the seam, mm.
    pub fn own_s(&self, seam_s: f64) -> f64 {
        self.sense * (seam_s - self.begin)
    }

    /// Range on the seam: from the smaller path length to the larger.
    pub fn range(&self) -> PathRange {
        self.range_of(PathRange::up_to(self.length))
    }

    /// Range on the seam of a range of the pass' own path length.
    pub(crate) fn range_of(&self, own: PathRange) -> PathRange {
        let (a, b) = (self.seam_s(own.from_mm), self.seam_s(own.to_mm));
        PathRange { from_mm: a.min(b), to_mm: a.max(b) }
    }

    /// The part of it in a range of the pass' own path length.
    pub(crate) fn part(&self, own: PathRange) -> Self {
        Self { begin: self.seam_s(own.from_mm), length: own.to_mm - own.from_mm, ..*self }
    }
}
