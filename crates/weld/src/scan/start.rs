//! Coarse search for the pose of the sensor.

use super::fit::to_section;
use super::surface::{AT_Y, AT_Z, DEPTH, Fixed, TURN, Unknowns};
use crate::joint::Section;
use glam::DVec2;

/// Turns that are tried, rad.
const TURNS: [f64; 7] = [-0.24, -0.15, -0.07, 0.0, 0.07, 0.15, 0.24];
/// Positions are tried at this distance, mm.
const STEP_MM: f64 = 0.8;
/// Points that are compared.
const COMPARED: usize = 48;
/// A point farther off counts as this far, mm.
const FAR_MM: f64 = 2.0;
/// Parts of the groove's height to which metal is tried.
const FILLED: [f64; 7] = [0.06, 0.22, 0.38, 0.55, 0.7, 0.85, 1.0];
/// Poses that are fitted.
const KEPT: usize = 4;

/// The best poses, with the drawn sizes.
pub(super) fn starts(fixed: &Fixed, points: &[DVec2], turn: f64) -> Vec<Unknowns> {
    let few: Vec<DVec2> = points.iter().copied().step_by(points.len().div_ceil(COMPARED)).collect();
    let (low, high) = few.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.x), h.max(p.x)));
    let mut found: Vec<(f64, Unknowns)> = Vec::new();
    let filled: &[f64] = if fixed.welded { &FILLED } else { &[0.0] };
    let Some(section) = fixed.section(&fixed.start(0.0)) else { return Vec::new() };
    let (bottom, top) = section.slices.heights();
    let view = section.view();
    let square = -turn - view.x.atan2(view.y);
    for part in filled {
        let mut drawn = fixed.start((1.0 - part) * (top - bottom));
        for extra in TURNS {
            drawn[TURN] = square + extra;
            let Some(heights) = Heights::new(fixed, &drawn, high - low) else { continue };
            let mut at = low;
            while at <= high {
                let mut start = drawn;
                start[AT_Y] = at;
                let (z, cost) = heights.compare(&few, at);
                start[AT_Z] = z;
                found.push((cost, start));
                at += STEP_MM;
            }
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Of neighbours only the best one.
    let mut kept: Vec<Unknowns> = Vec::new();
    let near = |a: &Unknowns, b: &Unknowns| (a[AT_Y] - b[AT_Y]).abs() < 2.5 && (a[TURN] - b[TURN]).abs() < 0.1;
    for (_, start) in found {
        if kept.len() == KEPT {
            break;
        }
        if !kept.iter().any(|k| near(k, &start)) {
            kept.push(start);
        }
    }
    if fixed.welded {
        kept.iter_mut().for_each(|start| set_depth(&section, points, start));
    }
    kept
}

/// Sets the depth of the metal to the median of the points over the middle half of the groove.
fn set_depth(section: &Section, points: &[DVec2], start: &mut Unknowns) {
    let [first, second] = section.toes();
    let (across, top) = (section.across(), section.up.dot(first));
    let middle = 0.5 * across.dot(first + second);
    let there = points.iter().map(|p| to_section(start, *p));
    let there = there.filter(|q| (across.dot(*q) - middle).abs() < 0.25 * section.chord());
    let mut depths: Vec<f64> = there.map(|q| top - section.up.dot(q)).collect();
    if !depths.is_empty() {
        let half = depths.len() / 2;
        start[DEPTH] = *depths.select_nth_unstable_by(half, f64::total_cmp).1;
    }
}

/// Distance of the table's entries, mm.
const CELL_MM: f64 = 0.25;

/// Height of the surface over the sensor's y, with the seam at the origin.
struct Heights {
    first: f64,
    values: Vec<f64>,
}

impl Heights {
    fn new(fixed: &Fixed, u: &Unknowns, reach: f64) -> Option<Self> {
        let surface = fixed.surface(u)?;
        let turn = DVec2::from_angle(-u[TURN]);
        let count = (2.0 * reach / CELL_MM).ceil() as usize + 1;
        let (first, mut values) = (-reach, vec![f64::NEG_INFINITY; count]);
        for s in &surface.segments {
            let [a, b] = [turn.rotate(s.from), turn.rotate(s.to)];
            if b.x <= a.x {
                continue;
            }
            let cell = |x: f64| ((x - first) / CELL_MM).clamp(0.0, count as f64);
            for (k, value) in values.iter_mut().enumerate().take(cell(b.x) as usize + 1).skip(cell(a.x).ceil() as usize)
            {
                let x = first + CELL_MM * k as f64;
                let z = a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)).clamp(0.0, 1.0);
                *value = value.max(z);
            }
        }
        Some(Self { first, values })
    }

    /// The height of the seam that fits points best with the seam at `at`, and their mean distance.
    fn compare(&self, points: &[DVec2], at: f64) -> (f64, f64) {
        let height = |p: &DVec2| {
            let k = ((p.x - at - self.first) / CELL_MM).round();
            let z = self.values.get(k as usize).copied().filter(|_| k >= 0.0)?;
            z.is_finite().then_some(p.y - z)
        };
        let mut off: Vec<f64> = points.iter().filter_map(height).collect();
        if off.len() < points.len() / 4 {
            return (0.0, f64::INFINITY);
        }
        off.sort_by(f64::total_cmp);
        let z = off[off.len() / 2];
        let sum: f64 = off.iter().map(|o| (o - z).abs().min(FAR_MM)).sum();
        // Points over a gap are as far as half of the way.
        (z, sum + 0.5 * FAR_MM * (points.len() - off.len()) as f64)
    }
}
