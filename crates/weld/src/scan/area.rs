//! The area that is open above the metal.

use super::Measured;
use super::fit::{Fit, to_section};
use super::surface::{Fixed, Piece, Unknowns};
use glam::DVec2;

/// Points whose height differs more from the median of their neighbours, in standard deviations, are spatter.
const OUTLIER: f64 = 4.0;
/// Neighbours on each side.
const BESIDE: usize = 4;
/// A bead is at most so much rougher than the stripe, mm.
const ROUGH_MM: f64 = 0.25;

/// The area between the line from toe to toe, the fitted edges and the points on the metal. Points on it are taken as
/// they are: a bead's surface is not a parabola.
pub(super) fn open(fixed: &Fixed, fit: &Fit, points: &[DVec2]) -> Option<Measured> {
    let surface = fixed.surface(&fit.unknowns)?;
    let [second, first] = surface.ends?;
    let across = surface.section.across();
    let between = |p: &&DVec2| {
        let x = across.dot(to_section(&fit.unknowns, **p));
        x > across.dot(second) && x < across.dot(first)
    };
    let inside: Vec<DVec2> = points.iter().filter(between).copied().collect();
    let on_metal = smooth(&inside, fit.scatter);
    let area = |u: &Unknowns| polygon(fixed, u, &on_metal);
    let value = area(&fit.unknowns)?;
    // Each point moves the area by its height times the distance of its neighbours.
    let widths = on_metal.windows(3).map(|w| 0.5 * (w[2].x - w[0].x));
    let noise = fit.scatter * widths.map(|w| w * w).sum::<f64>().sqrt();
    let uncertainty = fit.uncertainty(area)?.hypot(noise);
    Some(Measured { value, uncertainty })
}

/// The points without those far from the median of their neighbours.
fn smooth(points: &[DVec2], scatter: f64) -> Vec<DVec2> {
    let within = OUTLIER * scatter + ROUGH_MM;
    let near = |i: usize| {
        let from = i.saturating_sub(BESIDE);
        let mut heights: Vec<f64> = points[from..(i + BESIDE + 1).min(points.len())].iter().map(|p| p.y).collect();
        let middle = heights.len() / 2;
        let median = *heights.select_nth_unstable_by(middle, f64::total_cmp).1;
        (points[i].y - median).abs() <= within
    };
    (0..points.len()).filter(|i| near(*i)).map(|i| points[i]).collect()
}

/// Area from the line from toe to toe down to the edges and the points, with other unknowns.
fn polygon(fixed: &Fixed, u: &Unknowns, on_metal: &[DVec2]) -> Option<f64> {
    let surface = fixed.surface(u)?;
    let [second_end, first_end] = surface.ends?;
    let [first_toe, second_toe] = surface.section.toes();
    let edge = |piece: fn(&Piece) -> bool| {
        let there = surface.segments.iter().filter(move |s| piece(&s.piece));
        there.flat_map(|s| [s.from, s.to]).collect::<Vec<_>>()
    };
    let mut corners = vec![second_toe];
    corners.extend(edge(|p| matches!(p, Piece::SecondEdge(_))));
    corners.push(second_end);
    corners.extend(on_metal.iter().map(|p| to_section(u, *p)));
    corners.push(first_end);
    corners.extend(edge(|p| matches!(p, Piece::FirstEdge(_))));
    corners.push(first_toe);
    let twice: f64 = (0..corners.len()).map(|i| corners[i].perp_dot(corners[(i + 1) % corners.len()])).sum();
    Some(0.5 * twice)
}
