mod blended;

use crate::follower::Follower;
use crate::stretch::Stretch;
use seamwright_geometry::{NODES, Series, nodes};
use seamwright_machine::{Axis, AxisKind, Course, Joints, MAX_AXES};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// Axes evaluated together, so that the compiler can use vector instructions.
const LANES: usize = 4;

/// Coefficients of [`LANES`] axes, by degree.
type Block = [[f64; LANES]; NODES];

/// Maximum deviation (mm) of the panels' series from the exact inverse kinematics of a linear axis.
const TOLERANCE_MM: f64 = 1e-10;
/// The same for a rotary axis, rad.
const TOLERANCE_RAD: f64 = 1e-12;
/// Panels narrower than this have no coefficients below a part of the tolerance, mm.
const NARROW_MM: f64 = 0.02;
/// In panels narrower than this second derivatives are lost in rounding, mm.
const HAIR_MM: f64 = 1e-4;
/// Panels are not halved below this part of the path: there the inverse is not smooth.
const SMALLEST_PANEL: f64 = 1e-6;
/// Travel of the tip by path length nearer to 1 than this counts as 1.
const SAME_RATE: f64 = 1e-9;

/// Positions and derivatives by path length at one station; mm or rad per mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointPoint {
    /// Positions, mm or rad.
    pub q: Joints,
    /// First derivative by path length.
    pub d1: Joints,
    /// Second derivative by path length.
    pub d2: Joints,
    /// Third derivative by path length.
    pub d3: Joints,
}

