//! Drawing of the result over the frame as in Fig. 4 of EBW-2004: midline, cross, motion vector, detection zone.

use glam::DVec2;
use seamwright_frames::{COASTED, CROSS, Colour, MOTION, Overlay, sureness};
use seamwright_project::failure::Failure;
use seamwright_vision::Frame;
use seamwright_vision::joint::{CONFIDENT, Joint, Row, Start, State, Zone};

/// The frame with the joint found in it as PNG. The motion vector goes from the start to the last confident row: the
/// move that teaching would make.
pub(super) fn draw(frame: &Frame, joint: &Joint, start: &Start, zone: &Zone) -> Result<Vec<u8>, Failure> {
    let mut picture = Overlay::of(frame);
    // Large pictures are viewed from farther away.
    let thick = (frame.width() + frame.height()).div_ceil(1500) as i32;
    let across: Vec<f64> = (-thick..=thick).map(f64::from).collect();
    let low = DVec2::new(f64::from(zone.left), f64::from(zone.top));
    picture.zone(low, DVec2::new(f64::from(zone.right), f64::from(zone.bottom)));
    for pair in joint.rows.windows(2) {
        picture.line(place(&pair[0]), place(&pair[1]), &across, colour(&pair[1]));
    }
    let from = DVec2::new(f64::from(start.x), f64::from(start.y));
    let last = joint.rows.iter().rev().find(|r| r.confidence >= CONFIDENT);
    if let Some(last) = last {
        // Beside the midline, so that neither hides the other.
        let aside = (place(last) - from).perp().normalize_or_zero() * f64::from(6 + 4 * thick);
        picture.arrow(from + aside, place(last) + aside, MOTION);
    }
    picture.cross(from, CROSS, 10 + 4 * thick);
    picture.png().map_err(Failure::Environment)
}

fn place(row: &Row) -> DVec2 {
    DVec2::new(f64::from(row.x), f64::from(row.y))
}

fn colour(row: &Row) -> Colour {
    match row.state {
        State::Coasted => COASTED,
        State::Seen => sureness(f64::from(row.confidence), f64::from(CONFIDENT)),
    }
}
