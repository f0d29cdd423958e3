use super::midline::Found;
use super::{End, Row};

/// Nats by which the path is likelier than any other in a row that is sure.
const MARGIN: f32 = 12.0;
/// Nats by which a joint is likelier than none.
const STRENGTH: f32 = 12.0;
/// Standard error in a row that is sure, pixels.
const ERROR: f32 = 0.45;

/// How sure a row is by itself, `scale` pixels of the frame to one of its level.
pub(super) fn row(found: &Found, scale: f32, whole: bool) -> f32 {
    if !found.seen || !whole {
        return 0.0;
    }
    let margin = (found.margin / MARGIN / 2.0).clamp(0.0, 1.0);
    let strength = (found.strength / STRENGTH / 2.0).clamp(0.0, 1.0);
    let exact = (1.5 - found.error * scale / ERROR).clamp(0.0, 1.0);
    margin.min(strength).min(exact)
}

/// A line shorter than this may be a scratch, pixels.
const SHORT: usize = 130;

pub(super) fn whole(rows: &mut [Row], end: End) {
    if end != End::Closed && end != End::LeftImage && rows.len() < SHORT {
        rows.iter_mut().for_each(|r| r.confidence = r.confidence.min(0.4));
    }
}