/// The axes' positions by path length, `q(s)`, with derivatives.
///
/// Panels of Chebyshev series fitted to the closed-form inverse kinematics at their nodes and halved until they agree
/// with it between the nodes. Guarantee (checked at 33 stations a panel): within 1e-10 mm and 1e-12 rad of the exact
/// inverse, except in blends at corners. Evaluation does not allocate, and its cost depends on the number of axes only.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct JointPath {
    panels: Vec<Panel>,
    /// `blocks` per panel, one after the other.
    blocks: Vec<Block>,
    blocks_a_panel: usize,
    length: f64,
    axes: usize,
    /// Inner path lengths at which the first or second derivative may jump, mm.
    pub(crate) bends: Vec<f64>,
    /// Path lengths at which the path requests a stop, mm.
    pub(crate) stops: Vec<f64>,
    /// True if path lengths count planned time, not the tip's travel.
    pub(crate) timed: bool,
    blends: Vec<(f64, f64)>,
    /// True if the tip's travel by path length is not 1, as beside a seam.
    pub(crate) beside: bool,
    /// Distance of the machine's tip behind the arc, mm, to which speeds belong.
    pub(crate) drawn_back: f64,
    /// With a weave, the travel of its centre line by path length, panel by panel: the requested speed applies to it.
    line: Option<Vec<Series>>,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Panel {
    start: f64,
    end: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NotSmooth {
    pub(crate) s: f64,
}

impl JointPath {
    /// Fits the axes' path of `follower`, starting at the positions `start` (one branch of the inverse at s = 0).
    pub(crate) fn new(follower: Follower, start: &Joints) -> Result<Self, NotSmooth> {
        Self::over(follower, start, Stretch { from: 0.0, to: follower.path.length() })
    }

    /// Fits a part of the path alone, starting at the positions `start`; valid only in its range.
    pub(crate) fn over(follower: Follower, start: &Joints, part: Stretch) -> Result<Self, NotSmooth> {
        let Stretch { from, to } = part;
        let axes = follower.machine.axes.len();
        let length = follower.path.length();
        let mut built = Self::empty(axes, length);
        built.bends = follower.bends();
        built.stops = follower.path.points().map_or(Vec::new(), seamwright_program::ThroughPoints::stops);
        built.timed = follower.path.points().is_some();
        built.drawn_back = follower.path.drawn_back();
        built.line = follower.path.weave().map(|_| Vec::new());
        let mut near = *start;
        let mut todo: Vec<(f64, f64)> = Vec::new();
        let mut edges = vec![from];
        edges.extend(follower.knots().into_iter().filter(|s| *s > from && *s < to));
        edges.push(to);
        todo.extend(edges.windows(2).rev().map(|w| (w[0], w[1])));
        while let Some((a, b)) = todo.pop() {
            if let Some((blocks, end)) = fit(follower, a, b, &near, built.blocks_a_panel) {
                let rates = nodes().map(|x| follower.path.rate(a + 0.5 * (b - a) * (1.0 + x)));
                if let Some(line) = &mut built.line {
                    line.push(Series::fit(&rates));
                }
                built.beside |= rates.iter().any(|rate| (rate - 1.0).abs() > SAME_RATE);
                built.panels.push(Panel { start: a, end: b });
                built.blocks.extend(blocks);
                near = end;
            } else if b - a < SMALLEST_PANEL * length {
                return Err(NotSmooth { s: a });
            } else {
                let middle = 0.5 * (a + b);
                todo.push((middle, b));
                todo.push((a, middle));
            }
        }
        Ok(built)
    }

    fn empty(axes: usize, length: f64) -> Self {
        Self { blocks_a_panel: axes.div_ceil(LANES), length, axes, ..Self::default() }
    }

    /// Returns true if evaluation is possible everywhere, for a machine with this number of axes: panels adjoin one
    /// another over the whole length, each with all its coefficients, and all numbers are finite.
    pub(crate) fn is_whole(&self, axes: usize) -> bool {
        let ends = self.panels.iter().map(|p| p.end);
        let starts = self.panels.iter().skip(1).map(|p| p.start).chain(std::iter::once(self.length));
        let marks = || self.bends.iter().chain(&self.stops).chain(self.blends.iter().flat_map(|(a, b)| [a, b]));
        let line = self.line.iter().flatten().flat_map(|series| &series.c);
        self.axes == axes
            && axes <= MAX_AXES
            && self.blocks_a_panel == axes.div_ceil(LANES)
            && self.blocks.len() == self.panels.len() * self.blocks_a_panel
            && self.line.as_ref().is_none_or(|line| line.len() == self.panels.len())
            && self.panels.first().is_some_and(|first| first.start.total_cmp(&0.0).is_eq())
            && self.panels.iter().all(|p| p.start < p.end)
            && ends.zip(starts).all(|(end, start)| end.total_cmp(&start).is_eq())
            && self
                .blocks
                .iter()
                .flatten()
                .flatten()
                .chain(marks())
                .chain(line)
                .chain([&self.drawn_back])
                .all(|value| value.is_finite())
    }

    /// Length of the path, mm.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Path lengths at which panels meet, with both ends of the path.
    pub(crate) fn edges(&self) -> Vec<f64> {
        self.panels.iter().map(|p| p.start).chain(std::iter::once(self.length)).collect()
    }

    /// The panel at `s`: the later one where two meet, unless `before`.
    pub(crate) fn panel(&self, s: f64, before: bool) -> usize {
        let after = |p: &Panel| if before { p.start < s } else { p.start <= s };
        self.panels.partition_point(after).saturating_sub(1)
    }

    /// Positions at path length `s` in [0, length], mm or rad.
    pub fn at(&self, s: f64) -> Joints {
        let i = self.panel(s, false);
        let x = self.panels[i].local(s);
        let twice = 2.0 * x;
        let mut q = Joints::default();
        for (b, block) in self.blocks[i * self.blocks_a_panel..][..self.blocks_a_panel].iter().enumerate() {
            // Clenshaw's recurrence, on all lanes at once.
            let (mut b1, mut b2) = ([0.0; LANES], [0.0; LANES]);
            for c in block[1..].iter().rev() {
                for l in 0..LANES {
                    let new = twice * b1[l] + (c[l] - b2[l]);
                    b2[l] = b1[l];
                    b1[l] = new;
                }
            }
            for l in 0..LANES {
                q[b * LANES + l] = x * b1[l] + (block[0][l] - b2[l]);
            }
        }
        q
    }

    fn series(&self, i: usize, axis: usize) -> Series {
        let block = &self.blocks[i * self.blocks_a_panel + axis / LANES];
        Series { c: std::array::from_fn(|k| block[k][axis % LANES]) }
    }

    /// Adds `turns` whole turns to the positions of rotary axis `i`.
    pub(crate) fn turn(&mut self, i: usize, turns: f64) {
        let blocks = self.blocks.iter_mut().skip(i / LANES).step_by(self.blocks_a_panel);
        blocks.for_each(|block| block[0][i % LANES] += TAU * turns);
    }

    /// Minimum and maximum position of axis `i` over [`PLACES`] samples.
    pub(crate) fn extremes(&self, i: usize) -> RangeInclusive<f64> {
        let places = (0..=PLACES).map(|k| self.length * k as f64 / PLACES as f64);
        let positions = places.map(|s| self.at(s)[i]);
        let (low, high) = positions.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), q| (l.min(q), h.max(q)));
        low..=high
    }

    /// Bounds of each axis' rate dq/ds in `from..=to`: low and high.
    fn rates(&self, from: f64, to: f64) -> (Joints, Joints) {
        let mut bounds: Option<(Joints, Joints)> = None;
        for i in self.panel(from, false)..=self.panel(to, true) {
            let panel = self.panels[i];
            let (a, b) = (from.max(panel.start), to.min(panel.end));
            let (x, half) = (panel.local(0.5 * (a + b)), (b - a) / (panel.end - panel.start));
            let scale = 2.0 / (panel.end - panel.start);
            let (low, high) = bounds.get_or_insert(([f64::INFINITY; MAX_AXES], [f64::NEG_INFINITY; MAX_AXES]));
            for axis in 0..self.axes {
                let d1 = self.series(i, axis).derivative();
                // A Chebyshev polynomial is at most 1: the coefficients' sum bounds the series.
                let d2: f64 = d1.derivative().c.iter().map(|c| c.abs()).sum();
                let (middle, beside) = (scale * d1.at(x), scale * half.max(0.0) * d2);
                low[axis] = low[axis].min(middle - beside);
                high[axis] = high[axis].max(middle + beside);
            }
        }
        let (mut low, mut high) = bounds.unwrap_or_default();
        low[self.axes..].fill(0.0);
        high[self.axes..].fill(0.0);
        (low, high)
    }

    /// Positions and derivatives at `s`, from the panel after it (or before it, where two panels meet).
    pub fn point(&self, s: f64, before: bool) -> JointPoint {
        let i = self.panel(s, before);
        let panel = self.panels[i];
        self.point_in(i, s.clamp(panel.start, panel.end))
    }

    /// The same from the nearest panel wide enough for second derivatives, as positions given by hand may lie a hair beside
    /// those of a bead. `None` without one on that side.
    pub(crate) fn point_in_wide(&self, s: f64, before: bool) -> Option<JointPoint> {
        let is_wide = |p: &Panel| p.end - p.start > HAIR_MM;
        let i = self.panel(s, before);
        let wide = match before {
            true => self.panels[..=i].iter().rposition(is_wide),
            false => self.panels[i..].iter().position(is_wide).map(|k| i + k),
        };
        wide.map(|i| self.point_in(i, s.clamp(self.panels[i].start, self.panels[i].end)))
    }

    /// The same from panel `i`, continued where `s` is beyond its ends by rounding.
    pub(crate) fn point_in(&self, i: usize, s: f64) -> JointPoint {
        let panel = self.panels[i];
        let scale = 2.0 / (panel.end - panel.start);
        let table = chebyshev(scale * (s - panel.start) - 1.0);
        let mut p = [Joints::default(); 4];
        for (b, block) in self.blocks[i * self.blocks_a_panel..][..self.blocks_a_panel].iter().enumerate() {
            let mut sums = [[0.0; LANES]; 4];
            for (c, t) in block.iter().zip(&table) {
                for (sum, t) in sums.iter_mut().zip(t) {
                    (0..LANES).for_each(|l| sum[l] += c[l] * t);
                }
            }
            let mut factor = 1.0;
            for (p, sum) in p.iter_mut().zip(sums) {
                (0..LANES).for_each(|l| p[b * LANES + l] = factor * sum[l]);
                factor *= scale;
            }
        }
        let [q, d1, d2, d3] = p;
        JointPoint { q, d1, d2, d3 }
    }
}

