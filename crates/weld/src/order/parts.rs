use super::file::{Parts, WeldOrder};
use crate::allowed::{less_than, rounded};
use crate::seam::{SAME_MM, SeamCurve};
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};
use seamwright_program::{
    Pass, PathRange, SAME_POSITION_MM, is_before, is_beyond, is_same_position, part_start, parts_of,
};

/// Quarters in the order of welding: each followed by the one opposite it.
const QUARTERS: [usize; 4] = [0, 2, 1, 3];
/// Parts keep this away from the corners between them, mm: it is not seen, and the torch stands as the part has it.
const CORNER_MM: f64 = 1e-4;
/// Minimum length of parts between corners, mm.
const MIN_PART_MM: f64 = 10.0 * CORNER_MM;
/// Maximum number of pieces of a weld; more are a mistake.
const MAX_PIECES: usize = 1000;
/// Cosine of the maximum turn of a seam that does not count as a corner: 0.1 degrees.
const STRAIGHT: f64 = 1.0 - 1.5e-6;

impl WeldOrder {
    /// Checks the parts against the seam. Fails with the key's address: quarters of a seam that is not welded all
    /// round, pieces longer than the weld, a tie-in as long as a part. Also two ends on a seam without ends.
    pub(crate) fn check_parts<T>(&self, file: &Document<T>, seam: &SeamCurve) -> Result<(), DocumentError> {
        let part = match self.parts {
            Parts::Whole => f64::INFINITY,
            Parts::AtCorners if corners(seam, PathRange::up_to(seam.weld_length())).is_empty() => {
                let message = Message::new("weld-seam-without-corners");
                let allowed = Message::verbatim("\"whole\", \"quadrants\", { back_step_mm = 150 }");
                return Err(file.error_at("order.parts", message, allowed));
            }
            Parts::AtCorners if seam.all_round() && is_beyond(seam.weld_length(), seam.length()) => {
                let message = Message::new("weld-overlap-at-corners");
                let key = file.given_or("start.overlap_mm", "start");
                return Err(file.error_at(key, message, Message::new("weld-allowed-no-overlap-at-corners")));
            }
            Parts::AtCorners => f64::INFINITY,
            Parts::Quadrants if !seam.all_round() => {
                let message = Message::new("weld-seam-without-quarters");
                let allowed = Message::verbatim("\"whole\", { back_step_mm = 150 }");
                return Err(file.error_at("order.parts", message, allowed));
            }
            Parts::Quadrants => 0.25 * seam.length(),
            Parts::BackStepMm(step) if !is_before(step.get(), seam.weld_length()) => {
                let message = Message::new("weld-pieces-longer-than-weld");
                let allowed = less_than(rounded(seam.weld_length()), Unit::Mm);
                return Err(file.error_at("order.parts.back_step_mm", message, allowed));
            }
            Parts::BackStepMm(step) if parts_of(seam.weld_length(), step.get()) > MAX_PIECES => {
                let min = seam.weld_length() / MAX_PIECES as f64;
                let allowed = Message::new("weld-allowed-piece-length").quantity("min", min, Unit::Mm, 3);
                let allowed = allowed.count("count", MAX_PIECES);
                return Err(file.error_at("order.parts.back_step_mm", Message::new("weld-too-many-pieces"), allowed));
            }
            Parts::BackStepMm(step) => seam.weld_length() / parts_of(seam.weld_length(), step.get()) as f64,
        };
        if !is_before(self.tie_in_mm.get(), part) {
            let message = Message::new("weld-tie-in-too-long");
            let key = file.given_or("order.tie_in_mm", "order");
            let allowed = Message::new("weld-allowed-tie-in").quantity("max", part, Unit::Mm, 3);
            return Err(file.error_at(key, message, allowed));
        }
        if self.either_end && seam.all_round() {
            let message = Message::new("weld-all-round-has-one-end");
            return Err(file.error_at("order.either_end", message, Message::verbatim("false")));
        }
        Ok(())
    }

