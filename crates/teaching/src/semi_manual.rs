//! Teaching by the operator (SADDLE-2020): the nominal seam is moved to points to which the operator has jogged.

use crate::seam_line::SeamLine;
use crate::smoothing::LinePoint;
use glam::DVec3;
use seamwright_geometry::MonotoneCurve;
use seamwright_message::{Message, Unit};

/// Points nearer to each other along the seam than this coincide, mm.
const SAME_MM: f64 = 0.01;

/// Moves the nominal seam to the operator's `points` (work frame, mm, in any order). The deviation is interpolated
/// smoothly between points, and constant beyond the first and last of an open seam. Returns a point every `every` mm.
///
/// # Errors
/// No points, a point that is not near the seam, two at the same position.
pub fn semi_manual(nominal: &SeamLine, points: &[DVec3], every: f64) -> Result<Vec<LinePoint>, Message> {
    if points.is_empty() {
        return Err(Message::new("cell-no-points"));
    }
    let mut off = Vec::with_capacity(points.len());
    for (i, point) in points.iter().enumerate() {
        let foot = Some(*point).filter(|p| p.is_finite()).and_then(|p| nominal.foot(p)).ok_or_else(|| {
            Message::new("cell-point-off-seam").number("point", (i + 1) as f64, 0).value("max", 15.0, Unit::Mm)
        })?;
        let away = *point - foot.at.point;
        let (across, along) = (foot.at.normal.cross(foot.along), foot.along);
        // The component along the seam is only where the operator stopped.
        off.push((foot.way, away.dot(across), away.dot(foot.at.normal), away.dot(along), i));
    }
    off.sort_by(|a, b| a.0.total_cmp(&b.0));
    let last = off.last().map_or(0.0, |o| o.0) - nominal.length();
    let round = nominal.is_closed() && off.len() > 1 && off[0].0 - last < SAME_MM;
    if let Some(w) = off.windows(2).find(|w| w[1].0 - w[0].0 < SAME_MM) {
        let number = |i: usize| (i + 1) as f64;
        let message = Message::new("cell-points-coincide").number("first", number(w[0].4), 0);
        return Err(message.number("second", number(w[1].4), 0));
    }
    if round {
        off.pop();
    }
    let curve = |value: fn(&(f64, f64, f64, f64, usize)) -> f64| {
        let rows: Vec<(f64, f64)> = off.iter().map(|o| (o.0, value(o))).collect();
        MonotoneCurve::new(&rows, nominal.is_closed().then(|| nominal.length())).map_err(|e| e.message())
    };
    let (across, above) = (curve(|o| o.1)?, curve(|o| o.2)?);
    let count = (nominal.length() / every).ceil().clamp(1.0, 1e7);
    let at = |k: u32| {
        let way = nominal.length() * f64::from(k) / count;
        let (station, along) = nominal.at(way);
        let side = station.normal.cross(along);
        let point = station.point + across.at(way) * side + above.at(way) * station.normal;
        LinePoint { way, point, normal: station.normal, confidence: 1.0 }
    };
    Ok((0..=count as u32).map(at).collect())
}