/// All Chebyshev polynomials at `x` with three derivatives, by differentiating their recurrence.
fn chebyshev(x: f64) -> [[f64; 4]; NODES] {
    let mut t = [[0.0; 4]; NODES];
    t[0][0] = 1.0;
    t[1] = [x, 1.0, 0.0, 0.0];
    for k in 2..NODES {
        t[k][0] = 2.0 * x * t[k - 1][0] - t[k - 2][0];
        for d in 1..4 {
            t[k][d] = 2.0 * (d as f64 * t[k - 1][d - 1] + x * t[k - 1][d]) - t[k - 2][d];
        }
    }
    t
}

/// Bounds the rates by the first derivative in the middle of each panel touched and a bound of the second derivative.
impl Course for JointPath {
    fn range(&self) -> (f64, f64) {
        (0.0, self.length)
    }

    fn at(&self, s: f64) -> Joints {
        Self::at(self, s)
    }

    fn greatest_rates(&self, from: f64, to: f64) -> Joints {
        let (low, high) = self.rates(from, to);
        std::array::from_fn(|axis| high[axis].max(-low[axis]))
    }

    fn greatest_rate_changes(&self, from: f64, to: f64) -> Joints {
        let (low, high) = self.rates(from, to);
        std::array::from_fn(|axis| high[axis] - low[axis])
    }
}

