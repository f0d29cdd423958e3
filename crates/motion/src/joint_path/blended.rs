use super::{JointPath, JointPoint, Panel, blocks};
use crate::taught::Piece;
use seamwright_geometry::{NODES, Series, nodes};
use seamwright_machine::{Joints, Machine};

/// Shorter parts of the path count as empty, as a fraction of its length.
const ROUNDING: f64 = 1e-12;

impl JointPath {
    /// This path with stretches replaced by `blends`, which are in order and apart; the rest is unchanged.
    pub(crate) fn blended(&self, blends: &[Piece]) -> Self {
        let mut built = Self::empty(self.axes, self.length);
        built.beside = self.beside;
        built.drawn_back = self.drawn_back;
        built.bends.clone_from(&self.bends);
        built.stops.clone_from(&self.stops);
        built.timed = self.timed;
        built.blends = blends.iter().map(|b| (b.from, b.to)).collect();
        let mut blends = blends.iter().peekable();
        for (i, panel) in self.panels.iter().enumerate() {
            // The blend before may reach into this panel, or beyond it.
            let mut from = built.panels.last().map_or(0.0, |last| last.end).max(panel.start);
            while let Some(blend) = blends.next_if(|b| b.from < panel.end) {
                built.part(self, i, Panel { start: from, end: blend.from });
                built.add(Panel { start: blend.from, end: blend.to }, |s| blend.derivatives(s)[0]);
                from = blend.to;
            }
            built.part(self, i, Panel { start: from, end: panel.end });
        }
        built
    }

    /// Appends a `part` of panel `i` of another path: the same polynomial.
    fn part(&mut self, of: &Self, i: usize, part: Panel) {
        let whole = of.panels[i];
        if part.start <= whole.start && part.end >= whole.end {
            self.panels.push(whole);
            self.blocks.extend_from_slice(&of.blocks[i * of.blocks_a_panel..][..of.blocks_a_panel]);
        } else if part.end - part.start > ROUNDING * self.length {
            self.add(part, |s| of.point_in(i, s).q);
        }
    }

    /// Appends a `panel` that is the polynomial `q`, of a degree below [`NODES`].
    fn add(&mut self, panel: Panel, q: impl Fn(f64) -> Joints) {
        let Panel { start, end } = panel;
        let places = nodes().map(|x| q(start + 0.5 * (end - start) * (1.0 + x)));
        let values: Vec<[f64; NODES]> = (0..self.axes).map(|axis| places.map(|q| q[axis])).collect();
        let series = values.iter().map(|values| Series::fit(values).without_rounding());
        self.panels.push(panel);
        self.blocks.extend(blocks(series, self.blocks_a_panel));
    }

    /// Stretches in which the axes go round a corner of the seam, in order, mm.
    pub fn blends(&self) -> &[(f64, f64)] {
        &self.blends
    }

    pub(crate) fn in_blend(&self, s: f64) -> bool {
        let i = self.blends.partition_point(|b| b.1 < s);
        self.blends.get(i).is_some_and(|b| b.0 <= s)
    }

    /// True if speeds at `s` count the tip's travel and this may differ from path length: beside the seam and in
    /// blends, where `s` is the station on the seam.
    pub(crate) fn has_rate(&self, s: f64) -> bool {
        !self.timed && (self.beside || self.in_blend(s))
    }

    /// Scale of speeds by path length at `s`: the travel of the tip of `machine`, whose path this is, or 1 on a path
    /// that counts time.
    pub fn speed_rate(&self, machine: &Machine, s: f64) -> f64 {
        if self.timed { 1.0 } else { self.tip_rate(machine, s) }
    }

    /// True if the torch weaves about its line.
    pub fn is_woven(&self) -> bool {
        self.line.is_some()
    }

    /// Travel of the weave's centre line by path length at `s` of panel `i`; none without a weave.
    pub(crate) fn line_rate(&self, i: usize, s: f64) -> Option<f64> {
        self.line.as_ref().map(|line| line[i].at(self.panels[i].local(s)))
    }

    /// Path length near `guess` at which the axes are nearest to `q`, each weighted by its maximum speed on `machine`.
    pub fn foot(&self, machine: &Machine, q: &Joints, guess: f64) -> f64 {
        (0..3).fold(guess, |s, _| {
            let p = self.point(s, false);
            let (mut along, mut square) = (0.0, 0.0);
            for (i, axis) in machine.axes.iter().enumerate() {
                along += (q[i] - p.q[i]) * p.d1[i] / axis.max_speed.powi(2);
                square += (p.d1[i] / axis.max_speed).powi(2);
            }
            if square > 0.0 { (s + along / square).clamp(0.0, self.length) } else { s }
        })
    }

    /// Travel of the arc on `machine`, whose path this is, by path length at `s`: 1 on the seam; beside it and in
    /// blends that of the axes; with a weave that of its centre line.
    pub fn tip_rate(&self, machine: &Machine, s: f64) -> f64 {
        if !self.timed && !self.has_rate(s) {
            return 1.0;
        }
        if let Some(rate) = self.line_rate(self.panel(s, false), s) {
            return rate;
        }
        let JointPoint { q, d1, d2, d3 } = self.point(s, false);
        machine.tip_derivatives(&[q, d1, d2, d3], self.drawn_back)[0].length()
    }
}
