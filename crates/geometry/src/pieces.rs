//! Closed curves cut into pieces at their crossings of borders, computed once.

use crate::numeric::bisect;
use crate::tube_intersection::{SAMPLES, minimum};
use std::f64::consts::TAU;

/// The pieces of a closed curve over the angle 0 to 2 pi, each in one zone.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pieces(Vec<(f64, usize)>);

/// A curve within this distance of a border, mm, does not cross it.
pub(crate) const AT_BORDER_MM: f64 = 1e-9;
/// Shorter pieces, rad, within another zone are dropped: they pass the border by less than 1e-11 of their radius.
const SHORTEST: f64 = 1e-5;

impl Pieces {
    pub(crate) fn whole(zone: usize) -> Self {
        Self(vec![(0.0, zone)])
    }

    /// The pieces between crossings of the `borders`; `beyond` returns the distance beyond each border at an angle,
    /// `zone` the zone there.
    pub(crate) fn new(borders: usize, beyond: &dyn Fn(f64) -> Vec<f64>, zone: &dyn Fn(f64) -> usize) -> Self {
        let step = TAU / SAMPLES as f64;
        let samples: Vec<(f64, Vec<f64>)> =
            (0..=SAMPLES).map(|i| i as f64 * step).map(|phi| (phi, beyond(phi))).collect();
        let mut ends: Vec<f64> = Vec::new();
        for border in 0..borders {
            let beyond = |phi: f64| beyond(phi)[border];
            let mut places: Vec<(f64, f64)> = samples.iter().map(|(phi, b)| (*phi, b[border])).collect();
            places.extend(turns(&places, step, &beyond));
            places.sort_by(|a, b| a.0.total_cmp(&b.0));
            ends.extend(places.windows(2).filter_map(|w| crossing(w[0], w[1], &beyond)));
        }
        ends.sort_by(f64::total_cmp);
        let piece = |(i, &from): (usize, &f64)| {
            let to = ends.get(i + 1).copied().unwrap_or(ends[0] + TAU);
            (from, to - from, zone((0.5 * (from + to)).rem_euclid(TAU)))
        };
        let pieces: Vec<(f64, f64, usize)> = ends.iter().enumerate().map(piece).collect();
        let mut kept: Vec<(f64, usize)> = Vec::new();
        for (i, &(from, width, zone)) in pieces.iter().enumerate() {
            let around = [&pieces[(i + pieces.len() - 1) % pieces.len()], &pieces[(i + 1) % pieces.len()]];
            let tiny = width < SHORTEST && around[0].2 == around[1].2;
            if !tiny && kept.last().is_none_or(|last| last.1 != zone) {
                kept.push((from, zone));
            }
        }
        if kept.len() > 1 && kept[0].1 == kept[kept.len() - 1].1 {
            kept.remove(0);
        }
        if kept.is_empty() { Self::whole(zone(0.0)) } else { Self(kept) }
    }

    /// Angles of zone changes, rad in [0, 2 pi), increasing.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        if self.0.len() > 1 { self.0.iter().map(|piece| piece.0).collect() } else { Vec::new() }
    }

    pub(crate) fn zone(&self, phi: f64) -> usize {
        let phi = phi.rem_euclid(TAU);
        let after = self.0.partition_point(|piece| piece.0 <= phi);
        // Before the start of the first piece, the last one continues.
        let piece = if after == 0 { self.0.len() - 1 } else { after - 1 };
        self.0[piece].1
    }

    pub(crate) fn middles(&self) -> Vec<f64> {
        let end = |i: usize| self.0.get(i + 1).map_or(self.0[0].0 + TAU, |piece| piece.0);
        self.0.iter().enumerate().map(|(i, piece)| 0.5 * (piece.0 + end(i))).collect()
    }
}

/// Local extrema nearest to 0 between samples `step` apart, where a function may cross 0, with its values.
fn turns(places: &[(f64, f64)], step: f64, f: &dyn Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let count = places.len() - 1;
    let turn = |i: usize| {
        let [l, m, r] = [(i + count - 1) % count, i, i + 1].map(|k| places[k].1);
        let sign = m.signum();
        (sign * l > 0.0 && sign * r > 0.0 && sign * m <= sign * l && sign * m <= sign * r).then(|| {
            let at = minimum(&|phi| sign * f(phi), places[i].0 - step, places[i].0 + step).rem_euclid(TAU);
            (at, f(at))
        })
    };
    (0..count).filter_map(turn).collect()
}

/// Zero crossing of a function between two samples, to full precision.
fn crossing(from: (f64, f64), to: (f64, f64), f: &dyn Fn(f64) -> f64) -> Option<f64> {
    if (from.1 > AT_BORDER_MM) == (to.1 > AT_BORDER_MM) {
        return None;
    }
    let (below, above) = if to.1 > AT_BORDER_MM { (from, to.0) } else { (to, from.0) };
    // A curve that runs along the border has no single zero: use the threshold instead.
    let level = if below.1 <= 0.0 { 0.0 } else { AT_BORDER_MM };
    let (above, below) = bisect(above, below.0, 60, |phi| f(phi) > level);
    Some((0.5 * (below + above)).rem_euclid(TAU))
}