impl Panel {
    fn local(&self, s: f64) -> f64 {
        (2.0 * (s - self.start) / (self.end - self.start) - 1.0).clamp(-1.0, 1.0)
    }
}

/// Fits one panel. Returns its coefficients and the positions at its end, or none if it is too long.
fn fit(follower: Follower, a: f64, b: f64, near: &Joints, count: usize) -> Option<(Vec<Block>, Joints)> {
    let at = |x: f64| a + 0.5 * (b - a) * (1.0 + x);
    let mut last = *near;
    let mut exact = |s: f64| -> Option<Joints> {
        last = follower.next(s, &last).ok()?.joints;
        Some(last)
    };
    // Nodes descend; walk them upwards so that each inverse starts from its neighbour.
    let mut values = [[0.0; NODES]; MAX_AXES];
    for j in (0..NODES).rev() {
        let q = exact(at(nodes()[j]))?;
        for (axis, row) in values.iter_mut().enumerate() {
            row[j] = q[axis];
        }
    }
    let end = exact(b)?;
    let machine = follower.machine;
    let series = machine.axes.iter().zip(&values).map(|(axis, values)| match b - a < NARROW_MM {
        // Divided by so small a width, rounding would show in the derivatives.
        true => Series::fit(values).without_tail(0.25 * tolerance(axis)),
        false => Series::fit(values),
    });
    let series: Vec<Series> = series.collect();
    let mut last = *near;
    for i in 0..=2 * NODES {
        let x = i as f64 / NODES as f64 - 1.0;
        let q = follower.next(at(x), &last).ok()?.joints;
        for (axis, (s, q)) in machine.axes.iter().zip(series.iter().zip(&q)) {
            let rounding = 32.0 * f64::EPSILON * q.abs();
            let off = (s.at(x) - q).abs();
            if off.is_nan() || off > tolerance(axis).max(rounding) {
                return None;
            }
        }
        last = q;
    }
    Some((blocks(series.into_iter(), count), end))
}

fn tolerance(axis: &Axis) -> f64 {
    match axis.kind {
        AxisKind::Linear => TOLERANCE_MM,
        AxisKind::Rotary => TOLERANCE_RAD,
    }
}

/// The coefficients of the axes' series, in `count` blocks.
fn blocks(series: impl Iterator<Item = Series>, count: usize) -> Vec<Block> {
    let mut blocks = vec![[[0.0; LANES]; NODES]; count];
    for (axis, series) in series.enumerate() {
        let rows = blocks[axis / LANES].iter_mut().zip(series.c);
        rows.for_each(|(row, c)| row[axis % LANES] = c);
    }
    blocks
}

/// Number of samples along the path.
pub(crate) const PLACES: usize = 1440;
