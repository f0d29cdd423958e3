use super::timed_motion::{Rates, Timed, Tip};
use crate::joint_path::JointPath;
use crate::speed_profile::{ProfilePoint, SpeedProfile};
use crate::tip_channels::{self, TipChannels};
use seamwright_machine::{AxisLimits, Machine};

/// A pass in time: the axes' path with a speed profile.
///
/// Rates follow by the chain rule from the path's derivatives by path length and the profile's by time, without
/// differences. Borders are those of the profile's cells, which include all jumps of the path's third derivatives.
#[derive(Debug, Clone)]
pub struct PassTimed<'a> {
    machine: &'a Machine,
    path: &'a JointPath,
    profile: &'a SpeedProfile,
    /// Start (s) of each cell of the profile, and the panel of the path that contains the cell.
    cells: Vec<(f64, usize)>,
}

impl<'a> PassTimed<'a> {
    /// Combines `path`, of the axes of `machine`, with a profile `profile` along it.
    pub fn new(machine: &'a Machine, path: &'a JointPath, profile: &'a SpeedProfile) -> Self {
        let cell = |i| (profile.cell_times(i).0, path.panel(profile.in_cell(i, 0.5).s, false));
        Self { machine, path, profile, cells: (0..profile.cells()).map(cell).collect() }
    }

    /// The cell in which time `t` is: the later one where two meet, unless `before`.
    fn cell(&self, t: f64, before: bool) -> usize {
        let begun = |c: &(f64, usize)| if before { c.0 < t } else { c.0 <= t };
        self.cells.partition_point(begun).saturating_sub(1)
    }

    fn profile_in(&self, cell: usize, t: f64) -> ProfilePoint {
        let (from, to) = self.profile.cell_times(cell);
        let part = if to > from { ((t - from) / (to - from)).clamp(0.0, 1.0) } else { 1.0 };
        self.profile.in_cell(cell, part)
    }
}

impl Timed for PassTimed<'_> {
    fn duration(&self) -> f64 {
        self.profile.duration()
    }

    fn at(&self, t: f64, before: bool) -> Rates {
        let duration = self.duration();
        let cell = self.cell(t.clamp(0.0, duration), before);
        let rest = |s| ProfilePoint { s, ..ProfilePoint::default() };
        let profile = if t < 0.0 || (t <= 0.0 && before) {
            rest(0.0)
        } else if t > duration || (t >= duration && !before) {
            rest(self.path.length())
        } else {
            self.profile_in(cell, t)
        };
        let ProfilePoint { s, v, a, j } = profile;
        // Path lengths are rounded: the cell determines the side of a border.
        let p = self.path.point_in(self.cells[cell].1, s);
        let mut rates = Rates { q: p.q, tip: Tip { s, v, a, j }, ..Rates::default() };
        let mut channel = |i: usize, [d1, d2, d3]: [f64; 3]| {
            rates.v[i] = d1 * v;
            rates.a[i] = d2 * v * v + d1 * a;
            rates.j[i] = d3 * v * v * v + 3.0 * d2 * v * a + d1 * j;
        };
        let axes = self.machine.axes.len();
        (0..axes).for_each(|i| channel(i, [p.d1[i], p.d2[i], p.d3[i]]));
        if self.machine.tip != AxisLimits::NONE {
            let mut tip = [[0.0; 3]; tip_channels::COUNT];
            TipChannels::derivatives(
                self.machine.tip_derivatives(&[p.q, p.d1, p.d2, p.d3], self.path.drawn_back),
                &mut tip,
            );
            tip.into_iter().enumerate().for_each(|(i, d)| channel(axes + i, d));
        }
        rates
    }

    fn next_border(&self, t: f64, forward: bool) -> f64 {
        if forward {
            let next = self.cells.get(self.cells.partition_point(|c| c.0 <= t)).map(|c| c.0);
            next.unwrap_or(if t < self.duration() { self.duration() } else { f64::INFINITY })
        } else if t > self.duration() {
            self.duration()
        } else {
            let passed = self.cells.partition_point(|c| c.0 < t);
            passed.checked_sub(1).map_or(f64::NEG_INFINITY, |i| self.cells[i].0)
        }
    }

    fn time_of(&self, s: f64) -> f64 {
        self.profile.time(s)
    }
}
