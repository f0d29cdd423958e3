use crate::joint_path::JointPath;
use crate::speed_profile::{Certificate, Leg, ProfilePoint, SpeedProfile};
use crate::stretch::Stretch;
use seamwright_machine::Machine;

/// A speed profile along the path of a machine's axes, with its certificate: the input of findings.
#[derive(Clone, Copy)]
pub(crate) struct Planned<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) joints: &'a JointPath,
    pub(crate) profile: &'a SpeedProfile,
    pub(crate) certificate: &'a Certificate,
    pub(crate) legs: &'a [Leg],
}

impl Planned<'_> {
    /// Speed to compare with the requested one at the point `p` of the profile, mm/s: that of the tip.
    pub(crate) fn tip_speed(&self, p: ProfilePoint) -> f64 {
        p.v * self.joints.speed_rate(self.machine, p.s)
    }

    pub(crate) fn tip_speed_at(&self, s: f64) -> f64 {
        self.profile.speed(s) * self.joints.speed_rate(self.machine, s)
    }

    /// Range of the tip speed on a stretch, from samples of the profile's cells there; none without cells.
    pub(crate) fn tip_band(&self, stretch: Stretch, asked: &dyn Fn(f64) -> f64) -> Option<Band> {
        let Stretch { from, to } = stretch;
        let at = |cell: usize, part: f64| self.profile.in_cell(cell, part).s;
        let first = first_where(self.profile.cells(), |cell| at(cell, 1.0) >= from);
        let cells = (first..self.profile.cells()).take_while(|cell| at(*cell, 0.0) <= to);
        let points = cells.flat_map(|cell| [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| self.profile.in_cell(cell, part)));
        let inside = points.filter(|p| p.s >= from && p.s <= to).map(|p| (self.tip_speed(p), p.s));
        inside.fold(None, |band: Option<Band>, (v, s)| {
            let here = Band { least: (v, s), greatest: v, reached: (v / asked(s), s) };
            let lesser = |a: (f64, f64), b: (f64, f64)| if b.0 < a.0 { b } else { a };
            Some(band.map_or(here, |band| Band {
                least: lesser(band.least, here.least),
                greatest: band.greatest.max(v),
                reached: lesser(band.reached, here.reached),
            }))
        })
    }
}

/// First of the numbers 0 to `count` - 1 that is `good`, as are all after it; `count` without one. Uses bisection.
fn first_where(count: usize, good: impl Fn(usize) -> bool) -> usize {
    let (mut low, mut high) = (0, count);
    while low < high {
        let middle = usize::midpoint(low, high);
        if good(middle) { high = middle } else { low = middle + 1 }
    }
    low
}

#[derive(Clone, Copy)]
pub(crate) struct Band {
    /// Minimum speed, mm/s, and its path length.
    pub(crate) least: (f64, f64),
    pub(crate) greatest: f64,
    /// Minimum ratio of reached to requested speed, and its path length.
    pub(crate) reached: (f64, f64),
}
