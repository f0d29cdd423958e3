//! Where the places of a line end.

use super::fit::StripeLine;
use super::profile::{Profile, Sample, median};
use glam::DVec2;

/// Most columns in a row without a place on the line: dropped columns, not an end.
const DROPPED: i32 = 10;

/// A blob that covers so much more than usual has something else in it.
const MERGED: f64 = 1.3;

/// Columns that tell the usual strength beside an end.
const BESIDE: i32 = 14;

/// The end of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge {
    /// Its column, sub-pixel.
    pub(super) column: f64,
    /// The place on the line.
    pub(super) at: DVec2,
}

/// Goes from column `from` towards column `to` as far as places lie `within` of `line`. At the end the strength falls to half of what it was before.
pub(super) fn edge(
    profile: &Profile,
    line: &StripeLine,
    within: f64,
    (from, to): (i32, i32),
    scratch: &mut Vec<f64>,
) -> Option<Edge> {
    let step = if to >= from { 1 } else { -1 };
    let span = profile.all_between(from.min(to), from.max(to));
    let mut last: Option<&Sample> = None;
    let on = |s: &Sample| line.off(s.at).abs() <= within;
    let ordered = |i: usize| if step > 0 { &span[i] } else { &span[span.len() - 1 - i] };
    let mut covered: Option<i32> = None;
    for s in (0..span.len()).map(ordered) {
        if covered.is_some_and(|column| (s.column - column).abs() > DROPPED) {
            break;
        }
        if on(s) {
            last = Some(s);
        }
        // A reflection across the stripe shifts the centre of both, but there is light.
        let merged = s.covers > MERGED * profile.usual_cover;
        if line.off(s.at).abs() <= if merged { within.max(s.covers) } else { within } {
            covered = Some(s.column);
        }
    }
    let last = last?;
    let column =
        half_strength(profile, last, step, &on, scratch).unwrap_or(f64::from(last.column) + 0.5 * f64::from(step));
    let y = last.at.x + (column - f64::from(last.column)) * profile.pitch;
    let along = line.along.x.max(1e-6);
    Some(Edge { column, at: line.at + line.along * ((y - line.at.x) / along) })
}

/// The column where the strength of places on the line falls to half on the way out to `last`.
fn half_strength(
    profile: &Profile,
    last: &Sample,
    step: i32,
    on: &dyn Fn(&Sample) -> bool,
    scratch: &mut Vec<f64>,
) -> Option<f64> {
    let near = |from: i32, to: i32| {
        let (a, b) = (last.column + step * from, last.column + step * to);
        profile.all_between(a.min(b), a.max(b))
    };
    scratch.clear();
    scratch.extend(near(-BESIDE, -3).iter().filter(|s| on(s)).filter_map(|s| s.strength));
    let half = 0.5 * median(scratch)?;
    let around = near(-3, 0);
    let mut before: Option<&Sample> = None;
    for i in 0..around.len() {
        let s = if step > 0 { &around[i] } else { &around[around.len() - 1 - i] };
        if !on(s) {
            continue;
        }
        let strength = s.strength?;
        if strength >= half {
            before = Some(s);
        } else if let Some(b) = before {
            let above = b.strength?;
            if (s.column - b.column).abs() > 1 {
                break;
            }
            let part = (above - half) / (above - strength);
            return Some(f64::from(b.column) + part * f64::from(step));
        }
    }
    before.map(|b| f64::from(b.column) + 0.5 * f64::from(step))
}