    /// Number of parts that [`WeldOrder::parts_of`] makes of `pass`.
    pub(crate) fn count_parts(&self, pass: &Pass, seam: &SeamCurve) -> usize {
        let turn = seam.all_round().then(|| seam.length());
        match self.parts {
            Parts::Whole => 1,
            Parts::Quadrants if is_before(pass.length(), seam.length()) => 1,
            Parts::Quadrants => QUARTERS.len(),
            Parts::AtCorners => ends_at_corners(pass, seam, turn).len().saturating_sub(1),
            Parts::BackStepMm(step) => parts_of(pass.length(), step.get()),
        }
    }

    /// The parts of `pass` on `seam` in the order of welding.
    pub(crate) fn parts_of(&self, pass: &Pass, seam: &SeamCurve) -> Vec<Pass> {
        let turn = seam.all_round().then(|| seam.length());
        let (length, tie_in) = (pass.length(), self.tie_in_mm.get());
        match self.parts {
            Parts::Whole => vec![pass.clone()],
            // A layer over a part of the seam has no quarters.
            Parts::Quadrants if is_before(length, seam.length()) => vec![pass.clone()],
            Parts::Quadrants => {
                let quarter = 0.25 * seam.length();
                let piece = |q: usize| {
                    let range = PathRange { from_mm: quarter * q as f64, to_mm: quarter * (q + 1) as f64 + tie_in };
                    pass.piece(range, turn)
                };
                QUARTERS.into_iter().map(piece).collect()
            }
            Parts::AtCorners => {
                let ends = ends_at_corners(pass, seam, turn);
                let range = |end: &[f64]| PathRange { from_mm: end[0] + CORNER_MM, to_mm: end[1] - CORNER_MM };
                ends.windows(2).map(|end| pass.piece(range(end), turn)).collect()
            }
            Parts::BackStepMm(step) => {
                let count = parts_of(length, step.get());
                // Welded all round without an overlap, the last piece ties in with the first one.
                let over = turn.filter(|turn| is_same_position(length, *turn)).map_or(0.0, |_| tie_in);
                let piece = |i: usize| {
                    let (from, to) = (part_start(length, i, count), part_start(length, i + 1, count));
                    let to = if i + 1 == count { to + over } else { to };
                    let range = PathRange { from_mm: (from - tie_in).max(0.0), to_mm: to };
                    pass.piece(range, turn).turned(turn)
                };
                if count == 1 { vec![pass.clone()] } else { (0..count).map(piece).collect() }
            }
        }
    }
}

/// Ends of the parts of `pass` from corner to corner, by its own path length, mm; `turn` is the length of a seam that
/// is welded all round.
fn ends_at_corners(pass: &Pass, seam: &SeamCurve, turn: Option<f64>) -> Vec<f64> {
    let (from, to) = (pass.seam_s(0.0), pass.seam_s(pass.length()));
    let low = from.min(to);
    let all_round = turn.filter(|turn| !is_before(pass.length(), *turn));
    // All round one of every corner, also of one at the start.
    let range = match all_round {
        Some(turn) => PathRange { from_mm: low - SAME_POSITION_MM, to_mm: low + turn - SAME_POSITION_MM },
        None => PathRange { from_mm: low, to_mm: from.max(to) },
    };
    let mut ends: Vec<f64> = corners(seam, range).iter().map(|s| (s - from).abs()).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|later, earlier| *later - *earlier < MIN_PART_MM);
    match all_round.zip(ends.first().copied()) {
        // From a corner on, so that all parts start at corners.
        Some((turn, first)) => ends.push(first + turn),
        None => {
            ends.retain(|end| *end > MIN_PART_MM && *end < pass.length() - MIN_PART_MM);
            ends.insert(0, -CORNER_MM);
            ends.push(pass.length() + CORNER_MM);
        }
    }
    ends
}

/// Positions inside a range of the seam at which it or the direction between its faces turns, mm.
fn corners(seam: &SeamCurve, range: PathRange) -> Vec<f64> {
    let turns = |s: &f64| {
        let (before, after) = (seam.at(s - SAME_MM), seam.at(s + SAME_MM));
        before.tangent.dot(after.tangent) < STRAIGHT || before.bisector.dot(after.bisector) < STRAIGHT
    };
    seam.knots_within(range).into_iter().filter(turns).collect()
}
