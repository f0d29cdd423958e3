//! Helpers for several tests.

use super::{Row, State};

/// Rows a pixel apart along legs of a length and a heading (rad), each confident, unconfident or not seen.
pub(super) fn along(legs: &[(usize, f32, Option<bool>)], width: f32) -> Vec<Row> {
    let (mut x, mut y) = (0.0, 0.0);
    let mut row = |heading: f32, sure: Option<bool>| {
        (x, y) = (x + heading.cos(), y + heading.sin());
        let state = if sure.is_some() { State::Seen } else { State::Coasted };
        Row { x, y, confidence: if sure == Some(true) { 0.9 } else { 0.2 }, width, state }
    };
    legs.iter().flat_map(|leg| vec![*leg; leg.0]).map(|(_, heading, sure)| row(heading, sure)).collect()
}
